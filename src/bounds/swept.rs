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

#[cfg(test)]
mod tests {
    use glam::DVec3;

    use super::*;
    use crate::bounds::box_of_row;
    use crate::flatten::flatten;
    use crate::kernel::own_box::{ball_box, triangle_box};
    use crate::kernel::two_float::TwoFloat;
    use crate::scene::{Geometry, Scene, Shape, Transform};

    /// A fixed sequence of numbers from -1 to 1.
    fn numbers() -> impl FnMut() -> f64 {
        let mut state = 1_u64;
        move || {
            state = state
                .wrapping_mul(6_364_136_223_846_793_005)
                .wrapping_add(1_442_695_040_888_963_407);
            (state >> 33) as f64 / f64::from(1_u32 << 30) - 1.0
        }
    }

    /// A sphere, a disk and a triangle of each of many sizes, at places and on ways of other
    /// sizes.
    fn scene(next: &mut impl FnMut() -> f64) -> Scene {
        let mut scene = Scene::default();
        for _ in 0..100 {
            let size = |next: &mut dyn FnMut() -> f64| 10_f64.powf(3.0 * next());
            let vector = |next: &mut dyn FnMut() -> f64| DVec3::new(next(), next(), next());
            let radius = size(next);
            let center = vector(next) * size(next);
            let normal = vector(next).normalize();
            let velocity = vector(next) * size(next);
            let vertices = [0; 3].map(|_| center + vector(next) * radius);
            for geometry in [
                Geometry::Sphere { center, radius },
                Geometry::Disk {
                    center,
                    normal,
                    radius,
                },
                Geometry::Triangle { vertices },
            ] {
                scene.shapes.push(Shape {
                    geometry,
                    transform: Transform::default(),
                    material: 0,
                    velocity,
                });
            }
        }
        scene
    }

    fn own_box<R: Real>(flat: &Flat<R>, kind: Kind, row: usize, time: f32) -> Aabb {
        let place = |v: [R; 3]| Vec3::from(v).to_f32();
        let number = row as u32;
        match kind {
            Kind::Sphere => {
                let sphere = sphere_at(flat, number, time);
                ball_box::<R>(place(sphere.center), sphere.radius.to_f32())
            }
            Kind::Disk => {
                let disk = disk_at(flat, number, time);
                ball_box::<R>(place(disk.center), disk.radius.to_f32())
            }
            Kind::Triangle => {
                let triangle = triangle_at(flat, flat.triangles[row], time);
                triangle_box::<R>(place(triangle.a), place(triangle.b), place(triangle.c))
            }
        }
    }

    fn holds(outer: Aabb, inner: Aabb) -> bool {
        let [low, high] = [inner.low - outer.low, outer.high - inner.high];
        [low.x, low.y, low.z, high.x, high.y, high.z]
            .iter()
            .all(|room| *room >= 0.0)
    }

    /// Own boxes at random times, and at the ends, that stick out of `outer`.
    fn outside<R: Real>(scene: &Scene, outer: impl Fn(&Flat<R>, Kind, usize) -> Aabb) -> usize {
        let flat = flatten::<R>(scene);
        let mut next = numbers();
        let mut outside = 0;
        for kind in [Kind::Sphere, Kind::Disk, Kind::Triangle] {
            for row in 0..100 {
                let outer = outer(&flat, kind, row);
                let last = 0.5 - 1.0 / 16_777_216.0;
                let random = [0; 20].map(|_| (next() / 2.0) as f32);
                let times = [-0.5, -0.5_f32.next_up(), 0.0, last].into_iter();
                outside += times
                    .chain(random)
                    .filter(|&time| !holds(outer, own_box(&flat, kind, row, time)))
                    .count();
            }
        }
        outside
    }

    fn check<R: Real>() {
        let scene = scene(&mut numbers());
        let swept = |flat: &Flat<R>, kind, row| box_of_row(flat, kind, row);
        assert_eq!(outside::<R>(&scene, swept), 0);
        // The controls: the box in the middle of the time, and at one of the ends.
        for time in [0.0, 0.5] {
            let still = |flat: &Flat<R>, kind, row| own_box(flat, kind, row, time);
            assert!(outside::<R>(&scene, still) > 1000);
        }
    }

    #[test]
    fn own_boxes_are_held_at_every_time() {
        check::<f32>();
        check::<TwoFloat>();
        check::<f64>();
    }
}
