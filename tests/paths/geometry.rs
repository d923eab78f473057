//! Paths whose end is known.

use glam::DVec3;
use rayproof::accuracy::Widths;
use rayproof::bounds::Bounds;
use rayproof::flatten::flatten;
use rayproof::kernel::camera::Ray;
use rayproof::kernel::vector::{Vec3, vec3, vector_length};
use rayproof::layout::NO_HIT;
use rayproof::paths::{Aim, Paths};
use rayproof::scene::Geometry;
use rayproof::stability::shapes::{disk, scene_of};
use rayproof::{Accuracy, Backend};

use super::backends;
use super::common::random::Numbers;

fn widths_of(shapes: &[Geometry], bounds: Bounds) -> Widths {
    Widths::of(flatten(&scene_of(shapes.iter().cloned())), bounds)
}

fn follow(
    widths: &Widths,
    backend: &Backend,
    accuracy: Accuracy,
    rays: &[Ray<f32>],
    aim: Aim,
    legs: u32,
) -> Paths {
    let aims = vec![aim; rays.len()];
    widths
        .follow_paths(backend, accuracy, rays, &aims, legs)
        .unwrap()
}

const STABLE: [Accuracy; 4] = [
    Accuracy::Robust,
    Accuracy::Extended,
    Accuracy::Double,
    Accuracy::Adaptive,
];

/// Two mirrors 1e-3 apart, and rays that run to and fro between them. A leg goes along by less
/// than 0.43 of the gap, so that 1000 legs end within the disks.
#[test]
fn nothing_escapes_between_two_mirrors() {
    let center = DVec3::new(0.0, 0.0, -1.0);
    let mirrors = [0.0, 1e-3].map(|gap| disk(center - DVec3::Z * gap, DVec3::Z, 0.5));
    let widths = widths_of(&mirrors, Bounds::None);
    let mut n = Numbers(5);
    let rays: Vec<Ray<f32>> = (0..64)
        .map(|_| Ray {
            origin: vec3(0.0, 0.0, -1.0005),
            direction: vec3(
                n.between(-0.3, 0.3) as f32,
                n.between(-0.3, 0.3) as f32,
                1.0,
            ),
        })
        .collect();
    let legs = 1000;
    for backend in backends() {
        let escaped = |accuracy| {
            let paths = follow(&widths, &backend, accuracy, &rays, Aim::Mirrored, legs);
            let mut escaped = 0;
            for found in paths.found.chunks(legs as usize) {
                let to_and_fro = found.windows(2).all(|pair| pair[0].id != pair[1].id);
                escaped += usize::from(!to_and_fro || found.iter().any(|f| f.id == NO_HIT));
            }
            escaped
        };
        for accuracy in STABLE {
            assert_eq!(escaped(accuracy), 0, "{accuracy:?}");
        }
        assert_eq!(escaped(Accuracy::Textbook), rays.len(), "the control");
    }
}

/// Two mirrors at a right angle throw a ray back where it came from, three in a corner any.
#[test]
fn a_corner_of_mirrors_returns_what_comes_in() {
    let corner = DVec3::new(-1.0, -1.0, -5.0);
    let mirrors = [DVec3::X, DVec3::Y, DVec3::Z].map(|normal| disk(corner, normal, 4.0));
    let widths = widths_of(&mirrors, Bounds::None);
    let mut n = Numbers(9);
    let rays: Vec<Ray<f32>> = (0..500)
        .map(|_| {
            let mut inside = || n.between(0.1, 1.0) as f32;
            Ray {
                origin: vec3(inside(), inside(), inside() - 5.0),
                direction: vec3(-inside(), -inside(), -inside()),
            }
        })
        .collect();
    for backend in backends() {
        for accuracy in STABLE {
            let paths = follow(&widths, &backend, accuracy, &rays, Aim::Mirrored, 3);
            let found = paths.found.chunks(3);
            let mut returned = 0;
            for ((ray, end), found) in rays.iter().zip(&paths.ends).zip(found) {
                if found.iter().any(|found| found.id == NO_HIT) {
                    continue;
                }
                returned += 1;
                // Normals along axes are exact, and so is 2 d.n: d comes back as it was.
                assert_eq!(end.direction, -ray.direction, "{accuracy:?}");
            }
            assert!(returned > 300, "{returned}");
        }
    }
}

