//! Meshes to vertices, shared, and triangles.

use std::collections::HashMap;

use glam::DVec3;

use super::{place, real_vector, turn};
use crate::flat::Flat;
use crate::kernel::real::Real;
use crate::layout::Corners;
use crate::scene::{Mesh, Shape};

/// Adds a mesh: its vertices, shared between its triangles, and the triangles.
pub(super) fn push_mesh<R: Real>(flat: &mut Flat<R>, mesh: &Mesh, shape: &Shape, eye: DVec3) {
    let first = flat.vertices.len() as u32;
    let id = flat.primitives();
    let placed = |&position: &DVec3| real_vector(place(position, &shape.transform, eye));
    let corners = |(vertices, id): ([u32; 3], u32)| Corners { vertices, id };
    if mesh.triangle_normals.is_empty() {
        flat.vertices.extend(mesh.positions.iter().map(placed));
        let moved = mesh
            .triangles
            .iter()
            .map(|t| t.map(|vertex| first + vertex));
        flat.triangles.extend(moved.zip(id..).map(corners));
    } else {
        let smooth = SmoothVertices::of(mesh);
        let places = smooth.vertices.iter();
        flat.vertices
            .extend(places.map(|&[position, _]| placed(&mesh.positions[position as usize])));
        flat.vertex_normals.resize(first as usize, [0.0; 3]);
        let turned = |normal: u32| turn(mesh.normals[normal as usize], &shape.transform);
        let normals = smooth.vertices.iter();
        flat.vertex_normals
            .extend(normals.map(|&[_, normal]| turned(normal).as_vec3().to_array()));
        let moved = smooth
            .triangles
            .iter()
            .map(|t| t.map(|vertex| first + vertex));
        flat.triangles.extend(moved.zip(id..).map(corners));
    }
    if mesh.triangle_materials.is_empty() {
        let materials = flat.material_indices.len() + mesh.triangles.len();
        flat.material_indices
            .resize(materials, shape.material as u32);
    } else {
        flat.material_indices.extend(&mesh.triangle_materials);
    }
}

/// The vertices of a mesh with normals: each pair of a position and a normal that
/// occurs at a corner, once.
struct SmoothVertices {
    /// A position's index and a normal's.
    vertices: Vec<[u32; 2]>,
    triangles: Vec<[u32; 3]>,
}

impl SmoothVertices {
    fn of(mesh: &Mesh) -> Self {
        // Most positions have one normal: it is looked up in a plain array, the
        // others in a map.
        const UNSET: u32 = u32::MAX;
        let mut first = vec![[UNSET; 2]; mesh.positions.len()];
        let mut others = HashMap::new();
        let mut vertices = Vec::new();
        let mut vertex = |position: u32, normal: u32| {
            let [known, its_normal] = &mut first[position as usize];
            let mut push = || {
                vertices.push([position, normal]);
                vertices.len() as u32 - 1
            };
            if *known == UNSET {
                (*known, *its_normal) = (push(), normal);
            }
            if *its_normal == normal {
                return *known;
            }
            *others.entry([position, normal]).or_insert_with(push)
        };
        let corners = mesh.triangles.iter().zip(&mesh.triangle_normals);
        let triangles = corners
            .map(|(positions, normals)| {
                std::array::from_fn(|corner| vertex(positions[corner], normals[corner]))
            })
            .collect();
        Self {
            vertices,
            triangles,
        }
    }
}
