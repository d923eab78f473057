//! The accuracy tiers: what each promises, on both backends. They need a Vulkan driver with
//! f64; software will do.

mod aimed;
#[path = "../common/mod.rs"]
mod common;
mod intervals;
mod leaving;
mod pictures;
mod refusals;
mod table;

use rayproof::Backend;
use rayproof::found::Found;

/// Scenes whose pictures are looked at.
const PICTURES: [&str; 8] = [
    "shapes",
    "seed-models",
    "seed-spheres",
    "knot",
    "planet",
    "far-sphere",
    "slivers",
    "contact",
];

/// Scenes at which rays are aimed: whether the scene is turned, and its scale.
const HARD: [(bool, f64); 4] = [(false, 1.0), (true, 1.0), (true, 1e-3), (true, 1e4)];

/// Both backends; without a GPU the tests fail.
fn backends() -> [Backend; 2] {
    [Backend::Cpu(None), Backend::Gpu(Box::new(common::gpu()))]
}

/// Whether the long tests are asked for.
fn thorough() -> bool {
    std::env::var_os("RAYPROOF_THOROUGH").is_some()
}

/// The indices at which two lists name another primitive.
fn differing_ids(left: &[Found], right: &[Found]) -> Vec<usize> {
    let pairs = left.iter().zip(right).enumerate();
    pairs
        .filter(|(_, (left, right))| left.id != right.id)
        .map(|(index, _)| index)
        .collect()
}
