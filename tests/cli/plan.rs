//! `plan`: what a scene calls for, and what that costs.

use super::{Ended, Room, has_fields};

/// A small scene that calls for most effects.
pub(super) const EFFECTS: &str = r#"
[image]
width = 24
height = 16

[integrator]
samples = 4
bounces = 1

[camera]
eye = [0, 1, 6]
target = [0, 0.5, 0]
aperture = 0.1

[fog]
density = 0.01

[ambient]
color = [0.1, 0.1, 0.1]
occlusion = 2

[[light]]
name = "sun"
kind = "point"
position = [3, 5, 4]
intensity = 2

[[light]]
kind = "sphere"
position = [-3, 5, 4]
radius = 0.5
intensity = 30

[[material]]
name = "steel"
mirror = 0.8
roughness = 0.3

[[material]]
name = "glass"
ior = 1.5

[[material]]
name = "tiles"
texture = { checker = [0.1, 0.2, 0.3] }

[[sphere]]
radius = 1
material = "steel"

[[sphere]]
radius = 0.5
center = [1.5, 0, 1]
material = "glass"
velocity = [0, 0.2, 0]

[[plane]]
point = [0, -1, 0]
normal = [0, 1, 0]
material = "tiles"
"#;

/// Why an effect is on, in `EFFECTS`; the line is found by what stands in it.
const REASONS: [(&str, &str, &str); 13] = [
    ("spheres", "sphere 1", "[[sphere]]\nradius = 1"),
    ("planes", "plane 1", "[[plane]]"),
    ("point lights", "light \"sun\"", "[[light]]\nname = \"sun\""),
    ("hard shadows", "light \"sun\"", "[[light]]\nname = \"sun\""),
    ("soft shadows", "light 2", "[[light]]\nkind = \"sphere\""),
    (
        "indirect light",
        "the bounces of [integrator]",
        "[integrator]",
    ),
    ("anti-aliasing", "4 samples of [integrator]", "[integrator]"),
    (
        "glossy reflection",
        "material \"steel\"",
        "[[material]]\nname = \"steel\"",
    ),
    (
        "refraction",
        "material \"glass\"",
        "[[material]]\nname = \"glass\"",
    ),
    (
        "textures",
        "material \"tiles\"",
        "[[material]]\nname = \"tiles\"",
    ),
    ("motion blur", "sphere 2", "[[sphere]]\nradius = 0.5"),
    ("depth of field", "the aperture of [camera]", "[camera]"),
    ("fog", "[fog]", "[fog]"),
];

fn room() -> Room {
    let room = Room::new();
    room.write("effects.toml", EFFECTS);
    let spheres = include_str!("../../assets/scenes/seed-spheres.toml");
    room.write("spheres.toml", spheres);
    room
}

/// The line of a text on which a part of it begins.
fn line_of(part: &str) -> usize {
    let start = EFFECTS.find(part).expect("a part");
    EFFECTS[..start].lines().count() + 1
}

/// The reason in an effect's row of the table, where it is on.
fn reason_in<'e>(ended: &'e Ended, name: &str) -> &'e str {
    let mut lines = ended.out.lines();
    let row = lines.find_map(|line| line.strip_prefix(name)?.trim_start().strip_prefix("on "));
    row.unwrap_or_else(|| panic!("no {name} in {ended:#?}"))
        .trim()
}

#[test]
fn the_first_scene_calls_for_little() {
    let room = room();
    let ended = room.run("plan spheres.toml").with(0);
    assert_eq!(
        reason_in(&ended, "spheres"),
        "sphere 1, line 39, and 71 more"
    );
    assert_eq!(reason_in(&ended, "tree"), "bounds `tree`");
    assert_eq!(reason_in(&ended, "directional lights"), "light 1, line 24");
    assert!(
        ended.out.contains("1000 x 1000, one ray a pixel"),
        "{ended:#?}"
    );
    let plan = room.run("plan spheres.toml --json").with(0).json();
    has_fields(
        &plan,
        "effects bindings shader_words full_shader_words files files_left_out",
    );
    assert_eq!(plan["traced"], "rays");
    let effects = plan["effects"].as_array().expect("effects");
    for effect in effects {
        has_fields(effect, "name on reason cost_ms");
        assert!(effect["cost_ms"].is_null(), "{effect:#}");
    }
    let on = effects.iter().filter(|effect| effect["on"] == true);
    let on: Vec<_> = on.map(|effect| effect["name"].as_str()).collect();
    assert_eq!(on, ["spheres", "tree", "directional lights"].map(Some));
    // No effect that is out leaves a buffer behind.
    for binding in plan["bindings"].as_array().expect("bindings") {
        has_fields(binding, "name group binding access");
        assert!(binding["effect"].is_null(), "{binding:#}");
    }
    let words = |name: &str| plan[name].as_u64().expect("words");
    assert!(
        words("shader_words") < words("full_shader_words") / 3,
        "{plan:#}"
    );
}

#[test]
fn reasons_name_what_calls_for_an_effect_and_its_line() {
    let room = room();
    let table = room.run("plan effects.toml").with(0);
    let plan = room.run("plan effects.toml --json").with(0).json();
    assert_eq!(
        (&plan["traced"], &plan["samples"]),
        (&"paths".into(), &4.into())
    );
    let effects = plan["effects"].as_array().expect("effects");
    for (name, what, part) in REASONS {
        let told = reason_in(&table, name);
        let begins = format!("{what}, line {}", line_of(part));
        assert!(told.starts_with(&begins), "{name}: {told}, not {begins}");
        let mut named = effects.iter().filter(|effect| effect["name"] == name);
        let effect = named.next().expect("an effect");
        assert_eq!(
            (&effect["on"], &effect["reason"]),
            (&true.into(), &told.into())
        );
    }
    let bindings = plan["bindings"].as_array().expect("bindings");
    for effect in ["depth of field", "motion blur", "fog", "soft shadows"] {
        assert!(
            bindings.iter().any(|binding| binding["effect"] == effect),
            "{effect}"
        );
    }
    assert!(table.out.contains("24 x 16, 4 paths a pixel"), "{table:#?}");
}

