//! Whole numbers, of which nothing is rounded: there is one right answer.

use glam::{DMat3, DVec3};

use crate::bounds::Bounds;
use crate::error::Result;
use crate::kernel::camera::Ray;
use crate::random::Numbers;
use crate::scene::mesh::{Builtin, build};
use crate::scene::{Geometry, Mesh};
use crate::stability::aim::{any_corners, ray};
use crate::stability::case::{Case, Trial};
use crate::stability::demand::Demand::{self, BruteForce, Classified, Exact, Finite, NoLeak};
use crate::stability::shapes::{flat_of, mesh, scene_of, triangle};
use crate::stability::trials::aimed::Aimed;
use crate::stability::trials::together::Together;
use crate::tier::Accuracy::{Robust, Textbook};

pub(super) const CASES: &[Case] = &[
    Case {
        id: "triangle/grid",
        name: "a grid along the axes",
        sets_up: "Rays at vertices, edges and diagonals of a grid of whole numbers, straight \
                  and aslant.",
        danger: "A strict edge test leaves every edge to neither neighbour; of six triangles \
                 at a vertex, the first has to win.",
        demands: &[Exact, BruteForce],
        fails: &[Textbook],
        is_random: true,
        trial: grid,
    },
    Case {
        id: "triangle/along-edges",
        name: "rays along edges",
        sets_up: "Rays along the edges and diagonals of a cube, from outside and from a vertex.",
        danger: "Two faces are seen edge-on, and the third is met at its corner.",
        demands: &[Exact, BruteForce],
        fails: &[Textbook],
        is_random: true,
        trial: along_edges,
    },
    Case {
        id: "triangle/in-plane",
        name: "rays in a triangle's plane",
        sets_up: "Triangles of whole numbers in the planes y = -3 and x = y, and rays within \
                  them.",
        danger: "The determinant is 0: 0/0 is NaN, or the triangle is hit all along.",
        demands: &[Exact, Finite],
        fails: &[],
        is_random: true,
        trial: in_plane,
    },
    Case {
        id: "triangle/on-it",
        name: "rays that start on the triangle, or beyond it",
        sets_up: "Rays from points of a triangle, and away from it.",
        danger: "t = 0, and t below 0, are no hits.",
        demands: &[Exact],
        fails: &[],
        is_random: true,
        trial: on_it,
    },
    Case {
        id: "triangle/edge-products",
        name: "edge products that differ in the last bit",
        sets_up: "1024 quads of two triangles. Of their diagonal from (a, b) to (-c, -d), with a \
                  d - b c = 1, a ray passes 1e-6 and less beside.",
        danger: "Products of 34 bits round to one number; if one of them is kept whole by a \
                 fused multiply-add, both triangles see the ray outside.",
        demands: &[NoLeak, Classified, Finite],
        fails: &[Textbook],
        is_random: true,
        trial: edge_products,
    },
    Case {
        id: "triangle/edge-sides",
        name: "on which side of such an edge",
        sets_up: "The same quads and rays.",
        danger: "Both products round to one number, and the ray is on both sides.",
        demands: &[Exact],
        // One rounded product compared with the other cannot tell; no product of f32 can.
        fails: &[Textbook, Robust],
        is_random: true,
        trial: edge_products,
    },
    Case {
        id: "triangle/twice",
        name: "a mesh twice in one place",
        sets_up: "Rays at points within the triangles of two equal spheres.",
        danger: "Of two hits at one t the lower id counts, in whatever order the tree has them.",
        // Points at least a tenth of a triangle off its edges, a thousand times the rounding.
        demands: &[Exact, BruteForce],
        fails: &[],
        is_random: true,
        trial: twice,
    },
];

