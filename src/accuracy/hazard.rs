//! One scene, harder and harder.

use std::sync::Arc;

use glam::DVec3;

use crate::error::{Error, Result};
use crate::flatten::flatten;
use crate::scene::{Camera, Falloff, Geometry, GroupBound, Light, Mesh, Scene, Shape};

/// In which way a scene gets harder.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Hazard {
    /// The camera moves away, in radii of the scene, and its view narrows.
    Distance,
    /// Scene and camera move away from the origin, in radii of the scene.
    Offset,
    /// Scene and camera are scaled.
    Scale,
    /// Each triangle is cut in two, one of which is so many times thinner.
    Slivers,
}

/// How much larger than the scene the view is.
const ROOM: f64 = 1.05;

impl Hazard {
    /// Every way.
    pub const ALL: [Self; 4] = [Self::Distance, Self::Offset, Self::Scale, Self::Slivers];

    /// The name on the command line.
    pub fn name(self) -> &'static str {
        match self {
            Self::Distance => "distance",
            Self::Offset => "offset",
            Self::Scale => "scale",
            Self::Slivers => "slivers",
        }
    }

    /// The steps.
    pub fn levels(self) -> &'static [f64] {
        match self {
            Self::Distance => &[1.000_001, 10.0, 1e3, 1e4, 1e5, 1e6, 1e7],
            Self::Offset => &[0.0, 1e3, 1e6, 1e9],
            Self::Scale => &[1e-6, 1e-3, 1.0, 1e3, 1e6],
            Self::Slivers => &[10.0, 1e2, 1e4, 1e6],
        }
    }

    /// The scene at one of the steps.
    ///
    /// # Errors
    ///
    /// [`Error::Usage`] where the scene has nothing of which the hazard can be made.
    pub fn apply(self, scene: &Scene, level: f64) -> Result<Scene> {
        let mut scene = scene.clone();
        match self {
            Self::Distance => {
                let radius = radius_of(&scene)?;
                let camera = &mut scene.camera;
                let away = (camera.eye - camera.target).normalize();
                camera.eye = camera.target + away * (level * radius);
                camera.fov_degrees = 2.0 * half_view(level).to_degrees();
            }
            Self::Offset => {
                let offset = DVec3::ONE.normalize() * (level * radius_of(&scene)?);
                place_anew(&mut scene, 1.0, offset);
            }
            Self::Scale => place_anew(&mut scene, level, DVec3::ZERO),
            Self::Slivers => {
                let cut = scene
                    .shapes
                    .iter_mut()
                    .map(|shape| cut_triangles(shape, level));
                if cut.filter(|cut| *cut).count() == 0 {
                    return Err(Error::Usage(
                        "the hazard `slivers` needs a scene with triangles".into(),
                    ));
                }
            }
        }
        Ok(scene)
    }
}

/// Half the angle of a view of a ball from so many of its radii away, at most 45 degrees.
fn half_view(radii: f64) -> f64 {
    let tangent = ROOM / (radii * radii - 1.0).sqrt();
    tangent.min(1.0).atan()
}

/// The farthest point of any shape but planes, from where the camera looks.
fn radius_of(scene: &Scene) -> Result<f64> {
    let mut there = scene.clone();
    // Camera-relative coordinates are then those from the target.
    let camera: Camera = scene.camera;
    there.camera.eye = camera.target;
    there.camera.target = camera.target + (camera.target - camera.eye);
    let flat = flatten::<f64>(&there);
    let far = |center: [f64; 3], radius: f64| DVec3::from(center).length() + radius;
    let spheres = flat.spheres.iter().map(|s| far(s.center, s.radius));
    let disks = flat.disks.iter().map(|d| far(d.center, d.radius));
    let corners = flat.vertices.iter().map(|v| far(*v, 0.0));
    let radius = spheres.chain(disks).chain(corners).fold(0.0, f64::max);
    if radius > 0.0 {
        return Ok(radius);
    }
    Err(Error::Usage(
        "this hazard is measured in radii: it needs a sphere, a disk or a triangle".into(),
    ))
}

