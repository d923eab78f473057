//! Formulas that are broken on purpose, each in one way, so that a case is seen to fail.

use rayproof::accuracy::Widths;
use rayproof::error::Result;
use rayproof::flat::Flat;
use rayproof::found::Found;
use rayproof::kernel::camera::Ray;
use rayproof::layout::Pixel;
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

/// The program itself in the textbook tier, on the CPU.
pub struct AsInTextbooks;

impl AsInTextbooks {
    const STATION: Station<'static> = Station {
        backend: &Backend::Cpu(None),
        tier: Accuracy::Textbook,
    };
}

impl Subject for AsInTextbooks {
    fn tier(&self) -> Accuracy {
        Self::STATION.tier
    }

    fn trace_rays(&self, widths: &Widths, rays: &[Ray<f32>]) -> Result<Vec<Found>> {
        Self::STATION.trace_rays(widths, rays)
    }

    fn trace_picture(&self, widths: &Widths) -> Result<Vec<Pixel>> {
        Self::STATION.trace_picture(widths)
    }
}
