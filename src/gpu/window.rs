//! Which primitives lie in which buffers.
//!
//! A binding holds so many bytes (128 MiB on lavapipe). Primitives that need
//! more lie in several sets of buffers, windows, that are bound one after the
//! other.

use std::ops::Range;

use crate::flat::Flat;
use crate::layout::{CornerNormals, Disk, Dispatch, Plane, Run, Sphere, Triangle};

/// A band of rows.
#[derive(Debug, Clone, Copy)]
pub(super) struct Tile {
    pub(super) first_row: u32,
    pub(super) rows: u32,
}

/// Consecutive primitive ids, as many as bindings of `binding_bytes` hold.
#[derive(Debug, Clone, PartialEq, Eq)]
pub(super) struct Window {
    pub(super) ids: Range<u32>,
}

impl Window {
    /// The windows of a scene: at least one, which is empty in an empty scene.
    pub(super) fn split(flat: &Flat<f32>, binding_bytes: u64) -> Vec<Self> {
        let room = |stride: usize| {
            u32::try_from(binding_bytes / stride as u64)
                .unwrap_or(u32::MAX)
                .max(1)
        };
        let kinds = [
            (flat.first_plane(), room(size_of::<Sphere<f32>>())),
            (flat.first_disk(), room(size_of::<Plane<f32>>())),
            (flat.first_triangle(), room(size_of::<Disk<f32>>())),
            (
                flat.primitives(),
                room(size_of::<Triangle<f32>>().max(size_of::<CornerNormals>())),
            ),
        ];
        let mut windows = Vec::new();
        let mut begin = 0;
        while begin < flat.primitives() {
            let mut end = begin;
            for (past_kind, room) in kinds {
                if end < past_kind {
                    end = past_kind.min(end.saturating_add(room));
                    // A kind that does not end here is the window's last.
                    if end < past_kind {
                        break;
                    }
                }
            }
            windows.push(Self { ids: begin..end });
            begin = end;
        }
        if windows.is_empty() {
            windows.push(Self { ids: 0..0 });
        }
        windows
    }

    /// The window's spheres, as indices into the scene's.
    pub(super) fn spheres(&self, flat: &Flat<f32>) -> Range<u32> {
        part(&self.ids, flat.first_sphere(), flat.first_plane())
    }

    /// The window's planes, as indices into the scene's.
    pub(super) fn planes(&self, flat: &Flat<f32>) -> Range<u32> {
        part(&self.ids, flat.first_plane(), flat.first_disk())
    }

    /// The window's disks, as indices into the scene's.
    pub(super) fn disks(&self, flat: &Flat<f32>) -> Range<u32> {
        part(&self.ids, flat.first_disk(), flat.first_triangle())
    }

    /// The window's triangles, as indices into the scene's.
    pub(super) fn triangles(&self, flat: &Flat<f32>) -> Range<u32> {
        part(&self.ids, flat.first_triangle(), flat.primitives())
    }

    /// The orders for a dispatch over `tile` that concerns `ids` of the window.
    pub(super) fn orders(&self, flat: &Flat<f32>, ids: Range<u32>, tile: Tile) -> Dispatch {
        let run = |first: u32, past: u32| {
            let bound = part(&self.ids, first, past);
            let concerned = part(&ids, first, past);
            Run {
                begin: concerned.start - bound.start,
                end: concerned.end - bound.start,
                first_id: first + bound.start,
                padding: 0,
            }
        };
        Dispatch {
            size: flat.size,
            first_row: tile.first_row,
            rows: tile.rows,
            spheres: run(flat.first_sphere(), flat.first_plane()),
            planes: run(flat.first_plane(), flat.first_disk()),
            disks: run(flat.first_disk(), flat.first_triangle()),
            triangles: run(flat.first_triangle(), flat.primitives()),
            first_id: self.ids.start,
            primitives: self.ids.end - self.ids.start,
            fresh: u32::from(ids.start == 0),
            padding: 0,
        }
    }
}

/// The part of `ids` from `first` to before `past`, counted from `first`.
fn part(ids: &Range<u32>, first: u32, past: u32) -> Range<u32> {
    ids.start.clamp(first, past) - first..ids.end.clamp(first, past) - first
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::scene::Scene;

    /// 10 primitives: 7 spheres, a plane, a disk, a triangle.
    fn shapes() -> Flat<f32> {
        let mut flat = crate::flatten::flatten::<f32>(&Scene::default());
        flat.spheres = vec![Sphere::default(); 7];
        flat.planes = vec![Plane::default()];
        flat.disks = vec![Disk::default()];
        flat.triangles = vec![Triangle::default()];
        flat.material_indices = vec![0; 10];
        flat
    }

    fn split(binding_bytes: u64) -> Vec<Range<u32>> {
        Window::split(&shapes(), binding_bytes)
            .into_iter()
            .map(|window| window.ids)
            .collect()
    }

    #[test]
    fn a_large_binding_holds_all() {
        assert_eq!(split(1 << 20).as_slice(), std::slice::from_ref(&(0..10)));
    }

    #[test]
    fn windows_are_cut_where_a_kind_is_full() {
        // Three spheres of 16 bytes, one plane, disk or triangle of up to 48.
        assert_eq!(split(48), [0..3, 3..6, 6..10]);
        // A binding that holds less than one primitive takes one all the same,
        // and the device refuses it.
        assert_eq!(split(1).len(), 7);
    }

    #[test]
    fn orders_count_from_the_window() {
        let flat = shapes();
        let window = &Window::split(&flat, 48)[2];
        let orders = window.orders(
            &flat,
            8..10,
            Tile {
                first_row: 0,
                rows: 1,
            },
        );
        assert_eq!((orders.spheres.begin, orders.spheres.end), (1, 1));
        assert_eq!((orders.spheres.first_id, orders.planes.first_id), (6, 7));
        assert_eq!(
            (orders.disks.begin, orders.disks.end, orders.disks.first_id),
            (0, 1, 8)
        );
        assert_eq!(
            (orders.first_id, orders.primitives, orders.fresh),
            (6, 4, 0)
        );
    }

    #[test]
    fn an_empty_scene_has_one_empty_window() {
        let flat = crate::flatten::flatten::<f32>(&Scene::default());
        assert_eq!(Window::split(&flat, 1 << 20), [Window { ids: 0..0 }]);
    }
}
