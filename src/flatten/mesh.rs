//! Meshes to vertices, shared, and triangles.

use std::collections::HashMap;

use glam::DVec3;

use super::{is_turned_inside_out, place, real_vector, turn};
use crate::flat::Flat;
use crate::kernel::real::Real;
use crate::layout::Corners;
use crate::scene::{Material, Mesh, Shape};

/// Adds a mesh: its vertices, shared between its triangles, and the triangles.
pub(super) fn push_mesh<R: Real>(
    flat: &mut Flat<R>,
    mesh: &Mesh,
    shape: &Shape,
    materials: &[Material],
    eye: DVec3,
) {
    let first = flat.vertices.len();
    let first_id = flat.primitives();
    let placed = |position: DVec3| real_vector(place(position, &shape.transform, eye));
    let is_smooth = !mesh.triangle_normals.is_empty();
    let is_textured = !mesh.triangle_uvs.is_empty() && has_texture(mesh, shape, materials);
    let shared;
    let triangles = if is_smooth || is_textured {
        shared = SharedVertices::of(mesh, is_smooth, is_textured);
        let vertices = &shared.vertices;
        let positions = vertices.iter().map(|v| mesh.positions[v.position as usize]);
        flat.vertices.extend(positions.map(placed));
        if is_smooth {
            let turned = |v: &Vertex| turn(mesh.normals[v.normal as usize], &shape.transform);
            flat.vertex_normals.resize(first, [0.0; 3]);
            let normals = vertices.iter().map(|v| turned(v).as_vec3().to_array());
            flat.vertex_normals.extend(normals);
        }
        if is_textured {
            flat.vertex_uvs.resize(first, [0.0; 2]);
            let uvs = vertices.iter().map(|v| mesh.uvs[v.uv as usize]);
            flat.vertex_uvs.extend(uvs.map(|uv| uv.map(|x| x as f32)));
        }
        &shared.triangles
    } else {
        let positions = mesh.positions.iter().copied();
        flat.vertices.extend(positions.map(placed));
        &mesh.triangles
    };
    let moved = triangles.iter().map(|t| t.map(|v| first as u32 + v));
    let corners = |(mut vertices, id): ([u32; 3], u32)| {
        let material = match mesh.triangle_materials.get((id - first_id) as usize) {
            Some(own) => *own as usize,
            None => shape.material,
        };
        if is_turned_inside_out(&shape.transform, &materials[material]) {
            vertices.swap(0, 1);
        }
        Corners { vertices, id }
    };
    flat.triangles.extend(moved.zip(first_id..).map(corners));
    if mesh.triangle_materials.is_empty() {
        let materials = flat.material_indices.len() + mesh.triangles.len();
        flat.material_indices
            .resize(materials, shape.material as u32);
    } else {
        flat.material_indices.extend(&mesh.triangle_materials);
    }
}

/// Does a material of the mesh have a texture?
fn has_texture(mesh: &Mesh, shape: &Shape, materials: &[Material]) -> bool {
    let textured = |material: usize| materials[material].texture.is_some();
    let mut own = mesh.triangle_materials.iter();
    match mesh.triangle_materials.is_empty() {
        true => textured(shape.material),
        false => own.any(|&material| textured(material as usize)),
    }
}

/// What a vertex is made of, as indices into the mesh; 0 where it is made without.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash)]
struct Vertex {
    position: u32,
    normal: u32,
    uv: u32,
}

/// The vertices of a mesh with normals or texture coordinates: each combination of a
/// position with them that occurs at a corner, once.
struct SharedVertices {
    vertices: Vec<Vertex>,
    triangles: Vec<[u32; 3]>,
}

impl SharedVertices {
    fn of(mesh: &Mesh, is_smooth: bool, is_textured: bool) -> Self {
        // Most positions have one normal and one place on the texture: these are looked up in
        // a plain array, the others in a map.
        const UNSET: u32 = u32::MAX;
        let mut first = vec![UNSET; mesh.positions.len()];
        let mut others = HashMap::new();
        let mut vertices: Vec<Vertex> = Vec::new();
        let mut index_of = |vertex: Vertex| {
            let known = &mut first[vertex.position as usize];
            // There are at most as many as corners, whose number a scene's policy keeps far
            // below 2^32.
            let next = vertices.len() as u32;
            let index = if *known == UNSET {
                *known = next;
                next
            } else if vertices[*known as usize] == vertex {
                *known
            } else {
                *others.entry(vertex).or_insert(next)
            };
            if index == next {
                vertices.push(vertex);
            }
            index
        };
        let normals = is_smooth.then_some(&mesh.triangle_normals);
        let uvs = is_textured.then_some(&mesh.triangle_uvs);
        let at = |list: Option<&Vec<[u32; 3]>>, triangle: usize, corner: usize| {
            list.map_or(0, |list| list[triangle][corner])
        };
        let triangles = mesh.triangles.iter().enumerate();
        let triangles = triangles
            .map(|(triangle, positions)| {
                std::array::from_fn(|corner| {
                    index_of(Vertex {
                        position: positions[corner],
                        normal: at(normals, triangle, corner),
                        uv: at(uvs, triangle, corner),
                    })
                })
            })
            .collect();
        Self {
            vertices,
            triangles,
        }
    }
}

