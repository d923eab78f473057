//! Host structs and bindings against naga's reflection of the shaders.

use rayproof::effects::{DIVIDE_CORRECTED, DIVIDE_NATIVE, EFFECTS, select_files};
use rayproof::gpu::program::{Access, Binding, Program, StructLayout, struct_layout};
use rayproof::layout::*;

fn all_effects() -> Program {
    Program::build(&select_files(|_| true, DIVIDE_NATIVE)).unwrap()
}

/// What differs between a host struct and its WGSL struct.
fn mismatch<T: Record>(program: &Program) -> Option<String> {
    let host = StructLayout {
        fields: T::fields()
            .into_iter()
            .map(|(name, at)| (name.to_string(), at))
            .collect(),
        stride: T::stride(),
    };
    let shader = struct_layout(&program.module, T::NAME);
    (shader.as_ref() != Some(&host)).then(|| format!("{}: {host:?}, {shader:?}", T::NAME))
}

#[test]
fn host_structs_lie_as_the_shaders_read_them() {
    let program = all_effects();
    let mismatches: Vec<String> = [
        mismatch::<CameraRecord<f32>>(&program),
        mismatch::<Sphere<f32>>(&program),
        mismatch::<Plane<f32>>(&program),
        mismatch::<Disk<f32>>(&program),
        mismatch::<Triangle<f32>>(&program),
        mismatch::<CornerNormals>(&program),
        mismatch::<Pair>(&program),
        mismatch::<MaterialRecord>(&program),
        mismatch::<LightRecord>(&program),
        mismatch::<Surroundings>(&program),
        mismatch::<Run>(&program),
        mismatch::<Dispatch>(&program),
        mismatch::<Pixel>(&program),
    ]
    .into_iter()
    .flatten()
    .collect();
    assert!(mismatches.is_empty(), "{mismatches:#?}");
}

/// Every struct that the shaders share with the host is in the list above.
#[test]
fn no_struct_is_left_out() {
    let text = include_str!("../shaders/layout.wgsl");
    assert_eq!(
        text.lines()
            .filter(|line| line.starts_with("struct "))
            .count(),
        13
    );
}

/// The control: a field moved by four bytes, a field renamed, a stride too small.
#[test]
fn a_wrong_layout_is_noticed() {
    struct Moved;
    impl Record for Moved {
        const NAME: &'static str = "Sphere";
        fn fields() -> Vec<(&'static str, usize)> {
            vec![("center", 0), ("radius", 16)]
        }
        fn stride() -> usize {
            16
        }
    }
    struct Renamed;
    impl Record for Renamed {
        const NAME: &'static str = "Sphere";
        fn fields() -> Vec<(&'static str, usize)> {
            vec![("center", 0), ("size", 12)]
        }
        fn stride() -> usize {
            16
        }
    }
    struct Narrow;
    impl Record for Narrow {
        const NAME: &'static str = "MaterialRecord";
        fn fields() -> Vec<(&'static str, usize)> {
            vec![("albedo", 0)]
        }
        fn stride() -> usize {
            12
        }
    }
    let program = all_effects();
    assert!(mismatch::<Moved>(&program).is_some());
    assert!(mismatch::<Renamed>(&program).is_some());
    assert!(mismatch::<Narrow>(&program).is_some());
}

/// The bindings of a module with all effects. A buffer is bound by its name and
/// at the number that naga reports, so this table is the only place that repeats
/// the numbers.
#[test]
fn bindings_are_these() {
    let expected = [
        ("dispatch", 0, 0, Access::Uniform),
        ("camera", 0, 1, Access::Uniform),
        ("pixels", 0, 2, Access::Write),
        ("surroundings", 0, 3, Access::Uniform),
        ("materials", 1, 0, Access::Read),
        ("lights", 1, 1, Access::Read),
        ("indices", 2, 0, Access::Read),
        ("spheres", 2, 1, Access::Read),
        ("planes", 2, 2, Access::Read),
        ("disks", 2, 3, Access::Read),
        ("triangles", 2, 4, Access::Read),
        ("corner_normals", 2, 5, Access::Read),
        ("pairs", 2, 6, Access::Read),
    ]
    .map(|(name, group, binding, access)| Binding {
        name: name.to_string(),
        group,
        binding,
        access,
    });
    let bindings = all_effects().bindings;
    assert_eq!(bindings, expected);
    // SwiftShader binds no more.
    let storage = bindings
        .iter()
        .filter(|binding| binding.access != Access::Uniform)
        .count();
    assert!(storage <= 10);
}

/// Every combination of effects is a valid module, and an effect that is off
/// leaves no binding behind.
#[test]
fn every_combination_of_effects_compiles() {
    let own = ["spheres", "planes", "disks", "triangles"];
    for choice in 0..1u32 << EFFECTS.len() {
        let on = |name: &str| {
            EFFECTS
                .iter()
                .position(|effect| effect.name == name)
                .is_some_and(|index| choice >> index & 1 == 1)
        };
        let divide = if choice % 2 == 0 {
            DIVIDE_NATIVE
        } else {
            DIVIDE_CORRECTED
        };
        let program = Program::build(&select_files(|effect| on(effect.name), divide)).unwrap();
        let bound = |name: &str| program.bindings.iter().any(|binding| binding.name == name);
        for name in own {
            assert_eq!(bound(name), on(name), "{name} in combination {choice:b}");
        }
        if on("tree") {
            assert!(bound("pairs"));
        }
        assert_eq!(
            bound("lights"),
            on("point lights") || on("directional lights")
        );
        assert_eq!(
            bound("corner_normals"),
            on("triangles") && on("smooth normals")
        );
    }
}

/// A defect of a shader is told with its file and line.
#[test]
fn errors_name_the_shader_file() {
    use rayproof::gpu::program::Source;
    let mut files = select_files(|_| true, DIVIDE_NATIVE);
    files.push(Source {
        name: "broken.wgsl",
        text: "fn fine() {}\n\nfn broken() { return 1.0; }\n",
    });
    let error = Program::build(&files).unwrap_err().to_string();
    assert!(error.contains("shaders/broken.wgsl:3"), "{error}");
    files.push(Source {
        name: "worse.wgsl",
        text: "fn worse( {\n",
    });
    let error = Program::build(&files).unwrap_err().to_string();
    assert!(error.contains("shaders/worse.wgsl:1"), "{error}");
}
