//! The scene format: every rule has a file that breaks it and a near-identical
//! one that keeps it.

#[path = "common/broken_files.rs"]
mod broken_files;

use std::path::Path;

use rayproof::Error;
use rayproof::scene::parse::parse_str;
use rayproof::scene::policy::Policy;

use broken_files::{Case, HEAD, breaks, each_breaks_alone, faults, parse, places};

#[rustfmt::skip]
const KEYS: &[Case] = &[
    ("[image]", "width = 0", "from 1 to 32768", "0", "width = 1"),
    ("[image]", "height = 32769", "from 1 to 32768", "32769", "height = 32768"),
    ("[image]", "width = 640.0", "expected a whole number, found a float", "640.0", "width = 640"),
    ("[image]", "width = -3", "not negative, but is -3", "-3", "width = 3"),
    ("[image]", "transfer = \"sgrb\"", "cannot be \"sgrb\"", "\"sgrb\"", "transfer = \"srgb\""),
    ("[image]", "heigth = 3", "unknown key `heigth`", "heigth", "height = 3"),
    ("[background]", "color = [0, -1, 0]", "must not be negative", "-1", "color = [0, 1, 0]"),
    ("[background]", "color = [0, 1]", "takes 3 values, found 2", "[0, 1]", "color = [0, 1, 0]"),
    ("[background]", "from = [1, 1, 1]", "lacks `to`", "[background]", "from = [1, 1, 1]\nto = [0, 0, 0]"),
    ("[background]", "color = [0, 0, 0]\nslope = 1", "both", "[background]", "slope = 1\nfrom = [0, 0, 0]\nto = [1, 1, 1]"),
    ("[[light]]", "kind = \"point\"", "lacks `position`", "[[light]]", "kind = \"point\"\nposition = [0, 1, 0]"),
    ("[[light]]", "kind = \"spot\"", "cannot be \"spot\"", "\"spot\"", "kind = \"directional\"\ndirection = [0, 1, 0]"),
    ("[[light]]", "position = [0, 1, 0]", "lacks `kind`", "[[light]]", "kind = \"point\"\nposition = [0, 1, 0]"),
    ("[[light]]\nkind = \"directional\"", "direction = [0, 0, 0]", "points nowhere", "[0, 0, 0]", "direction = [0, 1e-9, 0]"),
    ("[[light]]\nkind = \"directional\"\ndirection = [0, 1, 0]", "falloff = \"none\"", "unknown key `falloff`", "falloff", "intensity = 2"),
    ("[[light]]\nkind = \"point\"\nposition = [0, 1, 0]", "falloff = \"inverse\"", "cannot be", "\"inverse\"", "falloff = \"inverse-square\""),
    ("[[light]]\nkind = \"point\"\nposition = [0, 1, 0]", "intensity = -1", "must not be negative", "-1", "intensity = 0"),
    ("[[material]]\nname = \"m\"", "albedo = [0, 1.5, 0]", "between 0 and 1", "1.5", "albedo = [0, 1, 0]"),
    ("[[material]]\nname = \"m\"", "albedo = { random = -1 }", "not negative", "-1", "albedo = { random = 1 }"),
    ("[[material]]\nname = \"m\"", "albedo = { seed = 1, random = 1 }", "unknown key `seed`", "seed", "albedo = { random = 1 }"),
    ("[[material]]\nname = \"m\"", "", "lacks `albedo`", "[[material]]", "albedo = [0, 0, 0]"),
    ("[[material]]\nalbedo = [0, 0, 0]", "name = \"red\"", "defined twice", "\"red\"", "name = \"redder\""),
    ("[[sphere]]", "radius = 0", "greater than 0", "0", "radius = 1e-9"),
    ("[[sphere]]", "radius = 9e-16", "9e-16, below 1e-15", "9e-16", "radius = 1e-15"),
    ("[[sphere]]", "radius = -1", "greater than 0", "-1", "radius = 1"),
    ("[[sphere]]", "radius = nan", "finite", "nan", "radius = 1"),
    ("[[sphere]]", "radius = -inf", "finite", "-inf", "radius = 1"),
    ("[[sphere]]", "radius = 1e400", "1e400, beyond 1e15", "1e400", "radius = 1"),
    ("[[sphere]]", "radius = 1.1e15", "beyond 1e15", "1.1e15", "radius = 1e15"),
    ("[[sphere]]", "radius = 0xfffffffffffffff", "beyond 1e15", "0xfffffffffffffff", "radius = 0x10"),
    ("[[sphere]]", "radius = \"1\"", "expected a number, found a string", "\"1\"", "radius = 1"),
    ("[[sphere]]", "raduis = 1\nradius = 1", "unknown key `raduis`", "raduis", "radius = 1"),
    ("[[sphere]]", "", "lacks `radius`", "[[sphere]]", "radius = 1"),
    ("[[sphere]]\nradius = 1", "center = [0, 0, nan]", "finite", "nan", "center = [0, 0, 0]"),
    ("[[sphere]]\nradius = 1", "center = 3", "expected an array of 3, found an integer", "3", "center = [3, 3, 3]"),
    ("[[sphere]]\nradius = 1", "material = \"rde\"", "no material is named \"rde\"", "\"rde\"", "material = \"red\""),
    ("[[sphere]]\nradius = 1", "material = 1", "expected a string", "1", "material = \"default\""),
    ("[[sphere]]\nradius = 1", "scale = 0", "greater than 0", "0", "scale = 2"),
    ("[[sphere]]\nradius = 1", "scale = -2", "greater than 0", "-2", "scale = 2"),
    ("[[sphere]]\nradius = 1", "scale = [1, 2, 1]", "takes one number", "[1, 2, 1]", "scale = 2"),
    ("[[sphere]]\nradius = 1e10", "scale = 1e6", "after `scale`, `radius` is 1e16", "[[sphere]]", "scale = 1e5"),
    ("[[sphere]]\nradius = 1e-10", "scale = 1e-6", "after `scale`, `radius` is 1e-16", "[[sphere]]", "scale = 1e-5"),
    ("[[sphere]]\nradius = 1", "rotate = [0, 90]", "takes 3 values", "[0, 90]", "rotate = [0, 90, 0]"),
    ("[[sphere]]\nradius = 1", "translate = [0, 0, inf]", "finite", "inf", "translate = [0, 0, 1]"),
    ("[[sphere]]\nradius = 1", "grid = { count = [2, 0, 1], step = [1, 1, 1] }", "1 or more", "0", "grid = { count = [2, 1, 1], step = [1, 1, 1] }"),
    ("[[sphere]]\nradius = 1", "grid = { count = [2, 1, 1] }", "lacks `step`", "{ count = [2, 1, 1] }", "grid = { count = [2, 1, 1], step = [1, 1, 1] }"),
    ("[[sphere]]\nradius = 1", "grid = [2, 2, 2]", "expected a table", "[2, 2, 2]", "grid = { count = [2, 2, 2], step = [1, 1, 1] }"),
    ("[[sphere]]\nradius = 1", "grid = { count = [1025, 1024, 1], step = [1, 1, 1] }", "1049600 shapes here", "[[sphere]]", "grid = { count = [8, 8, 1], step = [1, 1, 1] }"),
    ("[[sphere]]\nradius = 1", "grid = { count = [9223372036854775807, 9223372036854775807, 1], step = [0, 0, 0] }", "more than 1048576", "[[sphere]]", "grid = { count = [8, 8, 1], step = [0, 0, 0] }"),
    ("[[sphere]]\nradius = 1", "grid = { count = [1, 1, 1000], step = [0, 0, 1e13] }", "reaches 9.99", "[[sphere]]", "grid = { count = [1, 1, 10], step = [0, 0, 1e13] }"),
    ("[[plane]]\npoint = [0, 0, 0]", "normal = [0, 0, 0]", "points nowhere", "[0, 0, 0]", "normal = [0, 0, 3]"),
    ("[[plane]]\npoint = [0, 0, 0]", "normal = [0, 1e-200, 0]", "points nowhere", "[0, 1e-200, 0]", "normal = [0, 1e-100, 0]"),
    ("[[plane]]\npoint = [0, 0, 0]", "", "lacks `normal`", "[[plane]]", "normal = [0, 0, 3]"),
    ("[[plane]]\npoint = [0, 0, 0]\nnormal = [0, 1, 0]", "scale = 0", "must not be 0", "0", "scale = -1"),
    ("[[disk]]\ncenter = [0, 0, 0]\nnormal = [0, 1, 0]", "radius = -1", "greater than 0", "-1", "radius = 1"),
    ("[[disk]]\nradius = 1\nnormal = [0, 1, 0]", "", "lacks `center`", "[[disk]]", "center = [0, 0, 0]"),
    ("[[triangle]]", "vertices = [[0, 0, 0], [0.1, 0.2, 0.3], [0.7, 1.4, 2.1]]", "no area", "[[0, 0, 0], [0.1, 0.2, 0.3], [0.7, 1.4, 2.1]]", "vertices = [[0, 0, 0], [0.1, 0.2, 0.3], [0.7, 1.4, 2.1001]]"),
    ("[[triangle]]", "vertices = [[0, 0, 0], [0, 0, 0], [1, 0, 0]]", "no area", "[[0, 0, 0], [0, 0, 0], [1, 0, 0]]", "vertices = [[0, 0, 0], [0, 1e-9, 0], [1, 0, 0]]"),
    ("[[triangle]]", "vertices = [[0, 0, 0], [0, 1, 0], [1, 0]]", "takes 3 values", "[1, 0]", "vertices = [[0, 0, 0], [0, 1, 0], [1, 0, 0]]"),
    ("[[mesh]]", "", "neither `file` nor `builtin`", "[[mesh]]", "builtin = \"box\""),
    ("[[mesh]]", "builtin = \"box\"\nfile = \"a.obj\"", "both `file` and `builtin`", "[[mesh]]", "builtin = \"box\""),
    ("[[mesh]]", "builtin = \"taepot\"", "cannot be \"taepot\"", "\"taepot\"", "builtin = \"teapot\""),
    ("[[mesh]]\nbuiltin = \"box\"", "detail = 3", "from 4 to 10000000", "3", "detail = 4"),
    ("[[mesh]]\nbuiltin = \"box\"", "detail = 10000001", "from 4 to 10000000", "10000001", "detail = 12"),
    ("[[mesh]]\nbuiltin = \"box\"\ngrid = { count = [100, 1, 1], step = [1, 0, 0] }", "detail = 1000000", "100000000 primitives", "[[mesh]]", "detail = 12"),
    ("[[mesh]]\nbuiltin = \"box\"", "scale = [1, 0, 1]", "must not be 0", "0", "scale = [1, -2, 1]"),
    ("[[mesh]]\nbuiltin = \"box\"", "scale = [1, -1e-16, 1]", "1e-16, below 1e-15", "-1e-16", "scale = [1, -1e-15, 1]"),
    ("[[mesh]]\nbuiltin = \"box\"", "scale = 1e15\ntranslate = [1e15, 0, 0]", "beyond 1e15", "[[mesh]]", "scale = 1e14"),
    ("[[mesh]]\nbuiltin = \"box\"", "smooth = 1", "expected true or false", "1", "smooth = false"),
];

