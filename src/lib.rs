//! rayproof: a headless GPU ray tracer whose pictures can be trusted.

pub mod compare;
pub mod error;
pub mod frame;
pub mod scene;

pub use error::{Error, Result};
