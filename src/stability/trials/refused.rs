//! Scenes that have no meaning: they are refused when they are loaded, before any ray.

use crate::error::Result;
use crate::scene::Scene;
use crate::stability::case::Trial;
use crate::stability::subject::Subject;
use crate::stability::tally::{Tally, must};

/// Scenes, and a word that the reason for the refusal has to hold.
pub struct Refused(pub Vec<(Scene, &'static str)>);

impl Trial for Refused {
    fn run(&self, on: &dyn Subject) -> Result<Tally> {
        let mut tally = Tally::default();
        for (scene, reason) in &self.0 {
            let is_told = match on.validate(scene) {
                Ok(()) => false,
                Err(error) => error.to_string().contains(reason),
            };
            tally.count([must(is_told)]);
        }
        Ok(tally)
    }
}