#[test]
fn every_key_has_its_rule() {
    each_breaks_alone(KEYS);
}

#[test]
fn the_camera_looks_somewhere_and_knows_what_is_up() {
    let file = |camera: &str| {
        format!("[ambient]\ncolor = [1, 1, 1]\n[[sphere]]\nradius = 1\n[camera]\n{camera}")
    };
    let good = file("eye = [0, 0, 5]\ntarget = [0, 0, 0]\n");
    #[rustfmt::skip]
    let bad = [
        ("eye = [1, 2, 3]\ntarget = [1, 2, 3]", "looks nowhere", "[1, 2, 3]"),
        ("eye = [0, 5, 0]\ntarget = [0, 0, 0]", "parallel", "[camera]"),
        ("eye = [0, 0, 5]\ntarget = [0, 0, 0]\nup = [1e-9, 0, 1]", "parallel", "[1e-9, 0, 1]"),
        ("eye = [0, 0, 5]\ntarget = [0, 0, 0]\nup = [0, 0, 0]", "points nowhere", "[0, 0, 0]"),
        ("eye = [0, 0, 5]\ntarget = [0, 0, 0]\nfov = 0", "between 0 and 180", "0"),
        ("eye = [0, 0, 5]\ntarget = [0, 0, 0]\nfov = 180", "between 0 and 180", "180"),
        ("eye = [0, 0, 5]\ntarget = [0, 0, 0]\nsampling = \"middle\"", "cannot be", "\"middle\""),
        ("target = [0, 0, 0]", "lacks `eye`", "[camera]"),
        ("eye = [0, 0, 5]", "lacks `target`", "[camera]"),
    ];
    for (camera, message, at) in bad {
        breaks(&file(camera), message, at, &good);
    }
    let near = file("eye = [0, 0, 5]\ntarget = [0, 0, 0]\nup = [1e-7, 0, 1]\nfov = 179.9");
    parse(&near).expect("steep, but known to be so");
    breaks("[[sphere]]\nradius = 1\n", "no [camera]", "", &good);
}

