//! What makes a mesh sound, for the tests.

use std::collections::HashMap;

use glam::DVec3;

use super::super::Mesh;

/// The first fault of a mesh, or None: indices, finiteness, zero areas, winding,
/// normals, texture coordinates.
pub fn fault(mesh: &Mesh) -> Option<String> {
    if let Some(fault) = fault_of_indices(mesh) {
        return Some(fault);
    }
    let mut numbers = mesh.positions.iter().chain(&mesh.normals);
    if let Some(v) = numbers.find(|v| !v.is_finite()) {
        return Some(format!("{v} is not finite"));
    }
    if let Some([u, v]) = mesh.uvs.iter().find(|uv| !uv.iter().all(|x| x.is_finite())) {
        return Some(format!("the texture coordinates {u}, {v} are not finite"));
    }
    for (i, corners) in mesh.triangles.iter().enumerate() {
        let (area, longest) = twice_area(mesh, *corners);
        // The cross product's rounding error is below 8 ulp of longest^2; an
        // area above it has a sign.
        if area.length() <= 8.0 * f64::EPSILON * longest * longest {
            return Some(format!("triangle {i} has no area"));
        }
    }
    if let Some((edge, _)) = directed_edges(mesh)
        .into_iter()
        .find(|&(_, times)| times > 1)
    {
        return Some(format!("edge {edge:?} is run twice in one direction"));
    }
    fault_of_normals(mesh)
}

/// Vertices that stand where an earlier one stands, with that one.
pub fn doubles(mesh: &Mesh) -> Vec<[u32; 2]> {
    let pairs = weld(mesh).into_iter().zip(0..);
    pairs
        .filter(|(place, i)| place != i)
        .map(|(place, i)| [place, i])
        .collect()
}

/// The smallest cosine between a triangle's normal and those at its corners;
/// above 0, all normals face with the winding.
pub fn least_cosine(mesh: &Mesh) -> f64 {
    let of = |(t, n): (&[u32; 3], &[u32; 3])| {
        let (area, _) = twice_area(mesh, *t);
        let cosine = |i: u32| mesh.normals[i as usize].dot(area.normalize());
        n.map(cosine).into_iter().fold(1.0, f64::min)
    };
    let pairs = mesh.triangles.iter().zip(&mesh.triangle_normals);
    pairs.map(of).fold(1.0, f64::min)
}

/// The number of triangles whose texture is seen in a mirror, or squeezed to a line, from
/// the side from which the triangle runs counter-clockwise.
pub fn mirrored_uvs(mesh: &Mesh) -> usize {
    let turns_left = |uvs: &&[u32; 3]| {
        let [a, b, c] = uvs.map(|uv| glam::DVec2::from(mesh.uvs[uv as usize]));
        (b - a).perp_dot(c - a) > 0.0
    };
    mesh.triangle_uvs.len() - mesh.triangle_uvs.iter().filter(turns_left).count()
}

/// The number of edges that no neighbour runs in the other direction; 0 where
/// the mesh is closed.
pub fn open_edges(mesh: &Mesh) -> usize {
    let edges = directed_edges(mesh);
    edges
        .keys()
        .filter(|&&(a, b)| !edges.contains_key(&(b, a)))
        .count()
}

/// V - E + F.
pub fn euler_characteristic(mesh: &Mesh) -> i64 {
    let edges = directed_edges(mesh);
    let single = edges
        .keys()
        .filter(|&&(a, b)| a < b || !edges.contains_key(&(b, a)));
    mesh.positions.len() as i64 - single.count() as i64 + mesh.triangles.len() as i64
}

/// The enclosed volume; positive where triangles wind counter-clockwise seen
/// from outside.
pub fn volume(mesh: &Mesh) -> f64 {
    let six = |t: &[u32; 3]| {
        let [a, b, c] = t.map(|i| mesh.positions[i as usize]);
        a.dot(b.cross(c))
    };
    mesh.triangles.iter().map(six).sum::<f64>() / 6.0
}

