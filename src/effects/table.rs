//! THE table: what a scene calls for, and which shader files and buffers that brings in.

use super::{Effect, Part, file};

/// Every effect.
pub const EFFECTS: &[Effect] = &[
    Effect::new(
        "spheres",
        Part::Primitives,
        |counts| counts.spheres > 0,
        &[
            file!("sphere.wgsl"),
            file!("sphere_meeting.wgsl"),
            file!("spheres_on.wgsl"),
        ],
        &[file!("spheres_off.wgsl")],
    )
    .along_paths(
        &[file!("sphere_coordinates_on.wgsl"), file!("angles.wgsl")],
        &[file!("sphere_coordinates_off.wgsl")],
    ),
    Effect::new(
        "near spheres",
        Part::Primitives,
        |counts| counts.near_spheres > 0,
        &[file!("near_spheres_on.wgsl")],
        &[file!("near_spheres_off.wgsl")],
    ),
    Effect::new(
        "planes",
        Part::Primitives,
        |counts| counts.planes > 0,
        &[
            file!("plane.wgsl"),
            file!("plane_meeting.wgsl"),
            file!("planes_on.wgsl"),
        ],
        &[file!("planes_off.wgsl")],
    ),
    Effect::new(
        "disks",
        Part::Primitives,
        |counts| counts.disks > 0,
        &[
            file!("plane.wgsl"),
            file!("plane_meeting.wgsl"),
            file!("disk.wgsl"),
            file!("disk_meeting.wgsl"),
            file!("disks_on.wgsl"),
        ],
        &[file!("disks_off.wgsl")],
    ),
    Effect::new(
        "triangles",
        Part::Primitives,
        |counts| counts.triangles > 0,
        &[
            file!("triangle.wgsl"),
            file!("triangle_meeting.wgsl"),
            file!("triangles_on.wgsl"),
        ],
        &[file!("triangles_off.wgsl")],
    )
    .along_paths(
        &[file!("triangle_coordinates_on.wgsl")],
        &[file!("triangle_coordinates_off.wgsl")],
    ),
    Effect::new(
        "tree",
        Part::Bounds,
        |counts| counts.pairs > 0,
        &[file!("tree_on.wgsl")],
        &[file!("tree_off.wgsl")],
    ),
    Effect::new(
        "volumes",
        Part::Bounds,
        |counts| counts.volumes > 0,
        &[file!("volumes_on.wgsl")],
        &[file!("volumes_off.wgsl")],
    )
    .binding(&["cursors"]),
    Effect::new(
        "bounding balls",
        Part::Bounds,
        |counts| counts.balls > 0,
        &[file!("ball.wgsl"), file!("balls_on.wgsl")],
        &[file!("balls_off.wgsl")],
    ),
    Effect::new(
        "bounding boxes",
        Part::Bounds,
        |counts| counts.boxes > 0,
        &[file!("boxes_on.wgsl")],
        &[file!("boxes_off.wgsl")],
    ),
    Effect::new(
        "screen",
        Part::Screen,
        |counts| counts.tile_words > 0,
        &[file!("cone.wgsl"), file!("screen_on.wgsl")],
        &[file!("screen_off.wgsl")],
    )
    .binding(&["masks", "split"]),
    Effect::new(
        "smooth normals",
        Part::Light,
        |counts| counts.vertex_normals > 0,
        &[file!("smooth_normals_on.wgsl")],
        &[file!("smooth_normals_off.wgsl")],
    ),
    Effect::new(
        "point lights",
        Part::Light,
        |counts| counts.point_lights > 0,
        &[file!("point_lights_on.wgsl")],
        &[file!("point_lights_off.wgsl")],
    )
    .along_paths(
        &[file!("point_sources_on.wgsl")],
        &[file!("point_sources_off.wgsl")],
    ),
    Effect::new(
        "directional lights",
        Part::Light,
        |counts| counts.directional_lights > 0,
        &[file!("directional_lights_on.wgsl")],
        &[file!("directional_lights_off.wgsl")],
    )
    .along_paths(
        &[file!("directional_sources_on.wgsl")],
        &[file!("directional_sources_off.wgsl")],
    ),
    Effect::new(
        "hard shadows",
        Part::Path,
        |counts| counts.shadowed_lights > 0,
        &[file!("hard_shadows_on.wgsl"), file!("blockers_on.wgsl")],
        &[file!("hard_shadows_off.wgsl"), file!("blockers_off.wgsl")],
    ),
    Effect::new(
        "emission",
        Part::Path,
        |counts| counts.emissions > 0,
        &[file!("emission_on.wgsl")],
        &[file!("emission_off.wgsl")],
    ),
    Effect::new(
        "ambient occlusion",
        Part::Path,
        |counts| counts.occlusion,
        &[file!("occlusion_on.wgsl")],
        &[file!("occlusion_off.wgsl")],
    ),
    Effect::new(
        "indirect light",
        Part::Path,
        |counts| counts.bounces > 0,
        &[file!("indirect_on.wgsl")],
        &[file!("indirect_off.wgsl")],
    ),
    Effect::new(
        "anti-aliasing",
        Part::Path,
        |counts| counts.samples > 1,
        &[file!("anti_aliasing_on.wgsl")],
        &[file!("anti_aliasing_off.wgsl")],
    ),
    Effect::new(
        "fog",
        Part::Path,
        |counts| counts.fog,
        &[file!("fog_on.wgsl"), file!("exponential.wgsl")],
        &[file!("fog_off.wgsl")],
    )
    .binding(&["fog"]),
    Effect::new(
        "textures",
        Part::Path,
        |counts| counts.textures > 0,
        &[file!("textures_on.wgsl")],
        &[file!("textures_off.wgsl")],
    ),
    Effect::new(
        "cut-outs",
        Part::Path,
        |counts| counts.cutouts > 0,
        &[file!("cutouts_on.wgsl"), file!("textures_on.wgsl")],
        &[file!("cutouts_off.wgsl")],
    ),
];
