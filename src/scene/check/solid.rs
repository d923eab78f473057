//! Rules for shapes, transforms and meshes.

use glam::{DMat3, DVec3};

use super::rule::{
    Flaw, MAX_MAGNITUDE, MIN_SIZE, Verdict, direction, flaw, number, point, require, size,
};
use crate::scene::{Geometry, Mesh, Transform};

/// Relative rounding error of the products and differences of two or three
/// vectors that stand below, 4 ulp: a result under it cannot be told from 0.
pub const CANCELLED: f64 = 4.0 * f64::EPSILON;

/// A matrix that flattens nothing: its columns are not shorter than
/// [`MIN_SIZE`], and its determinant is larger than the rounding
/// error of computing it (Hadamard's bound times a few ulp).
pub fn invertible(m: DMat3) -> Verdict {
    let columns = [m.x_axis, m.y_axis, m.z_axis];
    columns.iter().try_for_each(|&c| point("transform", c))?;
    let lengths = columns.map(DVec3::length);
    // A rotation rounds the length of a column by a few ulp.
    let long = lengths.iter().all(|&l| l >= MIN_SIZE * (1.0 - CANCELLED));
    let bound: f64 = lengths.iter().product();
    require(long && m.determinant().abs() > CANCELLED * bound, || {
        flaw(
            format!("the transform {m} is singular: it flattens the shape"),
            "singular",
            format!("use scales from {MIN_SIZE:e} and columns that span space"),
        )
    })
}

/// A rotation times one scale, so that a sphere stays a sphere: columns of one
/// length, at right angles, up to a few ulp for each of the at most 6 products
/// of rotations that made them.
pub fn similarity(m: DMat3) -> Verdict {
    invertible(m)?;
    let [x, y, z] = [m.x_axis, m.y_axis, m.z_axis];
    let square = x.length_squared();
    let slack = 6.0 * CANCELLED * square;
    let even = [
        y.length_squared() - square,
        z.length_squared() - square,
        x.dot(y),
        y.dot(z),
        z.dot(x),
    ];
    require(even.iter().all(|d| d.abs() <= slack), || {
        flaw(
            format!("the transform {m} is not a rotation with one scale"),
            "not a similarity",
            "use a mesh where a sphere or a disk is to be stretched or sheared",
        )
    })
}

/// A simple shape keeps its rules; returns the largest |x|, |y|, |z| on it. A
/// plane counts as its point.
pub fn geometry(shape: &Geometry) -> std::result::Result<DVec3, Flaw> {
    match *shape {
        Geometry::Sphere { center, radius } => {
            point("center", center)?;
            size("radius", radius)?;
            Ok(center.abs() + DVec3::splat(radius))
        }
        Geometry::Plane { point: p, normal } => {
            point("point", p)?;
            direction("normal", normal)?;
            Ok(p.abs())
        }
        Geometry::Disk {
            center,
            normal,
            radius,
        } => {
            point("center", center)?;
            direction("normal", normal)?;
            size("radius", radius)?;
            Ok(center.abs() + DVec3::splat(radius))
        }
        Geometry::Triangle { vertices } => {
            vertices.iter().try_for_each(|&v| point("vertices", v))?;
            area(vertices)?;
            Ok(vertices.iter().fold(DVec3::ZERO, |e, v| e.max(v.abs())))
        }
        Geometry::Mesh(ref shared) => extent(shared),
    }
}

/// A triangle whose corners are not on one line: the cross product of its edges
/// is larger than its own rounding error.
pub fn area([a, b, c]: [DVec3; 3]) -> Verdict {
    let (ab, ac) = (b - a, c - a);
    let doubled = ab.cross(ac).length();
    require(doubled > CANCELLED * ab.length() * ac.length(), || {
        flaw(
            format!("the triangle {a}, {b}, {c} has no area"),
            "corners on one line",
            "move one corner off the line through the other two",
        )
    })
}

/// The largest |x|, |y|, |z| of a mesh, all of them numbers.
pub fn extent(mesh: &Mesh) -> std::result::Result<DVec3, Flaw> {
    let mut extent = DVec3::ZERO;
    for (i, &p) in mesh.positions.iter().enumerate() {
        point("position", p).map_err(|f| f.at(&format!("vertex {i}")))?;
        extent = extent.max(p.abs());
    }
    Ok(extent)
}

/// A mesh refers only to what it and a scene with so many materials have;
/// returns its [`extent`].
pub fn mesh(mesh: &Mesh, materials: usize) -> std::result::Result<DVec3, Flaw> {
    let extent = extent(mesh)?;
    for (i, &n) in mesh.normals.iter().enumerate() {
        direction("normal", n).map_err(|f| f.at(&format!("vertex normal {i}")))?;
    }
    indices("vertex", &mesh.triangles, mesh.positions.len())?;
    indices("vertex normal", &mesh.triangle_normals, mesh.normals.len())?;
    for (i, uv) in mesh.uvs.iter().enumerate() {
        uv.iter()
            .try_for_each(|&x| number("uv", x))
            .map_err(|f| f.at(&format!("texture coordinates {i}")))?;
    }
    indices("texture coordinates", &mesh.triangle_uvs, mesh.uvs.len())?;
    let triangles = mesh.triangles.len();
    one_each("triangle_normals", mesh.triangle_normals.len(), triangles)?;
    one_each("triangle_uvs", mesh.triangle_uvs.len(), triangles)?;
    one_each(
        "triangle_materials",
        mesh.triangle_materials.len(),
        triangles,
    )?;
    let wrong = mesh
        .triangle_materials
        .iter()
        .position(|&m| m as usize >= materials);
    match wrong {
        Some(i) => {
            let index = mesh.triangle_materials[i] as usize;
            Err(Flaw::index("material", index, materials).at(&format!("triangle {i}")))
        }
        None => Ok(extent),
    }
}

fn indices(what: &str, triangles: &[[u32; 3]], count: usize) -> Verdict {
    for (i, triangle) in triangles.iter().enumerate() {
        if let Some(&index) = triangle.iter().find(|&&index| index as usize >= count) {
            return Err(Flaw::index(what, index as usize, count).at(&format!("triangle {i}")));
        }
    }
    Ok(())
}

fn one_each(what: &str, found: usize, triangles: usize) -> Verdict {
    require(found == 0 || found == triangles, || {
        flaw(
            format!("{what} has {found} entries for {triangles} triangles"),
            "wrong count",
            "give one entry a triangle, or none at all",
        )
    })
}

/// A shape whose points have at most the given |x|, |y|, |z| stays within
/// [`MAX_MAGNITUDE`] of the world's origin.
pub fn within_reach(extent: DVec3, transform: &Transform) -> Verdict {
    let world = transform.linear.abs() * extent + transform.translate.abs();
    require(world.max_element() <= MAX_MAGNITUDE, || {
        flaw(
            format!(
                "the shape reaches {:e} from the origin, beyond {MAX_MAGNITUDE:e}",
                world.max_element()
            ),
            "too far out",
            "use smaller coordinates or a smaller scale",
        )
    })
}
