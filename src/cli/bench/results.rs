//! What `rayproof bench` found, as JSON and as a table.

use serde::Serialize;

use crate::cli::report::{columns, table};
use rayproof::bounds::Bounds;
use rayproof::count::Counters;

/// The result of one call.
#[derive(Debug, Serialize)]
pub(super) struct Results {
    pub(super) scene: String,
    pub(super) width: u32,
    pub(super) height: u32,
    pub(super) primitives: u32,
    pub(super) clock: &'static str,
    pub(super) warmup: u32,
    pub(super) budget_s: f64,
    pub(super) equal: bool,
    pub(super) runs: Vec<Row>,
}

/// One configuration.
#[derive(Debug, Serialize)]
pub(super) struct Row {
    pub(super) backend: &'static str,
    pub(super) adapter: Option<String>,
    pub(super) threads: Option<usize>,
    pub(super) bounds: Bounds,
    pub(super) runs: usize,
    pub(super) from_warm_up: bool,
    pub(super) median_ms: f64,
    pub(super) min_ms: f64,
    pub(super) max_ms: f64,
    pub(super) mrays_per_s: f64,
    /// Over `none` on the same backend, where that was measured.
    pub(super) speedup: Option<f64>,
    /// The least and the greatest ratio of single runs.
    pub(super) speedup_range: Option<[f64; 2]>,
    /// Over the first configuration.
    pub(super) against_first: f64,
    pub(super) against_first_range: Option<[f64; 2]>,
    /// By the device's clock: the passes in which closest hits are found.
    pub(super) search_ms: Option<f64>,
    /// Of those, over `none`.
    pub(super) search_speedup: Option<f64>,
    /// By the device's clock: the passes in which what was hit is coloured.
    pub(super) shade_ms: Option<f64>,
    pub(super) build_ms: f64,
    pub(super) counters: Option<Counters>,
    pub(super) equal: bool,
    pub(super) different_pixels: u64,
}

const HEAD: [&str; 13] = [
    "backend",
    "threads",
    "bounds",
    "runs",
    "median ms",
    "min",
    "max",
    "Mrays/s",
    "x none",
    "x first",
    "search ms",
    "x none",
    "build ms",
];

impl Results {
    /// For people.
    pub(super) fn table(&self, runs: u32) -> String {
        let Self {
            scene,
            width,
            height,
            primitives,
            warmup,
            budget_s,
            ..
        } = self;
        let mut rows = vec![
            ("scene", format!("{scene}, {width} x {height}")),
            ("primitives", primitives.to_string()),
        ];
        let adapter = self.runs.iter().find_map(|row| row.adapter.clone());
        rows.extend(adapter.map(|adapter| ("adapter", adapter)));
        rows.push((
            "measured",
            format!(
                "wall time of a picture; search by the device's clock; \
                 {warmup} + {runs} runs, interleaved"
            ),
        ));
        let mut text = table(&rows) + "\n" + &columns(HEAD, self.runs.iter().map(Row::cells));
        text += "\n";
        if self.runs.iter().any(|row| row.runs < runs as usize) {
            text += &format!("fewer runs: the budget of {budget_s} s was spent\n");
        }
        if self.runs.iter().any(|row| row.from_warm_up) {
            text += "* a warm-up, after which nothing was left of the budget\n";
        }
        for row in self.runs.iter().filter(|row| !row.equal) {
            text += &format!(
                "{} {}: {} pixels differ from the first row's\n",
                row.backend,
                row.bounds.name(),
                row.different_pixels
            );
        }
        text += if self.equal {
            "all pictures equal, bit for bit\n"
        } else {
            "DIFFERENT\n"
        };
        text
    }
}

impl Row {
    fn cells(&self) -> [String; 13] {
        let mark = if self.from_warm_up { "*" } else { "" };
        let speedup = match (self.speedup, self.speedup_range) {
            (Some(ratio), Some([min, max])) => format!("{ratio:.2} ({min:.2}-{max:.2})"),
            (Some(ratio), None) => format!("{ratio:.2}"),
            (None, _) => "-".into(),
        };
        [
            self.backend.into(),
            self.threads.map_or("-".into(), |n| n.to_string()),
            self.bounds.name().into(),
            format!("{}{mark}", self.runs),
            format!("{:.2}", self.median_ms),
            format!("{:.2}", self.min_ms),
            format!("{:.2}", self.max_ms),
            format!("{:.3}", self.mrays_per_s),
            speedup,
            format!("{:.2}", self.against_first),
            or_dash(self.search_ms),
            or_dash(self.search_speedup),
            format!("{:.2}", self.build_ms),
        ]
    }
}

fn or_dash(number: Option<f64>) -> String {
    number.map_or("-".into(), |number| format!("{number:.2}"))
}
