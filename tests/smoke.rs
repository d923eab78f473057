use glam::DVec3;
use rayproof::flatten::flatten;
use rayproof::gpu::device::Gpu;
use rayproof::kernel::trace::trace_pixel;
use rayproof::scene::*;
use rayproof::watch::Unwatched;

#[test]
fn smoke() {
    let t0 = std::time::Instant::now();
    let gpu = Gpu::open(None).unwrap();
    println!("open {:?}", t0.elapsed());
    println!("{:?} {:?}", gpu.adapter, gpu.arithmetic);
    println!("exact {}", gpu.is_exact());
    let mut shapes = vec![];
    let mat = |i: usize| i % 3;
    for i in 0..40 {
        let f = i as f64;
        shapes.push(Shape {
            geometry: Geometry::Sphere {
                center: DVec3::new(
                    (f * 1.3).sin() * 4.0,
                    (f * 2.1).cos() * 3.0,
                    -8.0 - (f * 0.7).sin() * 2.0,
                ),
                radius: 0.3 + 0.02 * f,
            },
            transform: Transform::default(),
            material: mat(i),
        });
    }
    shapes.push(Shape {
        geometry: Geometry::Plane {
            point: DVec3::new(0.0, -3.0, 0.0),
            normal: DVec3::new(0.1, 1.0, 0.05),
        },
        transform: Transform::default(),
        material: 1,
    });
    shapes.push(Shape {
        geometry: Geometry::Disk {
            center: DVec3::new(1.0, 1.0, -5.0),
            normal: DVec3::new(0.1, 1.0, 1.05),
            radius: 0.7,
        },
        transform: Transform::default(),
        material: 2,
    });
    shapes.push(Shape {
        geometry: Geometry::Triangle {
            vertices: [
                DVec3::new(-3.0, -2.0, -5.0),
                DVec3::new(-1.0, -2.0, -5.5),
                DVec3::new(-2.0, 1.0, -6.0),
            ],
        },
        transform: Transform::default(),
        material: 0,
    });
    let scene = Scene {
        image: Image {
            width: 1000,
            height: 1000,
            transfer: Transfer::Srgb,
        },
        camera: Camera {
            eye: DVec3::new(0.1, 0.2, 0.3),
            target: DVec3::new(0.0, 0.0, -8.0),
            up: DVec3::Y,
            fov_degrees: 60.0,
            sampling: PixelSampling::Center,
        },
        background: Background {
            from: [1.0; 3],
            to: [0.5, 0.6, 0.7],
            offset: 1.0,
            slope: -0.9,
        },
        ambient: [0.1; 3],
        lights: vec![
            Light::Point {
                position: DVec3::new(3.0, 5.0, 0.0),
                color: [30.0, 28.0, 20.0],
                falloff: Falloff::InverseSquare,
            },
            Light::Directional {
                direction: DVec3::new(1.0, 2.0, 3.0),
                color: [0.3; 3],
            },
        ],
        materials: vec![
            Material {
                name: "a".into(),
                albedo: [0.8, 0.2, 0.1],
            },
            Material {
                name: "b".into(),
                albedo: [0.3; 3],
            },
            Material {
                name: "c".into(),
                albedo: [0.1, 0.5, 0.8],
            },
        ],
        shapes,
    };
    let flat = flatten::<f32>(&scene);
    let t0 = std::time::Instant::now();
    let mut all = Vec::new();
    rayproof::gpu::render::render(&gpu, &flat, &Unwatched, &mut |_, p| {
        all.extend_from_slice(p)
    })
    .unwrap();
    println!("gpu {:?}", t0.elapsed());
    let t0 = std::time::Instant::now();
    let mut bad = 0;
    let mut hits = 0;
    for y in 0..1000 {
        for x in 0..1000 {
            let c = trace_pixel(&flat, x, y);
            let g = &all[(y * 1000 + x) as usize];
            if c.id != u32::MAX {
                hits += 1;
            }
            if bytemuck::bytes_of(&c) != bytemuck::bytes_of(g) {
                bad += 1;
                if bad < 5 {
                    println!("{x} {y}\n {c:?}\n {g:?}");
                }
            }
        }
    }
    println!("cpu {:?} hits {hits}", t0.elapsed());
    assert_eq!(bad, 0);
}
