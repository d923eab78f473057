//! Image files: each read under a cap, decoded to linear light, and checked.

mod decode;
#[cfg(test)]
mod tests;

use std::collections::HashMap;
use std::io::Read;
use std::path::{Path, PathBuf};
use std::sync::Arc;

use super::Texels;
use super::check;
use super::guard::{Guard, Refusal};
use super::policy::Policy;
use crate::{Error, Result};
use decode::decode;

/// What [`load`] and [`Images`] may read.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct ImageOptions {
    /// The most bytes that one file may have. Default: as [`Policy::max_image_bytes`].
    pub max_bytes: u64,
    /// The most texels that all images may have together. Default: as
    /// [`Policy::max_texels`].
    pub max_texels: u64,
    /// If given, files must lie under this folder, symbolic links resolved. Default: none.
    pub root: Option<PathBuf>,
}

impl Default for ImageOptions {
    fn default() -> Self {
        Self::of(&Policy::default(), None)
    }
}

impl ImageOptions {
    /// What a policy allows; `root` is the folder that files must lie under.
    pub fn of(policy: &Policy, root: Option<PathBuf>) -> Self {
        Self {
            max_bytes: policy.max_image_bytes,
            max_texels: policy.max_texels,
            root,
        }
    }
}

/// Reads a PNG, JPEG, OpenEXR or Radiance HDR file; contents decide, not the file's name.
///
/// PNG and JPEG are taken as sRGB (IEC 61966-2-1) and decoded to linear light, their alpha
/// as it is; profiles and orientation tags are not applied. EXR (one part, with the channels R,
/// G, B and perhaps A, or Y and perhaps A) and HDR are linear as they are. An image
/// without alpha has 1 everywhere.
///
/// # Errors
/// [`Error::Asset`] where the file is missing, not a regular file, outside the root, over a
/// limit, broken or of another kind; where it has no texels; and where a channel is negative
/// or not finite. [`Error::Limit`] where decoding takes more memory than there is.
pub fn load(path: &Path, options: &ImageOptions) -> Result<Texels> {
    read(path, options, 0)
}

/// Loads images, each file once.
#[derive(Debug)]
pub struct Images {
    options: ImageOptions,
    /// Each image, or what is wrong with its file.
    known: HashMap<PathBuf, std::result::Result<Image, String>>,
    /// Texels of all that is known.
    texels: u64,
}

/// An image that keeps the rules of a scene.
#[derive(Debug, Clone)]
pub(super) struct Image {
    pub texels: Arc<Texels>,
    /// The largest part of its colours.
    pub largest: f32,
}

impl Images {
    /// None so far.
    pub fn new(options: ImageOptions) -> Self {
        Self {
            options,
            known: HashMap::new(),
            texels: 0,
        }
    }

    /// The image of a file, as [`load`] reads it.
    ///
    /// # Errors
    /// As there; where an image breaks the rules of a scene ([`Scene::validate`](super::Scene::validate));
    /// all images together keep [`ImageOptions::max_texels`].
    pub fn load(&mut self, path: &Path) -> Result<Arc<Texels>> {
        self.image(path).map(|image| image.texels)
    }

    /// The same, with its largest colour.
    pub(super) fn image(&mut self, path: &Path) -> Result<Image> {
        // A file that is not there has no other name, and the reader words the error.
        let key = path.canonicalize().unwrap_or_else(|_| path.to_owned());
        if let Some(known) = self.known.get(&key) {
            let known = known.clone();
            return known.map_err(|message| asset_error(path, message));
        }
        let image = self.read(path);
        match &image {
            Ok(image) => {
                self.texels += image.texels.texels.len() as u64;
                self.known.insert(key, Ok(image.clone()));
            }
            Err(Error::Asset { message, .. }) => {
                self.known.insert(key, Err(message.clone()));
            }
            // Of the machine, not of the file.
            Err(_) => {}
        }
        image
    }

    fn read(&self, path: &Path) -> Result<Image> {
        let texels = read(path, &self.options, self.texels)?;
        let largest = check::texels(&texels).map_err(|flaw| asset_error(path, flaw.message))?;
        Ok(Image {
            texels: Arc::new(texels),
            largest,
        })
    }
}

/// `taken` texels are in other images.
fn read(path: &Path, options: &ImageOptions, taken: u64) -> Result<Texels> {
    let fail = |message| asset_error(path, message);
    let guard = Guard::new(options.root.as_deref())?;
    let mut file = guard
        .open(path, options.max_bytes)
        .map_err(|refusal| match refusal {
            Refusal::Missing => fail("no such file".into()),
            Refusal::Refused(message) => fail(message),
        })?;
    let mut bytes = Vec::new();
    file.read_to_end(&mut bytes)
        .map_err(|error| fail(format!("cannot be read: {error}")))?;
    let room = Room {
        max_texels: options.max_texels,
        taken,
    };
    let image = decode(path, &bytes, &room)?;
    image.check().map_err(fail)?;
    Ok(image)
}

/// How many texels an image may have.
struct Room {
    max_texels: u64,
    taken: u64,
}

impl Room {
    /// What is left.
    fn left(&self) -> u64 {
        self.max_texels.saturating_sub(self.taken)
    }

    /// Is there room for an image of this size, which a header claims? Asked before memory is
    /// taken.
    fn check(&self, width: u64, height: u64) -> std::result::Result<(), String> {
        if width.saturating_mul(height) <= self.left() {
            return Ok(());
        }
        let others = match self.taken {
            0 => String::new(),
            taken => format!(" beside {taken} in other images"),
        };
        Err(format!(
            "{width} x {height} texels{others} are more than the {} allowed; use a smaller image",
            self.max_texels
        ))
    }
}

impl Texels {
    /// Has it one texel or more, as many as its sides say, and is each channel a finite
    /// number from 0? Otherwise what is wrong, with the texel's place.
    pub(super) fn check(&self) -> std::result::Result<(), String> {
        let count = u64::from(self.width) * u64::from(self.height);
        if count == 0 || count != self.texels.len() as u64 {
            return Err(format!(
                "{} texels do not make an image of {} x {}; one has a texel or more",
                self.texels.len(),
                self.width,
                self.height
            ));
        }
        let good = |channel: &f32| channel.is_finite() && *channel >= 0.0;
        let wrong = self.texels.iter().position(|texel| !texel.iter().all(good));
        let Some(at) = wrong else { return Ok(()) };
        let [r, g, b, a] = self.texels[at];
        Err(format!(
            "the texel {} from the left and {} from the top, counted from 0, is ({r}, {g}, {b}) \
             with alpha {a}; every channel must be a finite number from 0",
            at as u64 % u64::from(self.width),
            at as u64 / u64::from(self.width),
        ))
    }
}

fn asset_error(path: &Path, message: String) -> Error {
    Error::Asset {
        path: path.to_owned(),
        line: None,
        message,
    }
}
