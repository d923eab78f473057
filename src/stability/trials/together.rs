//! Several trials as one, of scenes that differ in what may not be in one scene.

use crate::error::Result;
use crate::stability::case::Trial;
use crate::stability::subject::Subject;
use crate::stability::tally::Tally;

/// Trials that count as one.
pub struct Together(pub Vec<Box<dyn Trial>>);

impl Trial for Together {
    fn run(&self, on: &dyn Subject) -> Result<Tally> {
        let mut tally = Tally::default();
        for trial in &self.0 {
            tally.add(trial.run(on)?);
        }
        Ok(tally)
    }
}
