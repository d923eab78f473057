//! `check`: what is in a scene, and all that is wrong with it.

use super::{CAMERA, Room, SCENE, has_fields};

/// A triangle, a face with two corners and one whose corners are one.
const ODD_MESH: &str = "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\nf 1 2\nf 1 1 1\n";

fn with_odd_mesh() -> Room {
    let room = Room::new();
    room.write("odd.obj", ODD_MESH);
    let light = "[ambient]\ncolor = [1, 1, 1]\n";
    room.write(
        "odd.toml",
        format!("{CAMERA}{light}[[mesh]]\nfile = \"odd.obj\"\n"),
    );
    room
}

#[test]
fn a_good_scene_is_counted() {
    let room = Room::new();
    let table = room.run("check ok.toml").with(0);
    assert!(table.out.contains("no faults"), "{table:#?}");
    assert!(
        table
            .out
            .contains("1 spheres, 1 planes, 0 disks, 0 triangles"),
        "{table:#?}"
    );
    assert_eq!(table.err, "");
    let counts = room.run("check ok.toml --json").with(0).json();
    has_fields(
        &counts,
        "scene width height lights materials effects device_bytes",
    );
    assert_eq!(counts["spheres"], 1);
    assert_eq!(counts["planes"], 1);
    assert_eq!(counts["warnings"], serde_json::json!([]));
    assert_eq!(counts["faults"], serde_json::json!([]));
}

#[test]
fn all_faults_are_told_in_one_run() {
    let room = Room::new();
    let bad = SCENE
        .replace("radius = 1", "radius = -1")
        .replace("normal = [0, 1, 0]", "normal = [0, 0, 0]")
        .replace("material = \"clay\"", "material = \"caly\"")
        .replace("width = 48", "width = 0");
    room.write("bad.toml", &bad);
    let place = |text: &str| {
        1 + bad
            .lines()
            .position(|l| l.starts_with(text))
            .expect("there")
    };
    let lines = ["width", "radius", "material", "normal"].map(place);

    let told = room.run("check bad.toml").with(3);
    assert!(told.err.contains("4 faults"), "{told:#?}");
    for line in lines {
        assert!(
            told.err.contains(&format!("bad.toml:{line}:")),
            "{line}: {told:#?}"
        );
    }

    let object = room.run("check bad.toml --json").with(3).json();
    let faults = object["faults"].as_array().expect("a list");
    let found: Vec<_> = faults.iter().map(|fault| fault["line"].as_u64()).collect();
    assert_eq!(found, lines.map(|line| Some(line as u64)));
    for fault in faults {
        has_fields(fault, "file line column message help");
        assert_eq!(fault["file"], "bad.toml");
        // Where the message for people puts it.
        let place = format!("bad.toml:{}:{}", fault["line"], fault["column"]);
        assert!(told.err.contains(&place), "{place}: {told:#?}");
        assert!(told.err.contains(fault["message"].as_str().expect("text")));
    }
    assert_eq!(faults[2]["help"], "did you mean `clay`?");
}

#[test]
fn a_scene_that_cannot_be_read_is_a_fault_without_a_line() {
    let room = Room::new();
    let object = room.run("check none.toml --json").with(3).json();
    assert_eq!(object["faults"][0]["file"], "none.toml");
    assert!(object["faults"][0]["line"].is_null());
}

#[test]
fn the_warnings_of_a_mesh_name_its_file() {
    let room = with_odd_mesh();
    let ended = room.run("check odd.toml").with(0);
    assert!(ended.out.contains("1 triangles"), "{ended:#?}");
    assert!(ended.err.contains("odd.obj"), "{ended:#?}");
    let counts = room.run("check odd.toml --json").with(0).json();
    let warnings = counts["warnings"].as_array().expect("a list");
    assert!(!warnings.is_empty());
    for warning in warnings {
        assert!(
            warning.as_str().expect("text").contains("odd.obj"),
            "{warning}"
        );
    }
}

#[test]
fn strict_takes_them_for_errors() {
    let room = with_odd_mesh();
    for line in [
        "check odd.toml --strict",
        "render odd.toml --strict -o a.png",
    ] {
        room.run(line)
            .with(3)
            .telling(&["odd.toml:7:8", "odd.obj:5"]);
    }
    room.run("check ok.toml --strict").with(0);
    room.run("render odd.toml -o a.png").with(0);
}

#[test]
fn shapes_that_f32_cannot_resolve_are_noted() {
    let room = Room::new();
    let far = "[[sphere]]\ncenter = [0, 0, -1e6]\nradius = 1\n";
    let disk = "[[disk]]\ncenter = [0, 0, -1e3]\nnormal = [0, 0, 1]\nradius = 1e-6\n";
    // 32 roundings of the distance are a half-millionth of it.
    let nearer = "[[sphere]]\ncenter = [0, 0, -5e5]\nradius = 1\n";
    let scene = format!("{SCENE}{far}{nearer}{disk}");
    room.write("far.toml", &scene);
    let line = |text: &str| {
        let before = scene.split(text).next().expect("there");
        1 + before.matches('\n').count()
    };
    let lines = [line(far), line(disk)];

    let told = room.run("check far.toml").with(0);
    for line in lines {
        assert!(told.out.contains(&format!("far.toml:{line}:")), "{told:#?}");
    }
    assert!(told.out.contains("--accuracy adaptive"), "{told:#?}");
    let object = room.run("check far.toml --json").with(0).json();
    let notes = object["notes"].as_array().expect("a list");
    let found: Vec<_> = notes.iter().map(|note| note["line"].as_u64()).collect();
    assert_eq!(found, lines.map(|line| Some(line as u64)));
    let message = notes[0]["message"].as_str().expect("text");
    assert!(message.contains("--accuracy adaptive"), "{message}");

    let none = room.run("check ok.toml --json").with(0).json();
    assert_eq!(none["notes"], serde_json::json!([]));
}
