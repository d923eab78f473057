//! What `rayproof plan` found, as JSON and as a table.

use std::path::Path;

use serde::Serialize;

use super::row_of;
use crate::cli::paths::a_pixel_of;
use crate::cli::report::{columns_of, table};
use rayproof::plan::{PATHS, PlannedBinding, ScenePlan};
use rayproof::scene::Scene;

/// The result of one call.
#[derive(Debug, Serialize)]
pub(super) struct Results {
    scene: String,
    width: u32,
    height: u32,
    samples: u32,
    traced: &'static str,
    /// What was measured on.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub(super) backend: Option<String>,
    effects: Vec<Row>,
    files: Vec<&'static str>,
    files_left_out: Vec<&'static str>,
    bindings: Vec<PlannedBinding>,
    shader_words: usize,
    full_shader_words: usize,
    #[serde(skip_serializing_if = "Option::is_none")]
    pub(super) proof: Option<Proof>,
}

/// An effect.
#[derive(Debug, Serialize)]
pub(super) struct Row {
    pub(super) name: &'static str,
    pub(super) on: bool,
    pub(super) reason: String,
    /// None where it was not measured, or cannot be taken out.
    pub(super) cost_ms: Option<f64>,
    #[serde(flatten)]
    pub(super) cost: Option<Cost>,
}

/// How an effect's cost comes about.
#[derive(Debug, Clone, Copy, Serialize)]
pub(super) struct Cost {
    /// Of the scene as it is, a median.
    pub(super) with_ms: f64,
    /// Of the scene without the effect, another.
    pub(super) without_ms: f64,
    /// The part of the scene's time that it takes.
    pub(super) share: f64,
}

/// That what is left out changes nothing.
#[derive(Debug, Clone, Copy, Serialize)]
pub(super) struct Proof {
    /// Whether the picture with all effects in the shader has the same bits.
    pub(super) equal: bool,
    pub(super) different_pixels: usize,
    /// How much longer that took, compiling it included.
    pub(super) ratio: f64,
}

impl Results {
    pub(super) fn of(path: &Path, scene: &Scene, plan: &ScenePlan) -> Self {
        Self {
            scene: path.display().to_string(),
            width: scene.image.width,
            height: scene.image.height,
            samples: scene.integrator.samples,
            traced: plan.traced,
            backend: None,
            effects: plan.effects.iter().map(row_of).collect(),
            files: plan.files.clone(),
            files_left_out: plan.files_left_out.clone(),
            bindings: plan.bindings.clone(),
            shader_words: plan.shader_words,
            full_shader_words: plan.full_shader_words,
            proof: None,
        }
    }

    pub(super) fn take_costs(&mut self, costs: Vec<(&'static str, Cost)>) {
        for (name, cost) in costs {
            let row = self.effects.iter_mut().find(|row| row.name == name);
            if let Some(row) = row {
                row.cost_ms = Some(cost.with_ms - cost.without_ms);
                row.cost = Some(cost);
            }
        }
    }

    pub(super) fn table(&self) -> String {
        let is_measured = self.backend.is_some();
        let rows = self.effects.iter().map(|row| row.cells(is_measured));
        let cells = columns_of(head(is_measured), rows.collect());
        let reasons = ["why"].into_iter();
        let reasons = reasons.chain(self.effects.iter().map(|row| row.reason.as_str()));
        let width = cells.lines().map(str::len).max().unwrap_or(0);
        let lines = cells.lines().zip(reasons);
        let effects: String = lines
            .map(|(cells, reason)| format!("{cells:width$}  {reason}\n"))
            .collect();
        let buffers: Vec<String> = self.bindings.iter().map(described).collect();
        let count = |names: &[&str]| {
            let names: Vec<&str> = names.iter().map(|name| stem_of(name)).collect();
            folded(&format!("{}: {}", names.len(), names.join(" ")))
        };
        let part = 100.0 * self.shader_words as f64 / self.full_shader_words as f64;
        let mut facts = vec![
            ("scene", self.scene.clone()),
            ("made of", self.made_of()),
            ("files in", count(&self.files)),
            ("files out", count(&self.files_left_out)),
            ("bindings", folded(&buffers.join(", "))),
            (
                "shader",
                format!(
                    "{} words of SPIR-V, {part:.0} % of the {} of all effects",
                    self.shader_words, self.full_shader_words
                ),
            ),
        ];
        if let Some(proof) = self.proof {
            facts.push(("proof", proof.told()));
        }
        if let Some(backend) = &self.backend {
            facts.push(("measured on", backend.clone()));
        }
        format!("{effects}\n{}", table(&facts))
    }

    fn made_of(&self) -> String {
        let each = a_pixel_of(self.traced == PATHS, self.samples);
        format!("{} x {}, {each}", self.width, self.height)
    }
}

/// A shader file's name without its ending.
fn stem_of(name: &str) -> &str {
    name.strip_suffix(".wgsl").unwrap_or(name)
}

/// Columns of the facts' text, and where it begins.
const WIDTH: usize = 84;
const INDENT: &str = "             ";

/// A text in lines that are not too long.
fn folded(text: &str) -> String {
    let mut lines = vec![String::new()];
    for word in text.split(' ') {
        let last = lines.len() - 1;
        if !lines[last].is_empty() && lines[last].len() + 1 + word.len() > WIDTH {
            lines.push(word.to_owned());
            continue;
        }
        if !lines[last].is_empty() {
            lines[last].push(' ');
        }
        lines[last].push_str(word);
    }
    lines.join(&format!("\n{INDENT}"))
}

fn head(is_measured: bool) -> Vec<String> {
    let cost: &[&str] = if is_measured {
        &["cost ms", "of", "part"]
    } else {
        &[]
    };
    let names = ["effect", "on"].iter().chain(cost);
    names.map(ToString::to_string).collect()
}

impl Row {
    fn cells(&self, is_measured: bool) -> Vec<String> {
        let mut cells = vec![
            self.name.to_owned(),
            if self.on { "on" } else { "-" }.into(),
        ];
        match self.cost.zip(self.cost_ms) {
            Some((cost, cost_ms)) => cells.extend([
                format!("{cost_ms:.1}"),
                format!("{:.1}", cost.with_ms),
                format!("{:.0} %", 100.0 * cost.share),
            ]),
            None if is_measured => cells.extend(["", "", ""].map(String::from)),
            None => {}
        }
        cells
    }
}

impl Proof {
    fn told(self) -> String {
        if self.equal {
            return "with all effects in the shader, every bit of the picture is the same".into();
        }
        format!(
            "with all effects in the shader, {} pixels have another colour: a defect",
            self.different_pixels
        )
    }
}

fn described(binding: &PlannedBinding) -> String {
    let place = format!("{} ({}.{}", binding.name, binding.group, binding.binding);
    match binding.effect {
        Some(effect) => format!("{place}, {effect})"),
        None => format!("{place})"),
    }
}
