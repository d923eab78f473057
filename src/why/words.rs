//! How a tier came to its answer, and what makes the exact one, in plain sentences.

use super::ROUNDINGS;
use super::candidates::{place_of, ulps};
use super::seen::{Seen, View};
use super::textbook::fault;
use super::truth::Truths;
use crate::accuracy::Widths;
use crate::flat::Flat;
use crate::kernel::camera::Ray;
use crate::layout::NO_HIT;
use crate::oracle::{Oracle, ShapeKind};
use crate::tier::Accuracy;

/// All that was found out about a ray.
pub(super) struct Story<'a> {
    pub(super) widths: &'a Widths,
    pub(super) pixel: [u32; 2],
    /// In f64.
    pub(super) ray: Ray<f64>,
    pub(super) seen: &'a Seen,
    /// For the numbers of f32.
    pub(super) single: &'a Truths,
    /// For those of two f32.
    pub(super) extended: &'a Truths,
    /// For those of f64.
    pub(super) exact: &'a Truths,
}

impl Story<'_> {
    /// What decides a tier's answer: a view, and what is exact for the numbers it has.
    pub(super) fn decides(&self, accuracy: Accuracy) -> (&View, &Truths) {
        let seen = self.seen;
        match accuracy {
            Accuracy::Textbook => (&seen.textbook, self.single),
            Accuracy::Robust => (&seen.robust, self.single),
            Accuracy::Extended => (&seen.extended, self.extended),
            Accuracy::Double => (&seen.double, self.exact),
            Accuracy::Adaptive if seen.first_pass.in_doubt => (&seen.double, self.exact),
            Accuracy::Adaptive => (&seen.first_pass, self.single),
        }
    }

    /// What makes the exact answer.
    pub(super) fn of_truth(&self) -> String {
        let [first, next] = [0, 1].map(|place| self.exact.order.get(place));
        let Some(first) = first else {
            return "the ray meets nothing".into();
        };
        let Some(next) = next else {
            return "nothing else is met".into();
        };
        let [t, other] = [first, next].map(|id| self.exact.met[id]);
        let behind = (other.t - t.t) + (other.t_rest - t.t_rest);
        let next = self.name(*next);
        if behind == 0.0 {
            return format!("{next} is met at the same t, and the lower id counts");
        }
        format!("{next} comes next, at a t larger by {}", brief(behind))
    }

    /// How a tier came to its answer.
    pub(super) fn of_tier(&self, accuracy: Accuracy) -> String {
        let (view, truths) = self.decides(accuracy);
        let answer = self.answer(accuracy, view, truths);
        if accuracy != Accuracy::Adaptive {
            return answer;
        }
        let doubt = self.doubt();
        if self.seen.first_pass.in_doubt {
            return format!("in doubt, since {doubt}; traced again in f64: {answer}");
        }
        format!("{answer}; certain, since {doubt}")
    }

    /// The first pass of the adaptive tier.
    fn doubt(&self) -> String {
        let view = &self.seen.first_pass;
        let own = self.name(view.found.id);
        if !view.in_doubt {
            return match view.found.id {
                NO_HIT => "the ray comes near no shape".into(),
                _ => format!("the interval of {own} ends before any other begins"),
            };
        }
        if !(view.rival <= view.high && view.rival < f64::INFINITY) {
            let [low, high] = [view.low, view.high].map(single);
            return format!("the interval of {own} is wide, {low} to {high}");
        }
        // Of several that begin there, the one that decides, if it is among them.
        let others = view
            .meetings
            .iter()
            .filter(|(id, meeting)| **id != view.found.id && meeting.low == view.rival);
        let rival = others.min_by_key(|(id, _)| (**id != self.exact.first, **id));
        let (rival, may) = rival.map_or(("another shape".into(), true), |(id, meeting)| {
            (self.name(*id), meeting.high == f64::INFINITY)
        });
        let from = single(view.rival);
        let met = if may { "may be met" } else { "is met" };
        if view.found.id == NO_HIT {
            return format!("{rival} {met} from t = {from} on, and nothing is met for certain");
        }
        let high = single(view.high);
        format!("{rival} {met} from t = {from} on, before the interval of {own} ends at {high}")
    }

    /// Whether the answer is right and, if not, which shape made it wrong, and how.
    fn answer(&self, accuracy: Accuracy, view: &View, truths: &Truths) -> String {
        let (found, exact) = (view.found.id, self.exact.first);
        if found == exact {
            if truths.first != exact {
                return format!(
                    "right, though scene and ray as rounded, taken as exact, give {}",
                    self.name(truths.first)
                );
            }
            return "right".into();
        }
        let text = self.fault(accuracy, view);
        if truths.first == found {
            text + "; scene and ray as rounded, taken as exact, give that too: the rounding \
                    is enough to turn it"
        } else if truths.first == exact {
            text + "; scene and ray as rounded, taken as exact, give the right answer: the fault is in \
                    the formulas"
        } else {
            text
        }
    }

    fn fault(&self, accuracy: Accuracy, view: &View) -> String {
        let (found, exact) = (view.found.id, self.exact.first);
        let [shown, right] = [found, exact].map(|id| self.name(id));
        let known = |id| match accuracy {
            Accuracy::Textbook => fault(&self.widths.textbook, self.pixel, id),
            _ => None,
        };
        let because = |id| known(id).map_or(String::new(), |fault| format!(": {fault}"));
        if exact == NO_HIT {
            return format!("meets {shown}{}{}", self.missed(found), because(found));
        }
        let Some(right_t) = view.t_of(exact) else {
            let instead = match found {
                NO_HIT => String::new(),
                _ => format!("; it meets {shown} instead{}", self.missed(found)),
            };
            let by = self.roundings(exact);
            return format!(
                "misses {right}, which the exact ray meets by {by}{}{instead}",
                because(exact)
            );
        };
        if found != NO_HIT && view.found.t <= right_t {
            let [off, own] = [found, exact].map(|id| self.error(view, id));
            let early = match right_t - view.found.t {
                0.0 => "at the same t as".into(),
                early => format!("{} behind", brief(early)),
            };
            let missed = self.missed(found);
            if own > off {
                let own = brief(own);
                return format!("meets {right}, {own} ulp off, but {early} {shown}{missed}");
            }
            let whose = match off {
                0.0 => String::new(),
                off => format!(", whose t is off by {} ulp", brief(off)),
            };
            return format!("meets {right} too, but {early} {shown}{whose}{missed}");
        }
        // Every tier but the textbook clamps its hits to boxes.
        format!("meets {right}, but misses a volume around it, or has it end too early")
    }

    /// That the exact ray misses a shape, if it does.
    fn missed(&self, id: u32) -> String {
        if self.exact.met.contains_key(&id) {
            return String::new();
        }
        format!(", which the exact ray misses by {}", self.roundings(id))
    }

    /// By how many ulp of f32 the t of a shape is off; 0 where it is truly missed.
    fn error(&self, view: &View, id: u32) -> f64 {
        let exact = self.exact.met.get(&id);
        let errors = view.t_of(id).zip(exact).map(|(t, exact)| ulps(t, exact));
        errors.unwrap_or(0.0)
    }

    /// How far the exact ray is from the edge at which it would no longer meet, or miss, a
    /// shape.
    fn roundings(&self, id: u32) -> String {
        let flat = &self.widths.double;
        let (kind, row) = place_of(flat, id);
        let nearness = Oracle::new(flat).shape(kind, row).1.nearness(self.ray);
        let margin = (nearness.slack * ROUNDINGS).abs();
        format!("{} roundings of f32", brief(margin))
    }

    fn name(&self, id: u32) -> String {
        name(&self.widths.double, id)
    }
}

/// What a primitive is called: its kind and its id.
fn name<R>(flat: &Flat<R>, id: u32) -> String {
    if id == NO_HIT {
        return "nothing".into();
    }
    let kind = match place_of(flat, id).0 {
        ShapeKind::Sphere => "sphere",
        ShapeKind::Plane => "plane",
        ShapeKind::Disk => "disk",
        ShapeKind::Triangle => "triangle",
    };
    format!("{kind} {id}")
}

/// A number of f32, as short as it can be.
fn single(value: f64) -> String {
    let value = value as f32;
    match value.abs() {
        size if size != 0.0 && !(1e-4..1e7).contains(&size) => format!("{value:e}"),
        _ => value.to_string(),
    }
}

/// A few digits.
pub(super) fn brief(value: f64) -> String {
    match value.abs() {
        0.0 => "0".into(),
        size if (0.01..1e4).contains(&size) => format!("{value:.2}"),
        _ => format!("{value:.1e}"),
    }
}
