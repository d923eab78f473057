//! Environments that shine, against closed forms.

use std::f64::consts::{PI, TAU};

use glam::DVec3;
use rayproof::flat::Flat;
use rayproof::flatten::flatten;
use rayproof::kernel::camera::Ray;
use rayproof::kernel::sky::{COLUMNS, ROWS, seen_sky};
use rayproof::kernel::vector::Vec3;
use rayproof::layout::ONLY_SURFACES;
use rayproof::random::Numbers;
use rayproof::scene::{Environment, Scene};

use crate::sampled::{Mean, arriving, path, seen, single, surface};
use crate::scenes::{image, ramp};

const SAMPLES: u32 = 1 << 14;

/// Roundings of a sample's light.
const ROUNDINGS: f64 = 64.0;

fn under(environment: Environment) -> Flat<f32> {
    flatten(&Scene {
        environment: Some(environment),
        ..Scene::default()
    })
}

/// What a path sees in a direction that was drawn with this density.
fn sky(flat: &Flat<f32>, direction: DVec3, density: f32) -> [f64; 3] {
    let mut path = path(flat, 0);
    path.ray = Ray {
        origin: Vec3::default(),
        direction: single(direction),
    };
    path.density = density;
    <[f32; 3]>::from(seen_sky(flat, &path)).map(f64::from)
}

/// The density with which a direction is drawn, by how a path weighs what it finds there.
fn density(flat: &Flat<f32>, direction: DVec3) -> f64 {
    let whole = sky(flat, direction, 0.0)[0];
    let weighed = sky(flat, direction, 1.0)[0];
    whole / weighed - 1.0
}

/// A dim sky with a sun in it.
fn sunny() -> Environment {
    image(32, 16, |x, y| match (x, y) {
        (20, 5) => [100.0, 80.0, 60.0],
        (x, y) => [0.1 + 0.02 * f64::from((x * 7 + y * 3) % 11); 3],
    })
}

/// Light from everywhere makes a white surface white.
#[test]
fn a_furnace_is_as_bright_everywhere() {
    let flat = under(ramp([0.7; 3], [0.7; 3]));
    let mut random = Numbers(3);
    for _ in 0..8 {
        let found = seen(&flat, &surface(DVec3::ZERO, random.direction()), SAMPLES);
        assert!(found.fits(0.7, ROUNDINGS), "{found:?}");
        assert!(!found.fits(0.75, ROUNDINGS), "the control: {found:?}");
    }
}

/// The mean height of directions above a surface, by their cosine, is 2/3 of its own.
#[test]
fn a_ramp_lights_by_its_mean() {
    let flat = under(Environment {
        intensity: 2.0,
        ..ramp([0.2; 3], [1.0; 3])
    });
    for normal in [DVec3::Y, DVec3::X, DVec3::new(1.0, -2.0, 0.5).normalize()] {
        let found = seen(&flat, &surface(DVec3::ZERO, normal), SAMPLES);
        let exact = 2.0 * (0.2 + 0.8 * (0.5 + 0.5 * 2.0 / 3.0 * normal.y));
        assert!(found.fits(exact, ROUNDINGS), "{found:?}, {exact}");
        assert!(!found.fits(exact * 1.1, ROUNDINGS));
    }
}

/// The irradiance over pi under one bright texel of 32 x 16, in steps of f64: a tent over
/// azimuth and polar angle. `turn` is how far the texel is from x towards z, in radians.
fn under_texel(turn: f64, polar: f64, normal: DVec3) -> f64 {
    let (steps, reach) = (400, TAU / 32.0);
    let at = |step: i32| (f64::from(step) + 0.5) / f64::from(steps) * 2.0 - 1.0;
    let mut sum = 0.0;
    for i in 0..steps {
        for j in 0..steps {
            let (x, y) = (at(i), at(j));
            let (azimuth, angle) = (turn + x * reach, polar + y * reach);
            let (sine, cosine) = angle.sin_cos();
            let direction = DVec3::new(sine * azimuth.cos(), cosine, sine * azimuth.sin());
            let light = (1.0 - x.abs()) * (1.0 - y.abs());
            sum += light * direction.dot(normal).max(0.0) * sine;
        }
    }
    let step = 2.0 * reach / f64::from(steps);
    sum * step * step / PI
}

#[test]
fn a_bright_texel_lights_by_its_angle() {
    for turned in [0.0, 90.0, -200.0] {
        let flat = under(Environment {
            turn_degrees: turned,
            ..image(32, 16, |x, y| [f64::from(u8::from((x, y) == (20, 5))); 3])
        });
        // The middle of the image is x, its right half goes on towards z; turned, from x
        // towards -z.
        let turn = (20.5 / 32.0 - 0.5 - turned / 360.0) * TAU;
        let polar = 5.5 / 16.0 * PI;
        let towards = DVec3::new(
            polar.sin() * turn.cos(),
            polar.cos(),
            polar.sin() * turn.sin(),
        );
        for normal in [towards, DVec3::Y] {
            let found = seen(&flat, &surface(DVec3::ZERO, normal), SAMPLES);
            let exact = under_texel(turn, polar, normal);
            // The steps are 400, the tent's edges fall on them.
            assert!(found.fits(exact, ROUNDINGS + 16.0), "{found:?}, {exact}");
            assert!(!found.fits(exact * 1.05, ROUNDINGS), "{found:?}, {exact}");
        }
        // Seen in the middle it is whole, at half the way to the next one half.
        let [whole, half] = [0.0, 0.5].map(|texels: f64| {
            let turn = turn + texels / 32.0 * TAU;
            let side = DVec3::new(
                polar.sin() * turn.cos(),
                polar.cos(),
                polar.sin() * turn.sin(),
            );
            sky(&flat, side, 0.0)[0]
        });
        // Angles are off by 2^-22 of a turn, of which a texel is a part in 32.
        let most = 64.0 / f64::from(1 << 22);
        assert!((whole - 1.0).abs() < most, "{whole}");
        assert!((half - 0.5).abs() < most, "{half}");
    }
}

