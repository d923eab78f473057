//! Formulas that are broken on purpose, each in one way, so that a case is seen to fail.

use rayproof::accuracy::Widths;
use rayproof::accuracy::truth::exact_rays;
use rayproof::bounds::tree::Tree;
use rayproof::error::Result;
use rayproof::flat::Flat;
use rayproof::found::Found;
use rayproof::gpu::selfcheck::Arithmetic;
use rayproof::kernel::aabb::Aabb;
use rayproof::kernel::camera::Ray;
use rayproof::kernel::vector::{Vec3, vector_length};
use rayproof::layout::Pixel;
use rayproof::paths::{Aim, Paths};
use rayproof::scene::Scene;
use rayproof::stability::{Station, Subject};
use rayproof::{Accuracy, Backend};

/// What finds a ray's closest hit wrongly.
pub type Formula = fn(&Flat<f64>, Ray<f64>) -> Found;

/// How a picture is wrong.
pub type Picture = fn(&Widths) -> Result<Vec<Pixel>>;

/// How a unit direction goes on through a surface with a normal, by a ratio of indices.
pub type Refraction = fn(Vec3<f32>, Vec3<f32>, f32) -> Vec3<f32>;

/// What tree grows over some boxes.
pub type Growth = fn(Vec<(Aabb, u32)>) -> Tree;

/// The program, but for what is given: judged as f32, since it must fail by more than rounding.
#[derive(Default)]
pub struct Broken {
    pub formula: Option<Formula>,
    pub picture: Option<Picture>,
    pub refraction: Option<Refraction>,
    pub arithmetic: Option<Arithmetic>,
    pub grow: Option<Growth>,
    /// No scene is refused.
    pub believes_all: bool,
}

/// The program, but for how it finds closest hits.
pub fn by(formula: Formula) -> Broken {
    Broken {
        formula: Some(formula),
        ..Broken::default()
    }
}

/// The program, but for the scenes that it should refuse.
pub fn believing_all() -> Broken {
    Broken {
        believes_all: true,
        ..Broken::default()
    }
}

impl Subject for Broken {
    fn tier(&self) -> Accuracy {
        AS_IT_IS.tier()
    }

    fn trace_rays(&self, widths: &Widths, rays: &[Ray<f32>]) -> Result<Vec<Found>> {
        let Some(formula) = self.formula else {
            return AS_IT_IS.trace_rays(widths, rays);
        };
        let find = |ray: &Ray<f32>| formula(&widths.double, ray.converted());
        Ok(rays.iter().map(find).collect())
    }

    fn validate(&self, scene: &Scene) -> Result<()> {
        if self.believes_all {
            return Ok(());
        }
        scene.validate()
    }

    fn picture(&self, widths: &Widths) -> Result<Vec<Pixel>> {
        let formula = match (self.picture, self.formula) {
            (Some(picture), _) => return picture(widths),
            (None, None) => return AS_IT_IS.picture(widths),
            (None, Some(formula)) => formula,
        };
        let pixel = |ray| {
            let found = formula(&widths.double, ray);
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
        let mut paths = AS_IT_IS.follow_paths(widths, rays, aims, legs)?;
        let Some(refraction) = self.refraction else {
            return Ok(paths);
        };
        let normal = Vec3::from(widths.double.disks[0].normal.map(|c| c as f32));
        for ((ray, aim), end) in rays.iter().zip(aims).zip(&mut paths.ends) {
            if let Aim::Refracted { ratio } = aim {
                let unit = ray.direction * (1.0 / vector_length(ray.direction));
                end.direction = refraction(unit, normal, *ratio);
            }
        }
        Ok(paths)
    }

    fn arithmetic(&self) -> Arithmetic {
        self.arithmetic.clone().unwrap_or(AS_IT_IS.arithmetic())
    }

    fn grow(&self, items: Vec<(Aabb, u32)>) -> Tree {
        match self.grow {
            Some(grow) => grow(items),
            None => AS_IT_IS.grow(items),
        }
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
