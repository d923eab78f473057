//! What spheres, planes and disks are broken by, each in one way that real code is.

use rayproof::accuracy::Widths;
use rayproof::error::Result;
use rayproof::flat::Flat;
use rayproof::found::Found;
use rayproof::kernel::camera::{Ray, camera_ray};
use rayproof::kernel::real::Real;
use rayproof::kernel::trace::trace_pixel;
use rayproof::kernel::vector::{Vec3, dot_product, unit_vector};
use rayproof::layout::{Disk, NO_HIT, Pixel, Sphere};

use super::broken::{Broken, Formula, believing_all, by};
use super::broken_flat::{
    distance_form, only_beyond_is_rejected, parallel_unchecked, point_from_camera, rim_excluded,
    rim_with_tolerance, without_division,
};

/// For each case of these families that the textbook passes, what fails it.
pub fn broken_for(id: &str) -> Option<Broken> {
    let formula: Formula = match id {
        "sphere/away-from-camera" => expanded_square,
        "sphere/tangent" | "sphere/kissing" | "sphere/gap-between-shells" => small_discriminant,
        "sphere/growing" => scaled_to_unit,
        "sphere/shells" | "sphere/direction-powers" | "sphere/start-just-above" => fixed_least_t,
        "sphere/equal" | "flat/disk-in-plane" | "flat/equal-disks" => last_of_equals,
        "sphere/start-outward" | "sphere/start-inward" | "flat/start-on-plane" => zero_is_a_hit,
        "sphere/start-center" | "sphere/direction-1e10" => unit_length_taken,
        "sphere/direction-1e-30" => unit_length_taken,
        "sphere/start-abreast" => sign_of_zero,
        "sphere/behind" | "flat/behind" => behind_too,
        "sphere/origin-1e20" => overflow_unchecked,
        "sphere/smallest" => small_discriminant,
        "sphere/largest" => fixed_infinity,
        "flat/in-plane" | "flat/beyond-f32" => parallel_unchecked,
        "flat/edge-on" => only_beyond_is_rejected,
        "flat/plane-1e6" => distance_form,
        "flat/disk-1e6" => point_from_camera,
        "flat/rim" => rim_excluded,
        "flat/rim-ulp" | "flat/rim-aimed" => rim_with_tolerance,
        "flat/largest" => without_division,
        "sphere/ground-seen" => {
            return Some(Broken {
                picture: Some(root_of_the_rest),
                ..Broken::default()
            });
        }
        "sphere/center-1e20" | "sphere/radius-refused" => return Some(believing_all()),
        _ => return None,
    };
    Some(by(formula))
}

/// f32, and normals along root(r^2 - l.l) wherever the camera is.
fn root_of_the_rest(widths: &Widths) -> Result<Vec<Pixel>> {
    let flat = widths.double.converted::<f32>();
    let [width, height] = flat.size;
    let pixels = (0..height).flat_map(|y| (0..width).map(move |x| (x, y)));
    let pixels = pixels.map(|(x, y)| {
        let ray = camera_ray(&flat.camera, flat.size, x, y);
        let sphere = &flat.spheres[0];
        let [a, b, _] = terms(ray, sphere);
        let l = (ray.origin - Vec3::from(sphere.center)) + ray.direction * (b / a);
        let rest = sphere.radius * sphere.radius - dot_product(l, l);
        let normal = unit_vector(l - ray.direction * (rest / a).sqrt());
        Pixel {
            normal: normal.into(),
            ..trace_pixel(&flat, x, y)
        }
    });
    Ok(pixels.collect())
}

