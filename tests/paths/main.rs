//! Paths: rays that go on from the surfaces that they meet.

mod backends;
#[path = "../common/mod.rs"]
mod common;
mod geometry;

use rayproof::Backend;

/// Both backends; without a GPU the tests fail.
fn backends() -> [Backend; 2] {
    [Backend::Cpu(None), Backend::Gpu(Box::new(common::gpu()))]
}
