//! The scene as the shaders read it: one run of quads, table after table.

use bytemuck::{Pod, cast_slice};

use crate::effects::EffectSet;
use crate::flat::Flat;
use crate::kernel::real::Real;
use crate::layout::{Environment, LampTable, MotionRecord, NONE, QUAD, SamplingRecord, Tables};
use crate::tier::parts_of;

/// Four words.
pub(super) type Quad = [u32; QUAD];

/// A scene in quads.
pub(super) struct PackedScene {
    pub(super) quads: Vec<Quad>,
    pub(super) tables: Tables,
}

/// Where the tables of lights lie that are no points.
#[derive(Clone, Copy, Default)]
pub(super) struct LightTables {
    pub(super) lamps: LampTable,
    pub(super) environment: Environment,
}

impl PackedScene {
    /// Packs a flattened scene, with what forced effects read that it does not call for.
    pub(super) fn of<R: Real>(flat: &Flat<R>, forced: EffectSet) -> Self {
        let mut quads = Vec::with_capacity(flat.bytes() as usize / size_of::<Quad>() + 16);
        let tables = Tables {
            spheres: push_reals::<R, _>(&mut quads, &flat.spheres),
            sphere_ids: push_words(&mut quads, &flat.sphere_ids),
            planes: push_reals::<R, _>(&mut quads, &flat.planes),
            disks: push_reals::<R, _>(&mut quads, &flat.disks),
            disk_ids: push_words(&mut quads, &flat.disk_ids),
            triangles: push_records(&mut quads, &flat.triangles),
            vertices: push_vertices(&mut quads, &flat.vertices),
            vertex_normals: push_normals(&mut quads, flat, forced),
            pairs: push_records(&mut quads, &flat.pairs),
            volumes: push_records(&mut quads, &flat.volumes),
            volume_count: flat.volumes.len() as u32,
            tile_words: flat.tile_words,
            balls: push_reals::<R, _>(&mut quads, &flat.balls),
            boxes: push_records(&mut quads, &flat.boxes),
            materials: push_records(&mut quads, &flat.materials),
            material_indices: push_words(&mut quads, &flat.material_indices),
            lights: push_records(&mut quads, &flat.lights),
            light_count: flat.lights.len() as u32,
            first_plane: flat.first_plane(),
            first_disk: flat.first_disk(),
            first_triangle: flat.first_triangle(),
        };
        // A binding must not be empty.
        if quads.is_empty() {
            quads.push([0; QUAD]);
        }
        Self { quads, tables }
    }

    /// Packs what only paths of light read, and tells where it lies.
    pub(super) fn add_path_tables<R: Real>(&mut self, flat: &Flat<R>) -> SamplingRecord {
        let quads = &mut self.quads;
        SamplingRecord {
            finishes: push_records(quads, &flat.finishes),
            energies: push_words(quads, cast_slice(&flat.energies)),
            vertex_uvs: if flat.vertex_uvs.is_empty() {
                NONE
            } else {
                push_words(quads, cast_slice(&flat.vertex_uvs))
            },
            textures: push_records(quads, &flat.textures),
            texels: push_records(quads, &flat.texels),
            ..flat.sampling
        }
    }

    /// Packs what only paths of light read of lamps that have a size and of the environment,
    /// and tells where it lies.
    pub(super) fn add_light_tables<R: Real>(&mut self, flat: &Flat<R>) -> LightTables {
        let quads = &mut self.quads;
        LightTables {
            lamps: LampTable {
                start: push_records(quads, &flat.lamps),
                count: flat.lamps.len() as u32,
                ..LampTable::default()
            },
            environment: Environment {
                texels: push_records(quads, &flat.sky.texels),
                sums: push_words(quads, cast_slice(&flat.sky.sums)),
                ..flat.environment
            },
        }
    }

    /// Packs how far shapes go while the shutter is open, and tells where that lies.
    pub(super) fn add_motion_tables<R: Real>(&mut self, flat: &Flat<R>) -> MotionRecord {
        let quads = &mut self.quads;
        MotionRecord {
            camera: flat.camera_velocity,
            moving: flat.velocities.len() as u32,
            velocities: push_vectors(quads, &flat.velocities),
            rows: push_words(quads, &flat.velocity_rows),
            padding: [0; 2],
        }
    }

