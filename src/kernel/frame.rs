//! Axes about a direction, and directions told by them.

use super::circle::disk_point;
use super::divide::{divide, square_root};
use super::vector::{Vec3, dot_product, vec3};

/// Three unit vectors, each at right angles to the others; right-handed.
#[derive(Debug, Clone, Copy)]
pub struct Axes {
    /// The first axis.
    pub right: Vec3<f32>,
    /// The second.
    pub up: Vec3<f32>,
    /// The third: the direction about which they are.
    pub along: Vec3<f32>,
}

/// Axes about a unit normal, as near to unit length and to right angles as it is to unit
/// length, and 2^-21 besides.
///
/// Duff, Burgess, Christensen, Hery, Kensler, Liani, Villemin, "Building an Orthonormal
/// Basis, Revisited", JCGT 6(1), 2017.
pub fn axes_around(normal: Vec3<f32>) -> Axes {
    let sign = if normal.z >= 0.0 { 1.0 } else { -1.0 };
    let a = divide(-1.0, sign + normal.z);
    let b = (normal.x * normal.y) * a;
    Axes {
        right: vec3(
            1.0 + sign * ((normal.x * normal.x) * a),
            sign * b,
            -(sign * normal.x),
        ),
        up: vec3(b, sign + (normal.y * normal.y) * a, -normal.y),
        along: normal,
    }
}

/// The vector that goes so far along each of the axes.
pub fn from_axes(axes: Axes, x: f32, y: f32, z: f32) -> Vec3<f32> {
    (axes.right * x + axes.up * y) + axes.along * z
}

/// How far `v` goes along each of the axes.
pub fn to_axes(axes: Axes, v: Vec3<f32>) -> Vec3<f32> {
    vec3(
        dot_product(axes.right, v),
        dot_product(axes.up, v),
        dot_product(axes.along, v),
    )
}

/// The unit direction on the normal's side for a point of the unit square: as many near a
/// direction as its cosine to the normal says. At the square's edge the cosine is 0, give or
/// take a rounding.
///
/// Malley's method: a point of the disk, lifted to the half sphere above it.
pub fn cosine_direction(normal: Vec3<f32>, pair: [f32; 2]) -> Vec3<f32> {
    let point = disk_point(pair);
    let rest = 1.0 - (point[0] * point[0] + point[1] * point[1]);
    // By roundings a point may be outside the circle.
    let height = square_root(if rest > 0.0 { rest } else { 0.0 });
    from_axes(axes_around(normal), point[0], point[1], height)
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::kernel::vector::{unit_vector, vector_length};
    use crate::random::Numbers;

    /// A sum of some ten products, each rounded, of numbers up to 1; and of normals that are
    /// a rounding or two too long.
    const MOST: f32 = 4.0 * f32::EPSILON;

    /// Directions of all kinds, those next to the poles and to the equator among them.
    fn normals() -> Vec<Vec3<f32>> {
        let mut random = Numbers(11);
        let mut normals = Vec::new();
        for _ in 0..20_000 {
            let [x, y, z] = random.direction().to_array().map(|v| v as f32);
            for shrink in [1.0, 1e-3, 1e-7, 0.0] {
                normals.push(unit_vector(vec3(x * shrink, y * shrink, z)));
                normals.push(unit_vector(vec3(x, y, z * shrink)));
            }
        }
        normals.push(vec3(0.0, 0.0, -1.0));
        normals.push(vec3(1.0, 0.0, -0.0));
        normals
    }

    fn worst_of(axes: Axes) -> f32 {
        let Axes { right, up, along } = axes;
        let lengths = [right, up, along].map(|v| dot_product(v, v) - 1.0);
        let angles = [(right, up), (up, along), (along, right)].map(|(a, b)| dot_product(a, b));
        let each = lengths.into_iter().chain(angles);
        each.fold(0.0, |worst, off| worst.max(off.abs()))
    }

    #[test]
    fn axes_are_of_unit_length_and_at_right_angles() {
        let worst = |axes: fn(Vec3<f32>) -> Axes| {
            let each = normals().into_iter().map(axes).map(worst_of);
            each.fold(0.0, f32::max)
        };
        let found = worst(axes_around);
        println!("worst: {found:e}");
        assert!(found < MOST, "{found:e}");
        for normal in normals() {
            let Axes { right, up, along } = axes_around(normal);
            let cross = crate::kernel::vector::cross_product(right, up);
            assert!(
                vector_length(cross - along) < MOST,
                "left-handed at {normal:?}"
            );
        }
        // The control: Frisvad's, which the paper revises, near the lower pole.
        let frisvad = |n: Vec3<f32>| {
            let a = 1.0 / (1.0 + n.z);
            let b = -n.x * n.y * a;
            Axes {
                right: vec3(1.0 - n.x * n.x * a, b, -n.x),
                up: vec3(b, 1.0 - n.y * n.y * a, -n.y),
                along: n,
            }
        };
        let near_pole = unit_vector(vec3(1e-3, 2e-3, -1.0));
        assert!(worst_of(frisvad(near_pole)) > MOST);
    }

    #[test]
    fn to_the_axes_and_back() {
        let v = vec3(0.3, -0.5, 0.7);
        for normal in normals() {
            let axes = axes_around(normal);
            let told = to_axes(axes, v);
            let back = from_axes(axes, told.x, told.y, told.z);
            assert!(vector_length(back - v) < 2.0 * MOST, "{normal:?}: {back:?}");
        }
    }

    #[test]
    fn directions_have_unit_length_on_the_normals_side() {
        let mut random = Numbers(5);
        for normal in normals() {
            let pair = [0; 2].map(|_| (random.next() >> 40) as f32 / 16_777_216.0);
            for pair in [pair, [0.0, pair[1]], [0.5, 0.5]] {
                let direction = cosine_direction(normal, pair);
                assert!((vector_length(direction) - 1.0).abs() < MOST);
                assert!(
                    dot_product(direction, normal) > -MOST,
                    "{normal:?}, {pair:?}"
                );
            }
        }
    }

    /// By Lambert's law, the part of directions whose cosine's square is below t is t.
    #[test]
    fn directions_are_distributed_by_their_cosine() {
        let normal = unit_vector(vec3(0.2, -0.7, -0.4));
        let size = 256;
        let at = |i: i32| (i as f32 + 0.5) / size as f32;
        let cosines: Vec<f32> = (0..size * size)
            .map(|i| cosine_direction(normal, [at(i % size), at(i / size)]))
            .map(|direction| dot_product(direction, normal))
            .collect();
        let part = |power: i32, t: f32| {
            let below = cosines.iter().filter(|cosine| cosine.powi(power) < t);
            below.count() as f32 / cosines.len() as f32
        };
        for t in [0.1, 0.25, 0.5, 0.75, 0.9] {
            // The edge of a square in the square is met by so many of its cells.
            let most = 4.0 / size as f32;
            assert!((part(2, t) - t).abs() < most, "{t}: {}", part(2, t));
            // The control: evenly over the half sphere, it would be the cosine.
            assert!((part(1, t) - t).abs() > most, "{t}: {}", part(1, t));
        }
    }
}
