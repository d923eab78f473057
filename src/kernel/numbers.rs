//! Numbers to sample by: points that fill the square evenly, for each pixel and dimension
//! other ones.
//!
//! Burley, "Practical Hash-based Owen Scrambling", JCGT 9(4), 2020: the (0,2)-sequence of
//! Sobol, its coordinates scrambled as Owen does it; a pair of dimensions takes them in an
//! order of its own, so that it knows nothing of the other pairs.

/// Of one sample of one pixel, all numbers that it takes.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct Numbers {
    /// Stands for the seed and the pixel.
    pub pixel: u32,
    /// The sample's number, from 0.
    pub sample: u32,
}

/// What keeps a pair's keys apart from a pixel's: any number would do.
pub const KEYS: u32 = 0x9e37_79b9;

/// The distance of the numbers: of 24 bits, so that all are f32 and none is 1.
pub const STEP: f32 = 1.0 / 16_777_216.0;

/// Three numbers that show nothing of the order in these three.
///
/// Jarzynski, Olano, "Hash Functions for GPU Rendering", JCGT 9(3), 2020: pcg3d.
fn pcg3d(a: u32, b: u32, c: u32) -> [u32; 3] {
    let mut x = a.wrapping_mul(1_664_525).wrapping_add(1_013_904_223);
    let mut y = b.wrapping_mul(1_664_525).wrapping_add(1_013_904_223);
    let mut z = c.wrapping_mul(1_664_525).wrapping_add(1_013_904_223);
    x = x.wrapping_add(y.wrapping_mul(z));
    y = y.wrapping_add(z.wrapping_mul(x));
    z = z.wrapping_add(x.wrapping_mul(y));
    x ^= x >> 16;
    y ^= y >> 16;
    z ^= z >> 16;
    x = x.wrapping_add(y.wrapping_mul(z));
    y = y.wrapping_add(z.wrapping_mul(x));
    z = z.wrapping_add(x.wrapping_mul(y));
    [x, y, z]
}

/// A permutation of all u32 in which each bit depends on those below it alone: turned
/// round, Owen's scramble.
///
/// That of Laine and Karras as Vegdahl improved it, see Pharr, Jakob, Humphreys, "Physically
/// Based Rendering", 4th edition, 8.7.2.
fn scrambled(value: u32, key: u32) -> u32 {
    let mut x = value;
    x ^= x.wrapping_mul(0x3d20_adea);
    x = x.wrapping_add(key);
    x = x.wrapping_mul((key >> 16) | 1);
    x ^= x.wrapping_mul(0x0552_6c56);
    x ^= x.wrapping_mul(0x53a2_2864);
    x
}

/// The second coordinate of Sobol's point `index`, its last bit first; the first one's is
/// `index` itself.
///
/// Its matrix is Pascal's triangle modulo 2, which halves itself five times: Ahmed, "An
/// Implementation Algorithm of 2D Sobol Sequence Fast, Elegant, and Compact", EGSR 2024.
fn second_coordinate(index: u32) -> u32 {
    let mut x = index;
    x ^= (x & 0xaaaa_aaaa) >> 1;
    x ^= (x & 0xcccc_cccc) >> 2;
    x ^= (x & 0xf0f0_f0f0) >> 4;
    x ^= (x & 0xff00_ff00) >> 8;
    x ^ (x >> 16)
}

/// The point of the sequence that a pair takes. The first 2^k samples take 2^k points that
/// follow one another, from a multiple of 2^k on.
fn shuffled(sample: u32, key: u32) -> u32 {
    scrambled(sample.reverse_bits(), key).reverse_bits()
}

/// The number with these bits, the last one first: from 0 up to but not 1.
fn from_reversed(bits: u32) -> f32 {
    (bits.reverse_bits() >> 8) as f32 * STEP
}

/// The numbers of a pixel's sample; another `seed` gives another picture's.
pub fn numbers_of(seed: u32, x: u32, y: u32, sample: u32) -> Numbers {
    let pixel = pcg3d(x, y, seed);
    Numbers {
        pixel: pixel[2],
        sample,
    }
}

/// Pair `dimension`, each in \[0, 1), a multiple of 2^-24.
///
/// The pairs of a pixel's first 2^k samples are a (0,2)-net: each of the rectangles of area
/// 2^-k into which halving divides the square has one.
pub fn number_pair(numbers: Numbers, dimension: u32) -> [f32; 2] {
    let keys = pcg3d(numbers.pixel, dimension, KEYS);
    let index = shuffled(numbers.sample, keys[0]);
    [
        from_reversed(scrambled(index, keys[1])),
        from_reversed(scrambled(second_coordinate(index), keys[2])),
    ]
}

/// The first of pair `dimension`.
pub fn number(numbers: Numbers, dimension: u32) -> f32 {
    let keys = pcg3d(numbers.pixel, dimension, KEYS);
    from_reversed(scrambled(shuffled(numbers.sample, keys[0]), keys[1]))
}

#[cfg(test)]
mod tests;
