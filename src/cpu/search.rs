//! The nearest hit, by way of the tree of eight boxes a node.

use wide::f32x8;

use super::wide::{Node, WIDTH, Wide};
use crate::flat::{Flat, Kind};
use crate::kernel::aabb::Slabs;
use crate::kernel::doubt::{keep_nearer, limit_of, may_be_closest};
use crate::kernel::hit::{Hit, NO_TILE, no_hit};
use crate::kernel::planes::closest_plane;
use crate::kernel::probe::Probe;
use crate::kernel::real::{Real, constant};
use crate::kernel::trace::{find_hit, test_rows};
use crate::kernel::tree::any_hit;
use crate::kernel::triangles::meet_triangle;
use crate::layout::{LEAF, NO_HIT, leaf_parts};

/// A child that waits, and where the ray enters it.
type Waiting = (f32, u32);

/// What the search needs besides the scene: the tree, and a stack to use again.
pub struct Search<'a, R> {
    flat: &'a Flat<R>,
    wide: Option<&'a Wide<R>>,
    waiting: Vec<Waiting>,
    /// When shapes are looked for.
    pub(super) time: f32,
}

/// A ray's slabs, eight times each, and which plane of an axis it meets first.
struct Slabs8 {
    /// What low planes are measured from, then high ones.
    origins: [[f32x8; 2]; 3],
    inverse: [f32x8; 3],
    slack: f32x8,
    near: [usize; 3],
}

impl Slabs8 {
    fn new(slabs: Slabs) -> Self {
        let inverse: [f32; 3] = slabs.inverse.into();
        let (above, below): ([f32; 3], [f32; 3]) = (slabs.above.into(), slabs.below.into());
        Self {
            origins: [0, 1, 2].map(|axis| [above[axis], below[axis]].map(f32x8::splat)),
            slack: f32x8::splat(slabs.slack),
            inverse: inverse.map(f32x8::splat),
            near: inverse.map(|inverse| usize::from(inverse < 0.0)),
        }
    }

    /// Where the ray enters each box, and the boxes, a bit each, that it meets no later
    /// than at `limit`: [`crate::kernel::aabb::clip_to_box`] with the same roundings.
    #[inline]
    fn clip(&self, node: &Node, limit: f32x8) -> ([f32; WIDTH], u32) {
        let plane = |axis: usize, far: usize| {
            let side = self.near[axis] ^ far;
            let planes = f32x8::from(node.planes[axis][side]);
            (planes - self.origins[axis][side]) * self.inverse[axis]
        };
        let enter = plane(0, 0).fast_max(plane(1, 0)).fast_max(plane(2, 0));
        let enter = enter.fast_max(f32x8::ZERO);
        let exit = plane(0, 1).fast_min(plane(1, 1)).fast_min(plane(2, 1));
        let exit = exit * self.slack;
        let met = enter.simd_le(exit.fast_min(limit)).to_bitmask();
        (enter.to_array(), met)
    }
}

/// No smaller than t.
fn above<R: Real>(t: R) -> f32 {
    let near = t.to_f32();
    if constant::<R>(near) < t {
        near.next_up()
    } else {
        near
    }
}

impl<'a, R: Real> Search<'a, R> {
    /// With the tree made wide, if there is one.
    pub fn new(flat: &'a Flat<R>, wide: Option<&'a Wide<R>>) -> Self {
        Self {
            flat,
            wide,
            waiting: vec![(0.0, 0); wide.map_or(0, |wide| wide.waiting)],
            time: 0.0,
        }
    }

    /// The nearest of all primitives.
    pub fn closest(&mut self, probe: Probe<R>, hit: &mut Hit<R>) {
        match self.wide {
            None => find_hit(self.flat, probe, hit),
            Some(wide) => self.walk(wide, probe, hit, |_| false),
        }
    }

    /// Whether anything is met no later than at `limit`.
    pub fn any(&mut self, probe: Probe<R>, limit: R) -> bool {
        let mut hit = no_hit();
        hit.t = limit;
        hit.tile = NO_TILE;
        hit.time = self.time;
        match self.wide {
            None if !self.flat.pairs.is_empty() => {
                return any_hit(self.flat, probe, limit, &mut hit);
            }
            None => find_hit(self.flat, probe, &mut hit),
            Some(wide) => self.walk(wide, probe, &mut hit, |hit| hit.id != NO_HIT),
        }
        hit.id != NO_HIT
    }

    /// Visits what may be nearer than the hit, the nearest child of each node first,
    /// until nothing waits or `enough` is found.
    #[inline]
    fn walk(
        &mut self,
        wide: &Wide<R>,
        probe: Probe<R>,
        hit: &mut Hit<R>,
        enough: impl Fn(&Hit<R>) -> bool,
    ) {
        closest_plane(self.flat, probe, hit);
        let slabs = Slabs8::new(probe.slabs);
        let waiting = &mut self.waiting[..];
        let mut depth = 0;
        let mut at = 0;
        let mut limit = above(limit_of(*hit));
        loop {
            let mut next = None;
            if at & LEAF == 0 {
                let node = &wide.nodes[at as usize];
                let (enter, met) = slabs.clip(node, f32x8::splat(limit));
                next = sort_children(waiting, &mut depth, node, &enter, met);
            } else {
                test_leaf(self.flat, wide, probe, at, hit);
                if enough(hit) {
                    return;
                }
                limit = above(limit_of(*hit));
            }
            match next.or_else(|| next_waiting(waiting, &mut depth, limit)) {
                Some(next) => at = next,
                None => return,
            }
        }
    }
}

