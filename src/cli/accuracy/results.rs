//! What `rayproof accuracy` found, as JSON, as a table and as a plot.

use serde::Serialize;

use crate::cli::report::{columns, table};
use rayproof::accuracy::Errors;
use rayproof::render::{Accuracy, Backend};
use rayproof::report::{Curve, Plot, Point, mark_dominated};

/// The result of one call.
#[derive(Debug, Serialize)]
pub(super) struct Results {
    pub(super) scene: String,
    pub(super) width: u32,
    pub(super) height: u32,
    pub(super) adapter: Option<String>,
    pub(super) clock: &'static str,
    pub(super) warmup: u32,
    pub(super) budget_s: f64,
    pub(super) hazard: Option<&'static str>,
    /// Without a hazard.
    #[serde(skip_serializing_if = "Vec::is_empty")]
    pub(super) tiers: Vec<Row>,
    /// With one.
    #[serde(skip_serializing_if = "Vec::is_empty")]
    pub(super) levels: Vec<LevelRows>,
}

/// A step of a hazard.
#[derive(Debug, Serialize)]
pub(super) struct LevelRows {
    pub(super) level: f64,
    /// Why the scene cannot be made so hard, if it cannot.
    pub(super) reason: Option<String>,
    pub(super) tiers: Vec<Row>,
}

/// One tier on one backend.
#[derive(Debug, Serialize)]
pub(super) struct Row {
    pub(super) tier: Accuracy,
    pub(super) backend: &'static str,
    pub(super) available: bool,
    pub(super) reason: Option<String>,
    pub(super) runs: usize,
    pub(super) from_warm_up: bool,
    pub(super) median_ms: Option<f64>,
    pub(super) min_ms: Option<f64>,
    pub(super) max_ms: Option<f64>,
    pub(super) mrays_per_s: Option<f64>,
    /// Time over that of the textbook's tier on the same backend.
    pub(super) cost: Option<f64>,
    /// By the device's clock: all passes of a picture, without reading it back.
    pub(super) device_ms: Option<f64>,
    /// The same over that of the textbook's tier.
    pub(super) device_cost: Option<f64>,
    /// Rays that were traced a second time.
    pub(super) retraced: Option<u64>,
    /// Of the intersections: the same rays and shapes in f32, against the exact answer.
    #[serde(flatten)]
    pub(super) errors: Option<Errors>,
    /// In total: of the picture in depth, against the exact scene and rays.
    pub(super) total: Option<Errors>,
    pub(super) rmse: Option<f64>,
    pub(super) flip: Option<f64>,
}

/// The ulp of a number of 24 bits that the number itself is, at most: all of it is wrong.
const WHOLE: f64 = 16_777_216.0;

const HEAD: [&str; 17] = [
    "backend",
    "tier",
    "median ms",
    "min",
    "max",
    "cost",
    "device ms",
    "cost",
    "twice",
    "wrong",
    "past band",
    "ulp 50 %",
    "99 %",
    "worst",
    "all wrong",
    "99 %",
    "flip",
];

impl Row {
    /// A tier, not yet measured.
    pub(super) fn of(backend: &Backend, tier: Accuracy) -> Self {
        Self {
            tier,
            backend: backend.name(),
            available: true,
            reason: None,
            runs: 0,
            from_warm_up: false,
            median_ms: None,
            min_ms: None,
            max_ms: None,
            mrays_per_s: None,
            cost: None,
            device_ms: None,
            device_cost: None,
            retraced: None,
            errors: None,
            total: None,
            rmse: None,
            flip: None,
        }
    }

    /// A tier that the backend does not have.
    pub(super) fn unavailable(backend: &Backend, tier: Accuracy, reason: String) -> Self {
        Self {
            available: false,
            reason: Some(reason),
            ..Self::of(backend, tier)
        }
    }

    fn cells(&self) -> [String; 17] {
        let two = |number: Option<f64>| number.map_or("-".into(), |n| format!("{n:.2}"));
        let count = |number: Option<u64>| number.map_or("-".into(), |n| n.to_string());
        let ulp = |number: Option<f64>| number.map_or("-".into(), short);
        let (errors, total) = (&self.errors, &self.total);
        [
            self.backend.into(),
            self.tier.name().into(),
            two(self.median_ms),
            two(self.min_ms),
            two(self.max_ms),
            two(self.cost),
            two(self.device_ms),
            two(self.device_cost),
            count(self.retraced),
            count(errors.map(|errors| errors.misclassified)),
            count(errors.map(|errors| errors.outside_band)),
            ulp(errors.map(|errors| errors.ulp_p50)),
            ulp(errors.map(|errors| errors.ulp_p99)),
            ulp(errors.map(|errors| errors.ulp_max)),
            count(total.map(|total| total.misclassified)),
            ulp(total.map(|total| total.ulp_p99)),
            self.flip.map_or("-".into(), |flip| format!("{flip:.4}")),
        ]
    }
}

