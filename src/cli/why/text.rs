//! A pixel's explanation as text.

use crate::cli::report::table;
use rayproof::bounds::Bounds;
use rayproof::frame::Verdict;
use rayproof::oracle::ShapeKind;
use rayproof::render::Accuracy;
use rayproof::why::{CandidateFacts, Path, TierFacts, VolumeKind, Why};

/// Candidates shown; JSON has them all.
const MOST: usize = 10;

/// The band in which a decision is within the roundings that stable formulas make.
const BAND: f64 = rayproof::accuracy::BAND * 16_777_216.0;

/// The whole explanation; `more` lists the volumes.
pub(super) fn explained(scene: &str, why: &Why, more: bool) -> String {
    let mut text = table(&head(scene, why));
    if let Some(path) = why.path.as_ref().filter(|_| more) {
        text += &volumes(path);
    }
    text += "\nwho wins\n";
    text += &winners(why);
    let count = why.candidates.len();
    if count == 0 {
        return text + "\nNo tier meets any shape, nor is one in doubt.\n";
    }
    text += "\nwhat the ray meets or may meet, nearest first; errors in ulp of f32: in all, and\n\
             of the intersection alone, without what rounding scene and ray adds\n";
    for candidate in why.candidates.iter().take(MOST) {
        text += &shape(candidate);
    }
    if count > MOST {
        text += &format!("\nand {} more; --json has them all\n", count - MOST);
    }
    text
}

fn head(scene: &str, why: &Why) -> Vec<(&'static str, String)> {
    let ray = &why.ray;
    let mut rows = vec![
        ("scene", scene.to_string()),
        (
            "pixel",
            format!("{} {} of {} x {}", why.x, why.y, why.width, why.height),
        ),
        ("ray", format!("from the eye, at {}", triple(ray.eye))),
        ("  in f64", format!("along {}", triple(ray.direction))),
        ("  in f32", format!("along {}", triple(ray.direction_f32))),
        (
            "",
            format!(
                "turned by {:.1e} radians; t counts in lengths of {:.6}",
                ray.turned, ray.length
            ),
        ),
    ];
    let robust = &why.tiers[Accuracy::Robust as usize].counters;
    let mut tested = match why.bounds {
        Bounds::None => "none".into(),
        bounds => format!(
            "{}: {} met of {} tested",
            bounds.name(),
            robust.bound_hits,
            robust.bound_tests
        ),
    };
    if let Some(path) = &why.path {
        let name = name_of(why, Some(path.id));
        tested += &match path.steps.len() {
            0 => format!("; {name} lies in none"),
            1 => format!("; {name} lies in 1"),
            depth => format!("; {name} lies {depth} deep"),
        };
    }
    rows.push(("volumes", tested));
    rows.push((
        "shapes",
        format!("{} tested of {}", robust.shape_tests, why.primitives),
    ));
    rows
}

fn volumes(path: &Path) -> String {
    let line = |(step, depth): (&rayproof::why::Step, usize)| {
        let kind = match step.volume {
            VolumeKind::Box => "box",
            VolumeKind::Ball => "ball",
        };
        let met = if step.met { "met" } else { "MISSED" };
        let along = match (step.enter, step.exit) {
            (Some(enter), Some(exit)) => format!(", t = {enter} to {exit}"),
            _ => String::new(),
        };
        format!("  {kind} {depth}: {met}{along}\n")
    };
    path.steps.iter().zip(1..).map(line).collect()
}

fn winners(why: &Why) -> String {
    let exact = &why.exact;
    let near = exact.margin.map_or(String::new(), |margin| {
        let whose = if margin <= BAND {
            "within what f32 may round"
        } else {
            "more than f32 may round"
        };
        format!("; {} roundings of f32 from turning, {whose}", short(margin))
    });
    let mut rows = vec![(
        "  exact",
        format!("{}: {}{near}", name_of(why, exact.id), exact.why),
    )];
    let names = [
        "  textbook",
        "  robust",
        "  extended",
        "  double",
        "  adaptive",
    ];
    let tiers = names.into_iter().zip(&why.tiers);
    rows.extend(tiers.map(|(name, tier)| (name, answer(why, tier))));
    table(&rows)
}

