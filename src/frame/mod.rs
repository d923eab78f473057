//! The picture that a render gives: linear colour and the hit layers.

pub(crate) mod exr;
mod false_color;
mod layer;
mod memory;
mod output;
mod picture;
mod png;
pub mod transfer;
mod verdict;

pub use layer::Layer;
pub use output::{check_writable, while_nothing_is_written, write_atomically};
pub use picture::{Channel, Picture, PictureValues, Samples, read_image};
pub use png::write_rgb8;
pub use verdict::{Verdict, ulp_colors, wrong_colors};

use crate::kernel::hit::GIVEN_UP;
pub use crate::layout::NO_HIT;
use crate::layout::Pixel;
use crate::{Error, Result};

/// PNG stores a side in 31 bits, EXR in a signed 32-bit number.
const MAX_SIDE: u32 = i32::MAX as u32;

/// Colour, depth, normal, position and id of one pixel.
const BYTES_PER_PIXEL: u64 = 12 + 4 + 12 + 12 + 4;

/// Bytes a pixel that writing a PNG takes beside the frame: the three codes, and
/// the packed file twice, both of them no smaller for noise.
pub const PNG_PACKING: u64 = 3 + 3 + 3;

/// Bytes a pixel that writing an EXR of all layers takes beside the frame: the
/// channels, and the file, no smaller for noise.
pub const EXR_PACKING: u64 = 2 * BYTES_PER_PIXEL;

/// A rendered picture: each layer holds `width * height` values, row by row
/// from the top left.
#[derive(Debug, Clone, PartialEq)]
pub struct Frame {
    /// Pixels from left to right.
    pub width: u32,
    /// Pixels from top to bottom.
    pub height: u32,
    /// Linear light, RGB, unclamped.
    pub color: Vec<[f32; 3]>,
    /// Distance along the ray in world units (t * |d|); +infinity where nothing
    /// is hit.
    pub depth: Vec<f32>,
    /// Unit normal in world space, facing the viewer; zero where nothing is hit.
    pub normal: Vec<[f32; 3]>,
    /// Hit point minus camera position; zero where nothing is hit.
    pub position: Vec<[f32; 3]>,
    /// Primitive id; [`NO_HIT`] where nothing is hit.
    pub id: Vec<u32>,
}

impl Frame {
    /// A black frame in which nothing is hit.
    ///
    /// # Errors
    /// [`Error::Usage`] for a side of 0, [`Error::Limit`] where a side is over
    /// 2^31 - 1 or the memory does not suffice.
    pub fn new(width: u32, height: u32) -> Result<Self> {
        if width == 0 || height == 0 {
            return Err(Error::Usage(format!(
                "the picture is {width} x {height} pixels: each side takes at least 1"
            )));
        }
        if width > MAX_SIDE || height > MAX_SIDE {
            return Err(Error::Limit(format!(
                "the picture is {width} x {height} pixels: \
                 PNG and EXR hold at most {MAX_SIDE} a side"
            )));
        }
        let pixels = memory::reserve_pixels(width, height, BYTES_PER_PIXEL)?;
        Ok(Self {
            width,
            height,
            color: memory::filled(pixels, [0.0; 3])?,
            depth: memory::filled(pixels, f32::INFINITY)?,
            normal: memory::filled(pixels, [0.0; 3])?,
            position: memory::filled(pixels, [0.0; 3])?,
            id: memory::filled(pixels, NO_HIT)?,
        })
    }

    /// Whether the memory suffices for a frame of this size and for writing it to
    /// a file that takes `packing` bytes a pixel on the way: [`PNG_PACKING`] or
    /// [`EXR_PACKING`]. Asked before a long render.
    ///
    /// # Errors
    /// [`Error::Limit`] with the bytes needed and the bytes there are.
    pub fn check_memory(width: u32, height: u32, packing: u64) -> Result<()> {
        memory::reserve_pixels(width, height, BYTES_PER_PIXEL + packing).map(drop)
    }

    /// Sorts whole rows of traced pixels into the layers, from row `first_row` on;
    /// `false` if any of their rays was given up on its way through a tree.
    #[must_use]
    pub fn keep_rows(&mut self, first_row: u32, pixels: &[Pixel]) -> bool {
        let start = first_row as usize * self.width as usize;
        for (index, pixel) in (start..).zip(pixels) {
            self.color[index] = pixel.color;
            self.depth[index] = if pixel.id == NO_HIT {
                f32::INFINITY
            } else {
                pixel.depth
            };
            self.normal[index] = pixel.normal;
            self.position[index] = pixel.position;
            self.id[index] = pixel.id;
        }
        pixels.iter().all(|pixel| pixel.tests != GIVEN_UP)
    }

