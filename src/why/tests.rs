use glam::DVec3;

use super::*;
use crate::oracle::ShapeKind;
use crate::scene::{Camera, Geometry, Material, Shape, Transform};
use crate::watch::Unwatched;

const CHOICES: [Bounds; 6] = [
    Bounds::None,
    Bounds::Scene,
    Bounds::Spheres { levels: 2 },
    Bounds::Boxes { levels: 2 },
    Bounds::Screen { levels: 1 },
    Bounds::Tree,
];

/// Shapes before a camera that looks along -z; the middle pixel's ray is the axis.
fn scene(shapes: Vec<Geometry>) -> Scene {
    let shape = |geometry| Shape {
        geometry,
        transform: Transform::default(),
        material: 0,
        velocity: DVec3::ZERO,
    };
    Scene {
        ambient: [1.0; 3],
        materials: vec![Material {
            name: "clay".into(),
            albedo: [0.5; 3],
            ..Material::default()
        }],
        shapes: shapes.into_iter().map(shape).collect(),
        ..Scene::default()
    }
    .with_size(9, 9)
}

fn sphere(x: f64, z: f64, radius: f64) -> Geometry {
    Geometry::Sphere {
        center: DVec3::new(x, 0.0, z),
        radius,
    }
}

fn wall(z: f64) -> Geometry {
    Geometry::Plane {
        point: DVec3::new(0.0, 0.0, z),
        normal: DVec3::Z,
    }
}

fn middle(scene: &Scene, bounds: Bounds) -> Why {
    explain(scene, bounds, 4, 4, &Unwatched).unwrap()
}

fn tier(why: &Why, accuracy: Accuracy) -> &TierFacts {
    why.tiers.iter().find(|t| t.accuracy == accuracy).unwrap()
}

#[test]
fn all_that_is_met_stands_in_its_order() {
    let corner = |x: f64, y: f64| DVec3::new(x, y, -6.0);
    let scene = scene(vec![
        wall(-8.0),
        Geometry::Disk {
            center: DVec3::new(0.0, 0.0, -7.0),
            normal: DVec3::Z,
            radius: 1.0,
        },
        Geometry::Triangle {
            vertices: [corner(-1.0, -1.0), corner(1.0, -1.0), corner(0.0, 1.0)],
        },
        sphere(0.0, -4.0, 1.0),
        // The control: beside the ray.
        sphere(5.0, -4.0, 1.0),
    ]);
    for bounds in CHOICES {
        let why = middle(&scene, bounds);
        let met: Vec<_> = why
            .candidates
            .iter()
            .map(|c| (c.id, c.kind, c.shape.unwrap(), c.t))
            .collect();
        let expected = [
            (0, ShapeKind::Sphere, 3, Some(3.0)),
            (4, ShapeKind::Triangle, 2, Some(6.0)),
            (3, ShapeKind::Disk, 1, Some(7.0)),
            (2, ShapeKind::Plane, 0, Some(8.0)),
        ];
        assert_eq!(met, expected, "{bounds:?}");
        assert_eq!((why.exact.id, why.exact.t), (Some(0), Some(3.0)));
        assert!(why.exact.why.contains("triangle 4 comes next"));
        for tier in &why.tiers {
            assert_eq!((tier.id, tier.verdict), (Some(0), Verdict::Right));
        }
        for candidate in &why.candidates {
            assert_eq!(candidate.material.as_deref(), Some("clay"));
            for meeting in &candidate.meetings {
                assert_eq!(meeting.t, candidate.t);
                assert_eq!(meeting.error, Some(0.0));
                assert_eq!(meeting.intersection_error, Some(0.0));
            }
            let Interval { low, high } = candidate.interval.unwrap();
            let t = candidate.t.unwrap();
            assert!(low < t && t < high.unwrap(), "{candidate:?}");
        }
    }
}

