//! What some of the cases look like: the wrong pixels of a tier.

use glam::{DMat3, DVec3};

use super::demand::band_of;
use super::shapes::{disk, flat_of, mesh, scene_of, sphere};
use super::subject::{Station, Subject};
use crate::accuracy::errors::verdict;
use crate::accuracy::truth::rounded_rays;
use crate::accuracy::{Truths, Widths};
use crate::bounds::Bounds;
use crate::error::Result;
use crate::found::Found;
use crate::frame::{Layer, Verdict, wrong_colors};
use crate::kernel::camera::Ray;
use crate::layout::NO_HIT;
use crate::oracle::Truth;
use crate::paths::Aim;
use crate::random::Numbers;
use crate::render::{Accuracy, Backend};
use crate::scene::{Light, Mesh, Scene, Transfer};
use crate::watch::Watch;

/// A scene in which a case can be seen.
pub struct View {
    /// The case.
    pub id: &'static str,
    /// What is to be seen, for people.
    pub caption: &'static str,
    /// The scene, as large as the picture.
    pub scene: fn() -> Scene,
    /// Whether shadows are to be seen, of the scene's directional light, in place of shapes.
    pub has_shadows: bool,
}

/// Pixels of a picture's side.
const SIDE: u32 = 192;

/// The cases that can be seen.
pub const VIEWS: &[View] = &[
    View {
        id: "sphere/far-1e4",
        caption: "a unit sphere 10,000 away",
        scene: far_sphere,
        has_shadows: false,
    },
    View {
        id: "sphere/horizon",
        caption: "the horizon of a planet, from 2 above its ground",
        scene: horizon,
        has_shadows: false,
    },
    View {
        id: "triangle/shared-edges",
        caption: "a crumpled sheet, with rays along its edges",
        scene: crumpled_sheet,
        has_shadows: false,
    },
    View {
        id: "shading/acne",
        caption: "the shadow of a ball of radius 100,000",
        scene: || ball_on_floor(1e5),
        has_shadows: true,
    },
    View {
        id: "shading/contact",
        caption: "the shadow of a ball of radius 0.0003",
        scene: || ball_on_floor(3e-4),
        has_shadows: true,
    },
];

/// The view of a case, if it has one.
pub fn view_of(id: &str) -> Option<&'static View> {
    VIEWS.iter().find(|view| view.id == id)
}

/// Black pixels between two pictures.
const GAP: usize = 4;

impl View {
    /// The pictures of several subjects' errors, from left to right: the exact picture in grey,
    /// wrong pixels in colour. Where two shapes meet, either is right; shadows are held to those
    /// in f64. Three bytes a pixel; width and height.
    ///
    /// # Errors
    ///
    /// Those of the subjects, and [`crate::Error::Interrupted`] when `watch` says so.
    pub fn side_by_side(
        &self,
        subjects: &[Station<'_>],
        watch: &dyn Watch,
    ) -> Result<(Vec<u8>, [u32; 2])> {
        let scenery = Scenery::of(self, watch)?;
        let [width, height] = scenery.widths.double.size;
        let mut rows: Vec<Vec<u8>> = vec![Vec::new(); height as usize];
        for subject in subjects {
            let pixels = wrong_colors(&scenery.base, &scenery.verdicts(subject)?);
            for (row, pixels) in rows.iter_mut().zip(pixels.chunks(3 * width as usize)) {
                if !row.is_empty() {
                    row.extend([0; 3 * GAP]);
                }
                row.extend(pixels);
            }
        }
        let size = [(rows[0].len() / 3) as u32, height];
        Ok((rows.concat(), size))
    }
}

/// A view with the exact answers.
struct Scenery {
    widths: Widths,
    rays: Vec<Ray<f32>>,
    truths: Truths,
    /// The exact picture, three bytes a pixel.
    base: Vec<u8>,
    /// Where shadows are to be seen, whether each pixel is dark.
    dark: Option<Vec<bool>>,
}

impl Scenery {
    fn of(view: &View, watch: &dyn Watch) -> Result<Self> {
        let flat = flat_of(&(view.scene)());
        let rays = rounded_rays(&flat);
        let exact: Vec<Ray<f64>> = rays.iter().map(|ray| ray.converted()).collect();
        let widths = Widths::of(flat, Bounds::Tree);
        let truths = Truths::of(&widths.double, &exact, watch)?;
        let base = truths.frame(&widths.double, &exact)?;
        let mut base = base.to_rgb8(Layer::Color, Transfer::Srgb);
        let double = Station {
            backend: &Backend::Cpu(None),
            tier: Accuracy::Double,
        };
        let dark = view.has_shadows.then(|| shadows(&double, &widths, &rays));
        let dark = dark.transpose()?;
        for (pixel, is_dark) in base.chunks_mut(3).zip(dark.iter().flatten()) {
            if *is_dark {
                pixel.iter_mut().for_each(|channel| *channel /= 2);
            }
        }
        Ok(Self {
            widths,
            rays,
            truths,
            base,
            dark,
        })
    }

