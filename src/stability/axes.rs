//! Axes at right angles whose numbers are small integers, so that what is built on them needs
//! no rounding.

use glam::DVec3;

use crate::random::Numbers;

/// Three such axes and the length of each, 1 or 3.
pub fn frame(n: &mut Numbers) -> ([DVec3; 3], f64) {
    let oblique = [[1.0, 2.0, 2.0], [2.0, 1.0, -2.0], [2.0, -2.0, 1.0]];
    let straight = [[1.0, 0.0, 0.0], [0.0, 1.0, 0.0], [0.0, 0.0, 1.0]];
    let (axes, length) = if n.pick(4) == 0 {
        (straight, 1.0)
    } else {
        (oblique, 3.0)
    };
    let (turn, signs) = (
        n.pick(3),
        [(); 3].map(|()| if n.flip() { 1.0 } else { -1.0 }),
    );
    let turned = |axis: [f64; 3]| {
        DVec3::from_array([0, 1, 2].map(|place| signs[place] * axis[(place + turn) % 3]))
    };
    let mut axes = axes.map(turned);
    axes.rotate_left(n.pick(3));
    (axes, length)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_axes_are_at_right_angles() {
        let mut n = Numbers(1);
        for _ in 0..100 {
            let ([a, b, c], length) = frame(&mut n);
            assert_eq!([a.dot(b), b.dot(c), c.dot(a)], [0.0; 3]);
            assert_eq!([a, b, c].map(DVec3::length_squared), [length * length; 3]);
        }
    }
}
