//! Results on standard output, all else on standard error.

use std::process::{Command, Stdio};

use serde_json::Value;

use super::{RAYPROOF, Room, has_fields};

const STATS: &str = "scene backend adapter driver width height samples accuracy bounds effects \
                     primitives seconds trace_ms rays mrays_per_s build_ms device_bytes";
const COMPARISON: &str = "left right pixels different_pixels max_abs rmse psnr_db flip \
                          id_mismatches max_ulp pass tolerance";
const ADAPTER: &str = "name driver type backend limits features arithmetic fetch";
const ARITHMETIC: &str = "two_sum two_prod contraction fma_fused division_ulp sqrt_ulp denormals \
                          f64 f64_ulp loop_budget";

/// A line for each command.
const ALL_COMMANDS: [&str; 8] = [
    "render ok.toml -o a.png",
    "compare ok.toml",
    "compare a.png a.png",
    "why ok.toml 24 16",
    "accuracy ok.toml --runs 1 --warmup 0",
    "check ok.toml",
    "doctor",
    "mesh box -o box.obj",
];

#[test]
fn a_run_without_trouble_says_nothing_on_standard_error() {
    let room = Room::new();
    for line in ALL_COMMANDS {
        let bare = format!("unset HOME XDG_RUNTIME_DIR; exec \"$0\" {line}");
        let ended = room.shell(&bare).with(0);
        assert_eq!(ended.err, "", "{line}");
        assert!(!ended.out.is_empty(), "{line}");
    }
}

#[test]
fn quiet_says_nothing_at_all() {
    let room = Room::new();
    for line in ALL_COMMANDS {
        let ended = room.run(&format!("{line} --quiet --progress json")).with(0);
        assert_eq!((ended.out.as_str(), ended.err.as_str()), ("", ""), "{line}");
    }
    // But for errors, and for what is asked for by name.
    room.run("check none.toml --quiet")
        .with(3)
        .telling(&["none.toml"]);
    room.run("check ok.toml --quiet --json").with(0).json();
}

#[test]
fn json_is_one_object_with_the_promised_fields() {
    let room = Room::new();
    for backend in ["cpu", "gpu"] {
        let line = format!("render ok.toml -o a.png --json --backend {backend}");
        let stats = room.run(&line).with(0).json();
        has_fields(&stats, STATS);
        assert_eq!(stats["width"], 48);
        assert_eq!(stats["rays"], 48 * 32);
        assert_eq!(stats["primitives"], 2);
        assert_eq!(stats["adapter"].is_string(), backend == "gpu");
    }
    for line in ["compare ok.toml --json", "compare a.png a.png --json"] {
        let comparison = room.run(line).with(0).json();
        has_fields(&comparison, COMPARISON);
        assert_eq!(comparison["pixels"], 48 * 32, "{line}");
        assert_eq!(comparison["pass"], true, "{line}");
    }
    let doctor = room.run("doctor --json").with(0).json();
    let adapters = doctor["adapters"].as_array().expect("a list");
    assert!(!adapters.is_empty());
    for adapter in adapters {
        has_fields(adapter, ADAPTER);
        has_fields(&adapter["arithmetic"], ARITHMETIC);
    }
    let mesh = room.run("mesh box -o box.obj --json").with(0).json();
    assert_eq!(mesh["triangles"], 12);
}

#[test]
fn stats_go_to_a_file_or_to_standard_output() {
    let room = Room::new();
    let table = room
        .run("render ok.toml -o a.png --stats stats.json")
        .with(0);
    assert!(table.out.contains("primitives  2\n"), "{table:#?}");
    let text = String::from_utf8(room.read("stats.json")).expect("text");
    let stats: Value = serde_json::from_str(&text).expect("JSON");
    assert_eq!(stats["schema"], 1);
    has_fields(&stats, STATS);
    for line in [
        "--stats -",
        "--stats - --json",
        "--json",
        "--stats - --quiet",
    ] {
        let stats = room
            .run(&format!("render ok.toml -o a.png {line}"))
            .with(0)
            .json();
        has_fields(&stats, STATS);
    }
}

#[test]
fn progress_as_json_is_a_line_each() {
    let room = Room::new();
    for backend in ["cpu", "gpu"] {
        let line = format!("render ok.toml -o a.png --progress json --backend {backend}");
        let ended = room.run(&line).with(0);
        assert!(!ended.err.is_empty());
        let mut furthest = 0.0_f64;
        for line in ended.err.lines() {
            let step: Value = serde_json::from_str(line).unwrap_or_else(|_| panic!("{ended:#?}"));
            has_fields(&step, "progress seconds work");
            let progress = step["progress"].as_f64().expect("a number");
            assert!((0.0..=1.0).contains(&progress), "{line}");
            furthest = furthest.max(progress);
        }
        assert_eq!(furthest, 1.0, "{backend}");
    }
    for mode in ["auto", "never"] {
        let line = format!("render ok.toml -o a.png --progress {mode}");
        assert_eq!(room.run(&line).with(0).err, "", "{mode}");
    }
}

/// The exit code with a pipe in place of a stream, closed at its other end.
fn with_closed(room: &Room, line: &str, out: bool, err: bool) -> Option<i32> {
    let stream = |closed| {
        if closed {
            Stdio::piped()
        } else {
            Stdio::null()
        }
    };
    let mut child = Command::new(RAYPROOF)
        .args(line.split_whitespace())
        .current_dir(room.0.path())
        .stdout(stream(out))
        .stderr(stream(err))
        .spawn()
        .expect("a process");
    drop((child.stdout.take(), child.stderr.take()));
    child.wait().expect("a child").code()
}

#[test]
fn a_closed_pipe_changes_nothing() {
    let room = Room::new();
    for line in ALL_COMMANDS.into_iter().chain(["--help", "doctor --json"]) {
        assert_eq!(with_closed(&room, line, true, false), Some(0), "{line}");
        assert_eq!(with_closed(&room, line, true, true), Some(0), "{line}");
    }
    let slow = "render ok.toml -o a.png -vv --progress json";
    assert_eq!(with_closed(&room, slow, false, true), Some(0));
    assert_eq!(with_closed(&room, "check none.toml", false, true), Some(3));
    assert_eq!(with_closed(&room, "paint", false, true), Some(2));
}

#[test]
fn help_and_version_are_results() {
    let room = Room::new();
    for line in ["--help", "-h", "help", "compare --help", "--version"] {
        let ended = room.run(line).with(0);
        assert!(ended.err.is_empty() && !ended.out.is_empty(), "{ended:#?}");
    }
}
