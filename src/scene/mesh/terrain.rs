//! A height field of fractal gradient noise.

use glam::{DVec2, DVec3, dvec2, dvec3};
use rayon::prelude::*;

use super::super::Mesh;
use super::{grid, nearest, smooth};

/// Half the side of the square, in units of the scene.
const HALF_SIDE: f64 = 5.0;
/// Lattice cells of the coarsest octave to a unit: four to the side.
const FREQUENCY: f64 = 0.4;
/// Height of the coarsest octave: hills of about a tenth of the side.
const AMPLITUDE: f64 = 1.7;
/// Each octave has twice the frequency of the one before ...
const LACUNARITY: f64 = 2.0;
/// ... and less than half its height, so that slopes die out with the octaves.
const GAIN: f64 = 0.4;
/// The finest octave has cells of 2.5 / 2^6 = 0.04 units and 0.007 of height.
const OCTAVES: u32 = 7;
/// Gradient noise is 0 on its whole lattice. Shifting the octaves against each
/// other keeps those zeros from meeting; any odd fraction would do.
const SHIFT: f64 = 0.37;

/// Hills over x and z in -5..5, y up; 2 n^2 triangles, n >= 1. The form does not
/// depend on `detail`, only how finely it is sampled. Normals are those of the
/// samples (central differences), for a coarse grid cannot follow the form's own.
pub(super) fn terrain(detail: u32) -> Mesh {
    let n = nearest(detail, 1, |n| 2 * n * n);
    let step = 2.0 * HALF_SIDE / f64::from(n);
    // One sample more on each side, so that the border has neighbours too.
    let across = n + 3;
    let place = |i: u32| (2.0 * f64::from(i) - f64::from(n) - 2.0) * HALF_SIDE / f64::from(n);
    let heights: Vec<f64> = (0..across)
        .into_par_iter()
        .flat_map_iter(|i| (0..across).map(move |j| height(dvec2(place(i), place(j)))))
        .collect();
    let sample = |i: u32, j: u32| heights[(i * across + j) as usize];

    let (positions, normals): (Vec<DVec3>, Vec<DVec3>) = (1..=n + 1)
        .into_par_iter()
        .flat_map_iter(|i| (1..=n + 1).map(move |j| (i, j)))
        .map(|(i, j)| {
            let along_x = sample(i + 1, j) - sample(i - 1, j);
            let along_z = sample(i, j + 1) - sample(i, j - 1);
            let normal = dvec3(-along_x, 2.0 * step, -along_z).normalize();
            (dvec3(place(i), sample(i, j), place(j)), normal)
        })
        .unzip();
    // Rows along z, from row to row along x: z cross x is y, upward.
    let triangles = grid::triangles(n, n, |i, j| i * (n + 1) + j);
    let side = f64::from(n);
    Mesh {
        // u along x, v along -z: upright seen from above with -z upward.
        uvs: grid::uvs(n, n, |i, j| [i / side, (side - j) / side]),
        triangle_uvs: triangles.clone(),
        ..smooth(positions, normals, triangles)
    }
}

/// Height over a point (x, z): the sum of [`OCTAVES`] of noise.
fn height(at: DVec2) -> f64 {
    let [mut frequency, mut amplitude] = [FREQUENCY, AMPLITUDE];
    let mut height = 0.0;
    for octave in 0..OCTAVES {
        let shift = DVec2::splat(SHIFT * f64::from(octave));
        height += amplitude * noise(octave, at * frequency + shift);
        frequency *= LACUNARITY;
        amplitude *= GAIN;
    }
    height
}

/// Gradient noise, -1..1, with the quintic blend that leaves no creases
/// (K. Perlin, "Improving Noise", SIGGRAPH 2002).
fn noise(seed: u32, at: DVec2) -> f64 {
    let cell = at.floor();
    let f = at - cell;
    let corner = |dx: f64, dz: f64| gradient(seed, cell.x + dx, cell.y + dz).dot(f - dvec2(dx, dz));
    let blend = f * f * f * (f * (f * 6.0 - 15.0) + 10.0);
    let mix = |a: f64, b: f64, share: f64| a + share * (b - a);
    mix(
        mix(corner(0.0, 0.0), corner(1.0, 0.0), blend.x),
        mix(corner(0.0, 1.0), corner(1.0, 1.0), blend.x),
        blend.y,
    )
}

