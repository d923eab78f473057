//! Up to four triangles that are tested at once.

use crate::flat::Flat;
use crate::kernel::probe::Probe;
use crate::kernel::real::{Real, constant};
use crate::kernel::triangle_bounded::TRIANGLE_ERROR;
use crate::kernel::triangle_textbook::EDGE_ON;
use crate::kernel::triangles::triangle_of;
use crate::kernel::vector::taxicab_length;
use crate::layout::Triangle;
use crate::tier::Formulas;

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

    /// The lanes, a bit each, that the ray may meet.
    #[inline]
    pub fn met(&self, probe: &Probe<R>) -> u32 {
        let met = match R::FORMULAS {
            Formulas::Textbook => self.met_by_determinant(probe),
            _ => self.met_by_edges(probe),
        };
        met & ((1 << self.count) - 1)
    }

    /// Those that the ray does not pass by on one side: the signs of the edge functions,
    /// with the very roundings of [`crate::kernel::triangle::passes_between`], or of
    /// [`crate::kernel::triangle_bounded`] and past its bounds.
    #[inline]
    fn met_by_edges(&self, probe: &Probe<R>) -> u32 {
        let shear = probe.shear;
        let origin: [R; 3] = probe.ray.origin.into();
        let axis = shear.axis as usize;
        let (x, y, z) = (NEXT[axis], NEXT[axis + 1], axis);
        let mut distance = [R::ZERO; LANES];
        let mut sheared = |corner: &[Lane<R>; 3]| {
            let mut across = [R::ZERO; LANES];
            let mut up = [R::ZERO; LANES];
            for lane in 0..LANES {
                let along = corner[z][lane] - origin[z];
                let right = corner[x][lane] - origin[x];
                let above = corner[y][lane] - origin[y];
                across[lane] = right - shear.x * along;
                up[lane] = above - shear.y * along;
                if R::FORMULAS == Formulas::Bounded {
                    let far = (right.abs() + above.abs()) + along.abs();
                    if far > distance[lane] {
                        distance[lane] = far;
                    }
                }
            }
            (across, up)
        };
        let (ax, ay) = sheared(&self.corners[0]);
        let (bx, by) = sheared(&self.corners[1]);
        let (cx, cy) = sheared(&self.corners[2]);
        let beyond = R::TWO * taxicab_length(probe.ray.origin);
        let mut met = 0;
        for lane in 0..LANES {
            let (u_left, u_right) = (cx[lane] * by[lane], cy[lane] * bx[lane]);
            let (v_left, v_right) = (ax[lane] * cy[lane], ay[lane] * cx[lane]);
            let (w_left, w_right) = (bx[lane] * ay[lane], by[lane] * ax[lane]);
            let (negative, positive) = if R::FORMULAS == Formulas::Bounded {
                let error = (distance[lane] + beyond) * constant(TRIANGLE_ERROR);
                let twice = R::TWO * error;
                let a_size = ax[lane].abs() + ay[lane].abs();
                let b_size = bx[lane].abs() + by[lane].abs();
                let c_size = cx[lane].abs() + cy[lane].abs();
                let u_slack = ((b_size + c_size) + twice) * error;
                let v_slack = ((c_size + a_size) + twice) * error;
                let w_slack = ((a_size + b_size) + twice) * error;
                let [u, v, w] = [u_left - u_right, v_left - v_right, w_left - w_right];
                (
                    (u < -u_slack) | (v < -v_slack) | (w < -w_slack),
                    (u > u_slack) | (v > v_slack) | (w > w_slack),
                )
            } else {
                (
                    !((u_left >= u_right) & (v_left >= v_right) & (w_left >= w_right)),
                    !((u_left <= u_right) & (v_left <= v_right) & (w_left <= w_right)),
                )
            };
            met |= u32::from(!(negative & positive)) << lane;
        }
        met
    }

    /// Those that the textbook's formula does not miss, with the very roundings of
    /// [`crate::kernel::triangle_textbook`].
    #[inline]
    fn met_by_determinant(&self, probe: &Probe<R>) -> u32 {
        let [dx, dy, dz]: [R; 3] = probe.ray.direction.into();
        let [ox, oy, oz]: [R; 3] = probe.ray.origin.into();
        let [a, b, c] = &self.corners;
        let mut met = 0;
        for lane in 0..LANES {
            let (ex, ey, ez) = (
                b[0][lane] - a[0][lane],
                b[1][lane] - a[1][lane],
                b[2][lane] - a[2][lane],
            );
            let (fx, fy, fz) = (
                c[0][lane] - a[0][lane],
                c[1][lane] - a[1][lane],
                c[2][lane] - a[2][lane],
            );
            let (px, py, pz) = (dy * fz - dz * fy, dz * fx - dx * fz, dx * fy - dy * fx);
            let determinant = (ex * px + ey * py) + ez * pz;
            let inverse = constant::<R>(1.0) / determinant;
            let (sx, sy, sz) = (ox - a[0][lane], oy - a[1][lane], oz - a[2][lane]);
            let u = ((sx * px + sy * py) + sz * pz) * inverse;
            let (qx, qy, qz) = (sy * ez - sz * ey, sz * ex - sx * ez, sx * ey - sy * ex);
            let v = ((dx * qx + dy * qy) + dz * qz) * inverse;
            let outside = (u < R::ZERO) | (v < R::ZERO) | (u + v > constant(1.0));
            let edge_on = determinant.abs() < constant(EDGE_ON);
            met |= u32::from(!(outside | edge_on)) << lane;
        }
        met
    }
}

/// After each axis the next one.
const NEXT: [usize; 4] = [1, 2, 0, 1];
