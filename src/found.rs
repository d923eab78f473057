//! What a ray of a list finds.

use crate::error::{Error, Result};
use crate::flat::Flat;
use crate::kernel::hit::{GIVEN_UP, Hit};
use crate::kernel::real::Real;
use crate::layout::NO_HIT;

/// What a ray finds.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Found {
    /// The ray's parameter at its closest hit, infinite where nothing is hit.
    pub t: f64,
    /// The primitive, or [`NO_HIT`].
    pub id: u32,
}

impl Found {
    /// At a hit.
    ///
    /// # Errors
    ///
    /// [`Error::Limit`] where the ray was given up.
    pub fn at<R: Real>(hit: Hit<R>) -> Result<Self> {
        if hit.tests == GIVEN_UP {
            return Err(given_up());
        }
        Ok(Self::new(hit.t.to_f64(), hit.id))
    }

    /// Of a primitive, or of none.
    pub fn new(t: f64, id: u32) -> Self {
        let t = if id == NO_HIT { f64::INFINITY } else { t };
        Self { t, id }
    }
}

/// A ray was given up on its way.
pub(crate) fn given_up() -> Error {
    Error::Limit("a ray meets too many volumes: add `--bounds none`".into())
}

/// Refuses a scene with a list of volumes, of which balls are padded for rays from the camera
/// only.
pub(crate) fn refuse_lists<R>(flat: &Flat<R>) -> Result<()> {
    if flat.volumes.is_empty() {
        return Ok(());
    }
    Err(Error::Limit(
        "rays of a list go through a tree or through all shapes: take bounds `tree` or `none`"
            .into(),
    ))
}
