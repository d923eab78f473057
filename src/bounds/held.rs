//! What volumes must hold: every ray that a shape's rounded test accepts.

use glam::DVec3;

use super::ball::{Ball, bounding_ball};
use super::primitive_boxes;
use super::swept::ENDS;
use crate::flat::Flat;
use crate::kernel::aabb::Aabb;
use crate::kernel::disk_rows::disk_at;
use crate::kernel::real::Real;
use crate::kernel::sphere_rows::sphere_at;
use crate::kernel::triangle_rows::triangle_at;
use crate::layout::{BallRecord, BoxRecord};

/// A ball's padding in parts of its reach, the distance of its farthest point from the
/// camera: the error with which a shape's test accepts a ray, at most 16 roundings of
/// 2^-24, that of the ball's own test, as many, and as much again for the ball's
/// rounded centre and radius. `docs/numerics.md` derives it.
const PADDING: f64 = 64.0 / 16_777_216.0;

/// The same where shapes move: a place on the way is off the straight line by a rounding of the
/// way, at most the ball's radius, and one of the sum, in each coordinate; so are both ends.
/// By the inequality of the triangle that is 2 u of the reach for each of these.
const MOVING_PADDING: f64 = PADDING + 4.0 / 16_777_216.0;

/// What volumes must hold of each primitive.
pub(super) struct Held {
    /// By id: the corners of a triangle, a sphere or a disk as a ball three times. Where shapes
    /// move, they stand there as the shutter opens.
    balls: Vec<[Ball; 3]>,
    /// The same as it closes; empty where no shape moves. What holds a ball here and there,
    /// holds it on its way.
    closing: Vec<[Ball; 3]>,
    /// By id; none for a plane.
    boxes: Vec<Option<Aabb>>,
    /// A ball's padding, in parts of its reach.
    padding: f64,
}

impl Held {
    /// Of all primitives.
    pub(super) fn of<R: Real>(flat: &Flat<R>) -> Self {
        let count = flat.primitives() as usize;
        let [opens, closes] = ENDS;
        let mut held = Self {
            balls: balls_at(flat, 0.0),
            closing: Vec::new(),
            boxes: vec![None; count],
            padding: PADDING,
        };
        if flat.has_moving_shapes() {
            held.balls = balls_at(flat, opens);
            held.closing = balls_at(flat, closes);
            held.padding = MOVING_PADDING;
        }
        for (aabb, id) in primitive_boxes(flat) {
            held.boxes[id as usize] = Some(aabb);
        }
        held
    }

    fn balls_of(&self, ids: &[u32]) -> impl Iterator<Item = &Ball> {
        let closing = |id: u32| self.closing.get(id as usize).into_iter().flatten();
        ids.iter()
            .flat_map(move |&id| self.balls[id as usize].iter().chain(closing(id)))
    }

    /// The box of primitives: the union of their own boxes.
    pub(super) fn box_of(&self, ids: &[u32]) -> BoxRecord {
        let mut low = [f32::MAX; 3];
        let mut high = [f32::MIN; 3];
        for aabb in ids.iter().filter_map(|&id| self.boxes[id as usize]) {
            let (least, most): ([f32; 3], [f32; 3]) = (aabb.low.into(), aabb.high.into());
            for axis in 0..3 {
                low[axis] = low[axis].min(least[axis]);
                high[axis] = high[axis].max(most[axis]);
            }
        }
        BoxRecord {
            low,
            padding_0: 0.0,
            high,
            padding_1: 0.0,
        }
    }

    /// The tight ball of primitives, padded.
    pub(super) fn ball_of<R: Real>(&self, ids: &[u32]) -> BallRecord<R> {
        let items: Vec<Ball> = self.balls_of(ids).copied().collect();
        let (center, _) = bounding_ball(&items).unwrap_or_default();
        let center = center.to_array().map(R::from_f64);
        BallRecord {
            center,
            radius: R::from_f64(self.padded(self.radius_around(center, ids), center)),
        }
    }

    /// A ball that the scene gives: as it is where it holds its primitives with what
    /// rounding needs, a little larger where it just holds them, and as it is where it
    /// does not: then it cuts the picture, as it says.
    pub(super) fn settle_ball<R: Real>(&self, given: BallRecord<R>, ids: &[u32]) -> BallRecord<R> {
        let radius = self.radius_around(given.center, ids);
        let needed = self.padded(radius, given.center);
        let own = f64::from(given.radius.to_f32());
        let slack = needed - radius;
        if own >= needed || own + slack < radius {
            return given;
        }
        BallRecord {
            radius: R::from_f64(needed),
            ..given
        }
    }

