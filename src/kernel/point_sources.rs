//! Light from points.

use super::divide::square_root;
use super::hard_shadows::shadow_limit;
use super::sources::{Arriving, nothing_arriving};
use super::vector::{Vec3, dot_product};
use crate::layout::{LightRecord, WEAKENS};

/// What comes from a point light, which has no size.
pub fn arriving_from_point(lamp: &LightRecord, position: Vec3<f32>) -> Arriving {
    let goal = Vec3::from(lamp.vector);
    let towards = goal - position;
    let square = dot_product(towards, towards);
    if square == 0.0 {
        return nothing_arriving();
    }
    Arriving {
        towards,
        length: square_root(square),
        color: lamp.color.into(),
        square: if lamp.flags & WEAKENS == 0 {
            1.0
        } else {
            square
        },
        goal,
        limit: shadow_limit(lamp.flags, 1.0),
        ..nothing_arriving()
    }
}
