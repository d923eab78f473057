//! Every shape that may be the closest, as each tier and the oracle have it.

use std::collections::BTreeSet;
use std::ops::Range;

use serde::Serialize;

use super::truth::Truths;
use super::words::Story;
use super::{ROUNDINGS, finite};
use crate::accuracy::errors::ulps_off;
use crate::flat::Flat;
use crate::found::Found;
use crate::oracle::{Candidate, Oracle, ShapeKind, Truth};
use crate::scene::{Geometry, Scene};
use crate::tier::Accuracy;

/// A shape that a tier or the oracle meets, or that is in doubt.
#[derive(Debug, Clone, PartialEq, Serialize)]
pub struct CandidateFacts {
    /// Its id, as the layer `id` shows it.
    pub id: u32,
    /// Its kind.
    pub kind: ShapeKind,
    /// The number of the shape in the scene, meshes included, counted from 0 in the order
    /// of the scene; none if it is a lamp.
    pub shape: Option<usize>,
    /// The number of the lamp among those that have a size, counted from 0; none if it is a
    /// shape.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub lamp: Option<usize>,
    /// The number of the triangle in its mesh, counted from 0.
    pub triangle: Option<u32>,
    /// The name of its material; none if it is a lamp.
    pub material: Option<String>,
    /// Where the ray meets it, exactly; none if it misses it.
    pub t: Option<f64>,
    /// By how many roundings of f32 the ray is from missing it, if it meets it; from meeting
    /// it, and then negative, if it misses it.
    pub margin: Option<f64>,
    /// What the tiers of one pass make of it.
    pub meetings: Vec<MeetingFacts>,
    /// Where it is, for all that the adaptive tier's first pass can tell; none if it is
    /// missed for certain.
    pub interval: Option<Interval>,
}

/// Where a tier meets a shape.
#[derive(Debug, Clone, PartialEq, Serialize)]
pub struct MeetingFacts {
    /// The tier.
    pub accuracy: Accuracy,
    /// Where; none if it misses it.
    pub t: Option<f64>,
    /// By how many ulp of f32 that is off the exact t of the scene in f64.
    pub error: Option<f64>,
    /// By how many it is off what is exact for the numbers that the tier is given: what the
    /// intersection alone adds.
    pub intersection_error: Option<f64>,
}

/// The ends of what t may be.
#[derive(Debug, Clone, Copy, PartialEq, Serialize)]
pub struct Interval {
    /// No sooner than here.
    pub low: f64,
    /// No later than here; none if it may be missed.
    pub high: Option<f64>,
}

/// The tiers of one pass.
const ONE_PASS: [Accuracy; 4] = [
    Accuracy::Textbook,
    Accuracy::Robust,
    Accuracy::Extended,
    Accuracy::Double,
];

/// All candidates, the nearest first. `ids` are those of each shape of the scene, then of each
/// lamp.
pub(super) fn candidates(
    scene: &Scene,
    ids: &[Range<u32>],
    story: &Story<'_>,
) -> Vec<CandidateFacts> {
    let seen = story.seen.all().flat_map(|view| view.meetings.keys());
    let all: BTreeSet<u32> = seen.chain(&story.exact.order).copied().collect();
    let mut candidates: Vec<_> = all
        .into_iter()
        .map(|id| candidate(scene, ids, story, id))
        .collect();
    // By id before, and this keeps the order of what is equal.
    candidates.sort_by(|a, b| earliest(a).total_cmp(&earliest(b)));
    candidates
}

/// Where the ray meets it, or else where a tier first has it.
fn earliest(facts: &CandidateFacts) -> f64 {
    let seen = facts.meetings.iter().filter_map(|meeting| meeting.t);
    let low = facts.interval.map(|interval| interval.low);
    let first = seen.chain(low).fold(f64::INFINITY, f64::min);
    facts.t.unwrap_or(first)
}

fn candidate(scene: &Scene, ids: &[Range<u32>], story: &Story<'_>, id: u32) -> CandidateFacts {
    let flat = &story.widths.double;
    let (kind, row) = place_of(flat, id);
    let place = ids.iter().position(|ids| ids.contains(&id)).unwrap_or(0);
    let shape = scene.shapes.get(place);
    let is_mesh = shape.is_some_and(|shape| matches!(shape.geometry, Geometry::Mesh(_)));
    let material = flat.material_indices[id as usize] as usize;
    let nearness = Oracle::new(flat).shape(kind, row).1.nearness(story.ray);
    let exact = story.exact.met.get(&id);
    let meeting = |accuracy| {
        let (view, truths) = story.decides(accuracy);
        let off = |t: Option<f64>, truths: &Truths| Some(ulps(t?, truths.met.get(&id)?));
        let t = view.t_of(id);
        MeetingFacts {
            accuracy,
            t,
            error: off(t, story.exact),
            intersection_error: off(view.rounded_t_of(id), truths),
        }
    };
    let interval = story.seen.first_pass.meetings.get(&id);
    CandidateFacts {
        id,
        kind,
        shape: shape.map(|_| place),
        lamp: place.checked_sub(scene.shapes.len()),
        triangle: is_mesh.then(|| id - ids[place].start),
        material: scene
            .materials
            .get(material)
            .map(|found| found.name.clone()),
        t: exact.map(|exact| exact.t),
        margin: finite(nearness.slack * ROUNDINGS),
        meetings: ONE_PASS.into_iter().map(meeting).collect(),
        interval: interval.map(|meeting| Interval {
            low: meeting.low,
            high: finite(meeting.high),
        }),
    }
}

/// Kind and row of a primitive.
pub(super) fn place_of<R>(flat: &Flat<R>, id: u32) -> (ShapeKind, u32) {
    let row = |ids: &[u32]| ids.iter().position(|other| *other == id).unwrap_or(0) as u32;
    if id < flat.first_plane() {
        (ShapeKind::Sphere, row(&flat.sphere_ids))
    } else if id < flat.first_disk() {
        (ShapeKind::Plane, id - flat.first_plane())
    } else if id < flat.first_triangle() {
        (ShapeKind::Disk, row(&flat.disk_ids))
    } else {
        let place = flat.triangles.iter().position(|corners| corners.id == id);
        (ShapeKind::Triangle, place.unwrap_or(0) as u32)
    }
}

/// By how many ulp of f32 a t is off.
pub(super) fn ulps(t: f64, exact: &Candidate) -> f64 {
    let truth = Truth {
        id: exact.id,
        row: exact.row,
        t: exact.t,
        t_rest: exact.t_rest,
        margin: 0.0,
    };
    ulps_off(&Found::new(t, exact.id), &truth)
}
