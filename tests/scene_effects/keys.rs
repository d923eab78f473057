//! Every rule has a file that breaks it and a near-identical one that keeps it.

use crate::broken_files::{Case, breaks, each_breaks_alone};

#[rustfmt::skip]
const KEYS: &[Case] = &[
    ("[integrator]", "samples = 0", "from 1 to 65536", "0", "samples = 1"),
    ("[integrator]", "samples = 65537", "from 1 to 65536", "65537", "samples = 65536"),
    ("[integrator]", "bounces = 65", "from 0 to 64", "65", "bounces = 64"),
    ("[integrator]", "reflections = -1", "not negative", "-1", "reflections = 0"),
    ("[integrator]", "seed = 4294967296", "from 0 to 4294967295", "4294967296", "seed = 4294967295"),
    ("[integrator]", "strategy = \"light\"", "cannot be \"light\"", "\"light\"", "strategy = \"lights\""),
    ("[integrator]", "sample = 3", "unknown key `sample`", "sample", "samples = 3"),
    ("[[light]]\nkind = \"point\"\nposition = [0, 1, 0]", "shadow = 1", "expected true or false", "1", "shadow = true"),
    ("[[light]]\nkind = \"directional\"\ndirection = [0, 1, 0]", "shadow = \"no\"", "expected true or false", "\"no\"", "shadow = false"),
    ("[[light]]\nkind = \"point\"\nposition = [0, 1, 0]", "name = 3", "expected a string", "3", "name = \"key\""),
    ("[[light]]\nkind = \"sphere\"\nposition = [0, 1, 0]", "radius = 0", "greater than 0", "0", "radius = 0.1"),
    ("[[light]]\nkind = \"sphere\"\nradius = 1", "", "lacks `position`", "[[light]]", "position = [0, 3, 0]"),
    ("[[light]]\nkind = \"sphere\"\nradius = 1\nposition = [0, 3, 0]", "shadow = true", "unknown key `shadow`", "shadow", "intensity = 2"),
    ("[[light]]\nkind = \"sphere\"\nposition = [1e14, 0, 0]", "radius = 1e15", "the light reaches 1.1e15", "[[light]]", "radius = 1e14"),
    ("[[light]]\nkind = \"disk\"\nposition = [0, 1, 0]\nradius = 1", "normal = [0, 0, 0]", "points nowhere", "[0, 0, 0]", "normal = [0, -1, 0]"),
    ("[[light]]\nkind = \"rectangle\"\ncorner = [0, 3, 0]\nright = [1, 0, 0]", "up = [2, 0, 0]", "are parallel", "[2, 0, 0]", "up = [2, 0, 1e-6]"),
    ("[[light]]\nkind = \"rectangle\"\ncorner = [0, 3, 0]\nup = [1, 0, 0]", "right = [0, 9e-16, 0]", "shorter than 1e-15", "[0, 9e-16, 0]", "right = [0, 1e-15, 0]"),
    ("[[light]]\nkind = \"rectangle\"\ncorner = [0, 3, 0]\nup = [1, 0, 0]", "", "lacks `right`", "[[light]]", "right = [0, 0, 1]"),
    ("[[light]]\nkind = \"disk\"\nposition = [0, 1, 0]\nradius = 1\nnormal = [0, 1, 0]\ncolor = [2, 2, 2]", "intensity = 1e15", "2e15, beyond 1e15", "[[light]]", "intensity = 1e14"),
    ("[[material]]\nname = \"m\"", "mirror = 1.5", "between 0 and 1", "1.5", "mirror = 1"),
    ("[[material]]\nname = \"m\"", "mirror = [0, -0.1, 1]", "between 0 and 1", "-0.1", "mirror = [0, 0.1, 1]"),
    ("[[material]]\nname = \"m\"", "mirror = \"gold\"", "expected a number or an array of 3", "\"gold\"", "mirror = [1, 0.8, 0.3]"),
    ("[[material]]\nname = \"m\"", "roughness = 1.1", "between 0 and 1", "1.1", "roughness = 1"),
    ("[[material]]\nname = \"m\"", "ior = 0.9", "from 1 to 4", "0.9", "ior = 1"),
    ("[[material]]\nname = \"m\"", "ior = nan", "finite", "nan", "ior = 4"),
    ("[[material]]\nname = \"m\"\nior = 1.5", "mirror = 0.5", "`mirror` goes without `ior`", "0.5", "absorption = [0, 1, 2]"),
    ("[[material]]\nname = \"m\"\nior = 1.5", "roughness = 0", "`roughness` goes without `ior`", "0", "emission = [0, 1, 2]"),
    ("[[material]]\nname = \"m\"\nior = 1.5", "texture = { checker = [0, 0, 0] }", "`texture` goes without `ior`", "{ checker = [0, 0, 0] }", ""),
    ("[[material]]\nname = \"m\"\nalbedo = [1, 1, 1]", "absorption = [0, 1, 2]", "goes with `ior`", "[0, 1, 2]", "ior = 1.5\nabsorption = [0, 1, 2]"),
    ("[[material]]\nname = \"m\"\nior = 1.5", "absorption = [0, -1, 0]", "must not be negative", "-1", "absorption = [0, 1000, 0]"),
    ("[[material]]\nname = \"m\"", "emission = [0, -1, 0]", "must not be negative", "-1", "emission = [1000, 0, 0]"),
    ("[[material]]\nname = \"m\"", "texture = {}", "neither `checker` nor `file`", "{}", "texture = { checker = [0, 0, 0] }"),
    ("[[material]]\nname = \"m\"", "texture = { checker = [0, 0, 0], file = \"a.png\" }", "both", "{ checker = [0, 0, 0], file = \"a.png\" }", "texture = { checker = [0, 0, 0] }"),
    ("[[material]]\nname = \"m\"", "texture = { checker = [0, 1.5, 0] }", "between 0 and 1", "1.5", "texture = { checker = [0, 1, 0] }"),
    ("[[material]]\nname = \"m\"", "texture = { checker = [0, 1, 0], repeat = [1, 0] }", "greater than 0", "0", "texture = { checker = [0, 1, 0], repeat = [1, 0.5] }"),
    ("[[material]]\nname = \"m\"", "texture = { checker = [0, 1, 0], repeat = [1, 2, 3] }", "takes 2 values, found 3", "[1, 2, 3]", "texture = { checker = [0, 1, 0], repeat = [1, 2] }"),
    ("[[material]]\nname = \"m\"", "texture = { checker = [0, 1, 0], size = -1 }", "greater than 0", "-1", "texture = { checker = [0, 1, 0], size = 1 }"),
    ("[[material]]\nname = \"m\"", "texture = { file = \"missing.png\" }", "missing.png", "\"missing.png\"", "texture = { checker = [0, 1, 0] }"),
    ("[[material]]\nname = \"m\"", "texture = \"wood.png\"", "expected a table", "\"wood.png\"", "texture = { checker = [0, 1, 0] }"),
    ("[[material]]\nname = \"m\"\nalbedo = [1, 1, 1]", "alpha = \"cutout\"", "goes with a texture from a file", "\"cutout\"", "alpha = \"ignore\""),
    ("[[material]]\nname = \"m\"\ntexture = { checker = [0, 0, 0] }", "alpha = \"cutout\"", "goes with a texture from a file", "\"cutout\"", "alpha = \"ignore\""),
    ("[[material]]\nname = \"m\"\nalbedo = [1, 1, 1]", "alpha = \"cut\"", "cannot be \"cut\"", "\"cut\"", "alpha = \"ignore\""),
    ("[[material]]\nname = \"m\"", "alpha = \"ignore\"", "lacks `albedo`", "[[material]]", "alpha = \"ignore\"\nalbedo = [1, 1, 1]"),
    ("[[material]]\nname = \"m\"\nmirror = 1", "rougness = 1", "unknown key `rougness`", "rougness", "roughness = 1"),
    ("[environment]", "", "none of `file`, `color` and a ramp", "[environment]", "color = [1, 1, 1]"),
    ("[environment]", "color = [1, 1, 1]\nslope = 1", "more than one of", "[environment]", "from = [1, 1, 1]\nto = [0, 0, 0]\nslope = 1"),
    ("[environment]", "file = \"sky.exr\"\ncolor = [1, 1, 1]", "more than one of", "[environment]", "color = [1, 1, 1]"),
    ("[environment]", "from = [1, 1, 1]", "lacks `to`", "[environment]", "from = [1, 1, 1]\nto = [0, 0, 0]"),
    ("[environment]", "file = \"missing.exr\"", "missing.exr", "\"missing.exr\"", "color = [1, 1, 1]"),
    ("[environment]", "file = \"sky.png\"", ".exr or .hdr", "\"sky.png\"", "color = [1, 1, 1]"),
    ("[environment]\ncolor = [1, 1, 1]", "intensity = -1", "must not be negative", "-1", "intensity = 0"),
    ("[environment]\ncolor = [2, 2, 2]", "intensity = 1e15", "2e15, beyond 1e15", "[environment]", "intensity = 1e14"),
    ("[environment]\ncolor = [2, 2, 2]", "turn = [90]", "expected a number", "[90]", "turn = -90"),
    ("[environment]\ncolor = [1, 1, 1]", "intensty = 2", "unknown key `intensty`", "intensty", "intensity = 2"),
    ("[environment]\ncolor = [1, 1, 1]", "[background]", "both a [background] and an [environment]", "[environment]", ""),
    ("[fog]", "density = 0", "greater than 0", "0", "density = 0.1"),
    ("[fog]", "", "lacks `density`", "[fog]", "density = 0.1"),
    ("[fog]\ndensity = 0.1", "albedo = [0, 1.1, 0]", "between 0 and 1", "1.1", "albedo = [0, 1, 0]"),
    ("[[sphere]]\nradius = 1", "velocity = [1, 2]", "takes 3 values", "[1, 2]", "velocity = [1, 2, 3]"),
    ("[[sphere]]\nradius = 1\ntranslate = [9e14, 0, 0]", "velocity = [-3e14, 0, 0]", "the shape reaches 1.05", "[[sphere]]", "velocity = [-1e14, 0, 0]"),
    ("[[mesh]]\nbuiltin = \"box\"\ntranslate = [9e14, 0, 0]", "velocity = [3e14, 0, 0]", "the shape reaches 1.05", "[[mesh]]", "velocity = [1e14, 0, 0]"),
];

