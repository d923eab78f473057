//! `render`: what is in the files.

use rayproof::frame::{Picture, PictureValues, Samples, read_image};

use super::{CAMERA, Room};

const LAYERS: [&str; 5] = ["color", "depth", "normal", "position", "id"];

fn picture(room: &Room, name: &str) -> Picture {
    read_image(&room.path(name)).expect("a picture")
}

/// The names of an EXR's channels, colour as `RGB`, sorted.
fn channels(room: &Room, name: &str) -> Vec<String> {
    let PictureValues::Linear { color, channels } = picture(room, name).values else {
        panic!("{name} is no EXR");
    };
    let mut names: Vec<_> = channels.into_iter().map(|channel| channel.name).collect();
    names.extend(color.map(|_| "RGB".to_string()));
    names.sort();
    names
}

#[test]
fn every_layer_is_a_png_of_its_own() {
    let room = Room::new();
    for layer in LAYERS {
        room.run(&format!(
            "render ok.toml -o {layer}.png --layer {layer} --backend cpu"
        ))
        .with(0);
        let picture = picture(&room, &format!("{layer}.png"));
        assert_eq!((picture.width, picture.height), (48, 32), "{layer}");
        room.run(&format!(
            "render ok.toml -o gpu.png --layer {layer} --backend gpu"
        ))
        .with(0);
        assert_eq!(
            room.read("gpu.png"),
            room.read(&format!("{layer}.png")),
            "{layer}"
        );
    }
    for (index, left) in LAYERS.into_iter().enumerate() {
        for right in &LAYERS[index + 1..] {
            let [left, right] = [left, right].map(|layer| room.read(&format!("{layer}.png")));
            assert_ne!(left, right);
        }
    }
    room.run("render ok.toml -o default.png").with(0);
    assert_eq!(room.read("default.png"), room.read("color.png"));
}

#[test]
fn an_exr_holds_all_layers_or_those_asked_for() {
    let room = Room::new();
    let all = "RGB depth.Z id normal.X normal.Y normal.Z position.X position.Y position.Z";
    for (flags, names) in [
        ("", all),
        ("--layer color", "RGB"),
        ("--layer depth,id", "depth.Z id"),
        ("--layer id --layer depth", "depth.Z id"),
        ("--layer normal,position,color,depth,id", all),
    ] {
        room.run(&format!("render ok.toml -o a.exr {flags}"))
            .with(0);
        assert_eq!(channels(&room, "a.exr").join(" "), names, "{flags}");
    }
}

#[test]
fn backends_and_threads_write_the_same_file() {
    let room = Room::new();
    let first = "render ok.toml -o gpu.exr --backend gpu";
    room.run(first).with(0);
    for (flags, name) in [
        ("--backend cpu", "cpu.exr"),
        ("--backend cpu --threads 1", "one.exr"),
        ("--backend cpu --threads 2", "two.exr"),
        ("--backend cpu --threads 1024", "many.exr"),
    ] {
        room.run(&format!("render ok.toml -o {name} {flags}"))
            .with(0);
        let compared = room
            .run(&format!("compare gpu.exr {name} --json"))
            .with(0)
            .json();
        assert_eq!(compared["different_pixels"], 0, "{flags}");
        assert_eq!(room.read("gpu.exr"), room.read(name), "{flags}");
    }
}

#[test]
fn double_is_traced_on_both() {
    let room = Room::new();
    room.run("render ok.toml -o robust.exr --backend cpu")
        .with(0);
    for backend in ["gpu", "cpu"] {
        let line =
            format!("render ok.toml -o double.exr --accuracy double --json --backend {backend}");
        let stats = room.run(&line).with(0).json();
        assert_eq!(stats["accuracy"], "double");
        assert_eq!(stats["backend"], backend);
        room.shell("mv -n double.exr first.exr").with(0);
    }
    let compared = room.run("compare first.exr double.exr --json").with(0);
    assert_eq!(compared.json()["different_pixels"], 0);
    // Other bits, but hardly another picture: the roundings of f32 show.
    let compared = room
        .run("compare robust.exr double.exr --json --max-pixels 1536")
        .with(0)
        .json();
    assert!(
        compared["different_pixels"].as_u64() > Some(0),
        "{compared:#}"
    );
    assert!(compared["rmse"].as_f64() < Some(1e-3), "{compared:#}");
}

