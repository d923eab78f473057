//! Exit codes 0 to 4.

use super::{CAMERA, Room, SCENE};

/// A machine without a Vulkan driver. The second name is the one that loaders
/// before 1.3.207 know.
const NO_DRIVER: [(&str, &str); 2] = [
    ("VK_DRIVER_FILES", "/nonexistent"),
    ("VK_ICD_FILENAMES", "/nonexistent"),
];

#[test]
fn done_is_0() {
    let room = Room::new();
    for line in [
        "render ok.toml -o a.png",
        "render ok.toml -o a.EXR --backend cpu",
        "compare ok.toml",
        "compare a.png a.png",
        "check ok.toml",
        "doctor",
        "mesh box -o box.obj",
        "--help",
        "render --help",
        "--version",
    ] {
        room.run(line).with(0);
    }
}

#[test]
fn a_difference_is_1() {
    let room = Room::new();
    room.write(
        "moved.toml",
        SCENE.replace("radius = 1", "radius = 1.000001"),
    );
    room.run("render ok.toml -o color.png").with(0);
    room.run("render ok.toml -o normal.png --layer normal")
        .with(0);

    let files = room.run("compare color.png normal.png -o diff.png").with(1);
    assert!(files.out.contains("DIFFERENT"), "{files:#?}");
    assert!(room.names().contains(&"diff.png".to_string()));

    let scenes = room.run("compare ok.toml moved.toml --json").with(1).json();
    assert!(scenes["different_pixels"].as_u64() > Some(0), "{scenes:#}");
    assert_eq!(scenes["pass"], false);
    room.run("compare ok.toml ok.toml").with(0);
    // Allowed to differ, it passes.
    room.run("compare ok.toml moved.toml --max-pixels 1536")
        .with(0);
}

#[test]
fn wrong_usage_is_2() {
    let room = Room::new();
    room.run("render ok.toml -o a.png").with(0);
    room.write("big.toml", SCENE.replace("width = 48", "width = 30000"));
    let names = room.names();
    for (line, word) in [
        ("", "Usage"),
        ("paint ok.toml", "paint"),
        ("render ok.toml", "--output"),
        ("render -o b.png", "<SCENE>"),
        ("render ok.toml -o b.png --nope", "--nope"),
        ("render ok.toml -o b.png --size 12", "640x480"),
        ("render ok.toml -o b.png --size 12x", "640x480"),
        ("render ok.toml -o b.png --size -1x5", "640x480"),
        ("render ok.toml -o b.png --size 0x3", "1 to 32768"),
        ("render ok.toml -o b.png --size 3x0", "1 to 32768"),
        ("render ok.toml -o b.png --size 32769x1", "1 to 32768"),
        ("render ok.toml -o b.png --size 4294967296x1", "640x480"),
        ("render ok.toml -o b.jpg", ".png nor in .exr"),
        ("render ok.toml -o b", ".png nor in .exr"),
        ("render ok.toml -o b.png --layer fog", "color, depth"),
        ("render ok.toml -o b.png --layer depth,id", "one layer"),
        ("render ok.toml -o b.png --threads 0", "1 to 1024"),
        ("render ok.toml -o b.png --threads 100000", "1 to 1024"),
        ("render ok.toml -o b.png --accuracy good", "adaptive"),
        ("accuracy ok.toml -o b.txt", ".svg"),
        ("accuracy ok.toml -o b.png", "--layer"),
        ("accuracy ok.toml -o b.svg --layer ulp", ".png"),
        ("accuracy ok.toml -o b.png --layer ulp", "one tier"),
        ("accuracy ok.toml --layer ulp", "--output"),
        ("accuracy ok.toml --hazard heat", "distance"),
        (
            "render ok.toml -o b.png --adapter x --backend cpu",
            "--adapter",
        ),
        ("render ok.toml -o b.png --progress sometimes", "always"),
        ("compare ok.toml a.png", "two image files"),
        ("compare a.png ok.toml", "two image files"),
        ("compare a.png", "two image files"),
        ("compare ok.toml big.toml", "--size"),
        ("compare a.png a.png -o diff.exr", "a PNG"),
        ("compare a.png a.png --max-abs -1", "max_abs"),
        ("mesh teacup -o a.obj", "teapot, icosphere, knot, terrain"),
        ("mesh knot -o a.obj --detail 3", "4..=10000000"),
        ("mesh knot -o a.obj --detail 10000001", "4..=10000000"),
    ] {
        // As one word, or clap takes the minus for a flag.
        let line = line
            .replace("--size -", "--size=-")
            .replace("abs -", "abs=-");
        room.run(&line).with(2).telling(&[word]);
    }
    assert_eq!(room.names(), names, "wrong usage wrote something");
}

