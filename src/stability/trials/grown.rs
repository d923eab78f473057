//! Trees over boxes that no shape has: they are grown, and hold what they should.

use crate::bounds::validate;
use crate::error::Result;
use crate::flat::Kind;
use crate::kernel::aabb::Aabb;
use crate::stability::case::Trial;
use crate::stability::subject::Subject;
use crate::stability::tally::{Tally, must};

/// Lists of boxes, each for a tree.
pub struct Grown(pub Vec<Vec<Aabb>>);

/// Spheres and triangles in turn, so that leaves have to be kept apart.
pub fn kind_of(id: u32) -> Kind {
    if id.is_multiple_of(3) {
        Kind::Sphere
    } else {
        Kind::Triangle
    }
}

impl Trial for Grown {
    fn run(&self, on: &dyn Subject) -> Result<Tally> {
        let mut tally = Tally::default();
        for boxes in &self.0 {
            let items: Vec<(Aabb, u32)> = boxes.iter().copied().zip(0..).collect();
            let tree = on.grow(items.clone());
            let is_broken = validate(&tree, &items, &kind_of).is_err();
            tally.count([must(!is_broken)]);
        }
        Ok(tally)
    }
}
