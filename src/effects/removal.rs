//! How what calls for an effect is taken out of a scene.

use super::set::named;
use crate::error::{Error, Result};
use crate::scene::Scene;

/// The scene without what calls for the effect of this name.
///
/// # Errors
///
/// [`Error::Usage`] for a name that no effect has, and for volumes, which the settings ask
/// for.
pub fn without(scene: &Scene, name: &str) -> Result<Scene> {
    let effect = named(name)?;
    let Some(remove) = effect.removal else {
        return Err(Error::Usage(format!(
            "`{name}` cannot be left out: it goes with the shapes, and `--bounds`"
        )));
    };
    let mut left = scene.clone();
    remove(&mut left);
    Ok(left)
}