#[test]
fn sections_are_known_and_stand_as_often_as_they_may() {
    let good = format!("{HEAD}[[sphere]]\nradius = 1\n");
    #[rustfmt::skip]
    let bad = [
        ("[sphere]\nradius = 1", "expected one [[sphere]] or more, found a table", "[sphere]"),
        ("[[image]]\nwidth = 3", "expected one [image], found an array", "[[image]]"),
        ("[[spheres]]\nradius = 1", "unknown key `spheres`", "spheres"),
        ("[metal]", "unknown key `metal`", "metal"),
    ];
    for (line, message, at) in bad {
        breaks(&format!("{HEAD}{line}\n"), message, at, &good);
    }
}

#[test]
fn all_faults_are_told_at_once_each_at_its_place() {
    let text = "\
[image]
width = 0
[camera]
eye = [0, 0, nan]
target = [0, 0]
fov = 60 70
[[light]]
kind = 'point'
[[material]]
name = 'red'
albedo = [2, 0, 0]
[[sphere]]
radius = -1
material = 'rad'
[[mesh]]
file = 'missing.obj'
[[disk]]
center = [0, 0, 0]
normal = [0, 0, 0]
radius = 1e16
";
    let found = faults(text);
    let expected = [
        (2, 9),
        (4, 14),
        (5, 10),
        (6, 7),
        (7, 1),
        (11, 11),
        (13, 10),
        (14, 12),
        (16, 8),
        (19, 10),
        (20, 10),
    ];
    let told: Vec<_> = found.faults.iter().map(|f| &f.message).collect();
    assert_eq!(places(&found), expected, "{told:#?}");

    let report = miette::GraphicalReportHandler::new_themed(miette::GraphicalTheme::none());
    let mut shown = String::new();
    report
        .render_report(&mut shown, &Error::Scene(Box::new(found)))
        .expect("it renders");
    for (line, column) in expected {
        let place = format!("test.toml:{line}:{column}]");
        assert!(shown.contains(&place), "{place} in\n{shown}");
    }
    assert!(shown.contains("did you mean `red`?"), "{shown}");
}

