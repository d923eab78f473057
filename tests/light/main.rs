//! Light by many samples, effect by effect.

mod lamps;
mod scenes;
