//! What accuracy costs and what it buys: every tier's time, and its errors against the
//! exact answer.
//!
//! [`Widths`] holds a scene in the numbers of every tier and traces pictures, lists of
//! rays and paths in each; [`Truths`] has the exact answers; [`Errors`] is what lies between;
//! [`hazard`] makes a scene harder, step by step.

pub mod errors;
pub mod hazard;
mod lengths;
mod paths;
pub mod truth;
pub mod widths;

pub use errors::{BAND, Errors};
pub use hazard::Hazard;
pub use truth::Truths;
pub use widths::{Tracer, Widths};
