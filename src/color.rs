//! Colour spaces, each from linear RGB of ITU-R BT.709 (sRGB without its curve)
//! and back, for the white of D65.

use std::sync::LazyLock;

use glam::{DMat3, DVec3};

/// CIE xy chromaticities of red, green, blue and white, ITU-R BT.709 item 1.
const PRIMARIES: [(f64, f64); 3] = [(0.64, 0.33), (0.30, 0.60), (0.15, 0.06)];
const WHITE: (f64, f64) = (0.3127, 0.3290);

/// CIE 15: where the cube root of L*a*b* gives way to a straight line.
const DELTA: f64 = 6.0 / 29.0;

static TO_XYZ: LazyLock<DMat3> = LazyLock::new(rgb_to_xyz);
static FROM_XYZ: LazyLock<DMat3> = LazyLock::new(|| TO_XYZ.inverse());
static WHITE_XYZ: LazyLock<DVec3> = LazyLock::new(|| xyz_of(WHITE));

/// XYZ of a chromaticity at a luminance of 1.
fn xyz_of((x, y): (f64, f64)) -> DVec3 {
    DVec3::new(x / y, 1.0, (1.0 - x - y) / y)
}

/// SMPTE RP 177: the primaries scaled so that their sum is white.
fn rgb_to_xyz() -> DMat3 {
    let [r, g, b] = PRIMARIES.map(xyz_of);
    let primaries = DMat3::from_cols(r, g, b);
    let scale = primaries.inverse() * xyz_of(WHITE);
    primaries * DMat3::from_diagonal(scale)
}

/// The space of opponent colours Y, Cx, Cz in which FLIP filters, linear in XYZ.
/// The usual offset of Y by -16 is left out, so that black is 0 and white 116:
/// filters that sum to 1 leave it as it is.
pub(crate) fn ycxcz_from_rgb(rgb: DVec3) -> DVec3 {
    let xyz = *TO_XYZ * rgb / *WHITE_XYZ;
    DVec3::new(
        116.0 * xyz.y,
        500.0 * (xyz.x - xyz.y),
        200.0 * (xyz.y - xyz.z),
    )
}

/// The inverse of [`ycxcz_from_rgb`].
pub(crate) fn rgb_from_ycxcz(ycxcz: DVec3) -> DVec3 {
    let y = ycxcz.x / 116.0;
    let xyz = DVec3::new(y + ycxcz.y / 500.0, y, y - ycxcz.z / 200.0);
    *FROM_XYZ * (xyz * *WHITE_XYZ)
}

/// CIE 1976 L*a*b*.
pub(crate) fn lab_from_rgb(rgb: DVec3) -> DVec3 {
    let f = |t: f64| {
        if t > DELTA.powi(3) {
            t.cbrt()
        } else {
            t / (3.0 * DELTA * DELTA) + 4.0 / 29.0
        }
    };
    let xyz = *TO_XYZ * rgb / *WHITE_XYZ;
    let (x, y, z) = (f(xyz.x), f(xyz.y), f(xyz.z));
    DVec3::new(116.0 * y - 16.0, 500.0 * (x - y), 200.0 * (y - z))
}

/// The inverse of [`lab_from_rgb`]; out of 0..=1 where no display shows it.
pub(crate) fn rgb_from_lab(lab: DVec3) -> DVec3 {
    let inverse = |t: f64| {
        if t > DELTA {
            t.powi(3)
        } else {
            3.0 * DELTA * DELTA * (t - 4.0 / 29.0)
        }
    };
    let y = (lab.x + 16.0) / 116.0;
    let (x, z) = (y + lab.y / 500.0, y - lab.z / 200.0);
    let xyz = DVec3::new(inverse(x), inverse(y), inverse(z)) * *WHITE_XYZ;
    *FROM_XYZ * xyz
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Published to 4 digits.
    const PUBLISHED: f64 = 0.5e-4;

    #[test]
    fn the_matrix_is_the_published_one() {
        let published = DMat3::from_cols(
            DVec3::new(0.4124, 0.2126, 0.0193),
            DVec3::new(0.3576, 0.7152, 0.1192),
            DVec3::new(0.1805, 0.0722, 0.9505),
        );
        assert!(
            TO_XYZ.abs_diff_eq(published, PUBLISHED + 1e-9),
            "{:?}",
            *TO_XYZ
        );
    }

    #[test]
    fn white_has_no_color() {
        let lab = lab_from_rgb(DVec3::ONE);
        assert!(lab.abs_diff_eq(DVec3::new(100.0, 0.0, 0.0), 1e-12), "{lab}");
        let ycxcz = ycxcz_from_rgb(DVec3::ONE);
        assert!(ycxcz.abs_diff_eq(DVec3::new(116.0, 0.0, 0.0), 1e-12));
    }

    #[test]
    fn blue_is_where_it_is_published() {
        // CIE L*a*b* of sRGB blue under D65: 32.30, 79.19, -107.86.
        let lab = lab_from_rgb(DVec3::Z);
        assert!(
            lab.abs_diff_eq(DVec3::new(32.30, 79.19, -107.86), 0.01),
            "{lab}"
        );
    }

    #[test]
    fn all_ways_lead_back() {
        // Some 20 operations on numbers of about 100.
        const TOLERANCE: f64 = 20.0 * 100.0 * f64::EPSILON;
        for i in 0..1000 {
            let rgb = DVec3::new((i % 10) as f64, (i / 10 % 10) as f64, (i / 100) as f64) / 9.0;
            for back in [
                rgb_from_lab(lab_from_rgb(rgb)),
                rgb_from_ycxcz(ycxcz_from_rgb(rgb)),
            ] {
                assert!(back.abs_diff_eq(rgb, TOLERANCE), "{rgb} {back}");
            }
        }
    }
}
