//! The known ways in which a textbook's formulas go wrong.

use super::candidates::place_of;
use super::words::brief;
use crate::flat::Flat;
use crate::kernel::camera::{Ray, camera_ray};
use crate::kernel::real::{Real, constant};
use crate::kernel::triangle_textbook::EDGE_ON;
use crate::kernel::triangles::triangle_of;
use crate::kernel::vector::{Vec3, cross_product, dot_product, vec3};
use crate::layout::Sphere;
use crate::oracle::ShapeKind;
use crate::tier::Textbook;

/// Why the textbook misses a shape, or meets it, if that is wrong in a known way.
pub(super) fn fault(flat: &Flat<Textbook>, [x, y]: [u32; 2], id: u32) -> Option<String> {
    let ray = camera_ray(&flat.camera, flat.size, x, y);
    match place_of(flat, id) {
        (ShapeKind::Sphere, row) => cancelled(ray, &flat.spheres[row as usize]),
        (ShapeKind::Triangle, row) => edge_on(flat, ray, row as usize),
        _ => None,
    }
}

/// b^2 - 4ac on the wrong side of zero.
fn cancelled(ray: Ray<Textbook>, sphere: &Sphere<Textbook>) -> Option<String> {
    // As `sphere_textbook` has it.
    let f = ray.origin - Vec3::from(sphere.center);
    let a = dot_product(ray.direction, ray.direction);
    let b = Textbook::TWO * dot_product(f, ray.direction);
    let c = dot_product(f, f) - sphere.radius * sphere.radius;
    let square = b * b;
    let computed = square - constant::<Textbook>(4.0) * a * c;
    // Where nothing large cancels, of the same numbers.
    let [f, d] = [f, ray.direction].map(|v| vec3(v.x.to_f64(), v.y.to_f64(), v.z.to_f64()));
    let across = cross_product(f, d);
    let radius = sphere.radius.to_f64();
    let exact = 4.0 * (dot_product(d, d) * (radius * radius) - dot_product(across, across));
    let turned = (computed < Textbook::ZERO) != (exact < 0.0);
    turned.then(|| {
        format!(
            "b^2 - 4ac comes out as {} where it is {}, since both terms are about {}, and there \
             numbers of f32 are {} apart",
            brief(computed.to_f64()),
            brief(exact),
            brief(square.to_f64()),
            brief((square.0.next_up() - square.0).into())
        )
    })
}

/// A determinant below the absolute limit.
fn edge_on(flat: &Flat<Textbook>, ray: Ray<Textbook>, row: usize) -> Option<String> {
    let triangle = triangle_of(flat, flat.triangles[row]);
    let a = Vec3::from(triangle.a);
    let across = cross_product(ray.direction, Vec3::from(triangle.c) - a);
    let determinant = dot_product(Vec3::from(triangle.b) - a, across).abs();
    (determinant < constant(EDGE_ON)).then(|| {
        format!(
            "its determinant, {:.1e}, is below the textbook's limit of {EDGE_ON:e}, so it counts \
             as seen edge-on",
            determinant.0
        )
    })
}
