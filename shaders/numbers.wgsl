// Numbers to sample by: points that fill the square evenly, for each pixel and dimension
// other ones.
//
// Burley, "Practical Hash-based Owen Scrambling", JCGT 9(4), 2020: the (0,2)-sequence of
// Sobol, its coordinates scrambled as Owen does it; a pair of dimensions takes them in an
// order of its own, so that it knows nothing of the other pairs.

// Of one sample of one pixel, all numbers that it takes.
struct Numbers {
    // Stands for the seed and the pixel.
    pixel: u32,
    // The sample's number, from 0.
    sample: u32,
}

// What keeps a pair's keys apart from a pixel's: any number would do.
const KEYS: u32 = 0x9e3779b9u;

// The distance of the numbers: of 24 bits, so that all are f32 and none is 1.
const STEP: f32 = 1.0 / 16777216.0;

// Three numbers that show nothing of the order in these three.
//
// Jarzynski, Olano, "Hash Functions for GPU Rendering", JCGT 9(3), 2020: pcg3d.
fn pcg3d(a: u32, b: u32, c: u32) -> vec3<u32> {
    var x = a * 1664525u + 1013904223u;
    var y = b * 1664525u + 1013904223u;
    var z = c * 1664525u + 1013904223u;
    x += y * z;
    y += z * x;
    z += x * y;
    x ^= x >> 16u;
    y ^= y >> 16u;
    z ^= z >> 16u;
    x += y * z;
    y += z * x;
    z += x * y;
    return vec3<u32>(x, y, z);
}

// A permutation of all u32 in which each bit depends on those below it alone: turned
// round, Owen's scramble.
//
// That of Laine and Karras as Vegdahl improved it, see Pharr, Jakob, Humphreys, "Physically
// Based Rendering", 4th edition, 8.7.2.
fn scrambled(value: u32, key: u32) -> u32 {
    var x = value;
    x ^= x * 0x3d20adeau;
    x += key;
    x *= (key >> 16u) | 1u;
    x ^= x * 0x05526c56u;
    x ^= x * 0x53a22864u;
    return x;
}

// The second coordinate of Sobol's point `index`, its last bit first; the first one's is
// `index` itself.
//
// Its matrix is Pascal's triangle modulo 2, which halves itself five times: Ahmed, "An
// Implementation Algorithm of 2D Sobol Sequence Fast, Elegant, and Compact", EGSR 2024.
fn second_coordinate(index: u32) -> u32 {
    var x = index;
    x ^= (x & 0xaaaaaaaau) >> 1u;
    x ^= (x & 0xccccccccu) >> 2u;
    x ^= (x & 0xf0f0f0f0u) >> 4u;
    x ^= (x & 0xff00ff00u) >> 8u;
    return x ^ (x >> 16u);
}

// The point of the sequence that a pair takes. The first 2^k samples take 2^k points that
// follow one another, from a multiple of 2^k on.
fn shuffled(sample: u32, key: u32) -> u32 {
    return reverseBits(scrambled(reverseBits(sample), key));
}

// The number with these bits, the last one first: from 0 up to but not 1.
fn from_reversed(bits: u32) -> f32 {
    return f32(reverseBits(bits) >> 8u) * STEP;
}

// The numbers of a pixel's sample; another `seed` gives another picture's.
fn numbers_of(seed: u32, x: u32, y: u32, sample: u32) -> Numbers {
    let pixel = pcg3d(x, y, seed);
    return Numbers(pixel.z, sample);
}

// Pair `dimension`, each in [0, 1), a multiple of 2^-24.
//
// The pairs of a pixel's first 2^k samples are a (0,2)-net: each of the rectangles of area
// 2^-k into which halving divides the square has one.
fn number_pair(numbers: Numbers, dimension: u32) -> vec2<f32> {
    let keys = pcg3d(numbers.pixel, dimension, KEYS);
    let index = shuffled(numbers.sample, keys.x);
    return vec2<f32>(
        from_reversed(scrambled(index, keys.y)),
        from_reversed(scrambled(second_coordinate(index), keys.z)),
    );
}

// The first of pair `dimension`.
fn number(numbers: Numbers, dimension: u32) -> f32 {
    let keys = pcg3d(numbers.pixel, dimension, KEYS);
    return from_reversed(scrambled(shuffled(numbers.sample, keys.x), keys.y));
}
