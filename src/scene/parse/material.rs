//! `[[material]]`: names, and colours drawn by lot.

use std::collections::BTreeMap;

use super::faults::Faults;
use super::image_file::ImageFiles;
use super::near::suggestion;
use super::section::{Found, Section};
use super::surface::surface;
use super::value::text;
use crate::scene::{Material, Origin};

/// The name of the material of shapes that name none.
const DEFAULT: &str = "default";

/// The scene's materials as they grow while shapes ask for them.
#[derive(Default)]
pub(super) struct Palette {
    pub(super) materials: Vec<Material>,
    /// Where those are from, but for the last that a mesh brought along.
    origins: Vec<Origin>,
    named: BTreeMap<String, Paint>,
}

enum Paint {
    /// An index into the materials.
    Plain(usize),
    /// Every instance gets an albedo of its own.
    Random {
        material: Box<Material>,
        line: u32,
        seed: u64,
        instances: u64,
    },
}

impl Palette {
    /// Adds one `[[material]]`.
    pub(super) fn read(
        &mut self,
        mut section: Section<'_, '_>,
        images: &mut ImageFiles<'_>,
        faults: &mut Faults<'_>,
    ) {
        let name = section.required("name", faults, text);
        let surface = surface(&mut section, images, faults);
        let line = faults.line_of(&section.span);
        section.close(faults);
        let Some(Found { value: name, span }) = name else {
            return;
        };
        if self.named.contains_key(&name) {
            faults.push(
                span,
                format!("the material \"{name}\" is defined twice"),
                "defined before",
                "give each material a name of its own",
            );
            return;
        }
        // A material with a fault is still known by its name.
        let mut material = surface.material;
        material.name.clone_from(&name);
        let paint = match surface.seed {
            Some(seed) => Paint::Random {
                material: Box::new(material),
                line,
                seed,
                instances: 0,
            },
            None => Paint::Plain(self.push(material, Some(line))),
        };
        self.named.insert(name, paint);
    }

    /// Is there such a material? A fault if not.
    pub(super) fn check(&self, name: &Found<String>, faults: &mut Faults<'_>) {
        let word = name.value.as_str();
        let known = word == DEFAULT || self.named.contains_key(word);
        if !known && !faults.hides_material {
            let names = self.named.keys().map(String::as_str);
            let names = names.take(if faults.is_full() { 0 } else { usize::MAX });
            faults.push(
                name.span.clone(),
                format!("no material is named \"{word}\""),
                "not defined",
                suggestion(word, "materials of this scene", names),
            );
        }
    }

    /// The index of the material for one more instance of a shape.
    pub(super) fn index(&mut self, name: Option<&str>) -> usize {
        let name = name.unwrap_or(DEFAULT);
        match self.named.get_mut(name) {
            Some(Paint::Plain(index)) => *index,
            Some(Paint::Random {
                material,
                line,
                seed,
                instances,
            }) => {
                let (seed, instance, line) = (*seed, *instances, *line);
                *instances += 1;
                let mut material = Material::clone(material);
                material.name = format!("{name}#{instance}");
                material.albedo = [0, 1, 2].map(|channel| fraction(seed, instance, channel));
                self.push(material, Some(line))
            }
            None => {
                let index = self.push(Material::default(), None);
                self.named.insert(name.to_owned(), Paint::Plain(index));
                index
            }
        }
    }

    /// Notes that the last materials came with the mesh whose header is at a line.
    pub(super) fn brought_by(&mut self, line: u32) {
        let brought = &self.materials[self.origins.len()..];
        self.origins.extend(brought.iter().map(|material| Origin {
            name: Some(material.name.clone()),
            line: Some(line),
        }));
    }

    /// All materials, and where they are from.
    pub(super) fn into_parts(self) -> (Vec<Material>, Vec<Origin>) {
        (self.materials, self.origins)
    }

    fn push(&mut self, material: Material, line: Option<u32>) -> usize {
        self.origins.push(Origin {
            name: Some(material.name.clone()),
            line,
        });
        self.materials.push(material);
        self.materials.len() - 1
    }
}

/// A fraction in [0, 1) with 53 random bits, from integers alone, so that every
/// machine draws the same.
fn fraction(seed: u64, instance: u64, channel: u64) -> f64 {
    let bits = mix(mix(mix(seed).wrapping_add(instance)).wrapping_add(channel));
    (bits >> 11) as f64 / (1u64 << 53) as f64
}

/// One step of SplitMix64 (Steele, Lea, Flood 2014, "Fast splittable
/// pseudorandom number generators", figure 17).
fn mix(state: u64) -> u64 {
    let z = state.wrapping_add(0x9e37_79b9_7f4a_7c15);
    let z = (z ^ (z >> 30)).wrapping_mul(0xbf58_476d_1ce4_e5b9);
    let z = (z ^ (z >> 27)).wrapping_mul(0x94d0_49bb_1331_11eb);
    z ^ (z >> 31)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn mix_is_splitmix64() {
        // The first outputs of the published generator for the seed 0.
        assert_eq!(mix(0), 0xe220_a839_7b1d_cdaf);
        assert_eq!(mix(0x9e37_79b9_7f4a_7c15), 0x6e78_9e6a_a1b9_65f4);
    }

    #[test]
    fn fractions_differ_by_seed_instance_and_channel_and_fill_the_unit() {
        let all: Vec<f64> = (0..3000).map(|i| fraction(7, i / 3, i % 3)).collect();
        let mean = all.iter().sum::<f64>() / all.len() as f64;
        // Standard error of the mean of 3000 uniform numbers: sqrt(1/12/3000).
        assert!(
            (mean - 0.5).abs() < 5.0 * (1.0f64 / 36_000.0).sqrt(),
            "{mean}"
        );
        assert!(all.iter().all(|f| (0.0..1.0).contains(f)));
        let mut distinct = all.clone();
        distinct.sort_by(f64::total_cmp);
        distinct.dedup();
        assert_eq!(distinct.len(), all.len());
        assert_ne!(fraction(7, 0, 0), fraction(8, 0, 0));
    }
}
