//! What finds hits for a path of light: the kernel by itself, or by way of a tree of its own.

use super::hit::{Hit, NO_TILE, no_hit};
use super::probe::Probe;
use super::real::Real;
use super::trace::find_hit;
use crate::flat::Flat;
use crate::layout::NO_HIT;

/// What finds hits.
pub trait Tracer<R: Real> {
    /// Has the shapes stand where they are at a time, of [`super::motion::shutter_time`]; what
    /// knows no time has them where they are in its middle.
    fn open_shutter(&mut self, _time: f32) {}

    /// The nearest of all primitives.
    fn closest(&mut self, probe: Probe<R>, hit: &mut Hit<R>);

    /// Whether anything is met no later than at `limit`.
    fn any(&mut self, probe: Probe<R>, limit: R) -> bool;
}

/// The kernel by itself.
impl<R: Real> Tracer<R> for &Flat<R> {
    fn closest(&mut self, probe: Probe<R>, hit: &mut Hit<R>) {
        find_hit(self, probe, hit);
    }

    fn any(&mut self, probe: Probe<R>, limit: R) -> bool {
        let mut hit = no_hit();
        hit.t = limit;
        hit.tile = NO_TILE;
        find_hit(self, probe, &mut hit);
        hit.id != NO_HIT
    }
}
