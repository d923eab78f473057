//! Exit code 6: output that cannot be written, and the old file whole.

use super::Room;

#[test]
fn unwritable_outputs_are_6_and_are_found_before_the_render() {
    let room = Room::new();
    room.shell("mkdir folder.png; ln -s nowhere.png dangling.png")
        .with(0);
    for (line, word) in [
        ("render ok.toml -o missing/a.png", "no folder"),
        ("render ok.toml -o ok.toml/a.png", "ok.toml/a.png"),
        ("render ok.toml -o folder.png", "folder.png"),
        ("render ok.toml -o dangling.png", "symbolic link"),
        (
            "render ok.toml -o a.png --stats missing/stats.json",
            "missing/stats.json",
        ),
        ("compare ok.toml -o missing/a.png", "no folder"),
        ("mesh box -o missing/a.obj", "no folder"),
        ("mesh box -o folder.png", "folder.png"),
    ] {
        room.run(line).with(6).telling(&["cannot write", word]);
    }
    assert_eq!(room.names(), ["dangling.png", "folder.png", "ok.toml"]);
}

#[test]
fn a_full_device_is_6() {
    let room = Room::new();
    room.shell("ln -s /dev/full full.png; ln -s /dev/full full.exr")
        .with(0);
    for line in [
        "render ok.toml -o full.png",
        "render ok.toml -o full.exr",
        "render ok.toml -o a.png --stats /dev/full",
        "mesh box -o /dev/full",
    ] {
        room.run(line).with(6).telling(&["No space left on device"]);
    }
    let printed = room.shell("\"$0\" check ok.toml > /dev/full").with(6);
    assert!(printed.err.contains("standard output"), "{printed:#?}");
}

/// A disk that is full in the middle of a file: the limit on a file's size acts
/// like one.
#[test]
fn a_disk_that_fills_up_leaves_the_old_file_whole() {
    let room = Room::new();
    room.write("a.exr", "old");
    let small = "trap '' XFSZ; ulimit -f 8; exec \"$0\" render ok.toml --backend cpu -o a.exr";
    room.shell(small)
        .with(6)
        .telling(&["a.exr", "File too large"]);
    assert_eq!(room.read("a.exr"), b"old");
    assert_eq!(room.names(), ["a.exr", "ok.toml"]);
    // The control: without the limit it is replaced.
    room.run("render ok.toml --backend cpu -o a.exr").with(0);
    assert!(room.read("a.exr").len() > 8 * 1024);
}
