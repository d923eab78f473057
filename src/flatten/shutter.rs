//! What happens while the shutter is open: through which places of the lens light comes, and
//! how far things go.

use std::ops::Range;

use glam::DVec3;

use super::{camera_axes, turn};
use crate::flat::Flat;
use crate::layout::LensRecord;
use crate::scene::{Camera, Geometry, Shape};

/// The lens of a camera.
pub(super) fn lens(camera: &Camera) -> LensRecord {
    let [right, up, _] = camera_axes(camera);
    let radius = camera.aperture / 2.0;
    let distance = camera.target.distance(camera.eye);
    let focus = camera.focus.unwrap_or(distance);
    let axis = |axis: DVec3| axis.as_vec3().to_array();
    LensRecord {
        right: axis(right * radius),
        radius: radius as f32,
        up: axis(up * radius),
        turn_right: axis(right * (radius / focus)),
        turn_up: axis(up * (radius / focus)),
        ..LensRecord::default()
    }
}

/// How far a shape goes while the shutter is open; none where it stands still. A plane only
/// goes along its normal: what is along itself changes nothing, and its point stays the foot
/// of the perpendicular from the camera.
pub(super) fn velocity_of(shape: &Shape) -> Option<[f32; 3]> {
    let velocity = match shape.geometry {
        Geometry::Plane { normal, .. } => {
            let normal = turn(normal, &shape.transform);
            normal * shape.velocity.dot(normal)
        }
        _ => shape.velocity,
    };
    let velocity = velocity.as_vec3().to_array();
    (velocity != [0.0; 3]).then_some(velocity)
}

/// Has the primitives with these ids go as their shape does.
pub(super) fn push_velocity<R>(flat: &mut Flat<R>, shape: &Shape, ids: Range<u32>) {
    let Some(velocity) = velocity_of(shape) else {
        return;
    };
    flat.velocities.push(velocity);
    let row = flat.velocities.len() as u32;
    flat.velocity_rows.resize(ids.start as usize, 0);
    flat.velocity_rows.resize(ids.end as usize, row);
}
