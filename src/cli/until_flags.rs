//! The flags that say when a picture of many samples has enough of them.

use std::time::Duration;

use clap::Args;

use super::plan_flags::parse_seconds;
use rayproof::samples::Enough;
use rayproof::scene::{MAX_SAMPLES, Scene};

#[derive(Debug, Args)]
pub(super) struct UntilFlags {
    /// Take samples for so long
    #[arg(long, value_name = "SECONDS", value_parser = parse_seconds)]
    time: Option<f64>,
    /// Take samples until the estimated error is no more than this part of the picture's
    /// mean brightness
    #[arg(long, value_name = "X", value_parser = parse_noise)]
    noise: Option<f64>,
    /// Write the picture so far every so many seconds
    #[arg(long, value_name = "SECONDS", value_parser = parse_seconds)]
    preview_every: Option<f64>,
}

impl UntilFlags {
    /// When there are enough samples.
    pub(super) fn enough(&self) -> Enough {
        Enough {
            time: self.time.map(Duration::from_secs_f64),
            noise: self.noise,
        }
    }

    /// How often the picture so far is written.
    pub(super) fn preview_every(&self) -> Option<Duration> {
        self.preview_every.map(Duration::from_secs_f64)
    }

    /// The scene, with as many samples as may be where these flags end them and `samples`
    /// does not.
    pub(super) fn change(&self, mut scene: Scene, samples: Option<u32>) -> Scene {
        if samples.is_none() && (self.time.is_some() || self.noise.is_some()) {
            scene.integrator.samples = MAX_SAMPLES;
        }
        scene
    }
}

fn parse_noise(text: &str) -> Result<f64, String> {
    match text.parse() {
        Ok(noise) if noise > 0.0 && noise < 1.0 => Ok(noise),
        _ => Err(format!(
            "`{text}` is not a part of the brightness; write 0.01 for a hundredth"
        )),
    }
}
