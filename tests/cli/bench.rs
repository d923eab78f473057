//! `bench`: what is measured, and what is told of it.

use serde_json::Value;

use super::{Room, has_fields};

const FIELDS: &str = "backend adapter threads bounds runs from_warm_up median_ms min_ms max_ms \
    mrays_per_s speedup speedup_range against_first against_first_range search_ms \
    search_speedup shade_ms build_ms counters equal different_pixels";

/// Runs `bench ok.toml` in its own small size and gives the object.
#[track_caller]
fn bench(flags: &str) -> Value {
    Room::new()
        .run(&format!("bench ok.toml --json {flags}"))
        .with(0)
        .json()
}

/// The backends, threads and volumes of the rows.
fn names(results: &Value) -> Vec<String> {
    let rows = results["runs"].as_array().expect("rows");
    rows.iter()
        .map(|row| {
            let text = |name: &str| row[name].as_str().expect("a name").to_string();
            let threads = row["threads"].as_u64().map(|n| n.to_string());
            [
                text("backend"),
                threads.unwrap_or("-".into()),
                text("bounds"),
            ]
            .join(" ")
        })
        .collect()
}

#[track_caller]
fn number(value: &Value) -> f64 {
    value
        .as_f64()
        .unwrap_or_else(|| panic!("{value} is no number"))
}

/// Equal but for the last digits: seconds and milliseconds round apart.
#[track_caller]
fn assert_near(value: &Value, expected: f64) {
    let ratio = number(value) / expected;
    assert!((ratio - 1.0).abs() < 1e-12, "{value} is not {expected}");
}

const BOUNDS: [&str; 6] = ["none", "scene", "spheres", "boxes", "screen", "tree"];

#[test]
fn all_backends_and_volumes_are_measured_side_by_side() {
    let results = bench("--threads 1,2 --runs 3");
    has_fields(
        &results,
        "scene width height primitives clock warmup budget_s equal runs",
    );
    assert_eq!(
        names(&results),
        ["cpu 1", "cpu 2", "gpu -"]
            .into_iter()
            .flat_map(|backend| BOUNDS.map(|bounds| format!("{backend} {bounds}")))
            .collect::<Vec<_>>()
    );
    assert_eq!(results["equal"], true);
    let rows = results["runs"].as_array().expect("rows");
    for (index, row) in rows.iter().enumerate() {
        has_fields(row, FIELDS);
        assert_eq!(row["runs"], 3);
        assert_eq!(row["counters"], Value::Null);
        let [min, median, max] = ["min_ms", "median_ms", "max_ms"].map(|name| number(&row[name]));
        assert!(0.0 < min && min <= median && median <= max, "{row:#}");
        let rate = 48.0 * 32.0 / median / 1e3;
        assert_near(&row["mrays_per_s"], rate);
        // Against `none` of the same backend and threads, which is the first of them.
        let none = index / BOUNDS.len() * BOUNDS.len();
        let none = number(&rows[none]["median_ms"]);
        assert_near(&row["speedup"], none / median);
        let first = number(&rows[0]["median_ms"]);
        assert_near(&row["against_first"], first / median);
        let [low, high] = [0, 1].map(|end| number(&row["speedup_range"][end]));
        assert!(0.0 < low && low <= high, "{row:#}");
        assert!(
            low * 0.999 < none / median && none / median < high * 1.001,
            "{row:#}"
        );
    }
}

#[test]
fn what_was_not_measured_is_not_told() {
    let results = bench("--backend cpu --bounds tree --threads 2 --runs 1");
    assert_eq!(names(&results), ["cpu 2 tree"]);
    let row = &results["runs"][0];
    for name in ["speedup", "speedup_range", "adapter", "against_first_range"] {
        assert_eq!(row[name], Value::Null, "{name}");
    }
    assert_eq!(row["against_first"], 1.0);
    let results = bench("--backend gpu --bounds tree,none --runs 2");
    assert_eq!(names(&results), ["gpu - tree", "gpu - none"]);
    assert!(results["runs"][0]["speedup"].is_f64());
    assert!(results["runs"][0]["adapter"].is_string());
}

/// By the device's own clock, where there is one.
#[test]
fn the_device_times_its_passes() {
    let results = bench("--bounds none,tree --runs 2");
    for row in results["runs"].as_array().expect("rows") {
        let on_gpu = row["backend"] == "gpu";
        for name in ["search_ms", "shade_ms", "search_speedup"] {
            assert_eq!(row[name].is_f64(), on_gpu, "{name}: {row:#}");
        }
        if on_gpu {
            let [search, shade] = ["search_ms", "shade_ms"].map(|name| number(&row[name]));
            assert!(search > 0.0 && shade > 0.0, "{row:#}");
        }
    }
}

