//! Bounding volumes: rays that miss a volume skip what is in it.
//!
//! [`tree`] builds a bounding volume hierarchy over all primitives but the
//! planes: `split` finds where a node is cut, `item` is what is cut, `validate` proves
//! a built tree, and [`pairs`] packs it for the shaders.
//! `swept` finds the boxes of shapes that move.
//! `volumes` lists the volumes of groups and meshes: `held` says how large they must
//! be, [`ball`] finds tight spheres, `overfull` what sticks out of those given by hand,
//! `nesting` knows what lies in what.
//! [`screen`] finds, for each tile of the screen, the volumes that its rays may meet.
//! `outline` draws volumes.
//! `arrange` puts the primitives into the volumes' order.

mod arrange;
pub mod ball;
mod held;
mod item;
mod nesting;
mod outline;
mod overfull;
pub mod pairs;
pub mod screen;
mod split;
mod swept;
pub mod tree;
mod validate;
mod volumes;

pub use outline::outlines;
pub use overfull::overfull_groups;
pub use validate::validate;

use serde::Serialize;

use self::arrange::arrange;
use self::pairs::pack_pairs;
use self::screen::words_of_tile;
use self::swept::swept_box;
use self::volumes::{Listing, list_volumes};
use crate::flat::{Flat, Kind};
use crate::kernel::aabb::Aabb;
use crate::kernel::own_box::{ball_box, triangle_box};
use crate::kernel::real::Real;
use crate::kernel::triangles::triangle_of;
use crate::kernel::vector::Vec3;

/// Levels of spheres, boxes and the screen at most: four to the sixteenth
/// is more than any scene has primitives.
pub const MAX_LEVELS: u32 = 16;

/// The volumes in use. They never change the picture, unless the scene itself gives a
/// group a volume that does not hold it.
#[derive(Debug, Clone, Copy, Default, PartialEq, Eq)]
pub enum Bounds {
    /// Brute force: the reference.
    None,
    /// The volumes of the scene's groups, as the scene gives them.
    Scene,
    /// A tight sphere around each group and each mesh, and in each, `levels` deep,
    /// four more around a quarter of what it holds.
    Spheres {
        /// 1 for no more than one sphere a group or mesh.
        levels: u32,
    },
    /// The same with axis-aligned boxes.
    Boxes {
        /// As of the spheres.
        levels: u32,
    },
    /// The spheres, and for each tile of the screen, found in a quad-tree over it, those
    /// that its rays may meet: the others are not even tested.
    Screen {
        /// As of the spheres.
        levels: u32,
    },
    /// A bounding volume hierarchy.
    #[default]
    Tree,
}

impl Bounds {
    /// Its name on the command line and in JSON.
    pub fn name(self) -> &'static str {
        match self {
            Bounds::None => "none",
            Bounds::Scene => "scene",
            Bounds::Spheres { .. } => "spheres",
            Bounds::Boxes { .. } => "boxes",
            Bounds::Screen { .. } => "screen",
            Bounds::Tree => "tree",
        }
    }
}

impl Serialize for Bounds {
    fn serialize<S: serde::Serializer>(&self, serializer: S) -> Result<S::Ok, S::Error> {
        serializer.serialize_str(self.name())
    }
}

/// Builds the volumes of a flattened scene, in place of those that it has.
pub fn bound<R: Real>(flat: &mut Flat<R>, bounds: Bounds) {
    flat.pairs = Vec::new();
    (flat.volumes, flat.balls, flat.boxes) = Default::default();
    (flat.tile_words, flat.tile_masks) = Default::default();
    match bounds {
        Bounds::None => {}
        Bounds::Scene => list_volumes(flat, Listing::Given),
        Bounds::Spheres { levels } => list_volumes(flat, Listing::Balls(levels)),
        Bounds::Boxes { levels } => list_volumes(flat, Listing::Boxes(levels)),
        Bounds::Screen { levels } => {
            list_volumes(flat, Listing::Balls(levels));
            flat.tile_words = words_of_tile(flat.size, flat.volumes.len() as u32);
        }
        Bounds::Tree => grow_tree(flat),
    }
}

fn grow_tree<R: Real>(flat: &mut Flat<R>) {
    let tree = tree::build(primitive_boxes(flat), &|id| flat.kind_of(id).0);
    let rows = arrange(flat, &tree.ids);
    flat.pairs = pack_pairs(&tree, |first| {
        let (kind, _) = flat.kind_of(tree.ids[first as usize]);
        (kind, rows[first as usize])
    });
}

/// The own box of the primitive in a row of its kind's table; one that holds it at every time,
/// where shapes move.
pub fn box_of_row<R: Real>(flat: &Flat<R>, kind: Kind, row: usize) -> Aabb {
    if flat.has_moving_shapes() {
        return swept_box(flat, kind, row);
    }
    let ball =
        |center: [R; 3], radius: R| ball_box::<R>(Vec3::from(center).to_f32(), radius.to_f32());
    match kind {
        Kind::Sphere => ball(flat.spheres[row].center, flat.spheres[row].radius),
        Kind::Disk => ball(flat.disks[row].center, flat.disks[row].radius),
        Kind::Triangle => {
            let triangle = triangle_of(flat, flat.triangles[row]);
            let [a, b, c] = [triangle.a, triangle.b, triangle.c].map(|v| Vec3::from(v).to_f32());
            triangle_box::<R>(a, b, c)
        }
    }
}

/// The box of each primitive but the planes, which have none, with its id: the
/// same boxes that the shape tests clamp their hits to.
pub fn primitive_boxes<R: Real>(flat: &Flat<R>) -> Vec<(Aabb, u32)> {
    let spheres = flat.sphere_ids.iter().copied().enumerate();
    let disks = flat.disk_ids.iter().copied().enumerate();
    let triangles = flat.triangles.iter().map(|corners| corners.id).enumerate();
    let with_box = |kind| move |(row, id)| (box_of_row(flat, kind, row), id);
    spheres
        .map(with_box(Kind::Sphere))
        .chain(disks.map(with_box(Kind::Disk)))
        .chain(triangles.map(with_box(Kind::Triangle)))
        .collect()
}
