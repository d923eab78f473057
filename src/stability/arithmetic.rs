//! Sums, products, quotients and roots, and numbers that are none: what all else rests on.

use glam::{DMat3, DVec3};

use super::aim::{a_vertex, ray_to};
use super::case::{Case, Family, Trial};
use super::demand::Demand::Own;
use super::shapes::{flat_of, mesh, scene_of, sphere};
use super::subject::Subject;
use super::tally::Tally;
use super::trials::odd_rays::{InTime, MeetNothing};
use super::trials::together::Together;
use crate::accuracy::Widths;
use crate::bounds::Bounds;
use crate::error::Result;
use crate::gpu::selfcheck::{Arithmetic, INPUTS};
use crate::kernel::camera::Ray;
use crate::random::Numbers;
use crate::scene::mesh::{Builtin, build};

/// Sums, products, quotients and roots.
pub const FAMILY: Family = Family {
    name: "arithmetic",
    about: "Sums, products, quotients and roots, as the device's self-check found them, and \
            numbers that are none.",
    cases: &[&[
        Case {
            id: "arithmetic/error-terms",
            name: "what a sum and a product lack",
            sets_up: "TwoSum and TwoProd of 8192 pairs.",
            danger: "A compiler that reckons as with real numbers makes (a + b) - a into b, and \
                     the error term into 0.",
            demands: &[Own("the error terms are exact")],
            fails: &[],
            is_random: false,
            trial: |_, _| Ok(Box::new(Device(|device| device.two_sum && device.two_prod))),
        },
        Case {
            id: "arithmetic/contraction",
            name: "products that are not fused with a sum",
            sets_up: "a b - (a b) of 8192 pairs.",
            danger: "A fused product is not rounded: u_left - u_right of an edge function has \
                     another sign for one triangle than for its neighbour.",
            demands: &[Own("0, always")],
            fails: &[],
            is_random: false,
            trial: |_, _| Ok(Box::new(Device(|device| !device.contraction))),
        },
        Case {
            id: "arithmetic/rounding",
            name: "quotients and roots next to the middle of two numbers",
            sets_up: "8192 quotients and as many roots that lie as near as can be to where rounding \
                      turns.",
            danger: "Vulkan allows a quotient to be 2.5 ulp off: pictures then differ from the \
                     CPU's.",
            demands: &[Own(
                "they are rounded correctly, by the device or by what corrects it",
            )],
            fails: &[],
            is_random: false,
            trial: |_, _| Ok(Box::new(Device(Arithmetic::is_rounded))),
        },
        Case {
            id: "arithmetic/odd-rays",
            name: "rays of NaN, of infinity, or without a direction",
            sets_up: "A mesh of 5120 triangles and a sphere, and rays at them, of which one number \
                      or more are replaced.",
            danger: "No comparison with a NaN holds: a test that asks what rules a hit out lets it \
                     through. WGSL lets a compiler take it that there are none.",
            demands: &[Own("they meet nothing")],
            fails: &[],
            is_random: true,
            trial: |n, _| {
                let widths = a_scene();
                let rays = odd_rays(&widths, n);
                Ok(Box::new(MeetNothing { widths, rays }))
            },
        },
        Case {
            id: "arithmetic/odd-rays-in-time",
            name: "the time that such rays take",
            sets_up: "The same scene and rays, and as many that are denormal or huge, beside \
                      ordinary ones. Times are the least of five.",
            danger: "A NaN passes each box, and the ray visits the whole tree.",
            demands: &[Own("at most 2.5 times as long as ordinary ones")],
            fails: &[],
            is_random: false,
            trial: |n, _| {
                let in_time = |odd: fn(&Widths, &mut Numbers) -> Vec<Ray<f32>>, n: &mut _| {
                    let widths = a_scene();
                    let odd = odd(&widths, n);
                    let ordinary = at_the_scene(&widths, odd.len(), n);
                    Box::new(InTime {
                        widths,
                        ordinary,
                        odd,
                    })
                };
                Ok(Box::new(Together(vec![
                    in_time(odd_rays, n),
                    in_time(extreme_rays, n),
                ])))
            },
        },
    ]],
};

fn a_scene() -> Widths {
    let ball = mesh(
        build(Builtin::Icosphere, 5120),
        DMat3::IDENTITY,
        -DVec3::Z * 4.0,
    );
    let scene = scene_of([ball, sphere(DVec3::new(1.0, 1.0, -4.0), 0.5)]);
    Widths::of(flat_of(&scene), Bounds::Tree)
}

/// From around the scene, at its vertices.
fn at_the_scene(widths: &Widths, count: usize, n: &mut Numbers) -> Vec<Ray<f32>> {
    let from = |n: &mut Numbers| -DVec3::Z * 4.0 + n.direction() * 3.0;
    (0..count)
        .map(|_| ray_to(from(n), a_vertex(&widths.double, n)))
        .collect()
}

/// Rays of which one number or more are replaced by one of these.
fn replaced(widths: &Widths, by: &[f32], n: &mut Numbers) -> Vec<Ray<f32>> {
    let mut rays = at_the_scene(widths, 10_000, n);
    for (index, ray) in rays.iter_mut().enumerate() {
        let mut numbers = [0.0; 6];
        numbers[..3].copy_from_slice(&<[f32; 3]>::from(ray.origin));
        numbers[3..].copy_from_slice(&<[f32; 3]>::from(ray.direction));
        let first = n.pick(6);
        for (place, number) in numbers.iter_mut().enumerate() {
            if place == first || n.pick(4) == 0 {
                *number = by[index % by.len()];
            }
        }
        let [origin, direction] = [0, 3].map(|at| [numbers[at], numbers[at + 1], numbers[at + 2]]);
        (ray.origin, ray.direction) = (origin.into(), direction.into());
    }
    rays
}

fn odd_rays(widths: &Widths, n: &mut Numbers) -> Vec<Ray<f32>> {
    let mut rays = replaced(
        widths,
        &[f32::NAN, -f32::NAN, f32::INFINITY, f32::NEG_INFINITY],
        n,
    );
    for ray in rays.iter_mut().step_by(5) {
        *ray = at_the_scene(widths, 1, n)[0];
        ray.direction = [0.0, -0.0, 0.0].into();
    }
    rays
}

fn extreme_rays(widths: &Widths, n: &mut Numbers) -> Vec<Ray<f32>> {
    replaced(widths, &[1e-39, -1e-45, 1e-30, f32::MAX, -1e30, 0.0], n)
}

/// What the self-check of a device must have found.
struct Device(fn(&Arithmetic) -> bool);

impl Trial for Device {
    fn run(&self, on: &dyn Subject) -> Result<Tally> {
        let is_wrong = !(self.0)(&on.arithmetic());
        Ok(Tally {
            rays: u64::from(INPUTS),
            wrong: u64::from(is_wrong),
            worst: f64::from(u8::from(is_wrong)),
            bound: 0.0,
        })
    }
}
