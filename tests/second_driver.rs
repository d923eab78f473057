//! SwiftShader, a second software driver of another make, gives the same bits.
//!
//! Debian's chromium packages ship it. It is named through `VK_DRIVER_FILES`,
//! which the Vulkan loader reads once, so each comparison is a process; loaders
//! before 1.3.207 know it as `VK_ICD_FILENAMES`.

use std::io::Write;
use std::path::{Path, PathBuf};
use std::process::Command;

/// Where packages put SwiftShader's manifest.
const PLACES: [&str; 4] = [
    "/usr/lib/chromium/vk_swiftshader_icd.json",
    "/usr/lib/chromium-browser/vk_swiftshader_icd.json",
    "/usr/lib64/chromium-browser/vk_swiftshader_icd.json",
    "/opt/google/chrome/vk_swiftshader_icd.json",
];

/// SwiftShader's manifest; where the package is missing, none, said aloud, and
/// on CI, which installs it, a failure.
fn swiftshader() -> Option<PathBuf> {
    let found = PLACES.iter().map(Path::new).find(|path| path.exists());
    if found.is_none() {
        assert!(
            std::env::var_os("CI").is_none(),
            "CI installs SwiftShader, but it is not there"
        );
        // Not by `eprintln!`, which is shown of failing tests only.
        let _ = writeln!(
            std::io::stderr(),
            "NOT TESTED: no SwiftShader here; `scripts/setup.sh swiftshader` installs it"
        );
    }
    found.map(Path::to_path_buf)
}

fn compare(driver: &Path, arguments: &[&str]) -> (serde_json::Value, Option<i32>) {
    let output = Command::new(env!("CARGO_BIN_EXE_rayproof"))
        .env("VK_DRIVER_FILES", driver)
        .env("VK_ICD_FILENAMES", driver)
        .arg("compare")
        .args(arguments)
        .args(["--json", "--adapter", "SwiftShader"])
        .output()
        .unwrap();
    let text = String::from_utf8_lossy(&output.stdout);
    let figures = serde_json::from_str(&text)
        .unwrap_or_else(|_| panic!("{text}{}", String::from_utf8_lossy(&output.stderr)));
    (figures, output.status.code())
}

fn assert_same_bits(arguments: &[&str]) {
    let Some(driver) = swiftshader() else { return };
    let (figures, code) = compare(&driver, arguments);
    assert_eq!(figures["different_pixels"], 0, "{figures:#}");
    assert_eq!(figures["max_ulp"], 0);
    assert_eq!(figures["id_mismatches"], 0);
    assert_eq!(figures["tolerance"]["different_pixels"], 0);
    assert_eq!(code, Some(0));
}

#[test]
fn seed_spheres() {
    assert_same_bits(&["assets/scenes/seed-spheres.toml"]);
}

#[test]
fn shapes() {
    assert_same_bits(&["assets/scenes/shapes.toml"]);
}

#[test]
fn seed_models() {
    assert_same_bits(&["assets/scenes/seed-models.toml"]);
}

#[test]
fn knot() {
    assert_same_bits(&["assets/scenes/knot.toml"]);
}

/// It has no f64: `adaptive` traces rays in doubt again in two f32, and finds what the CPU
/// finds in f64.
#[test]
fn tiers() {
    let Some(driver) = swiftshader() else { return };
    for scene in ["shapes", "planet", "slivers", "far-sphere"] {
        for (tier, layers) in [
            ("extended", "color,depth,normal,position,id"),
            ("adaptive", "id"),
        ] {
            let folder = tempfile::tempdir().unwrap();
            let pictures = ["gpu", "cpu"].map(|backend| {
                let picture = folder.path().join(format!("{backend}.exr"));
                let status = Command::new(env!("CARGO_BIN_EXE_rayproof"))
                    .env("VK_DRIVER_FILES", &driver)
                    .env("VK_ICD_FILENAMES", &driver)
                    .args(["render", &format!("assets/scenes/{scene}.toml"), "--quiet"])
                    .args([
                        "--size",
                        "160x120",
                        "--accuracy",
                        tier,
                        "--backend",
                        backend,
                    ])
                    .args(["--layer", layers, "-o", picture.to_str().unwrap()])
                    .status();
                assert!(status.unwrap().success(), "{scene} {tier} {backend}");
                picture.to_str().unwrap().to_string()
            });
            let (figures, _) = compare(&driver, &[&pictures[0], &pictures[1]]);
            assert_eq!(
                figures["different_pixels"], 0,
                "{scene} {tier}: {figures:#}"
            );
        }
    }
    // The control: another tier is noticed.
    let arguments = ["--accuracy", "double", "--backend", "gpu", "-o", "x.exr"];
    let refused = Command::new(env!("CARGO_BIN_EXE_rayproof"))
        .env("VK_DRIVER_FILES", &driver)
        .env("VK_ICD_FILENAMES", &driver)
        .args(["render", "assets/scenes/shapes.toml"])
        .args(arguments)
        .output()
        .unwrap();
    assert_eq!(refused.status.code(), Some(2));
    assert!(String::from_utf8_lossy(&refused.stderr).contains("f64"));
}