#[cfg(test)]
mod tests {
    use std::sync::Arc;

    use super::super::flatten;
    use super::*;
    use crate::scene::mesh::{Builtin, build};
    use crate::scene::{Geometry, Pattern, Scene, Texture, Transform};

    const PLAIN: usize = 0;
    const CHECKERED: usize = 1;

    /// Meshes, each with the material that it stands in.
    fn scene(meshes: &[(&Mesh, usize)]) -> Flat<f32> {
        let checkered = Material {
            texture: Some(Texture {
                pattern: Pattern::Checker([0.0; 3]),
                repeat: [1.0; 2],
                size: 1.0,
            }),
            ..Material::default()
        };
        let shape = |&(mesh, material): &(&Mesh, usize)| Shape {
            geometry: Geometry::Mesh(Arc::new(mesh.clone())),
            transform: Transform::default(),
            material,
            velocity: DVec3::ZERO,
        };
        flatten(&Scene {
            materials: vec![Material::default(), checkered],
            shapes: meshes.iter().map(shape).collect(),
            ..Scene::default()
        })
    }

    /// What stands at the corners of each triangle of a mesh, and of the flat scene.
    fn agrees(mesh: &Mesh, flat: &Flat<f32>, first: usize, normals: bool, uvs: bool) -> bool {
        let triangles = flat.triangles[first..].iter().zip(0..mesh.triangles.len());
        triangles.into_iter().all(|(corners, i)| {
            (0..3).all(|corner| {
                let vertex = corners.vertices[corner] as usize;
                let position = mesh.positions[mesh.triangles[i][corner] as usize];
                let eye = Scene::default().camera.eye;
                let mut good = flat.vertices[vertex] == (position - eye).as_vec3().to_array();
                if normals {
                    let normal = mesh.normals[mesh.triangle_normals[i][corner] as usize];
                    let normal = normal.normalize().as_vec3().to_array();
                    good &= flat.vertex_normals[vertex] == normal;
                }
                if uvs {
                    let uv = mesh.uvs[mesh.triangle_uvs[i][corner] as usize];
                    good &= flat.vertex_uvs[vertex] == uv.map(|x| x as f32);
                }
                good
            })
        })
    }

    #[test]
    fn without_a_texture_no_vertex_is_split() {
        let knot = build(Builtin::Knot, 500);
        let cube = build(Builtin::Box, 300);
        let flat = scene(&[(&knot, PLAIN), (&cube, PLAIN)]);
        let vertices = knot.positions.len() + cube.positions.len();
        assert_eq!(flat.vertices.len(), vertices);
        assert!(flat.vertex_uvs.is_empty());
    }

    #[test]
    fn with_a_texture_vertices_are_split_where_it_has_seams() {
        let knot = build(Builtin::Knot, 500);
        let cube = build(Builtin::Box, 12 * 25);
        let flat = scene(&[(&cube, PLAIN), (&knot, CHECKERED), (&cube, CHECKERED)]);
        let [plain, seams, lattices] = [cube.positions.len(), knot.uvs.len(), 6 * 36];
        assert_eq!(flat.vertices.len(), plain + seams + lattices);
        assert_eq!(flat.vertex_uvs.len(), flat.vertices.len());
        assert_eq!(flat.vertex_normals.len(), flat.vertices.len());
        let second = cube.triangles.len();
        let third = second + knot.triangles.len();
        assert!(agrees(&cube, &flat, 0, false, false));
        assert!(agrees(&knot, &flat, second, true, true));
        assert!(agrees(&cube, &flat, third, false, true));
        let untextured = &flat.vertex_uvs[..plain];
        assert!(untextured.iter().all(|uv| *uv == [0.0; 2]));
        // Control: another mesh's corners do not agree.
        assert!(!agrees(&cube, &flat, second, false, false));
    }

    #[test]
    fn a_part_with_a_texture_is_enough() {
        let mut cube = build(Builtin::Box, 12);
        cube.triangle_materials = vec![PLAIN as u32; 12];
        assert!(scene(&[(&cube, CHECKERED)]).vertex_uvs.is_empty());
        cube.triangle_materials[11] = CHECKERED as u32;
        assert_eq!(scene(&[(&cube, PLAIN)]).vertex_uvs.len(), 6 * 4);
    }

    #[test]
    fn other_shapes_after_a_mesh_have_coordinates_too() {
        let cube = build(Builtin::Box, 12);
        let teapot = build(Builtin::Teapot, 300);
        let flat = scene(&[(&cube, CHECKERED), (&teapot, PLAIN)]);
        assert_eq!(flat.vertex_uvs.len(), flat.vertices.len());
        let wider = flat.converted::<f64>();
        assert_eq!(wider.vertex_uvs, flat.vertex_uvs);
        let mut without = flat.clone();
        without.vertex_uvs.clear();
        let bytes = (flat.bytes() - without.bytes()) as usize;
        assert_eq!(bytes, (8 * flat.vertices.len()).next_multiple_of(16));
    }
}
