//! The light of pictures that are made of samples, effect by effect, against closed forms.

#[path = "../common/mod.rs"]
mod common;

mod clear_bodies;
mod cutouts;
mod depth_of_field;
mod fog;
mod lamps;
mod mirrors;
mod motion_blur;
mod sampled;
mod scenes;
mod seen;
mod sky;
mod soft_shadows;
mod strategies;
mod textures;
