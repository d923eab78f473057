//! `[[material]]`: names, colours, and colours drawn by lot.

use std::collections::BTreeMap;

use toml::de::DeValue;

use super::faults::Faults;
use super::near::suggestion;
use super::section::{Found, Section};
use super::value::{number, ruled, text, triple, whole};
use crate::scene::{Material, Rgb, check};

/// The name of the material of shapes that name none.
const DEFAULT: &str = "default";

/// The albedo of the default material: a light grey.
const DEFAULT_ALBEDO: Rgb = [0.8; 3];

/// The scene's materials as they grow while shapes ask for them.
#[derive(Default)]
pub(super) struct Palette {
    pub(super) materials: Vec<Material>,
    named: BTreeMap<String, Paint>,
}

#[derive(Clone, Copy)]
enum Paint {
    /// An index into `materials`.
    Plain(usize),
    /// Every instance gets an albedo of its own.
    Random { seed: u64, instances: u64 },
}

#[derive(Clone, Copy)]
enum Albedo {
    Plain(Rgb),
    Random(u64),
}

impl Palette {
    /// Adds one `[[material]]`.
    pub(super) fn read(&mut self, mut section: Section<'_, '_>, faults: &mut Faults<'_>) {
        let name = section.required("name", faults, text);
        let albedo = match section.value("albedo") {
            Some(value) => match value.get_ref() {
                DeValue::Table(_) => random(value, faults),
                _ => triple(ruled(number, |what, x| check::albedo(what, [x; 3])))(
                    value, "albedo", faults,
                )
                .map(Albedo::Plain),
            },
            // Only to say that it is missing.
            None => section
                .required("albedo", faults, triple(number))
                .map(|found| Albedo::Plain(found.value)),
        };
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
        // A material whose albedo is at fault is still known by its name.
        let paint = match albedo.unwrap_or(Albedo::Plain(DEFAULT_ALBEDO)) {
            Albedo::Random(seed) => Paint::Random { seed, instances: 0 },
            Albedo::Plain(albedo) => Paint::Plain(self.push(name.clone(), albedo)),
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
            Some(Paint::Random { seed, instances }) => {
                let (seed, instance) = (*seed, *instances);
                *instances += 1;
                let albedo = [0, 1, 2].map(|channel| fraction(seed, instance, channel));
                self.push(format!("{name}#{instance}"), albedo)
            }
            None => {
                let index = self.push(name.to_owned(), DEFAULT_ALBEDO);
                self.named.insert(name.to_owned(), Paint::Plain(index));
                index
            }
        }
    }

    fn push(&mut self, name: String, albedo: Rgb) -> usize {
        self.materials.push(Material {
            name,
            albedo,
            ..Material::default()
        });
        self.materials.len() - 1
    }
}

fn random(value: &super::value::Value<'_>, faults: &mut Faults<'_>) -> Option<Albedo> {
    let mut section = Section::within("albedo", value, faults)?;
    let seed = section.required("random", faults, whole(|_, _| Ok(())));
    section.close(faults);
    seed.map(|found| Albedo::Random(found.value))
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
