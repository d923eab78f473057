//! `kill -9` at any time leaves the old file or the new one, never a part.

use std::fs;
use std::process::{Command, Stdio};
use std::time::{Duration, Instant};

use super::{RAYPROOF, Room};

const OLD: &[u8] = b"the old file";

/// What a killed process may leave beside the picture.
fn is_temporary(name: &str) -> bool {
    name.starts_with(".rayproof-") && name.ends_with(".tmp")
}

/// `make test-thorough` kills more often.
fn kills() -> u32 {
    match std::env::var_os("RAYPROOF_THOROUGH") {
        Some(_) => 200,
        None => 25,
    }
}

#[test]
fn a_killed_render_leaves_the_old_file_or_the_new_one() {
    let room = Room::new();
    let line = "render ok.toml --size 300x200 -o a.exr --backend cpu";
    let started = Instant::now();
    room.run(line).with(0);
    let whole_run = started.elapsed();
    let new = room.read("a.exr");

    let (mut killed, mut left_old, mut left_new) = (0, 0, 0);
    for round in 0..kills() {
        room.write("a.exr", OLD);
        let mut child = Command::new(RAYPROOF)
            .args(line.split_whitespace())
            .current_dir(room.0.path())
            .stdout(Stdio::null())
            .spawn()
            .expect("a process");
        if round % 2 == 0 {
            // Spread over the whole run and a little more.
            std::thread::sleep(whole_run * (round + 1) * 6 / (kills() * 5));
        } else {
            wait_for_a_part(&room, whole_run * 2);
        }
        child.kill().expect("to be killed");
        let status = child.wait().expect("a child");
        killed += u32::from(status.code().is_none());

        let file = room.read("a.exr");
        assert!(
            file == OLD || file == new,
            "round {round}: {} bytes",
            file.len()
        );
        left_old += u32::from(file == OLD);
        left_new += u32::from(file == new);
        for name in room.names() {
            let known = name == "a.exr" || name == "ok.toml";
            assert!(known || is_temporary(&name), "round {round} left {name}");
            if is_temporary(&name) {
                fs::remove_file(room.path(&name)).expect("to be removed");
            }
        }
    }
    println!(
        "killed {killed} of {}: {left_old} old files, {left_new} new ones",
        kills()
    );
    // The control: the kills did hit the program at work.
    assert!(
        killed > kills() / 4 && left_old > 0,
        "{killed} killed, {left_old} old"
    );
}

/// Waits until a temporary file has something in it, or the picture is touched: the
/// most delicate moment.
fn wait_for_a_part(room: &Room, at_most: Duration) {
    let started = Instant::now();
    while started.elapsed() < at_most {
        let size = |name: &str| fs::metadata(room.path(name)).map_or(0, |data| data.len());
        let part = room.names().into_iter().find(|name| is_temporary(name));
        if part.is_some_and(|name| size(&name) > 0) || size("a.exr") != OLD.len() as u64 {
            return;
        }
    }
}

#[test]
fn what_a_killed_run_left_is_in_nobody_s_way() {
    let room = Room::new();
    room.write(".rayproof-abcdef.tmp", "a part");
    room.write("a.png", OLD);
    room.run("render ok.toml -o a.png").with(0);
    assert_ne!(room.read("a.png"), OLD);
    assert_eq!(room.read(".rayproof-abcdef.tmp"), b"a part");
}