#[test]
fn what_the_rays_test_is_counted_where_asked_for() {
    let results = bench("--bounds none,tree --runs 1 --warmup 0 --count");
    let rows = results["runs"].as_array().expect("rows");
    let tests = |row: usize| number(&rows[row]["counters"]["shape_tests"]);
    let brute_force = 48.0 * 32.0 * number(&results["primitives"]);
    assert_eq!([tests(0), tests(2)], [brute_force; 2]);
    // Both backends walk the same tree, and it saves tests.
    assert_eq!(rows[1]["counters"], rows[3]["counters"]);
    assert!(tests(1) <= brute_force);
}

#[test]
fn growth_is_measured_without_a_scene() {
    let room = Room::new();
    let line = "bench --scale 2000,500 --size 24x16 --runs 2 --threads 2";
    let results = room.run(&format!("{line} --json")).with(0).json();
    has_fields(&results, "mesh width height warmup runs exponents");
    let rows = results["runs"].as_array().expect("rows");
    let names = "triangles backend adapter threads median_ms min_ms max_ms search_ms build_ms \
        device_bytes";
    for row in rows {
        has_fields(row, names);
    }
    let of = |name: &str| {
        rows.iter()
            .map(|row| number(&row[name]))
            .collect::<Vec<_>>()
    };
    let triangles = of("triangles");
    assert!(triangles[0] == triangles[1] && triangles[1] < triangles[2]);
    assert!((450.0..550.0).contains(&triangles[0]), "{triangles:?}");
    let bytes = number(&results["exponents"]["device_bytes"]);
    assert!((0.8..1.2).contains(&bytes), "{bytes}");
    assert_eq!(
        results["exponents"]["trace"].as_array().map(Vec::len),
        Some(2)
    );
    let one = room
        .run("bench --scale 10,100 --size 8x8 --runs 1")
        .with(0)
        .out;
    assert!(one.contains("one size") && !one.contains("NaN"), "{one}");
    let text = room.run(line).with(0).out;
    for words in ["growth with the triangles n", "a picture on the gpu"] {
        assert!(text.contains(words), "no `{words}` in {text}");
    }
    for line in [
        "bench",
        "bench ok.toml --scale",
        "bench --scale 0",
        "bench --scale --count",
    ] {
        room.run(line).with(2);
    }
}

#[test]
fn a_spent_budget_is_told() {
    let row = |flags: &str| {
        let results = bench(&format!("--backend cpu --bounds none --runs 4 {flags}"));
        let row = &results["runs"][0];
        (row["runs"].clone(), row["from_warm_up"].clone())
    };
    assert_eq!(row(""), (4.into(), false.into()));
    assert_eq!(row("--budget 0"), (1.into(), true.into()));
    assert_eq!(row("--budget 0 --warmup 0"), (1.into(), false.into()));
    let text = Room::new().run("bench ok.toml --backend cpu --budget 0");
    assert!(
        text.out.contains("the budget of 0 s was spent"),
        "{text:#?}"
    );
    assert!(text.out.contains("* a warm-up"), "{text:#?}");
}

#[test]
fn the_table_names_the_clock_and_the_verdict() {
    let ended = Room::new()
        .run("bench ok.toml --runs 2 --threads 1")
        .with(0);
    for words in [
        "wall time of a picture; search by the device's clock; 1 + 2 runs, interleaved",
        "backend  threads   bounds  runs",
        "all pictures equal, bit for bit",
    ] {
        assert!(ended.out.contains(words), "no `{words}` in {ended:#?}");
    }
    assert!(!ended.out.contains("budget"), "{ended:#?}");
}

#[test]
fn flags_that_make_no_sense_are_2() {
    let room = Room::new();
    for (flags, word) in [
        ("--runs 0", "1..=10000"),
        ("--budget -1", "unexpected"),
        ("--budget=-1", "seconds"),
        ("--budget nan", "seconds"),
        ("--budget inf", "seconds"),
        ("--bounds fog", "none, scene, spheres, boxes, screen, tree"),
        ("--levels 0", "1 to 16"),
        ("--threads 1,0", "1 to 1024"),
        ("--backend gpu --threads 1", "--threads"),
        ("--backend cpu --adapter x", "--adapter"),
        ("--size 0x1", "1 to 32768"),
    ] {
        room.run(&format!("bench ok.toml {flags}"))
            .with(2)
            .telling(&[word]);
    }
    room.run("bench none.toml").with(3);
}

#[test]
fn without_an_adapter_all_is_4_and_auto_is_the_cpu() {
    let room = Room::new();
    let nothing = [("VK_DRIVER_FILES", "/nonexistent")];
    room.run_with("bench ok.toml", &nothing)
        .with(4)
        .telling(&["mesa-vulkan-drivers"]);
    let line = "bench ok.toml --backend auto --bounds tree --threads 1 --json";
    let ended = room.run_with(line, &nothing).with(0);
    assert_eq!(names(&ended.json()), ["cpu 1 tree"]);
    assert!(ended.err.contains("measuring the CPU"), "{ended:#?}");
    // With one, `auto` is the GPU.
    assert_eq!(names(&room.run(line).with(0).json()), ["gpu - tree"]);
}
