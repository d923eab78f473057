//! Tone curves: from linear light to the bytes of a PNG, and back for sRGB.

use crate::scene::Transfer;

/// The sRGB curve (IEC 61966-2-1), linear 0..=1 to encoded 0..=1.
pub fn srgb_encode(linear: f64) -> f64 {
    if linear <= 0.003_130_8 {
        12.92 * linear
    } else {
        1.055 * linear.powf(1.0 / 2.4) - 0.055
    }
}

/// The inverse of [`srgb_encode`].
pub fn srgb_decode(encoded: f64) -> f64 {
    if encoded <= 0.040_45 {
        encoded / 12.92
    } else {
        ((encoded + 0.055) / 1.055).powf(2.4)
    }
}

/// The byte that shows a linear value: clamped to 0..=1, NaN as 0. `Srgb` and
/// `Linear` round 255 c to the nearest, `Sqrt` takes floor(255.99 c) as the
/// 2017 report does.
pub fn to_byte(transfer: Transfer, linear: f32) -> u8 {
    let linear = displayable(linear);
    let level = match transfer {
        Transfer::Srgb => (255.0 * srgb_encode(linear)).round(),
        Transfer::Sqrt => (255.99 * linear.sqrt()).floor(),
        Transfer::Linear => (255.0 * linear).round(),
    };
    level as u8
}

/// What a display can show of a linear value: 0..=1, NaN as 0.
pub fn displayable(linear: f32) -> f64 {
    if linear.is_nan() {
        0.0
    } else {
        f64::from(linear).clamp(0.0, 1.0)
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use Transfer::{Linear, Sqrt, Srgb};

    #[test]
    fn bytes_by_hand() {
        // Linear: 127.5 rounds away from zero. Sqrt: sqrt(0.25) = 0.5, floor(127.995).
        assert_eq!(to_byte(Linear, 0.5), 128);
        assert_eq!(to_byte(Linear, 0.25), 64);
        assert_eq!(to_byte(Sqrt, 0.25), 127);
        // 0.21404114 is what sRGB shows as one half.
        assert_eq!(to_byte(Srgb, 0.214_041_14), 128);
        // The straight part: 0.002 * 12.92 * 255 = 6.589.
        assert_eq!(to_byte(Srgb, 0.002), 7);
        for transfer in [Srgb, Sqrt, Linear] {
            assert_eq!(to_byte(transfer, 0.0), 0);
            assert_eq!(to_byte(transfer, -0.0), 0);
            assert_eq!(to_byte(transfer, 1.0), 255);
        }
    }

    #[test]
    fn what_a_display_cannot_show_is_clamped() {
        for transfer in [Srgb, Sqrt, Linear] {
            assert_eq!(to_byte(transfer, f32::NAN), 0);
            assert_eq!(to_byte(transfer, -f32::NAN), 0);
            assert_eq!(to_byte(transfer, f32::INFINITY), 255);
            assert_eq!(to_byte(transfer, f32::MAX), 255);
            assert_eq!(to_byte(transfer, f32::NEG_INFINITY), 0);
        }
    }

    #[test]
    fn every_srgb_byte_survives_decoding() {
        for byte in 0..=255_u8 {
            let linear = srgb_decode(f64::from(byte) / 255.0) as f32;
            assert_eq!(to_byte(Srgb, linear), byte);
        }
    }

    #[test]
    fn curves_never_fall() {
        for transfer in [Srgb, Sqrt, Linear] {
            let bytes: Vec<u8> = (0..=100_000)
                .map(|i| to_byte(transfer, i as f32 / 100_000.0))
                .collect();
            assert!(bytes.is_sorted(), "{transfer:?}");
        }
    }
}