    /// Whether every bit of every layer is the same.
    pub fn has_bits_of(&self, other: &Frame) -> bool {
        fn same<T: bytemuck::NoUninit>(left: &[T], right: &[T]) -> bool {
            bytemuck::cast_slice::<T, u8>(left) == bytemuck::cast_slice::<T, u8>(right)
        }
        (self.width, self.height) == (other.width, other.height)
            && same(&self.color, &other.color)
            && same(&self.depth, &other.depth)
            && same(&self.normal, &other.normal)
            && same(&self.position, &other.position)
            && same(&self.id, &other.id)
    }

    /// How many pixels the frame has.
    pub fn pixels(&self) -> usize {
        self.width as usize * self.height as usize
    }

    /// How many pixels have a colour with a channel that is NaN or infinite; a
    /// PNG shows NaN as 0.
    pub fn non_finite_pixels(&self) -> u64 {
        let finite = |c: &[f32; 3]| c.iter().all(|v| v.is_finite());
        self.color.iter().filter(|c| !finite(c)).count() as u64
    }

    /// The fields are public, so their lengths are checked before they are
    /// compared or written.
    pub(crate) fn check_lengths(&self) -> Result<()> {
        let lengths = [
            (Layer::Color, self.color.len()),
            (Layer::Depth, self.depth.len()),
            (Layer::Normal, self.normal.len()),
            (Layer::Position, self.position.len()),
            (Layer::Id, self.id.len()),
        ];
        match lengths.iter().find(|(_, n)| *n != self.pixels()) {
            None => Ok(()),
            Some((layer, length)) => Err(Error::Usage(format!(
                "the frame is {} x {}, which takes {} values a layer, but its {layer} layer \
                 holds {length}",
                self.width,
                self.height,
                self.pixels()
            ))),
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_new_frame_hits_nothing() {
        let frame = Frame::new(3, 2).unwrap();
        assert_eq!(frame.pixels(), 6);
        assert_eq!(frame.color, vec![[0.0; 3]; 6]);
        assert_eq!(frame.depth, vec![f32::INFINITY; 6]);
        assert_eq!(frame.normal, vec![[0.0; 3]; 6]);
        assert_eq!(frame.position, vec![[0.0; 3]; 6]);
        assert_eq!(frame.id, vec![NO_HIT; 6]);
        frame.check_lengths().unwrap();
    }

    #[test]
    fn impossible_sizes_are_refused_by_name() {
        for (w, h) in [(0, 1), (1, 0), (0, 0)] {
            let error = Frame::new(w, h).unwrap_err();
            assert!(matches!(error, Error::Usage(_)), "{error}");
            assert!(error.to_string().contains(&format!("{w} x {h}")), "{error}");
        }
        for (w, h) in [
            (u32::MAX, u32::MAX),
            (u32::MAX, 1),
            (1, u32::MAX),
            (MAX_SIDE, MAX_SIDE),
        ] {
            let error = Frame::new(w, h).unwrap_err();
            assert!(matches!(error, Error::Limit(_)), "{error}");
            assert!(error.to_string().contains(&format!("{w} x {h}")), "{error}");
        }
    }

    #[test]
    fn non_finite_pixels_are_counted_once_each() {
        let mut frame = Frame::new(2, 2).unwrap();
        assert_eq!(frame.non_finite_pixels(), 0);
        frame.color[0] = [f32::NAN, f32::NAN, 0.0];
        frame.color[3] = [0.0, 0.0, f32::NEG_INFINITY];
        assert_eq!(frame.non_finite_pixels(), 2);
    }

    #[test]
    fn one_bit_of_any_layer_makes_a_difference() {
        let frame = Frame::new(2, 2).unwrap();
        assert!(frame.has_bits_of(&frame.clone()));
        let changes: [fn(&mut Frame); 5] = [
            |frame| frame.color[3][2] = -0.0,
            |frame| frame.depth[0] = f32::MAX,
            |frame| frame.normal[1][0] = f32::from_bits(1),
            |frame| frame.position[2][1] = f32::NAN,
            |frame| frame.id[3] = 0,
        ];
        for change in changes {
            let mut other = frame.clone();
            change(&mut other);
            assert!(!frame.has_bits_of(&other), "{other:?}");
        }
        let not_numbers = Frame {
            depth: vec![f32::NAN; 4],
            ..frame.clone()
        };
        assert!(not_numbers.has_bits_of(&not_numbers));
        assert!(!Frame::new(4, 1).unwrap().has_bits_of(&frame));
    }

    #[test]
    fn a_layer_of_the_wrong_length_is_named() {
        let mut frame = Frame::new(2, 2).unwrap();
        frame.normal.pop();
        let message = frame.check_lengths().unwrap_err().to_string();
        assert!(message.contains("normal layer holds 3"), "{message}");
    }
}
