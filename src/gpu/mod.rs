//! The GPU tracer: from shader files to pixels.
//!
//! [`source`] joins the files, [`program`] parses and reflects them, [`exact`]
//! forbids the driver to contract; [`adapter`] finds an adapter, [`device`] opens
//! it, [`selfcheck`] measures its arithmetic; [`render`] sends the work out in
//! small dispatches.

pub mod adapter;
#[cfg(test)]
mod any_hit_tests;
pub mod device;
#[cfg(test)]
mod divide_tests;
pub mod exact;
pub mod fetch_probe;
mod kernel;
mod loaded;
mod memory;
mod pace;
pub mod paths;
mod portions;
pub mod program;
mod ray_list;
pub mod rays;
pub mod render;
mod retrace;
pub mod sampled;
mod samples;
#[cfg(test)]
mod sampling_tests;
mod scene;
mod scratch;
mod screen;
pub mod selfcheck;
pub mod source;
mod spirv;
mod split;
mod stage;
mod tile;
mod timestamps;
mod upload;
