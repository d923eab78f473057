//! The images that a scene asks for: each loaded once, however often it is used.

use std::collections::HashMap;
use std::path::{Path, PathBuf};
use std::sync::Arc;

use super::faults::Faults;
use super::value::{Value, text};
use crate::Result;
use crate::scene::policy::Policy;
use crate::scene::texels::{self, ImageOptions};
use crate::scene::{Texels, check};

/// The endings of the files that hold more than the 8 bits of a screen.
const WIDE_RANGE: [&str; 2] = ["exr", "hdr"];

/// An image in order.
#[derive(Clone)]
struct Image {
    texels: Arc<Texels>,
    /// The largest part of its colours.
    largest: f32,
}

/// Loads each image once.
pub(super) struct Images<'p> {
    folder: &'p Path,
    policy: &'p Policy,
    loaded: HashMap<PathBuf, std::result::Result<Image, String>>,
}

impl<'p> Images<'p> {
    pub(super) fn new(folder: &'p Path, policy: &'p Policy) -> Self {
        Self {
            folder,
            policy,
            loaded: HashMap::new(),
        }
    }

    /// The image that an albedo is multiplied with.
    pub(super) fn albedo(
        &mut self,
        file: &Value<'_>,
        faults: &mut Faults<'_>,
    ) -> Option<Arc<Texels>> {
        let name = text(file, "file", faults)?;
        let image = self.get(file, &name, faults)?;
        let verdict = check::brightest_texel(image.largest);
        faults.judge(file.span(), verdict).then_some(image.texels)
    }

    /// The image that lights a scene.
    pub(super) fn wide_range(
        &mut self,
        file: &Value<'_>,
        faults: &mut Faults<'_>,
    ) -> Option<Arc<Texels>> {
        let name = text(file, "file", faults)?;
        let ending = Path::new(&name).extension().unwrap_or_default();
        if !WIDE_RANGE
            .iter()
            .any(|wide| ending.eq_ignore_ascii_case(wide))
        {
            let message = format!("an environment is an .exr or .hdr file, not \"{name}\"");
            let help = "a lamp in the picture is far brighter than the white of other files";
            faults.push(file.span(), message, "another kind of file", help);
            return None;
        }
        self.get(file, &name, faults).map(|image| image.texels)
    }

    fn get(&mut self, file: &Value<'_>, name: &str, faults: &mut Faults<'_>) -> Option<Image> {
        let (folder, policy) = (self.folder, self.policy);
        let image = self.loaded.entry(name.into()).or_insert_with(|| {
            let texels = load_texels(folder, name, policy).map_err(|error| error.to_string())?;
            let largest = check::texels(&texels)
                .map_err(|flaw| format!("{}: {}", folder.join(name).display(), flaw.message))?;
            let texels = Arc::new(texels);
            Ok(Image { texels, largest })
        });
        match image {
            Ok(image) => Some(image.clone()),
            Err(message) => {
                let help = "the path is relative to the scene file's folder";
                faults.push(file.span(), message.clone(), "cannot be used", help);
                None
            }
        }
    }
}

/// The texels of an image file in the scene's folder.
fn load_texels(folder: &Path, name: &str, policy: &Policy) -> Result<Texels> {
    let root = (!policy.allow_outside).then(|| folder.to_owned());
    texels::load(&folder.join(name), &ImageOptions::of(policy, root))
}

#[cfg(test)]
mod tests {
    use toml::de::DeTable;

    use super::*;

    /// Images of a grey each, as if they had been read.
    fn with(greys: &[(&str, f32)]) -> HashMap<PathBuf, std::result::Result<Image, String>> {
        let image = |&(name, grey): &(&str, f32)| {
            let texels = Texels {
                name: name.into(),
                width: 1,
                height: 1,
                texels: vec![[grey, 0.0, 0.0, 1.0]],
            };
            let largest = check::texels(&texels).map_err(|flaw| flaw.message);
            let image = largest.map(|largest| Image {
                texels: Arc::new(texels),
                largest,
            });
            (PathBuf::from(name), image)
        };
        greys.iter().map(image).collect()
    }

    #[test]
    fn an_image_is_kept_and_an_albedo_ends_at_1() {
        let policy = Policy::default();
        let mut images = Images::new(Path::new("."), &policy);
        images.loaded = with(&[("white.exr", 1.0), ("lamp.exr", 9.0)]);
        let text = "white = 'white.exr'\nlamp = 'lamp.exr'\n";
        let table = DeTable::parse(text).expect("two keys");
        let file = |key| table.get_ref().get(key).expect("a key");
        let mut faults = Faults::new(text, Vec::new(), Vec::new());
        let first = images.albedo(file("white"), &mut faults).expect("white");
        let second = images
            .wide_range(file("white"), &mut faults)
            .expect("white");
        assert!(Arc::ptr_eq(&first, &second));
        assert!(images.wide_range(file("lamp"), &mut faults).is_some());
        assert!(faults.is_empty());
        assert!(images.albedo(file("lamp"), &mut faults).is_none());
        assert!(!faults.is_empty());
    }
}
