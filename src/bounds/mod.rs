//! Bounding volumes: rays that miss a volume skip what is in it.
//!
//! [`tree`] builds a bounding volume hierarchy over all primitives but the
//! planes; `validate` proves a built tree.

pub mod tree;
mod validate;

pub use validate::validate;

use serde::Serialize;

use crate::flat::Flat;
use crate::kernel::aabb::{Aabb, ball_box, triangle_box};
use crate::kernel::real::Real;
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
    let tree = match bounds {
        Bounds::None => tree::Tree::default(),
        Bounds::Tree => tree::build(primitive_boxes(flat)),
    };
    flat.pairs = tree.pairs;
    flat.leaf_ids = tree.leaf_ids;
}

/// The box of each primitive but the planes, which have none, with its id: the
/// same boxes that the shape tests clamp their hits to.
pub fn primitive_boxes<R: Real>(flat: &Flat<R>) -> Vec<(Aabb, u32)> {
    let ball = |center: [R; 3], radius: R| ball_box(Vec3::from(center).to_f32(), radius.to_f32());
    let spheres = flat
        .spheres
        .iter()
        .map(|sphere| ball(sphere.center, sphere.radius));
    let disks = flat.disks.iter().map(|disk| ball(disk.center, disk.radius));
    let triangles = flat.triangles.iter().map(|triangle| {
        triangle_box(
            Vec3::from(triangle.a).to_f32(),
            Vec3::from(triangle.b).to_f32(),
            Vec3::from(triangle.c).to_f32(),
        )
    });
    let after_planes = flat.first_disk()..;
    spheres
        .zip(0..)
        .chain(disks.chain(triangles).zip(after_planes))
        .collect()
}
