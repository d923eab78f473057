//! Paths: rays that go on from the surfaces that they meet, and what is demanded of them.

use crate::accuracy::Widths;
use crate::error::Result;
use crate::found::Found;
use crate::kernel::camera::Ray;
use crate::paths::Aim;
use crate::stability::case::Trial;
use crate::stability::subject::Subject;
use crate::stability::tally::Tally;

/// A path that was followed: its first ray, what its legs found, and the ray after the last.
pub struct Path<'a> {
    /// The first ray.
    pub ray: Ray<f32>,
    /// What each leg found.
    pub found: &'a [Found],
    /// The ray that would be next.
    pub end: Ray<f32>,
}

/// The error of a path, and its bound.
pub type Judge = Box<dyn Fn(&Path<'_>) -> (f64, f64)>;

/// Paths through a scene.
pub struct Journeys {
    /// The scene.
    pub widths: Widths,
    /// Where each begins.
    pub rays: Vec<Ray<f32>>,
    /// Where each goes on.
    pub aims: Vec<Aim>,
    /// For how many legs.
    pub legs: u32,
    /// What is demanded.
    pub judge: Judge,
}

impl Trial for Journeys {
    fn run(&self, on: &dyn Subject) -> Result<Tally> {
        let paths = on.follow_paths(&self.widths, &self.rays, &self.aims, self.legs)?;
        let mut tally = Tally::default();
        let found = paths.found.chunks(self.legs as usize);
        for ((ray, found), end) in self.rays.iter().zip(found).zip(paths.ends) {
            let path = Path {
                ray: *ray,
                found,
                end,
            };
            tally.count([(self.judge)(&path)]);
        }
        Ok(tally)
    }
}
