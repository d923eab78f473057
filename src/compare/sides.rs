//! Two pictures side by side, layer by layer, wherever they come from.

use super::difference::{self, DifferenceMap};
use super::tally::{Mark, Pair, Tally, Values};
use super::{Comparison, LayerDifference, Tolerance, flip};
use crate::frame::transfer::{displayable, srgb_decode};
use crate::frame::{Channel, Frame, Layer, Picture, PictureValues, Samples};
use crate::{Error, Result};

/// Two pictures of one size, as pairs of layers.
pub(super) struct Sides<'a> {
    left: String,
    right: String,
    width: usize,
    height: usize,
    color: Option<Pair<'a>>,
    others: Vec<Pair<'a>>,
}

impl<'a> Sides<'a> {
    pub fn of_frames(left: &'a Frame, right: &'a Frame) -> Result<Self> {
        left.check_lengths()?;
        right.check_lengths()?;
        check_sizes((left.width, left.height), (right.width, right.height))?;
        let float = |layer: Layer, components, left: &'a [f32], right: &'a [f32]| Pair {
            name: layer.to_string(),
            components,
            values: Values::Float(left, right),
        };
        let triple = |layer, left: &'a [[f32; 3]], right: &'a [[f32; 3]]| {
            float(layer, 3, left.as_flattened(), right.as_flattened())
        };
        Ok(Self {
            left: "left".into(),
            right: "right".into(),
            width: left.width as usize,
            height: left.height as usize,
            color: Some(triple(Layer::Color, &left.color, &right.color)),
            others: vec![
                float(Layer::Depth, 1, &left.depth, &right.depth),
                triple(Layer::Normal, &left.normal, &right.normal),
                triple(Layer::Position, &left.position, &right.position),
                Pair {
                    name: Layer::Id.to_string(),
                    components: 1,
                    values: Values::Id(&left.id, &right.id),
                },
            ],
        })
    }

    pub fn of_pictures(left: &'a Picture, right: &'a Picture) -> Result<Self> {
        check_sizes((left.width, left.height), (right.width, right.height))?;
        let color = |values| Pair {
            name: Layer::Color.to_string(),
            components: 3,
            values,
        };
        use PictureValues::{Encoded, Linear};
        let (color, others) = match (&left.values, &right.values) {
            (Encoded { bits: a, codes: l }, Encoded { bits: b, codes: r }) => {
                let values = Values::Code {
                    left: l.as_flattened(),
                    right: r.as_flattened(),
                    // 16-bit codes in one code of 8 bits: 65535 / 255.
                    step: if *a.max(b) == 8 { 257 } else { 1 },
                };
                (Some(color(values)), Vec::new())
            }
            (
                Linear {
                    color: l,
                    channels: left_channels,
                },
                Linear {
                    color: r,
                    channels: right_channels,
                },
            ) => {
                let others = pair_channels(left, left_channels, right, right_channels)?;
                match (l, r) {
                    (Some(l), Some(r)) => {
                        let values = Values::Float(l.as_flattened(), r.as_flattened());
                        (Some(color(values)), others)
                    }
                    (None, None) => (None, others),
                    (Some(_), None) => return Err(lacks(right, "R, G, B", left)),
                    (None, Some(_)) => return Err(lacks(left, "R, G, B", right)),
                }
            }
            _ => {
                return Err(Error::Usage(format!(
                    "{} and {} are a PNG and an EXR file, and the tone curve between them is \
                     not known: compare two files of one kind",
                    left.name, right.name
                )));
            }
        };
        Ok(Self {
            left: left.name.clone(),
            right: right.name.clone(),
            width: left.width as usize,
            height: left.height as usize,
            color,
            others,
        })
    }

    pub fn compare(&self, tolerance: &Tolerance) -> Comparison {
        let mut marks = vec![Mark::default(); self.width * self.height];
        let pairs = || self.color.iter().chain(&self.others);
        let tallies: Vec<Tally> = pairs().map(|p| p.tally(tolerance, &mut marks)).collect();

        let is_id = |pair: &Pair<'_>| matches!(pair.values, Values::Id(..));
        let floats = || pairs().zip(&tallies).filter(|(pair, _)| !is_id(pair));
        // Colour where there is any, else all floats: Sides holds it in front.
        let judged = if self.color.is_some() { 1 } else { usize::MAX };
        let sum = floats()
            .take(judged)
            .fold(Tally::default(), |sum, (_, tally)| sum.plus(*tally));
        let components: usize = floats().take(judged).map(|(pair, _)| pair.components).sum();
        let values = (components * marks.len()).max(1);
        let rmse = (sum.square_sum / values as f64).sqrt();

        let outside_pixels = marks.iter().filter(|m| m.outside).count() as u64;
        Comparison {
            left: self.left.clone(),
            right: self.right.clone(),
            pixels: marks.len() as u64,
            different_pixels: marks.iter().filter(|m| m.different).count() as u64,
            outside_pixels,
            max_abs: sum.max_abs,
            rmse,
            psnr_db: (rmse > 0.0 && rmse.is_finite()).then(|| -20.0 * rmse.log10()),
            flip: self.flip_map().map(|map| flip::mean(&map)),
            id_mismatches: pairs()
                .zip(&tallies)
                .filter(|(pair, _)| is_id(pair))
                .map(|(_, tally)| tally.different_pixels)
                .sum(),
            max_ulp: floats().map(|(_, tally)| tally.max_ulp).max().unwrap_or(0),
            pass: outside_pixels <= tolerance.different_pixels,
            tolerance: *tolerance,
            layers: pairs()
                .zip(&tallies)
                .map(|(pair, tally)| LayerDifference {
                    layer: pair.name.clone(),
                    different_pixels: tally.different_pixels,
                    max_abs: (!is_id(pair)).then_some(tally.max_abs),
                    max_ulp: (!is_id(pair)).then_some(tally.max_ulp),
                })
                .collect(),
        }
    }