#[test]
fn the_path_leads_to_the_winner() {
    let crowd = (0..40).map(|n| sphere(f64::from(n) * 3.0, -8.0, 1.0));
    let scene = scene(crowd.chain([wall(-20.0)]).collect());
    let path = |bounds, x| {
        let why = explain(&scene, bounds, x, 4, &Unwatched).unwrap();
        why.path.expect("a winner")
    };
    let to_sphere = path(Bounds::Tree, 4);
    assert_eq!(to_sphere.id, 0);
    assert!(to_sphere.steps.len() > 2);
    for pair in to_sphere.steps.windows(2) {
        assert!(pair[0].enter <= pair[1].enter && pair[1].exit <= pair[0].exit);
    }
    assert!(to_sphere.steps.iter().all(|step| step.met));
    // The controls: nothing holds a plane, nor anything where there are no volumes.
    assert_eq!(path(Bounds::Tree, 0).id, 40);
    assert!(path(Bounds::Tree, 0).steps.is_empty());
    assert!(path(Bounds::None, 4).steps.is_empty());
}

#[test]
fn of_two_equal_spheres_the_lower_id_wins() {
    let same = scene(vec![sphere(0.0, -4.0, 1.0), sphere(0.0, -4.0, 1.0)]);
    let why = middle(&same, Bounds::Tree);
    assert_eq!((why.exact.id, why.exact.margin), (Some(0), Some(0.0)));
    assert!(why.exact.why.contains("the lower id counts"));
    assert!(why.tiers.iter().all(|tier| tier.id == Some(0)));
    let adaptive = tier(&why, Accuracy::Adaptive);
    assert_eq!(adaptive.in_doubt, Some(true));
    assert!(adaptive.why.contains("before the interval"), "{adaptive:?}");
    // The control: one of them apart.
    let apart = scene(vec![sphere(0.0, -4.0, 1.0), sphere(0.0, -3.0, 1.0)]);
    let why = middle(&apart, Bounds::Tree);
    assert_eq!(why.exact.id, Some(1));
    assert_eq!(tier(&why, Accuracy::Adaptive).in_doubt, Some(false));
}

#[test]
fn nothing_is_met_and_nothing_is_in_doubt() {
    let why = middle(&scene(vec![sphere(9.0, -4.0, 1.0)]), Bounds::Tree);
    assert_eq!((why.exact.id, why.exact.t, why.path), (None, None, None));
    assert!(why.candidates.is_empty());
    for tier in &why.tiers {
        assert_eq!(
            (tier.id, tier.t, tier.verdict),
            (None, None, Verdict::Right)
        );
    }
    let empty = middle(&scene(Vec::new()), Bounds::Tree);
    assert_eq!(empty.exact.margin, None);
}

/// A sphere of radius 1, 10,000 away, whose rim is so far from the middle of the view.
fn far_sphere(rim: f64) -> Scene {
    let mut scene = scene(vec![sphere(1.0 - rim, -10_000.0, 1.0)]);
    scene.camera = Camera {
        fov_degrees: 0.1,
        ..scene.camera
    };
    scene
}

#[test]
fn a_textbook_loses_a_far_sphere_and_the_sentence_says_how() {
    // Steps of 32 and a discriminant of at most 4: some of these go wrong.
    let wrong = (1..60)
        .flat_map(|n| [f64::from(n) * 0.03, f64::from(n) * -0.03])
        .map(|rim| middle(&far_sphere(rim), Bounds::Tree))
        .filter(|why| tier(why, Accuracy::Textbook).verdict != Verdict::Right);
    let wrong: Vec<_> = wrong.collect();
    let with = |verdict| {
        let mut all = wrong.iter();
        all.find(|why| tier(why, Accuracy::Textbook).verdict == verdict)
    };
    let lost = with(Verdict::FalseMiss)
        .or(with(Verdict::FalseHit))
        .expect("one");
    let textbook = tier(lost, Accuracy::Textbook);
    assert!(
        textbook.why.contains("b^2 - 4ac comes out as"),
        "{textbook:?}"
    );
    assert!(textbook.why.contains("roundings of f32"), "{textbook:?}");
    assert_eq!(textbook.exact_of_input, lost.exact.id);
    for accuracy in [Accuracy::Robust, Accuracy::Double, Accuracy::Adaptive] {
        let stable = tier(lost, accuracy);
        assert_eq!(stable.verdict, Verdict::Right, "{stable:?}");
        // The control: the reason is the textbook's own.
        assert!(!stable.why.contains("4ac"));
    }
    let candidate = &lost.candidates[0];
    let met = candidate.meetings[0].t.is_some();
    assert_ne!(met, candidate.t.is_some());
}

