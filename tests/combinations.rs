//! The modules of all effects, tiers and entries: each is valid, and holds what it should.

use naga::{Scalar, TypeInner};
use rayon::prelude::*;
use rayproof::Accuracy;
use rayproof::effects::{
    DIVIDE_CORRECTED, DIVIDE_NATIVE, Device, EFFECTS, Entry, Fetch, Part, select_files,
};
use rayproof::gpu::program::{Program, Source};
use rayproof::tier::{Formulas, Width};

const NATIVE: Device = Device {
    divide: DIVIDE_NATIVE,
    fetch: Fetch::Storage,
    count: false,
    formulas: Formulas::Stable,
    width: Width::Single,
    entry: Entry::Tile,
};

const ENTRIES: [Entry; 7] = [
    Entry::Tile,
    Entry::Samples,
    Entry::DoubtfulPixels,
    Entry::Rays,
    Entry::DoubtfulRays,
    Entry::Paths,
    Entry::DoubtfulPaths,
];

/// The entries that follow no paths of light.
const PLAIN: [Entry; 6] = [
    Entry::Tile,
    Entry::DoubtfulPixels,
    Entry::Rays,
    Entry::DoubtfulRays,
    Entry::Paths,
    Entry::DoubtfulPaths,
];

/// A device of a tier. Where the adaptive one traces again, it does so in f64.
fn of_tier(accuracy: Accuracy, entry: Entry) -> Device {
    let again = matches!(
        entry,
        Entry::DoubtfulPixels | Entry::DoubtfulRays | Entry::DoubtfulPaths
    );
    let (formulas, width) = match accuracy {
        Accuracy::Textbook => (Formulas::Textbook, Width::Single),
        Accuracy::Robust => (Formulas::Stable, Width::Single),
        Accuracy::Extended => (Formulas::Stable, Width::Extended),
        Accuracy::Double => (Formulas::Stable, Width::Double),
        Accuracy::Adaptive if again => (Formulas::Stable, Width::Double),
        Accuracy::Adaptive => (Formulas::Bounded, Width::Single),
    };
    Device {
        formulas,
        width,
        entry,
        ..NATIVE
    }
}

/// Whether the module has an f64 in any of its types.
fn has_f64(program: &Program) -> bool {
    program
        .module
        .types
        .iter()
        .any(|(_, kind)| match kind.inner {
            TypeInner::Scalar(scalar)
            | TypeInner::Vector { scalar, .. }
            | TypeInner::Matrix { scalar, .. } => scalar == Scalar::F64,
            _ => false,
        })
}

/// Each tier through each entry, with all effects and with none; and of the f64 where it
/// belongs: in `double` alone, for two f32 are written as f64 and rewritten.
#[test]
fn every_tier_and_entry_compiles() {
    for accuracy in Accuracy::ALL {
        for entry in ENTRIES {
            for all in [false, true] {
                let device = of_tier(accuracy, entry);
                let files = select_files(|_| all, device);
                let program = Program::in_width(&files, device.width).unwrap();
                let double = device.width == Width::Double;
                assert_eq!(has_f64(&program), double, "{accuracy:?} {entry:?} {all}");
                // The control: before it is rewritten, there is f64 in it.
                if device.width == Width::Extended {
                    assert!(has_f64(&Program::build(&files).unwrap()));
                }
                let stages: Vec<&str> = program.entry_points().collect();
                let expected = match entry {
                    Entry::Tile => "trace_tile",
                    Entry::Samples => "sample_tile",
                    Entry::Rays | Entry::Paths => "trace_rays",
                    _ => "retrace",
                };
                assert!(stages.contains(&expected), "{stages:?}");
            }
        }
    }
}

/// Every combination of the effects of one ray a pixel is a valid module, and an effect that is off
/// leaves no function behind. What a device brings, and what is asked of it, changes with the
/// combination.
#[test]
fn every_combination_of_effects_compiles() {
    let plain = || EFFECTS.iter().filter(|effect| effect.part != Part::Path);
    (0..1u32 << plain().count())
        .into_par_iter()
        .for_each(|choice| {
            let on = |name: &str| {
                plain()
                    .position(|effect| effect.name == name)
                    .is_some_and(|index| choice >> index & 1 == 1)
            };
            // A near sphere is a sphere.
            if on("near spheres") && !on("spheres") {
                return;
            }
            let device = Device {
                divide: if choice % 2 == 0 {
                    DIVIDE_NATIVE
                } else {
                    DIVIDE_CORRECTED
                },
                fetch: Fetch::ALL[choice as usize % 3],
                count: choice & 2 == 2,
                ..of_tier(
                    Accuracy::ALL[choice as usize % 5],
                    PLAIN[choice as usize / 5 % PLAIN.len()],
                )
            };
            let files = select_files(|effect| on(effect.name), device);
            let program = Program::in_width(&files, device.width).unwrap();
            let functions = &program.module.functions;
            let defines = |name: &str| {
                functions
                    .iter()
                    .any(|(_, f)| f.name.as_deref() == Some(name))
            };
            // Formulas that bound their error are others; a list's rays are not coloured.
            let bounded = device.formulas == Formulas::Bounded;
            let coloured = matches!(device.entry, Entry::Tile | Entry::DoubtfulPixels);
            let followed = matches!(device.entry, Entry::Paths | Entry::DoubtfulPaths);
            for (effect, function, possible) in [
                ("spheres", "meet_sphere", true),
                ("disks", "meet_disk", true),
                ("triangles", "meet_triangle", true),
                ("spheres", "intersect_sphere", !bounded),
                ("disks", "intersect_disk", !bounded),
                ("triangles", "intersect_triangle", !bounded),
                ("spheres", "sphere_normal", coloured || followed),
                ("tree", "children_of", true),
                ("point lights", "point_irradiance", coloured),
                ("directional lights", "directional_irradiance", coloured),
            ] {
                let expected = on(effect) && possible;
                assert_eq!(defines(function), expected, "{function} in {choice:b}");
            }
            let lists = on("volumes") && !on("tree");
            assert_eq!(defines("closest_in_volumes"), !on("tree"), "{choice:b}");
            assert_eq!(defines("volume_at"), lists || on("screen"), "{choice:b}");
            let balls = lists && on("bounding balls");
            assert_eq!(defines("meets_ball"), balls, "{choice:b}");
            let boxes = lists && on("bounding boxes");
            assert_eq!(defines("box_at"), boxes, "{choice:b}");
            for function in ["leave_surface", "mirrored", "refracted"] {
                assert_eq!(defines(function), followed, "{function} in {choice:b}");
            }
            let smooth = on("triangles") && on("smooth normals") && (coloured || followed);
            assert_eq!(defines("vertex_normal_at"), smooth, "{choice:b}");
            let planes = on("planes") || on("disks");
            let crossing = ["intersect_plane", "bound_crossing"].map(defines);
            assert_eq!(
                crossing,
                [planes && !bounded, planes && bounded],
                "{choice:b}"
            );
        });
}

/// A defect of a shader is told with its file and line.
#[test]
fn errors_name_the_shader_file() {
    let mut files = select_files(|_| true, NATIVE);
    files.push(Source::new(
        "broken.wgsl",
        "fn fine() {}\n\nfn broken() { return 1.0; }\n",
    ));
    let error = Program::build(&files).unwrap_err().to_string();
    assert!(error.contains("shaders/broken.wgsl:3"), "{error}");
    files.push(Source::new("worse.wgsl", "fn worse( {\n"));
    let error = Program::build(&files).unwrap_err().to_string();
    assert!(error.contains("shaders/worse.wgsl:1"), "{error}");
}