    /// As [`Self::settle_ball`], for a box: it must hold the own boxes, which are padded.
    pub(super) fn settle_box(&self, given: BoxRecord, needed: BoxRecord) -> BoxRecord {
        let mut settled = given;
        for axis in 0..3 {
            let reach = needed.low[axis].abs().max(needed.high[axis].abs());
            // An own box is padded by a part of the sum over three axes.
            let slack = 4.0 * f64::from(reach) * self.padding;
            let just = |outside: f64| outside > 0.0 && outside <= slack;
            if just(f64::from(given.low[axis]) - f64::from(needed.low[axis])) {
                settled.low[axis] = needed.low[axis];
            }
            if just(f64::from(needed.high[axis]) - f64::from(given.high[axis])) {
                settled.high[axis] = needed.high[axis];
            }
        }
        settled
    }

    /// How far primitives reach from a centre, without padding.
    pub(super) fn radius_around<R: Real>(&self, center: [R; 3], ids: &[u32]) -> f64 {
        let center = DVec3::from(center.map(|x| f64::from(x.to_f32())));
        self.balls_of(ids).fold(0.0, |most, (at, radius)| {
            most.max(center.distance(*at) + radius)
        })
    }

    /// How far primitives stick out of a box, without padding; negative where they
    /// do not.
    pub(super) fn outside_box(&self, bounds: &BoxRecord, ids: &[u32]) -> f64 {
        let low = DVec3::from(bounds.low.map(f64::from));
        let high = DVec3::from(bounds.high.map(f64::from));
        self.balls_of(ids).fold(f64::MIN, |most, (at, radius)| {
            let below = (low - *at).max_element() + radius;
            let above = (*at - high).max_element() + radius;
            most.max(below).max(above)
        })
    }

    /// What rounding may take of primitives.
    pub(super) fn slack(&self, ids: &[u32]) -> f64 {
        self.radius_around([0.0; 3], ids) * self.padding
    }

    /// A radius with what rounding needs.
    fn padded<R: Real>(&self, radius: f64, center: [R; 3]) -> f64 {
        let distance = DVec3::from(center.map(|x| f64::from(x.to_f32()))).length();
        radius + (distance + radius) * self.padding
    }

    /// Cuts primitives in halves, along the axis along which they spread most.
    pub(super) fn halves<'i>(&self, ids: &'i mut [u32]) -> (&'i mut [u32], &'i mut [u32]) {
        let all = self.box_of(ids);
        let extent = |axis: usize| all.high[axis] - all.low[axis];
        let axis = (0..3).fold(0, |best, axis| {
            if extent(axis) > extent(best) {
                axis
            } else {
                best
            }
        });
        let twice_center = |id: &u32| {
            self.boxes[*id as usize].map_or(0.0, |aabb| {
                let center: [f32; 3] = (aabb.low + aabb.high).into();
                center[axis]
            })
        };
        // Ids settle ties, so that the cut does not depend on the order.
        ids.sort_unstable_by(|a, b| twice_center(a).total_cmp(&twice_center(b)).then(a.cmp(b)));
        ids.split_at_mut(ids.len() / 2)
    }
}

/// What volumes must hold of each primitive at a time, by its id.
fn balls_at<R: Real>(flat: &Flat<R>, time: f32) -> Vec<[Ball; 3]> {
    let mut balls = vec![[Ball::default(); 3]; flat.primitives() as usize];
    let point = |v: [R; 3]| DVec3::from(v.map(|x| f64::from(x.to_f32())));
    for (row, &id) in (0..).zip(&flat.sphere_ids) {
        let sphere = sphere_at(flat, row, time);
        balls[id as usize] = [(point(sphere.center), sphere.radius.to_f32().into()); 3];
    }
    for (row, &id) in (0..).zip(&flat.disk_ids) {
        let disk = disk_at(flat, row, time);
        balls[id as usize] = [(point(disk.center), disk.radius.to_f32().into()); 3];
    }
    for &corners in &flat.triangles {
        let triangle = triangle_at(flat, corners, time);
        let points = [triangle.a, triangle.b, triangle.c];
        balls[corners.id as usize] = points.map(|v| (point(v), 0.0));
    }
    balls
}
