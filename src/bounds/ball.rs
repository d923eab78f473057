//! Tight bounding spheres of points and of spheres.
//!
//! Bădoiu, Clarkson, "Smaller Core-Sets for Balls", SODA 2003: the ball around a few
//! of the items, to which the farthest one outside is added again and again. The
//! few are found along the axes and diagonals first, as in Larsson, "Fast and Tight
//! Fitting Bounding Spheres", SIGRAD 2008.

use glam::DVec3;

/// A sphere, or a point where the radius is 0.
pub type Ball = (DVec3, f64);

/// Directions along which the outermost items are looked for: axes, and diagonals of
/// faces and of the cube.
const DIRECTIONS: [DVec3; 13] = [
    DVec3::X,
    DVec3::Y,
    DVec3::Z,
    DVec3::new(1.0, 1.0, 0.0),
    DVec3::new(1.0, -1.0, 0.0),
    DVec3::new(1.0, 0.0, 1.0),
    DVec3::new(1.0, 0.0, -1.0),
    DVec3::new(0.0, 1.0, 1.0),
    DVec3::new(0.0, 1.0, -1.0),
    DVec3::new(1.0, 1.0, 1.0),
    DVec3::new(1.0, 1.0, -1.0),
    DVec3::new(1.0, -1.0, 1.0),
    DVec3::new(1.0, -1.0, -1.0),
];

/// Steps towards the farthest item: the radius is then within 1/1000 of the least.
const STEPS: u32 = 1000;

/// Items added to the first few at most; each is a pass over all.
const ROUNDS: u32 = 8;

/// A ball that holds all of `items`, hardly larger than the smallest one; none where
/// there are no items.
pub fn bounding_ball(items: &[Ball]) -> Option<Ball> {
    let mut few = Vec::new();
    for direction in DIRECTIONS {
        let unit = direction.normalize();
        for sign in [1.0, -1.0] {
            few.push(farthest(items, |(center, radius)| {
                sign * center.dot(unit) + radius
            })?);
        }
    }
    let mut center = center_of(&few);
    for _ in 0..ROUNDS {
        let outer = farthest(items, reach_from(center))?;
        let reach = reach_from(center)(&outer);
        if few.iter().any(|item| reach_from(center)(item) >= reach) {
            break;
        }
        few.push(outer);
        center = center_of(&few);
    }
    let outer = farthest(items, reach_from(center))?;
    Some((center, reach_from(center)(&outer)))
}

/// How far an item reaches, seen from a point.
fn reach_from(point: DVec3) -> impl Fn(&Ball) -> f64 {
    move |(center, radius)| point.distance(*center) + radius
}

fn farthest(items: &[Ball], measure: impl Fn(&Ball) -> f64) -> Option<Ball> {
    let first = items.first()?;
    let mut best = (*first, measure(first));
    for item in &items[1..] {
        let measured = measure(item);
        if measured > best.1 {
            best = (*item, measured);
        }
    }
    Some(best.0)
}

/// The middle of the smallest ball around a few items, nearly.
fn center_of(items: &[Ball]) -> DVec3 {
    let sum: DVec3 = items.iter().map(|(center, _)| *center).sum();
    let mut center = sum / items.len() as f64;
    for step in 1..=STEPS {
        let Some((to, radius)) = farthest(items, reach_from(center)) else {
            break;
        };
        let offset = to - center;
        let distance = offset.length();
        if distance == 0.0 {
            break;
        }
        // Towards the far side of the item, a part of the way that shrinks.
        let way = (distance + radius) / f64::from(step + 1);
        center += offset / distance * way.min(distance);
    }
    center
}

#[cfg(test)]
mod tests {
    use super::*;

    fn points(coordinates: &[[f64; 3]]) -> Vec<Ball> {
        let point = |c: &[f64; 3]| (DVec3::from(*c), 0.0);
        coordinates.iter().map(point).collect()
    }

    #[test]
    fn known_balls() {
        for (items, radius) in [
            (points(&[[3.0, 4.0, 5.0]]), 0.0),
            (points(&[[1.0, 0.0, 0.0], [1.0, 0.0, 0.0]]), 0.0),
            (
                points(&[[-1.0, 0.0, 0.0], [0.3, 0.0, 0.0], [1.0, 0.0, 0.0]]),
                1.0,
            ),
            // An equilateral triangle, whose ball is larger than its longest side's.
            (
                points(&[
                    [1.0, 0.0, 0.0],
                    [-0.5, 0.75_f64.sqrt(), 0.0],
                    [-0.5, -0.75_f64.sqrt(), 0.0],
                ]),
                1.0,
            ),
            (vec![(DVec3::ZERO, 1.0), (DVec3::X * 4.0, 2.0)], 3.5),
            (vec![(DVec3::ZERO, 5.0), (DVec3::X, 1.0)], 5.0),
        ] {
            let (_, found) = bounding_ball(&items).unwrap();
            assert!(found >= radius * (1.0 - 1e-12), "{found} of {radius}");
            assert!(found <= radius * 1.005 + 1e-12, "{found} of {radius}");
        }
        assert!(bounding_ball(&[]).is_none());
    }

    /// Points on and in a sphere: all are held, and the ball is as large as the sphere.
    #[test]
    fn a_crowd_is_held() {
        let mut state = 1_u64;
        let mut random = || {
            state = state
                .wrapping_mul(6_364_136_223_846_793_005)
                .wrapping_add(1);
            (state >> 33) as f64 / f64::from(1_u32 << 30) - 1.0
        };
        let middle = DVec3::new(7.0, -3.0, 2.0);
        let items: Vec<Ball> = (0..5000)
            .map(|i| {
                let direction = DVec3::new(random(), random(), random()).normalize_or_zero();
                let distance = if i % 2 == 0 { 1.0 } else { random() };
                (middle + direction * distance, 0.0)
            })
            .collect();
        let (center, radius) = bounding_ball(&items).unwrap();
        assert!(items.iter().all(|(p, _)| p.distance(center) <= radius));
        assert!(radius < 1.01, "{radius}");
        // The control: a ball a little smaller does not hold them.
        assert!(
            items
                .iter()
                .any(|(p, _)| p.distance(center) > radius * 0.999)
        );
    }
}
