//! From the faces that `tobj` returns to the triangles of a [`Mesh`].

use glam::DVec3;

use super::elements::{FaceNote, NO_MATERIAL, Notes};
use super::polygon::{Clipper, Cut};
use super::tally::Dropped;
use crate::scene::{MAX_MAGNITUDE, Mesh};

/// Stands for the normals of a flat triangle until it is known whether any other is
/// smooth, and likewise for texture coordinates.
const NONE: [u32; 3] = [u32::MAX; 3];

/// Triangulates the faces of `raw`, which stand in the order of
/// `notes.faces`. What is dropped is counted in `notes.dropped`. Where a
/// material is named, a face without one takes the index `notes.names.len()`.
pub(super) fn build(raw: tobj::Mesh, notes: &mut Notes) -> Mesh {
    let mut builder = Builder {
        mesh: Mesh {
            positions: vectors(&raw.positions),
            normals: vectors(&raw.normals).into_iter().map(unit).collect(),
            uvs: raw.texcoords.as_chunks::<2>().0.to_vec(),
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
        let uvs = raw.texcoord_indices.get(start..start + arity);
        let corners = Corners {
            indices,
            normals: normals.filter(|_| note.has_normals),
            uvs: uvs.filter(|_| note.has_uvs),
        };
        start += arity;
        builder.face(corners, note, &mut notes.dropped);
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
    fill_missing_uvs(&mut mesh);
    compact(&mut mesh.positions, &mut mesh.triangles);
    compact(&mut mesh.normals, &mut mesh.triangle_normals);
    compact(&mut mesh.uvs, &mut mesh.triangle_uvs);
    mesh
}

/// A face as `tobj` returns it.
struct Corners<'a> {
    indices: &'a [u32],
    normals: Option<&'a [u32]>,
    uvs: Option<&'a [u32]>,
}

#[derive(Clone, Copy)]
struct Corner {
    place: u32,
    normal: Option<u32>,
    uv: Option<u32>,
}

struct Builder {
    mesh: Mesh,
    clipper: Clipper,
    /// Those of the current face.
    corners: Vec<Corner>,
    places: Vec<DVec3>,
}

impl Builder {
    fn face(&mut self, face: Corners<'_>, note: &FaceNote, dropped: &mut Dropped) {
        let line = note.line as usize;
        self.gather(face);
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
        if self.drop_wild_uvs() {
            dropped.wild_uvs.add(line);
        }
        let mut whole = true;
        for &triangle in self.clipper.triangles() {
            if geometric_normal(triangle.map(|i| self.places[i])) == DVec3::ZERO {
                whole = false;
                continue;
            }
            let corners = triangle.map(|i| self.corners[i]);
            self.mesh.triangles.push(corners.map(|corner| corner.place));
            let smooth = self.smooth(corners);
            self.mesh.triangle_normals.push(smooth.unwrap_or(NONE));
            let uvs = all(corners.map(|corner| corner.uv));
            self.mesh.triangle_uvs.push(uvs.unwrap_or(NONE));
        }
        if !whole {
            dropped.degenerate.add(line);
        }
    }

    fn gather(&mut self, face: Corners<'_>) {
        let nth = |list: Option<&[u32]>, i: usize| list.and_then(|list| list.get(i).copied());
        self.corners.clear();
        self.places.clear();
        for (i, &place) in face.indices.iter().enumerate() {
            self.corners.push(Corner {
                place,
                normal: nth(face.normals, i),
                uv: nth(face.uvs, i),
            });
            self.places.push(self.mesh.positions[place as usize]);
        }
    }

    /// Takes a face's texture coordinates away if one of them cannot be used, and says
    /// whether.
    fn drop_wild_uvs(&mut self) -> bool {
        let usable = |uv: u32| {
            let uv = self.mesh.uvs[uv as usize];
            uv.iter().all(|x| x.abs() <= MAX_MAGNITUDE)
        };
        let mut uvs = self.corners.iter().filter_map(|corner| corner.uv);
        if uvs.all(usable) {
            return false;
        }
        for corner in &mut self.corners {
            corner.uv = None;
        }
        true
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
    fn smooth(&self, corners: [Corner; 3]) -> Option<[u32; 3]> {
        let usable = |&normal: &u32| self.mesh.normals[normal as usize] != DVec3::ZERO;
        all(corners.map(|corner| corner.normal.filter(usable)))
    }
}

fn all([a, b, c]: [Option<u32>; 3]) -> Option<[u32; 3]> {
    Some([a?, b?, c?])
}

/// Gives flat triangles their geometric normal if others are smooth; takes all
/// normals away if none is.
fn fill_flat_normals(mesh: &mut Mesh) {
    if mesh.triangle_normals.iter().all(|&normals| normals == NONE) {
        mesh.triangle_normals.clear();
        mesh.normals.clear();
        return;
    }
    for (normals, triangle) in mesh.triangle_normals.iter_mut().zip(&mesh.triangles) {
        if *normals == NONE {
            let places = triangle.map(|i| mesh.positions[i as usize]);
            *normals = [mesh.normals.len() as u32; 3];
            mesh.normals.push(unit(geometric_normal(places)));
        }
    }
}

/// Gives triangles without texture coordinates 0, 0 if others have some; takes all away if
/// none has any.
fn fill_missing_uvs(mesh: &mut Mesh) {
    if mesh.triangle_uvs.iter().all(|&uvs| uvs == NONE) {
        mesh.triangle_uvs.clear();
        mesh.uvs.clear();
        return;
    }
    let origin = mesh.uvs.len() as u32;
    mesh.uvs.push([0.0; 2]);
    for uvs in mesh.triangle_uvs.iter_mut().filter(|uvs| **uvs == NONE) {
        *uvs = [origin; 3];
    }
}

/// Leaves out vectors that no triangle refers to.
fn compact<T: Copy>(vectors: &mut Vec<T>, triangles: &mut [[u32; 3]]) {
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
