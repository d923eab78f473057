//! Bounding volumes: rays that miss a volume skip what is in it.
//!
//! [`tree`] builds a bounding volume hierarchy over all primitives but the
//! planes, and `validate` proves a built tree; `arrange` puts the primitives into
//! its order; [`pairs`] packs it for the shaders.

mod arrange;
pub mod pairs;
pub mod tree;
mod validate;

pub use validate::validate;

use serde::Serialize;

use self::arrange::arrange;
use self::pairs::pack_pairs;
use self::tree::Tree;
use crate::flat::Flat;
use crate::kernel::aabb::{Aabb, ball_box, triangle_box};
use crate::kernel::real::Real;
use crate::kernel::triangles::triangle_of;
use crate::kernel::vector::Vec3;

/// The volumes in use. They never change the picture.
#[derive(Debug, Clone, Copy, Default, PartialEq, Eq, Serialize)]
#[serde(rename_all = "lowercase")]
pub enum Bounds {
    /// Brute force: the reference.
    None,
    /// A bounding volume hierarchy.
    #[default]
    Tree,
}

impl Bounds {
    /// Its name on the command line and in JSON.
    pub fn name(self) -> &'static str {
        match self {
            Bounds::None => "none",
            Bounds::Tree => "tree",
        }
    }
}

/// Builds the volumes of a flattened scene.
pub fn bound<R: Real>(flat: &mut Flat<R>, bounds: Bounds) {
    flat.tree = match bounds {
        Bounds::None => Tree::default(),
        Bounds::Tree => tree::build(primitive_boxes(flat), &|id| flat.kind_of(id).0),
    };
    let rows = arrange(flat);
    flat.pairs = pack_pairs(&flat.tree, |first| {
        let (kind, _) = flat.kind_of(flat.tree.ids[first as usize]);
        (kind, rows[first as usize])
    });
}

/// The box of each primitive but the planes, which have none, with its id: the
/// same boxes that the shape tests clamp their hits to.
pub fn primitive_boxes<R: Real>(flat: &Flat<R>) -> Vec<(Aabb, u32)> {
    let ball = |center: [R; 3], radius: R| ball_box(Vec3::from(center).to_f32(), radius.to_f32());
    let spheres = flat
        .spheres
        .iter()
        .map(|sphere| ball(sphere.center, sphere.radius))
        .zip(flat.sphere_ids.iter().copied());
    let disks = flat
        .disks
        .iter()
        .map(|disk| ball(disk.center, disk.radius))
        .zip(flat.disk_ids.iter().copied());
    let triangles = flat.triangles.iter().map(|&corners| {
        let triangle = triangle_of(flat, corners);
        let own = triangle_box(
            Vec3::from(triangle.a).to_f32(),
            Vec3::from(triangle.b).to_f32(),
            Vec3::from(triangle.c).to_f32(),
        );
        (own, corners.id)
    });
    spheres.chain(disks).chain(triangles).collect()
}
