//! Pictures made of paths of light: samples and when there are enough, previews, interrupts,
//! samples that are no numbers, and what is done to the camera's rays alone.

use std::time::{Duration, Instant};

use serde_json::Value;

use super::interrupts::{SOON, Work};
use super::plan::EFFECTS;
use super::{PATIENCE, Room, has_fields};

/// A light so near to a tiny sphere that its inverse square is beyond f32.
const GLARING: &str = r#"
[image]
width = 16
height = 12

[integrator]
samples = 4

[camera]
eye = [0, 0, 1e-11]
target = [0, 0, 0]
fov = 20

[[light]]
kind = "point"
position = [0, 0, 2e-12]
falloff = "inverse-square"
intensity = 1e15

[[sphere]]
radius = 1e-12
"#;

fn room() -> Room {
    let room = Room::new();
    room.write("effects.toml", EFFECTS);
    room.write("glaring.toml", GLARING);
    room
}

/// The figures of a render on the CPU.
fn render(room: &Room, flags: &str) -> Value {
    let line = format!("render effects.toml --backend cpu --json {flags}");
    room.run(&line).with(0).json()
}

#[test]
fn samples_and_seed_are_the_scenes_or_the_flags() {
    let room = room();
    let stats = render(&room, "-o own.exr");
    has_fields(&stats, "samples noise effects rays");
    assert_eq!(stats["samples"], 4);
    assert_eq!(stats["rays"], 4 * 24 * 16);
    assert!(stats.get("faults").is_none(), "{stats:#}");
    let noise = |stats: &Value| stats["noise"].as_f64().expect("a number");
    let finer = render(&room, "-o finer.exr --samples 64");
    assert_eq!(finer["samples"], 64);
    assert!(noise(&finer) < noise(&stats), "{finer:#}");
    // A single sample tells nothing of how far it is off.
    let one = render(&room, "-o one.exr --samples 1");
    assert!(one.get("noise").is_none(), "{one:#}");
    render(&room, "-o again.exr");
    render(&room, "-o same.exr --samples 4 --seed 0");
    render(&room, "-o other.exr --seed 1");
    let own = room.read("own.exr");
    assert!(own == room.read("again.exr") && own == room.read("same.exr"));
    assert_ne!(own, room.read("other.exr"));
    let told = room
        .run("render effects.toml -o a.png --backend cpu")
        .with(0);
    assert!(told.out.contains("4 a pixel, "), "{told:#?}");
}

#[test]
fn numbers_out_of_range_are_refused() {
    let room = room();
    for (flag, told) in [
        ("--samples 0", "1..=65536"),
        ("--samples 65537", "1..=65536"),
        ("--seed -1", "--seed"),
        ("--seed 4294967296", "--seed"),
        ("--time -1", "number of seconds"),
        ("--time nan", "number of seconds"),
        ("--noise 0", "0.01 for a hundredth"),
        ("--noise 1", "0.01 for a hundredth"),
        ("--preview-every inf", "number of seconds"),
    ] {
        let (flag, value) = flag.split_once(' ').expect("two words");
        let line = format!("render effects.toml -o a.png {flag}={value}");
        room.run(&line).with(2).telling(&[told]);
    }
    assert!(!room.path("a.png").exists());
}

#[test]
fn a_render_ends_after_its_time() {
    let room = room();
    let started = Instant::now();
    let stats = render(&room, "-o a.png --time 1");
    let took = started.elapsed();
    let seconds = stats["seconds"].as_f64().expect("a number");
    // A sample more, of a thousandth of a second, on a busy machine.
    assert!((1.0..3.0).contains(&seconds), "{stats:#}");
    assert!(took >= Duration::from_secs(1), "{took:?}");
    let samples = stats["samples"].as_u64().expect("a number");
    assert!((2..65536).contains(&samples), "{stats:#}");
    assert!(!room.read("a.png").is_empty());
    // Time that is not needed is not taken.
    let stats = render(&room, "-o a.png --time 600 --samples 2");
    assert_eq!(stats["samples"], 2);
}

#[test]
fn a_render_ends_when_the_noise_is_small_enough() {
    let room = room();
    let noise = |stats: &Value| stats["noise"].as_f64().expect("a number");
    let stats = render(&room, "-o a.png --noise 0.2");
    assert!(noise(&stats) <= 0.2, "{stats:#}");
    let finer = render(&room, "-o a.png --noise 0.1");
    assert!(noise(&finer) <= 0.1, "{finer:#}");
    assert!(finer["samples"].as_u64() > stats["samples"].as_u64());
    assert!(finer["samples"].as_u64() < Some(65536), "{finer:#}");
    // Samples that are given are the most.
    let few = render(&room, "-o a.png --noise 0.0001 --samples 3");
    assert_eq!(few["samples"], 3);
}