#[test]
fn a_bad_scene_is_3_and_is_told_where_and_how() {
    let room = Room::new();
    room.write("typo.toml", SCENE.replace("radius", "radus"));
    let line = 1 + SCENE
        .lines()
        .position(|l| l == "radius = 1")
        .expect("there");
    let place = format!("typo.toml:{line}:1");
    for command in [
        "check typo.toml",
        "render typo.toml -o a.png",
        "compare typo.toml",
    ] {
        room.run(command)
            .with(3)
            .telling(&[&place, "radus", "did you mean `radius`"]);
    }
    room.run("check missing.toml")
        .with(3)
        .telling(&["missing.toml"]);
    let mesh = format!("{CAMERA}[[mesh]]\nfile = \"missing.obj\"\n");
    room.write("mesh.toml", mesh);
    room.run("check mesh.toml")
        .with(3)
        .telling(&["mesh.toml:5:8", "missing.obj"]);
    room.write("latin.toml", b"# caf\xe9\n");
    room.run("check latin.toml")
        .with(3)
        .telling(&["latin.toml"]);
    room.write("broken.png", b"\x89PNG\r\n\x1a\nrubbish");
    room.run("compare broken.png broken.png")
        .with(3)
        .telling(&["broken.png"]);
    room.run("compare none.png none.png")
        .with(3)
        .telling(&["none.png"]);
}

#[test]
fn what_is_no_file_is_refused_and_does_not_hang() {
    let room = Room::new();
    room.shell("mkfifo fifo.toml fifo.png; mkdir folder.toml; ln -s /dev/zero zero.toml")
        .with(0);
    for name in ["fifo.toml", "folder.toml", "zero.toml", "/dev/zero", "."] {
        let started = std::time::Instant::now();
        room.run(&format!("check {name}"))
            .with(3)
            .telling(&[name, "regular file"]);
        assert!(started.elapsed().as_secs() < 10, "{name}");
    }
    room.run("compare fifo.png /dev/zero")
        .with(3)
        .telling(&["fifo.png"]);
}

#[test]
fn no_adapter_is_4_and_names_the_package() {
    let room = Room::new();
    let package = "mesa-vulkan-drivers";
    for line in ["render ok.toml -o a.png --backend gpu", "compare ok.toml"] {
        room.run_with(line, &NO_DRIVER).with(4).telling(&[package]);
    }
    room.run("render ok.toml -o a.png --adapter abacus")
        .with(4)
        .telling(&["abacus", package]);
    // What OpenGL there may be is shown, but does not count.
    let doctor = room.run_with("doctor", &NO_DRIVER).with(4);
    assert!(doctor.err.contains(package), "{doctor:#?}");
    room.run_with("doctor --json", &NO_DRIVER).with(4).json();
    assert_eq!(room.names(), ["ok.toml"]);
}

#[test]
fn auto_falls_back_to_the_cpu_and_says_so() {
    let room = Room::new();
    let fallen = room
        .run_with("render ok.toml -o fallen.exr --json", &NO_DRIVER)
        .with(0);
    assert!(fallen.err.contains("rendering on the CPU"), "{fallen:#?}");
    assert_eq!(fallen.json()["backend"], "cpu");
    let found = room.run("render ok.toml -o found.exr --json").with(0);
    assert_eq!(found.json()["backend"], "gpu");
    assert_eq!(room.read("fallen.exr"), room.read("found.exr"));
}
