//! THE table: what a scene calls for, and which shader files that brings in.
//!
//! What a scene does not call for is not in its shader: not branched over but
//! absent, its bindings too. Nothing else in the program asks whether an effect
//! is on.

use serde::Serialize;

use crate::flat::Counts;
use crate::gpu::program::Source;
use crate::tier::{Formulas, Width};

/// A part of the shader that only some scenes need.
pub struct Effect {
    /// The name for people.
    pub name: &'static str,
    /// Whether the scene calls for it.
    called_for: fn(&Counts) -> bool,
    /// The shader files with it.
    on: &'static [Source],
    /// The shader files without it: the same functions, doing nothing.
    off: &'static [Source],
}

impl Effect {
    /// The shader files with the effect, or without it.
    pub fn files(&self, on: bool) -> &'static [Source] {
        if on { self.on } else { self.off }
    }
}

macro_rules! file {
    ($name:literal) => {
        Source::new($name, include_str!(concat!("../shaders/", $name)))
    };
}

/// Files that every scene needs.
const ALWAYS: &[Source] = &[
    file!("layout.wgsl"),
    file!("scene.wgsl"),
    file!("vector.wgsl"),
    file!("vector.wgsl").in_f32(),
    file!("camera.wgsl"),
    file!("aabb.wgsl"),
    file!("own_box.wgsl"),
    file!("offset.wgsl"),
    file!("probe.wgsl"),
    file!("hit.wgsl"),
    file!("doubt_off.wgsl"),
    file!("background.wgsl"),
    file!("lambert.wgsl"),
    file!("trace.wgsl"),
];

/// In place of which files a textbook's are taken.
const TEXTBOOK: &[(&str, Source)] = &[
    ("own_box.wgsl", file!("own_box_textbook.wgsl")),
    ("offset.wgsl", file!("offset_textbook.wgsl")),
    ("sphere.wgsl", file!("sphere_textbook.wgsl")),
    ("plane.wgsl", file!("plane_textbook.wgsl")),
    ("triangle.wgsl", file!("triangle_textbook.wgsl")),
];

/// In place of which files those are taken that bound their error.
const BOUNDED: &[(&str, Source)] = &[
    ("doubt_off.wgsl", file!("doubt_on.wgsl")),
    ("sphere_meeting.wgsl", file!("sphere_bounded.wgsl")),
    ("plane_meeting.wgsl", file!("plane_bounded.wgsl")),
    ("disk_meeting.wgsl", file!("disk_bounded.wgsl")),
    ("triangle_meeting.wgsl", file!("triangle_bounded.wgsl")),
];

/// The file with these formulas.
fn by_formulas(file: Source, formulas: Formulas) -> Source {
    let others = match formulas {
        Formulas::Textbook => TEXTBOOK,
        Formulas::Stable => &[],
        Formulas::Bounded => BOUNDED,
    };
    let other = others.iter().find(|(name, _)| *name == file.name);
    other.map_or(file, |(_, other)| *other)
}

/// Division and square root as the device has them.
pub const DIVIDE_NATIVE: Source = file!("divide_native.wgsl");

/// Division and square root, corrected on a device that rounds them loosely.
pub const DIVIDE_CORRECTED: Source = file!("divide_corrected.wgsl");

/// How the shader reads the scene: from where a device reads it best.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Serialize)]
#[serde(rename_all = "lowercase")]
pub enum Fetch {
    /// A storage buffer.
    Storage,
    /// A texture of four 32-bit numbers a texel.
    Texture,
    /// A uniform buffer, for small scenes.
    Uniform,
}

impl Fetch {
    /// Every way.
    pub const ALL: [Self; 3] = [Self::Storage, Self::Texture, Self::Uniform];

    /// Its name.
    pub fn name(self) -> &'static str {
        match self {
            Self::Storage => "storage buffer",
            Self::Texture => "texture",
            Self::Uniform => "uniform buffer",
        }
    }

    /// Its shader file.
    pub(crate) fn file(self) -> Source {
        match self {
            Self::Storage => file!("fetch_storage.wgsl"),
            Self::Texture => file!("fetch_texture.wgsl"),
            Self::Uniform => file!("fetch_uniform.wgsl"),
        }
    }
}

/// What a shader goes through.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Entry {
    /// The pixels of a tile.
    Tile,
    /// Those of them whose rays are in doubt.
    DoubtfulPixels,
    /// The rays of a list.
    Rays,
    /// Those of them that are in doubt.
    DoubtfulRays,
    /// The paths of the rays of a list.
    Paths,
    /// Those of them that are in doubt.
    DoubtfulPaths,
}

impl Entry {
    /// What is gone through, and what is done with it.
    fn files(self) -> [&'static [Source]; 2] {
        match self {
            Self::Tile => [&[], const { &[file!("tile.wgsl")] }],
            Self::DoubtfulPixels => [
                &[],
                const { &[file!("retrace.wgsl"), file!("retrace_pixels.wgsl")] },
            ],
            Self::Rays => [SINGLE_RAYS, LIST],
            Self::DoubtfulRays => [SINGLE_RAYS, DOUBTFUL_LIST],
            Self::Paths => [PATHS, LIST],
            Self::DoubtfulPaths => [PATHS, DOUBTFUL_LIST],
        }
    }
}

/// Rays of a list that end where they meet something.
const SINGLE_RAYS: &[Source] = &[file!("rays.wgsl"), file!("single_rays.wgsl")];

/// Rays of a list that go on there.
const PATHS: &[Source] = &[
    file!("rays.wgsl"),
    file!("followed_rays.wgsl"),
    file!("path.wgsl"),
    file!("mirror.wgsl"),
    file!("refract.wgsl"),
];

/// All rays of a list.
const LIST: &[Source] = &[file!("trace_rays.wgsl")];

