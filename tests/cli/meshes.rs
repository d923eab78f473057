//! `mesh`: built-in meshes as files.

use super::Room;

const NAMES: [&str; 6] = [
    "teapot",
    "icosphere",
    "knot",
    "terrain",
    "box",
    "tetrahedron",
];

/// A scene with one mesh under a material of the scene.
fn scene(mesh: &str) -> String {
    format!(
        "[image]\nwidth = 40\nheight = 30\n[camera]\neye = [1, 2, 5]\ntarget = [0, 0, 0]\n\
         [[light]]\nkind = \"directional\"\ndirection = [1, 2, 3]\nshadow = false\n\
         [[material]]\nname = \"jade\"\nalbedo = [0.2, 0.65, 0.45]\n\
         [[mesh]]\n{mesh}\nmaterial = \"jade\"\n"
    )
}

#[test]
fn each_mesh_is_written_and_renders_as_the_built_in_one() {
    let room = Room::new();
    for name in NAMES {
        room.write(
            "built-in.toml",
            scene(&format!("builtin = \"{name}\"\ndetail = 400")),
        );
        room.write("file.toml", scene(&format!("file = \"{name}.obj\"")));
        room.run(&format!("mesh {name} --detail 400 -o {name}.obj"))
            .with(0);
        room.run("render built-in.toml -o built-in.exr --backend cpu")
            .with(0);
        room.run("render file.toml -o file.exr --backend cpu")
            .with(0);
        let compared = room
            .run("compare built-in.exr file.exr --json")
            .with(0)
            .json();
        assert_eq!(compared["different_pixels"], 0, "{name}");
        // GPU with the one, CPU with the other.
        room.run("compare built-in.toml file.toml").with(0);
    }
    // The control: another mesh is another picture.
    room.write("other.toml", scene("builtin = \"knot\"\ndetail = 400"));
    room.run("compare file.toml other.toml").with(1);
}

#[test]
fn detail_is_about_the_number_of_triangles() {
    let room = Room::new();
    for name in ["icosphere", "knot", "terrain"] {
        let triangles = |detail: u32| {
            let line = format!("mesh {name} --detail {detail} -o a.obj --json");
            room.run(&line).with(0).json()["triangles"]
                .as_u64()
                .expect("a number")
        };
        let (few, many) = (triangles(300), triangles(20_000));
        assert!((50..=1800).contains(&few), "{name}: {few}");
        assert!((3500..=120_000).contains(&many), "{name}: {many}");
    }
}
