//! Bounding balls.

use super::ball::meets_ball;
use super::probe::Probe;
use super::real::Real;
use crate::flat::Flat;

/// Whether the ray meets the ball in a row of the table.
pub fn meets_bounding_ball<R: Real>(flat: &Flat<R>, probe: Probe<R>, row: u32) -> bool {
    meets_ball(probe.ray, &flat.balls[row as usize])
}