#[test]
fn every_key_has_its_rule() {
    each_breaks_alone(KEYS);
}

#[test]
fn the_camera_and_ambient_light_have_their_rules() {
    let file = |camera: &str, ambient: &str| {
        format!(
            "[[sphere]]\nradius = 1\n[ambient]\ncolor = [1, 1, 1]\n{ambient}\n\
             [camera]\ntarget = [0, 0, 0]\n{camera}\n"
        )
    };
    let eye = "eye = [0, 0, 5]\n";
    let good = file(
        &format!("{eye}aperture = 0.1\nfocus = 3\nvelocity = [1, 0, 0]"),
        "occlusion = 2",
    );
    #[rustfmt::skip]
    let bad = [
        ("eye = [0, 0, 5]\naperture = -1", "", "must not be negative", "-1"),
        ("eye = [0, 0, 5]\naperture = 1\nfocus = 0", "", "greater than 0", "0"),
        ("eye = [0, 0, 5]\nvelocity = 3", "", "expected an array of 3", "3"),
        ("eye = [0, 0, 9e14]\nvelocity = [0, 0, 3e14]", "", "the camera reaches 1.05", "[camera]"),
        ("eye = [0, 0, 9e14]\naperture = 3e14", "", "the camera reaches 1.05", "[camera]"),
        ("eye = [0, 0, 5]\napertur = 1", "", "unknown key `apertur`", "apertur"),
        ("eye = [0, 0, 5]", "occlusion = 0", "greater than 0", "0"),
        ("eye = [0, 0, 5]", "oclusion = 1", "unknown key `oclusion`", "oclusion"),
    ];
    for (camera, ambient, message, at) in bad {
        breaks(&file(camera, ambient), message, at, &good);
    }
}