#[test]
fn a_flood_of_faults_is_counted_and_not_all_told() {
    let text = format!("{HEAD}{}", "[[sphere]]\nradius = -1\n".repeat(250));
    let found = faults(&text);
    assert_eq!(found.faults.len(), 101);
    assert_eq!(found.faults[100].message, "and 150 more faults");
}

#[test]
fn what_is_odd_is_a_warning() {
    let lit = format!("{HEAD}[[sphere]]\nradius = 1\n");
    assert!(parse(&lit).expect("good").warnings.is_empty());
    let empty = parse(HEAD).expect("an empty scene");
    assert!(
        empty.warnings[0].contains("no shapes"),
        "{:?}",
        empty.warnings
    );
    let dark = parse(&lit.replace("[1, 1, 1]", "[0, 0, 0]")).expect("a dark scene");
    assert!(dark.warnings[0].contains("no light"), "{:?}", dark.warnings);
}

#[test]
fn a_byte_order_mark_is_passed_over_and_spans_stay_right() {
    let good = format!("\u{feff}{HEAD}[[sphere]]\nradius = 1\n");
    parse(&good).expect("a mark is no fault");
    let found = faults(&good.replace("radius = 1", "radius = 0"));
    assert_eq!(places(&found), [(10, 10)]);
}

#[test]
fn a_missing_key_is_not_blamed_on_a_table_that_cannot_be_read() {
    let found = faults(&format!(
        "{HEAD}[[sphere]]\nradius = abc\n[[disk]]\nradius = 1\n"
    ));
    let all: Vec<_> = found.faults.iter().map(|f| f.message.as_str()).collect();
    assert_eq!(all.len(), 3, "{all:#?}");
    assert!(all[0].starts_with("TOML syntax"));
    assert!(all[1].contains("[[disk]] lacks") && all[2].contains("[[disk]] lacks"));
}

