//! What is counted of a trial.

use serde::Serialize;

/// How many rays, how many of them wrong, and the worst.
#[derive(Debug, Clone, Copy, Default, PartialEq, Serialize)]
pub struct Tally {
    /// Rays tried.
    pub rays: u64,
    /// Those that did not have what was demanded.
    pub wrong: u64,
    /// The error that was largest in parts of its bound.
    pub worst: f64,
    /// The bound of that error; 0 where none is allowed.
    pub bound: f64,
}

impl Tally {
    /// Counts a ray, given its error and the bound of it under each demand; 0 and 0 is right.
    pub fn count(&mut self, errors: impl IntoIterator<Item = (f64, f64)>) {
        self.rays += 1;
        let mut is_wrong = false;
        for (error, bound) in errors {
            is_wrong |= error.is_nan() || error > bound;
            if part(error, bound) > part(self.worst, self.bound)
                || (self.worst, self.bound) == (0.0, 0.0)
            {
                (self.worst, self.bound) = (error, bound);
            }
        }
        self.wrong += u64::from(is_wrong);
    }

    /// Adds what another trial counted.
    pub fn add(&mut self, other: Self) {
        self.rays += other.rays;
        self.wrong += other.wrong;
        if part(other.worst, other.bound) >= part(self.worst, self.bound) {
            (self.worst, self.bound) = (other.worst, other.bound);
        }
    }
}

/// What holds or does not, as an error of which none is allowed.
pub fn must(holds: bool) -> (f64, f64) {
    (f64::from(u8::from(!holds)), 0.0)
}

/// An error in parts of its bound: infinite where none is allowed.
fn part(error: f64, bound: f64) -> f64 {
    if error == 0.0 {
        0.0
    } else if error.is_nan() {
        f64::INFINITY
    } else {
        error / bound
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_worst_is_the_largest_part_of_its_bound() {
        let mut tally = Tally::default();
        tally.count([(1.0, 4.0), (0.0, 0.0)]);
        tally.count([(3.0, 16.0)]);
        tally.count([(5.0, 4.0), (1.0, 2.0)]);
        let expected = Tally {
            rays: 3,
            wrong: 1,
            worst: 5.0,
            bound: 4.0,
        };
        assert_eq!(tally, expected);
        tally.count([(f64::NAN, 4.0)]);
        tally.count([(1.0, 0.0)]);
        assert_eq!((tally.rays, tally.wrong), (5, 3));
        let mut sum = Tally::default();
        sum.count([(1.0, 4.0)]);
        sum.add(expected);
        assert_eq!((sum.rays, sum.wrong, sum.worst), (4, 1, 5.0));
        // What may have no error stays the worst.
        sum.count([(1.0, 0.0)]);
        sum.count([(0.0, 0.0), (1.0, 4.0)]);
        assert_eq!((sum.wrong, sum.worst, sum.bound), (2, 1.0, 0.0));
    }
}
