//! A ball as a bounding volume: does the ray come near enough?

use super::camera::Ray;
use super::divide::divide;
use super::real::Real;
use super::vector::{Vec3, dot_product};
use crate::layout::BallRecord;

/// Whether the ray meets the ball after t = 0. As [`super::sphere`], without the
/// roots; `docs/numerics.md` derives by how much a ball is larger than what it holds.
pub fn meets_ball<R: Real>(ray: Ray<R>, ball: &BallRecord<R>) -> bool {
    let f = ray.origin - Vec3::from(ball.center);
    let d = ray.direction;
    let a = dot_product(d, d);
    let b = -dot_product(f, d);
    let l = f + d * divide(b, a);
    let square = ball.radius * ball.radius;
    let ahead = b > R::ZERO || dot_product(f, f) <= square;
    ahead && dot_product(l, l) <= square
}