    /// Bytes of all the quads.
    pub(super) fn bytes(&self) -> u64 {
        size_of_val(self.quads.as_slice()) as u64
    }
}

/// Adds a table of records of whole quads, and tells where it begins.
fn push_records<T: Pod>(quads: &mut Vec<Quad>, records: &[T]) -> u32 {
    let begin = quads.len() as u32;
    quads.extend_from_slice(cast_slice(records));
    begin
}

/// Adds a table of records of fours of numbers, each four as the quads of its parts, and
/// tells where it begins.
fn push_reals<R: Real, T: Pod>(quads: &mut Vec<Quad>, records: &[T]) -> u32 {
    let begin = quads.len() as u32;
    let numbers: &[R] = cast_slice(records);
    for four in numbers.as_chunks::<QUAD>().0 {
        push_parts(quads, *four);
    }
    begin
}

/// Adds a table of positions, and tells where it begins.
fn push_vertices<R: Real>(quads: &mut Vec<Quad>, vertices: &[[R; 3]]) -> u32 {
    let begin = quads.len() as u32;
    for &[x, y, z] in vertices {
        push_parts(quads, [x, y, z, R::ZERO]);
    }
    begin
}

/// Adds four numbers as the quads of their parts.
pub(super) fn push_parts<R: Real>(quads: &mut Vec<Quad>, numbers: [R; QUAD]) {
    let parts = numbers.map(parts_of);
    for part in 0..R::WIDTH.parts() {
        quads.push(parts.map(|parts| parts[part].to_bits()));
    }
}

/// Adds a table of words, the last quad filled up, and tells where it begins.
fn push_words(quads: &mut Vec<Quad>, words: &[u32]) -> u32 {
    let begin = quads.len() as u32;
    let (whole, rest) = words.as_chunks::<QUAD>();
    quads.extend_from_slice(whole);
    if !rest.is_empty() {
        let mut last = [0; QUAD];
        last[..rest.len()].copy_from_slice(rest);
        quads.push(last);
    }
    begin
}

/// Adds the normals of the vertices, zero where they are read though the scene has none.
fn push_normals<R>(quads: &mut Vec<Quad>, flat: &Flat<R>, forced: EffectSet) -> u32 {
    if flat.vertex_normals.is_empty() && forced != EffectSet::NONE {
        return push_vectors(quads, &vec![[0.0; 3]; flat.vertices.len()]);
    }
    push_vectors(quads, &flat.vertex_normals)
}

/// Adds a table of vectors, a quad each, and tells where it begins.
fn push_vectors(quads: &mut Vec<Quad>, vectors: &[[f32; 3]]) -> u32 {
    let begin = quads.len() as u32;
    quads.extend(vectors.iter().map(|vector| {
        let [x, y, z] = vector.map(f32::to_bits);
        [x, y, z, 0]
    }));
    begin
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::layout::Sphere;
    use crate::scene::Scene;

    #[test]
    fn tables_begin_at_whole_quads() {
        let mut flat = crate::flatten::flatten::<f32>(&Scene::default());
        let empty = PackedScene::of(&flat, EffectSet::NONE);
        assert_eq!(empty.quads.len(), 1);
        flat.spheres = vec![Sphere::default(); 5];
        flat.sphere_ids = vec![4, 3, 2, 1, 7];
        flat.material_indices = vec![9; 5];
        flat.vertices = vec![[1.0, 2.0, 3.0]];
        let packed = PackedScene::of(&flat, EffectSet::NONE);
        let tables = packed.tables;
        assert_eq!(
            (tables.spheres, tables.sphere_ids, tables.planes),
            (0, 10, 12)
        );
        assert_eq!(packed.quads[10..12], [[4, 3, 2, 1], [7, 0, 0, 0]]);
        let vertex = packed.quads[tables.vertices as usize];
        assert_eq!(vertex[1], 2f32.to_bits());
        assert_eq!(tables.material_indices, 13);
        assert_eq!(packed.bytes(), 16 * 15);
        assert_eq!(flat.bytes(), packed.bytes());
    }
}