    /// What a subject gets wrong, pixel by pixel.
    fn verdicts(&self, on: &dyn Subject) -> Result<Vec<Verdict>> {
        if let Some(dark) = &self.dark {
            let found = shadows(on, &self.widths, &self.rays)?;
            let pairs = found.iter().zip(dark);
            let verdict = |pair| match pair {
                (false, true) => Verdict::FalseMiss,
                (true, false) => Verdict::FalseHit,
                _ => Verdict::Right,
            };
            return Ok(pairs
                .map(|(found, dark)| verdict((*found, *dark)))
                .collect());
        }
        let found = on.trace_rays(&self.widths, &self.rays)?;
        let pairs = found.iter().zip(&self.truths.0);
        let verdict_of = |(found, truth): (&Found, &Truth)| match verdict(found.id, truth.id) {
            Verdict::WrongShape if truth.margin <= band_of(on.tier()) => Verdict::Right,
            verdict => verdict,
        };
        Ok(pairs.map(verdict_of).collect())
    }
}

/// Of each ray, whether something keeps the directional light off what it meets.
fn shadows(on: &dyn Subject, widths: &Widths, rays: &[Ray<f32>]) -> Result<Vec<bool>> {
    let light = widths.double.lights[0].vector;
    let aims = vec![Aim::Towards(light.into()); rays.len()];
    let paths = on.follow_paths(widths, rays, &aims, 2)?;
    Ok(paths
        .found
        .chunks(2)
        .map(|legs| legs[1].id != NO_HIT)
        .collect())
}

/// A scene in the light of a lamp behind the camera.
fn lit(mut scene: Scene) -> Scene {
    scene.ambient = [0.2; 3];
    scene.lights.push(Light::Directional {
        direction: DVec3::new(-1.0, 2.0, 3.0),
        color: [1.0; 3],
        shadow: false,
    });
    scene.with_size(SIDE, SIDE)
}

/// A little below the horizon, a ground that is round by a metre in some kilometres.
fn horizon() -> Scene {
    let radius = 6_371_000.0;
    let mut scene = lit(scene_of([sphere(-DVec3::Y * (radius + 2.0), radius)]));
    let dip = (2.0 * 2.0 / radius).sqrt();
    scene.camera.target = DVec3::new(0.0, -dip, -1.0);
    scene.camera.fov_degrees = (0.2 * dip).to_degrees();
    scene
}

/// A ball on a floor, in light from the side.
fn ball_on_floor(radius: f64) -> Scene {
    let floor = disk(-DVec3::Y * radius, DVec3::Y, 4.0 * radius);
    let mut scene = lit(scene_of([floor, sphere(DVec3::ZERO, radius)]));
    scene.camera.eye = DVec3::new(0.0, 2.0, 6.0) * radius;
    scene.camera.target = DVec3::new(0.3, -0.5, 0.0) * radius;
    scene.camera.fov_degrees = 40.0;
    scene
}

fn far_sphere() -> Scene {
    let mut scene = lit(scene_of([sphere(DVec3::ZERO, 1.0)]));
    scene.camera.eye = DVec3::new(0.36, 0.48, 0.8) * 1e4;
    scene.camera.target = DVec3::ZERO;
    scene.camera.fov_degrees = 2.0 * (1.1f64 / 1e4).atan().to_degrees();
    scene
}

/// A sheet whose vertices lie on rays of pixels, every twelfth in both directions, and so do
/// points of its edges. It is larger than the picture.
fn crumpled_sheet() -> Scene {
    let scene = lit(scene_of([]));
    let rays = rounded_rays(&flat_of(&scene));
    let ray = |x: u32, y: u32| {
        let ray: Ray<f64> = rays[(y * SIDE + x) as usize].converted();
        DVec3::from_array(ray.direction.into())
    };
    // Off the picture there are no rays to lie on.
    let (step, side) = (12, i64::from(SIDE));
    let [right, down] = [ray(1, 0), ray(0, 1)].map(|next| next - ray(0, 0));
    let along = |x: i64, y: i64| match (u32::try_from(x), u32::try_from(y)) {
        (Ok(x), Ok(y)) if x < SIDE && y < SIDE => ray(x, y),
        _ => ray(0, 0) + right * x as f64 + down * y as f64,
    };
    let places: Vec<i64> = (-step / 2..side + step).step_by(step as usize).collect();
    let mut n = Numbers(1);
    let mut sheet = Mesh::default();
    for &y in &places {
        for &x in &places {
            sheet.positions.push(along(x, y) * n.between(3.0, 3.6));
        }
    }
    let across = places.len() as u32;
    for row in 1..across {
        for column in 1..across {
            let corner = row * across + column;
            let [a, b, c, d] = [corner - across - 1, corner - across, corner - 1, corner];
            sheet.triangles.extend([[a, c, b], [b, c, d]]);
        }
    }
    lit(scene_of([mesh(sheet, DMat3::IDENTITY, DVec3::ZERO)]))
}
