//! `scale`, `rotate`, `translate` and `grid`: where a shape stands, and how
//! often.

use glam::{DMat3, DVec3};
use toml::de::DeValue;

use super::faults::Faults;
use super::section::Section;
use super::value::{Value, number, ruled, triple, vector, whole};
use crate::scene::check::{self, Flaw, Verdict};

/// Which scales a kind of shape can take.
#[derive(Clone, Copy, PartialEq, Eq)]
pub(super) enum Stretch {
    /// A factor greater than 0: spheres and disks, whose radius it scales.
    Radius,
    /// A factor that is not 0.
    Uniform,
    /// One factor, or one for each axis.
    PerAxis,
}

/// Where a shape stands: scaled, then rotated, then translated, once for each
/// cell of a grid.
#[derive(Debug, Clone, Copy)]
pub(super) struct Placement {
    pub(super) scale: DVec3,
    pub(super) rotation: DMat3,
    translate: DVec3,
    count: [u64; 3],
    step: DVec3,
}

impl Placement {
    /// Reads the four keys. A fault is in the list; the default stands in.
    pub(super) fn read(
        section: &mut Section<'_, '_>,
        stretch: Stretch,
        faults: &mut Faults<'_>,
    ) -> Self {
        let scale = section.or("scale", DVec3::ONE, faults, |value, what, faults| {
            scale(value, what, stretch, faults)
        });
        let degrees = section.or("rotate", DVec3::ZERO, faults, vector);
        let translate = section.or("translate", DVec3::ZERO, faults, vector);
        let (count, step) = section
            .value("grid")
            .and_then(|value| grid(value, faults))
            .unwrap_or(([1; 3], DVec3::ZERO));
        Self {
            scale,
            rotation: rotation(degrees),
            translate,
            count,
            step,
        }
    }

    /// How often the shape stands; saturates.
    pub(super) fn instances(&self) -> u64 {
        let [x, y, z] = self.count;
        x.saturating_mul(y).saturating_mul(z)
    }

    /// The translation of each instance, x fastest.
    pub(super) fn translations(self) -> impl Iterator<Item = DVec3> {
        let [nx, ny, nz] = self.count;
        (0..nz).flat_map(move |k| {
            (0..ny).flat_map(move |j| (0..nx).map(move |i| self.translation([i, j, k])))
        })
    }

    /// The translation of the last instance: with the first it bounds them all.
    pub(super) fn last_translation(&self) -> DVec3 {
        self.translation(self.count.map(|n| n - 1))
    }

    fn translation(&self, cell: [u64; 3]) -> DVec3 {
        self.translate + DVec3::from(cell.map(|n| n as f64)) * self.step
    }
}

fn scale(
    value: &Value<'_>,
    what: &str,
    stretch: Stretch,
    faults: &mut Faults<'_>,
) -> Option<DVec3> {
    let rule = match stretch {
        Stretch::Radius => check::size,
        Stretch::Uniform | Stretch::PerAxis => check::factor,
    };
    if !matches!(value.get_ref(), DeValue::Array(_)) {
        return ruled(number, rule)(value, what, faults).map(DVec3::splat);
    }
    if stretch != Stretch::PerAxis {
        faults.push(
            value.span(),
            "`scale` takes one number here, found an array",
            "an array",
            "only a [[mesh]] can be scaled along each axis",
        );
        return None;
    }
    triple(ruled(number, rule))(value, what, faults).map(DVec3::from)
}

fn grid(value: &Value<'_>, faults: &mut Faults<'_>) -> Option<([u64; 3], DVec3)> {
    let mut section = Section::within("grid", value, faults)?;
    let count = section.required("count", faults, triple(whole(at_least_one)));
    let step = section.required("step", faults, vector);
    section.close(faults);
    Some((count?.value, step?.value))
}

fn at_least_one(what: &str, count: u64) -> Verdict {
    if count > 0 {
        return Ok(());
    }
    Err(Flaw {
        message: format!("`{what}` must be 1 or more along each axis, but is 0"),
        label: "zero",
        help: "write 1 along an axis without repetition".into(),
    })
}

/// About x, then about y, then about z.
fn rotation(degrees: DVec3) -> DMat3 {
    let [(sx, cx), (sy, cy), (sz, cz)] = degrees.to_array().map(sin_cos);
    let x = DMat3::from_cols(DVec3::X, DVec3::new(0.0, cx, sx), DVec3::new(0.0, -sx, cx));
    let y = DMat3::from_cols(DVec3::new(cy, 0.0, -sy), DVec3::Y, DVec3::new(sy, 0.0, cy));
    let z = DMat3::from_cols(DVec3::new(cz, sz, 0.0), DVec3::new(-sz, cz, 0.0), DVec3::Z);
    z * y * x
}

/// Sine and cosine; quarter turns are exact, so that a turned box stays aligned
/// with the axes.
fn sin_cos(degrees: f64) -> (f64, f64) {
    let turn = degrees.rem_euclid(360.0);
    if turn == 90.0 {
        (1.0, 0.0)
    } else if turn == 180.0 {
        (0.0, -1.0)
    } else if turn == 270.0 {
        (-1.0, 0.0)
    } else {
        turn.to_radians().sin_cos()
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn quarter_turns_are_exact_and_right_handed() {
        assert_eq!(rotation(DVec3::new(90.0, 0.0, 0.0)) * DVec3::Y, DVec3::Z);
        assert_eq!(rotation(DVec3::new(0.0, 90.0, 0.0)) * DVec3::Z, DVec3::X);
        assert_eq!(rotation(DVec3::new(0.0, 0.0, -270.0)) * DVec3::X, DVec3::Y);
        assert_eq!(rotation(DVec3::splat(720.0)), DMat3::IDENTITY);
    }

    #[test]
    fn rotations_are_taken_about_x_then_y_then_z() {
        let all = rotation(DVec3::new(90.0, 90.0, 0.0));
        // y -> z about x, then z -> x about y.
        assert_eq!(all * DVec3::Y, DVec3::X);
        let angles = DVec3::new(20.0, -33.0, 131.0);
        let by_glam = DMat3::from_rotation_z(angles.z.to_radians())
            * DMat3::from_rotation_y(angles.y.to_radians())
            * DMat3::from_rotation_x(angles.x.to_radians());
        // Each entry is a sum of a few products of numbers up to 1.
        assert!(rotation(angles).abs_diff_eq(by_glam, 8.0 * f64::EPSILON));
    }

    #[test]
    fn a_grid_runs_x_fastest_and_its_last_cell_is_known() {
        let placement = Placement {
            scale: DVec3::ONE,
            rotation: DMat3::IDENTITY,
            translate: DVec3::new(10.0, 0.0, 0.0),
            count: [2, 1, 3],
            step: DVec3::new(1.0, 5.0, -2.0),
        };
        let all: Vec<_> = placement.translations().collect();
        assert_eq!(all.len() as u64, placement.instances());
        assert_eq!(all[1], DVec3::new(11.0, 0.0, 0.0));
        assert_eq!(all[2], DVec3::new(10.0, 0.0, -2.0));
        assert_eq!(*all.last().unwrap(), placement.last_translation());
    }
}