fn answer(why: &Why, tier: &TierFacts) -> String {
    let wrong = match tier.verdict {
        Verdict::Right => "",
        Verdict::FalseMiss => " (WRONG: a false miss)",
        Verdict::FalseHit => " (WRONG: a false hit)",
        Verdict::WrongShape => " (WRONG: another shape)",
    };
    format!("{}{wrong}: {}", name_of(why, tier.id), tier.why)
}

fn shape(facts: &CandidateFacts) -> String {
    let part = facts
        .triangle
        .map_or(String::new(), |n| format!("triangle {n} of "));
    let mut text = format!(
        "\n{} {} ({part}shape {}, {})",
        kind_name(facts.kind),
        facts.id,
        facts.shape,
        facts.material
    );
    if let Some(margin) = facts.margin {
        let size = short(margin.abs());
        text += &match facts.t {
            Some(_) => format!(", {size} roundings from being missed"),
            None => format!(", missed by {size} roundings"),
        };
    }
    text += "\n";
    let line = |name: &str, t: String, rest: String| {
        format!("  {name:10}{t:<24}{rest}").trim_end().to_string() + "\n"
    };
    let miss = || "miss".to_string();
    text += &line("exact", facts.t.map_or_else(miss, double), String::new());
    for meeting in &facts.meetings {
        let is_single = matches!(meeting.accuracy, Accuracy::Textbook | Accuracy::Robust);
        let number = if is_single { single } else { double };
        let off = match (meeting.error, meeting.intersection_error) {
            (Some(all), Some(own)) => format!("off {}, of it {}", ulps(all), ulps(own)),
            (Some(all), None) => format!("off {}", ulps(all)),
            (None, Some(own)) => format!("off {} for its rounded numbers", ulps(own)),
            (None, None) => String::new(),
        };
        text += &line(
            meeting.accuracy.name(),
            meeting.t.map_or_else(miss, number),
            off,
        );
    }
    let within = match facts.interval {
        None => miss(),
        Some(interval) => match interval.high {
            Some(high) => format!("within {} to {}", single(interval.low), single(high)),
            None => format!("perhaps, not before {}", single(interval.low)),
        },
    };
    text + &line("adaptive", within, String::new())
}

fn name_of(why: &Why, id: Option<u32>) -> String {
    let Some(id) = id else {
        return "nothing".into();
    };
    let facts = why.candidates.iter().find(|facts| facts.id == id);
    facts.map_or(format!("shape {id}"), |facts| {
        format!("{} {id}", kind_name(facts.kind))
    })
}

fn kind_name(kind: ShapeKind) -> &'static str {
    match kind {
        ShapeKind::Sphere => "sphere",
        ShapeKind::Plane => "plane",
        ShapeKind::Disk => "disk",
        ShapeKind::Triangle => "triangle",
    }
}

fn triple<T: std::fmt::Display>(v: [T; 3]) -> String {
    let [x, y, z] = v;
    format!("{x}, {y}, {z}")
}

fn is_ordinary(size: f64) -> bool {
    size == 0.0 || (1e-4..1e7).contains(&size)
}

/// As many digits as tell it from any other f64.
fn double(t: f64) -> String {
    if is_ordinary(t) {
        t.to_string()
    } else {
        format!("{t:e}")
    }
}

/// As many digits as tell it from any other f32.
fn single(t: f64) -> String {
    if is_ordinary(t) {
        (t as f32).to_string()
    } else {
        format!("{:e}", t as f32)
    }
}

/// A few digits.
fn short(value: f64) -> String {
    if value == 0.0 || (0.01..1e5).contains(&value) {
        format!("{value:.2}")
    } else {
        format!("{value:.1e}")
    }
}

fn ulps(error: f64) -> String {
    if error == 0.0 {
        "0".into()
    } else {
        short(error)
    }
}
