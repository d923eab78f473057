//! Textures to a table of them, and one of the texels of all their images.

use std::sync::Arc;

use glam::DVec3;

use super::color;
use crate::layout::TextureRecord;
use crate::scene::{Material, Pattern, Texels, Texture};

/// The textures of a scene's materials.
#[derive(Default)]
pub(super) struct Textures {
    pub(super) records: Vec<TextureRecord>,
    pub(super) texels: Vec<[f32; 4]>,
    /// The images so far, and their first texels: one that is shared is kept once.
    images: Vec<(Arc<Texels>, u32)>,
}

impl Textures {
    /// Adds the texture of a material, and tells its number if it has one.
    pub(super) fn add(&mut self, material: &Material, eye: DVec3) -> Option<u32> {
        let texture = material.texture.as_ref()?;
        let record = self.record(texture, eye);
        self.records.push(record);
        Some(self.records.len() as u32 - 1)
    }

    fn record(&mut self, texture: &Texture, eye: DVec3) -> TextureRecord {
        // A place that is a rounding away from the camera is as near in its repeat.
        let offset = eye.to_array().map(|x| x.rem_euclid(texture.size) as f32);
        let common = TextureRecord {
            offset,
            size: texture.size as f32,
            repeat: texture.repeat.map(|x| x as f32),
            ..TextureRecord::default()
        };
        match &texture.pattern {
            Pattern::Checker(rgb) => TextureRecord {
                color: color(*rgb),
                ..common
            },
            Pattern::Image(image) => TextureRecord {
                first: self.first_texel(image),
                width: image.width,
                height: image.height,
                ..common
            },
        }
    }

    /// The place of an image's first texel, which is added where it is not there yet.
    fn first_texel(&mut self, image: &Arc<Texels>) -> u32 {
        let known = |(other, _): &&(Arc<Texels>, u32)| Arc::ptr_eq(other, image);
        if let Some((_, first)) = self.images.iter().find(known) {
            return *first;
        }
        let first = self.texels.len() as u32;
        self.texels.extend_from_slice(&image.texels);
        self.images.push((image.clone(), first));
        first
    }
}
