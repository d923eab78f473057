//! The light of pictures that are made of samples, effect by effect, against closed forms.

#[path = "../common/mod.rs"]
mod common;

mod cutouts;
mod fog;
mod textures;
