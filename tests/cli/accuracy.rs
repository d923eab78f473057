//! `accuracy`: what is measured, and what is told of it.

use serde_json::Value;

use super::{Room, has_fields};

const TIERS: [&str; 5] = ["textbook", "robust", "extended", "double", "adaptive"];

const FIELDS: &str = "tier backend available reason runs from_warm_up median_ms min_ms max_ms \
    mrays_per_s cost device_ms device_cost retraced misclassified outside_band ulp_p50 ulp_p99 \
    ulp_max total rmse flip";

fn far_sphere(room: &Room) {
    let path = concat!(env!("CARGO_MANIFEST_DIR"), "/assets/scenes/far-sphere.toml");
    room.write("far.toml", std::fs::read_to_string(path).expect("a scene"));
}

fn rows<'a>(results: &'a Value, list: &str) -> &'a [Value] {
    results[list].as_array().expect("rows")
}

#[test]
fn every_tier_is_measured_on_every_backend() {
    let room = Room::new();
    far_sphere(&room);
    let line = "accuracy far.toml --json --size 64x64 --runs 2 -o plot.svg";
    let results = room.run(line).with(0).json();
    has_fields(
        &results,
        "scene width height adapter clock warmup budget_s hazard tiers",
    );
    let rows = rows(&results, "tiers");
    let names: Vec<_> = rows
        .iter()
        .map(|row| {
            (
                row["backend"].as_str().unwrap(),
                row["tier"].as_str().unwrap(),
            )
        })
        .collect();
    let expected: Vec<_> = ["cpu", "gpu"]
        .into_iter()
        .flat_map(|backend| TIERS.map(|tier| (backend, tier)))
        .collect();
    assert_eq!(names, expected);
    for row in rows {
        has_fields(row, FIELDS);
        assert_eq!(row["runs"], 2);
        let wrong = row["misclassified"].as_u64().unwrap();
        match row["tier"].as_str().unwrap() {
            // The baseline is bad here: the control for all the others.
            "textbook" => assert!(wrong > 100 && row["cost"] == 1.0, "{row:#}"),
            "robust" => assert!(wrong < 10, "{row:#}"),
            "adaptive" => assert!(wrong == 0 && row["retraced"].as_u64() > Some(0), "{row:#}"),
            _ => assert!(
                wrong == 0 && row["ulp_max"].as_f64() < Some(1e-3),
                "{row:#}"
            ),
        }
    }
    // GPU and CPU have the same errors, to the last digit.
    let (cpu, gpu) = rows.split_at(TIERS.len());
    for (cpu, gpu) in cpu.iter().zip(gpu).skip(1) {
        assert_eq!(cpu["ulp_max"], gpu["ulp_max"]);
        assert_eq!(cpu["retraced"], gpu["retraced"]);
        assert_eq!(cpu["total"], gpu["total"]);
    }
    let plot = String::from_utf8(room.read("plot.svg")).unwrap();
    assert!(
        plot.starts_with("<svg") || plot.starts_with("<?xml"),
        "{plot:.80}"
    );
    assert!(TIERS.iter().all(|tier| plot.contains(tier)));
}

#[test]
fn a_hazard_has_its_steps() {
    let room = Room::new();
    far_sphere(&room);
    let line = "accuracy far.toml --json --size 32x32 --runs 1 --warmup 0 --backend cpu \
                --hazard distance --tier textbook,double";
    let results = room.run(line).with(0).json();
    assert_eq!(results["hazard"], "distance");
    let levels = rows(&results, "levels");
    let wrong = |level: usize, row: usize| levels[level]["tiers"][row]["misclassified"].as_u64();
    assert_eq!(levels.len(), 7);
    assert!((0..7).all(|level| wrong(level, 1) == Some(0)), "double");
    assert!(wrong(1, 0) == Some(0) && wrong(4, 0) > Some(100));
    // What a scene has not got cannot be made harder.
    room.run("accuracy far.toml --hazard slivers")
        .with(2)
        .telling(&["slivers", "triangles"]);
}

#[test]
fn a_picture_shows_the_errors() {
    let room = Room::new();
    far_sphere(&room);
    for (layer, tier) in [
        ("ulp", "robust"),
        ("wrong", "textbook"),
        ("wrong", "double"),
    ] {
        let name = format!("{layer}-{tier}.png");
        let line = format!(
            "accuracy far.toml --size 32x32 --runs 1 --warmup 0 --tier {tier} --layer {layer} \
             -o {name}"
        );
        room.run(&line).with(0);
    }
    assert_ne!(
        room.read("wrong-textbook.png"),
        room.read("wrong-double.png")
    );
}

#[test]
fn the_table_names_its_columns() {
    let room = Room::new();
    let ended = room
        .run("accuracy ok.toml --runs 1 --warmup 0 --tier robust --bounds none")
        .with(0);
    for word in [
        "cost",
        "wrong",
        "past band",
        "worst",
        "robust",
        "exact answer",
    ] {
        assert!(ended.out.contains(word), "{word}: {}", ended.out);
    }
}
