//! The meshes that a scene asks for: each loaded once, however often it stands.

use std::collections::HashMap;
use std::path::{Path, PathBuf};
use std::sync::Arc;

use glam::DVec3;

use super::image_file::root;
use crate::Result;
use crate::scene::mesh::{self, Builtin};
use crate::scene::obj::{self, ObjOptions};
use crate::scene::policy::Policy;
use crate::scene::texels::Images;
use crate::scene::{Material, Mesh, check};

/// Where a mesh comes from.
#[derive(Debug, Clone, PartialEq, Eq, Hash)]
pub(super) enum Source {
    /// A file, relative to the scene's folder.
    File(PathBuf),
    /// A built-in mesh and the number of triangles wished for.
    Builtin(Builtin, u32),
}

impl Source {
    pub(super) fn file(name: String) -> Self {
        Source::File(name.into())
    }
}

/// A mesh as it was loaded, and the forms of it that are in use.
pub(super) struct Asset {
    mesh: Arc<Mesh>,
    /// The largest |x|, |y|, |z| of a vertex.
    pub(super) extent: DVec3,
    materials: Vec<Material>,
    /// Where `materials` begin among the scene's, once they are there.
    offset: Option<u32>,
    variants: HashMap<Variant, Arc<Mesh>>,
}

/// What a shape wants of a mesh.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash)]
struct Variant {
    smooth: bool,
    own_materials: bool,
}

impl Asset {
    fn new(mesh: Mesh, materials: Vec<Material>) -> std::result::Result<Self, check::Flaw> {
        Ok(Self {
            extent: check::mesh(&mesh, materials.len())?,
            mesh: Arc::new(mesh),
            materials,
            offset: None,
            variants: HashMap::new(),
        })
    }

    pub(super) fn triangles(&self) -> u64 {
        self.mesh.triangles.len() as u64
    }

    /// The mesh with its vertex normals or without, with its own materials
    /// (which join the scene's) or without.
    pub(super) fn variant(
        &mut self,
        smooth: bool,
        own_materials: bool,
        scene_materials: &mut Vec<Material>,
    ) -> Arc<Mesh> {
        let variant = Variant {
            smooth: smooth || self.mesh.triangle_normals.is_empty(),
            own_materials: own_materials && !self.mesh.triangle_materials.is_empty(),
        };
        let plain = self.mesh.triangle_materials.is_empty();
        if variant.smooth && plain {
            return Arc::clone(&self.mesh);
        }
        if let Some(known) = self.variants.get(&variant) {
            return Arc::clone(known);
        }
        let mut mesh = Mesh::clone(&self.mesh);
        if !variant.smooth {
            mesh.normals = Vec::new();
            mesh.triangle_normals = Vec::new();
        }
        if variant.own_materials {
            let offset = *self.offset.get_or_insert_with(|| {
                // Materials are capped like shapes, far below 2^32.
                let offset = scene_materials.len() as u32;
                scene_materials.append(&mut self.materials);
                offset
            });
            for material in &mut mesh.triangle_materials {
                *material += offset;
            }
        } else {
            mesh.triangle_materials = Vec::new();
        }
        let mesh = Arc::new(mesh);
        self.variants.insert(variant, Arc::clone(&mesh));
        mesh
    }
}

/// Loads each source once.
pub(super) struct Library<'p> {
    folder: &'p Path,
    pub(super) policy: &'p Policy,
    assets: HashMap<Source, std::result::Result<Asset, String>>,
    /// All images of the scene, those of its meshes included.
    images: Images,
    pub(super) warnings: Vec<String>,
}

impl<'p> Library<'p> {
    /// Loads meshes from a folder, and their images beside those that are loaded.
    pub(super) fn new(folder: &'p Path, policy: &'p Policy, images: Images) -> Self {
        Self {
            folder,
            policy,
            assets: HashMap::new(),
            images,
            warnings: Vec::new(),
        }
    }

    /// The mesh of a source, or what is wrong with it.
    pub(super) fn get(&mut self, source: &Source) -> std::result::Result<&mut Asset, String> {
        if !self.assets.contains_key(source) {
            let asset = self.load(source);
            self.assets.insert(source.clone(), asset);
        }
        match self.assets.get_mut(source) {
            Some(Ok(asset)) => Ok(asset),
            Some(Err(message)) => Err(message.clone()),
            None => Err("was not loaded".into()),
        }
    }

