//! The boxes of shapes that move while the shutter is open: each holds the shape's own box at
//! every time.
//!
//! A place at time t is fl(c + fl(v t)), see `moved` in src/kernel/motion.rs. Both roundings are
//! monotone, so each of its coordinates lies between those as the shutter opens and closes, and
//! so do the bounds of the own box without its padding, and the magnitudes by which that is
//! padded. Only of two f32 the sum is not rounded monotonely.

use crate::flat::{Flat, Kind};
use crate::kernel::aabb::{Aabb, greatest, least};
use crate::kernel::disk_rows::disk_at;
use crate::kernel::own_box::padded_box;
use crate::kernel::real::Real;
use crate::kernel::sphere_rows::sphere_at;
use crate::kernel::triangle_rows::triangle_at;
use crate::kernel::vector::{Vec3, vec3};

/// When the shutter opens and when it closes.
pub(super) const ENDS: [f32; 2] = [-0.5, 0.5];

/// By how much more such a box is padded: as for a reach that is an eighth longer, by 4 u of
/// it. A sum of two f32 that is not rounded monotonely moves a bound by an ulp of f32, 2 u,
/// and the difference from the radius by another rounding.
const ROUNDINGS: f32 = 1.125;

/// The box of the primitive in a row of its kind's table, on all its way.
pub(super) fn swept_box<R: Real>(flat: &Flat<R>, kind: Kind, row: usize) -> Aabb {
    let number = row as u32;
    let mut radius = 0.0;
    let mut places: Vec<[R; 3]> = Vec::with_capacity(6);
    for time in ENDS {
        match kind {
            Kind::Sphere => {
                let sphere = sphere_at(flat, number, time);
                radius = sphere.radius.to_f32();
                places.push(sphere.center);
            }
            Kind::Disk => {
                let disk = disk_at(flat, number, time);
                radius = disk.radius.to_f32();
                places.push(disk.center);
            }
            Kind::Triangle => {
                let triangle = triangle_at(flat, flat.triangles[row], time);
                places.extend([triangle.a, triangle.b, triangle.c]);
            }
        }
    }
    box_around(&places, radius)
}

/// The box of all points within `radius` of some places, padded.
fn box_around<R: Real>(places: &[[R; 3]], radius: f32) -> Aabb {
    let coordinates = |axis: usize| places.iter().map(move |place| place[axis].to_f32());
    let low = Vec3::from([0, 1, 2].map(|axis| coordinates(axis).fold(f32::MAX, least)));
    let high = Vec3::from([0, 1, 2].map(|axis| coordinates(axis).fold(f32::MIN, greatest)));
    let reach_x = greatest(low.x.abs(), high.x.abs());
    let reach_y = greatest(low.y.abs(), high.y.abs());
    let reach_z = greatest(low.z.abs(), high.z.abs());
    let corner = vec3(radius, radius, radius);
    let reach = ((reach_x + reach_y) + reach_z) + radius;
    padded_box::<R>(low - corner, high + corner, reach * ROUNDINGS)
}
