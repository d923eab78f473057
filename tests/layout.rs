//! Host structs and bindings against naga's reflection of the shaders.

use rayproof::effects::{DIVIDE_CORRECTED, DIVIDE_NATIVE, Device, EFFECTS, Fetch, select_files};
use rayproof::gpu::program::{Access, Binding, Program, StructLayout, struct_layout};
use rayproof::kernel::cone::{CONE_SLACK, WIDE};
use rayproof::kernel::hit::GIVEN_UP;
use rayproof::kernel::screen::WORD;
use rayproof::kernel::tree::{MOST_VISITS, STACK};
use rayproof::layout::*;

const NATIVE: Device = Device {
    divide: DIVIDE_NATIVE,
    fetch: Fetch::Storage,
    count: false,
};

fn all_effects() -> Program {
    Program::build(&select_files(|_| true, NATIVE)).unwrap()
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

/// A tree takes the place of the list of volumes.
fn all_but_the_tree() -> Program {
    Program::build(&select_files(|effect| effect.name != "tree", NATIVE)).unwrap()
}

#[test]
fn host_structs_lie_as_the_shaders_read_them() {
    let program = all_effects();
    let lists = all_but_the_tree();
    let mismatches: Vec<String> = [
        mismatch::<CameraRecord<f32>>(&program),
        mismatch::<Sphere<f32>>(&program),
        mismatch::<Plane<f32>>(&program),
        mismatch::<Disk<f32>>(&program),
        mismatch::<Triangle<f32>>(&program),
        mismatch::<Volume>(&lists),
        mismatch::<BoxRecord>(&lists),
        mismatch::<MaterialRecord>(&program),
        mismatch::<LightRecord>(&program),
        mismatch::<Surroundings>(&program),
        mismatch::<Tables>(&program),
        mismatch::<Run>(&program),
        mismatch::<ScreenLevel>(&program),
        mismatch::<Dispatch>(&program),
        mismatch::<HitRecord>(&program),
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
        16
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
    let expected = |access| {
        [
            ("dispatch", 0, 0, Access::Uniform),
            ("camera", 0, 1, Access::Uniform),
            ("surroundings", 0, 2, Access::Uniform),
            ("tables", 0, 3, Access::Uniform),
            ("hits", 0, 4, Access::Write),
            ("pixels", 0, 5, Access::Write),
            ("cursors", 0, 6, Access::Write),
            ("masks", 0, 8, Access::Write),
            ("split", 0, 9, Access::Uniform),
            ("scene", 1, 0, access),
        ]
        .map(|(name, group, binding, access)| Binding {
            name: name.to_string(),
            group,
            binding,
            access,
        })
    };
    for (fetch, access) in [
        (Fetch::Storage, Access::Read),
        (Fetch::Texture, Access::Texture),
        (Fetch::Uniform, Access::Uniform),
    ] {
        let device = Device { fetch, ..NATIVE };
        let program = Program::build(&select_files(|_| true, device)).unwrap();
        assert_eq!(program.bindings, expected(access));
        // SwiftShader binds no more.
        let storage = program
            .bindings
            .iter()
            .filter(|binding| binding.access != Access::Uniform)
            .count();
        assert!(storage <= 10);
    }
}

/// The value of a WGSL constant.
fn constant(shader: &str, name: &str) -> Option<u32> {
    let (_, value) = shader.split_once(&format!("const {name}: u32 = "))?;
    let value = value.split(['u', ';']).next()?;
    match value.strip_prefix("0x") {
        Some(hexadecimal) => u32::from_str_radix(hexadecimal, 16).ok(),
        None => value.parse().ok(),
    }
}

/// The value of a WGSL constant that is a number or a quotient of two.
fn number(shader: &str, name: &str) -> Option<f32> {
    let (_, value) = shader.split_once(&format!("const {name}: f32 = "))?;
    let (dividend, divisor) = match value.split(';').next()?.split_once(" / ") {
        Some((dividend, divisor)) => (dividend, divisor.parse().ok()?),
        None => (value.split(';').next()?, 1.0),
    };
    Some(dividend.parse::<f32>().ok()? / divisor)
}

/// What both sides must agree on and both write down.
#[test]
fn constants_are_the_hosts() {
    let tree = include_str!("../shaders/tree_on.wgsl");
    let volumes = include_str!("../shaders/volumes_on.wgsl");
    let hit = include_str!("../shaders/hit.wgsl");
    let scene = include_str!("../shaders/scene.wgsl");
    let screen = include_str!("../shaders/screen_on.wgsl");
    for (shader, name, value) in [
        (tree, "LEAF", LEAF),
        (tree, "LEAF_KIND", LEAF_KIND),
        (tree, "LEAF_COUNT", LEAF_COUNT),
        (tree, "NOWHERE", NOWHERE),
        (tree, "STACK", STACK as u32),
        (tree, "MOST_VISITS", MOST_VISITS),
        (volumes, "BOX", BOX),
        (scene, "EVERYTHING", EVERYTHING),
        (screen, "WORD", WORD),
        (volumes, "LIST_KIND", LEAF_KIND),
        (hit, "NO_HIT", NO_HIT),
        (hit, "GIVEN_UP", GIVEN_UP),
    ] {
        assert_eq!(constant(shader, name), Some(value), "{name}");
    }
    let cone = include_str!("../shaders/cone.wgsl");
    for (name, value) in [("WIDE", WIDE), ("CONE_SLACK", CONE_SLACK)] {
        let of_shader = number(cone, name);
        assert_eq!(of_shader, Some(value), "{name}");
        assert_ne!(of_shader, Some(value.next_up()), "the control: {name}");
    }
    // The controls: another value, and a name that is not there.
    assert_ne!(
        constant("const STACK: u32 = 63u;", "STACK"),
        Some(STACK as u32)
    );
    assert_eq!(constant(tree, "STAK"), None);
}

/// Every combination of effects is a valid module, and an effect that is off
/// leaves no function behind.
#[test]
fn every_combination_of_effects_compiles() {
    for choice in 0..1u32 << EFFECTS.len() {
        let on = |name: &str| {
            EFFECTS
                .iter()
                .position(|effect| effect.name == name)
                .is_some_and(|index| choice >> index & 1 == 1)
        };
        let device = Device {
            divide: if choice % 2 == 0 {
                DIVIDE_NATIVE
            } else {
                DIVIDE_CORRECTED
            },
            fetch: Fetch::ALL[choice as usize % 3],
            count: choice & 2 == 2,
        };
        let files = select_files(|effect| on(effect.name), device);
        let program = Program::build(&files).unwrap();
        let functions = &program.module.functions;
        let defines = |name: &str| {
            functions
                .iter()
                .any(|(_, f)| f.name.as_deref() == Some(name))
        };
        for (effect, function) in [
            ("spheres", "intersect_sphere"),
            ("disks", "intersect_disk"),
            ("triangles", "intersect_triangle"),
            ("tree", "children_of"),
            ("point lights", "point_irradiance"),
            ("directional lights", "directional_irradiance"),
        ] {
            assert_eq!(defines(function), on(effect), "{effect} in {choice:b}");
        }
        let lists = on("volumes") && !on("tree");
        assert_eq!(defines("closest_in_volumes"), !on("tree"), "{choice:b}");
        assert_eq!(defines("volume_at"), lists || on("screen"), "{choice:b}");
        let balls = lists && on("bounding balls");
        assert_eq!(defines("meets_ball"), balls, "{choice:b}");
        let boxes = lists && on("bounding boxes");
        assert_eq!(defines("box_at"), boxes, "{choice:b}");
        let smooth = on("triangles") && on("smooth normals");
        assert_eq!(defines("vertex_normal_at"), smooth, "{choice:b}");
        let planes = on("planes") || on("disks");
        assert_eq!(defines("intersect_plane"), planes, "{choice:b}");
    }
}

/// A defect of a shader is told with its file and line.
#[test]
fn errors_name_the_shader_file() {
    use rayproof::gpu::program::Source;
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
