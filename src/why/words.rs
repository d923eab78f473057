//! How a tier came to its answer, and what makes the exact one, in plain sentences.

use super::seen::{Seen, View};
use super::textbook::fault;
use super::truth::Truths;
use super::{ROUNDINGS, candidates::place_of};
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
            return format!("{next} is met at the same t: of two the lower id counts");
        }
        format!("{next} comes next, {} later", number(behind))
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
            return format!("in doubt, since {doubt}; traced again in f64, {answer}");
        }
        format!("certain, since {doubt}; {answer}")
    }

    /// The first pass of the adaptive tier.
    fn doubt(&self) -> String {
        let view = &self.seen.first_pass;
        let own = self.name(view.found.id);
        if !view.in_doubt {
            return match view.found.id {
                NO_HIT => "no shape comes near the ray".into(),
                _ => format!("{own} ends its interval before any other begins"),
            };
        }
        if !(view.rival <= view.high && view.rival < f64::INFINITY) {
            let [low, high] = [view.low, view.high].map(single);
            return format!("the interval of {own} is wide, {low} to {high}");
        }
        let rival = view
            .meetings
            .iter()
            .find(|(id, meeting)| **id != view.found.id && meeting.low == view.rival);
        let (rival, may) = rival.map_or(("another shape".into(), true), |(id, meeting)| {
            (self.name(*id), meeting.high == f64::INFINITY)
        });
        let from = single(view.rival);
        let met = if may { "may be met" } else { "is met" };
        if view.found.id == NO_HIT {
            return format!("{rival} {met} from t = {from} on and nothing is met for certain");
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
                    "as exact, though for its rounded numbers it would be {}",
                    self.name(truths.first)
                );
            }
            return "as exact".into();
        }
        let mut text = self.fault(accuracy, view);
        if found != NO_HIT && !self.exact.met.contains_key(&found) {
            text += &format!(", which the exact ray misses by {}", self.roundings(found));
        }
        if truths.first == found {
            text + "; that is exact for the rounded numbers: rounding scene and ray turned it"
        } else if truths.first == exact {
            text + "; the rounded numbers would still give the right answer: it is the formulas"
        } else {
            text
        }
    }

    fn fault(&self, accuracy: Accuracy, view: &View) -> String {
        let (found, exact) = (view.found.id, self.exact.first);
        let [shown, right] = [found, exact].map(|id| self.name(id));
        if exact == NO_HIT {
            return format!("meets {shown}");
        }
        let Some(right_t) = view.t_of(exact) else {
            let by = match fault(&self.widths.textbook, self.pixel, exact) {
                Some(fault) if accuracy == Accuracy::Textbook => format!(": {fault}"),
                _ => format!(", which the exact ray meets by {}", self.roundings(exact)),
            };
            return match found {
                NO_HIT => format!("misses {right}{by}"),
                _ => format!("misses {right}{by}; shows {shown}"),
            };
        };
        if found != NO_HIT && view.found.t < right_t {
            let early = number(right_t - view.found.t);
            return format!("meets {right} too, but {shown} {early} before it");
        }
        if found != NO_HIT && view.found.t == right_t {
            return format!("meets {right} at the very t of {shown}, and the lower id counts");
        }
        // Every tier but the textbook clamps its hits to boxes.
        format!("meets {right}, but a volume around it is missed or left too early")
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

/// Three digits of a number.
fn number(value: f64) -> String {
    format!("{value:.2e}")
}

/// A few digits of a number of ordinary size.
fn brief(value: f64) -> String {
    match value {
        value if (0.01..1e4).contains(&value) => format!("{value:.2}"),
        value => number(value),
    }
}
