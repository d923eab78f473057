//! What a scene file means: the `Scene` that comes out of it.

use std::path::Path;
use std::sync::Arc;

use glam::DVec3;
use rayproof::Error;
use rayproof::scene::parse::{Loaded, load, parse_str};
use rayproof::scene::policy::Policy;
use rayproof::scene::{Geometry, Light, Mesh, PixelSampling, Scene, Transfer};

const HEAD: &str =
    "camera = { eye = [0, 0, 5], target = [0, 0, 0] }\nambient = { color = [1, 1, 1] }\n";

fn parse_in(folder: &Path, body: &str) -> rayproof::Result<Loaded> {
    parse_str(
        &format!("{HEAD}{body}"),
        "test.toml",
        folder,
        &Policy::default(),
    )
}

fn scene(body: &str) -> Scene {
    let folder = tempfile::tempdir().expect("a temporary folder");
    parse_in(folder.path(), body)
        .unwrap_or_else(|e| panic!("{:?}", miette::Report::new(e)))
        .scene
}

fn meshes(scene: &Scene) -> Vec<&Arc<Mesh>> {
    let mut meshes = Vec::new();
    for shape in &scene.shapes {
        if let Geometry::Mesh(mesh) = &shape.geometry {
            meshes.push(mesh);
        }
    }
    meshes
}

#[test]
fn test_1_of_the_report_is_as_the_report_has_it() {
    let path = Path::new(env!("CARGO_MANIFEST_DIR")).join("assets/scenes/seed-spheres.toml");
    let scene = Scene::load(&path).expect("the scene loads");
    assert_eq!((scene.image.width, scene.image.height), (1000, 1000));
    assert_eq!(scene.image.transfer, Transfer::Sqrt);
    assert_eq!(scene.camera.sampling, PixelSampling::Corner);
    assert_eq!(scene.camera.eye, DVec3::new(0.0, 0.0, 10.0));
    assert_eq!(scene.camera.fov_degrees, 60.0);
    let expected = (0..2).flat_map(|half| {
        (0..6).flat_map(move |j| {
            (0..6).map(move |i| {
                let corner = [(-5.0, 2.0), (1.0, -7.0)][half];
                DVec3::new(corner.0 + f64::from(i), corner.1 + f64::from(j), -8.0)
            })
        })
    });
    let centers = scene.shapes.iter().map(|s| match s.geometry {
        Geometry::Sphere { center, radius } => {
            assert_eq!(radius, 0.1);
            s.transform.linear * center + s.transform.translate
        }
        ref other => panic!("{other:?}"),
    });
    assert!(centers.eq(expected), "the 72 centres are exact");
    let mut albedos: Vec<_> = scene.materials.iter().map(|m| m.albedo).collect();
    albedos.dedup();
    assert_eq!(albedos.len(), 72);
    assert_eq!(scene.materials[17].name, "lot#17");
    assert_eq!(scene.shapes[71].material, 71);
}

#[test]
fn shapes_come_in_the_order_of_their_kinds_and_grids_x_fastest() {
    let scene = scene(
        "[[mesh]]\nbuiltin = 'box'\n\
         [[triangle]]\nvertices = [[0, 0, 0], [1, 0, 0], [0, 1, 0]]\n\
         [[disk]]\ncenter = [0, 0, 0]\nnormal = [0, 1, 0]\nradius = 1\n\
         [[plane]]\npoint = [0, 0, 0]\nnormal = [0, 1, 0]\n\
         [[sphere]]\nradius = 1\ntranslate = [10, 0, 0]\n\
         grid = { count = [2, 2, 1], step = [1, 3, 0] }\n\
         [[sphere]]\nradius = 2\n",
    );
    let names: Vec<_> = scene.shapes.iter().map(|s| s.geometry.name()).collect();
    let spheres = ["sphere"; 5];
    assert_eq!(names[..5], spheres);
    assert_eq!(names[5..], ["plane", "disk", "triangle", "mesh"]);
    let places: Vec<_> = scene.shapes[..5]
        .iter()
        .map(|s| s.transform.translate.truncate().to_array())
        .collect();
    let expected = [
        [10.0, 0.0],
        [11.0, 0.0],
        [10.0, 3.0],
        [11.0, 3.0],
        [0.0, 0.0],
    ];
    assert_eq!(places, expected);
}