    pub fn difference_picture(&self, map: DifferenceMap) -> Vec<u8> {
        let mut marks = vec![Mark::default(); self.width * self.height];
        for pair in self.color.iter().chain(&self.others) {
            pair.tally(&Tolerance::default(), &mut marks);
        }
        let errors = match map {
            DifferenceMap::Flip => self.flip_map(),
            DifferenceMap::Absolute => {
                let color = self.color.as_ref();
                color.map(|color| difference::absolute(color, marks.len()))
            }
        };
        difference::paint(&marks, errors.as_deref())
    }

    /// The FLIP error of every pixel; `None` where there is no colour.
    fn flip_map(&self) -> Option<Vec<f32>> {
        let (left, right) = self.color.as_ref()?.displayed();
        let (width, height) = (self.width, self.height);
        Some(flip::error_map(
            &left,
            &right,
            width,
            height,
            flip::PIXELS_PER_DEGREE,
        ))
    }
}

impl Pair<'_> {
    /// Both sides as a display shows them: linear, 0..=1.
    fn displayed(&self) -> (Vec<[f32; 3]>, Vec<[f32; 3]>) {
        let linear = |v: &f32| displayable(*v) as f32;
        let decoded = |c: &u16| srgb_decode(f64::from(*c) / f64::from(u16::MAX)) as f32;
        match self.values {
            Values::Float(left, right) => (triples(left, linear), triples(right, linear)),
            Values::Code { left, right, .. } => (triples(left, decoded), triples(right, decoded)),
            Values::Id(..) => (Vec::new(), Vec::new()),
        }
    }
}

fn triples<T>(values: &[T], convert: impl Fn(&T) -> f32) -> Vec<[f32; 3]> {
    let (pixels, _) = values.as_chunks::<3>();
    pixels
        .iter()
        .map(|p| [0, 1, 2].map(|i| convert(&p[i])))
        .collect()
}

fn check_sizes(left: (u32, u32), right: (u32, u32)) -> Result<()> {
    if left == right {
        return Ok(());
    }
    Err(Error::Usage(format!(
        "the left picture is {} x {} pixels and the right one {} x {}: \
         only pictures of one size can be compared",
        left.0, left.1, right.0, right.1
    )))
}

fn pair_channels<'a>(
    left: &Picture,
    left_channels: &'a [Channel],
    right: &Picture,
    right_channels: &'a [Channel],
) -> Result<Vec<Pair<'a>>> {
    let names = |channels: &'a [Channel]| channels.iter().map(|c| c.name.as_str());
    let missing = |from: &'a [Channel], in_: &'a [Channel]| {
        names(from).find(|name| !names(in_).any(|n| n == *name))
    };
    if let Some(name) = missing(left_channels, right_channels) {
        return Err(lacks(right, name, left));
    }
    if let Some(name) = missing(right_channels, left_channels) {
        return Err(lacks(left, name, right));
    }
    let pairs = left_channels.iter().zip(right_channels);
    pairs
        .map(|(l, r)| {
            let values = match (&l.samples, &r.samples) {
                (Samples::Float(l), Samples::Float(r)) => Values::Float(l, r),
                (Samples::Integer(l), Samples::Integer(r)) => Values::Id(l, r),
                _ => {
                    return Err(Error::Usage(format!(
                        "channel '{}' holds floats in one of {} and {}, integers in the other",
                        l.name, left.name, right.name
                    )));
                }
            };
            Ok(Pair {
                name: l.name.clone(),
                components: 1,
                values,
            })
        })
        .collect()
}

fn lacks(poor: &Picture, channel: &str, rich: &Picture) -> Error {
    Error::Usage(format!(
        "{} has no channel {channel}, which {} has: write both with the same layers",
        poor.name, rich.name
    ))
}

#[cfg(test)]
mod tests;
