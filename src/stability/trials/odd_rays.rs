//! Rays that lead nowhere: of NaN, of infinity, without a direction.

use std::time::Instant;

use crate::accuracy::Widths;
use crate::error::Result;
use crate::kernel::camera::Ray;
use crate::layout::NO_HIT;
use crate::stability::case::Trial;
use crate::stability::subject::Subject;
use crate::stability::tally::{Tally, must};

/// Rays through a scene that must meet nothing.
pub struct MeetNothing {
    /// The scene.
    pub widths: Widths,
    /// The rays.
    pub rays: Vec<Ray<f32>>,
}

impl Trial for MeetNothing {
    fn run(&self, on: &dyn Subject) -> Result<Tally> {
        let mut tally = Tally::default();
        for found in on.trace_rays(&self.widths, &self.rays)? {
            tally.count([must(found.id == NO_HIT)]);
        }
        Ok(tally)
    }
}

/// How long rays may take in parts of the time of ordinary ones.
const SLOWER: f64 = 2.5;

/// How often each list is traced; the quickest counts, for a machine has other things to do.
const TIMES: usize = 5;

/// As many odd rays as ordinary ones, and their times.
pub struct InTime {
    /// The scene.
    pub widths: Widths,
    /// Rays of a picture.
    pub ordinary: Vec<Ray<f32>>,
    /// Others.
    pub odd: Vec<Ray<f32>>,
}

impl Trial for InTime {
    fn run(&self, on: &dyn Subject) -> Result<Tally> {
        let mut least = [f64::INFINITY; 2];
        for _ in 0..TIMES {
            for (least, rays) in least.iter_mut().zip([&self.ordinary, &self.odd]) {
                let started = Instant::now();
                on.trace_rays(&self.widths, rays)?;
                *least = least.min(started.elapsed().as_secs_f64());
            }
        }
        let [ordinary, odd] = least;
        let ratio = odd / ordinary;
        let rays = self.odd.len() as u64;
        Ok(Tally {
            rays,
            wrong: if ratio > SLOWER { rays } else { 0 },
            worst: ratio,
            bound: SLOWER,
        })
    }
}
