//! Reports to look at: what was measured, as a drawing.

mod axis;
mod labels;
pub mod plot;

pub use plot::{Curve, Plot, Point, mark_dominated};