/// A pseudo-random vector in the square -1..1, from the integer lattice point.
fn gradient(seed: u32, x: f64, z: f64) -> DVec2 {
    let lattice = |v: f64| v as i64 as u32;
    let bits = hash(lattice(x).wrapping_add(hash(lattice(z).wrapping_add(hash(seed)))));
    let signed = |half: u32| (2.0 * f64::from(half) - 65535.0) / 65535.0;
    dvec2(signed(bits & 0xffff), signed(bits >> 16))
}

/// An integer hash of low bias (C. Wellons, "Prospecting for Hash Functions",
/// 2018: lowbias32).
fn hash(mut x: u32) -> u32 {
    x ^= x >> 16;
    x = x.wrapping_mul(0x7feb_352d);
    x ^= x >> 15;
    x = x.wrapping_mul(0x846c_a68b);
    x ^ (x >> 16)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn normals_are_perpendicular_to_both_chords() {
        let n = 20;
        let mesh = terrain(2 * n * n);
        let at = |i: u32, j: u32| mesh.positions[(i * (n + 1) + j) as usize];
        for (i, j) in (1..n).flat_map(|i| (1..n).map(move |j| (i, j))) {
            let normal = mesh.normals[(i * (n + 1) + j) as usize];
            let chords = [at(i + 1, j) - at(i - 1, j), at(i, j + 1) - at(i, j - 1)];
            for chord in chords {
                // Coordinates up to 5 are rounded, a chord is about 1 long.
                assert!(normal.dot(chord).abs() < 16.0 * 5.0 * f64::EPSILON);
            }
        }
        // On the border too, though the mesh ends there.
        let beside = |x: f64, z: f64| height(dvec2(x, z));
        let along_x = beside(-4.5, -5.0) - beside(-5.5, -5.0);
        let along_z = beside(-5.0, -4.5) - beside(-5.0, -5.5);
        let expected = dvec3(-along_x, 1.0, -along_z).normalize();
        assert_eq!(mesh.normals[0], expected);
        assert_ne!(mesh.normals[1], expected);
    }

    #[test]
    fn noise_has_no_creases() {
        let h = 1.0 / f64::from(1 << 20);
        let slope = |x: f64, z: f64| (noise(1, dvec2(x + h, z)) - noise(1, dvec2(x, z))) / h;
        // Slopes a step apart differ by the curvature times h, and round by some
        // ulps / h; |f''| is below 60 for gradients in the square -1..1.
        let bound = 60.0 * h + 8.0 * f64::EPSILON / h;
        for i in 0..200 {
            let z = f64::from(i) * 0.173 - 17.0;
            assert!((slope(3.0, z) - slope(3.0 - h, z)).abs() < bound, "{z}");
            assert!((slope(3.0, z) - slope(3.5, z)).abs() > bound, "{z}");
        }
    }

    #[test]
    fn noise_is_bounded_and_0_on_its_lattice() {
        let mut largest: f64 = 0.0;
        for i in 0..10_000 {
            let at = dvec2(f64::from(i) * 0.137 - 700.0, f64::from(i) * -0.071);
            largest = largest.max(noise(3, at).abs());
            assert_eq!(noise(3, at.floor()), 0.0);
        }
        assert!(largest < 1.0 && largest > 0.3, "{largest}");
    }

    #[test]
    fn the_form_never_changes() {
        // Recorded from the first build; scenes and pictures depend on it.
        let heights = [dvec2(0.0, 0.0), dvec2(1.25, -3.5), dvec2(-4.0, 4.75)];
        let bits = heights.map(|at| height(at).to_bits());
        let recorded = [
            0x3fb5_976f_e4b3_9003,
            0x3fd3_9576_9e7a_7f9b,
            0x3fe0_cd42_cd85_60ac,
        ];
        assert_eq!(bits, recorded, "{bits:#x?}");
    }
}