/// A number in a few characters, whatever its size.
fn short(number: f64) -> String {
    if number == 0.0 {
        "0".into()
    } else if (0.01..1e5).contains(&number) {
        format!("{number:.2}")
    } else {
        format!("{number:.0e}")
    }
}

impl Results {
    /// For people.
    pub(super) fn text(&self, runs: u32) -> String {
        let Self {
            scene,
            width,
            height,
            warmup,
            ..
        } = self;
        let mut rows = vec![("scene", format!("{scene}, {width} x {height}"))];
        rows.extend(self.adapter.clone().map(|adapter| ("adapter", adapter)));
        rows.push((
            "measured",
            format!("wall time of a picture; {warmup} + {runs} runs, interleaved"),
        ));
        let mut text = table(&rows) + "\n";
        if self.levels.is_empty() {
            text += &columns(HEAD, self.tiers.iter().map(Row::cells));
        }
        for level in &self.levels {
            text += &format!(
                "{} {}\n",
                self.hazard.unwrap_or(""),
                short_level(level.level)
            );
            match &level.reason {
                Some(reason) => text += &format!("  not possible: {reason}\n"),
                None => text += &columns(HEAD, level.tiers.iter().map(Row::cells)),
            }
            text += "\n";
        }
        if self.levels.is_empty() {
            text += "\n";
        }
        text += "wrong, ulp: the same rays and shapes in f32, against the exact answer; \
                 all wrong, 99 %: the whole picture\n";
        if self.adapter.is_some() {
            text += "device ms: by the device's clock, search and colouring in passes apart\n";
        }
        let levels = self.levels.iter().flat_map(|level| &level.tiers);
        let mut reasons: Vec<&String> = Vec::new();
        for reason in self
            .tiers
            .iter()
            .chain(levels)
            .filter_map(|row| row.reason.as_ref())
        {
            if !reasons.contains(&reason) {
                reasons.push(reason);
            }
        }
        for reason in reasons {
            text += &format!("{reason}\n");
        }
        text
    }

    /// The error of 99 of 100 rays: that of t or, where more are wrong, t itself.
    fn plotted_error(&self, errors: &Errors) -> f64 {
        let rays = f64::from(self.width) * f64::from(self.height);
        if errors.misclassified as f64 > 0.01 * rays {
            WHOLE
        } else {
            errors.ulp_p99
        }
    }

    /// Error against time: a curve for each step of the hazard on the last backend, or one
    /// for each backend.
    pub(super) fn plot(&self) -> Plot {
        let curve = |name: String, rows: &mut dyn Iterator<Item = &Row>| {
            let mut points: Vec<Point> = rows
                .filter_map(|row| {
                    Some(Point {
                        label: row.tier.name().into(),
                        x: row.median_ms?,
                        y: self.plotted_error(&row.errors?),
                        dominated: false,
                    })
                })
                .collect();
            mark_dominated(&mut points);
            Curve { name, points }
        };
        let all = self.tiers.iter();
        let rows = || {
            all.clone()
                .chain(self.levels.iter().flat_map(|level| &level.tiers))
        };
        let last = rows().map(|row| row.backend).max().unwrap_or("cpu");
        let curves = match self.hazard {
            Some(hazard) => {
                let levels = self.levels.iter().filter(|level| level.reason.is_none());
                levels
                    .map(|level| {
                        let name = format!("{hazard} {}", short_level(level.level));
                        let mut rows = level.tiers.iter().filter(|row| row.backend == last);
                        curve(name, &mut rows)
                    })
                    .collect()
            }
            None => ["cpu", "gpu"]
                .into_iter()
                .filter(|name| rows().any(|row| row.backend == *name))
                .map(|name| {
                    curve(
                        name.into(),
                        &mut all.clone().filter(|row| row.backend == name),
                    )
                })
                .collect(),
        };
        let on = match (&self.adapter, self.hazard, last) {
            (Some(adapter), Some(_), "gpu") => format!(", {adapter}"),
            _ => String::new(),
        };
        Plot {
            title: format!("{}, {} x {}{on}", self.scene, self.width, self.height),
            x_label: "milliseconds a picture".into(),
            y_label: "error of t in ulp of f32, 99 of 100 rays (2^24: wrong)".into(),
            curves,
        }
    }
}

/// A step as people write it.
fn short_level(level: f64) -> String {
    if level == 0.0 || (0.01..1e3).contains(&level) {
        level.to_string()
    } else {
        format!("{level:e}")
    }
}
