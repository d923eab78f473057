//! From the faces that `tobj` returns to the triangles of a [`Mesh`].

use glam::DVec3;

use super::elements::{FaceNote, NO_MATERIAL, Notes};
use super::polygon::{Clipper, Cut};
use super::tally::Dropped;
use crate::scene::{MAX_MAGNITUDE, Mesh};

/// Stands for flat triangles until it is known whether any other is smooth.
const FLAT: [u32; 3] = [u32::MAX; 3];

/// Triangulates the faces of `raw`, which stand in the order of
/// `notes.faces`. What is dropped is counted in `notes.dropped`. Where a
/// material is named, a face without one takes the index `notes.names.len()`.
pub(super) fn build(raw: tobj::Mesh, notes: &mut Notes) -> Mesh {
    let mut builder = Builder {
        mesh: Mesh {
            positions: vectors(&raw.positions),
            normals: vectors(&raw.normals).into_iter().map(unit).collect(),
            ..Mesh::default()
        },
        clipper: Clipper::default(),
        corners: Vec::new(),
        places: Vec::new(),
    };
    let mut start = 0;
    for (face, note) in notes.faces.iter().enumerate() {
        // `tobj` leaves the arities out where all are 3.
        let arity = raw
            .face_arities
            .get(face)
            .map_or(3, |&arity| arity as usize);
        let indices = raw.indices.get(start..start + arity).unwrap_or_default();
        let normals = raw.normal_indices.get(start..start + arity);
        let normals = normals.filter(|_| note.has_normals);
        start += arity;
        builder.face(indices, normals, note, &mut notes.dropped);
        if !notes.names.is_empty() {
            let material = match note.material {
                NO_MATERIAL => notes.names.len() as u32,
                material => material,
            };
            let triangles = builder.mesh.triangles.len();
            builder.mesh.triangle_materials.resize(triangles, material);
        }
    }
    let mut mesh = builder.mesh;
    fill_flat_normals(&mut mesh);
    compact(&mut mesh.positions, &mut mesh.triangles);
    compact(&mut mesh.normals, &mut mesh.triangle_normals);
    mesh
}

struct Builder {
    mesh: Mesh,
    clipper: Clipper,
    /// Of the current face: position and normal (if it has one) of each corner.
    corners: Vec<(u32, Option<u32>)>,
    places: Vec<DVec3>,
}

impl Builder {
    fn face(
        &mut self,
        indices: &[u32],
        normals: Option<&[u32]>,
        note: &FaceNote,
        dropped: &mut Dropped,
    ) {
        let line = note.line as usize;
        self.gather(indices, normals);
        if !self.places.iter().all(|&place| is_usable(place)) {
            dropped.non_finite.add(line);
            return;
        }
        self.merge_repeated();
        if self.places.len() < 3 {
            dropped.degenerate.add(line);
            return;
        }
        match self.clipper.cut(&self.places) {
            Cut::Ears => {}
            Cut::Fan => dropped.fanned.add(line),
            Cut::Nothing => {
                dropped.degenerate.add(line);
                return;
            }
        }
        let mut whole = true;
        for &triangle in self.clipper.triangles() {
            if geometric_normal(triangle.map(|i| self.places[i])) == DVec3::ZERO {
                whole = false;
                continue;
            }
            let corners = triangle.map(|i| self.corners[i]);
            self.mesh.triangles.push(corners.map(|(place, _)| place));
            let smooth = self.smooth(corners);
            self.mesh.triangle_normals.push(smooth.unwrap_or(FLAT));
        }
        if !whole {
            dropped.degenerate.add(line);
        }
    }

    fn gather(&mut self, indices: &[u32], normals: Option<&[u32]>) {
        let normal = |i: usize| normals.and_then(|normals| normals.get(i).copied());
        self.corners.clear();
        self.places.clear();
        for (i, &index) in indices.iter().enumerate() {
            self.corners.push((index, normal(i)));
            self.places.push(self.mesh.positions[index as usize]);
        }
    }

    /// Takes out corners at the place of the next (`f 1 2 3 3` is a triangle).
    fn merge_repeated(&mut self) {
        let mut kept = 0;
        for i in 0..self.places.len() {
            if self.places[i] != self.places[(i + 1) % self.places.len()] {
                self.places[kept] = self.places[i];
                self.corners[kept] = self.corners[i];
                kept += 1;
            }
        }
        self.places.truncate(kept);
        self.corners.truncate(kept);
    }

    /// The corners' normals, if each has one that can be used.
    fn smooth(&self, corners: [(u32, Option<u32>); 3]) -> Option<[u32; 3]> {
        let [a, b, c] = corners.map(|(_, normal)| {
            normal.filter(|&normal| self.mesh.normals[normal as usize] != DVec3::ZERO)
        });
        Some([a?, b?, c?])
    }
}

/// Gives flat triangles their geometric normal if others are smooth; takes all
/// normals away if none is.
fn fill_flat_normals(mesh: &mut Mesh) {
    if mesh.triangle_normals.iter().all(|&normals| normals == FLAT) {
        mesh.triangle_normals.clear();
        mesh.normals.clear();
        return;
    }
    for (normals, triangle) in mesh.triangle_normals.iter_mut().zip(&mesh.triangles) {
        if *normals == FLAT {
            let places = triangle.map(|i| mesh.positions[i as usize]);
            *normals = [mesh.normals.len() as u32; 3];
            mesh.normals.push(unit(geometric_normal(places)));
        }
    }
}

/// Leaves out vectors that no triangle refers to.
fn compact(vectors: &mut Vec<DVec3>, triangles: &mut [[u32; 3]]) {
    let mut places = vec![u32::MAX; vectors.len()];
    for &index in triangles.as_flattened() {
        places[index as usize] = 0;
    }
    let mut kept = 0;
    for (old, place) in places.iter_mut().enumerate() {
        if *place == 0 {
            *place = kept;
            vectors[kept as usize] = vectors[old];
            kept += 1;
        }
    }
    vectors.truncate(kept as usize);
    for index in triangles.as_flattened_mut() {
        *index = places[*index as usize];
    }
}

fn vectors(flat: &[f64]) -> Vec<DVec3> {
    let (triples, _) = flat.as_chunks::<3>();
    triples.iter().map(|&triple| triple.into()).collect()
}

fn is_usable(place: DVec3) -> bool {
    place.is_finite() && place.abs().max_element() <= MAX_MAGNITUDE
}

/// Perpendicular to a triangle; zero where f64 gives it no area. Slivers with
/// an area, however small, are not for a reader to judge.
fn geometric_normal([a, b, c]: [DVec3; 3]) -> DVec3 {
    (b - a).cross(c - a)
}

/// Unit length; zero if the vector is zero or not finite. Scaled first, so that
/// no square overflows or vanishes.
fn unit(vector: DVec3) -> DVec3 {
    let size = vector.abs().max_element();
    if size > 0.0 && vector.is_finite() {
        (vector / size).normalize()
    } else {
        DVec3::ZERO
    }
}
