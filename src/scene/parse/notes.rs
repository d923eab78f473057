//! What f32 cannot tell of a scene that is in order.

use serde::Serialize;

use crate::accuracy::BAND;
use crate::scene::{Geometry, Scene, Shape};

/// Something to know of a scene that is no fault.
#[derive(Debug, Clone, PartialEq, Serialize)]
pub struct Note {
    /// The line of the shape's header, from 1.
    pub line: usize,
    /// What there is to know, and what to do.
    pub message: String,
}

/// A note for each table of spheres or disks that f32 cannot resolve from the camera.
pub(super) fn notes(scene: &Scene) -> Vec<Note> {
    let mut notes = Vec::new();
    let origins = &scene.origins.shapes;
    let mut first = 0;
    for table in origins.chunk_by(|a, b| a.line == b.line) {
        let shapes = &scene.shapes[first..first + table.len()];
        first += table.len();
        let radii = shapes.iter().filter_map(|shape| {
            let (radius, distance) = size_and_distance(shape, scene)?;
            // The lengths of a test are the way to the shape and the place of its centre. A
            // ray through the centre is clear of the rim by the radius: within the band,
            // there is no ray on which f32 has to be right.
            (radius < BAND * (2.0 * distance)).then_some(distance / radius)
        });
        let (Some(farthest), Some(line)) = (radii.reduce(f64::max), table[0].line) else {
            continue;
        };
        let name = shapes[0].geometry.name();
        notes.push(Note {
            line: line as usize,
            message: format!(
                "the {name} is {farthest:.1e} radii away from the camera, where f32 cannot tell \
                 hit from miss: add `--accuracy adaptive`"
            ),
        });
    }
    notes
}

/// Of a sphere or a disk.
fn size_and_distance(shape: &Shape, scene: &Scene) -> Option<(f64, f64)> {
    let (Geometry::Sphere { center, radius } | Geometry::Disk { center, radius, .. }) =
        shape.geometry
    else {
        return None;
    };
    let transform = &shape.transform;
    let from_eye = transform.translate - scene.camera.eye;
    let scale = transform.linear.determinant().abs().cbrt();
    Some((
        radius * scale,
        (transform.linear * center + from_eye).length(),
    ))
}
