//! `why`: one pixel explained.

use serde_json::json;

use super::{Room, SCENE, has_fields};

const FIELDS: &str = "scene width height x y bounds primitives ray exact tiers path candidates";
const RAY: &str = "eye origin direction length direction_f32 turned";
const TIER: &str = "accuracy id t verdict exact_of_input in_doubt counters why";
const CANDIDATE: &str = "id kind shape triangle material t margin meetings interval";
const MEETING: &str = "accuracy t error intersection_error";

#[test]
fn a_pixel_is_explained_in_text() {
    let room = Room::new();
    let told = room.run("why ok.toml 24 16").with(0);
    assert_eq!(told.err, "");
    for words in [
        "24 16 of 48 x 32",
        "sphere 0 (shape 0, clay)",
        "plane 1 (shape 1, default)",
        "textbook  sphere 0: right",
        "adaptive  sphere 0: right; certain",
    ] {
        assert!(told.out.contains(words), "no `{words}` in {told:#?}");
    }
    // The control: in a corner there is no sphere.
    let corner = room.run("why ok.toml 0 31").with(0);
    assert!(corner.out.contains("plane 1: right"), "{corner:#?}");
    assert!(!corner.out.contains("sphere 0 (shape"), "{corner:#?}");
    let sky = room.run("why ok.toml 0 0").with(0);
    assert!(sky.out.contains("nothing: right"), "{sky:#?}");
}

#[test]
fn verbose_lists_the_volumes() {
    let room = Room::new();
    let two = format!("{SCENE}[[sphere]]\ncenter = [3, 0, 0]\nradius = 1\n");
    room.write("two.toml", two);
    let brief = room.run("why two.toml 24 16").with(0);
    assert!(!brief.out.contains("box 1: met"), "{brief:#?}");
    let full = room.run("why two.toml 24 16 -v").with(0);
    assert!(full.out.contains("box 1: met, t = "), "{full:#?}");
    let balls = room
        .run("why two.toml 24 16 --bounds none --size 480x320")
        .with(0);
    assert!(balls.out.contains("24 16 of 480 x 320"), "{balls:#?}");
}

#[test]
fn json_has_the_promised_fields() {
    let room = Room::new();
    let why = room.run("why ok.toml 24 16 --json").with(0).json();
    has_fields(&why, FIELDS);
    has_fields(&why["ray"], RAY);
    has_fields(&why["exact"], "id t margin why");
    has_fields(&why["path"], "id steps");
    assert_eq!(why["exact"]["id"], 0);
    let tiers = why["tiers"].as_array().expect("a list");
    let names: Vec<_> = tiers.iter().map(|tier| &tier["accuracy"]).collect();
    let expected = ["textbook", "robust", "extended", "double", "adaptive"];
    assert_eq!(json!(names), json!(expected));
    for tier in tiers {
        has_fields(tier, TIER);
        has_fields(&tier["counters"], "bound_tests bound_hits shape_tests");
        assert_eq!(tier["verdict"], "right");
        assert_eq!(
            tier["in_doubt"].is_boolean(),
            tier["accuracy"] == "adaptive"
        );
    }
    let candidates = why["candidates"].as_array().expect("a list");
    assert_eq!(candidates.len(), 2);
    for candidate in candidates {
        has_fields(candidate, CANDIDATE);
        has_fields(&candidate["interval"], "low high");
        let meetings = candidate["meetings"].as_array().expect("a list");
        assert_eq!(meetings.len(), 4);
        meetings
            .iter()
            .for_each(|meeting| has_fields(meeting, MEETING));
    }
    let sky = room.run("why ok.toml 0 0 --json").with(0).json();
    assert!(sky["exact"]["id"].is_null() && sky["path"].is_null());
}

#[test]
fn a_pixel_outside_of_the_picture_is_wrong_usage() {
    let room = Room::new();
    for pixel in ["48 0", "0 32"] {
        room.run(&format!("why ok.toml {pixel}")).with(2).telling(&[
            "48 x 32",
            "x is 0 to 47",
            "y is 0 to 31",
        ]);
    }
    room.run("why ok.toml 47 31").with(0);
    for (line, word) in [
        ("why ok.toml 3", "<Y>"),
        ("why ok.toml 3 up", "up"),
        ("why ok.toml 3 3 --levels 2", "--levels"),
    ] {
        room.run(line).with(2).telling(&[word]);
    }
}

#[test]
fn a_scene_at_fault_is_told_as_everywhere() {
    let room = Room::new();
    room.run("why none.toml 0 0")
        .with(3)
        .telling(&["none.toml"]);
    room.write("typo.toml", SCENE.replace("radius", "radus"));
    room.run("why typo.toml 0 0")
        .with(3)
        .telling(&["did you mean `radius`"]);
}
