//! Where the outlines of volumes are seen.

use std::hash::{DefaultHasher, Hash, Hasher};

use rayon::prelude::*;

use crate::flat::Flat;
use crate::kernel::aabb::{Aabb, clip_to_box};
use crate::kernel::ball::meets_ball;
use crate::kernel::camera::camera_ray;
use crate::kernel::probe::{Probe, probe_of};
use crate::kernel::real::Real;
use crate::kernel::tree::children_of;
use crate::kernel::vector::Vec3;
use crate::layout::{BOX, BallRecord, EVERYTHING, LEAF};

/// Volumes whose outlines are drawn at most: more would hide the picture.
const MOST: usize = 100;

/// A volume to be drawn.
enum Shown<R> {
    Ball(BallRecord<R>),
    Box(Aabb),
}

impl<R: Real> Shown<R> {
    fn is_met(&self, probe: &Probe<R>) -> bool {
        match self {
            Self::Ball(ball) => meets_ball(probe.ray, ball),
            Self::Box(aabb) => {
                let interval = clip_to_box(probe.slabs, aabb.low, aabb.high);
                interval.enter <= interval.exit
            }
        }
    }
}

/// Of each pixel, row by row, whether an outline runs through it: its ray meets other
/// volumes than that of the pixel to the left or above. Of many volumes, the outermost
/// are drawn.
pub fn outlines<R: Real>(flat: &Flat<R>) -> Vec<bool> {
    let shown = if flat.pairs.is_empty() {
        of_list(flat)
    } else {
        of_tree(flat)
    };
    let [width, height] = flat.size.map(|side| side as usize);
    let seen: Vec<u64> = (0..width * height)
        .into_par_iter()
        .map(|index| {
            let (x, y) = ((index % width) as u32, (index / width) as u32);
            let probe = probe_of(camera_ray(&flat.camera, flat.size, x, y));
            let mut hasher = DefaultHasher::new();
            for volume in &shown {
                volume.is_met(&probe).hash(&mut hasher);
            }
            hasher.finish()
        })
        .collect();
    let differs = |index: usize| {
        let has_left = !index.is_multiple_of(width);
        let left = has_left && seen[index - 1] != seen[index];
        left || index >= width && seen[index - width] != seen[index]
    };
    (0..width * height).map(differs).collect()
}

/// The volumes of the list, level by level.
fn of_list<R: Real>(flat: &Flat<R>) -> Vec<Shown<R>> {
    let mut bounds = Vec::new();
    let everything = 0..flat.volumes.len() as u32;
    let mut level = vec![everything];
    while !level.is_empty() && bounds.len() < MOST {
        let mut below = Vec::new();
        for entries in level {
            let mut entry = entries.start;
            while entry < entries.end {
                let volume = flat.volumes[entry as usize];
                bounds.extend((volume.bound != EVERYTHING).then_some(volume.bound));
                below.push(entry + 1..volume.skip);
                entry = volume.skip;
            }
        }
        below.retain(|entries| !entries.is_empty());
        level = below;
    }
    let shown = |bound: u32| {
        if bound & BOX == 0 {
            return Shown::Ball(flat.balls[bound as usize]);
        }
        let record = flat.boxes[(bound ^ BOX) as usize];
        Shown::Box(Aabb {
            low: Vec3::from(record.low),
            high: Vec3::from(record.high),
        })
    };
    bounds.into_iter().take(MOST).map(shown).collect()
}

/// The boxes of the pairs, level by level.
fn of_tree<R: Real>(flat: &Flat<R>) -> Vec<Shown<R>> {
    let mut shown = Vec::new();
    let mut level = vec![0];
    while !level.is_empty() && shown.len() + 2 * level.len() <= MOST {
        let mut below = Vec::new();
        for pair in level {
            let children = children_of(&flat.pairs[pair as usize]);
            for (low, high, child) in [
                (children.left_low, children.left_high, children.left),
                (children.right_low, children.right_high, children.right),
            ] {
                shown.push(Shown::Box(Aabb { low, high }));
                below.extend((child & LEAF == 0).then_some(child));
            }
        }
        level = below;
    }
    shown
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::bounds::{Bounds, bound};
    use crate::flatten::flatten;
    use crate::scene::Scene;

    fn outlined(bounds: Bounds) -> Vec<bool> {
        let file = concat!(
            env!("CARGO_MANIFEST_DIR"),
            "/assets/scenes/seed-spheres.toml"
        );
        let mut flat = flatten::<f32>(&Scene::load(file).unwrap().with_size(200, 200));
        bound(&mut flat, bounds);
        outlines(&flat)
    }

    fn count(outlines: &[bool]) -> usize {
        outlines.iter().filter(|outline| **outline).count()
    }

    #[test]
    fn balls_have_thin_outlines() {
        let outlines = outlined(Bounds::Scene);
        // Balls end within the picture: no outline along its edge.
        assert!(outlines[..150].iter().all(|outline| !outline));
        // Two circles of a radius of 38 pixels, at most two pixels thick.
        let pixels = count(&outlines);
        assert!((400..1000).contains(&pixels), "{pixels}");
        assert_eq!(count(&outlined(Bounds::None)), 0);
    }

    /// More than can be drawn: those of both groups are.
    #[test]
    fn the_outermost_are_drawn() {
        let deep = Bounds::Spheres { levels: 5 };
        for bounds in [Bounds::Boxes { levels: 1 }, deep, Bounds::Tree] {
            let outlines = outlined(bounds);
            let (upper, lower) = outlines.split_at(outlines.len() / 2);
            assert!(count(upper) > 100 && count(lower) > 100, "{bounds:?}");
        }
    }
}
