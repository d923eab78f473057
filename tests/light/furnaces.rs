//! White furnaces: in even light nothing white can be seen, and in a closed room light adds up.

use std::sync::Arc;

use glam::DVec3;
use rayproof::Scene;
use rayproof::scene::mesh::{Builtin, build};
use rayproof::scene::{Geometry, Material, Mesh, Strategy};

use crate::scenes::{matt, ramp};
use crate::seen::{FAR, ROUNDING, looking_at, mean_of};

const WAYS: [Strategy; 3] = [Strategy::Both, Strategy::Lights, Strategy::Surfaces];

fn ball(radius: f64) -> Geometry {
    Geometry::Sphere {
        center: DVec3::new(0.0, 0.0, -3.0),
        radius,
    }
}

/// A white ball in light of 1, as a background or as a sky.
fn white_ball(albedo: f64, is_sky: bool) -> Scene {
    let mut scene = looking_at(vec![ball(1.0)], matt([albedo; 3])).with_size(16, 16);
    scene.camera.fov_degrees = 36.0;
    scene.integrator.samples = 64;
    scene.integrator.bounces = 1;
    if is_sky {
        scene.environment = Some(ramp([1.0; 3], [1.0; 3]));
    }
    scene
}

/// Each path brings all of the light, or, from beyond the horizon by roundings, none.
#[test]
fn a_white_ball_vanishes() {
    let frame = mean_of(&white_ball(1.0, false)).frame;
    assert!(frame.color.iter().all(|color| *color == [1.0; 3]));
    let frame = mean_of(&white_ball(0.98, false)).frame;
    assert!(frame.color.iter().any(|color| *color != [1.0; 3]));
}

#[test]
fn a_white_ball_vanishes_under_a_sky() {
    for strategy in WAYS {
        let seen = |albedo| {
            let mut scene = white_ball(albedo, true);
            scene.integrator.samples = 256;
            scene.integrator.strategy = strategy;
            let mean = mean_of(&scene);
            let most = FAR * mean.error + 64.0 * ROUNDING;
            ((mean.color[0] - 1.0).abs(), most)
        };
        let (off, most) = seen(1.0);
        assert!(off <= most, "{strategy:?}: {off}, {most}");
        let (off, most) = seen(0.95);
        assert!(off > most, "the control: {strategy:?}: {off}, {most}");
    }
}

/// A triangle across the line of sight whose normals lean by an angle.
fn leaning(angle: f64) -> Geometry {
    let normal = DVec3::new(0.0, angle.sin(), angle.cos());
    let corner = |x, y| DVec3::new(x, y, -3.0);
    Geometry::Mesh(Arc::new(Mesh {
        positions: vec![corner(-9.0, -9.0), corner(9.0, -9.0), corner(0.0, 9.0)],
        normals: vec![normal; 3],
        triangles: vec![[0, 1, 2]],
        triangle_normals: vec![[0, 1, 2]],
        ..Mesh::default()
    }))
}

/// Of the directions around a normal that leans, those below the surface itself bring nothing:
/// of a disk, what is beyond an ellipse of its width times the cosine, (1 - cos) / 2 of it. That
/// is so for each way to find the light.
#[test]
fn a_leaning_normal_sees_less_by_its_angle() {
    for degrees in [0.0f64, 20.0, 50.0] {
        let angle = degrees.to_radians();
        let expected = 0.5 * (1.0 + angle.cos());
        for strategy in WAYS {
            let mut scene = looking_at(vec![leaning(angle)], matt([1.0; 3])).with_size(8, 8);
            scene.environment = Some(ramp([1.0; 3], [1.0; 3]));
            scene.integrator.samples = 1024;
            scene.integrator.bounces = 1;
            scene.integrator.strategy = strategy;
            let mean = mean_of(&scene);
            let off = (mean.color[0] - expected).abs();
            let most = FAR * mean.error + 64.0 * ROUNDING;
            assert!(off <= most, "{degrees} {strategy:?}: {}", mean.color[0]);
            let whole = (mean.color[0] - 1.0).abs();
            assert!(degrees < 20.0 || whole > most, "the control");
        }
    }
}

