//! A layer as bytes to look at: colour through the tone curve, everything else
//! in false colours.

use rayon::prelude::*;

use super::{Frame, Layer, NO_HIT, transfer};
use crate::scene::Transfer;

/// The grey of the farthest hit: dark, yet apart from the black of no hit.
const FARTHEST: f64 = 0.1;

const BLACK: [u8; 3] = [0; 3];

impl Frame {
    /// One layer as RGB bytes, three a pixel, row by row from the top left.
    ///
    /// Only colour goes through `transfer`. Depth runs from white (nearest) to
    /// dark grey (farthest) by its reciprocal, so that a floor up to the horizon
    /// leaves contrast to what is near. A normal n shows as (n + 1) / 2, a
    /// coordinate x of a position as (x / (|x| + m) + 1) / 2, where m is the
    /// frame's median depth, and each of the first 2^21 ids has a colour of its
    /// own. What is not hit is black.
    pub fn to_rgb8(&self, layer: Layer, transfer: Transfer) -> Vec<u8> {
        match layer {
            Layer::Color => bytes(
                self.color
                    .par_iter()
                    .map(|c| c.map(|v| transfer::to_byte(transfer, v))),
            ),
            Layer::Depth => {
                let hits = self.depth.iter().filter(|depth| depth.is_finite());
                let scale = Scale::of(hits.map(|depth| 1.0 / depth));
                bytes(self.depth.par_iter().map(|&depth| {
                    if !depth.is_finite() {
                        return BLACK;
                    }
                    let near = scale.place(1.0 / depth, 1.0);
                    [level(FARTHEST + (1.0 - FARTHEST) * near); 3]
                }))
            }
            Layer::Normal => bytes(self.normal.par_iter().map(|normal| {
                if *normal == [0.0; 3] {
                    return BLACK;
                }
                normal.map(|n| level(f64::from(n) * 0.5 + 0.5))
            })),
            Layer::Position => self.position_bytes(),
            Layer::Id => bytes(self.id.par_iter().map(|&id| id_color(id))),
        }
    }

    fn position_bytes(&self) -> Vec<u8> {
        let middle = self.median_depth();
        let pixels = self.position.par_iter().zip(&self.id);
        bytes(pixels.map(|(position, &id)| {
            if id == NO_HIT {
                return BLACK;
            }
            position.map(|x| {
                let x = f64::from(x);
                level(x / (x.abs() + middle) * 0.5 + 0.5)
            })
        }))
    }

    /// The median of the finite depths; 1 where there is none.
    fn median_depth(&self) -> f64 {
        let mut depths: Vec<f32> = self
            .depth
            .iter()
            .copied()
            .filter(|d| d.is_finite())
            .collect();
        if depths.is_empty() {
            return 1.0;
        }
        let middle = depths.len() / 2;
        f64::from(*depths.select_nth_unstable_by(middle, f32::total_cmp).1)
    }
}

/// The range of a layer's finite values.
struct Scale {
    least: f64,
    greatest: f64,
}

impl Scale {
    fn of(values: impl Iterator<Item = f32>) -> Self {
        let nothing = Self {
            least: f64::INFINITY,
            greatest: f64::NEG_INFINITY,
        };
        values
            .filter(|v| v.is_finite())
            .map(f64::from)
            .fold(nothing, |s, v| Self {
                least: s.least.min(v),
                greatest: s.greatest.max(v),
            })
    }

    /// Where a value lies, 0 at the least and 1 at the greatest; `flat` where
    /// the range has no extent.
    fn place(&self, value: f32, flat: f64) -> f64 {
        let extent = self.greatest - self.least;
        if extent > 0.0 {
            (f64::from(value) - self.least) / extent
        } else {
            flat
        }
    }
}

fn bytes(colors: impl IndexedParallelIterator<Item = [u8; 3]>) -> Vec<u8> {
    colors.collect::<Vec<_>>().into_flattened()
}

/// 0..=1 to a byte; NaN becomes 0, as `as` defines it.
fn level(value: f64) -> u8 {
    (255.0 * value).round() as u8
}

