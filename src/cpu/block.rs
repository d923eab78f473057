//! Up to four triangles that are tested at once.

use crate::flat::Flat;
use crate::kernel::probe::Probe;
use crate::kernel::real::Real;
use crate::kernel::triangles::triangle_of;
use crate::layout::Triangle;

/// Triangles of a block.
pub const LANES: usize = 4;

/// One number of each triangle.
type Lane<R> = [R; LANES];

/// The triangles of a leaf, number by number.
#[derive(Debug, Clone, Copy)]
pub struct Block<R> {
    /// Of each corner and each axis, the coordinates. Lanes that stand empty repeat the
    /// last triangle.
    corners: [[Lane<R>; 3]; 3],
    /// The ids.
    pub ids: Lane<u32>,
    /// Row of the first triangle.
    pub first: u32,
    /// How many there are.
    pub count: u32,
}

impl<R: Real> Block<R> {
    /// The triangles from row `first` on.
    pub fn new(flat: &Flat<R>, first: u32, count: u32) -> Self {
        let mut block = Self {
            corners: Default::default(),
            ids: [0; LANES],
            first,
            count,
        };
        for lane in 0..LANES {
            let row = first + (lane as u32).min(count - 1);
            let corners = flat.triangles[row as usize];
            let triangle = triangle_of(flat, corners);
            for (corner, position) in [triangle.a, triangle.b, triangle.c].iter().enumerate() {
                for (axis, &coordinate) in position.iter().enumerate() {
                    block.corners[corner][axis][lane] = coordinate;
                }
            }
            block.ids[lane] = corners.id;
        }
        block
    }

    /// The triangle in a lane.
    pub fn triangle(&self, lane: usize) -> Triangle<R> {
        let corner = |corner: usize| self.corners[corner].map(|axis| axis[lane]);
        Triangle {
            a: corner(0),
            padding_0: R::ZERO,
            b: corner(1),
            padding_1: R::ZERO,
            c: corner(2),
            padding_2: R::ZERO,
        }
    }

    /// The lanes, a bit each, that the ray does not pass by on one side: the signs of
    /// the edge functions, with the very roundings of
    /// [`crate::kernel::triangle::edge_functions`].
    #[inline]
    pub fn met(&self, probe: &Probe<R>) -> u32 {
        let shear = probe.shear;
        let origin: [R; 3] = probe.ray.origin.into();
        let axis = shear.axis as usize;
        let (x, y, z) = (NEXT[axis], NEXT[axis + 1], axis);
        let sheared = |corner: &[Lane<R>; 3]| {
            let mut across = [R::ZERO; LANES];
            let mut up = [R::ZERO; LANES];
            for lane in 0..LANES {
                let along = corner[z][lane] - origin[z];
                across[lane] = (corner[x][lane] - origin[x]) - shear.x * along;
                up[lane] = (corner[y][lane] - origin[y]) - shear.y * along;
            }
            (across, up)
        };
        let (ax, ay) = sheared(&self.corners[0]);
        let (bx, by) = sheared(&self.corners[1]);
        let (cx, cy) = sheared(&self.corners[2]);
        let mut met = 0;
        for lane in 0..LANES {
            let (u_left, u_right) = (cx[lane] * by[lane], cy[lane] * bx[lane]);
            let (v_left, v_right) = (ax[lane] * cy[lane], ay[lane] * cx[lane]);
            let (w_left, w_right) = (bx[lane] * ay[lane], by[lane] * ax[lane]);
            let none_negative = (u_left >= u_right) & (v_left >= v_right) & (w_left >= w_right);
            let none_positive = (u_left <= u_right) & (v_left <= v_right) & (w_left <= w_right);
            met |= u32::from(none_negative | none_positive) << lane;
        }
        met & ((1 << self.count) - 1)
    }
}

/// After each axis the next one.
const NEXT: [usize; 4] = [1, 2, 0, 1];
