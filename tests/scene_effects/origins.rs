//! Where the parts of a scene stand.

use rayproof::scene::Origin;
use rayproof::scene::parse::parse_str;
use rayproof::scene::policy::Policy;

#[test]
fn origins_say_where_everything_stands() {
    let text = "\
[camera]
eye = [0, 0, 5]
target = [0, 0, 0]
[ambient]
color = [1, 1, 1]
[integrator]
samples = 2
[[light]]
kind = 'point'
position = [0, 1, 0]
name = 'key'
[[light]]
kind = 'point'
position = [0, 2, 0]
[[material]]
name = 'lot'
albedo = { random = 1 }
[[mesh]]
file = 'two.obj'
[[sphere]]
radius = 1
material = 'lot'
grid = { count = [2, 1, 1], step = [1, 0, 0] }
[[group]]
[[group.sphere]]
radius = 1
";
    let folder = tempfile::tempdir().expect("a temporary folder");
    let write = |name, text| std::fs::write(folder.path().join(name), text).expect("written");
    write("two.mtl", "newmtl leaf\nKd 0 1 0\n");
    write(
        "two.obj",
        "mtllib two.mtl\nv 0 0 0\nv 1 0 0\nv 0 1 0\nusemtl leaf\nf 1 2 3\n",
    );
    let loaded = parse_str(text, "test.toml", folder.path(), &Policy::default())
        .unwrap_or_else(|e| panic!("{:?}", miette::Report::new(e)));
    let origins = &loaded.scene.origins;
    let at = |name: Option<&str>, line| Origin {
        name: name.map(str::to_owned),
        line,
    };
    assert_eq!(origins.camera, at(None, Some(1)));
    assert_eq!(origins.ambient, at(None, Some(4)));
    assert_eq!(origins.integrator, at(None, Some(6)));
    assert_eq!(origins.fog, Origin::default());
    assert_eq!(origins.environment, Origin::default());
    assert_eq!(
        origins.lights,
        [at(Some("key"), Some(8)), at(None, Some(12))]
    );
    let lines: Vec<_> = origins.shapes.iter().map(|origin| origin.line).collect();
    assert_eq!(lines, [Some(20), Some(20), Some(18), Some(25)]);
    let expected = [
        at(Some("lot#0"), Some(15)),
        at(Some("lot#1"), Some(15)),
        at(Some("leaf"), Some(18)),
        at(Some("default"), None),
    ];
    assert_eq!(origins.materials, expected);
    assert_eq!(origins.materials.len(), loaded.scene.materials.len());
    assert_eq!(origins.shapes.len(), loaded.scene.shapes.len());
}
