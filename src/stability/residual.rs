//! How far a point of a ray is from a shape, in two f64: it judges f64 too.

use crate::kernel::camera::Ray;
use crate::oracle::double::Double;
use crate::oracle::number::{Divide, Number, Vector, cross, difference, dot, vector};
use crate::oracle::shape::Shape;

/// The distance of the ray's point at `t` from the shape's surface: from the sphere, or from
/// the plane of a flat shape.
pub fn residual(shape: &Shape<'_>, ray: Ray<f64>, t: f64) -> f64 {
    if !t.is_finite() {
        return f64::INFINITY;
    }
    let o: Vector<Double> = vector(ray.origin.into());
    let d: Vector<Double> = vector(ray.direction.into());
    let t = Double::exact(t);
    let point: Vector<Double> = std::array::from_fn(|axis| o[axis].plus(&d[axis].times(&t)));
    match shape {
        Shape::Sphere(sphere) => {
            let f = difference(&point, &vector(sphere.center));
            let radius = Double::exact(sphere.radius);
            // |f| - r = (|f|^2 - r^2) / (|f| + r)
            let squares = dot(&f, &f).minus(&radius.times(&radius));
            let sum = dot(&f, &f).square_root().plus(&radius);
            squares.over(&sum).high.abs()
        }
        Shape::Plane(plane) => from_plane(&point, plane.point, &vector(plane.normal)),
        Shape::Disk(disk) => from_plane(&point, disk.center, &vector(disk.normal)),
        Shape::Triangle([a, b, c]) => {
            let a_vector = vector(*a);
            let edges = [b, c].map(|corner| difference(&vector(*corner), &a_vector));
            from_plane(&point, *a, &cross(&edges[0], &edges[1]))
        }
    }
}

fn from_plane(point: &Vector<Double>, of_plane: [f64; 3], normal: &Vector<Double>) -> f64 {
    let height = dot(&difference(point, &vector(of_plane)), normal);
    height.over(&dot(normal, normal).square_root()).high.abs()
}

/// B = |o| + t |d| + |c| + r, the lengths of which the numbers of a test are rounded.
pub fn reach(shape: &Shape<'_>, ray: Ray<f64>, t: f64) -> f64 {
    let length = |v: [f64; 3]| glam::DVec3::from(v).length();
    let of_shape = match shape {
        Shape::Sphere(sphere) => length(sphere.center) + sphere.radius,
        Shape::Plane(plane) => length(plane.point),
        Shape::Disk(disk) => length(disk.center) + disk.radius,
        Shape::Triangle(corners) => corners.map(length).into_iter().fold(0.0, f64::max),
    };
    length(ray.origin.into()) + t * length(ray.direction.into()) + of_shape
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::kernel::vector::vec3;
    use crate::layout::{Plane, Sphere};

    fn ray() -> Ray<f64> {
        Ray {
            origin: vec3(0.0, 0.0, 0.0),
            direction: vec3(0.0, 0.0, -2.0),
        }
    }

    #[test]
    fn a_point_off_the_surface_is_seen_in_f64_and_below() {
        let sphere = Sphere::new([0.0, 0.0, -4.0], 1.0);
        let shape = Shape::Sphere(&sphere);
        assert_eq!(residual(&shape, ray(), 1.5), 0.0);
        let off = 1.5 * (1.0 + f64::EPSILON);
        let expected = 2.0 * 1.5 * f64::EPSILON;
        assert!((residual(&shape, ray(), off) / expected - 1.0).abs() < 0.5);
        let plane = Plane {
            point: [0.0, 0.0, -4.0],
            padding_0: 0.0,
            normal: [0.0, 0.0, 3.0],
            padding_1: 0.0,
        };
        assert_eq!(residual(&Shape::Plane(&plane), ray(), 2.25), 0.5);
        let corners = [[-1.0, -1.0, -4.0], [1.0, -1.0, -4.0], [0.0, 1.0, -4.0]];
        assert_eq!(residual(&Shape::Triangle(corners), ray(), 1.75), 0.5);
    }
}
