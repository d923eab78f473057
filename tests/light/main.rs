//! Pictures by paths of light against what is known of them.

mod clear_bodies;
#[path = "../common/mod.rs"]
mod common;
mod mirrors;
mod seen;
