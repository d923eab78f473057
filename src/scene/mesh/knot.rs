//! A smooth tube along a torus knot.

use std::f64::consts::TAU;

use glam::{DVec3, dvec3};
use rayon::prelude::*;

use super::super::Mesh;
use super::{grid, smooth};

/// Turns around the torus's axis.
const P: f64 = 2.0;
/// Turns around the torus's tube.
const Q: f64 = 3.0;
/// Radius of the torus's middle circle; with the two below the knot reaches to
/// 1.5 from its axis.
const MAJOR: f64 = 1.0;
/// Radius of the torus's tube, on which the knot lies. The two strands that pass
/// at opposite sides of it are up to 0.7 apart, well over two [`TUBE`]s.
const MINOR: f64 = 0.35;
/// Radius of the knot's own tube.
const TUBE: f64 = 0.15;

/// Fewer sides are no tube.
const LEAST_SIDES: u32 = 3;
/// Eight to a turn of [`Q`]; with fewer, neighbouring rings cut each other.
const LEAST_RINGS: u32 = 24;

/// The (2, 3) torus knot around the z axis. S sides and R rings give 2 S R
/// triangles, at least 144: S makes a quad as long as it is wide on average,
/// then R brings the count within S of `detail`.
pub(super) fn knot(detail: u32) -> Mesh {
    let [rings, sides] = split(detail);
    let frames = closed_frames(rings);
    let around: Vec<(f64, f64)> = (0..sides)
        .map(|j| (TAU * f64::from(j) / f64::from(sides)).sin_cos())
        .collect();

    let (positions, normals): (Vec<DVec3>, Vec<DVec3>) = frames
        .par_iter()
        .flat_map_iter(|frame| {
            around.iter().map(|&(sin, cos)| {
                let normal = (frame.first * cos + frame.second() * sin).normalize();
                (frame.center + normal * TUBE, normal)
            })
        })
        .unzip();
    let index = |i, j| (i % rings) * sides + j % sides;
    let [along, across] = [rings, sides].map(f64::from);
    Mesh {
        // u once along the tube, v once around it.
        uvs: grid::uvs(rings, sides, |i, j| [i / along, (across - j) / across]),
        triangle_uvs: grid::uv_triangles(rings, sides, index),
        ..smooth(positions, normals, grid::triangles(rings, sides, index))
    }
}

/// [rings, sides] for a wished number of triangles.
fn split(detail: u32) -> [u32; 2] {
    let detail = f64::from(detail);
    let rings_per_side = length() / (TAU * TUBE);
    let sides = (detail / (2.0 * rings_per_side)).sqrt().round();
    let sides = sides.max(f64::from(LEAST_SIDES));
    let rings = (detail / (2.0 * sides)).round();
    [(rings as u32).max(LEAST_RINGS), sides as u32]
}

/// The knot's middle line and its derivative at t in 0..TAU.
fn curve(t: f64) -> (DVec3, DVec3) {
    let (sin_p, cos_p) = (P * t).sin_cos();
    let (sin_q, cos_q) = (Q * t).sin_cos();
    let reach = MAJOR + MINOR * cos_q;
    let reach_slope = -MINOR * Q * sin_q;
    (
        dvec3(reach * cos_p, reach * sin_p, MINOR * sin_q),
        dvec3(
            reach_slope * cos_p - reach * P * sin_p,
            reach_slope * sin_p + reach * P * cos_p,
            MINOR * Q * cos_q,
        ),
    )
}

/// Length of the middle line, by the trapezoidal rule, which converges
/// exponentially on a smooth closed curve: 64 steps give all digits needed.
fn length() -> f64 {
    let steps = 64;
    let speed = |i: u32| curve(TAU * f64::from(i) / f64::from(steps)).1.length();
    (0..steps).map(speed).sum::<f64>() * TAU / f64::from(steps)
}

/// A cross-section's place and orientation.
#[derive(Clone, Copy)]
struct Frame {
    center: DVec3,
    /// Unit.
    tangent: DVec3,
    /// Unit, perpendicular to `tangent`.
    first: DVec3,
}

impl Frame {
    fn second(&self) -> DVec3 {
        self.tangent.cross(self.first)
    }

    /// This frame turned around its tangent.
    fn turned(self, angle: f64) -> Self {
        let (sin, cos) = angle.sin_cos();
        Self {
            first: self.first * cos + self.second() * sin,
            ..self
        }
    }

    /// `first` carried to (`center`, `tangent`) without twist: double reflection
    /// (W. Wang, B. Juettler, D. Zheng, Y. Liu, "Computation of Rotation
    /// Minimizing Frames", ACM TOG 27(1), 2008, section 4).
    fn carried(self, center: DVec3, tangent: DVec3) -> Self {
        let reflect = |v: DVec3, axis: DVec3| v - axis * (2.0 * axis.dot(v) / axis.dot(axis));
        let chord = center - self.center;
        let halfway = reflect(self.first, chord);
        let first = reflect(halfway, tangent - reflect(self.tangent, chord));
        Self {
            center,
            tangent,
            // Rounding adds up along thousands of rings; without this the first
            // would leave the cross-section's plane.
            first: (first - tangent * tangent.dot(first)).normalize(),
        }
    }
}

