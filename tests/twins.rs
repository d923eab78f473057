//! `src/kernel/X.rs` and `shaders/X.wgsl` hold the same functions in the same
//! order.

use std::fs;
use std::path::Path;

use rayproof::effects::EFFECTS;

/// Functions that only one side needs, and why.
const WITHOUT_TWIN: [(&str, &str); 13] = [
    // WGSL has the constructor built in.
    ("vector", "vec3"),
    // The CPU traces a pixel in one call, the GPU a tile in one dispatch or more.
    ("trace", "trace_pixel"),
    // In the shader the files of the tree, on or off, decide.
    ("trace", "find_hit"),
    ("trace", "trace_tile"),
    ("trace", "shade_tile"),
    ("trace", "render_tile"),
    // Which pixel an invocation takes is no arithmetic of the picture.
    ("trace", "even_bits"),
    ("trace", "tile_pixel"),
    // A ray of the CPU goes through the whole list at once, and counts where it is.
    ("volumes", "load_cursor"),
    ("volumes", "store_cursor"),
    // The CPU divides the screen on its own, see src/bounds/screen.rs.
    ("screen", "split_tiles"),
    // A constant in the width, where the shader converts.
    ("cone", "real"),
    ("count", "keep_counts"),
];

/// The ending of functions that read a record: on the CPU, tables are arrays.
const READER: &str = "_at";

/// The functions of a file at its outermost level, in order.
fn functions(text: &str) -> Vec<String> {
    text.lines()
        .filter_map(|line| line.strip_prefix("pub fn ").or(line.strip_prefix("fn ")))
        .filter_map(|rest| rest.split(['(', '<']).next())
        .map(str::to_string)
        .collect()
}

/// The functions that should have a twin.
fn twinned(stem: &str, text: &str) -> Vec<String> {
    let mut names = functions(text);
    names.retain(|name| !WITHOUT_TWIN.contains(&(stem, name.as_str())) && !name.ends_with(READER));
    names
}

/// The shader file of a kernel file: itself, its form for a scene that calls for
/// it, for f32, or for a device that divides well.
fn shader_of(stem: &str) -> Option<String> {
    ["", "_on", "_f32", "_native"]
        .iter()
        .map(|ending| format!("shaders/{stem}{ending}.wgsl"))
        .find(|path| Path::new(path).exists())
}

fn stems() -> Vec<String> {
    let mut stems: Vec<String> = fs::read_dir("src/kernel")
        .unwrap()
        .map(|entry| {
            entry
                .unwrap()
                .path()
                .file_stem()
                .unwrap()
                .to_str()
                .unwrap()
                .to_string()
        })
        .filter(|stem| stem != "mod")
        .collect();
    stems.sort();
    stems
}

#[test]
fn every_kernel_file_has_a_twin_with_the_same_functions() {
    let mut unmatched = Vec::new();
    for stem in stems() {
        let Some(shader) = shader_of(&stem) else {
            unmatched.push(format!("src/kernel/{stem}.rs has no shader"));
            continue;
        };
        let rust = fs::read_to_string(format!("src/kernel/{stem}.rs")).unwrap();
        let wgsl = fs::read_to_string(&shader).unwrap();
        let (rust, wgsl) = (twinned(&stem, &rust), twinned(&stem, &wgsl));
        if rust != wgsl {
            unmatched.push(format!("{stem}: {rust:?} in Rust, {wgsl:?} in {shader}"));
        }
    }
    assert!(unmatched.is_empty(), "{unmatched:#?}");
}

/// A shader file that no kernel file mirrors holds no arithmetic of the picture.
#[test]
fn every_shader_has_a_twin_or_a_reason() {
    let without = [
        "layout",
        "scene",
        "fetch_storage",
        "fetch_texture",
        "fetch_uniform",
        "fetch_probe",
        "selfcheck",
        "selfcheck_f64",
    ];
    let stems = stems();
    for entry in fs::read_dir("shaders").unwrap() {
        let path = entry.unwrap().path();
        let name = path.file_stem().unwrap().to_str().unwrap().to_string();
        let stem = ["_on", "_off", "_f32", "_native", "_corrected"]
            .iter()
            .find_map(|ending| name.strip_suffix(ending))
            .unwrap_or(&name);
        assert!(
            without.contains(&name.as_str()) || stems.iter().any(|known| known == stem),
            "{name}.wgsl has no twin"
        );
    }
}

/// What an effect offers when it is off is part of what it offers when on.
#[test]
fn stubs_define_functions_of_their_effect() {
    for effect in EFFECTS {
        let defined = |on| -> Vec<String> {
            effect
                .files(on)
                .iter()
                .flat_map(|file| functions(file.text))
                .collect()
        };
        let (on, off) = (defined(true), defined(false));
        assert!(
            !off.is_empty() && off.iter().all(|name| on.contains(name)),
            "{}",
            effect.name
        );
    }
}

/// The control: a missing, a renamed and a displaced function are noticed.
#[test]
fn differences_are_noticed() {
    let rust = "pub fn one<R: Real>(a: R) {}\nfn two() {}\n    fn inner() {}\n";
    assert_eq!(functions(rust), ["one", "two"]);
    assert_eq!(
        functions("fn one(a: real) -> real {\n}\nfn two() {\n}\n"),
        functions(rust)
    );
    for wgsl in [
        "fn one() {}",
        "fn one() {}\nfn to() {}",
        "fn two() {}\nfn one() {}",
    ] {
        assert_ne!(functions(wgsl), functions(rust));
    }
}
