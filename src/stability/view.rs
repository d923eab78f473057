//! What some of the cases look like: the wrong pixels of a tier.

use glam::DVec3;

use super::demand::band_of;
use super::shapes::{flat_of, mesh, scene_of, sphere};
use super::subject::{Station, Subject};
use crate::accuracy::errors::verdict;
use crate::accuracy::truth::rounded_rays;
use crate::accuracy::{Truths, Widths};
use crate::bounds::Bounds;
use crate::error::Result;
use crate::frame::{Layer, Verdict, wrong_colors};
use crate::kernel::camera::Ray;
use crate::random::Numbers;
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
}

/// Pixels of a picture's side.
const SIDE: u32 = 192;

/// The cases that can be seen.
pub const VIEWS: &[View] = &[
    View {
        id: "sphere/far-1e4",
        caption: "a unit sphere 10,000 away",
        scene: far_sphere,
    },
    View {
        id: "triangle/shared-vertices",
        caption: "a crumpled sheet whose edges are aimed at",
        scene: crumpled_sheet,
    },
];

/// The view of a case, if it has one.
pub fn view_of(id: &str) -> Option<&'static View> {
    VIEWS.iter().find(|view| view.id == id)
}

/// Black pixels between two pictures.
const GAP: usize = 4;

impl View {
    /// The pictures of several subjects, from left to right.
    ///
    /// # Errors
    ///
    /// As [`View::picture`].
    pub fn side_by_side(
        &self,
        subjects: &[Station<'_>],
        watch: &dyn Watch,
    ) -> Result<(Vec<u8>, [u32; 2])> {
        let mut rows: Vec<Vec<u8>> = Vec::new();
        for subject in subjects {
            let (pixels, [width, height]) = self.picture(subject, watch)?;
            rows.resize(height as usize, Vec::new());
            for (row, pixels) in rows.iter_mut().zip(pixels.chunks(3 * width as usize)) {
                if !row.is_empty() {
                    row.extend([0; 3 * GAP]);
                }
                row.extend(pixels);
            }
        }
        let width = rows.first().map_or(0, |row| row.len() / 3);
        let size = [width as u32, rows.len() as u32];
        Ok((rows.concat(), size))
    }

    /// The picture of a subject's errors: the exact picture in grey, wrong pixels in colour.
    /// Where two shapes meet, either is right. Three bytes a pixel; width and height.
    ///
    /// # Errors
    ///
    /// Those of the subject, and [`crate::Error::Interrupted`] when `watch` says so.
    pub fn picture(&self, on: &dyn Subject, watch: &dyn Watch) -> Result<(Vec<u8>, [u32; 2])> {
        let flat = flat_of(&(self.scene)());
        let rays = rounded_rays(&flat);
        let exact: Vec<Ray<f64>> = rays.iter().map(|ray| ray.converted()).collect();
        let widths = Widths::of(flat, Bounds::Tree);
        let truths = Truths::of(&widths.double, &exact, watch)?;
        let found = on.trace_rays(&widths, &rays)?;
        let base = truths.frame(&widths.double, &exact)?;
        let verdicts: Vec<_> = found
            .iter()
            .zip(&truths.0)
            .map(|(found, truth)| match verdict(found.id, truth.id) {
                Verdict::WrongShape if truth.margin <= band_of(on.tier()) => Verdict::Right,
                verdict => verdict,
            })
            .collect();
        let base = base.to_rgb8(Layer::Color, Transfer::Srgb);
        Ok((wrong_colors(&base, &verdicts), widths.double.size))
    }
}

/// A scene in the light of a lamp behind the camera.
fn lit(mut scene: Scene) -> Scene {
    scene.ambient = [0.2; 3];
    scene.lights.push(Light::Directional {
        direction: DVec3::new(-1.0, 2.0, 3.0),
        color: [1.0; 3],
    });
    scene.with_size(SIDE, SIDE)
}

fn far_sphere() -> Scene {
    let mut scene = lit(scene_of([sphere(DVec3::ZERO, 1.0)]));
    scene.camera.eye = DVec3::new(0.36, 0.48, 0.8) * 1e4;
    scene.camera.target = DVec3::ZERO;
    scene.camera.fov_degrees = 2.0 * (1.1f64 / 1e4).atan().to_degrees();
    scene
}

/// A sheet whose vertices lie on rays of pixels, every twelfth in both directions, and so do
/// points of its edges.
fn crumpled_sheet() -> Scene {
    let scene = lit(scene_of([]));
    let rays = rounded_rays(&flat_of(&scene));
    let step = 12;
    let across = SIDE / step;
    let mut n = Numbers(1);
    let mut sheet = Mesh::default();
    for row in 0..across {
        for column in 0..across {
            let pixel = (row * step + step / 2) * SIDE + column * step + step / 2;
            let ray: Ray<f64> = rays[pixel as usize].converted();
            let depth = n.between(3.0, 3.6);
            sheet
                .positions
                .push(DVec3::from_array(ray.direction.into()) * depth);
        }
    }
    for row in 1..across {
        for column in 1..across {
            let corner = row * across + column;
            let [a, b, c, d] = [corner - across - 1, corner - across, corner - 1, corner];
            sheet.triangles.extend([[a, c, b], [b, c, d]]);
        }
    }
    let sheet = mesh(sheet, glam::DMat3::IDENTITY, DVec3::ZERO);
    let mut scene = lit(scene_of([sheet]));
    scene.background.from = [0.0; 3];
    scene
}
