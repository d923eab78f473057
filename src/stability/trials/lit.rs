//! Pictures of which the light is known.

use crate::accuracy::Widths;
use crate::error::Result;
use crate::layout::{NO_HIT, Pixel};
use crate::stability::case::Trial;
use crate::stability::subject::Subject;
use crate::stability::tally::{Tally, must};

/// A scene that must be dark all over: its lights are behind what is seen, or in its plane.
pub struct Dark(pub Widths);

impl Trial for Dark {
    fn run(&self, on: &dyn Subject) -> Result<Tally> {
        let mut tally = Tally::default();
        for Pixel { color, id, .. } in on.picture(&self.0)? {
            // NaN counts as light.
            let light = color
                .into_iter()
                .fold(0.0, |sum, c| sum + f64::from(c).abs());
            let is_seen = must(id != NO_HIT);
            tally.count([(light, 0.0), is_seen]);
        }
        Ok(tally)
    }
}
