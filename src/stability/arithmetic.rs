//! Sums, products, quotients and roots: what all else rests on.

use super::case::{Case, Family, Trial};
use super::demand::Demand::Own;
use super::subject::Subject;
use super::tally::Tally;
use crate::error::Result;
use crate::gpu::selfcheck::{Arithmetic, INPUTS};

/// Sums, products, quotients and roots.
pub const FAMILY: Family = Family {
    name: "arithmetic",
    about: "Sums, products, quotients and roots, as the device's self-check found them: what all \
            else rests on.",
    cases: &[&[
        Case {
            id: "arithmetic/error-terms",
            name: "what a sum and a product lack",
            sets_up: "TwoSum and TwoProd of 8192 pairs.",
            danger: "A compiler that reckons as with real numbers makes (a + b) - a into b, and \
                     the error term into 0.",
            demands: &[Own("the error terms are exact")],
            fails: &[],
            is_random: false,
            trial: |_, _| Ok(Box::new(Device(|device| device.two_sum && device.two_prod))),
        },
        Case {
            id: "arithmetic/contraction",
            name: "products that are not fused with a sum",
            sets_up: "a b - (a b) of 8192 pairs.",
            danger: "A fused product is not rounded: u_left - u_right of an edge function has \
                     another sign for one triangle than for its neighbour.",
            demands: &[Own("0, always")],
            fails: &[],
            is_random: false,
            trial: |_, _| Ok(Box::new(Device(|device| !device.contraction))),
        },
        Case {
            id: "arithmetic/rounding",
            name: "quotients and roots next to the middle of two numbers",
            sets_up: "8192 quotients and as many roots that lie as near as can be to where rounding \
                      turns.",
            danger: "Vulkan allows a quotient to be 2.5 ulp off: pictures then differ from the \
                     CPU's.",
            demands: &[Own(
                "they are rounded correctly, by the device or by what corrects it",
            )],
            fails: &[],
            is_random: false,
            trial: |_, _| Ok(Box::new(Device(Arithmetic::is_rounded))),
        },
    ]],
};

/// What the self-check of a device must have found.
struct Device(fn(&Arithmetic) -> bool);

impl Trial for Device {
    fn run(&self, on: &dyn Subject) -> Result<Tally> {
        let is_wrong = !(self.0)(&on.arithmetic());
        Ok(Tally {
            rays: u64::from(INPUTS),
            wrong: u64::from(is_wrong),
            worst: f64::from(u8::from(is_wrong)),
            bound: 0.0,
        })
    }
}
