//! What the rays of a picture tested: ray by ray, and in exact sums.

use std::ops::{Add, AddAssign};

use serde::Serialize;

use crate::error::{Error, Result};
use crate::kernel::hit::GIVEN_UP;
use crate::ramp::ramp_color;

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

/// Bytes a pixel that counting takes beside the frame: what each ray counted, then the
/// heat map, outlines and what they are found by, or channels of an EXR.
pub const COUNT_BYTES: u64 = 12 + 3 + 1 + 8;

/// What one ray tested.
#[derive(Debug, Clone, Copy, Default, PartialEq, Eq)]
pub struct Counted {
    /// As in [`Counters`].
    pub bound_tests: u32,
    /// As in [`Counters`].
    pub bound_hits: u32,
    /// As in [`Counters`].
    pub shape_tests: u32,
}

/// What can be counted of a ray.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum CountLayer {
    /// Shapes tested.
    Tests,
    /// Volumes tested.
    Bounds,
}

impl CountLayer {
    /// Both.
    pub const ALL: [Self; 2] = [Self::Tests, Self::Bounds];

    /// The name on the command line.
    pub fn name(self) -> &'static str {
        match self {
            Self::Tests => "tests",
            Self::Bounds => "bounds",
        }
    }

    /// What a ray counted.
    pub fn of(self, counted: &Counted) -> u32 {
        match self {
            Self::Tests => counted.shape_tests,
            Self::Bounds => counted.bound_tests,
        }
    }
}

impl Counted {
    /// What a ray counted, unless it was given up on its way.
    ///
    /// # Errors
    ///
    /// [`Error::Limit`] if it was.
    pub fn of(bound_tests: u32, bound_hits: u32, shape_tests: u32) -> Result<Self> {
        if shape_tests == GIVEN_UP {
            return Err(Error::Limit(
                "a ray meets too many volumes to be counted: add `--bounds none`".into(),
            ));
        }
        Ok(Self {
            bound_tests,
            bound_hits,
            shape_tests,
        })
    }
}

/// What each ray of a picture tested.
#[derive(Debug, Clone, Default, PartialEq, Eq)]
pub struct CountMap {
    /// Pixels from left to right.
    pub width: u32,
    /// Row by row from the top left.
    pub pixels: Vec<Counted>,
}

impl CountMap {
    /// All rays together.
    pub fn sum(&self) -> Counters {
        let counters = self.pixels.iter().map(|counted| Counters {
            bound_tests: counted.bound_tests.into(),
            bound_hits: counted.bound_hits.into(),
            shape_tests: counted.shape_tests.into(),
        });
        counters.fold(Counters::default(), Add::add)
    }

    /// The greatest count of a layer.
    pub fn greatest(&self, layer: CountLayer) -> u32 {
        let counts = self.pixels.iter().map(|counted| layer.of(counted));
        counts.max().unwrap_or(0)
    }

    /// A layer as RGB bytes, three a pixel: black for nothing, then from dark violet
    /// over red to pale yellow for the greatest count, in even steps of lightness.
    pub fn to_rgb8(&self, layer: CountLayer) -> Vec<u8> {
        let greatest = f64::from(self.greatest(layer));
        let color = |counted: &Counted| match layer.of(counted) {
            0 => [0; 3],
            count => ramp_color(f64::from(count) / greatest),
        };
        let colors: Vec<_> = self.pixels.iter().map(color).collect();
        colors.into_flattened()
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn maps_are_summed_and_shown() {
        let counted = |bound_tests, shape_tests| Counted {
            bound_tests,
            bound_hits: 1,
            shape_tests,
        };
        let map = CountMap {
            width: 2,
            pixels: vec![counted(u32::MAX, 0), counted(u32::MAX, 4)],
        };
        let sum = map.sum();
        assert_eq!(sum.bound_tests, 2 * u64::from(u32::MAX));
        assert_eq!((sum.bound_hits, sum.shape_tests), (2, 4));
        let tests = map.to_rgb8(CountLayer::Tests);
        assert_eq!(tests[..3], [0; 3]);
        assert_eq!(tests[3..], ramp_color(1.0));
        assert_eq!(map.to_rgb8(CountLayer::Bounds)[..3], ramp_color(1.0));
        assert!(Counted::of(1, 1, GIVEN_UP).is_err());
        assert_eq!(Counted::of(u32::MAX, 1, 4).unwrap(), map.pixels[1]);
        assert_eq!(CountMap::default().greatest(CountLayer::Tests), 0);
    }
}