    fn load(&mut self, source: &Source) -> std::result::Result<Asset, String> {
        match source {
            Source::Builtin(kind, detail) => {
                Asset::new(mesh::build(*kind, *detail), Vec::new()).map_err(|flaw| flaw.message)
            }
            Source::File(name) => {
                let path = self.folder.join(name);
                let file = self.read(&path).map_err(|error| error.to_string())?;
                let named = |warning| format!("{}: {warning}", path.display());
                self.warnings.extend(file.warnings.into_iter().map(named));
                Asset::new(file.mesh, file.materials)
                    .map_err(|flaw| format!("{}: {}", path.display(), flaw.message))
            }
        }
    }

    fn read(&mut self, path: &Path) -> Result<obj::ObjFile> {
        let options = ObjOptions {
            max_bytes: self.policy.max_mesh_bytes,
            max_triangles: self.policy.max_mesh_triangles,
            strict: self.policy.strict,
            root: root(self.folder, self.policy),
        };
        obj::load_with(path, &options, &mut self.images)
    }
}

#[cfg(test)]
mod tests {
    use super::super::image_file::ImageFiles;
    use super::*;

    fn library<'p>(folder: &'p Path, policy: &'p Policy) -> Library<'p> {
        let images = ImageFiles::new(folder, policy).into_images();
        Library::new(folder, policy, images)
    }

    fn asset() -> Asset {
        let mesh = Mesh {
            positions: vec![DVec3::ZERO, DVec3::X, DVec3::Y],
            triangles: vec![[0, 1, 2], [2, 1, 0]],
            normals: vec![DVec3::Z],
            triangle_normals: vec![[0; 3]; 2],
            triangle_materials: vec![1, 0],
            ..Mesh::default()
        };
        let material = |name: &str| Material {
            name: name.into(),
            albedo: [0.5; 3],
            ..Material::default()
        };
        Asset::new(mesh, vec![material("a"), material("b")]).expect("a good mesh")
    }

    #[test]
    fn own_materials_join_the_scene_once_and_are_found_there() {
        let mut asset = asset();
        let mut scene = vec![Material {
            name: "before".into(),
            albedo: [0.0; 3],
            ..Material::default()
        }];
        let smooth = asset.variant(true, true, &mut scene);
        let flat = asset.variant(false, true, &mut scene);
        assert_eq!(scene.len(), 3);
        for mesh in [&smooth, &flat] {
            let names = mesh
                .triangle_materials
                .iter()
                .map(|&m| scene[m as usize].name.as_str());
            assert_eq!(names.collect::<Vec<_>>(), ["b", "a"]);
        }
        assert!(flat.normals.is_empty() && !smooth.normals.is_empty());
        assert!(Arc::ptr_eq(&smooth, &asset.variant(true, true, &mut scene)));
        assert_eq!(scene.len(), 3);
    }

    #[test]
    fn a_mesh_under_another_material_leaves_its_own_at_home() {
        let mut scene = Vec::new();
        let plain = asset().variant(true, false, &mut scene);
        assert!(plain.triangle_materials.is_empty() && scene.is_empty());
    }

    #[test]
    fn a_mesh_that_breaks_a_rule_is_refused() {
        let mesh = Mesh {
            positions: vec![DVec3::NAN],
            ..Mesh::default()
        };
        assert!(Asset::new(mesh, Vec::new()).is_err());
    }

    #[test]
    fn meshes_share_images_and_their_room() {
        let folder = tempfile::tempdir().expect("a temporary folder");
        let write = |name: &str, text: &str| {
            std::fs::write(folder.path().join(name), text).expect("a file");
        };
        let image = folder.path().join("a.png");
        crate::frame::write_rgb8(&image, 2, 2, &[9; 12]).expect("an image");
        write("a.mtl", "newmtl m\nmap_Kd a.png\n");
        for name in ["a.obj", "b.obj"] {
            write(
                name,
                "mtllib a.mtl\nusemtl m\nv 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n",
            );
        }
        let texture = |library: &mut Library<'_>, name: &str| {
            let asset = library.get(&Source::file(name.into()))?;
            Ok::<_, String>(asset.materials[0].texture.clone())
        };
        let policy = |max_texels| Policy {
            max_texels,
            ..Policy::default()
        };
        let enough = policy(4);
        let mut library = library(folder.path(), &enough);
        let first = texture(&mut library, "a.obj").expect("a mesh");
        assert!(first.is_some());
        assert_eq!(texture(&mut library, "b.obj"), Ok(first));
        let short = policy(3);
        let refusal = texture(&mut self::library(folder.path(), &short), "a.obj");
        let message = refusal.expect_err("too large");
        assert!(message.contains("a.mtl:2: map_Kd"), "{message}");
        assert!(message.contains("more than the 3 allowed"), "{message}");
    }
}