/// The hard cases come out as the catalogue says; `double` is not there, and is said not to be.
/// SwiftShader compiles the shaders of pictures for half of the time, so those cases are for the
/// thorough run.
#[test]
fn hard_cases() {
    let Some(driver) = swiftshader() else { return };
    let ids: Vec<&str> = rayproof::stability::catalogue()
        .map(|case| case.id)
        .filter(|id| thorough() || !OF_PICTURES.contains(id))
        .collect();
    assert!(ids.len() > 100);
    let output = Command::new(env!("CARGO_BIN_EXE_rayproof"))
        .env("VK_DRIVER_FILES", &driver)
        .env("VK_ICD_FILENAMES", &driver)
        .args(["stability", "--backend", "gpu", "--json", "--case"])
        .args([&ids.join(","), "--tier", "robust,extended,double,adaptive"])
        .output()
        .unwrap();
    let text = String::from_utf8_lossy(&output.stdout);
    let results: serde_json::Value = serde_json::from_str(&text).unwrap();
    let cases = results["cases"].as_array().unwrap();
    assert_eq!(cases.len(), 3 * ids.len());
    let unexpected: Vec<_> = cases
        .iter()
        .filter(|case| case["expected"] != true)
        .collect();
    assert!(unexpected.is_empty(), "{unexpected:#?}");
    assert_eq!(output.status.code(), Some(0));
    for sum in results["summary"].as_array().unwrap() {
        assert_eq!(sum["available"], sum["tier"] != "double", "{sum:#}");
        assert!(sum["adapter"].as_str().unwrap().contains("SwiftShader"));
    }
}

/// Hard cases that are pictures.
const OF_PICTURES: [&str; 7] = [
    "bounds/tight-box",
    "bounds/tight-sphere",
    "bounds/tight-tile",
    "shading/light-behind",
    "shading/light-on-surface",
    "sphere/far-1e5-seen",
    "sphere/ground-seen",
];

/// Brute force takes 27 s on the models in full size and 60 s on the knot.
#[test]
fn without_volumes() {
    for (scene, full, small) in [
        ("assets/scenes/seed-spheres.toml", "1000x1000", "1000x1000"),
        ("assets/scenes/shapes.toml", "1000x1000", "1000x1000"),
        ("assets/scenes/seed-models.toml", "500x500", "150x150"),
        ("assets/scenes/knot.toml", "96x96", "32x32"),
    ] {
        let size = if thorough() { full } else { small };
        assert_same_bits(&[scene, "--size", size, "--bounds", "none"]);
    }
}

fn thorough() -> bool {
    std::env::var_os("RAYPROOF_THOROUGH").is_some()
}

/// The control: another scene on the CPU is noticed.
#[test]
fn a_moved_sphere_is_noticed() {
    let Some(driver) = swiftshader() else { return };
    let folder = tempfile::tempdir().unwrap();
    let moved = folder.path().join("moved.toml");
    let scene = std::fs::read_to_string("assets/scenes/shapes.toml").unwrap();
    let changed = scene.replacen("radius = ", "radius = 1e-6 # instead of ", 1);
    assert_ne!(changed, scene);
    std::fs::write(&moved, changed).unwrap();
    let arguments = [
        "assets/scenes/shapes.toml",
        moved.to_str().unwrap(),
        "--size",
        "100x100",
    ];
    let (figures, code) = compare(&driver, &arguments);
    assert_ne!(figures["different_pixels"], 0);
    assert_eq!(code, Some(1));
}