/// A bright colour: 7 bits of a scrambled id for each channel, from 64 to 254.
/// Each step of the scrambling can be undone in 21 bits, so the first 2^21 ids
/// have different colours.
fn id_color(id: u32) -> [u8; 3] {
    if id == NO_HIT {
        return BLACK;
    }
    const BITS: u32 = 21;
    const MASK: u32 = (1 << BITS) - 1;
    // Odd numbers have an inverse modulo a power of two; these are digits of
    // the golden ratio and of pi. The offset keeps id 0 from being grey.
    let mut h = id.wrapping_add(1) & MASK;
    h = h.wrapping_mul(0x9E37_79B1) & MASK;
    h ^= h >> 11;
    h = h.wrapping_mul(0x243F_6A89) & MASK;
    h ^= h >> 9;
    [h >> 14, h >> 7, h].map(|bits| {
        let seven = bits & 0x7F;
        (64 + seven * 3 / 2) as u8
    })
}

#[cfg(test)]
mod tests {
    use super::*;
    use std::collections::HashSet;

    fn frame() -> Frame {
        let mut frame = Frame::new(4, 1).unwrap();
        for (i, depth) in [2.0, 3.0, 4.0].into_iter().enumerate() {
            frame.depth[i] = depth;
            frame.id[i] = i as u32;
            frame.color[i] = [0.25, 2.0, f32::NAN];
        }
        frame.normal[0] = [0.0, 0.0, 1.0];
        frame.normal[1] = [-1.0, 0.0, 0.0];
        frame.position[0] = [-1.0, 5.0, 0.0];
        frame.position[1] = [0.0, 5.0, 0.0];
        frame.position[2] = [1.0, 5.0, -8.0];
        frame
    }

    fn pixel(bytes: &[u8], i: usize) -> [u8; 3] {
        [bytes[3 * i], bytes[3 * i + 1], bytes[3 * i + 2]]
    }

    #[test]
    fn color_goes_through_the_curve() {
        let bytes = frame().to_rgb8(Layer::Color, Transfer::Sqrt);
        assert_eq!(bytes.len(), 12);
        assert_eq!(pixel(&bytes, 0), [127, 255, 0]);
        assert_eq!(pixel(&bytes, 3), BLACK);
    }

    #[test]
    fn near_is_white_and_nothing_is_black() {
        let bytes = frame().to_rgb8(Layer::Depth, Transfer::Srgb);
        assert_eq!(pixel(&bytes, 0), [255; 3]);
        assert_eq!(pixel(&bytes, 1), [102; 3]); // 255 * (0.1 + 0.9 / 3)
        assert_eq!(pixel(&bytes, 2), [26; 3]); // 25.5 rounds up
        assert_eq!(pixel(&bytes, 3), BLACK);
    }

    #[test]
    fn one_depth_is_white() {
        let mut frame = Frame::new(1, 1).unwrap();
        frame.depth[0] = 7.0;
        assert_eq!(frame.to_rgb8(Layer::Depth, Transfer::Srgb), [255; 3]);
    }

    #[test]
    fn normals_and_positions() {
        let normals = frame().to_rgb8(Layer::Normal, Transfer::Srgb);
        assert_eq!(pixel(&normals, 0), [128, 128, 255]);
        assert_eq!(pixel(&normals, 1), [0, 128, 128]);
        assert_eq!(pixel(&normals, 3), BLACK);
        let positions = frame().to_rgb8(Layer::Position, Transfer::Srgb);
        // The median depth is 3.
        assert_eq!(pixel(&positions, 0), [96, 207, 128]);
        assert_eq!(pixel(&positions, 1), [128, 207, 128]);
        assert_eq!(pixel(&positions, 2), [159, 207, 35]);
        assert_eq!(pixel(&positions, 3), BLACK);
    }

    #[test]
    fn hostile_layers_are_drawn_all_the_same() {
        let mut frame = frame();
        frame.depth = vec![f32::NAN, f32::MAX, -f32::MAX, f32::NEG_INFINITY];
        frame.normal = vec![[f32::NAN; 3]; 4];
        frame.position = vec![[f32::INFINITY, f32::MAX, f32::NAN]; 4];
        for layer in Layer::ALL {
            assert_eq!(frame.to_rgb8(layer, Transfer::Srgb).len(), 12);
        }
    }

    #[test]
    fn ids_have_colors_of_their_own() {
        assert_eq!(id_color(NO_HIT), BLACK);
        let colors: HashSet<[u8; 3]> = (0..1 << 21).map(id_color).collect();
        assert_eq!(colors.len(), 1 << 21);
        assert!(!colors.contains(&BLACK));
    }
}
