//! A cone of rays from the camera: those of a tile of the screen.

use super::divide::{divide, square_root};
use super::real::{Real, constant};
use super::vector::{Vec3, cross_product, dot_product, unit_vector, vector_length};
use crate::layout::BallRecord;

/// The sine from which on a cone is so wide that it meets everything.
pub const WIDE: f32 = 0.7;

/// What is added to a cone's sine, and to a ball's radius in parts of its reach: above
/// the roundings of rays, cones and this test, at most 20 of 2^-24.
pub const CONE_SLACK: f32 = 32.0 / 16_777_216.0;

/// All directions within an angle of the axis.
#[derive(Debug, Clone, Copy)]
pub struct Cone<R> {
    /// Unit length.
    pub axis: Vec3<R>,
    /// Of the angle; [`WIDE`] or more for a cone that meets everything.
    pub sine: R,
    /// Of the angle.
    pub cosine: R,
}

/// The larger of the sine so far and that of the direction's angle to the axis.
fn widened_sine<R: Real>(sine: R, axis: Vec3<R>, direction: Vec3<R>) -> R {
    if dot_product(axis, direction) <= R::ZERO {
        return constant(1.0);
    }
    let across = divide(
        vector_length(cross_product(axis, direction)),
        vector_length(direction),
    );
    if across > sine { across } else { sine }
}

/// The cone around four rays, the corners of a tile; all rays between them are in it.
pub fn cone_around<R: Real>(a: Vec3<R>, b: Vec3<R>, c: Vec3<R>, d: Vec3<R>) -> Cone<R> {
    let axis = unit_vector((a + b) + (c + d));
    let mut sine = R::ZERO;
    sine = widened_sine(sine, axis, a);
    sine = widened_sine(sine, axis, b);
    sine = widened_sine(sine, axis, c);
    sine = widened_sine(sine, axis, d) + constant(CONE_SLACK);
    if sine >= constant(WIDE) {
        return Cone {
            axis,
            sine,
            cosine: R::ZERO,
        };
    }
    Cone {
        axis,
        sine,
        cosine: square_root(constant::<R>(1.0) - sine * sine),
    }
}

/// Whether a ray of the cone may come near enough to the ball.
pub fn cone_meets_ball<R: Real>(cone: &Cone<R>, ball: &BallRecord<R>) -> bool {
    let c = Vec3::from(ball.center);
    let along = dot_product(cone.axis, c);
    let across = vector_length(cross_product(cone.axis, c));
    let distance = across * cone.cosine - along * cone.sine;
    let reach = ((c.x.abs() + c.y.abs()) + c.z.abs()) + ball.radius;
    cone.sine >= constant(WIDE) || distance <= ball.radius + reach * constant(CONE_SLACK)
}
