//! What a scene file asks for beyond plain shapes under plain lights: lamps, mirrors, glass,
//! textures, surroundings, lenses and motion, and how the light is added up.

#[path = "../common/broken_files.rs"]
mod broken_files;
mod images;
mod keys;
mod meaning;
mod oddities;
mod origins;
