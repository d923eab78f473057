//! `src/kernel/X.rs` and `shaders/X.wgsl` hold the same functions in the same
//! order.

use std::fs;
use std::path::Path;

use rayproof::effects::{EFFECTS, Entry};

/// Functions that only one side needs, and why.
const WITHOUT_TWIN: [(&str, &str); 17] = [
    // WGSL has the constructor built in.
    ("vector", "vec3"),
    // The CPU traces a pixel in one call, the GPU a tile in one dispatch or more.
    ("trace", "trace_pixel"),
    // In the shader the files of the tree, on or off, decide.
    ("trace", "find_hit"),
    // A ray of the CPU goes through the whole list at once, and counts where it is.
    ("volumes", "load_cursor"),
    ("volumes", "store_cursor"),
    // The CPU divides the screen on its own, see src/bounds/screen.rs.
    ("screen", "split_tiles"),
    ("count", "keep_counts"),
    // A constant in the width, where the shader converts.
    ("real", "constant"),
    // Only the shader reads a number from several f32, and writes it as several.
    ("real", "reals_of"),
    ("real", "parts_of"),
    // In the shader another file's `keep_nearer` stands in for it.
    ("doubt", "keep_interval"),
    // A ray of the CPU is taken to its end in one call, and traced again at once.
    ("doubt", "load_doubt"),
    ("doubt", "store_doubt"),
    ("doubt", "list_doubtful"),
    // The kernel's probe has a shear whatever the formulas; the textbook's shader has none.
    ("triangle_textbook", "shear_of"),
    // In the shader the files of the formulas decide.
    ("triangles", "meet_triangle"),
    // Where nothing moves; a shader's triangles are read where the time is known.
    ("triangles", "triangle_of"),
];

/// A kernel file without a shader: what finds hits is one function each in the shaders.
const ON_THE_CPU_ALONE: &str = "tracer";

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
        if stem == ON_THE_CPU_ALONE {
            continue;
        }
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
        // Which rays an invocation takes, and where it leaves what they find.
        "tile",
        "tile_order",
        "samples",
        "rays",
        "single_rays",
        "followed_rays",
        "trace_rays",
        "retrace",
        "retrace_pixels",
        "retrace_rays",
    ];
    let stems = stems();
    for entry in fs::read_dir("shaders").unwrap() {
        let path = entry.unwrap().path();
        let name = path.file_stem().unwrap().to_str().unwrap().to_string();
        let forms = FORMS.iter().find(|(form, _)| *form == name);
        let stem = match forms {
            Some((_, of)) => stem_of(of),
            None => stem_of(&name),
        };
        assert!(
            without.contains(&name.as_str()) || stems.iter().any(|known| known == stem),
            "{name}.wgsl has no twin"
        );
    }
}

/// Shader files that stand in for another one, which has the twin.
const FORMS: [(&str, &str); 6] = [
    ("doubt_off", "doubt_on"),
    ("own_box_textbook", "own_box"),
    ("offset_textbook", "offset"),
    ("divide_corrected", "divide_native"),
    ("real_f64", "real_f32"),
    ("real_two", "real_f32"),
];

/// A shader's name without the ending that tells what it is for.
fn stem_of(name: &str) -> &str {
    ["_on", "_off", "_f32", "_native"]
        .iter()
        .find_map(|ending| name.strip_suffix(ending))
        .unwrap_or(name)
}

/// A file that stands in for another one has what the rest of the shader asks of that one:
/// functions of its twin, in the order of the twin.
#[test]
fn other_forms_of_a_shader_offer_the_same() {
    let text = |name: &str| fs::read_to_string(format!("shaders/{name}.wgsl")).unwrap();
    for (form, of) in FORMS {
        let (present, expected) = (functions(&text(form)), functions(&text(of)));
        let shared: Vec<&String> = present
            .iter()
            .filter(|name| expected.contains(name))
            .collect();
        let mut rest = expected.iter();
        assert!(
            shared.iter().all(|name| rest.any(|other| other == *name)),
            "{form}: another order"
        );
        // The numbers and the division of a width have helpers besides.
        let complete = form.starts_with("real") || form.starts_with("divide");
        if complete {
            assert_eq!(shared.len(), expected.len(), "{form} lacks a function");
        } else {
            assert_eq!(shared.len(), present.len(), "{form} has one too many");
            assert!(!shared.is_empty(), "{form}");
        }
    }
}

/// No exception outlives its function.
#[test]
fn every_exception_is_needed() {
    for (stem, name) in WITHOUT_TWIN {
        let rust = fs::read_to_string(format!("src/kernel/{stem}.rs")).unwrap();
        let wgsl = fs::read_to_string(shader_of(stem).unwrap()).unwrap();
        let sides = [rust, wgsl].map(|text| functions(&text).iter().any(|other| other == name));
        assert!(
            sides[0] != sides[1],
            "{stem}: {name} is on both sides or none"
        );
    }
}

/// What an effect offers when it is off is part of what it offers when on.
#[test]
fn stubs_define_functions_of_their_effect() {
    for effect in EFFECTS {
        let defined = |on| -> Vec<String> {
            effect
                .files(on, Entry::Samples)
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
