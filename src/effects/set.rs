//! Some of the effects.

use super::{EFFECTS, Effect};
use crate::error::{Error, Result};

/// Some of the effects: those that are to be in a shader whether its scene calls for them or
/// not.
#[derive(Debug, Clone, Copy, Default, PartialEq, Eq)]
pub struct EffectSet(u64);

impl EffectSet {
    /// None of them.
    pub const NONE: Self = Self(0);

    /// All that may be forced.
    pub fn all() -> Self {
        let may = |effect: &&Effect| effect.may_be_forced();
        EFFECTS.iter().filter(may).fold(Self::NONE, Self::with)
    }

    /// These, and one more.
    #[must_use]
    pub fn with(self, effect: &Effect) -> Self {
        Self(self.0 | bit_of(effect))
    }

    /// Whether an effect is one of them.
    pub fn has(self, effect: &Effect) -> bool {
        self.0 & bit_of(effect) != 0
    }

    /// Those of the names.
    ///
    /// # Errors
    ///
    /// [`Error::Usage`] for a name that no effect has, and for one that may not be forced.
    pub fn of<'n>(names: impl IntoIterator<Item = &'n str>) -> Result<Self> {
        names.into_iter().try_fold(Self::NONE, |set, name| {
            let effect = named(name)?;
            if !effect.may_be_forced() {
                return Err(Error::Usage(format!(
                    "`{name}` cannot be forced: `--bounds` chooses the volumes"
                )));
            }
            Ok(set.with(effect))
        })
    }
}

/// The effect of a name.
///
/// # Errors
///
/// [`Error::Usage`] with the names that there are.
pub(super) fn named(name: &str) -> Result<&'static Effect> {
    let found = EFFECTS.iter().find(|effect| effect.name == name);
    found.ok_or_else(|| {
        let names: Vec<&str> = EFFECTS.iter().map(|effect| effect.name).collect();
        Error::Usage(format!(
            "no effect is named `{name}`; there are: {}",
            names.join(", ")
        ))
    })
}

/// An effect's bit: its place in the table.
fn bit_of(effect: &Effect) -> u64 {
    let place = EFFECTS.iter().position(|other| other.name == effect.name);
    place.map_or(0, |place| 1 << place)
}
