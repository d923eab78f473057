//! Logarithmic axes: where a value is drawn, and which values are written beside it.

/// More ticks than this are too close to be read.
const MOST_TICKS: i32 = 10;

/// A logarithmic scale from `from` to `to`, drawn from pixel `start` to pixel `end`.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) struct Axis {
    from: f64,
    to: f64,
    start: f64,
    end: f64,
}

impl Axis {
    /// Reaches a little beyond the values, of which all are positive.
    pub(super) fn around(values: impl Iterator<Item = f64>, start: f64, end: f64) -> Self {
        // A fifth of a decade leaves room for the labels of points at the rim.
        let margin = 0.2;
        let (least, greatest) = exponents(values);
        Self {
            from: least - margin,
            to: greatest + margin,
            start,
            end,
        }
    }

    /// Reaches from one power of ten to another, at least one decade.
    pub(super) fn decades(values: impl Iterator<Item = f64>, start: f64, end: f64) -> Self {
        let (least, greatest) = exponents(values);
        let from = least.floor();
        Self {
            from,
            to: greatest.ceil().max(from + 1.0),
            start,
            end,
        }
    }

    /// The pixel at which a positive value is drawn.
    pub(super) fn place(&self, value: f64) -> f64 {
        self.place_exponent(value.log10())
    }

    /// The pixel of a power of ten.
    pub(super) fn place_exponent(&self, exponent: f64) -> f64 {
        let share = (exponent - self.from) / (self.to - self.from);
        self.start + share * (self.end - self.start)
    }

    /// Exponents of the powers of ten on the axis, as many as can be read.
    pub(super) fn powers(&self) -> Vec<i32> {
        let (first, last) = (self.from.ceil() as i32, self.to.floor() as i32);
        let step = ((last - first) / MOST_TICKS + 1).max(1);
        // From the multiples of the step, so that 1 is among them.
        let all = (first..=last).filter(|exponent| exponent.rem_euclid(step) == 0);
        all.collect()
    }

    /// Round values on the axis, as many as can be read, with how they are written.
    pub(super) fn round_values(&self) -> Vec<(f64, String)> {
        let (exponents, factors): (Vec<i32>, &[f64]) = if self.to - self.from < 3.0 {
            let decades = self.from.floor() as i32..=self.to.ceil() as i32;
            (decades.collect(), &[1.0, 2.0, 5.0])
        } else {
            (self.powers(), &[1.0])
        };
        let all = exponents
            .into_iter()
            .flat_map(|exponent| factors.iter().map(move |f| (*f, exponent)));
        all.map(|(factor, exponent)| (factor * 10_f64.powi(exponent), exponent))
            .filter(|(value, _)| (self.from..=self.to).contains(&value.log10()))
            .map(|(value, exponent)| (value, written(value, exponent)))
            .collect()
    }
}

/// A value with one digit, at the decimal place of the exponent.
fn written(value: f64, exponent: i32) -> String {
    if (-3..=5).contains(&exponent) {
        let digits = (-exponent).max(0) as usize;
        format!("{value:.digits$}")
    } else {
        format!("{value:.0e}")
    }
}

/// The least and the greatest exponent to base 10; from 1 to 10 where there is none.
fn exponents(values: impl Iterator<Item = f64>) -> (f64, f64) {
    let nothing = (f64::INFINITY, f64::NEG_INFINITY);
    let range = values
        .map(f64::log10)
        .fold(nothing, |(least, greatest), e| {
            (least.min(e), greatest.max(e))
        });
    if range == nothing { (0.0, 1.0) } else { range }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn powers_of_ten_are_even_steps() {
        let axis = Axis::decades([3e-2, 400.0].into_iter(), 500.0, 0.0);
        assert_eq!(axis.powers(), [-2, -1, 0, 1, 2, 3]);
        let places = [0.01, 0.1, 1.0, 10.0, 100.0, 1000.0].map(|v| axis.place(v));
        for (place, even) in places
            .into_iter()
            .zip([500.0, 400.0, 300.0, 200.0, 100.0, 0.0])
        {
            assert!((place - even).abs() < 1e-9, "{place} {even}");
        }
    }

    #[test]
    fn many_powers_are_thinned_out_around_one() {
        let axis = Axis::decades([1e-9, 1e6].into_iter(), 0.0, 1.0);
        assert_eq!(axis.powers(), [-8, -6, -4, -2, 0, 2, 4, 6]);
        let wide = Axis::decades([1e-300, 1e300].into_iter(), 0.0, 1.0);
        assert!(wide.powers().len() <= MOST_TICKS as usize + 1);
        assert!(wide.powers().contains(&0));
    }

    #[test]
    fn round_values_are_written_short() {
        let texts = |values: [f64; 2]| -> Vec<String> {
            let axis = Axis::around(values.into_iter(), 0.0, 1.0);
            axis.round_values().into_iter().map(|(_, t)| t).collect()
        };
        assert_eq!(texts([21.0, 140.0]), ["20", "50", "100", "200"]);
        assert_eq!(texts([0.08, 0.9]), ["0.1", "0.2", "0.5", "1"]);
        assert_eq!(texts([1.0, 9000.0]), ["1", "10", "100", "1000", "10000"]);
        assert_eq!(texts([1.5e-7, 4e-7]), ["1e-7", "2e-7", "5e-7"]);
    }

    #[test]
    fn no_value_and_one_value_have_an_axis_too() {
        assert_eq!(Axis::decades([].into_iter(), 0.0, 1.0).powers(), [0, 1]);
        let one = Axis::around([7.0].into_iter(), 0.0, 100.0);
        assert!((one.place(7.0) - 50.0).abs() < 1e-9);
        assert_eq!(Axis::decades([1.0].into_iter(), 0.0, 1.0).powers(), [0, 1]);
    }
}
