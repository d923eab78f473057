//! The exact answers for the rays of a picture.

use rayon::prelude::*;

use crate::error::{Error, Result};
use crate::flat::Flat;
use crate::frame::Frame;
use crate::kernel::camera::{Ray, camera_ray};
use crate::kernel::hit::{Hit, no_hit};
use crate::kernel::trace::shade;
use crate::layout::Pixel;
use crate::oracle::{Oracle, Truth};
use crate::watch::Watch;

/// Rays between two looks at the watch.
const PORTION: usize = 4096;

/// The exact answer for each ray.
pub struct Truths(pub Vec<Truth>);

impl Truths {
    /// Of rays through a scene, whose numbers are taken as they are.
    ///
    /// # Errors
    ///
    /// [`Error::Interrupted`] when `watch` says so.
    pub fn of(flat: &Flat<f64>, rays: &[Ray<f64>], watch: &dyn Watch) -> Result<Self> {
        let oracle = Oracle::new(flat);
        let mut truths = Vec::with_capacity(rays.len());
        for portion in rays.chunks(PORTION) {
            if watch.cancelled() {
                return Err(Error::Interrupted);
            }
            let answers = portion.par_iter().map(|ray| oracle.closest(*ray));
            truths.par_extend(answers);
            watch.progress(truths.len() as f64 / rays.len() as f64);
        }
        Ok(Self(truths))
    }

    /// The picture that the rays of a camera see at these hits, coloured in f64.
    ///
    /// # Errors
    ///
    /// As [`Frame::new`].
    pub fn frame(&self, flat: &Flat<f64>, rays: &[Ray<f64>]) -> Result<Frame> {
        let [width, height] = flat.size;
        let mut frame = Frame::new(width, height)?;
        let pixels = rays.par_iter().zip(&self.0);
        let pixels: Vec<Pixel> = pixels
            .map(|(ray, truth)| shade(flat, *ray, hit_of(truth)))
            .collect();
        let _complete = frame.keep_rows(0, &pixels);
        Ok(frame)
    }
}

fn hit_of(truth: &Truth) -> Hit<f64> {
    Hit {
        t: truth.t,
        id: truth.id,
        row: truth.row,
        ..no_hit()
    }
}

/// The rays of a picture's pixels in f64, row by row from the top left.
pub fn exact_rays(flat: &Flat<f64>) -> Vec<Ray<f64>> {
    pixels(flat.size)
        .map(|(x, y)| camera_ray(&flat.camera, flat.size, x, y))
        .collect()
}

/// The same rays as the tracers in f32 have them.
pub fn rounded_rays(flat: &Flat<f64>) -> Vec<Ray<f32>> {
    let camera = flat.camera.converted::<f32>();
    pixels(flat.size)
        .map(|(x, y)| camera_ray(&camera, flat.size, x, y))
        .collect()
}

fn pixels([width, height]: [u32; 2]) -> impl Iterator<Item = (u32, u32)> {
    (0..height).flat_map(move |y| (0..width).map(move |x| (x, y)))
}