/// Interpolated across the edge where the image meets itself, and not across the poles.
#[test]
fn an_image_goes_around() {
    let flat = under(image(4, 2, |x, y| [f64::from(x + 10 * y), 1.0, 1.0]));
    let close = |direction: DVec3, expected: f64| {
        let [red, ..] = sky(&flat, direction, 0.0);
        assert!((red - expected).abs() < 1e-5, "{direction}: {red}");
    };
    // -x is between the last column and the first, the horizon between the two rows.
    close(DVec3::NEG_X, 0.5 * (3.0 + 0.0) + 5.0);
    close(DVec3::X, 0.5 * (1.0 + 2.0) + 5.0);
    close(DVec3::Z, 0.5 * (2.0 + 3.0) + 5.0);
    close(DVec3::NEG_Z, 0.5 * (0.0 + 1.0) + 5.0);
    // Towards the zenith the upper row alone.
    close(DVec3::new(1e-3, 1.0, 0.0), 1.5);
}

#[test]
fn densities_of_all_directions_make_a_whole() {
    for environment in [sunny(), ramp([0.1; 3], [1.0; 3])] {
        let flat = under(environment);
        let cells = f64::from(COLUMNS * ROWS);
        let mut sum = 0.0;
        for row in 0..ROWS {
            let height = 1.0 - (f64::from(row) + 0.5) * 2.0 / f64::from(ROWS);
            for column in 0..COLUMNS {
                let turn = (f64::from(column) + 0.5) / f64::from(COLUMNS) * TAU;
                let radius = (1.0 - height * height).sqrt();
                let direction = DVec3::new(radius * turn.cos(), height, radius * turn.sin());
                sum += density(&flat, direction) * 4.0 * PI / cells;
            }
        }
        // The weight of each takes some roundings; where it is small, more of the density.
        assert!((sum - 1.0).abs() < 1e-4, "{sum}");
    }
}

#[test]
fn what_is_drawn_is_found_with_the_same_density() {
    let flat = under(sunny());
    let at = surface(DVec3::ZERO, DVec3::Y);
    let mut others = 0;
    for number in 0..4000 {
        let (arriving, _) = arriving(&flat, &at, number);
        let direction = <[f32; 3]>::from(arriving.towards).map(f64::from);
        let direction = DVec3::from_array(direction);
        assert!((direction.length() - 1.0).abs() < 4.0 * f64::from(f32::EPSILON));
        let found = sky(&flat, direction, arriving.density)[0] / sky(&flat, direction, 0.0)[0];
        // At the edge of a cell roundings decide.
        others += u32::from((found - 0.5).abs() > 4.0 * f64::from(f32::EPSILON));
    }
    // Numbers are off by 2^-14 of a cell at most, on four sides.
    assert!(others <= 4, "{others}");
}

/// Directions that are bright are drawn more often: without that, a sun is noise.
#[test]
fn a_sun_is_looked_for() {
    let flat = under(sunny());
    let at = surface(DVec3::ZERO, DVec3::Y);
    let drawn = seen(&flat, &at, SAMPLES);
    let mut random = Numbers(8);
    let evenly = Mean::of((0..SAMPLES).map(|_| {
        let direction = random.direction();
        4.0 * sky(&flat, direction, 0.0)[0] * direction.y.max(0.0)
    }));
    println!("{drawn:?} {evenly:?}");
    let both = drawn.error.hypot(evenly.error);
    assert!((drawn.value - evenly.value).abs() < 5.0 * both);
    assert!(drawn.error < evenly.error / 3.0, "{drawn:?} {evenly:?}");
}

/// Where nothing is in the image, and where everything is dark, no direction is lost.
#[test]
fn dark_skies_are_no_faults() {
    for environment in [image(3, 2, |_, _| [0.0; 3]), ramp([0.0; 3], [0.0; 3])] {
        let flat = under(environment);
        let found = seen(&flat, &surface(DVec3::ZERO, DVec3::Y), 256);
        assert_eq!((found.value, found.error), (0.0, 0.0));
    }
}

/// A path alone finds all of it where surfaces are to.
#[test]
fn only_surfaces_find_all_of_it() {
    let mut flat = under(sunny());
    let direction = DVec3::new(0.3, 0.5, 0.4);
    let whole = sky(&flat, direction, 0.0);
    assert!(sky(&flat, direction, 0.5)[0] < whole[0]);
    flat.sampling.strategy = ONLY_SURFACES;
    assert_eq!(sky(&flat, direction, 0.5), whole);
}