#[test]
fn scale_comes_before_rotation_and_both_before_translation() {
    let scene = scene(
        "[[sphere]]\ncenter = [1, 0, 0]\nradius = 3\nscale = 2\nrotate = [0, 0, 90]\n\
         translate = [1e9, 0, 0]\n\
         [[mesh]]\nbuiltin = 'box'\nscale = [2, 3, 4]\nrotate = [0, 0, 90]\ntranslate = [1, 1, 1]\n",
    );
    let sphere = &scene.shapes[0];
    let Geometry::Sphere { center, radius } = sphere.geometry else {
        panic!("{:?}", sphere.geometry);
    };
    assert_eq!((center, radius), (DVec3::new(2.0, 0.0, 0.0), 6.0));
    assert_eq!(sphere.transform.linear * center, DVec3::new(0.0, 2.0, 0.0));
    assert_eq!(sphere.transform.translate, DVec3::new(1e9, 0.0, 0.0));
    let mesh = &scene.shapes[1].transform;
    assert_eq!(mesh.linear * DVec3::X, DVec3::new(0.0, 2.0, 0.0));
    assert_eq!(mesh.linear * DVec3::Y, DVec3::new(-3.0, 0.0, 0.0));
    assert_eq!(mesh.linear * DVec3::Z, DVec3::new(0.0, 0.0, 4.0));
}

#[test]
fn intensity_multiplies_the_color() {
    let scene = scene(
        "[[light]]\nkind = 'point'\nposition = [1, 2, 3]\ncolor = [1, 0.5, 0]\nintensity = 4\n",
    );
    let Light::Point { color, .. } = scene.lights[0] else {
        panic!("{:?}", scene.lights[0]);
    };
    assert_eq!(color, [4.0, 2.0, 0.0]);
}

#[test]
fn materials_are_grey_by_default_or_what_default_says() {
    let grey = scene("[[sphere]]\nradius = 1\n");
    assert_eq!(grey.materials[grey.shapes[0].material].albedo, [0.8; 3]);
    let named =
        scene("[[material]]\nname = 'default'\nalbedo = [1, 0, 0]\n[[sphere]]\nradius = 1\n");
    assert_eq!(named.materials.len(), 1);
    assert_eq!(named.materials[0].albedo, [1.0, 0.0, 0.0]);
}

#[test]
fn random_albedos_depend_on_seed_and_instance_alone() {
    let body = |seed: u32, more: &str| {
        format!(
            "[[material]]\nname = 'lot'\nalbedo = {{ random = {seed} }}\n{more}\
             [[sphere]]\nradius = 1\nmaterial = 'lot'\n\
             grid = {{ count = [3, 1, 1], step = [1, 0, 0] }}\n"
        )
    };
    let albedos = |text: &str| -> Vec<_> {
        let scene = scene(text);
        let of = |s: &rayproof::scene::Shape| scene.materials[s.material].albedo;
        scene.shapes.iter().map(of).collect()
    };
    let first = albedos(&body(1, ""));
    let with_another = body(1, "[[material]]\nname = 'other'\nalbedo = { random = 9 }\n");
    assert_eq!(first, albedos(&with_another));
    assert_ne!(first, albedos(&body(2, "")));
    assert!(first[0] != first[1] && first[1] != first[2]);
}

#[test]
fn a_mesh_is_shared_and_flat_where_asked() {
    let scene = scene(
        "[[mesh]]\nbuiltin = 'icosphere'\ngrid = { count = [3, 1, 1], step = [2, 0, 0] }\n\
         [[mesh]]\nbuiltin = 'icosphere'\nsmooth = false\n\
         [[mesh]]\nbuiltin = 'icosphere'\nsmooth = false\n\
         [[mesh]]\nbuiltin = 'icosphere'\ndetail = 80\n",
    );
    let meshes = meshes(&scene);
    assert!(Arc::ptr_eq(meshes[0], meshes[2]));
    assert!(Arc::ptr_eq(meshes[3], meshes[4]));
    assert!(!Arc::ptr_eq(meshes[0], meshes[3]));
    assert!(!Arc::ptr_eq(meshes[0], meshes[5]));
    assert!(!meshes[0].triangle_normals.is_empty());
    assert!(meshes[3].normals.is_empty() && meshes[3].triangle_normals.is_empty());
    assert_eq!(meshes[0].positions, meshes[3].positions);
}

