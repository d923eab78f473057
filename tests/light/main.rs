//! Light by many samples, effect by effect.

mod lamps;
mod sampled;
mod scenes;
mod sky;
mod soft_shadows;
mod strategies;
