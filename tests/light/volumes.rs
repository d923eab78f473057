//! Bounding volumes do not change what paths of light find.

use std::sync::Arc;

use glam::DVec3;
use rayproof::bounds::Bounds;
use rayproof::render::{Backend, Settings};
use rayproof::scene::mesh::{Builtin, build};
use rayproof::scene::{Geometry, Group, GroupBound, Scene};
use rayproof::{Accuracy, Frame, Unwatched};

use crate::common::{CHOICES, assert_same_bits, compare, gpu};
use crate::mirrors::mirror;
use crate::scenes::{room, shape};

/// The room with what is in it in groups, and a mesh with smooth normals, that mirrors.
pub fn grouped() -> Scene {
    let mut scene = room(32, 4, 2);
    scene.materials.push(mirror(0.5, 0.3, 0.4));
    let mirror = scene.materials.len() - 1;
    scene.shapes.truncate(4);
    let mut ball = shape(
        Geometry::Mesh(Arc::new(build(Builtin::Icosphere, 80))),
        mirror,
    );
    ball.transform.linear *= 0.4;
    ball.transform.translate = DVec3::new(-0.9, 1.2, -0.6);
    scene.shapes.push(ball);
    for step in 0..4 {
        let at = 0.4 * f64::from(step);
        scene.shapes.push(shape(
            Geometry::Disk {
                center: DVec3::new(1.0 - at, 0.1 + at, -1.0),
                normal: DVec3::new(0.3, 1.0, 0.2 * at),
                radius: 0.3,
            },
            mirror,
        ));
    }
    let group = |parent, shapes| Group {
        name: None,
        bound: GroupBound::Auto,
        parent,
        shapes,
    };
    scene.groups = vec![group(None, 3..5), group(None, 5..7), group(Some(1), 7..9)];
    scene
}

/// The picture of a scene, by a tier and volumes.
pub fn by(scene: &Scene, backend: &Backend, accuracy: Accuracy, bounds: Bounds) -> Frame {
    let settings = Settings {
        accuracy,
        bounds,
        forced: rayproof::effects::EffectSet::NONE,
    };
    let made = rayproof::render(scene, backend, settings, &Unwatched).unwrap();
    assert_eq!(made.stats.faults, 0);
    made.frame
}

#[test]
fn volumes_change_no_path() {
    let (cpu, gpu) = (Backend::Cpu(None), Backend::Gpu(Box::new(gpu())));
    let scene = grouped();
    scene.validate().unwrap();
    let reference = by(&scene, &cpu, Accuracy::Robust, Bounds::None);
    assert_same_bits(
        &reference,
        &by(&scene, &gpu, Accuracy::Robust, Bounds::None),
    );
    for bounds in CHOICES {
        for backend in [&cpu, &gpu] {
            let frame = by(&scene, backend, Accuracy::Robust, bounds);
            let comparison = compare(&reference, &frame);
            let name = backend.name();
            assert_eq!(comparison.different_pixels, 0, "{name} {bounds:?}");
        }
    }
    // The control: a volume that is too small cuts paths too.
    let mut cut = grouped();
    cut.groups[1].bound = GroupBound::Ball {
        center: DVec3::new(0.8, 0.3, -1.0),
        radius: 0.2,
    };
    let frame = by(&cut, &cpu, Accuracy::Robust, Bounds::Scene);
    assert!(compare(&reference, &frame).different_pixels > 0);
}