/// A ball of triangles with smooth normals loses as little as those lean.
#[test]
fn a_smooth_ball_of_triangles_all_but_vanishes() {
    let mesh = build(Builtin::Icosphere, 1280);
    let middle = |triangle: &[u32; 3]| {
        let [a, b, c] = triangle.map(|vertex| mesh.positions[vertex as usize]);
        let normal = (b - a).cross(c - a).normalize();
        [a, b, c].map(|vertex| normal.dot(vertex.normalize()))
    };
    // Between corners normals lean less.
    let least = mesh.triangles.iter().flat_map(middle).fold(1.0, f64::min);
    assert!(least > 0.98 && least < 1.0, "{least}");
    let ball = Geometry::Mesh(Arc::new(mesh.clone()));
    let mut scene = looking_at(vec![ball], matt([1.0; 3])).with_size(16, 16);
    scene.camera.eye = DVec3::Z * 3.0;
    scene.camera.target = DVec3::ZERO;
    scene.camera.fov_degrees = 36.0;
    scene.integrator.samples = 256;
    scene.integrator.bounces = 1;
    let mean = mean_of(&scene);
    let lost = 1.0 - mean.color[0];
    let most = 0.5 * (1.0 - least) + FAR * mean.error;
    assert!((0.0..most).contains(&lost), "{lost}, {most}");
    assert!(lost > 0.0, "the control: {lost}");
}

/// The camera in a body whose walls shine and scatter; through a hole red would come in.
fn rooms(emission: f64, albedo: f64) -> Vec<Scene> {
    let walls = Material {
        emission: [emission; 3],
        ..matt([albedo; 3])
    };
    let sphere = Geometry::Sphere {
        center: DVec3::new(0.2, 0.1, -0.3),
        radius: 1.0,
    };
    let cube = Geometry::Mesh(Arc::new(build(Builtin::Box, 12)));
    let rooms = [sphere, cube].map(|room| {
        let mut scene = looking_at(vec![room], walls.clone()).with_size(16, 12);
        scene.camera.fov_degrees = 100.0;
        scene.background = rayproof::scene::Background::plain([1000.0, 0.0, 0.0]);
        scene.integrator.samples = 64;
        scene
    });
    rooms.into()
}

/// Where all is white, each bounce adds as much, and nothing gets out.
#[test]
fn a_white_room_adds_up_exactly() {
    for mut scene in rooms(0.5, 1.0) {
        for bounces in [0, 1, 24] {
            scene.integrator.bounces = bounces;
            let frame = mean_of(&scene).frame;
            let expected = [0.5 * (1.0 + bounces as f32); 3];
            let others = frame.color.iter().filter(|color| **color != expected);
            // Directions along the wall may be below it by roundings: such a path ends.
            let most = 16 * 12 / 100;
            assert!(others.count() <= most, "{bounces}");
            assert!(frame.color.iter().all(|[red, green, _]| red == green));
        }
    }
}

/// E + a E + a^2 E and so on, as often as paths may bounce, though those that are long end by
/// lot.
#[test]
fn a_grey_room_adds_up_a_series() {
    for mut scene in rooms(0.5, 0.6) {
        for bounces in [3, 12] {
            scene.integrator.bounces = bounces;
            let mean = mean_of(&scene);
            let series = |bounces: u32| 0.5 * (1.0 - 0.6f64.powi(bounces as i32 + 1)) / 0.4;
            let off = |expected: f64| (mean.color[1] - expected).abs();
            let most = FAR * mean.error + 64.0 * ROUNDING;
            assert!(off(series(bounces)) <= most, "{bounces}: {:?}", mean.color);
            // The controls: another bounce, and another albedo.
            assert!(bounces > 3 || off(series(4)) > most);
            assert!(off(series(bounces) * 1.05) > most);
        }
    }
}
