//! Which pair of random numbers is for what: each use on each leg of a path has its own.

/// Where in the pixel a ray goes through.
pub const IN_PIXEL: u32 = 0;
/// Where it goes through the lens.
pub const IN_LENS: u32 = 1;
/// When.
pub const IN_TIME: u32 = 2;

/// On a leg: which lobe scatters.
pub const LOBE: u32 = 0;
/// Where to.
pub const SCATTER: u32 = 1;
/// From where ambient light is looked for.
pub const AMBIENT: u32 = 2;
/// From where in the sky light is looked for.
pub const SKY: u32 = 3;
/// How far a ray comes through fog.
pub const FOG_WAY: u32 = 4;
/// Whether the path goes on.
pub const ROULETTE: u32 = 5;
/// Where on a lamp, lamp by lamp.
pub const LAMP: u32 = 6;

/// The pairs of a leg.
pub const PAIRS_OF_LEG: u32 = 7;
/// The first leg's first pair.
pub const FIRST_LEG: u32 = 8;
/// From one lamp's pair to the next lamp's.
pub const PAIRS_OF_LAMP: u32 = 65_536;

/// The pair for a use on a leg.
pub fn dimension_of(leg: u32, purpose: u32) -> u32 {
    FIRST_LEG + leg * PAIRS_OF_LEG + purpose
}

/// The pair for a lamp on a leg.
pub fn dimension_of_lamp(leg: u32, lamp: u32) -> u32 {
    dimension_of(leg, LAMP) + lamp * PAIRS_OF_LAMP
}
