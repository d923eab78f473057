//! rayproof: a headless GPU ray tracer whose pictures can be trusted.

pub mod compare;
pub mod cpu;
pub mod effects;
pub mod error;
pub mod flatten;
pub mod frame;
pub mod gpu;
pub mod kernel;
pub mod layout;
pub mod render;
pub mod scene;
pub mod watch;

pub use error::{Error, Result};
