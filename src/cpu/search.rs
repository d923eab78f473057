//! The nearest hit, by way of the tree of eight boxes a node.

use wide::f32x8;

use super::wide::{Node, WIDTH, Wide, leaf_parts};
use crate::flat::{Flat, Kind};
use crate::kernel::aabb::{SLACK, Slabs};
use crate::kernel::hit::{Hit, keep_nearer, may_be_closest};
use crate::kernel::planes::closest_plane;
use crate::kernel::probe::Probe;
use crate::kernel::real::Real;
use crate::kernel::trace::{find_hit, test_row};
use crate::kernel::triangles::meet_triangle;
use crate::layout::LEAF;

/// A child that waits, and where the ray enters it.
type Waiting = (f32, u32);

/// What the search needs besides the scene: the tree, and a stack to use again.
pub struct Search<'a, R> {
    flat: &'a Flat<R>,
    wide: Option<&'a Wide<R>>,
    waiting: Vec<Waiting>,
}

/// A ray's slabs, eight times each, and which plane of an axis it meets first.
struct Slabs8 {
    origin: [f32x8; 3],
    inverse: [f32x8; 3],
    near: [usize; 3],
}

impl Slabs8 {
    fn new(slabs: Slabs) -> Self {
        let inverse: [f32; 3] = slabs.inverse.into();
        Self {
            origin: <[f32; 3]>::from(slabs.origin).map(f32x8::splat),
            inverse: inverse.map(f32x8::splat),
            near: inverse.map(|inverse| usize::from(inverse < 0.0)),
        }
    }

    /// Where the ray enters each box, and the boxes, a bit each, that it meets no later
    /// than at `limit`: [`crate::kernel::aabb::clip_to_box`] with the same roundings.
    #[inline]
    fn clip(&self, node: &Node, limit: f32x8) -> ([f32; WIDTH], u32) {
        let plane = |axis: usize, far: usize| {
            let planes = f32x8::from(node.planes[axis][self.near[axis] ^ far]);
            (planes - self.origin[axis]) * self.inverse[axis]
        };
        let enter = plane(0, 0).fast_max(plane(1, 0)).fast_max(plane(2, 0));
        let enter = enter.fast_max(f32x8::ZERO);
        let exit = plane(0, 1).fast_min(plane(1, 1)).fast_min(plane(2, 1));
        let exit = exit * f32x8::splat(SLACK);
        let met = enter.simd_le(exit.fast_min(limit)).to_bitmask();
        (enter.to_array(), met)
    }
}

/// No smaller than t.
fn above<R: Real>(t: R) -> f32 {
    let near = t.to_f32();
    if R::from_f64(f64::from(near)) < t {
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
        }
    }

    /// The nearest of all primitives.
    pub fn find(&mut self, probe: Probe<R>, hit: &mut Hit<R>) {
        let Some(wide) = self.wide else {
            return find_hit(self.flat, probe, hit);
        };
        closest_plane(self.flat, probe, hit);
        let slabs = Slabs8::new(probe.slabs);
        let waiting = &mut self.waiting[..];
        let mut depth = 0;
        let mut at = 0;
        let mut limit = above(hit.t);
        loop {
            if at & LEAF == 0 {
                let node = &wide.nodes[at as usize];
                let (enter, mut met) = slabs.clip(node, f32x8::splat(limit));
                if met != 0 {
                    let nearest = met.trailing_zeros() as usize;
                    met &= met - 1;
                    let mut next = (enter[nearest], node.children[nearest]);
                    let bottom = depth;
                    while met != 0 {
                        let place = met.trailing_zeros() as usize;
                        met &= met - 1;
                        let mut other = (enter[place], node.children[place]);
                        if other.0 < next.0 {
                            std::mem::swap(&mut other, &mut next);
                        }
                        // The nearest of those that wait comes last.
                        let mut gap = depth;
                        while gap > bottom && waiting[gap - 1].0 < other.0 {
                            waiting[gap] = waiting[gap - 1];
                            gap -= 1;
                        }
                        waiting[gap] = other;
                        depth += 1;
                    }
                    at = next.1;
                    continue;
                }
            } else {
                self::test_leaf(self.flat, wide, probe, at, hit);
                limit = above(hit.t);
            }
            loop {
                if depth == 0 {
                    return;
                }
                depth -= 1;
                let (enter, child) = waiting[depth];
                if enter <= limit {
                    at = child;
                    break;
                }
            }
        }
    }
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
        for row in first..first + count {
            test_row(flat, probe, kind, row, hit);
        }
        return;
    }
    let block = &wide.blocks[first as usize];
    let mut met = block.met(&probe);
    hit.tests += block.count - met.count_ones();
    while met != 0 {
        let lane = met.trailing_zeros() as usize;
        met &= met - 1;
        let t = meet_triangle(probe, &block.triangle(lane));
        if may_be_closest(hit, t) {
            keep_nearer(hit, t, block.ids[lane], block.first + lane as u32);
        }
    }
}