#[test]
fn a_preview_is_there_before_the_end_and_an_interrupt_keeps_it() {
    let room = room();
    let names = ["effects.toml", "glaring.toml", "ok.toml", "preview.png"];
    let line = "render effects.toml -o preview.png --backend cpu --samples 65536 \
                --size 200x200 --preview-every 0.1 --progress json";
    let mut work = Work::start(&room, line);
    work.await_progress();
    let started = Instant::now();
    while !room.path("preview.png").exists() {
        assert!(started.elapsed() < PATIENCE, "no preview");
        std::thread::sleep(Duration::from_millis(10));
    }
    assert!(work.is_running());
    work.signal("INT");
    let (code, took) = work.end();
    assert_eq!(code, Some(130));
    assert!(took < SOON, "{took:?}");
    // The last preview, whole, and no part of a file.
    assert_eq!(room.names(), names);
    let picture = rayproof::frame::read_image(&room.path("preview.png")).expect("a picture");
    assert_eq!((picture.width, picture.height), (200, 200));
}

#[test]
fn an_interrupt_while_sampling_leaves_the_old_file() {
    for backend in ["cpu", "gpu"] {
        let room = room();
        room.write("a.png", "old");
        let line = format!(
            "render effects.toml -o a.png --backend {backend} --samples 65536 --size 400x400 \
             --progress json"
        );
        let mut work = Work::start(&room, &line);
        work.await_progress();
        work.signal("INT");
        let (code, took) = work.end();
        assert_eq!(code, Some(130), "{backend}");
        assert!(took < SOON, "{backend}: {took:?}");
        let names = ["a.png", "effects.toml", "glaring.toml", "ok.toml"];
        assert_eq!(room.names(), names, "{backend}");
        assert_eq!(room.read("a.png"), b"old", "{backend}");
    }
}

#[test]
fn gpu_and_cpu_agree_on_a_scene_of_effects() {
    let room = room();
    let line = "compare effects.toml --samples 4 --json";
    let compared = room.run(line).with(0).json();
    assert_eq!(compared["different_pixels"], 0, "{compared:#}");
}

#[test]
fn samples_that_are_no_numbers_are_told_with_the_pixel() {
    let room = room();
    for backend in ["cpu", "gpu"] {
        let line = format!("render glaring.toml -o a.exr --json --backend {backend}");
        let ended = room.run(&line).with(0);
        let stats = ended.json();
        let faults = stats["faults"].as_u64().expect("a number");
        let [x, y] = [0, 1].map(|axis| stats["first_fault"][axis].as_u64().expect("a pixel"));
        let told = format!("{faults} samples were infinite or not a number");
        let place = format!("in pixel ({x}, {y})");
        for words in [told, place] {
            assert!(ended.err.contains(&words), "no `{words}` in {ended:#?}");
        }
    }
    let compared = room.run("compare glaring.toml").with(0);
    assert!(compared.err.contains("in pixel ("), "{compared:#?}");
}

#[test]
fn what_is_done_to_the_cameras_rays_alone_says_so() {
    let room = room();
    let few = "--runs 1 --warmup 0 --backend cpu";
    let calls = "the scene calls for paths of light (hard shadows, emission, ";
    for (line, does) in [
        (
            format!("bench effects.toml --bounds none {few}"),
            "`bench` times the camera's rays alone",
        ),
        (
            format!("accuracy effects.toml --tier robust {few}"),
            "`accuracy` measures the camera's rays alone",
        ),
        (
            "why effects.toml 3 3".into(),
            "`why` explains the camera's rays alone",
        ),
        (
            "render effects.toml -o a.png --backend cpu --count".into(),
            "counted is what is tested by the camera's rays alone",
        ),
        (
            "render effects.toml -o a.png --backend cpu --layer tests".into(),
            "counted is what is tested by the camera's rays alone",
        ),
    ] {
        let ended = room.run(&line).with(0);
        assert_eq!(ended.err.matches(calls).count(), 1, "{line}: {ended:#?}");
        assert!(ended.err.contains(does), "{line}: {ended:#?}");
        let plain = room.run(&line.replace("effects.toml", "ok.toml")).with(0);
        assert!(!plain.err.contains("paths of light"), "{line}: {plain:#?}");
    }
}

#[test]
fn check_tells_samples_and_effects() {
    let room = room();
    let ended = room.run("check effects.toml").with(0);
    assert!(ended.out.contains("24 x 16, 4 paths a pixel"), "{ended:#?}");
    let contents = room.run("check effects.toml --json").with(0).json();
    assert_eq!(contents["samples"], 4);
    assert_eq!(contents["traced"], "paths");
    let effects = contents["effects"].as_array().expect("effects");
    assert!(
        effects.iter().any(|name| name == "soft shadows"),
        "{contents:#}"
    );
    let plain = room.run("check ok.toml").with(0);
    assert!(plain.out.contains("48 x 32, one ray a pixel"), "{plain:#?}");
}
