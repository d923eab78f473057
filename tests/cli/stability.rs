//! `stability`: what is tried, and what is told of it.

use serde_json::Value;

use super::{Room, has_fields};

const CASE: &str = "id name tier backend adapter rays wrong worst bound pass expected";

const SUM: &str =
    "tier backend adapter available reason passed failed expected_failures unexpected_passes";

fn list<'a>(results: &'a Value, name: &str) -> &'a [Value] {
    results[name].as_array().expect("a list")
}

#[test]
fn a_case_is_tried_in_every_tier_on_every_backend() {
    let room = Room::new();
    let results = room
        .run("stability --case sphere/far-1e3 --json")
        .with(0)
        .json();
    has_fields(&results, "rounds seconds cases summary");
    let cases = list(&results, "cases");
    assert_eq!(cases.len(), 10);
    for case in cases {
        has_fields(case, CASE);
        assert_eq!(case["expected"], true);
        let is_textbook = case["tier"] == "textbook";
        assert_eq!(case["pass"], !is_textbook);
        assert_eq!(case["wrong"].as_u64() > Some(0), is_textbook);
        let (worst, bound) = (case["worst"].as_f64(), case["bound"].as_f64());
        assert_eq!(worst > bound, is_textbook, "{case:#}");
    }
    let summary = list(&results, "summary");
    assert_eq!(summary.len(), 10);
    for sum in summary {
        has_fields(sum, SUM);
        let is_textbook = sum["tier"] == "textbook";
        let counts = ["passed", "expected_failures", "failed", "unexpected_passes"];
        let counts = counts.map(|count| sum[count].as_u64().unwrap());
        assert_eq!(
            counts,
            if is_textbook {
                [0, 1, 0, 0]
            } else {
                [1, 0, 0, 0]
            }
        );
    }
}

#[test]
fn the_table_has_the_tiers_asked_for() {
    let room = Room::new();
    let line = "stability --case sphere/far-1e3 --tier robust,textbook --backend cpu --threads 1";
    let run = room.run(line).with(0);
    let text = &run.out;
    let lines: Vec<&str> = text.lines().collect();
    let words = |line: &str| {
        line.split_whitespace()
            .map(str::to_string)
            .collect::<Vec<_>>()
    };
    assert_eq!(lines[0], "cpu");
    assert_eq!(words(lines[1]), ["case", "rays", "textbook", "robust"]);
    let row = words(lines[2]);
    assert_eq!(row[..2], ["sphere/far-1e3", "100000"]);
    assert_eq!((row[4].as_str(), row[5].as_str()), ("*", "0"));
    assert!(text.contains("All 2 outcomes are as expected"), "{text}");
}

#[test]
fn a_family_is_named_by_its_name() {
    let room = Room::new();
    let all = room.run("stability --list --json").with(0).json();
    let of_family = room
        .run("stability --case sphere --list --json")
        .with(0)
        .json();
    let (all, of_family) = (list(&all, "cases"), list(&of_family, "cases"));
    assert!(of_family.len() > 1 && of_family.len() < all.len());
    for case in of_family {
        has_fields(case, "id name sets_up danger demands expected_to_fail");
        assert!(case["id"].as_str().unwrap().starts_with("sphere/"));
    }
    let text = room.run("stability --list").with(0).out;
    assert_eq!(text.matches("expected to fail:").count(), all.len());
}

#[test]
fn what_there_is_not_is_told_with_what_there_is() {
    let room = Room::new();
    room.run("stability --case sphere/far-1e33")
        .with(2)
        .telling(&["no hard case `sphere/far-1e33`", "sphere/far-1e3,"]);
    room.run("stability --case spheres")
        .with(2)
        .telling(&["sphere, flat, triangle"]);
    room.run("stability --case sphere/far-1e3 --adapter none-such")
        .with(4)
        .telling(&["none-such"]);
    room.run("stability --backend cpu --adapter llvmpipe")
        .with(2)
        .telling(&["needs none"]);
    room.run("stability --case sphere/far-1e3 -o far.gif")
        .with(2)
        .telling(&["far.gif"]);
    room.run("stability --case sphere/far-1e3 -o far.png")
        .with(2)
        .telling(&["can be seen: sphere/far-1e4"]);
    room.run("stability --case sphere/far-1e4 -o nowhere/far.png")
        .with(6)
        .telling(&["nowhere"]);
}

#[test]
fn a_picture_shows_the_tiers_side_by_side() {
    let room = Room::new();
    let line = "stability --case sphere/far-1e4 --tier textbook,robust --backend cpu -o far.png";
    room.run(line).with(0);
    let bytes = room.read("far.png");
    let picture = image::load_from_memory(&bytes).unwrap().to_rgb8();
    let is_wrong = |x: u32, y: u32| {
        let [red, green, blue] = picture.get_pixel(x, y).0;
        red != green || green != blue
    };
    let (width, height) = picture.dimensions();
    let half = width / 2;
    let wrong = |columns: std::ops::Range<u32>| {
        let pixels = columns.flat_map(|x| (0..height).map(move |y| (x, y)));
        pixels.filter(|(x, y)| is_wrong(*x, *y)).count()
    };
    // The control stands on the left.
    assert!(wrong(0..half) > 1000);
    assert!(wrong(half..width) < 10);
}