/// Those of them that are in doubt.
const DOUBTFUL_LIST: &[Source] = &[file!("retrace.wgsl"), file!("retrace_rays.wgsl")];

/// The number type of the geometry.
fn real_file(width: Width) -> Source {
    match width {
        Width::Single => file!("real_f32.wgsl"),
        Width::Extended => file!("real_two.wgsl"),
        Width::Double => file!("real_f64.wgsl"),
    }
}

/// What a device brings to every shader, and what is asked of it.
#[derive(Debug, Clone, Copy)]
pub struct Device {
    /// Whether volumes are counted.
    pub count: bool,
    /// Which formulas.
    pub formulas: Formulas,
    /// In which numbers.
    pub width: Width,
    /// What is gone through.
    pub entry: Entry,
    /// Division and square root.
    pub divide: Source,
    /// Where the scene lies.
    pub fetch: Fetch,
}

/// Every effect.
pub const EFFECTS: &[Effect] = &[
    Effect {
        name: "spheres",
        called_for: |counts| counts.spheres > 0,
        on: &[
            file!("sphere.wgsl"),
            file!("sphere_meeting.wgsl"),
            file!("spheres_on.wgsl"),
        ],
        off: &[file!("spheres_off.wgsl")],
    },
    Effect {
        name: "near spheres",
        called_for: |counts| counts.near_spheres > 0,
        on: &[file!("near_spheres_on.wgsl")],
        off: &[file!("near_spheres_off.wgsl")],
    },
    Effect {
        name: "planes",
        called_for: |counts| counts.planes > 0,
        on: &[
            file!("plane.wgsl"),
            file!("plane_meeting.wgsl"),
            file!("planes_on.wgsl"),
        ],
        off: &[file!("planes_off.wgsl")],
    },
    Effect {
        name: "disks",
        called_for: |counts| counts.disks > 0,
        on: &[
            file!("plane.wgsl"),
            file!("plane_meeting.wgsl"),
            file!("disk.wgsl"),
            file!("disk_meeting.wgsl"),
            file!("disks_on.wgsl"),
        ],
        off: &[file!("disks_off.wgsl")],
    },
    Effect {
        name: "triangles",
        called_for: |counts| counts.triangles > 0,
        on: &[
            file!("triangle.wgsl"),
            file!("triangle_meeting.wgsl"),
            file!("triangles_on.wgsl"),
        ],
        off: &[file!("triangles_off.wgsl")],
    },
    Effect {
        name: "tree",
        called_for: |counts| counts.pairs > 0,
        on: &[file!("tree_on.wgsl")],
        off: &[file!("tree_off.wgsl")],
    },
    Effect {
        name: "volumes",
        called_for: |counts| counts.volumes > 0,
        on: &[file!("volumes_on.wgsl")],
        off: &[file!("volumes_off.wgsl")],
    },
    Effect {
        name: "bounding balls",
        called_for: |counts| counts.balls > 0,
        on: &[file!("ball.wgsl"), file!("balls_on.wgsl")],
        off: &[file!("balls_off.wgsl")],
    },
    Effect {
        name: "bounding boxes",
        called_for: |counts| counts.boxes > 0,
        on: &[file!("boxes_on.wgsl")],
        off: &[file!("boxes_off.wgsl")],
    },
    Effect {
        name: "screen",
        called_for: |counts| counts.tile_words > 0,
        on: &[file!("cone.wgsl"), file!("screen_on.wgsl")],
        off: &[file!("screen_off.wgsl")],
    },
    Effect {
        name: "smooth normals",
        called_for: |counts| counts.vertex_normals > 0,
        on: &[file!("smooth_normals_on.wgsl")],
        off: &[file!("smooth_normals_off.wgsl")],
    },
    Effect {
        name: "point lights",
        called_for: |counts| counts.point_lights > 0,
        on: &[file!("point_lights_on.wgsl")],
        off: &[file!("point_lights_off.wgsl")],
    },
    Effect {
        name: "directional lights",
        called_for: |counts| counts.directional_lights > 0,
        on: &[file!("directional_lights_on.wgsl")],
        off: &[file!("directional_lights_off.wgsl")],
    },
];

/// The names of the effects that the scene calls for.
pub fn effects_of(counts: &Counts) -> Vec<&'static str> {
    EFFECTS
        .iter()
        .filter(|effect| (effect.called_for)(counts))
        .map(|effect| effect.name)
        .collect()
}

/// The shader files for a scene on a device, each once.
pub fn shader_files(counts: &Counts, device: Device) -> Vec<Source> {
    select_files(|effect| (effect.called_for)(counts), device)
}

/// The shader files with exactly the effects that `chosen` accepts.
pub fn select_files(chosen: impl Fn(&Effect) -> bool, device: Device) -> Vec<Source> {
    let divide = match device.width {
        Width::Single => device.divide,
        // Wider numbers are divided as the device does it, or by way of f32.
        Width::Extended | Width::Double => DIVIDE_NATIVE,
    };
    let mut files = vec![real_file(device.width)];
    files.extend(
        ALWAYS
            .iter()
            .map(|file| by_formulas(*file, device.formulas)),
    );
    if device.width == Width::Extended {
        files.push(file!("two_float.wgsl"));
    }
    files.extend([divide, device.divide.in_f32()]);
    files.push(device.fetch.file());
    files.extend(device.entry.files().into_iter().flatten());
    files.push(if device.count {
        file!("count_on.wgsl")
    } else {
        file!("count_off.wgsl")
    });
    for effect in EFFECTS {
        for file in effect.files(chosen(effect)) {
            let file = by_formulas(*file, device.formulas);
            if !files.iter().any(|present| present.name == file.name) {
                files.push(file);
            }
        }
    }
    files
}
