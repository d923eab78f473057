//! The volumes around a shape, from the outermost in.

use serde::Serialize;

use super::candidates::place_of;
use crate::flat::{Flat, Kind};
use crate::kernel::aabb::clip_to_box;
use crate::kernel::balls::meets_bounding_ball;
use crate::kernel::camera::camera_ray;
use crate::kernel::probe::{Probe, probe_of};
use crate::kernel::screen::{is_on_tile, tile_of};
use crate::kernel::tree::children_of;
use crate::kernel::vector::Vec3;
use crate::layout::{BOX, EVERYTHING, LEAF, LEAF_KIND, leaf_parts};
use crate::oracle::ShapeKind;

/// The volumes that hold a shape.
#[derive(Debug, Clone, PartialEq, Serialize)]
pub struct Path {
    /// The shape.
    pub id: u32,
    /// From the outermost in; none where it lies in no volume.
    pub steps: Vec<Step>,
}

/// A volume on the way.
#[derive(Debug, Clone, PartialEq, Serialize)]
pub struct Step {
    /// What it is.
    pub volume: VolumeKind,
    /// Whether the ray meets it.
    pub met: bool,
    /// The t at which the ray enters a box; none for a ball, which is not measured.
    pub enter: Option<f32>,
    /// Where it leaves it. Less than `enter` where the box is missed.
    pub exit: Option<f32>,
}

/// The kinds of volumes.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Serialize)]
#[serde(rename_all = "lowercase")]
pub enum VolumeKind {
    /// An axis-aligned box.
    Box,
    /// A ball.
    Ball,
}

/// The volumes around a primitive, if there is such a one, as a pixel's ray meets them.
pub(super) fn path_to(flat: &Flat<f32>, id: u32, x: u32, y: u32) -> Option<Path> {
    if id >= flat.primitives() {
        return None;
    }
    let probe = probe_of(camera_ray(&flat.camera, flat.size, x, y));
    let (kind, row) = place_of(flat, id);
    let kind = match kind {
        ShapeKind::Sphere => Some(Kind::Sphere as u32),
        ShapeKind::Disk => Some(Kind::Disk as u32),
        ShapeKind::Triangle => Some(Kind::Triangle as u32),
        // No volume holds a plane.
        ShapeKind::Plane => None,
    };
    let steps = kind.map_or_else(Vec::new, |kind| {
        let mut steps = in_tree(flat, probe, kind, row);
        steps.extend(in_list(flat, probe, kind, row, tile_of(flat.size, x, y)));
        steps
    });
    Some(Path { id, steps })
}

/// A box as the ray meets it.
fn boxed(probe: Probe<f32>, low: Vec3<f32>, high: Vec3<f32>) -> Step {
    let interval = clip_to_box(probe.slabs, low, high);
    Step {
        volume: VolumeKind::Box,
        met: interval.enter <= interval.exit,
        enter: Some(interval.enter),
        exit: Some(interval.exit),
    }
}

/// From the leaf that has the row up to the root, then turned round.
fn in_tree(flat: &Flat<f32>, probe: Probe<f32>, kind: u32, row: u32) -> Vec<Step> {
    let children: Vec<_> = flat.pairs.iter().map(children_of).collect();
    let mut parents = vec![None; children.len()];
    let mut at = None;
    for (pair, two) in children.iter().enumerate() {
        for (child, is_left) in [(two.left, true), (two.right, false)] {
            if child & LEAF == 0 {
                parents[child as usize] = Some((pair, is_left));
                continue;
            }
            let (leaf_kind, count, first) = leaf_parts(child);
            if leaf_kind == kind && (first..first + count).contains(&row) {
                at = Some((pair, is_left));
            }
        }
    }
    let mut steps = Vec::new();
    while let Some((pair, is_left)) = at {
        let two = children[pair];
        steps.push(if is_left {
            boxed(probe, two.left_low, two.left_high)
        } else {
            boxed(probe, two.right_low, two.right_high)
        });
        at = parents[pair];
    }
    steps.reverse();
    steps
}

/// Those of the list that are not skipped before the run with the row.
fn in_list(flat: &Flat<f32>, probe: Probe<f32>, kind: u32, row: u32, tile: u32) -> Vec<Step> {
    let holds = |first: u32, count: u32| {
        let start = first & ((1 << LEAF_KIND) - 1);
        first >> LEAF_KIND == kind && (start..start + count).contains(&row)
    };
    let entries = flat.volumes.iter();
    let Some(place) = entries.clone().position(|v| holds(v.first, v.count)) else {
        return Vec::new();
    };
    let around = (0..).zip(entries.take(place + 1));
    around
        .filter(|(_, volume)| volume.bound != EVERYTHING && volume.skip as usize > place)
        .map(|(entry, volume)| {
            let mut step = if volume.bound & BOX == 0 {
                Step {
                    volume: VolumeKind::Ball,
                    met: meets_bounding_ball(flat, probe, volume.bound),
                    enter: None,
                    exit: None,
                }
            } else {
                let bounds = &flat.boxes[(volume.bound ^ BOX) as usize];
                boxed(probe, bounds.low.into(), bounds.high.into())
            };
            step.met = step.met && is_on_tile(flat, tile, entry);
            step
        })
        .collect()
}
