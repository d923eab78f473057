//! Numbers that nobody chose, and that are the same every time.

use glam::DVec3;

/// A fixed sequence of numbers, so that a failure can be repeated.
#[derive(Debug, Clone)]
pub struct Numbers(pub u64);

impl Numbers {
    /// Steele, Lea, Flood, "Fast Splittable Pseudorandom Number Generators",
    /// OOPSLA 2014: SplitMix64.
    #[expect(clippy::should_implement_trait, reason = "it has no end")]
    pub fn next(&mut self) -> u64 {
        self.0 = self.0.wrapping_add(0x9e37_79b9_7f4a_7c15);
        let mut z = self.0;
        z = (z ^ (z >> 30)).wrapping_mul(0xbf58_476d_1ce4_e5b9);
        z = (z ^ (z >> 27)).wrapping_mul(0x94d0_49bb_1331_11eb);
        z ^ (z >> 31)
    }

    /// Evenly from `low` to `high`.
    pub fn between(&mut self, low: f64, high: f64) -> f64 {
        low + (high - low) * (self.next() >> 11) as f64 / (1u64 << 53) as f64
    }

    /// Evenly in the cube from `-reach` to `reach`.
    pub fn vector(&mut self, reach: f64) -> DVec3 {
        DVec3::from_array([0; 3].map(|_| self.between(-reach, reach)))
    }

    /// Of length 1, evenly in all directions (Marsaglia 1972).
    pub fn direction(&mut self) -> DVec3 {
        loop {
            let v = self.vector(1.0);
            let square = v.length_squared();
            if (1e-6..=1.0).contains(&square) {
                return v / square.sqrt();
            }
        }
    }

    /// One of so many.
    pub fn pick(&mut self, count: usize) -> usize {
        (self.next() % count as u64) as usize
    }

    /// Heads or tails.
    pub fn flip(&mut self) -> bool {
        self.next().is_multiple_of(2)
    }
}
