//! What the rays of a picture tested, in exact sums.

use std::ops::{Add, AddAssign};

use serde::Serialize;

/// What rays tested.
#[derive(Debug, Clone, Copy, Default, PartialEq, Eq, Serialize)]
pub struct Counters {
    /// Volumes tested, two for each pair of a tree.
    pub bound_tests: u64,
    /// Those of them that the ray met, and, in a tree, no farther than its hit.
    pub bound_hits: u64,
    /// Shapes tested.
    pub shape_tests: u64,
}

impl Add for Counters {
    type Output = Self;

    fn add(self, other: Self) -> Self {
        Self {
            bound_tests: self.bound_tests + other.bound_tests,
            bound_hits: self.bound_hits + other.bound_hits,
            shape_tests: self.shape_tests + other.shape_tests,
        }
    }
}

impl AddAssign for Counters {
    fn add_assign(&mut self, other: Self) {
        *self = *self + other;
    }
}
