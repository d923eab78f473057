//! A band of rows, and what a dispatch over it is to do.

use std::ops::Range;

use crate::flat::Flat;
use crate::layout::{Dispatch, Run};

/// Pixels of a workgroup across and down.
pub(super) const WORKGROUP: u32 = 8;

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
    pub(super) fn list_orders(self, flat: &Flat<f32>, steps: Range<u32>, total: u32) -> Dispatch {
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

    /// The orders for a dispatch over the tile that concerns `rows`: the rows of all
    /// the kinds' tables, counted through spheres, planes, disks and triangles.
    pub(super) fn orders(self, flat: &Flat<f32>, rows: Range<u32>) -> Dispatch {
        let run = |first: u32, past: u32| Run {
            begin: rows.start.clamp(first, past) - first,
            end: rows.end.clamp(first, past) - first,
            padding: [0; 2],
        };
        let workgroups_across = flat.size[0].div_ceil(WORKGROUP);
        let workgroups = workgroups_across * self.rows.div_ceil(WORKGROUP);
        Dispatch {
            size: flat.size,
            first_row: self.first_row,
            rows: self.rows,
            spheres: run(flat.first_sphere(), flat.first_plane()),
            planes: run(flat.first_plane(), flat.first_disk()),
            disks: run(flat.first_disk(), flat.first_triangle()),
            triangles: run(flat.first_triangle(), flat.primitives()),
            fresh: u32::from(rows.start == 0),
            workgroups,
            workgroups_across,
            stride: if self.spread { stride(workgroups) } else { 1 },
            steps: rows.end - rows.start,
            last: 1,
            padding: [0; 2],
        }
    }
}

/// A step that visits all of `count` places and lands far from the last ones: near
/// the golden section, and coprime to `count`.
fn stride(count: u32) -> u32 {
    let golden = (f64::from(count) * 0.618_034) as u32;
    (golden.max(1)..=count)
        .find(|&step| greatest_common_divisor(step, count) == 1)
        .unwrap_or(1)
}

fn greatest_common_divisor(a: u32, b: u32) -> u32 {
    if b == 0 {
        a
    } else {
        greatest_common_divisor(b, a % b)
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::effects::{DIVIDE_NATIVE, Device, Fetch, select_files};
    use crate::gpu::program::Program;
    use crate::layout::{Corners, Disk, Plane, Sphere};
    use crate::scene::Scene;

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

    #[test]
    fn every_workgroup_has_its_own_place() {
        for count in [1, 2, 3, 8, 36, 625, 15_625, 16_384] {
            let stride = stride(count);
            let mut seen = vec![false; count as usize];
            for group in 0..count {
                seen[((group * stride) % count) as usize] = true;
            }
            assert!(seen.iter().all(|seen| *seen), "{stride} of {count}");
        }
        // The control: a step that is not coprime leaves places out.
        assert_eq!(greatest_common_divisor(10, 625), 5);
    }

    #[test]
    fn the_shader_has_workgroups_of_this_size() {
        let device = Device {
            divide: DIVIDE_NATIVE,
            fetch: Fetch::Storage,
            count: false,
        };
        let program = Program::build(&select_files(|_| true, device)).unwrap();
        for entry in &program.module.entry_points {
            assert_eq!(entry.workgroup_size, [WORKGROUP * WORKGROUP, 1, 1]);
        }
    }
}