#[test]
fn the_scenes_of_this_project_load() {
    let folder = Path::new(env!("CARGO_MANIFEST_DIR")).join("assets/scenes");
    let mut seen = 0;
    for entry in std::fs::read_dir(&folder).expect("assets/scenes") {
        let path = entry.expect("an entry").path();
        if path.is_dir() {
            continue; // the images that scenes refer to
        }
        let loaded = rayproof::scene::parse::load(&path, &Policy::default())
            .unwrap_or_else(|e| panic!("{:?}", miette::Report::new(e)));
        assert_eq!(loaded.warnings, Vec::<String>::new(), "{}", path.display());
        loaded.scene.validate().expect("valid");
        seen += 1;
    }
    assert!(seen >= 4, "{seen} scenes in {}", folder.display());
}

/// The fenced blocks of a language in the reference.
fn blocks(language: &str) -> Vec<&'static str> {
    const REFERENCE: &str = include_str!("../docs/scene-format.md");
    let fence = format!("```{language}\n");
    let after = REFERENCE.split(fence.as_str()).skip(1);
    after.filter_map(|rest| rest.split("```").next()).collect()
}

#[test]
fn the_examples_of_the_reference_load_without_a_warning() {
    let examples = blocks("toml");
    assert_eq!(examples.len(), 3);
    for (example, shapes) in examples.iter().zip([29, 3]) {
        let loaded = parse(example).unwrap_or_else(|e| panic!("{:?}", miette::Report::new(e)));
        assert_eq!(loaded.warnings, Vec::<String>::new());
        assert_eq!(loaded.scene.shapes.len(), shapes);
    }
    let groups = "[camera]\neye = [0, 0, 5]\ntarget = [0, 0, 0]\n\n".to_string() + examples[2];
    let loaded = parse(&groups).unwrap_or_else(|e| panic!("{:?}", miette::Report::new(e)));
    let parents: Vec<_> = loaded
        .scene
        .groups
        .iter()
        .map(|group| group.parent)
        .collect();
    assert_eq!(parents, [None, Some(0)]);
    assert_eq!(
        rayproof::bounds::overfull_groups(&loaded.scene),
        Vec::<String>::new()
    );
}

/// Groups that make no sense, each told where it stands.
#[test]
fn faults_of_groups() {
    for (group, words) in [
        ("[[group]]\nbound = \"box\"", "auto"),
        (
            "[[group]]\nbound = { center = [0, 0, 0] }",
            "lacks `radius`",
        ),
        (
            "[[group]]\nbound = { low = [0, 0, 0], high = [1, 0, 1] }",
            "must lie below",
        ),
        ("[[group]]\nbund = \"auto\"", "unknown key `bund`"),
        (
            "[[group]]\n[[group.plane]]\npoint = [0, 0, 0]\nnormal = [0, 1, 0]",
            "a plane has no",
        ),
        ("[[group]]\n[[group.sphere]]\nradius = -1", "greater than 0"),
        ("[group]\nname = \"one\"", "[[group]]"),
    ] {
        let text = format!("[camera]\neye = [0, 0, 5]\ntarget = [0, 0, 0]\n\n{group}\n");
        let error = parse(&text).expect_err(group);
        let told = format!("{:?}", miette::Report::new(error));
        assert!(told.contains(words), "{group}: {told}");
    }
}

#[test]
fn the_error_of_the_reference_is_the_one_that_is_told() {
    let text = "\
[camera]
eye = [0, 0, 5]
target = [0, 0, 0]

[[material]]
name = \"clay\"
albedo = [0.7, 0.4, 0.3]

[[sphere]]
radius = -1
material = \"caly\"

[[disk]]
center = [0, 0, 0]
radius = 1
";
    let policy = Policy::default();
    let error = parse_str(text, "scene.toml", Path::new("."), &policy).expect_err("three faults");
    let theme = miette::GraphicalTheme::unicode_nocolor();
    let mut shown = String::new();
    miette::GraphicalReportHandler::new_themed(theme)
        .render_report(&mut shown, &error)
        .expect("it renders");
    let trimmed = |s: &str| {
        s.lines()
            .map(|l| l.trim_end().to_owned())
            .collect::<Vec<_>>()
    };
    let told = trimmed(shown.trim_end());
    let printed = trimmed(blocks("text")[0].trim_end());
    assert_eq!(told, printed);
}
