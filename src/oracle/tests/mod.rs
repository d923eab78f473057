//! The oracle against what whole numbers tell, against itself and against the kernel.

mod adversary;
mod known;
mod margins;
mod pictures;
mod widths;

use super::Oracle;
use crate::flat::Flat;
use crate::flatten::flatten;
use crate::kernel::camera::Ray;
use crate::layout::{Corners, Disk, Plane, Sphere};
use crate::random::Numbers;
use crate::scene::Scene;

/// A scene made by hand, in the order of the ids: spheres, planes, disks, triangles.
struct Shapes(Flat<f64>);

impl Shapes {
    fn none() -> Self {
        let mut flat = flatten::<f64>(&Scene::default());
        flat.spheres.clear();
        flat.sphere_ids.clear();
        flat.planes.clear();
        flat.disks.clear();
        flat.disk_ids.clear();
        flat.triangles.clear();
        flat.vertices.clear();
        flat.material_indices.clear();
        Self(flat)
    }

    fn next_id(&mut self) -> u32 {
        self.0.material_indices.push(0);
        self.0.material_indices.len() as u32 - 1
    }

    fn sphere(mut self, center: [f64; 3], radius: f64) -> Self {
        let id = self.next_id();
        self.0.sphere_ids.push(id);
        self.0.spheres.push(Sphere::new(center, radius));
        self
    }

    fn plane(mut self, point: [f64; 3], normal: [f64; 3]) -> Self {
        self.next_id();
        self.0.planes.push(Plane {
            point,
            normal,
            ..Plane::default()
        });
        self
    }

    fn disk(mut self, center: [f64; 3], normal: [f64; 3], radius: f64) -> Self {
        let id = self.next_id();
        self.0.disk_ids.push(id);
        self.0.disks.push(Disk {
            center,
            normal,
            radius,
            padding: 0.0,
        });
        self
    }

    fn triangle(mut self, corners: [[f64; 3]; 3]) -> Self {
        let id = self.next_id();
        let first = self.0.vertices.len() as u32;
        self.0.vertices.extend(corners);
        self.0.triangles.push(Corners {
            vertices: [first, first + 1, first + 2],
            id,
        });
        self
    }

    fn oracle(&self) -> Oracle<'_> {
        Oracle::new(&self.0)
    }
}

fn ray(origin: [f64; 3], direction: [f64; 3]) -> Ray<f64> {
    Ray {
        origin: origin.into(),
        direction: direction.into(),
    }
}

/// What these tests ask of numbers beyond what there is.
trait Draw {
    fn point(&mut self, reach: f64) -> [f64; 3];
    /// A whole number from -`most` to `most`.
    fn whole(&mut self, most: u64) -> f64;
}

impl Draw for Numbers {
    fn point(&mut self, reach: f64) -> [f64; 3] {
        self.vector(reach).to_array()
    }

    fn whole(&mut self, most: u64) -> f64 {
        (self.next() % (2 * most + 1)) as f64 - most as f64
    }
}
