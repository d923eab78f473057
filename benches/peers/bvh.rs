//! The crate `bvh`.

use bvh::aabb::{Aabb, Bounded};
use bvh::bounding_hierarchy::BHShape;
use bvh::bvh::Bvh;
use bvh::ray::Ray;
use nalgebra::{Point3, Vector3};

use crate::Trace;

struct Triangle {
    corners: [Point3<f32>; 3],
    id: u32,
    node: usize,
}

impl Bounded<f32, 3> for Triangle {
    fn aabb(&self) -> Aabb<f32, 3> {
        let [a, b, c] = self.corners;
        Aabb::empty().grow(&a).grow(&b).grow(&c)
    }
}

impl BHShape<f32, 3> for Triangle {
    fn set_bh_node_index(&mut self, index: usize) {
        self.node = index;
    }
    fn bh_node_index(&self) -> usize {
        self.node
    }
}

/// It names all triangles whose boxes the ray meets; each is tested.
pub fn bvh(triangles: &[rayproof::layout::Triangle<f32>]) -> Trace<'_> {
    let corners = triangles.iter().map(|t| [t.a, t.b, t.c].map(Point3::from));
    let mut triangles: Vec<_> = corners
        .zip(0..)
        .map(|(corners, id)| Triangle {
            corners,
            id,
            node: 0,
        })
        .collect();
    let bvh = Bvh::build(&mut triangles);
    Box::new(move |rays, found| {
        for (ray, found) in rays.iter().zip(found) {
            let (origin, direction) = (ray.origin, ray.direction);
            let direction = Vector3::new(direction.x, direction.y, direction.z);
            let length = direction.norm();
            let ray = Ray::new(Point3::new(origin.x, origin.y, origin.z), direction);
            *found = (f32::INFINITY, u32::MAX);
            for triangle in bvh.traverse_iterator(&ray, &triangles) {
                let [a, b, c] = &triangle.corners;
                let t = ray.intersects_triangle(a, b, c).distance / length;
                if t < found.0 {
                    *found = (t, triangle.id);
                }
            }
        }
    })
}