#[test]
fn effects_are_left_out_and_forced() {
    let room = room();
    let plan = |flags: &str| {
        let ended = room.run(&format!("plan effects.toml --json {flags}"));
        ended.with(0).json()
    };
    let effect = |plan: &serde_json::Value, name: &str| {
        let effects = plan["effects"].as_array().expect("effects");
        let mut named = effects.iter().filter(|effect| effect["name"] == name);
        named.next().expect("an effect").clone()
    };
    let whole = plan("");
    let left = plan("--without fog,refraction");
    for name in ["fog", "refraction"] {
        assert_eq!(effect(&whole, name)["on"], true);
        assert_eq!(effect(&left, name)["on"], false);
    }
    assert!(left["shader_words"].as_u64() < whole["shader_words"].as_u64());
    let forced = plan("--force environment");
    let environment = effect(&forced, "environment");
    assert_eq!(environment["on"], true);
    let reason = environment["reason"].as_str().expect("a reason");
    assert!(reason.contains("forced"), "{reason}");
    let all = plan("--force all");
    assert_eq!(all["shader_words"], all["full_shader_words"]);
    // One path effect is enough for paths.
    let spheres = room
        .run("plan spheres.toml --json --force fog")
        .with(0)
        .json();
    assert_eq!(spheres["traced"], "paths");
}

#[test]
fn wrong_names_are_told_with_the_right_ones() {
    let room = room();
    for flag in ["--without", "--force"] {
        let line = format!("plan effects.toml {flag} fogg");
        let names = [
            "no effect is named `fogg`",
            "spheres, ",
            "fog, ",
            "alpha cut-outs",
        ];
        room.run(&line).with(2).telling(&names);
        let told = ["`tree` cannot be", "`--bounds` chooses the volumes"];
        let line = format!("plan effects.toml {flag} tree");
        room.run(&line).with(2).telling(&told);
    }
    let told = ["`spheres` cannot be left out: it comes with the scene's shapes"];
    room.run("plan effects.toml --without spheres")
        .with(2)
        .telling(&told);
    room.run("plan missing.toml")
        .with(3)
        .telling(&["missing.toml"]);
}

#[test]
fn the_screen_is_no_use_to_paths() {
    let room = room();
    let line = "plan effects.toml --bounds screen --json";
    let plan = room.run(line).with(0).json();
    let effects = plan["effects"].as_array().expect("effects");
    let screen = effects.iter().find(|effect| effect["name"] == "screen");
    let screen = screen.expect("a row");
    assert_eq!(screen["on"], false, "{screen:#}");
    let reason = screen["reason"].as_str().expect("a reason");
    assert!(reason.contains("no use to paths"), "{reason}");
    let spheres = room.run("plan spheres.toml --bounds screen").with(0);
    assert_eq!(reason_in(&spheres, "screen"), "bounds `screen`");
}

/// On the CPU, which compiles nothing.
#[test]
fn costs_are_measured_and_the_proof_is_made() {
    let room = room();
    let line = "plan effects.toml --measure --runs 1 --warmup 0 --size 32x24 --backend gpu";
    let measured = room.run(&format!("{line} --json")).with(0).json();
    assert_eq!(
        (&measured["width"], &measured["height"]),
        (&32.into(), &24.into())
    );
    let backend = measured["backend"].as_str().expect("a name");
    assert!(backend.starts_with("gpu"), "{backend}");
    assert_eq!(measured["proof"]["equal"], true, "{measured:#}");
    assert_eq!(measured["proof"]["different_pixels"], 0, "{measured:#}");
    for effect in measured["effects"].as_array().expect("effects") {
        let comes_with_shapes = ["spheres", "planes", "tree"];
        let is_kept = comes_with_shapes.iter().any(|name| effect["name"] == *name);
        let is_measured = effect["on"] == true && !is_kept;
        assert_eq!(effect["cost_ms"].is_f64(), is_measured, "{effect:#}");
        if is_measured {
            let [cost, with, without] = ["cost_ms", "with_ms", "without_ms"]
                .map(|name| effect[name].as_f64().expect("a number"));
            // Three numbers that are read back, each to an ulp of the larger time.
            let bound = 4.0 * f64::EPSILON * with.max(without);
            assert!((cost - (with - without)).abs() <= bound, "{effect:#}");
            let share = effect["share"].as_f64().expect("a number");
            assert!(share <= 1.0, "{effect:#}");
        }
    }
    let table = room.run(line).with(0);
    assert!(table.out.contains("cost ms"), "{table:#?}");
    assert!(
        table.out.contains("every bit of the picture is the same"),
        "{table:#?}"
    );
    // Nothing is left out of the CPU's code, so there is nothing to prove.
    let on_cpu = room.run(&line.replace("gpu", "cpu")).with(0);
    assert!(on_cpu.out.contains("cost ms"), "{on_cpu:#?}");
    assert!(!on_cpu.out.contains("proof"), "{on_cpu:#?}");
}
