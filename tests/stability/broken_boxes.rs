//! Tests of boxes that are broken on purpose, each in one way.

use rayproof::bounds::primitive_boxes;
use rayproof::flat::Flat;
use rayproof::found::Found;
use rayproof::kernel::aabb::Aabb;
use rayproof::kernel::camera::Ray;
use rayproof::kernel::hit::no_hit;
use rayproof::kernel::probe::probe_of;
use rayproof::kernel::trace::test_rows;
use rayproof::tier::Textbook;

use super::broken::rightly;

/// Whether a ray may meet a box, in f32: a start, a direction, low and high.
pub type Slabs = fn([f32; 3], [f32; 3], Aabb) -> bool;

/// Of a scene with a tree, only what tight boxes let through.
pub fn culled(flat: &Flat<f64>, ray: Ray<f64>, slabs: Slabs) -> Found {
    if flat.pairs.is_empty() {
        return rightly(flat, ray);
    }
    let [origin, direction] = [ray.origin, ray.direction].map(|v| v.to_f32().into());
    let mut hit = no_hit();
    for (aabb, id) in primitive_boxes(&flat.converted::<Textbook>()) {
        if slabs(origin, direction, aabb) {
            let (kind, row) = flat.kind_of(id);
            test_rows(flat, probe_of(ray), kind as u32, row..row + 1, &mut hit);
        }
    }
    Found::at(hit).unwrap()
}

/// The ends of the interval, given those of each slab.
fn ends(slab: impl Fn(usize) -> [f32; 2]) -> [f32; 2] {
    let slabs = [slab(0), slab(1), slab(2)];
    [
        slabs.iter().fold(0.0, |most, slab| slab[0].max(most)),
        slabs
            .iter()
            .fold(f32::INFINITY, |least, slab| slab[1].min(least)),
    ]
}

fn in_order([a, b]: [f32; 2]) -> [f32; 2] {
    [a.min(b), a.max(b)]
}

fn planes_of(aabb: Aabb) -> [[f32; 2]; 3] {
    let (low, high): ([f32; 3], [f32; 3]) = (aabb.low.into(), aabb.high.into());
    [0, 1, 2].map(|axis| [low[axis], high[axis]])
}

/// One multiplication and one addition a plane: b / d - o / d.
pub fn cancelling(o: [f32; 3], d: [f32; 3], aabb: Aabb) -> bool {
    let planes = planes_of(aabb);
    let [enter, exit] = ends(|axis| {
        let inverse = 1.0 / d[axis];
        in_order(planes[axis].map(|plane| plane * inverse - o[axis] * inverse))
    });
    enter <= exit
}

/// 0 times infinity, and comparisons that are false.
pub fn nan_culls(o: [f32; 3], d: [f32; 3], aabb: Aabb) -> bool {
    let planes = planes_of(aabb);
    (0..3).all(|axis| {
        let [a, b] = planes[axis].map(|plane| (plane - o[axis]) * (1.0 / d[axis]));
        a <= b || b <= a
    }) && {
        let [enter, exit] =
            ends(|axis| in_order(planes[axis].map(|plane| (plane - o[axis]) * (1.0 / d[axis]))));
        enter <= exit
    }
}

/// The near plane is told by d < 0, of which -0 is none; 1 / -0 is below 0.
pub fn near_by_sign(o: [f32; 3], d: [f32; 3], aabb: Aabb) -> bool {
    let planes = planes_of(aabb);
    let [enter, exit] = ends(|axis| {
        let [low, high] = planes[axis].map(|plane| (plane - o[axis]) * (1.0 / d[axis]));
        if d[axis] < 0.0 {
            [high, low]
        } else {
            [low, high]
        }
    });
    enter <= exit
}

/// Flat boxes are entered where they are left.
pub fn never_enters_flat(o: [f32; 3], d: [f32; 3], aabb: Aabb) -> bool {
    let planes = planes_of(aabb);
    let [enter, exit] =
        ends(|axis| in_order(planes[axis].map(|plane| (plane - o[axis]) * (1.0 / d[axis]))));
    enter < exit
}

/// A box has to be entered ahead.
pub fn not_from_within(o: [f32; 3], d: [f32; 3], aabb: Aabb) -> bool {
    let planes = planes_of(aabb);
    let [enter, exit] =
        ends(|axis| in_order(planes[axis].map(|plane| (plane - o[axis]) * (1.0 / d[axis]))));
    enter <= exit && enter > 0.0
}
