//! Means of samples and how far they may be off, and what a place finds of light.

use glam::DVec3;
use rayproof::flat::Flat;
use rayproof::kernel::blockers::is_shadowed;
use rayproof::kernel::camera::Ray;
use rayproof::kernel::hit::Surface;
use rayproof::kernel::integrator::{Path, path_from_camera};
use rayproof::kernel::numbers::numbers_of;
use rayproof::kernel::sources::{Arriving, arriving_from, cosine_at_surface};
use rayproof::kernel::vector::{Vec3, taxicab_length, vec3};

/// Standard errors by which a mean may be off: once in two million means it is more.
pub const ERRORS: f64 = 5.0;

/// A mean and its standard error.
#[derive(Debug, Clone, Copy)]
pub struct Mean {
    pub value: f64,
    pub error: f64,
}

impl Mean {
    /// Of samples that know nothing of each other.
    pub fn of(samples: impl Iterator<Item = f64>) -> Self {
        let (mut count, mut value, mut squares) = (0.0, 0.0, 0.0);
        for sample in samples {
            count += 1.0;
            let off = sample - value;
            value += off / count;
            squares += off * (sample - value);
        }
        let error = (squares / (count * (count - 1.0))).sqrt();
        Self { value, error }
    }

    /// The sum of two that know nothing of each other.
    pub fn plus(self, other: Self) -> Self {
        Self {
            value: self.value + other.value,
            error: self.error.hypot(other.error),
        }
    }

    /// Whether it may be an estimate of `exact`, computed in f32 with so many roundings.
    pub fn fits(self, exact: f64, roundings: f64) -> bool {
        let rounded = roundings * exact.abs() / f64::from(1 << 24);
        (self.value - exact).abs() <= ERRORS * self.error + rounded
    }
}

/// A vector in f32.
pub fn single(v: DVec3) -> Vec3<f32> {
    let [x, y, z] = v.as_vec3().to_array();
    vec3(x, y, z)
}

/// A path at its beginning, each `number` with random numbers of its own.
pub fn path(flat: &Flat<f32>, number: u32) -> Path<f32> {
    let ray = Ray {
        origin: Vec3::default(),
        direction: vec3(0.0, 0.0, -1.0),
    };
    path_from_camera(flat, ray, numbers_of(7, number, 0, 0))
}

/// A surface at a place.
pub fn surface(place: DVec3, normal: DVec3) -> Surface {
    let position = single(place);
    let normal = single(normal.normalize());
    Surface {
        position,
        normal,
        facing: normal,
        reach: 2.0 * taxicab_length(position),
    }
}

/// What comes from the first source by `number`, and by what cosine.
pub fn arriving(flat: &Flat<f32>, surface: &Surface, number: u32) -> (Arriving, f64) {
    let arriving = arriving_from(flat, 0, &path(flat, number), surface);
    let cosine = cosine_at_surface(surface, &arriving).max(0.0);
    (arriving, cosine.into())
}

/// The irradiance of a surface over pi, in red: what it would look like if it were white.
pub fn seen(flat: &Flat<f32>, surface: &Surface, samples: u32) -> Mean {
    Mean::of((0..samples).map(|number| {
        let (arriving, cosine) = arriving(flat, surface, number);
        f64::from(arriving.color.x / arriving.square) * cosine
    }))
}

/// Whether something keeps off what comes.
pub fn shadowed(flat: &Flat<f32>, surface: &Surface, arriving: &Arriving) -> bool {
    let mut tracer = flat;
    is_shadowed(flat, &mut tracer, &mut path(flat, 0), surface, arriving)
}