/// Frames at `rings` equal steps of t, with the least twist that closes: carried
/// once around without twist the frame comes back turned by some angle, and
/// each ring takes back an equal share of it.
fn closed_frames(rings: u32) -> Vec<Frame> {
    let at = |i: u32| {
        let (center, slope) = curve(TAU * f64::from(i % rings) / f64::from(rings));
        (center, slope.normalize())
    };
    let (center, tangent) = at(0);
    let start = Frame {
        center,
        tangent,
        first: tangent.any_orthonormal_vector(),
    };
    let mut frames = vec![start];
    for i in 1..=rings {
        let (center, tangent) = at(i);
        frames.push(frames[i as usize - 1].carried(center, tangent));
    }
    let end = frames.pop().unwrap_or(start);
    let turn = f64::atan2(end.first.dot(start.second()), end.first.dot(start.first));
    let share = turn / f64::from(rings);
    let turned_back = |(i, frame): (usize, Frame)| frame.turned(-share * i as f64);
    frames.into_iter().enumerate().map(turned_back).collect()
}

#[cfg(test)]
mod tests {
    use super::super::check::closer_than;
    use super::*;

    #[test]
    fn counts_are_within_one_ring() {
        for detail in (200..3000).step_by(7).chain([100_000, 10_000_000]) {
            let [rings, sides] = split(detail);
            assert!((2 * rings * sides).abs_diff(detail) <= sides, "{detail}");
        }
        assert_eq!(split(0), [LEAST_RINGS, LEAST_SIDES]);
    }

    #[test]
    fn quads_are_near_square() {
        for detail in [2_000, 12_000, 100_000] {
            let [rings, sides] = split(detail).map(f64::from);
            let aspect = (length() / rings) / (TAU * TUBE / sides);
            // `sides` is rounded by up to a half, and the aspect is its square.
            let slack = (1.0 + 0.5 / (sides - 0.5)).powi(2);
            assert!(aspect < slack && aspect > 1.0 / slack, "{aspect}");
        }
    }

    #[test]
    fn the_frame_closes_without_a_seam() {
        let frames = closed_frames(300);
        let turn = |a: Frame, b: Frame| {
            let carried = a.carried(b.center, b.tangent);
            f64::atan2(
                carried.first.cross(b.first).dot(b.tangent),
                carried.first.dot(b.first),
            )
        };
        let turns: Vec<f64> = (0..300)
            .map(|i| turn(frames[i], frames[(i + 1) % 300]))
            .collect();
        // Each step carries the same share; 300 carried frames and one atan2
        // round by some ulps each.
        for t in &turns {
            assert!(
                (t - turns[0]).abs() < 300.0 * 16.0 * f64::EPSILON,
                "{t} {}",
                turns[0]
            );
        }
        // Control: frames that were not turned back do not close.
        let mut open = frames.clone();
        open[299] = open[299].turned(0.01);
        assert!((turn(open[299], open[0]) - turns[0]).abs() > 0.005);
    }

    #[test]
    fn strands_keep_apart() {
        let steps = 600;
        let points: Vec<DVec3> = (0..steps)
            .map(|i| curve(TAU * f64::from(i) / f64::from(steps)).0)
            .collect();
        let mut least = f64::MAX;
        for i in 0..steps {
            for j in 0..i {
                // Neighbours along the knot, up to a sixth of it, are no strands.
                let gap = (i - j).min(steps - (i - j));
                if gap > steps / 6 {
                    least = least.min(points[i as usize].distance(points[j as usize]));
                }
            }
        }
        assert!(least > 2.0 * TUBE, "{least}");
    }

    #[test]
    fn vertices_keep_apart() {
        let mesh = knot(12_000);
        let [rings, sides] = split(12_000).map(f64::from);
        let step = TAU / rings;
        let speeds = (0..256).map(|i| curve(TAU * f64::from(i) / 256.0).1.length());
        let slowest = speeds.fold(f64::MAX, f64::min);
        let bends = (0..256).map(|i| {
            let t = TAU * f64::from(i) / 256.0;
            let [(_, a), (_, b)] = [curve(t), curve(t + step)];
            a.normalize().distance(b.normalize()) / (a.length() * step)
        });
        let sharpest = bends.fold(0.0, f64::max);
        // Along the tube the inner side of a bend is shorter by TUBE * curvature;
        // half covers chord against arc.
        let along = slowest * step * (1.0 - TUBE * sharpest);
        let across = 2.0 * TUBE * (TAU / 2.0 / sides).sin();
        let bound = 0.5 * along.min(across);
        assert_eq!(closer_than(&mesh, bound), None);
        assert!(closer_than(&mesh, 4.0 * bound).is_some());
    }

    #[test]
    fn the_knot_reaches_where_it_should() {
        let mesh = knot(100_000);
        let reach = mesh.positions.iter().map(|p| p.truncate().length());
        let reach = reach.fold(0.0, f64::max);
        assert!((reach - (MAJOR + MINOR + TUBE)).abs() < 0.001, "{reach}");
    }
}
