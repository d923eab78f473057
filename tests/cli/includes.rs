//! Scenes that reach for what is not theirs.

use std::time::Instant;

use super::{CAMERA, Room};

/// A folder with a scene folder in it, and files beside that.
fn house() -> Room {
    let room = Room::new();
    let layout = "mkdir scene; mkfifo scene/fifo.obj; mkdir scene/folder.obj; \
                  ln -s /dev/zero scene/zero.obj; ln -s ../out.obj scene/link.obj; \
                  ln -s .. scene/up; ln -s in.obj scene/inner.obj";
    room.shell(layout).with(0);
    let triangle = "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n";
    room.write("out.obj", triangle);
    room.write("scene/in.obj", triangle);
    room
}

fn including(room: &Room, file: &str) {
    let mesh = format!("[[mesh]]\nfile = \"{file}\"\n");
    let light = "[ambient]\ncolor = [1, 1, 1]\n";
    room.write("scene/a.toml", format!("{CAMERA}{light}{mesh}"));
}

#[test]
fn only_regular_files_under_the_scene_s_folder_are_read() {
    let room = house();
    let absolute = room.path("out.obj").display().to_string();
    for file in [
        "../../../../../../../../etc/passwd",
        "/etc/passwd",
        "../out.obj",
        "up/out.obj",
        "link.obj",
        absolute.as_str(),
        "/dev/zero",
        "zero.obj",
        "fifo.obj",
        "folder.obj",
        "",
        "missing.obj",
        "in.obj/",
    ] {
        including(&room, file);
        let started = Instant::now();
        let ended = room
            .run("check scene/a.toml")
            .with(3)
            .telling(&["scene/a.toml:7:8"]);
        assert!(
            !ended.err.contains("root:"),
            "a stranger's file is shown: {ended:#?}"
        );
        assert!(started.elapsed().as_secs() < 10, "{file}");
    }
    for file in ["in.obj", "./in.obj", "inner.obj", "up/scene/in.obj"] {
        including(&room, file);
        room.run("check scene/a.toml").with(0);
    }
}

#[test]
fn outside_is_allowed_where_asked_for_but_a_device_is_not() {
    let room = house();
    for file in ["../out.obj", "link.obj"] {
        including(&room, file);
        room.run("check scene/a.toml --allow-outside").with(0);
    }
    for file in ["/dev/zero", "fifo.obj", "zero.obj"] {
        including(&room, file);
        room.run("check scene/a.toml --allow-outside").with(3);
    }
}

/// An OBJ that names material files is no way round.
#[test]
fn a_material_library_is_guarded_too() {
    let room = house();
    let triangle = "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n";
    including(&room, "in.obj");
    for library in [
        "/etc/passwd",
        "../out.obj",
        "/dev/zero",
        "fifo.obj",
        "none.mtl",
    ] {
        room.write("scene/in.obj", format!("mtllib {library}\n{triangle}"));
        let started = Instant::now();
        let ended = room.run("check scene/a.toml");
        assert!(matches!(ended.code, Some(0 | 3)), "{library}: {ended:#?}");
        assert!(!ended.err.is_empty(), "{library}: without a word");
        assert!(!ended.err.contains("root:"), "{ended:#?}");
        assert!(started.elapsed().as_secs() < 10, "{library}");
    }
}