#[test]
fn a_scene_without_shapes_is_its_background() {
    let room = Room::new();
    let background = "[background]\ncolor = [0.25, 0.5, 0.75]\n";
    room.write("empty.toml", format!("{CAMERA}{background}"));
    for backend in ["cpu", "gpu"] {
        let line = format!("render empty.toml -o a.exr --size 20x10 --backend {backend}");
        let ended = room.run(&line).with(0);
        assert!(ended.err.contains("no shapes"), "{ended:#?}");
        let PictureValues::Linear {
            color: Some(color), ..
        } = picture(&room, "a.exr").values
        else {
            panic!("no colour");
        };
        assert_eq!(color, vec![[0.25, 0.5, 0.75]; 200], "{backend}");
    }
    let both = room
        .run("compare empty.toml --size 20x10 --json")
        .with(0)
        .json();
    assert_eq!(both["different_pixels"], 0);
}

#[test]
fn the_size_of_the_command_line_wins() {
    let room = Room::new();
    for (size, width, height) in [("1x1", 1, 1), ("7X5", 7, 5), ("3000x2", 3000, 2)] {
        for backend in ["cpu", "gpu"] {
            room.run(&format!(
                "render ok.toml -o a.png --size {size} --backend {backend}"
            ))
            .with(0);
            let picture = picture(&room, "a.png");
            assert_eq!(
                (picture.width, picture.height),
                (width, height),
                "{size} {backend}"
            );
        }
    }
}

/// Two spheres, each in a ball of its own.
fn grouped() -> String {
    let sphere =
        |x: i32| format!("[[group]]\n[[group.sphere]]\ncenter = [{x}, 1, 0]\nradius = 0.5\n");
    format!(
        "{CAMERA}[image]\nwidth = 60\nheight = 40\n{}{}",
        sphere(-1),
        sphere(1)
    )
}

#[test]
fn what_rays_test_is_a_heat_map() {
    let room = Room::new();
    room.write("groups.toml", grouped());
    for layer in ["tests", "bounds"] {
        for backend in ["cpu", "gpu"] {
            let line = format!(
                "render groups.toml --bounds scene --layer {layer} --backend {backend} \
                 -o {layer}-{backend}.png"
            );
            room.run(&line).with(0);
        }
        let [cpu, gpu] = ["cpu", "gpu"].map(|backend| room.read(&format!("{layer}-{backend}.png")));
        assert_eq!(cpu, gpu, "{layer}");
    }
    assert_ne!(room.read("tests-cpu.png"), room.read("bounds-cpu.png"));
    // Outlines are white, which no count is.
    let white = |name: &str| {
        let PictureValues::Encoded { codes, .. } = picture(&room, name).values else {
            panic!("{name} is no PNG");
        };
        codes.iter().filter(|code| **code == [u16::MAX; 3]).count()
    };
    assert!(white("bounds-cpu.png") > 15);
    assert_eq!(white("tests-cpu.png"), 0);
}

#[test]
fn counts_are_numbers_in_an_exr() {
    let room = Room::new();
    room.write("groups.toml", grouped());
    let line = "render groups.toml --bounds scene --layer id,tests,bounds -o a.exr --json";
    let stats = room.run(line).with(0).json();
    assert_eq!(channels(&room, "a.exr"), ["bounds", "id", "tests"]);
    let PictureValues::Linear { channels, .. } = picture(&room, "a.exr").values else {
        panic!("no EXR");
    };
    for (name, counter) in [("tests", "shape_tests"), ("bounds", "bound_tests")] {
        let channel = channels.iter().find(|channel| channel.name == name);
        let Samples::Integer(counts) = &channel.expect("a channel").samples else {
            panic!("{name} is no integer");
        };
        let sum: u64 = counts.iter().map(|count| u64::from(*count)).sum();
        assert!(sum > 0);
        assert_eq!(stats["counters"][counter], sum, "{name}");
    }
    room.run("render ok.toml -o a.png --layer fog")
        .with(2)
        .telling(&["position, id, tests, bounds"]);
}
