//! Formulas for triangles and boxes that are broken on purpose, each in one way that real code
//! is, and the cases that each of them fails.

use glam::DVec3;
use rayproof::bounds::ball::bounding_ball;
use rayproof::bounds::tree::{Node, Tree};
use rayproof::flat::Flat;
use rayproof::found::Found;
use rayproof::kernel::aabb::Aabb;
use rayproof::kernel::camera::Ray;
use rayproof::kernel::hit::no_hit;
use rayproof::kernel::probe::probe_of;
use rayproof::kernel::trace::test_rows;
use rayproof::layout::NO_HIT;

use super::broken::{Broken, Formula, believing_all, by, rightly};
use super::broken_boxes::{
    cancelling, culled, nan_culls, near_by_sign, never_enters_flat, not_from_within,
};

/// For each case of triangles and boxes that the textbook passes, what fails it.
pub fn broken_for(id: &str) -> Option<Broken> {
    let formula: Formula = match id {
        "triangle/grid" | "triangle/along-edges" | "bounds/in-a-face" => without_edges,
        "triangle/no-area" | "triangle/in-plane" | "triangle/denormal" => without_zero_check,
        "triangle/nearly-collinear" | "triangle/edge-on" => with_tolerance,
        "triangle/huge" => to_far_plane,
        "triangle/on-it" => from_behind,
        "triangle/edge-products" => contracted,
        "triangle/twice" | "bounds/equal-shapes" => last_wins,
        "bounds/negative-zero" => |flat, ray| culled(flat, ray, near_by_sign),
        "bounds/denormal-direction" => |flat, ray| culled(flat, ray, nan_culls),
        "bounds/flat" => |flat, ray| culled(flat, ray, never_enters_flat),
        "bounds/start-on-face" => |flat, ray| culled(flat, ray, not_from_within),
        "bounds/edges-and-corners"
        | "bounds/far-start"
        | "bounds/touching-spheres"
        | "bounds/long-thin"
        | "bounds/neighbours"
        | "bounds/all-scales" => |flat, ray| culled(flat, ray, cancelling),
        "bounds/tight-sphere" | "bounds/tight-box" | "bounds/tight-tile" => in_tight_ball,
        "bounds/equal-centroids" => of_a_full_leaf,
        "triangle/not-a-number" => return Some(believing_all()),
        "bounds/odd-boxes" => {
            return Some(Broken {
                grow: Some(one_leaf),
                ..Broken::default()
            });
        }
        _ => return None,
    };
    Some(by(formula))
}

/// The nearest of what a test finds of each triangle.
fn nearest(flat: &Flat<f64>, ray: Ray<f64>, test: impl Fn([DVec3; 3]) -> Option<f64>) -> Found {
    let mut nearest = Found::new(f64::INFINITY, NO_HIT);
    let origin = DVec3::from(<[f64; 3]>::from(ray.origin));
    for triangle in &flat.triangles {
        let at = |vertex: u32| DVec3::from(flat.vertices[vertex as usize]) - origin;
        let found = test(triangle.vertices.map(at)).map(|t| Found::new(t, triangle.id));
        if let Some(found) = found
            && !(found.t > nearest.t || found.t == nearest.t && found.id > nearest.id)
        {
            nearest = found;
        }
    }
    nearest
}

/// The edge functions, from the origin on, and t.
fn edges(ray: Ray<f64>, [a, b, c]: [DVec3; 3]) -> ([f64; 3], f64) {
    let d = DVec3::from(<[f64; 3]>::from(ray.direction));
    let normal = (b - a).cross(c - a);
    let sides = [c.cross(b).dot(d), a.cross(c).dot(d), b.cross(a).dot(d)];
    (sides, normal.dot(a) / normal.dot(d))
}

/// Whether all are of one sign, as a comparison has it.
fn one_sign(sides: [f64; 3], is_above: impl Fn(f64) -> bool) -> bool {
    sides.iter().all(|side| is_above(*side)) || sides.iter().all(|side| is_above(-side))
}

/// `>` where `>=` is due: edges belong to no triangle.
fn without_edges(flat: &Flat<f64>, ray: Ray<f64>) -> Found {
    nearest(flat, ray, |corners| {
        let (sides, t) = edges(ray, corners);
        (one_sign(sides, |side| side > 0.0) && t > 0.0).then_some(t)
    })
}