/// Scales and moves all that the scene holds, and the camera with it.
fn place_anew(scene: &mut Scene, scale: f64, offset: DVec3) {
    let place = |point: DVec3| point * scale + offset;
    scene.camera.eye = place(scene.camera.eye);
    scene.camera.target = place(scene.camera.target);
    for shape in &mut scene.shapes {
        shape.transform.linear *= scale;
        shape.transform.translate = place(shape.transform.translate);
    }
    for light in &mut scene.lights {
        if let Light::Point {
            position,
            color,
            falloff,
            ..
        } = light
        {
            *position = place(*position);
            if *falloff == Falloff::InverseSquare {
                *color = color.map(|channel| channel * scale * scale);
            }
        }
    }
    for group in &mut scene.groups {
        match &mut group.bound {
            GroupBound::Auto => {}
            GroupBound::Ball { center, radius } => {
                *center = place(*center);
                *radius *= scale;
            }
            GroupBound::Box { low, high } => {
                *low = place(*low);
                *high = place(*high);
            }
        }
    }
}

/// Cuts each triangle of a shape from its first corner; `false` where it has none. A mesh
/// loses its vertex normals.
fn cut_triangles(shape: &mut Shape, ratio: f64) -> bool {
    let whole = match &shape.geometry {
        Geometry::Triangle { vertices } => Mesh {
            positions: vertices.to_vec(),
            triangles: vec![[0, 1, 2]],
            ..Mesh::default()
        },
        Geometry::Mesh(mesh) => Mesh::clone(mesh),
        _ => return false,
    };
    let mut cut = Mesh {
        positions: whole.positions,
        triangle_materials: whole
            .triangle_materials
            .iter()
            .flat_map(|material| [*material; 2])
            .collect(),
        ..Mesh::default()
    };
    for [a, b, c] in whole.triangles {
        let [from, to] = [b, c].map(|vertex| cut.positions[vertex as usize]);
        let between = cut.positions.len() as u32;
        cut.positions.push(from + (to - from) / ratio);
        cut.triangles.extend([[a, b, between], [a, between, c]]);
    }
    shape.geometry = Geometry::Mesh(Arc::new(cut));
    true
}

#[cfg(test)]
mod tests {
    use super::*;

    fn scene(name: &str) -> Scene {
        let root = env!("CARGO_MANIFEST_DIR");
        Scene::load(format!("{root}/assets/scenes/{name}.toml")).unwrap()
    }

    #[test]
    fn every_level_of_every_hazard_is_a_scene() {
        for hazard in Hazard::ALL {
            for level in hazard.levels() {
                let scene = hazard.apply(&scene("seed-models"), *level).unwrap();
                scene
                    .validate()
                    .unwrap_or_else(|error| panic!("{hazard:?} {level}: {error}"));
            }
        }
        let spheres = scene("far-sphere");
        assert!(Hazard::Slivers.apply(&spheres, 10.0).is_err());
    }

    #[test]
    fn a_far_camera_sees_the_whole_scene() {
        let far = Hazard::Distance.apply(&scene("far-sphere"), 1e6).unwrap();
        let camera = far.camera;
        assert!((camera.eye.distance(camera.target) / 1e6 - 1.0).abs() < 1e-9);
        let half_height = 1e6 * (camera.fov_degrees.to_radians() / 2.0).tan();
        assert!((half_height - ROOM).abs() < 1e-6, "{half_height}");
    }

    #[test]
    fn cutting_changes_no_surface() {
        let whole = scene("seed-models");
        let cut = Hazard::Slivers.apply(&whole, 1e4).unwrap();
        let area = |scene: &Scene| -> f64 {
            let flat = flatten::<f64>(scene);
            let corner = |v: u32| DVec3::from(flat.vertices[v as usize]);
            let areas = flat.triangles.iter().map(|t| {
                let [a, b, c] = t.vertices.map(corner);
                (b - a).cross(c - a).length()
            });
            areas.sum()
        };
        assert!((area(&cut) / area(&whole) - 1.0).abs() < 1e-9);
        let count = |scene: &Scene| flatten::<f64>(scene).triangles.len();
        assert_eq!(count(&cut), 2 * count(&whole));
    }
}
