//! Rays that go on from where they hit: they do not meet the surface again, and start next to
//! it.

use glam::DVec3;

use super::case::Trial;
use super::subject::Subject;
use super::tally::Tally;
use crate::accuracy::Widths;
use crate::error::Result;
use crate::flat::Flat;
use crate::kernel::camera::Ray;
use crate::kernel::offset::leave_surface;
use crate::kernel::real::Real;
use crate::kernel::vector::{Vec3, dot_product, taxicab_length};
use crate::kernel::{sphere, sphere_textbook};
use crate::layout::NO_HIT;
use crate::tier::{Accuracy, Formulas};

/// Rays at the one sphere of a scene, and where each goes on: to the side of the normal, so
/// each is turned round if it has to.
pub struct Leaving {
    /// The scene.
    pub widths: Widths,
    /// At the sphere.
    pub rays: Vec<Ray<f32>>,
    /// From there.
    pub onward: Vec<DVec3>,
    /// How far from the surface a ray may start, in radii.
    pub gap: f64,
}

impl Trial for Leaving {
    fn run(&self, on: &dyn Subject) -> Result<Tally> {
        let found = on.trace_rays(&self.widths, &self.rays)?;
        let hits = found.iter().zip(&self.rays).zip(&self.onward);
        let rays: Vec<Ray<f32>> = hits
            .filter(|((found, _), _)| found.id != NO_HIT)
            .map(|((found, ray), onward)| self.start(on.tier(), *ray, found.t, *onward))
            .collect();
        let sphere = &self.widths.double.spheres[0];
        let mut tally = Tally::default();
        for (ray, again) in rays.iter().zip(on.trace_rays(&self.widths, &rays)?) {
            let origin = DVec3::from(<[f64; 3]>::from(ray.converted::<f64>().origin));
            let height = origin.distance(DVec3::from(sphere.center)) - sphere.radius;
            tally.count([
                (f64::from(u8::from(again.id != NO_HIT)), 0.0),
                (height.abs() / sphere.radius, self.gap),
            ]);
        }
        Ok(tally)
    }
}

impl Leaving {
    fn start(&self, tier: Accuracy, ray: Ray<f32>, t: f64, onward: DVec3) -> Ray<f32> {
        let widths = &self.widths;
        match tier {
            Accuracy::Textbook => start_in(&widths.textbook, ray, t, onward),
            Accuracy::Robust | Accuracy::Adaptive => start_in(&widths.robust, ray, t, onward),
            Accuracy::Extended => start_in(&widths.extended, ray, t, onward),
            Accuracy::Double => start_in(&widths.double, ray, t, onward),
        }
    }
}

/// The ray that goes on, in the formulas of a tier.
fn start_in<R: Real>(flat: &Flat<R>, ray: Ray<f32>, t: f64, onward: DVec3) -> Ray<f32> {
    let (ray, t) = (ray.converted::<R>(), R::from_f64(t));
    let of = &flat.spheres[0];
    let (normal, point) = if R::FORMULAS == Formulas::Textbook {
        let normal = sphere_textbook::sphere_normal(ray, of, t);
        let point = sphere_textbook::sphere_point(ray, of, normal, t);
        (normal, point)
    } else {
        let normal = sphere::sphere_normal(ray, of, t);
        (normal, sphere::sphere_point(ray, of, normal, t))
    };
    let direction = Vec3::from(onward.to_array().map(R::from_f64));
    let direction = if dot_product(direction, normal) < R::ZERO {
        -direction
    } else {
        direction
    };
    let reach = taxicab_length(Vec3::from(of.center)) + of.radius;
    let origin = leave_surface(point, normal, direction, reach);
    Ray { origin, direction }.converted()
}