/// A shape of the families.
pub(super) enum Part<'a> {
    Sphere(&'a Sphere<f64>),
    Plane(Vec3<f64>, Vec3<f64>),
    Disk(&'a Disk<f64>),
}

/// All shapes, in the order of their ids.
fn parts(flat: &Flat<f64>) -> impl Iterator<Item = Part<'_>> {
    let planes = flat.planes.iter();
    let planes = planes.map(|plane| Part::Plane(plane.point.into(), plane.normal.into()));
    let disks = flat.disks.iter().map(Part::Disk);
    flat.spheres
        .iter()
        .map(Part::Sphere)
        .chain(planes)
        .chain(disks)
}

/// The nearest of all shapes; a miss is at infinity.
pub(super) fn closest(flat: &Flat<f64>, t_of: impl Fn(&Part<'_>) -> f64) -> Found {
    let mut found = Found::new(f64::INFINITY, NO_HIT);
    for (part, id) in parts(flat).zip(0..) {
        let t = t_of(&part);
        if t < found.t {
            found = Found { t, id };
        }
    }
    found
}

/// a, b and c of the sphere's equation a t^2 - 2 b t + c = 0.
fn terms<R: Real>(ray: Ray<R>, sphere: &Sphere<R>) -> [R; 3] {
    let f = ray.origin - Vec3::from(sphere.center);
    let d = ray.direction;
    let c = dot_product(f, f) - sphere.radius * sphere.radius;
    [dot_product(d, d), -dot_product(f, d), c]
}

/// Both roots, the lower one first; NaN where there are none.
fn roots<R: Real>([a, b, c]: [R; 3]) -> [R; 2] {
    let root = (b * b - a * c).sqrt();
    [(b - root) / a, (b + root) / a]
}

/// Where the ray crosses a plane, if it does.
pub(super) fn crossing<R: Real>(ray: Ray<R>, point: Vec3<R>, normal: Vec3<R>) -> R {
    dot_product(point - ray.origin, normal) / dot_product(ray.direction, normal)
}

/// t where the test accepts it, else a miss.
pub(super) fn only(accepted: bool, t: f64) -> f64 {
    if accepted { t } else { f64::INFINITY }
}

/// The first of the roots that is accepted, and of a flat shape its only one.
fn first_of(part: &Part<'_>, ray: Ray<f64>, accept: impl Fn(f64) -> bool) -> f64 {
    match part {
        Part::Sphere(sphere) => {
            let [near, far] = roots(terms(ray, sphere));
            if accept(near) {
                near
            } else {
                only(accept(far), far)
            }
        }
        Part::Plane(point, normal) => {
            let t = crossing(ray, *point, *normal);
            only(accept(t), t)
        }
        Part::Disk(disk) => {
            let t = crossing(ray, disk.center.into(), disk.normal.into());
            let limit = disk.radius * disk.radius;
            only(accept(t) && square_from_center(ray, disk, t) <= limit, t)
        }
    }
}

pub(super) fn square_from_center(ray: Ray<f64>, disk: &Disk<f64>, t: f64) -> f64 {
    let point = (ray.origin - Vec3::from(disk.center)) + ray.direction * t;
    dot_product(point, point)
}

/// A smallest t, whatever the scale.
fn fixed_least_t(flat: &Flat<f64>, ray: Ray<f64>) -> Found {
    closest(flat, |part| first_of(part, ray, |t| t > 1e-3))
}

/// A largest t, whatever the scale.
fn fixed_infinity(flat: &Flat<f64>, ray: Ray<f64>) -> Found {
    closest(flat, |part| first_of(part, ray, |t| t > 0.0 && t < 1e10))
}

/// t >= 0 in place of t > 0.
fn zero_is_a_hit(flat: &Flat<f64>, ray: Ray<f64>) -> Found {
    closest(flat, |part| first_of(part, ray, |t| t >= 0.0))
}

/// No look at the sign of t.
fn behind_too(flat: &Flat<f64>, ray: Ray<f64>) -> Found {
    closest(flat, |part| first_of(part, ray, |t| t.is_finite()))
}

/// t <= best in place of t < best.
fn last_of_equals(flat: &Flat<f64>, ray: Ray<f64>) -> Found {
    let mut found = Found::new(f64::INFINITY, NO_HIT);
    for (part, id) in parts(flat).zip(0..) {
        let t = first_of(&part, ray, |t| t > 0.0);
        if t < f64::INFINITY && t <= found.t {
            found = Found { t, id };
        }
    }
    found
}

/// The test of the spheres only.
fn sphere_by(flat: &Flat<f64>, t_of: impl Fn(&Sphere<f64>) -> f64) -> Found {
    closest(flat, |part| match part {
        Part::Sphere(sphere) => t_of(sphere),
        _ => f64::INFINITY,
    })
}

fn ahead([near, far]: [f64; 2]) -> f64 {
    if near > 0.0 {
        near
    } else {
        only(far > 0.0, far)
    }
}

/// A discriminant below a threshold counts as none.
fn small_discriminant(flat: &Flat<f64>, ray: Ray<f64>) -> Found {
    sphere_by(flat, |sphere| {
        let [a, b, c] = terms(ray, sphere);
        only(b * b - a * c > 1e-3, ahead(roots([a, b, c])))
    })
}

/// a = 1.
fn unit_length_taken(flat: &Flat<f64>, ray: Ray<f64>) -> Found {
    sphere_by(flat, |sphere| {
        let [_, b, c] = terms(ray, sphere);
        ahead(roots([1.0, b, c]))
    })
}

/// q = b + sign(b) root, where the sign of 0 is 0.
fn sign_of_zero(flat: &Flat<f64>, ray: Ray<f64>) -> Found {
    sphere_by(flat, |sphere| {
        let [a, b, c] = terms(ray, sphere);
        let sign = if b == 0.0 { 0.0 } else { b.signum() };
        let q = b + sign * (b * b - a * c).sqrt();
        ahead([(c / q).min(q / a), (c / q).max(q / a)])
    })
}

/// f32, and the ray scaled to a unit sphere.
fn scaled_to_unit(flat: &Flat<f64>, ray: Ray<f64>) -> Found {
    sphere_by(flat, |sphere| {
        let ray = ray.converted::<f32>();
        let scale = 1.0 / sphere.radius as f32;
        let center = Vec3::from(sphere.center.map(|x| x as f32));
        let scaled = Ray {
            origin: (ray.origin - center) * scale,
            direction: ray.direction * scale,
        };
        let unit = Sphere::new([0.0; 3], 1.0);
        ahead(roots(terms(scaled, &unit)).map(f64::from))
    })
}

/// f32, and |c|^2 - r^2 computed beforehand.
fn expanded_square(flat: &Flat<f64>, ray: Ray<f64>) -> Found {
    sphere_by(flat, |sphere| {
        let Ray { origin, direction } = ray.converted::<f32>();
        let center = Vec3::from(sphere.center.map(|x| x as f32));
        let radius = sphere.radius as f32;
        let beforehand = dot_product(center, center) - radius * radius;
        let c = dot_product(origin, origin) - 2.0 * dot_product(origin, center) + beforehand;
        let b = dot_product(center, direction) - dot_product(origin, direction);
        ahead(roots([dot_product(direction, direction), b, c]).map(f64::from))
    })
}

/// f32, and what is not below 0 is a hit: NaN too.
fn overflow_unchecked(flat: &Flat<f64>, ray: Ray<f64>) -> Found {
    let sphere = &flat.spheres[0];
    let rounded = Sphere::new(sphere.center.map(|x| x as f32), sphere.radius as f32);
    let [a, b, c] = terms(ray.converted::<f32>(), &rounded);
    // As where the equation is not divided by 2.
    let [a, b, c] = [a * a, a * b, a * c];
    let discriminant = b * b - a * c;
    let is_miss = discriminant < 0.0 || b < 0.0;
    let id = if is_miss { NO_HIT } else { 0 };
    Found::new(f64::from((b - discriminant.sqrt()) / a), id)
}
