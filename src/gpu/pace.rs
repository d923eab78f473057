//! How much work a dispatch gets, learnt from how long the last ones took.

use std::time::Duration;

use super::tile::WORKGROUP;

/// How long a dispatch should take: long enough that starting it costs little,
/// short enough to be smooth and far from any watchdog.
pub(super) const DISPATCH_TIME: Duration = Duration::from_millis(75);

/// Shape tests a second before anything was measured: slow software.
const FIRST_GUESS: f64 = 1e7;

/// Primitives of a dispatch at least; fewer would not pay for starting it.
const FEWEST: u32 = 256;

/// The pace of a scene on a device.
#[derive(Debug)]
pub(super) struct Pace {
    /// Primitives that a dispatch may test at most.
    most: u32,
    /// Primitives that a ray tests.
    primitives: u32,
    /// Lights of the scene, which one dispatch goes through for each pixel. One
    /// counts as a shape test: a root and a division or two, as that.
    lights: u32,
    width: u32,
    /// Shape tests a second.
    rate: f64,
    tested: f64,
    total: f64,
}

impl Pace {
    pub(super) fn new([width, height]: [u32; 2], primitives: u32, lights: u32, most: u32) -> Self {
        let total = f64::from(width) * f64::from(height) * f64::from(primitives.max(1));
        Self {
            most,
            primitives,
            lights,
            width,
            rate: FIRST_GUESS,
            tested: 0.0,
            total,
        }
    }

    /// Begins another picture at the rate that is known.
    pub(super) fn start_anew(&mut self) {
        self.tested = 0.0;
    }

    /// Rows of the next tile, at most `limit`.
    pub(super) fn rows(&self, limit: u32) -> u32 {
        let steps = self.primitives.clamp(1, self.most).max(self.lights);
        let row = f64::from(self.width) * f64::from(steps);
        let rows = (self.budget() / row) as u32;
        // A tile of fewer rows than a workgroup leaves lanes idle.
        (rows / WORKGROUP * WORKGROUP).max(WORKGROUP).min(limit)
    }

    /// Primitives of the next dispatch over this many pixels.
    pub(super) fn chunk(&self, pixels: u32) -> u32 {
        let primitives = self.budget() / f64::from(pixels);
        (primitives as u32).max(FEWEST).min(self.most)
    }

    /// Takes a finished dispatch into account. The first one of a kernel may
    /// hold the driver's compiling, so the rate may only quadruple at a time.
    pub(super) fn learn(&mut self, pixels: u32, primitives: u32, took: Duration) {
        let tests = f64::from(pixels) * f64::from(primitives.max(1));
        // A clock may be too coarse for a small dispatch.
        let rate = tests / took.max(Duration::from_micros(1)).as_secs_f64();
        self.rate = rate.clamp(self.rate / 4.0, self.rate * 4.0);
        self.tested += tests;
    }

    /// The part of all tests that is done.
    pub(super) fn done(&self) -> f64 {
        (self.tested / self.total).min(1.0)
    }

    fn budget(&self) -> f64 {
        self.rate * DISPATCH_TIME.as_secs_f64()
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_dispatch_nears_its_time_and_keeps_its_bound() {
        // A device that does a thousand million tests a second.
        let mut pace = Pace::new([1000, 1000], 10_000_000, 1, 60_000);
        let mut seconds = 0.0;
        for _ in 0..20 {
            let pixels = 1000 * pace.rows(1000);
            let primitives = pace.chunk(pixels);
            assert!(primitives <= 60_000);
            seconds = f64::from(pixels) * f64::from(primitives) / 1e9;
            pace.learn(pixels, primitives, Duration::from_secs_f64(seconds));
        }
        assert!((0.04..0.11).contains(&seconds), "{seconds} s");
    }
    /// Shading is one dispatch a tile, however many the lights.
    #[test]
    fn many_lights_make_small_tiles() {
        let rows = |lights| Pace::new([1000, 1000], 1, lights, 60_000).rows(1000);
        assert!(rows(1) > 100 && rows(10_000) == WORKGROUP);
    }
}
