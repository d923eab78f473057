//! The kinds of trials.
//!
//! Most are [`aimed`] rays; [`alike`] ones have two sets of rays with one answer, a
//! [`monotone`] one a shape that grows, [`journeys`] paths, [`odd_rays`] rays of no numbers.
//! [`pictures`] are taken with volumes and without, [`seen`] and [`lit`] look at their points
//! and their light, [`grown`] trees are looked through, and what a scene check says is asked
//! by [`refused`]. [`together`] makes one of several.

pub mod aimed;
pub mod alike;
pub mod grown;
pub mod journeys;
pub mod lit;
pub mod monotone;
pub mod odd_rays;
pub mod pictures;
pub mod refused;
pub mod seen;
pub mod together;