#[test]
fn a_file_that_cannot_be_used_is_told_at_each_place_beside_other_faults() {
    let folder = tempfile::tempdir().expect("a temporary folder");
    let body = "[[mesh]]\nfile = 'none.obj'\n[[mesh]]\nfile = 'none.obj'\nscale = 0\n";
    let Err(Error::Scene(faults)) = parse_in(folder.path(), body) else {
        panic!("accepted");
    };
    let source = faults.source_code.inner();
    let told: Vec<_> = faults
        .faults
        .iter()
        .map(|f| (&source[f.span.clone()], f.message.contains("none.obj")))
        .collect();
    assert_eq!(
        told,
        [("'none.obj'", true), ("'none.obj'", true), ("0", false)]
    );
}

#[test]
fn limits_count_instances_and_triangles() {
    let folder = tempfile::tempdir().expect("a temporary folder");
    let body = "[[sphere]]\nradius = 1\ngrid = { count = [5, 1, 1], step = [1, 0, 0] }\n\
                [[mesh]]\nbuiltin = 'tetrahedron'\ndetail = 4\n";
    let text = format!("{HEAD}{body}");
    let with = |max_shapes, max_primitives| {
        let policy = Policy {
            max_shapes,
            max_primitives,
            ..Policy::default()
        };
        parse_str(&text, "test.toml", folder.path(), &policy).is_ok()
    };
    assert!(with(6, 9));
    assert!(!with(5, 9));
    assert!(!with(6, 8));
}

#[test]
fn a_scene_is_a_regular_file_of_utf_8_within_its_cap() {
    let folder = tempfile::tempdir().expect("a temporary folder");
    let file = folder.path().join("scene.toml");
    let good = format!("{HEAD}[[sphere]]\nradius = 1\n");
    let says =
        |policy: &Policy, path: &Path, part: &str, at: Option<usize>| match load(path, policy) {
            Err(Error::Asset { message, line, .. }) => {
                assert!(message.contains(part), "{message}");
                assert_eq!(line, at, "{message}");
            }
            other => panic!("{part}: {other:?}"),
        };
    let policy = Policy::default();
    std::fs::write(&file, &good).expect("written");
    load(&file, &policy).expect("a good file");

    let exact = Policy {
        max_scene_bytes: good.len() as u64,
        ..Policy::default()
    };
    load(&file, &exact).expect("as large as may be");
    let tight = Policy {
        max_scene_bytes: good.len() as u64 - 1,
        ..Policy::default()
    };
    says(&tight, &file, "larger than", None);
    says(&policy, folder.path(), "not a regular file", None);
    says(
        &policy,
        &folder.path().join("none.toml"),
        "cannot be read",
        None,
    );
    let latin = [HEAD.as_bytes(), b"# caf\xe9\n"].concat();
    std::fs::write(&file, latin).expect("written");
    says(&policy, &file, "0xe9 is not UTF-8", Some(3));
}

#[cfg(unix)]
#[test]
fn a_device_and_a_fifo_are_refused_at_once() {
    let folder = tempfile::tempdir().expect("a temporary folder");
    let fifo = folder.path().join("fifo.toml");
    let made = std::process::Command::new("mkfifo").arg(&fifo).status();
    assert!(made.expect("mkfifo").success());
    for path in [fifo.as_path(), Path::new("/dev/zero")] {
        let refused = load(path, &Policy::default());
        assert!(
            matches!(refused, Err(Error::Asset { .. })),
            "{}",
            path.display()
        );
    }
}

#[test]
fn a_file_keeps_its_materials_unless_the_scene_names_one() {
    let folder = tempfile::tempdir().expect("a temporary folder");
    let write = |name: &str, text: &str| std::fs::write(folder.path().join(name), text);
    write("two.mtl", "newmtl red\nKd 1 0 0\nnewmtl blue\nKd 0 0 1\n").expect("written");
    let obj = "mtllib two.mtl\nv 0 0 0\nv 1 0 0\nv 0 1 0\nv 0 0 1\n\
               usemtl red\nf 1 2 3\nusemtl blue\nf 1 3 4\n";
    write("two.obj", obj).expect("written");
    let loaded = parse_in(
        folder.path(),
        "[[material]]\nname = 'grey'\nalbedo = [0.5, 0.5, 0.5]\n\
         [[mesh]]\nfile = 'two.obj'\n[[mesh]]\nfile = 'two.obj'\nmaterial = 'grey'\n",
    );
    let scene = loaded.expect("it loads").scene;
    let own: Vec<_> = meshes(&scene)[0]
        .triangle_materials
        .iter()
        .map(|&m| scene.materials[m as usize].name.as_str())
        .collect();
    assert_eq!(own, ["red", "blue"]);
    assert!(meshes(&scene)[1].triangle_materials.is_empty());
    assert_eq!(scene.materials[scene.shapes[1].material].name, "grey");
}