/// The smallest distance of two vertices, if it is below `bound`.
pub fn closer_than(mesh: &Mesh, bound: f64) -> Option<f64> {
    let cell = |p: DVec3| (p / bound).floor().to_array().map(|c| c as i64);
    let mut cells: HashMap<_, Vec<DVec3>> = HashMap::new();
    for &p in &mesh.positions {
        cells.entry(cell(p)).or_default().push(p);
    }
    let near = |p: DVec3| {
        let [x, y, z] = cell(p);
        (0..27).map(move |k| [x + k % 3 - 1, y + k / 3 % 3 - 1, z + k / 9 - 1])
    };
    let mut least = bound;
    for &p in &mesh.positions {
        let others = near(p).filter_map(|c| cells.get(&c)).flatten();
        // A vertex meets itself once, at distance 0; a second 0 is a double.
        let mut distances: Vec<f64> = others.map(|q| p.distance(*q)).collect();
        distances.sort_by(f64::total_cmp);
        least = least.min(distances.get(1).copied().unwrap_or(bound));
    }
    (least < bound).then_some(least)
}

fn fault_of_indices(mesh: &Mesh) -> Option<String> {
    let beyond = |list: &[[u32; 3]], len: usize| {
        list.iter().flatten().find(|&&i| i as usize >= len).copied()
    };
    if let Some(i) = beyond(&mesh.triangles, mesh.positions.len()) {
        return Some(format!("there is no vertex {i}"));
    }
    if let Some(i) = beyond(&mesh.triangle_normals, mesh.normals.len()) {
        return Some(format!("there is no normal {i}"));
    }
    if let Some(i) = beyond(&mesh.triangle_uvs, mesh.uvs.len()) {
        return Some(format!("there are no texture coordinates {i}"));
    }
    for (list, what) in [
        (&mesh.triangle_normals, "normals"),
        (&mesh.triangle_uvs, "texture coordinates"),
    ] {
        if !list.is_empty() && list.len() != mesh.triangles.len() {
            return Some(format!("{} triangles have {what}, not all", list.len()));
        }
    }
    let mut used = vec![false; mesh.positions.len()];
    for &i in mesh.triangles.iter().flatten() {
        used[i as usize] = true;
    }
    let unused = used.iter().position(|&u| !u);
    unused.map(|i| format!("vertex {i} is in no triangle"))
}

fn fault_of_normals(mesh: &Mesh) -> Option<String> {
    // Normalising rounds three components, a square root and a division: the
    // squared length is within 8 ulp of 1.
    let off = |n: &&DVec3| (n.length_squared() - 1.0).abs() > 8.0 * f64::EPSILON;
    let wrong = mesh.normals.iter().find(off);
    wrong.map(|n| format!("normal {n} has length {}", n.length()))
}

/// Twice the area as a vector, and the longest edge.
fn twice_area(mesh: &Mesh, corners: [u32; 3]) -> (DVec3, f64) {
    let [a, b, c] = corners.map(|i| mesh.positions[i as usize]);
    let longest = a.distance(b).max(b.distance(c)).max(c.distance(a));
    ((b - a).cross(c - a), longest)
}

/// For each vertex the first one at exactly its position.
fn weld(mesh: &Mesh) -> Vec<u32> {
    let mut first = HashMap::new();
    let place = |(i, p): (usize, &DVec3)| {
        // + 0 makes the two zeros one.
        let bits = (*p + DVec3::ZERO).to_array().map(f64::to_bits);
        *first.entry(bits).or_insert(i as u32)
    };
    mesh.positions.iter().enumerate().map(place).collect()
}

/// How often each edge is run, by the places of its ends.
fn directed_edges(mesh: &Mesh) -> HashMap<(u32, u32), u32> {
    let places = weld(mesh);
    let mut edges = HashMap::new();
    for corners in &mesh.triangles {
        let [a, b, c] = corners.map(|i| places[i as usize]);
        for edge in [(a, b), (b, c), (c, a)] {
            *edges.entry(edge).or_insert(0) += 1;
        }
    }
    edges
}
