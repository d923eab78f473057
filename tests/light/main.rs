//! The light of pictures that are made of samples, effect by effect, against closed forms.

#[path = "../common/mod.rs"]
mod common;

mod bands;
mod bounces;
mod clear_bodies;
mod convergence;
mod cutouts;
mod depth_of_field;
mod endings;
mod faults;
mod fog;
mod fresnel;
mod furnaces;
mod lamps;
mod matt_surfaces;
mod mirrors;
mod motion_blur;
mod noisy;
mod rough_mirrors;
mod sampled;
mod scenes;
mod seen;
mod sky;
mod soft_shadows;
mod strategies;
mod textures;
mod tiers;
mod volumes;
