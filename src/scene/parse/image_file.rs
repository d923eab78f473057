//! The images that a scene file names.

use std::path::{Path, PathBuf};
use std::sync::Arc;

use super::faults::Faults;
use super::value::{Value, text};
use crate::scene::policy::Policy;
use crate::scene::texels::{Image, ImageOptions, Images};
use crate::scene::{Texels, check};

/// The endings of the files that hold more than the 8 bits of a screen.
const WIDE_RANGE: [&str; 2] = ["exr", "hdr"];

/// Loads the images that a scene file names.
pub(super) struct ImageFiles<'p> {
    folder: &'p Path,
    /// All images of the scene, those of its meshes too.
    images: Images,
}

/// The folder that files must lie under, if there is one.
pub(super) fn root(folder: &Path, policy: &Policy) -> Option<PathBuf> {
    (!policy.allow_outside).then(|| folder.to_owned())
}

impl<'p> ImageFiles<'p> {
    pub(super) fn new(folder: &'p Path, policy: &Policy) -> Self {
        Self {
            folder,
            images: Images::new(ImageOptions::of(policy, root(folder, policy))),
        }
    }

    /// What is loaded so far, and the room that is left.
    pub(super) fn into_images(self) -> Images {
        self.images
    }

    /// The image that an albedo is multiplied with.
    pub(super) fn albedo(
        &mut self,
        file: &Value<'_>,
        faults: &mut Faults<'_>,
    ) -> Option<Arc<Texels>> {
        let name = text(file, "file", faults)?;
        let image = self.get(file, &name, faults)?;
        let path = self.folder.join(&name).display().to_string();
        let verdict = check::brightest_texel(image.largest).map_err(|flaw| flaw.at(&path));
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
        match self.images.image(&self.folder.join(name)) {
            Ok(image) => Some(image),
            Err(error) => {
                let help = "the path is relative to the scene file's folder";
                faults.push(file.span(), error.to_string(), "cannot be used", help);
                None
            }
        }
    }
}
