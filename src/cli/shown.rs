//! What a pixel of a written picture shows: a layer, or what its ray tested.

use std::path::Path;
use std::str::FromStr;

use rayproof::Scene;
use rayproof::count::{CountLayer, CountMap};
use rayproof::error::{Error, Result};
use rayproof::frame::{self, Frame, Layer};
use rayproof::render::{Settings, outlines};
use rayproof::scene::Transfer;

/// White.
const OUTLINE: [u8; 3] = [255; 3];

/// What a pixel shows.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) enum Shown {
    /// A layer of the picture.
    Layer(Layer),
    /// What a ray tested.
    Count(CountLayer),
}

impl Shown {
    /// The layers of a picture, all that a ray finds.
    pub(super) fn all_layers() -> Vec<Self> {
        Layer::ALL.map(Self::Layer).to_vec()
    }

    pub(super) fn is_counted(self) -> bool {
        matches!(self, Self::Count(_))
    }
}

impl FromStr for Shown {
    type Err = String;

    fn from_str(name: &str) -> Result<Self, String> {
        let mut counted = CountLayer::ALL.into_iter();
        if let Some(layer) = counted.find(|layer| layer.name() == name) {
            return Ok(Self::Count(layer));
        }
        name.parse().map(Self::Layer).map_err(|_| {
            let layers = Layer::ALL.map(Layer::name);
            let counts = CountLayer::ALL.map(CountLayer::name);
            let names = [&layers[..], &counts[..]].concat().join(", ");
            format!("no layer is named '{name}': use one of {names}")
        })
    }
}

/// What a picture is written from.
pub(super) struct Written<'a> {
    pub(super) scene: &'a Scene,
    pub(super) settings: Settings,
    pub(super) frame: &'a Frame,
    /// Empty where no layer asks for it.
    pub(super) counted: &'a CountMap,
}

impl Written<'_> {
    /// Writes a PNG of one layer. A heat map of the volumes has their outlines in it.
    ///
    /// # Errors
    ///
    /// [`Error::Output`]; the old file, if any, is then untouched.
    pub(super) fn write_png(&self, path: &Path, shown: Shown, transfer: Transfer) -> Result<()> {
        let layer = match shown {
            Shown::Layer(layer) => return self.frame.write_png(path, layer, transfer),
            Shown::Count(layer) => layer,
        };
        let mut rgb = self.counted.to_rgb8(layer);
        if layer == CountLayer::Bounds {
            let outlines = outlines(self.scene, self.settings)?;
            let (pixels, _) = rgb.as_chunks_mut::<3>();
            for (pixel, _) in pixels.iter_mut().zip(outlines).filter(|(_, drawn)| *drawn) {
                *pixel = OUTLINE;
            }
        }
        frame::write_rgb8(path, self.frame.width, self.frame.height, &rgb)
    }

    /// Writes an EXR of layers and counts, as numbers.
    ///
    /// # Errors
    ///
    /// As [`Self::write_png`].
    pub(super) fn write_exr(&self, path: &Path, shown: &[Shown]) -> Result<()> {
        let mut layers = Vec::new();
        let mut counts = Vec::new();
        for shown in shown {
            match *shown {
                Shown::Layer(layer) => layers.push(layer),
                Shown::Count(layer) => {
                    let pixels = self.counted.pixels.iter();
                    counts.push((layer.name(), pixels.map(|c| layer.of(c)).collect()));
                }
            }
        }
        self.frame.write_exr_with(path, &layers, counts)
    }
}

/// What a PNG is to show: colour, unless something else is asked for.
///
/// # Errors
///
/// [`Error::Usage`] where several things are.
pub(super) fn one_layer_of(shown: &[Shown]) -> Result<Shown> {
    match shown {
        [] => Ok(Shown::Layer(Layer::Color)),
        [shown] => Ok(*shown),
        _ => Err(Error::Usage(
            "a PNG shows one layer; an EXR holds several".into(),
        )),
    }
}
