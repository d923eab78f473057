//! THE table: what a scene calls for, and which shader files and buffers that brings in.

use super::{Effect, Part, cause, file, removal};

/// Every effect.
pub const EFFECTS: &[Effect] = &[
    Effect::new(
        "spheres",
        Part::Primitives,
        |counts| counts.spheres > 0,
        &[
            file!("sphere.wgsl"),
            file!("sphere_meeting.wgsl"),
            file!("sphere_rows_off.wgsl"),
            file!("spheres_on.wgsl"),
        ],
        &[file!("spheres_off.wgsl")],
    )
    .along_paths(
        &[file!("sphere_coordinates_on.wgsl"), file!("angles.wgsl")],
        &[file!("sphere_coordinates_off.wgsl")],
    )
    .caused_by(cause::spheres),
    Effect::new(
        "near spheres",
        Part::Primitives,
        |counts| counts.near_spheres > 0,
        &[file!("near_spheres_on.wgsl")],
        &[file!("near_spheres_off.wgsl")],
    )
    .caused_by(cause::near_spheres),
    Effect::new(
        "planes",
        Part::Primitives,
        |counts| counts.planes > 0,
        &[
            file!("plane.wgsl"),
            file!("plane_meeting.wgsl"),
            file!("plane_rows_off.wgsl"),
            file!("planes_on.wgsl"),
        ],
        &[file!("planes_off.wgsl")],
    )
    .caused_by(cause::planes),
    Effect::new(
        "disks",
        Part::Primitives,
        |counts| counts.disks > 0,
        &[
            file!("plane.wgsl"),
            file!("plane_meeting.wgsl"),
            file!("disk.wgsl"),
            file!("disk_meeting.wgsl"),
            file!("disk_rows_off.wgsl"),
            file!("disks_on.wgsl"),
        ],
        &[file!("disks_off.wgsl")],
    )
    .caused_by(cause::disks),
    Effect::new(
        "triangles",
        Part::Primitives,
        |counts| counts.triangles > 0,
        &[
            file!("triangle.wgsl"),
            file!("triangle_meeting.wgsl"),
            file!("triangle_rows_off.wgsl"),
            file!("triangles_on.wgsl"),
        ],
        &[file!("triangles_off.wgsl")],
    )
    .along_paths(
        &[file!("triangle_coordinates_on.wgsl")],
        &[file!("triangle_coordinates_off.wgsl")],
    )
    .caused_by(cause::triangles),
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
    )
    .caused_by(cause::smooth_normals)
    .removed_by(removal::smooth_normals),
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
    )
    .caused_by(cause::point_lights)
    .removed_by(removal::point_lights),
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
    )
    .caused_by(cause::directional_lights)
    .removed_by(removal::directional_lights),
    Effect::new(
        "hard shadows",
        Part::Path,
        |counts| counts.shadowed_lights > 0,
        &[file!("hard_shadows_on.wgsl"), file!("blockers_on.wgsl")],
        &[file!("hard_shadows_off.wgsl"), file!("blockers_off.wgsl")],
    )
    .caused_by(cause::hard_shadows)
    .removed_by(removal::hard_shadows),
    Effect::new(
        "emission",
        Part::Path,
        |counts| counts.emissions > 0 || counts.lamps > 0,
        &[file!("emission_on.wgsl")],
        &[file!("emission_off.wgsl")],
    )
    .caused_by(cause::emission)
    .removed_by(removal::emission),
    Effect::new(
        "ambient occlusion",
        Part::Path,
        |counts| counts.occlusion,
        &[file!("occlusion_on.wgsl")],
        &[file!("occlusion_off.wgsl")],
    )
    .caused_by(cause::ambient_occlusion)
    .removed_by(removal::ambient_occlusion),
    Effect::new(
        "indirect light",
        Part::Path,
        |counts| counts.bounces > 0,
        &[file!("indirect_on.wgsl")],
        &[file!("indirect_off.wgsl")],
    )
    .caused_by(cause::indirect_light)
    .removed_by(removal::indirect_light),
    Effect::new(
        "anti-aliasing",
        Part::Path,
        |counts| counts.samples > 1,
        &[file!("anti_aliasing_on.wgsl")],
        &[file!("anti_aliasing_off.wgsl")],
    )
    .caused_by(cause::anti_aliasing)
    .removed_by(removal::anti_aliasing),
    Effect::new(
        "mirrors",
        Part::Path,
        |counts| counts.mirrors > 0,
        &[
            file!("mirror.wgsl"),
            file!("fresnel.wgsl"),
            file!("mirrors_on.wgsl"),
        ],
        &[file!("mirrors_off.wgsl")],
    )
    .caused_by(cause::mirrors)
    .removed_by(removal::mirrors),
    Effect::new(
        "glossy reflection",
        Part::Path,
        |counts| counts.rough_mirrors > 0,
        &[
            file!("mirror.wgsl"),
            file!("microfacets.wgsl"),
            file!("glossy_on.wgsl"),
        ],
        &[file!("glossy_off.wgsl")],
    )
    .caused_by(cause::glossy_reflection)
    .removed_by(removal::glossy_reflection),
    Effect::new(
        "refraction",
        Part::Path,
        |counts| counts.clear_bodies > 0,
        &[
            file!("mirror.wgsl"),
            file!("refract.wgsl"),
            file!("fresnel.wgsl"),
            file!("exponential.wgsl"),
            file!("clear_bodies_on.wgsl"),
        ],
        &[file!("clear_bodies_off.wgsl")],
    )
    .caused_by(cause::refraction)
    .removed_by(removal::refraction),
    Effect::new(
        "soft shadows",
        Part::Path,
        |counts| counts.lamps > 0,
        &[file!("lamps_on.wgsl"), file!("blockers_on.wgsl")],
        &[file!("lamps_off.wgsl"), file!("blockers_off.wgsl")],
    )
    .binding(&["lamps"])
    .caused_by(cause::soft_shadows)
    .removed_by(removal::soft_shadows),
    Effect::new(
        "environment",
        Part::Path,
        |counts| counts.environments > 0,
        &[
            file!("sky_on.wgsl"),
            file!("angles.wgsl"),
            file!("blockers_on.wgsl"),
        ],
        &[file!("sky_off.wgsl"), file!("blockers_off.wgsl")],
    )
    .binding(&["environment"])
    .caused_by(cause::environment)
    .removed_by(removal::environment),
    Effect::new(
        "depth of field",
        Part::Path,
        |counts| counts.lens,
        &[file!("lens_on.wgsl")],
        &[file!("lens_off.wgsl")],
    )
    .binding(&["lens"])
    .caused_by(cause::depth_of_field)
    .removed_by(removal::depth_of_field),
    Effect::new(
        "motion blur",
        Part::Path,
        |counts| counts.moving > 0,
        &[
            file!("motion_on.wgsl"),
            file!("sphere_rows_on.wgsl"),
            file!("disk_rows_on.wgsl"),
            file!("plane_rows_on.wgsl"),
            file!("triangle_rows_on.wgsl"),
        ],
        &[file!("motion_off.wgsl")],
    )
    .binding(&["motion"])
    .caused_by(cause::motion_blur)
    .removed_by(removal::motion_blur),
    Effect::new(
        "fog",
        Part::Path,
        |counts| counts.fog,
        &[file!("fog_on.wgsl"), file!("exponential.wgsl")],
        &[file!("fog_off.wgsl")],
    )
    .binding(&["fog"])
    .caused_by(cause::fog)
    .removed_by(removal::fog),
    Effect::new(
        "textures",
        Part::Path,
        |counts| counts.textures > 0,
        &[file!("textures_on.wgsl")],
        &[file!("textures_off.wgsl")],
    )
    .caused_by(cause::textures)
    .removed_by(removal::textures),
    Effect::new(
        "alpha cut-outs",
        Part::Path,
        |counts| counts.cutouts > 0,
        &[file!("cutouts_on.wgsl"), file!("textures_on.wgsl")],
        &[file!("cutouts_off.wgsl")],
    )
    .caused_by(cause::cutouts)
    .removed_by(removal::cutouts),
];
