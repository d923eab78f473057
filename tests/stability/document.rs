//! `docs/hard-cases.md` is made of the catalogue, and shows real counts.
//!
//! `RAYPROOF_HARD_CASES=write cargo test --test stability` writes it, with its pictures.

use std::fmt::Write;
use std::path::Path;

use rayproof::frame::write_rgb8;
use rayproof::stability::view::{VIEWS, View, view_of};
use rayproof::stability::{Case, FAMILIES, Station, catalogue};
use rayproof::{Accuracy, Backend, Unwatched};

use super::{Outcome, outcomes};

const FILE: &str = "docs/hard-cases.md";

const HEAD: &str = "\
# Hard cases

<!-- Made of the catalogue in src/stability; see tests/stability/document.rs. -->

Where ray tracers break, tried by `rayproof stability` in every tier on every backend. Each case
is one row of a table in `src/stability`, a module for each family. Rays are aimed where a
decision is hard, by seeds that are fixed; the answers are those of exact arithmetic
(`src/oracle`). For each case something is known to fail it: the textbook tier, or a formula
that is broken on purpose (`tests/stability`).

A hit or miss counts as wrong only where the oracle is clear. Its margin is the relative change
that would turn the decision, in parts of B = |o| + t |d| + |c| + r, where o is the origin, d the
direction and c, r the shape's place and size. In f32 (textbook, robust) a margin below 16 u is
within the band in which rounding decides, u = 2^-24; in wider numbers, and for `adaptive`, one
below 2^-40. Distances are measured in the rounding of the tier's own numbers: u = 2^-24, 2^-44 in
two f32, 2^-53 in f64.

The tables count wrong rays, as the CPU has them; `*` stands where that is expected.
";

/// The picture of a case.
fn picture_of(view: &View) -> String {
    format!("pictures/hard-cases/{}.png", view.id.replace('/', "-"))
}

fn cell(case: &Case, tier: Accuracy, outcome: &Outcome) -> String {
    let mark = if case.is_expected_to_fail(tier) {
        "\\*"
    } else {
        ""
    };
    format!("{}{mark}", outcome.tally.wrong)
}

fn describe(text: &mut String, case: &Case) -> std::fmt::Result {
    let demands: Vec<String> = case.demands.iter().map(|one| one.describe()).collect();
    writeln!(text, "\n### `{}`: {}\n", case.id, case.name)?;
    writeln!(text, "{}\n", case.sets_up)?;
    writeln!(text, "Why careless code fails: {}\n", case.danger)?;
    writeln!(text, "Demanded: {}.", demands.join("; "))?;
    if !case.needs_denormals().is_empty() {
        let tiers: Vec<&str> = case
            .needs_denormals()
            .iter()
            .map(|tier| tier.name())
            .collect();
        writeln!(text, "\n{}: {NEEDS_DENORMALS}.", tiers.join(" and "))?;
    }
    if let Some(view) = view_of(case.id) {
        let picture = picture_of(view);
        writeln!(text, "\n![{}]({picture})\n", view.caption)?;
        let legend = if view.has_shadows { OF_SHADOWS } else { LEGEND };
        writeln!(text, "Textbook and robust: {}. {legend}", view.caption)?;
    }
    Ok(())
}

const LEGEND: &str = "Orange is missed and should be hit, blue is hit and should be missed.";

const OF_SHADOWS: &str = "Orange is lit and should be dark, blue is dark and should be lit.";

const NEEDS_DENORMALS: &str =
    "expected to fail in two f32, on a device that makes denormal numbers 0";

fn document() -> Result<String, std::fmt::Error> {
    let mut text = HEAD.to_string();
    writeln!(text, "\n{} cases:\n", catalogue().count())?;
    writeln!(text, "| | passed | failed as expected |\n|---|---|---|")?;
    for tier in Accuracy::ALL {
        let of_tier = || {
            outcomes()
                .iter()
                .filter(|one| one.is_on_cpu() && one.tier == tier)
        };
        let passed = of_tier().filter(|one| one.tally.wrong == 0).count();
        let failed = of_tier().count() - passed;
        writeln!(text, "| {} | {passed} | {failed} |", tier.name())?;
    }
    for family in FAMILIES {
        writeln!(text, "\n## {}\n\n{}\n", family.name, family.about)?;
        let tiers = Accuracy::ALL.map(Accuracy::name).join(" | ");
        writeln!(
            text,
            "| case | rays | {tiers} |\n|---|---|---|---|---|---|---|"
        )?;
        for case in family.cases() {
            let of_case: Vec<&Outcome> = outcomes()
                .iter()
                .filter(|one| one.is_on_cpu() && one.case.id == case.id)
                .collect();
            let cells = of_case.iter().map(|one| cell(case, one.tier, one));
            let cells = cells.collect::<Vec<_>>().join(" | ");
            let rays = of_case[0].tally.rays;
            writeln!(text, "| `{}` | {rays} | {cells} |", case.id)?;
        }
        for case in family.cases() {
            describe(&mut text, case)?;
        }
    }
    Ok(text)
}

/// Textbook and robust, side by side.
fn draw(view: &View) {
    let backend = Backend::Cpu(None);
    let stations = [Accuracy::Textbook, Accuracy::Robust].map(|tier| Station {
        backend: &backend,
        tier,
    });
    let (pixels, [width, height]) = view.side_by_side(&stations, &Unwatched).unwrap();
    let path = Path::new("docs").join(picture_of(view));
    std::fs::create_dir_all(path.parent().unwrap()).unwrap();
    write_rgb8(&path, width, height, &pixels).unwrap();
}

/// What may differ on another machine, whose sines are others: the counts.
fn without_numbers(text: &str) -> String {
    text.chars().filter(|c| !c.is_ascii_digit()).collect()
}

#[test]
fn the_document_is_that_of_the_catalogue() {
    let made = document().unwrap();
    if std::env::var("RAYPROOF_HARD_CASES").is_ok_and(|value| value == "write") {
        std::fs::write(FILE, &made).unwrap();
        VIEWS.iter().for_each(draw);
    }
    let kept = std::fs::read_to_string(FILE).unwrap_or_default();
    let [kept, made] = [&kept, &made].map(|text| without_numbers(text));
    let differing = kept
        .lines()
        .zip(made.lines())
        .find(|(kept, made)| kept != made);
    assert!(
        kept == made,
        "{differing:?}: write it anew, RAYPROOF_HARD_CASES=write cargo test --test stability"
    );
    for view in VIEWS {
        assert!(catalogue().any(|case| case.id == view.id), "{}", view.id);
        let path = Path::new("docs").join(picture_of(view));
        assert!(path.exists(), "{}", path.display());
    }
}