fn grid(n: &mut Numbers, demands: &'static [Demand]) -> Result<Box<dyn Trial>> {
    const SIDE: u32 = 16;
    let index = |x: u32, y: u32| x + y * (SIDE + 1);
    let cells = (0..SIDE * SIDE).map(|cell| (cell % SIDE, cell / SIDE));
    let of_cell = |(x, y): (u32, u32)| {
        let [a, b] = [index(x, y), index(x + 1, y)];
        let [c, d] = [index(x + 1, y + 1), index(x, y + 1)];
        [[a, b, c], [a, c, d]]
    };
    let positions = (0..(SIDE + 1) * (SIDE + 1)).map(|place| {
        let (x, y) = (place % (SIDE + 1), place / (SIDE + 1));
        DVec3::new(f64::from(x) - 8.0, f64::from(y) - 8.0, -8.0)
    });
    let squares = Mesh {
        positions: positions.collect(),
        triangles: cells.flat_map(of_cell).collect(),
        ..Mesh::default()
    };
    let flat = flat_of(&scene_of([mesh(squares, DMat3::IDENTITY, DVec3::ZERO)]));
    let rays = (0..4000)
        .map(|_| {
            // Up to half a cell beyond the rim.
            let [x, y] = [0; 2].map(|_| n.pick(35) as f64 / 2.0 - 8.5);
            let target = DVec3::new(x, y, -8.0);
            // A component is 0 or a power of two: all products are exact.
            let [x, y] = [0; 2].map(|_| [-1.0, -0.5, 0.0, 0.5, 1.0][n.pick(5)]);
            let direction = DVec3::new(x, y, -1.0);
            ray(target - direction * 8.0, direction)
        })
        .collect();
    Ok(Box::new(Aimed::new(flat, Bounds::Tree, rays, demands)?))
}

fn along_edges(n: &mut Numbers, demands: &'static [Demand]) -> Result<Box<dyn Trial>> {
    let middle = DVec3::new(3.0, -2.0, -6.0);
    let cube = mesh(build(Builtin::Box, 12), DMat3::IDENTITY * 2.0, middle);
    let flat = flat_of(&scene_of([cube]));
    let rays = (0..2000)
        .map(|_| {
            // An edge, a diagonal of a face, or one of the cube.
            let [a, b] = loop {
                let [a, _, _] = any_corners(&flat, n);
                let [b, _, _] = any_corners(&flat, n);
                if a != b {
                    break [a, b];
                }
            };
            let from = a - (b - a) * n.pick(3) as f64;
            ray(from, b - a)
        })
        .collect();
    Ok(Box::new(Aimed::new(flat, Bounds::Tree, rays, demands)?))
}

/// Whole numbers from -9 to 9.
fn whole(n: &mut Numbers) -> [f64; 2] {
    [0; 2].map(|_| n.pick(19) as f64 - 9.0)
}

fn in_plane(n: &mut Numbers, demands: &'static [Demand]) -> Result<Box<dyn Trial>> {
    let flat_on = |[x, z]: [f64; 2]| DVec3::new(x, -3.0, z);
    let aslant = |[x, z]: [f64; 2]| DVec3::new(x, x, z);
    let corners = [[-6.0, -5.0], [7.0, -4.0], [1.0, 8.0]];
    let flats = [flat_on, aslant]
        .map(|place: fn([f64; 2]) -> DVec3| flat_of(&scene_of([triangle(corners.map(place))])));
    let mut trials: Vec<Box<dyn Trial>> = Vec::new();
    for (flat, place) in flats.into_iter().zip([flat_on, aslant]) {
        let rays: Vec<Ray<f32>> = (0..1000)
            .map(|_| {
                let from = place(whole(n));
                let direction = loop {
                    let direction = place(whole(n)) - from;
                    if direction != DVec3::ZERO {
                        break direction;
                    }
                };
                ray(from, direction)
            })
            .collect();
        trials.push(Box::new(Aimed::new(flat, Bounds::None, rays, demands)?));
    }
    Ok(Box::new(Together(trials)))
}

fn on_it(n: &mut Numbers, demands: &'static [Demand]) -> Result<Box<dyn Trial>> {
    let corner = |x: f64, y: f64| DVec3::new(x, y, -4.0);
    let corners = [corner(-16.0, -16.0), corner(16.0, -16.0), corner(0.0, 16.0)];
    let flat = flat_of(&scene_of([triangle(corners)]));
    let rays = (0..2000)
        .map(|index| {
            let [x, y] = whole(n);
            // On it, or up to 3 beyond, and steep enough that depths are along z.
            let beyond = if index % 2 == 0 {
                0.0
            } else {
                n.pick(4) as f64
            };
            let sign = if n.flip() { 1.0 } else { -1.0 };
            let away = if beyond == 0.0 { sign } else { -1.0 };
            let [dx, dy] = whole(n).map(|d| d / 16.0);
            ray(
                DVec3::new(x / 2.0, y / 2.0, -4.0 - beyond),
                DVec3::new(dx, dy, away),
            )
        })
        .collect();
    Ok(Box::new(Aimed::new(flat, Bounds::None, rays, demands)?))
}

