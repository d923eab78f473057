//! The flags that change what a scene's pictures are made of.

use clap::Args;

use rayproof::effects::{EffectSet, without};
use rayproof::error::Result;
use rayproof::scene::{MAX_SAMPLES, Scene};

#[derive(Debug, Args)]
pub(super) struct EffectFlags {
    /// Paths through a pixel, in place of the scene's own
    #[arg(long, value_name = "N",
          value_parser = clap::value_parser!(u32).range(1..=i64::from(MAX_SAMPLES)))]
    pub(super) samples: Option<u32>,
    /// What the paths' random numbers are drawn from, in place of the scene's own
    #[arg(long, value_name = "N")]
    pub(super) seed: Option<u32>,
    /// Leave an effect out that the scene calls for; several, with commas
    #[arg(long, value_name = "EFFECT", value_delimiter = ',')]
    pub(super) without: Vec<String>,
    /// Put an effect into the shaders that the scene does not call for, which changes the
    /// time but no bit of the picture; several, with commas, or `all`
    #[arg(long, value_name = "EFFECT", value_delimiter = ',')]
    pub(super) force: Vec<String>,
}

impl EffectFlags {
    /// The scene as the flags would have it.
    ///
    /// # Errors
    ///
    /// [`rayproof::Error::Usage`] for an effect that there is not, or that cannot be left out.
    pub(super) fn change(&self, mut scene: Scene) -> Result<Scene> {
        if let Some(samples) = self.samples {
            scene.integrator.samples = samples;
        }
        if let Some(seed) = self.seed {
            scene.integrator.seed = seed;
        }
        for name in &self.without {
            scene = without(&scene, name)?;
        }
        Ok(scene)
    }

    /// The effects that are forced.
    ///
    /// # Errors
    ///
    /// [`rayproof::Error::Usage`] for an effect that there is not, or that cannot be forced.
    pub(super) fn forced(&self) -> Result<EffectSet> {
        if self.force == ["all"] {
            return Ok(EffectSet::all());
        }
        EffectSet::of(self.force.iter().map(String::as_str))
    }
}