/// Has the children that were met wait, the nearer ones on top, but for the nearest,
/// which it gives.
#[inline]
fn sort_children(
    waiting: &mut [Waiting],
    depth: &mut usize,
    node: &Node,
    enter: &[f32; WIDTH],
    mut met: u32,
) -> Option<u32> {
    if met == 0 {
        return None;
    }
    let mut take = || {
        let place = met.trailing_zeros() as usize;
        met &= met - 1;
        (met, (enter[place], node.children[place]))
    };
    let (mut left, mut nearest) = take();
    let bottom = *depth;
    while left != 0 {
        let (still_left, mut other) = take();
        left = still_left;
        if other.0 < nearest.0 {
            std::mem::swap(&mut other, &mut nearest);
        }
        let mut gap = *depth;
        while gap > bottom && waiting[gap - 1].0 < other.0 {
            waiting[gap] = waiting[gap - 1];
            gap -= 1;
        }
        waiting[gap] = other;
        *depth += 1;
    }
    Some(nearest.1)
}

/// The last of those that wait which the ray still enters early enough.
#[inline]
fn next_waiting(waiting: &[Waiting], depth: &mut usize, limit: f32) -> Option<u32> {
    while *depth > 0 {
        *depth -= 1;
        let (enter, child) = waiting[*depth];
        if enter <= limit {
            return Some(child);
        }
    }
    None
}

#[inline]
fn test_leaf<R: Real>(
    flat: &Flat<R>,
    wide: &Wide<R>,
    probe: Probe<R>,
    leaf: u32,
    hit: &mut Hit<R>,
) {
    let (kind, count, first) = leaf_parts(leaf);
    if kind != Kind::Triangle as u32 {
        return test_rows(flat, probe, kind, first..first + count, hit);
    }
    let block = &wide.blocks[first as usize];
    let mut met = block.met(&probe);
    hit.tests += block.count;
    while met != 0 {
        let lane = met.trailing_zeros() as usize;
        met &= met - 1;
        let meeting = meet_triangle(probe, &block.triangle(lane));
        if may_be_closest(*hit, meeting) {
            keep_nearer(hit, meeting, block.ids[lane], block.first + lane as u32);
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::kernel::aabb::{Aabb, clip_to_box, slabs_of};
    use crate::kernel::camera::Ray;
    use crate::kernel::vector::{Vec3, vec3};

    /// A fixed sequence of numbers from -1 to 1, with zeros and equals among them.
    fn numbers() -> impl FnMut() -> f32 {
        let mut state = 1_u32;
        move || {
            state = state.wrapping_mul(1_664_525).wrapping_add(1_013_904_223);
            (state >> 24) as f32 / 128.0 - 1.0
        }
    }

    /// Eight boxes at once are clipped as one by one, bit for bit.
    #[test]
    fn eight_boxes_are_clipped_as_one() {
        let mut next = numbers();
        let mut vector = || vec3(next(), next(), next());
        let (mut met_at_all, mut missed) = (0, 0);
        for _ in 0..2000 {
            let direction = vector();
            let slabs = slabs_of(Ray {
                origin: vector(),
                direction,
            });
            let mut node = Node::empty();
            let boxes: Vec<Aabb> = (0..WIDTH - 1)
                .map(|place| {
                    let (a, b) = (vector(), vector());
                    let with = |of: fn(f32, f32) -> f32| Vec3 {
                        x: of(a.x, b.x),
                        y: of(a.y, b.y),
                        z: of(a.z, b.z),
                    };
                    let (low, high) = (with(f32::min), with(f32::max));
                    node.set(place, Aabb { low, high }, 0);
                    Aabb { low, high }
                })
                .collect();
            let limit = 1.5;
            let (enter, met) = Slabs8::new(slabs).clip(&node, f32x8::splat(limit));
            for (place, aabb) in boxes.iter().enumerate() {
                let one = clip_to_box(slabs, aabb.low, aabb.high);
                assert_eq!(enter[place], one.enter, "{slabs:?} {aabb:?}");
                let is_met = one.enter <= one.exit && one.enter <= limit;
                assert_eq!((met >> place) & 1 == 1, is_met, "{slabs:?} {aabb:?}");
                met_at_all += u32::from(is_met);
                missed += u32::from(!is_met);
            }
            // The place without a child.
            assert_eq!(met >> (WIDTH - 1), 0);
        }
        assert!(met_at_all > 1000 && missed > 1000, "{met_at_all} {missed}");
    }
}
