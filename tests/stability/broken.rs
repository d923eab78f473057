//! Formulas that are broken on purpose, each in one way, so that a case is seen to fail.

use rayproof::accuracy::Widths;
use rayproof::accuracy::truth::exact_rays;
use rayproof::error::Result;
use rayproof::flat::Flat;
use rayproof::found::Found;
use rayproof::gpu::selfcheck::Arithmetic;
use rayproof::kernel::camera::Ray;
use rayproof::layout::Pixel;
use rayproof::paths::{Aim, Paths};
use rayproof::stability::{Station, Subject};
use rayproof::{Accuracy, Backend};

/// What finds a ray's closest hit wrongly.
pub type Formula = fn(&Flat<f64>, Ray<f64>) -> Found;

/// A subject that is wrong: judged as f32, since it must fail by more than rounding.
pub struct Broken(pub Formula);

impl Subject for Broken {
    fn tier(&self) -> Accuracy {
        Accuracy::Robust
    }

    fn trace_rays(&self, widths: &Widths, rays: &[Ray<f32>]) -> Result<Vec<Found>> {
        let find = |ray: &Ray<f32>| (self.0)(&widths.double, ray.converted());
        Ok(rays.iter().map(find).collect())
    }

    fn picture(&self, widths: &Widths) -> Result<Vec<Pixel>> {
        let pixel = |ray| {
            let found = (self.0)(&widths.double, ray);
            Pixel {
                id: found.id,
                depth: found.t as f32,
                ..Pixel::default()
            }
        };
        let rays = exact_rays(&widths.double);
        Ok(rays.into_iter().map(pixel).collect())
    }

    fn follow_paths(
        &self,
        widths: &Widths,
        rays: &[Ray<f32>],
        aims: &[Aim],
        legs: u32,
    ) -> Result<Paths> {
        AS_IT_IS.follow_paths(widths, rays, aims, legs)
    }

    fn arithmetic(&self) -> Arithmetic {
        AS_IT_IS.arithmetic()
    }
}

/// What the program finds in f64, on which a broken formula may be built.
pub fn rightly(flat: &Flat<f64>, ray: Ray<f64>) -> Found {
    use rayproof::kernel::hit::no_hit;
    use rayproof::kernel::probe::probe_of;
    use rayproof::kernel::trace::find_hit;
    let mut hit = no_hit();
    find_hit(flat, probe_of(ray), &mut hit);
    Found::at(hit).unwrap()
}

/// The CPU, which never changes.
static CPU: Backend = Backend::Cpu(None);

/// The program itself in the textbook tier, on the CPU.
pub const AS_IN_TEXTBOOKS: Station<'static> = Station {
    backend: &CPU,
    tier: Accuracy::Textbook,
};

/// The program itself in the robust tier, on the CPU: what is broken elsewhere does this right.
pub const AS_IT_IS: Station<'static> = Station {
    backend: &CPU,
    tier: Accuracy::Robust,
};
