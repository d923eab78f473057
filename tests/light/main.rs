//! The light of pictures that are made of samples, against closed forms.

#[path = "../common/mod.rs"]
mod common;

mod depth_of_field;
mod motion_blur;
