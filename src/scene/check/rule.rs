//! Rules for numbers, colours and directions, each stated once: the parser puts a
//! line and a column to a [`Flaw`], `Scene::validate` an index.

use std::ops::RangeInclusive;

use glam::DVec3;

use crate::scene::Rgb;

/// Largest magnitude of a number in a scene. Squares in f32 overflow above
/// 1.8e19, which leaves four decades for sums and scales; and up to it
/// neighbouring f64 values lie at most an eighth apart, so that subtracting the
/// camera's position still leaves a meaningful difference.
pub const MAX_MAGNITUDE: f64 = 1e15;

/// Smallest radius, and smallest factor of a scale: squares in f32 underflow
/// below 1e-19, and a transform's inverse then stays below [`MAX_MAGNITUDE`].
pub const MIN_SIZE: f64 = 1.0 / MAX_MAGNITUDE;

/// Largest width or height of a picture: pixel numbers then fit 30 bits and a
/// sample position is exact in f32.
pub const MAX_IMAGE_SIDE: u64 = 32768;

/// What breaks a rule.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Flaw {
    /// What is wrong, with the value.
    pub message: String,
    /// A word under the underline.
    pub label: &'static str,
    /// What would be right.
    pub help: String,
}

/// Does a value keep a rule?
pub type Verdict = std::result::Result<(), Flaw>;

impl Flaw {
    pub(super) fn index(what: &str, index: usize, count: usize) -> Self {
        flaw(
            format!("{what} {index} does not exist"),
            "no such index",
            format!("there are {count}, counted from 0"),
        )
    }

    pub(in crate::scene) fn at(mut self, place: &str) -> Self {
        self.message = format!("{place}: {}", self.message);
        self
    }
}

pub(super) fn flaw(message: String, label: &'static str, help: impl Into<String>) -> Flaw {
    Flaw {
        message,
        label,
        help: help.into(),
    }
}

pub(super) fn require(holds: bool, flaw: impl FnOnce() -> Flaw) -> Verdict {
    if holds { Ok(()) } else { Err(flaw()) }
}

/// A finite number of a magnitude that f32 arithmetic can square.
pub fn number(what: &str, x: f64) -> Verdict {
    require(x.is_finite(), || {
        let message = format!("`{what}` must be a finite number, but is {x}");
        flaw(message, "not finite", "write a plain number such as 1.5")
    })?;
    require(x.abs() <= MAX_MAGNITUDE, || {
        flaw(
            format!("`{what}` is {x:e}, beyond {MAX_MAGNITUDE:e}"),
            "too large",
            format!("keep magnitudes up to {MAX_MAGNITUDE:e}, where f32 squares cannot overflow"),
        )
    })
}

/// A radius, or a factor that scales one: greater than 0 by [`MIN_SIZE`].
pub fn size(what: &str, x: f64) -> Verdict {
    number(what, x)?;
    require(x > 0.0, || {
        let message = format!("`{what}` must be greater than 0, but is {x}");
        flaw(message, "not positive", "write a number greater than 0")
    })?;
    not_tiny(what, x)
}

fn not_tiny(what: &str, x: f64) -> Verdict {
    require(x.abs() >= MIN_SIZE, || {
        flaw(
            format!("`{what}` is {x:e}, below {MIN_SIZE:e}"),
            "too small",
            format!("keep sizes from {MIN_SIZE:e}, where f32 squares cannot underflow"),
        )
    })
}

/// The two corners of a box: every coordinate of the one below that of the other.
pub fn corners(low: DVec3, high: DVec3) -> Verdict {
    require(low.cmplt(high).all(), || {
        let message = format!("`low` {low} must lie below `high` {high} in every coordinate");
        flaw(
            message,
            "an empty box",
            "exchange them, or give the box some depth",
        )
    })
}

/// A number that is 0 or more.
pub fn not_negative(what: &str, x: f64) -> Verdict {
    number(what, x)?;
    require(x >= 0.0, || {
        let message = format!("`{what}` must not be negative, but is {x}");
        flaw(message, "negative", "write 0 or more")
    })
}

/// A factor of a scale: of either sign, but not 0 by [`MIN_SIZE`].
pub fn factor(what: &str, x: f64) -> Verdict {
    number(what, x)?;
    require(x != 0.0, || {
        let message = format!("`{what}` must not be 0: the shape would have no size");
        flaw(message, "zero", "write 1 to keep the size")
    })?;
    not_tiny(what, x)
}

/// The width or height of a picture in pixels.
pub fn image_side(what: &str, pixels: u64) -> Verdict {
    require((1..=MAX_IMAGE_SIDE).contains(&pixels), || {
        flaw(
            format!("`{what}` must be from 1 to {MAX_IMAGE_SIDE} pixels, but is {pixels}"),
            "out of range",
            format!("pictures up to {MAX_IMAGE_SIDE} x {MAX_IMAGE_SIDE} can be rendered"),
        )
    })
}

/// A position: three numbers.
pub fn point(what: &str, p: DVec3) -> Verdict {
    p.to_array().iter().try_for_each(|&x| number(what, x))
}

/// A vector of any length but 0. A length counts as 0 whose square underflows
/// once the smallest transform has shrunk it: it cannot be normalised.
pub fn direction(what: &str, v: DVec3) -> Verdict {
    point(what, v)?;
    // A normal is multiplied by products of two columns of its transform.
    let shrunk = v * (MIN_SIZE * MIN_SIZE);
    require(shrunk.length_squared() >= f64::MIN_POSITIVE, || {
        flaw(
            format!("`{what}` is {v}, which points nowhere"),
            "zero length",
            "write a vector of any length but 0, such as [0, 1, 0]",
        )
    })
}

/// A linear colour: no part negative.
pub fn color(what: &str, rgb: Rgb) -> Verdict {
    rgb.iter().try_for_each(|&x| not_negative(what, x))
}

/// A number from 0 to 1.
pub fn fraction(what: &str, x: f64) -> Verdict {
    number(what, x)?;
    require((0.0..=1.0).contains(&x), || {
        let message = format!("`{what}` must lie between 0 and 1, but is {x}");
        flaw(message, "out of range", "write a number from 0 to 1")
    })
}

/// A whole number within a range.
pub fn whole(what: &str, n: u64, range: RangeInclusive<u64>) -> Verdict {
    require(range.contains(&n), || {
        let (least, most) = (range.start(), range.end());
        let message = format!("`{what}` must be from {least} to {most}, but is {n}");
        let help = format!("write a whole number from {least} to {most}");
        flaw(message, "out of range", help)
    })
}
