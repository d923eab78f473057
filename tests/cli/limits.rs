//! Exit code 5: sizes and memory. `ulimit -v` makes every machine a small one.

use super::{CAMERA, Room};

/// Address space in KiB in which the program starts, but little else fits.
const SMALL: u32 = 400_000;

fn in_small_memory(room: &Room, line: &str) -> super::Ended {
    room.shell(&format!("ulimit -v {SMALL}; exec \"$0\" {line}"))
}

#[test]
fn a_picture_too_large_is_refused_with_the_numbers() {
    let room = Room::new();
    let started = std::time::Instant::now();
    for output in ["a.png", "a.exr"] {
        let line = format!("render ok.toml --size 32768x32768 -o {output} --backend cpu");
        in_small_memory(&room, &line).with(5).telling(&[
            "32768 x 32768",
            "bytes of memory",
            "available",
        ]);
    }
    // Before the first ray, not after the last.
    assert!(started.elapsed().as_secs() < 10);
    assert_eq!(room.names(), ["ok.toml"]);
    // The control: what fits in the same memory is done.
    let small = "render ok.toml --size 640x480 -o a.exr --backend cpu --threads 2";
    in_small_memory(&room, small).with(0);
}

#[test]
fn a_picture_that_fits_but_whose_file_does_not_is_refused_before_the_render() {
    let room = Room::new();
    // 5.3 million pixels: 231 MB to render, 692 MB with the packing of all layers.
    let line = "render ok.toml --size 2300x2300 --backend cpu --threads 1";
    in_small_memory(&room, &format!("{line} -o a.exr"))
        .with(5)
        .telling(&["2300 x 2300"]);
    in_small_memory(&room, &format!("{line} -o a.png")).with(0);
}

#[test]
fn memory_that_no_estimate_foresaw_is_an_error_and_no_abort() {
    let room = Room::new();
    let mesh = "[[mesh]]\nbuiltin = \"terrain\"\ndetail = 10000000\n";
    room.write("large.toml", format!("{CAMERA}{mesh}"));
    for line in [
        "check large.toml",
        "render large.toml -o a.png --backend cpu",
        "mesh terrain --detail 10000000 -o a.obj",
    ] {
        in_small_memory(&room, line)
            .with(5)
            .telling(&["over a limit", "memory"]);
    }
    assert_eq!(room.names(), ["large.toml", "ok.toml"]);
}
