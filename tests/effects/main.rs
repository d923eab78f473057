//! Effects: each alone, each pair, and all at once: their modules, and their pictures.

#[path = "../common/mod.rs"]
mod common;

mod causes;
mod modules;
mod pictures;
mod proof;
mod scenes;
