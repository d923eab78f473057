//! Host structs and bindings against naga's reflection of the shaders.

use rayproof::effects::{DIVIDE_NATIVE, Device, Entry, Fetch, select_files};
use rayproof::gpu::program::{Access, Binding, Program, StructLayout, struct_layout};
use rayproof::kernel::aabb::HUGE;
use rayproof::kernel::cone::{CONE_SLACK, WIDE};
use rayproof::kernel::doubt::{ERROR, WIDE_INTERVAL};
use rayproof::kernel::hit::GIVEN_UP;
use rayproof::kernel::lamps::{LEAST_ANGLE, PER_PI, WHOLE_TURN};
use rayproof::kernel::offset::{FIXED_OFFSET, OFFSET};
use rayproof::kernel::own_box::{PADDING, SLACK};
use rayproof::kernel::path::{LARGEST, MIRRORED, REFRACTED, TO, TOWARDS};
use rayproof::kernel::plane_bounded::PLANE_ERROR;
use rayproof::kernel::plane_textbook::PARALLEL;
use rayproof::kernel::screen::WORD;
use rayproof::kernel::sky::{CELL_DENSITY, COLUMNS, ROWS, SKY_PER_PI};
use rayproof::kernel::sphere_bounded::{NEAR_ERROR, RADIUS_ERROR, SQUARE_ERROR};
use rayproof::kernel::spheres::NEAR_REACH;
use rayproof::kernel::tree::{MOST_VISITS, STACK};
use rayproof::kernel::triangle_bounded::TRIANGLE_ERROR;
use rayproof::kernel::triangle_textbook::EDGE_ON;
use rayproof::layout::*;
use rayproof::tier::{Formulas, Width};