/// Whole numbers c and d with a d - b c = 1, for a and b without a common divisor: Euclid.
fn partners(a: i64, b: i64) -> Option<[i64; 2]> {
    let (mut rest, mut x, mut y) = ([a, b], [1, 0], [0, 1]);
    while rest[1] != 0 {
        let quotient = rest[0] / rest[1];
        for pair in [&mut rest, &mut x, &mut y] {
            *pair = [pair[1], pair[0] - quotient * pair[1]];
        }
    }
    // a x + b y = 1
    (rest[0] == 1).then_some([-y[0], x[0]])
}

/// Quads in a square, each around a point that its diagonal passes by, and those points.
fn quads(n: &mut Numbers) -> (Geometry, Vec<DVec3>) {
    const SIDE: i64 = 32;
    const SPACE: i64 = 1 << 19;
    const REACH: i64 = 1 << 17;
    let mut all = Mesh::default();
    let mut middles = Vec::new();
    for place in 0..SIDE * SIDE {
        let [column, row] = [place % SIDE, place / SIDE].map(|at| at - SIDE / 2);
        // The ray comes down at (x, y), and the plane is 1024 below.
        let middle = DVec3::new((column * SPACE) as f64, (row * SPACE) as f64, -1024.0);
        let ([a, b], [c, d]) = loop {
            let [a, b] = [0; 2].map(|_| REACH / 2 + n.pick(REACH as usize / 2) as i64);
            if let Some([c, d]) = partners(a, b) {
                break ([a, b], [c, d]);
            }
        };
        // (c, d) and any number of (a, b) more: as far on the other side.
        let [c, d] = if c < 0 { [c + a, d + b] } else { [c, d] };
        let point = |x: i64, y: i64| middle + DVec3::new(x as f64, y as f64, 0.0);
        let first = all.positions.len() as u32;
        let mut corners = [point(a, b), point(-c, -d), point(-b, a), point(b, -a)];
        // The ray is on the side of (-b, a).
        for [first, second] in [[0, 1], [2, 3]] {
            if n.flip() {
                corners.swap(first, second);
            }
        }
        all.positions.extend(corners);
        all.triangles
            .extend([[0, 1, 2], [1, 0, 3]].map(|t: [u32; 3]| t.map(|i| first + i)));
        middles.push(middle);
    }
    (mesh(all, DMat3::IDENTITY, DVec3::ZERO), middles)
}

fn edge_products(n: &mut Numbers, demands: &'static [Demand]) -> Result<Box<dyn Trial>> {
    let (geometry, middles) = quads(n);
    let flat = flat_of(&scene_of([geometry]));
    let rays = middles
        .iter()
        .flat_map(|&middle| {
            [[0.0, 0.0], [0.5, 0.25], [-0.25, 0.125], [0.0, -0.5]].map(|[x, y]| {
                let direction = DVec3::new(x, y, -1.0);
                ray(middle - direction * 1024.0, direction)
            })
        })
        .collect();
    Ok(Box::new(Aimed::new(flat, Bounds::Tree, rays, demands)?))
}

fn twice(n: &mut Numbers, demands: &'static [Demand]) -> Result<Box<dyn Trial>> {
    let ball = mesh(
        build(Builtin::Icosphere, 320),
        DMat3::IDENTITY,
        DVec3::NEG_Z * 4.0,
    );
    let flat = flat_of(&scene_of([ball.clone(), ball]));
    let rays = (0..1000)
        .map(|_| {
            let [a, b, c] = any_corners(&flat, n);
            let (first, second) = (n.between(0.1, 0.8), n.between(0.1, 0.9));
            let second = second.min(0.9 - first);
            let target = a + (b - a) * first + (c - a) * second;
            // From outside, straight down on it.
            let outward = (target - DVec3::NEG_Z * 4.0).normalize();
            ray(target + outward * n.between(0.5, 2.0), -outward)
        })
        .collect();
    Ok(Box::new(Aimed::new(flat, Bounds::Tree, rays, demands)?))
}