/// The same with mirrors that stand anywhere: off by 4 ulp a bounce at most.
#[test]
fn a_turned_corner_returns_nearly_what_comes_in() {
    let corner = DVec3::new(0.1, 0.2, -5.0);
    let x = DVec3::new(1.0, 0.7, 0.9).normalize();
    let y = x.cross(DVec3::new(-0.3, 1.0, 0.2)).normalize();
    let mirrors = [x, y].map(|normal| disk(corner, normal, 4.0));
    let widths = widths_of(&mirrors, Bounds::None);
    let mut n = Numbers(9);
    let rays: Vec<Ray<f32>> = (0..500)
        .map(|_| {
            let from = corner + x * n.between(0.5, 2.0) + y * n.between(0.5, 2.0);
            let to = corner + x * n.between(0.0, 0.5) + y * n.between(-0.5, 0.5);
            let [from, to] = [from, to].map(|v| {
                let [x, y, z] = v.as_vec3().to_array();
                vec3(x, y, z)
            });
            Ray {
                origin: from,
                direction: to - from,
            }
        })
        .collect();
    let along = {
        let [x, y, z] = x.cross(y).as_vec3().to_array();
        vec3(x, y, z)
    };
    for backend in backends() {
        for accuracy in STABLE {
            let paths = follow(&widths, &backend, accuracy, &rays, Aim::Mirrored, 2);
            let mut returned = 0;
            for ((ray, end), found) in rays.iter().zip(&paths.ends).zip(paths.found.chunks(2)) {
                if found[0].id == found[1].id || found.iter().any(|found| found.id == NO_HIT) {
                    continue;
                }
                returned += 1;
                // What lies along the edge of the corner stays.
                let stays = along
                    * (along.x * ray.direction.x
                        + along.y * ray.direction.y
                        + along.z * ray.direction.z);
                let off = (end.direction + ray.direction) - stays * 2.0;
                let allowed = 2.0 * 4.0 * f32::EPSILON * vector_length(ray.direction);
                assert!(vector_length(off) <= allowed, "{accuracy:?}: {off:?}");
            }
            assert!(returned > 200, "{returned}");
        }
    }
}

/// Light upon glass from within at the critical angle, up to 20 ulp to either side: it goes
/// through or is thrown back, and its direction is a unit vector.
#[test]
fn light_at_the_critical_angle_goes_somewhere() {
    let slab = disk(DVec3::new(0.0, -1.0, 0.0), DVec3::Y, 1e3);
    let widths = widths_of(&[slab], Bounds::None);
    let ratio = 1.5f32;
    let sine = 1.0 / ratio;
    let cosine = (1.0 - sine * sine).sqrt();
    let rays: Vec<Ray<f32>> = (-20..=20)
        .map(|ulps| Ray {
            origin: Vec3::default(),
            direction: vec3(
                sine,
                -f32::from_bits(cosine.to_bits().wrapping_add_signed(ulps)),
                0.0,
            ),
        })
        .collect();
    for backend in backends() {
        for accuracy in Accuracy::ALL {
            let paths = follow(
                &widths,
                &backend,
                accuracy,
                &rays,
                Aim::Refracted { ratio },
                1,
            );
            let (mut through, mut back) = (0, 0);
            for end in &paths.ends {
                let length = vector_length(end.direction);
                assert!((length - 1.0).abs() < 4.0 * f32::EPSILON, "{end:?}");
                assert!(vector_length(end.origin).is_finite());
                through += usize::from(end.direction.y <= 0.0);
                back += usize::from(end.direction.y > 0.0);
            }
            assert!(through > 0 && back > 0, "the control: {through} {back}");
        }
    }
}

/// A ray to a point is at it at t = 1, and one that is stopped before, before.
#[test]
fn a_ray_to_a_light_ends_at_the_light() {
    let floor = Geometry::Plane {
        point: DVec3::new(0.0, -1.0, 0.0),
        normal: DVec3::Y,
    };
    let ball = Geometry::Sphere {
        center: DVec3::new(0.0, 1.0, -4.0),
        radius: 0.5,
    };
    let widths = widths_of(&[ball, floor], Bounds::None);
    let rays: Vec<Ray<f32>> = (-20..=20)
        .map(|x| Ray {
            origin: Vec3::default(),
            direction: vec3(x as f32 / 10.0, -1.0, -4.0),
        })
        .collect();
    let light = vec3(0.0, 3.0, -4.0);
    for backend in backends() {
        for accuracy in Accuracy::ALL {
            let paths = follow(&widths, &backend, accuracy, &rays, Aim::To(light), 2);
            let first = follow(&widths, &backend, accuracy, &rays, Aim::To(light), 1);
            let mut shadowed = 0;
            for (index, found) in paths.found.chunks(2).enumerate() {
                assert_eq!(found[0].id, 1);
                let to = first.ends[index];
                let missed = vector_length((to.origin + to.direction) - light);
                assert!(missed <= 4.0 * f32::EPSILON * 4.0, "{missed}");
                // The floor's point x is in the ball's shadow from -1.03 to 1.03: the line
                // from the light, 2 above the ball's centre, is 14.5 degrees wide.
                shadowed += usize::from(found[1].t < 1.0);
            }
            assert_eq!(shadowed, 21, "{accuracy:?}");
        }
    }
}
