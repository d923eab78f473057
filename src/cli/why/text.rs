//! A pixel's explanation as text.

use crate::cli::report::table;
use rayproof::bounds::Bounds;
use rayproof::frame::Verdict;
use rayproof::oracle::ShapeKind;
use rayproof::render::Accuracy;
use rayproof::why::{CandidateFacts, Path, VolumeKind, Why};

/// Candidates shown; JSON has them all.
const MOST: usize = 10;

/// Columns of a sentence.
const WIDTH: usize = 76;

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
    text += &format!(
        "\nwhat the ray meets or may meet, nearest first\n  {:10}{:<24}{:>9}  {:>12}\n",
        "", "t", "error", "intersection"
    );
    for candidate in why.candidates.iter().take(MOST) {
        text += &shape(candidate);
    }
    if count > MOST {
        text += &format!("\nand {} more; --json has them all\n", count - MOST);
    }
    text + "\nErrors are in ulp of f32: of the whole, and of the intersection alone, against what\n\
            is exact for scene and ray as the tier has them, rounded.\n"
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
                "turned by {:.1e} radians; its length, {:.6}, is the unit of t",
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
        let so = if margin <= BAND {
            "may get it wrong"
        } else {
            "should get it right"
        };
        format!(
            ". A change by {} roundings of f32 would turn that; stable formulas make up to \
             {BAND}, so f32 {so}",
            short(margin)
        )
    });
    let mut text = wrapped(
        "exact",
        &format!("{}: {}{near}", name_of(why, exact.id), exact.why),
    );
    for tier in &why.tiers {
        let wrong = match tier.verdict {
            Verdict::Right => "",
            Verdict::FalseMiss => ", WRONG (a false miss)",
            Verdict::FalseHit => ", WRONG (a false hit)",
            Verdict::WrongShape => ", WRONG (another shape)",
        };
        let answer = format!("{}{wrong}: {}", name_of(why, tier.id), tier.why);
        text += &wrapped(tier.accuracy.name(), &answer);
    }
    text
}

/// A name and a sentence, broken into lines that stand under one another.
fn wrapped(name: &str, sentence: &str) -> String {
    let mut text = format!("  {name:9}");
    let mut length = 0;
    for word in sentence.split(' ') {
        if length > 0 && length + word.len() >= WIDTH {
            text += &format!("\n  {:9}", "");
            length = 0;
        }
        text += &format!(" {word}");
        length += 1 + word.len();
    }
    text + "\n"
}

fn shape(facts: &CandidateFacts) -> String {
    let part = facts
        .triangle
        .map_or(String::new(), |n| format!("triangle {n} of "));
    let mut what = match (facts.shape, facts.lamp) {
        (Some(shape), _) => format!("{part}shape {shape}"),
        (None, lamp) => lamp.map_or("lamp".into(), |lamp| format!("lamp {lamp}")),
    };
    if let Some(material) = &facts.material {
        what += &format!(", {material}");
    }
    let mut text = format!("\n{} {} ({what})", kind_name(facts.kind), facts.id);
    if let Some(margin) = facts.margin {
        let size = short(margin.abs());
        text += &match facts.t {
            Some(_) => format!(", {size} roundings from being missed"),
            None => format!(", missed by {size} roundings"),
        };
    }
    text += "\n";
    let miss = || "miss".to_string();
    text += &line("exact", &facts.t.map_or_else(miss, double), [None; 2]);
    for meeting in &facts.meetings {
        let is_single = matches!(meeting.accuracy, Accuracy::Textbook | Accuracy::Robust);
        let number = if is_single { single } else { double };
        text += &line(
            meeting.accuracy.name(),
            &meeting.t.map_or_else(miss, number),
            [meeting.error, meeting.intersection_error],
        );
    }
    let within = match facts.interval {
        None => miss(),
        Some(interval) => match interval.high {
            Some(high) => format!("within {} to {}", single(interval.low), single(high)),
            None => format!("perhaps, not before {}", single(interval.low)),
        },
    };
    text + &line("adaptive", &within, [None; 2])
}

/// A tier's t and its errors, where there are any.
fn line(name: &str, t: &str, [all, own]: [Option<f64>; 2]) -> String {
    let cell = |error: Option<f64>| error.map_or(String::new(), short);
    let line = format!("  {name:10}{t:<24}{:>9}  {:>12}", cell(all), cell(own));
    line.trim_end().to_string() + "\n"
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
    if value == 0.0 {
        "0".into()
    } else if (0.01..1e4).contains(&value) {
        format!("{value:.2}")
    } else {
        format!("{value:.1e}")
    }
}