const NATIVE: Device = Device {
    divide: DIVIDE_NATIVE,
    fetch: Fetch::Storage,
    count: false,
    formulas: Formulas::Stable,
    width: Width::Single,
    entry: Entry::Tile,
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
        mismatch::<BallRecord<f32>>(&lists),
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
        17
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

/// The bindings of the modules with all effects: the pixels of a tile, the rays of a
/// list and their paths, by formulas that bound their error; and those in doubt, in f64. A buffer is bound by
/// its name and at the number that naga reports, so this table is the only place that
/// repeats the numbers.
#[test]
fn bindings_are_these() {
    const NUMBERS: [(&str, u32); 15] = [
        ("dispatch", 0),
        ("camera", 1),
        ("surroundings", 2),
        ("tables", 3),
        ("hits", 4),
        ("pixels", 5),
        ("cursors", 6),
        ("masks", 8),
        ("split", 9),
        ("doubtful", 10),
        ("bounds", 11),
        ("rays", 12),
        ("found", 13),
        ("aims", 14),
        ("ends", 15),
    ];
    let access = |name: &str| match name {
        "dispatch" | "camera" | "surroundings" | "tables" | "split" => Access::Uniform,
        "rays" | "aims" => Access::Read,
        _ => Access::Write,
    };
    let frame = ["dispatch", "camera", "surroundings", "tables"];
    let screen = ["masks", "split"];
    let list = ["rays", "found", "doubtful"];
    let mut of_tile = frame.to_vec();
    of_tile.extend(["hits", "pixels", "cursors", "doubtful", "bounds"]);
    of_tile.extend(screen);
    let mut of_doubtful = frame.to_vec();
    of_doubtful.extend(["pixels", "doubtful"]);
    of_doubtful.extend(screen);
    // No colours are asked for.
    let mut of_list = vec!["dispatch", "camera", "tables"];
    of_list.extend(list);
    of_list.extend(screen);
    let mut of_paths = of_list.clone();
    of_paths.extend(["aims", "ends"]);
    let (bounded, stable) = (Formulas::Bounded, Formulas::Stable);
    let (single, double) = (Width::Single, Width::Double);
    for (entry, formulas, width, names) in [
        (Entry::Tile, bounded, single, &of_tile),
        (Entry::DoubtfulPixels, stable, double, &of_doubtful),
        (Entry::Rays, bounded, single, &of_list),
        (Entry::DoubtfulRays, stable, double, &of_list),
        (Entry::Paths, bounded, single, &of_paths),
        (Entry::DoubtfulPaths, stable, double, &of_paths),
    ] {
        for (fetch, scene) in [
            (Fetch::Storage, Access::Read),
            (Fetch::Texture, Access::Texture),
            (Fetch::Uniform, Access::Uniform),
        ] {
            let device = Device {
                fetch,
                formulas,
                width,
                entry,
                ..NATIVE
            };
            let program = Program::build(&select_files(|_| true, device)).unwrap();
            let binding = |name: &str, group, binding, access| Binding {
                name: name.to_string(),
                group,
                binding,
                access,
            };
            let mut expected: Vec<Binding> = NUMBERS
                .iter()
                .filter(|(name, _)| names.contains(name))
                .map(|&(name, number)| binding(name, 0, number, access(name)))
                .collect();
            expected.push(binding("scene", 1, 0, scene));
            assert_eq!(program.bindings, expected, "{entry:?}");
            // SwiftShader binds no more.
            let storage = program
                .bindings
                .iter()
                .filter(|binding| binding.access != Access::Uniform)
                .count();
            assert!(storage <= 10);
        }
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
    let aabb = include_str!("../shaders/aabb.wgsl");
    let cone = include_str!("../shaders/cone.wgsl");
    let doubt = include_str!("../shaders/doubt_on.wgsl");
    let near = include_str!("../shaders/spheres_on.wgsl");
    let offset = include_str!("../shaders/offset.wgsl");
    let offset_textbook = include_str!("../shaders/offset_textbook.wgsl");
    let own_box = include_str!("../shaders/own_box.wgsl");
    let path = include_str!("../shaders/path.wgsl");
    let plane_bounded = include_str!("../shaders/plane_bounded.wgsl");
    let plane_textbook = include_str!("../shaders/plane_textbook.wgsl");
    let sphere_bounded = include_str!("../shaders/sphere_bounded.wgsl");
    let triangle_bounded = include_str!("../shaders/triangle_bounded.wgsl");
    let triangle_textbook = include_str!("../shaders/triangle_textbook.wgsl");
    for (shader, name, value) in [
        (aabb, "HUGE", HUGE),
        (cone, "WIDE", WIDE),
        (cone, "CONE_SLACK", CONE_SLACK),
        (doubt, "ERROR", ERROR),
        (doubt, "WIDE_INTERVAL", WIDE_INTERVAL),
        (near, "NEAR_REACH", NEAR_REACH),
        (offset, "OFFSET", OFFSET),
        (offset_textbook, "FIXED_OFFSET", FIXED_OFFSET),
        (path, "MIRRORED", MIRRORED),
        (path, "TOWARDS", TOWARDS),
        (path, "TO", TO),
        (path, "REFRACTED", REFRACTED),
        (path, "LARGEST", LARGEST),
        (own_box, "PADDING", PADDING),
        (own_box, "SLACK", SLACK),
        (plane_bounded, "PLANE_ERROR", PLANE_ERROR),
        (plane_textbook, "PARALLEL", PARALLEL),
        (sphere_bounded, "SQUARE_ERROR", SQUARE_ERROR),
        (sphere_bounded, "RADIUS_ERROR", RADIUS_ERROR),
        (sphere_bounded, "NEAR_ERROR", NEAR_ERROR),
        (triangle_bounded, "TRIANGLE_ERROR", TRIANGLE_ERROR),
        (triangle_textbook, "EDGE_ON", EDGE_ON),
    ] {
        let of_shader = number(shader, name);
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

/// Lamps that have a size, and environments: only samples of a picture read them.
#[test]
fn lights_of_paths_lie_as_the_shaders_read_them() {
    let device = Device {
        entry: Entry::Samples,
        ..NATIVE
    };
    let program = Program::build(&select_files(|_| true, device)).unwrap();
    assert_eq!(mismatch::<LampRecord>(&program), None);
    assert_eq!(mismatch::<LampTable>(&program), None);
    assert_eq!(mismatch::<SamplingRecord>(&program), None);
    assert_eq!(mismatch::<Tally>(&program), None);
    assert_eq!(mismatch::<LensRecord>(&program), None);
    assert_eq!(mismatch::<MotionRecord>(&program), None);
    assert_eq!(mismatch::<FogRecord>(&program), None);
    assert_eq!(mismatch::<TextureRecord>(&program), None);
    assert_eq!(mismatch::<Environment>(&program), None);
    let lamps = include_str!("../shaders/lamps_on.wgsl");
    let sky = include_str!("../shaders/sky_on.wgsl");
    for (shader, name, value) in [
        (lamps, "SPHERE_LAMP", SPHERE_LAMP),
        (lamps, "DISK_LAMP", DISK_LAMP),
        (lamps, "NO_LAMP", NONE),
        (sky, "COLUMNS", COLUMNS),
        (sky, "ROWS", ROWS),
    ] {
        assert_eq!(constant(shader, name), Some(value), "{name}");
    }
    for (shader, name, value) in [
        (lamps, "WHOLE_TURN", WHOLE_TURN),
        (lamps, "PER_PI", PER_PI),
        (lamps, "LEAST_ANGLE", LEAST_ANGLE),
        (sky, "CELL_DENSITY", CELL_DENSITY),
        (sky, "SKY_PER_PI", SKY_PER_PI),
    ] {
        assert_eq!(number(shader, name), Some(value), "{name}");
    }
    let cells = f64::from(COLUMNS * ROWS) / (4.0 * std::f64::consts::PI);
    assert_eq!(CELL_DENSITY, cells as f32);
}
