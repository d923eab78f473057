// Which pair of random numbers is for what: each use on each leg of a path has its own.

// Where in the pixel a ray goes through, where through the lens, and when.
const IN_PIXEL: u32 = 0u;
const IN_LENS: u32 = 1u;
const IN_TIME: u32 = 2u;

// On a leg: which lobe scatters, and where to; ambient light and the sky from where; how far
// through fog; whether the path goes on; and where on a lamp, lamp by lamp.
const LOBE: u32 = 0u;
const SCATTER: u32 = 1u;
const AMBIENT: u32 = 2u;
const SKY: u32 = 3u;
const FOG_WAY: u32 = 4u;
const ROULETTE: u32 = 5u;
const LAMP: u32 = 6u;

// The pairs of a leg, from where on, and those of a lamp.
const PAIRS_OF_LEG: u32 = 7u;
const FIRST_LEG: u32 = 8u;
const PAIRS_OF_LAMP: u32 = 65536u;

// The pair for a use on a leg.
fn dimension_of(leg: u32, purpose: u32) -> u32 {
    return FIRST_LEG + leg * PAIRS_OF_LEG + purpose;
}

// The pair for a lamp on a leg.
fn dimension_of_lamp(leg: u32, lamp: u32) -> u32 {
    return dimension_of(leg, LAMP) + lamp * PAIRS_OF_LAMP;
}
