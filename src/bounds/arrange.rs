//! Primitives in the order of their volumes, so that what one holds is a run of rows.

use crate::flat::Flat;

/// Puts the rows of each kind's table into the order of `ids`, and tells the row of
/// each of them. They are all primitives but the planes, or none.
pub(super) fn arrange<R: Copy>(flat: &mut Flat<R>, ids: &[u32]) -> Vec<u32> {
    // The ids of each kind, in the order wanted.
    let mut orders: [Vec<u32>; 3] = Default::default();
    let rows = ids
        .iter()
        .map(|&id| {
            let order = &mut orders[flat.kind_of(id).0 as usize];
            order.push(id);
            order.len() as u32 - 1
        })
        .collect();
    if !ids.is_empty() {
        let [spheres, disks, triangles] = orders;
        let sources = sources(&flat.sphere_ids, &spheres, flat.first_sphere());
        flat.spheres = picked(&flat.spheres, &sources);
        flat.sphere_ids = spheres;
        let sources = self::sources(&flat.disk_ids, &disks, flat.first_disk());
        flat.disks = picked(&flat.disks, &sources);
        flat.disk_ids = disks;
        let ids: Vec<u32> = flat.triangles.iter().map(|corners| corners.id).collect();
        let sources = self::sources(&ids, &triangles, flat.first_triangle());
        flat.triangles = picked(&flat.triangles, &sources);
    }
    rows
}

/// The row of `ids` in which each of `order` stands.
fn sources(ids: &[u32], order: &[u32], first_id: u32) -> Vec<u32> {
    let mut rows = vec![0; ids.len()];
    for (&id, row) in ids.iter().zip(0..) {
        rows[(id - first_id) as usize] = row;
    }
    order
        .iter()
        .map(|&id| rows[(id - first_id) as usize])
        .collect()
}

fn picked<T: Copy>(table: &[T], sources: &[u32]) -> Vec<T> {
    sources.iter().map(|&row| table[row as usize]).collect()
}
