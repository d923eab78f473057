//! Watching a long computation: its progress, and a way to stop it.

/// Told how far a computation is; asked whether it should go on.
pub trait Watch: Sync {
    /// Called often, with the part done, from 0 to 1.
    fn progress(&self, _done: f64) {}

    /// Called often; `true` ends the computation with [`crate::Error::Interrupted`].
    fn cancelled(&self) -> bool {
        false
    }
}

/// Watches nothing and never stops.
#[derive(Debug, Clone, Copy, Default)]
pub struct Unwatched;

impl Watch for Unwatched {}
