//! The rules that a scene keeps, each stated once: the parser puts a line and a
//! column to a [`Flaw`], [`super::Scene::validate`] an index.

use glam::{DMat3, DVec3};

use crate::scene::{Geometry, Mesh, Rgb, Transform};

/// Largest magnitude of a number in a scene. Squares in f32 overflow above
/// 1.8e19, which leaves four decades for sums and scales; and up to it neighbouring f64
/// values lie at most an eighth apart, so that subtracting the camera's position
/// still leaves a meaningful difference.
pub const MAX_MAGNITUDE: f64 = 1e15;

/// Largest width or height of a picture: pixel numbers then fit 30 bits and a
/// sample position is exact in f32.
pub const MAX_IMAGE_SIDE: u64 = 32768;

/// Sine of the smallest angle between `up` and the line of sight. Rounding
/// leaves their f64 cross product (differences, products, sums) with a relative
/// error below 3 sqrt(3) 2^-53 over that sine; at 2^-26 the camera's horizontal
/// axis still has the 24 bits of an f32.
const MIN_UP_SINE: f64 = 1.0 / (1u64 << 26) as f64;

/// Relative rounding error of the products and differences of two or three
/// vectors that stand below, 4 ulp: a result under it cannot be told from 0.
const CANCELLED: f64 = 4.0 * f64::EPSILON;

/// What breaks a rule.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Flaw {
    /// What is wrong, with the value.
    pub message: String,
    /// A word under the underline.
    pub label: &'static str,
    /// What would be right.
    pub help: String,
}

/// Does a value keep a rule?
pub type Verdict = std::result::Result<(), Flaw>;

impl Flaw {
    pub(super) fn index(what: &str, index: usize, count: usize) -> Self {
        flaw(
            format!("{what} {index} does not exist"),
            "no such index",
            format!("there are {count}, counted from 0"),
        )
    }
}

fn flaw(message: String, label: &'static str, help: impl Into<String>) -> Flaw {
    Flaw {
        message,
        label,
        help: help.into(),
    }
}

fn require(holds: bool, flaw: impl FnOnce() -> Flaw) -> Verdict {
    if holds { Ok(()) } else { Err(flaw()) }
}

/// A finite number of a magnitude that f32 arithmetic can square.
pub fn number(what: &str, x: f64) -> Verdict {
    require(x.is_finite(), || {
        let message = format!("`{what}` must be a finite number, but is {x}");
        flaw(message, "not finite", "write a plain number such as 1.5")
    })?;
    require(x.abs() <= MAX_MAGNITUDE, || {
        flaw(
            format!("`{what}` is {x:e}, beyond {MAX_MAGNITUDE:e}"),
            "too large",
            format!("keep magnitudes up to {MAX_MAGNITUDE:e}, where f32 squares cannot overflow"),
        )
    })
}

/// A number greater than 0.
pub fn positive(what: &str, x: f64) -> Verdict {
    number(what, x)?;
    require(x > 0.0, || {
        let message = format!("`{what}` must be greater than 0, but is {x}");
        flaw(message, "not positive", "write a number greater than 0")
    })
}

/// A number that is 0 or more.
pub fn not_negative(what: &str, x: f64) -> Verdict {
    number(what, x)?;
    require(x >= 0.0, || {
        let message = format!("`{what}` must not be negative, but is {x}");
        flaw(message, "negative", "write 0 or more")
    })
}

/// A factor of a scale: any number but 0.
pub fn factor(what: &str, x: f64) -> Verdict {
    number(what, x)?;
    require(x != 0.0, || {
        let message = format!("`{what}` must not be 0: the shape would have no size");
        flaw(message, "zero", "write 1 to keep the size")
    })
}

/// A full angle of view in degrees, between 0 and 180.
pub fn field_of_view(what: &str, degrees: f64) -> Verdict {
    require(degrees > 0.0 && degrees < 180.0, || {
        let message = format!("`{what}` must lie between 0 and 180 degrees, but is {degrees}");
        flaw(message, "out of range", "60 is a usual full vertical angle")
    })
}

/// The width or height of a picture in pixels.
pub fn image_side(what: &str, pixels: u64) -> Verdict {
    require((1..=MAX_IMAGE_SIDE).contains(&pixels), || {
        flaw(
            format!("`{what}` must be from 1 to {MAX_IMAGE_SIDE} pixels, but is {pixels}"),
            "out of range",
            format!("pictures up to {MAX_IMAGE_SIDE} x {MAX_IMAGE_SIDE} can be rendered"),
        )
    })
}

/// A position: three numbers.
pub fn point(what: &str, p: DVec3) -> Verdict {
    p.to_array().iter().try_for_each(|&x| number(what, x))
}

/// A vector of any length but 0. A length whose square underflows counts as 0:
/// it cannot be normalised.
pub fn direction(what: &str, v: DVec3) -> Verdict {
    point(what, v)?;
    require(v.length_squared() >= f64::MIN_POSITIVE, || {
        flaw(
            format!("`{what}` is {v}, which points nowhere"),
            "zero length",
            "write a vector of any length but 0, such as [0, 1, 0]",
        )
    })
}

/// A linear colour: no part negative.
pub fn color(what: &str, rgb: Rgb) -> Verdict {
    rgb.iter().try_for_each(|&x| not_negative(what, x))
}

/// A fraction of light per channel.
pub fn albedo(what: &str, rgb: Rgb) -> Verdict {
    rgb.iter().try_for_each(|&x| {
        number(what, x)?;
        require((0.0..=1.0).contains(&x), || {
            let message = format!("`{what}` must lie between 0 and 1, but has a part of {x}");
            let help = "a surface scatters no less than none and no more than all of the light";
            flaw(message, "out of range", help)
        })
    })
}

/// The camera looks somewhere.
pub fn line_of_sight(eye: DVec3, target: DVec3) -> Verdict {
    require((target - eye).length_squared() >= f64::MIN_POSITIVE, || {
        flaw(
            format!("`target` {target} is where `eye` is: the camera looks nowhere"),
            "same as eye",
            "move `target` to the point in the middle of the picture",
        )
    })
}

/// `up` is not along the line of sight, so the picture has a horizontal.
pub fn upward(up: DVec3, forward: DVec3) -> Verdict {
    let (up_length, forward_length) = (up.length(), forward.length());
    let sine = (up / up_length).cross(forward / forward_length).length();
    require(sine >= MIN_UP_SINE, || {
        flaw(
            format!("`up` {up} is parallel to the line of sight {forward}"),
            "parallel to the line of sight",
            "choose another `up`, such as [0, 0, 1] for a camera that looks straight down",
        )
    })
}

/// A matrix that flattens nothing: its determinant is larger than the rounding
/// error of computing it (Hadamard's bound times a few ulp).
pub fn invertible(m: DMat3) -> Verdict {
    for column in [m.x_axis, m.y_axis, m.z_axis] {
        point("transform", column)?;
    }
    let bound = m.x_axis.length() * m.y_axis.length() * m.z_axis.length();
    require(m.determinant().abs() > CANCELLED * bound, || {
        flaw(
            format!("the transform {m} is singular: it flattens the shape"),
            "singular",
            "use a scale without 0 and columns that span space",
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
            positive("radius", radius)?;
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
            positive("radius", radius)?;
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
    let triangles = mesh.triangles.len();
    one_each("triangle_normals", mesh.triangle_normals.len(), triangles)?;
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

impl Flaw {
    fn at(mut self, place: &str) -> Self {
        self.message = format!("{place}: {}", self.message);
        self
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
