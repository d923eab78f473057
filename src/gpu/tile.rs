//! A band of rows, and what a dispatch over it is to do.

use std::ops::Range;

use crate::flat::Flat;
use crate::layout::{Dispatch, Run};

/// Pixels of a workgroup across and down.
pub(super) const WORKGROUP: u32 = 8;

/// Slices of a tile whose workgroups are spread: enough for as many threads, each of
/// which a software driver gives the workgroups of a slice.
pub(super) const SLICES: u32 = 16;

/// A band of rows.
#[derive(Debug, Clone, Copy)]
pub(super) struct Tile {
    pub(super) first_row: u32,
    pub(super) rows: u32,
    /// Whether the workgroups are spread over the tile.
    pub(super) spread: bool,
}

impl Tile {
    /// The orders for a dispatch over the tile that takes each ray so many steps on
    /// through the list of volumes, of `total`.
    pub(super) fn list_orders<R>(self, flat: &Flat<R>, steps: Range<u32>, total: u32) -> Dispatch {
        // The planes, which are in no volume, come first.
        let planes = if steps.start == 0 {
            flat.first_plane()..flat.first_disk()
        } else {
            0..0
        };
        Dispatch {
            fresh: u32::from(steps.start == 0),
            steps: steps.end - steps.start,
            last: u32::from(steps.end == total),
            ..self.orders(flat, planes)
        }
    }

    /// The orders for a dispatch over the tile in which each ray tests all there is to test.
    pub(super) fn all_orders<R>(self, flat: &Flat<R>) -> Dispatch {
        Dispatch {
            steps: flat.primitives() + flat.volumes.len() as u32,
            ..self.orders(flat, 0..flat.primitives())
        }
    }

    /// Workgroups of a dispatch: across, down a slice, slices.
    pub(super) fn workgroups(self, orders: &Dispatch) -> [u32; 3] {
        let down = self.rows.div_ceil(WORKGROUP);
        let across = orders.size[0].div_ceil(WORKGROUP);
        [across, down.div_ceil(orders.slices), orders.slices]
    }

    /// The orders for a dispatch over the tile that concerns `rows`: the rows of all
    /// the kinds' tables, counted through spheres, planes, disks and triangles.
    pub(super) fn orders<R>(self, flat: &Flat<R>, rows: Range<u32>) -> Dispatch {
        let run = |first: u32, past: u32| Run {
            begin: rows.start.clamp(first, past) - first,
            end: rows.end.clamp(first, past) - first,
            padding: [0; 2],
        };
        let slices = if self.spread { SLICES } else { 1 };
        Dispatch {
            size: flat.size,
            first_row: self.first_row,
            rows: self.rows,
            spheres: run(flat.first_sphere(), flat.first_plane()),
            planes: run(flat.first_plane(), flat.first_disk()),
            disks: run(flat.first_disk(), flat.first_triangle()),
            triangles: run(flat.first_triangle(), flat.primitives()),
            fresh: u32::from(rows.start == 0),
            slices: slices.min(self.rows.div_ceil(WORKGROUP)),
            steps: rows.end - rows.start,
            last: 1,
            first_doubtful: 0,
            legs: 0,
            sample: 0,
            band_row: 0,
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::effects::{DIVIDE_NATIVE, Device, Entry, Fetch, select_files};
    use crate::gpu::program::Program;
    use crate::layout::{Corners, Disk, Plane, Sphere};
    use crate::scene::Scene;
    use crate::tier::{Formulas, Width};

    /// 10 primitives: 7 spheres, a plane, a disk, a triangle.
    fn shapes() -> Flat<f32> {
        let mut flat = crate::flatten::flatten::<f32>(&Scene::default());
        flat.spheres = vec![Sphere::default(); 7];
        flat.planes = vec![Plane::default()];
        flat.disks = vec![Disk::default()];
        flat.triangles = vec![Corners::default()];
        flat.material_indices = vec![0; 10];
        flat
    }

    #[test]
    fn orders_count_within_each_kind() {
        let tile = Tile {
            first_row: 0,
            rows: 1,
            spread: true,
        };
        let run = |run: Run| (run.begin, run.end);
        let orders = tile.orders(&shapes(), 5..9);
        assert_eq!(run(orders.spheres), (5, 7));
        assert_eq!(run(orders.planes), (0, 1));
        assert_eq!(run(orders.disks), (0, 1));
        assert_eq!(run(orders.triangles), (0, 0));
        assert_eq!(orders.fresh, 0);
        assert_eq!(tile.orders(&shapes(), 0..9).fresh, 1);
    }

    /// Every row of workgroups is dispatched once, those of a slice far apart.
    #[test]
    fn slices_cover_the_tile() {
        for (rows, spread) in [
            (1, true),
            (8, true),
            (61, true),
            (1000, true),
            (1000, false),
        ] {
            let tile = Tile {
                first_row: 0,
                rows,
                spread,
            };
            let orders = tile.orders(&shapes(), 0..1);
            let [_, down, slices] = tile.workgroups(&orders);
            let mut seen = vec![0; rows.div_ceil(WORKGROUP) as usize];
            for (slice, row) in (0..slices).flat_map(|z| (0..down).map(move |y| (z, y))) {
                if let Some(seen) = seen.get_mut((row * orders.slices + slice) as usize) {
                    *seen += 1;
                }
            }
            assert!(seen.iter().all(|&seen| seen == 1), "{rows} rows: {seen:?}");
            assert_eq!(slices > 1, spread && rows > WORKGROUP);
        }
    }

    #[test]
    fn the_shader_has_workgroups_of_this_size() {
        let device = Device {
            divide: DIVIDE_NATIVE,
            formulas: Formulas::Stable,
            width: Width::Single,
            entry: Entry::Tile,
            fetch: Fetch::Storage,
            count: false,
        };
        let program = Program::build(&select_files(|_| true, device)).unwrap();
        for entry in &program.module.entry_points {
            assert_eq!(entry.workgroup_size, [WORKGROUP * WORKGROUP, 1, 1]);
        }
    }
}