#[test]
fn a_textbook_takes_a_small_triangle_for_edge_on() {
    let small = |size: f64| {
        let corner = |x: f64, y: f64| DVec3::new(x * size, y * size, -1.0);
        let vertices = [corner(-1.0, -1.0), corner(1.0, -1.0), corner(0.0, 1.0)];
        middle(&scene(vec![Geometry::Triangle { vertices }]), Bounds::Tree)
    };
    let why = small(1e-4);
    let textbook = tier(&why, Accuracy::Textbook);
    assert_eq!(textbook.verdict, Verdict::FalseMiss);
    assert!(textbook.why.contains("edge-on"), "{textbook:?}");
    assert_eq!(tier(&why, Accuracy::Robust).verdict, Verdict::Right);
    // The control: a larger one.
    let why = small(1e-2);
    assert_eq!(tier(&why, Accuracy::Textbook).why, "right");
}

#[test]
fn the_answers_are_those_of_the_tracers() {
    use crate::kernel::trace::trace_pixel;
    let root = env!("CARGO_MANIFEST_DIR");
    let scene = Scene::load(format!("{root}/assets/scenes/shapes.toml")).unwrap();
    let scene = scene.with_size(24, 24);
    let flat = crate::flatten::flatten::<f32>(&scene);
    let mut shown = std::collections::BTreeSet::new();
    for (x, y) in (0..24).flat_map(|y| (0..24).map(move |x| (x, y))) {
        let why = explain(&scene, Bounds::Tree, x, y, &Unwatched).unwrap();
        let id = shown_id(trace_pixel(&flat, x, y).id);
        assert_eq!(tier(&why, Accuracy::Robust).id, id, "{x} {y}");
        shown.insert(id);
    }
    // Else the comparison would say nothing.
    assert!(shown.len() > 4, "{shown:?}");
}

fn shown_id(id: u32) -> Option<u32> {
    (id < NO_HIT).then_some(id)
}

#[test]
fn a_pixel_outside_is_refused() {
    let scene = scene(vec![wall(-1.0)]);
    for (x, y) in [(9, 0), (0, 9), (u32::MAX, 0)] {
        let error = explain(&scene, Bounds::Tree, x, y, &Unwatched).unwrap_err();
        assert_eq!(error.exit_code(), 2);
        assert!(error.to_string().contains("9 x 9"), "{error}");
    }
    assert!(explain(&scene, Bounds::Tree, 8, 8, &Unwatched).is_ok());
}

#[test]
fn a_lamp_is_told_from_a_shape() {
    let mut scene = scene(vec![wall(-8.0)]);
    scene.lights = vec![crate::scene::Light::Area {
        form: crate::scene::AreaForm::Sphere {
            center: DVec3::new(0.0, 0.0, -4.0),
            radius: 1.0,
        },
        radiance: [1.0; 3],
    }];
    let why = middle(&scene, Bounds::Tree);
    let found: Vec<_> = why
        .candidates
        .iter()
        .map(|c| (c.id, c.shape, c.lamp, c.material.as_deref()))
        .collect();
    let expected = [(0, None, Some(0), None), (1, Some(0), None, Some("clay"))];
    assert_eq!(found, expected);
}