/// Divides by a determinant of 0, and rules out rather than in.
fn without_zero_check(flat: &Flat<f64>, ray: Ray<f64>) -> Found {
    nearest(flat, ray, |corners| {
        let [a, b, c] = corners.map(|corner| corner.as_vec3());
        let d = DVec3::from(<[f64; 3]>::from(ray.direction)).as_vec3();
        let across = d.cross(c - a);
        let inverse = 1.0 / (b - a).dot(across);
        let along = (-a).cross(b - a);
        let [u, v] = [(-a).dot(across) * inverse, d.dot(along) * inverse];
        let t = (c - a).dot(along) * inverse;
        let is_out = u < 0.0 || v < 0.0 || u + v > 1.0 || t <= 0.0;
        (!is_out).then_some(f64::from(t))
    })
}

/// Closes gaps by edges that are 1e-3 wider.
fn with_tolerance(flat: &Flat<f64>, ray: Ray<f64>) -> Found {
    nearest(flat, ray, |corners| {
        let (sides, t) = edges(ray, corners);
        let size = 1.0 + sides.iter().map(|side| side.abs()).sum::<f64>();
        (one_sign(sides, |side| side > -1e-3 * size) && t > 0.0).then_some(t)
    })
}

/// Sees nothing beyond 1e5.
fn to_far_plane(flat: &Flat<f64>, ray: Ray<f64>) -> Found {
    let found = rightly(flat, ray);
    let length = DVec3::from(<[f64; 3]>::from(ray.direction)).length();
    if found.t * length > 1e5 {
        return Found::new(f64::INFINITY, NO_HIT);
    }
    found
}

/// Meets what is at t = 0.
fn from_behind(flat: &Flat<f64>, ray: Ray<f64>) -> Found {
    nearest(flat, ray, |corners| {
        let (sides, t) = edges(ray, corners);
        (one_sign(sides, |side| side >= 0.0) && t >= 0.0).then_some(t)
    })
}

/// Woop's edge functions in f32, contracted: one product of each is not rounded.
fn contracted(flat: &Flat<f64>, ray: Ray<f64>) -> Found {
    // Rays mostly along z.
    let d = DVec3::from(<[f64; 3]>::from(ray.direction)).as_vec3();
    nearest(flat, ray, |corners| {
        let [a, b, c] = corners.map(|corner| {
            let v = corner.as_vec3();
            [v.x - d.x / d.z * v.z, v.y - d.y / d.z * v.z]
        });
        let side = |p: [f32; 2], q: [f32; 2]| f64::from(p[0].mul_add(q[1], -(p[1] * q[0])));
        let sides = [side(c, b), side(a, c), side(b, a)];
        let t = edges(ray, corners).1;
        (one_sign(sides, |side| side >= 0.0) && t > 0.0).then_some(t)
    })
}

/// Of equal t the last one counts.
fn last_wins(flat: &Flat<f64>, ray: Ray<f64>) -> Found {
    let first = rightly(flat, ray);
    let half = flat.triangles.len() as u32 / 2;
    Found {
        id: if first.id < half {
            first.id + half
        } else {
            first.id
        },
        ..first
    }
}

/// What no plane parts is put in one leaf, which holds 8.
fn of_a_full_leaf(flat: &Flat<f64>, ray: Ray<f64>) -> Found {
    if flat.pairs.is_empty() {
        return rightly(flat, ray);
    }
    let mut hit = no_hit();
    for (kind, row) in (0..8).map(|id| flat.kind_of(id)) {
        test_rows(flat, probe_of(ray), kind as u32, row..row + 1, &mut hit);
    }
    Found::at(hit).unwrap()
}

/// Of a scene with volumes, only what passes the quadratic formula for its tight ball, in f32.
fn in_tight_ball(flat: &Flat<f64>, ray: Ray<f64>) -> Found {
    if flat.volumes.is_empty() {
        return rightly(flat, ray);
    }
    let points: Vec<_> = flat
        .vertices
        .iter()
        .map(|v| (DVec3::from(*v), 0.0))
        .collect();
    let (center, radius) = bounding_ball(&points).unwrap();
    let (c, d) = (
        center.as_vec3(),
        DVec3::from(<[f64; 3]>::from(ray.direction)).as_vec3(),
    );
    let (a, b) = (d.dot(d), -2.0 * c.dot(d));
    let discriminant = b * b - 4.0 * a * (c.dot(c) - (radius * radius) as f32);
    let mut bare = flat.clone();
    bare.volumes.clear();
    if discriminant < 0.0 {
        return Found::new(f64::INFINITY, NO_HIT);
    }
    rightly(&bare, ray)
}

/// A tree of one leaf.
fn one_leaf(items: Vec<(Aabb, u32)>) -> Tree {
    let root = Node {
        aabb: items[0].0,
        first: 0,
        count: items.len() as u32,
    };
    Tree {
        nodes: vec![root],
        ids: items.into_iter().map(|(_, id)| id).collect(),
    }
}
