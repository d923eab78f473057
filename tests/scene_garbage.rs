//! Garbage in: never a panic, and never a scene that `validate` refuses.

use std::path::Path;

use proptest::prelude::*;
use rayproof::Error;
use rayproof::scene::parse::{load, parse_str};
use rayproof::scene::policy::Policy;

const SCENES: [&str; 4] = [
    include_str!("../assets/scenes/seed-spheres.toml"),
    include_str!("../assets/scenes/seed-models.toml"),
    include_str!("../assets/scenes/shapes.toml"),
    include_str!("../assets/scenes/knot.toml"),
];

/// Pieces that a slip or malice puts into a scene.
const PIECES: [&str; 56] = [
    "[",
    "]",
    "[[",
    "]]",
    "{",
    "}",
    "=",
    ",",
    "\n",
    "\"",
    "'''",
    "#",
    ".",
    "nan",
    "-inf",
    "1e308",
    "-0.0",
    "1e-320",
    "0x7fffffffffffffff",
    "9223372036854775807",
    "true",
    "[sphere]",
    "[[mesh]]\n",
    "[[sphere.mesh]]\n",
    "grid = { count = [9, 9, 9], step = [0, 0, 0] }\n",
    "scale = [1, 2, 3]\n",
    "file = \"../x.obj\"\n",
    "detail = 4\n",
    "velocity = [1e15, 0, 0]\n",
    "[integrator]\nsamples = 9\n",
    "bounces = 65\n",
    "strategy = \"lights\"\n",
    "aperture = 1e15\n",
    "focus = 1e-15\n",
    "occlusion = 0.5\n",
    "[environment]\ncolor = [1, 1, 1]\n",
    "file = \"sky.exr\"\n",
    "intensity = 1e15\n",
    "turn = -1e15\n",
    "[fog]\ndensity = 1\n",
    "kind = \"sphere\"\n",
    "kind = \"disk\"\nposition = [0, 0, 0]\n",
    "[[light]]\nkind = \"rectangle\"\ncorner = [0, 0, 0]\nright = [1, 0, 0]\nup = [0, 1, 0]\n",
    "shadow = false\n",
    "mirror = 1\n",
    "roughness = 0.5\n",
    "ior = 1.5\n",
    "absorption = [1, 2, 3]\n",
    "emission = [1e15, 0, 0]\n",
    "texture = { checker = [0, 0.5, 1], repeat = [1e-15, 1e15] }\n",
    "texture = { file = \"a.png\" }\n",
    "alpha = \"cutout\"\n",
    "\u{feff}",
    "\u{0}",
    "é",
    "1979-05-27",
];

/// Small enough that no mutation asks for much.
fn policy() -> Policy {
    Policy {
        max_shapes: 2000,
        max_primitives: 20_000,
        ..Policy::default()
    }
}

fn survives(text: &str) {
    match parse_str(text, "garbage.toml", Path::new("no-such-folder"), &policy()) {
        Ok(loaded) => loaded.scene.validate().expect("what loads is valid"),
        Err(Error::Scene(faults)) => {
            assert!(!faults.faults.is_empty());
            for fault in &faults.faults {
                let underlined = faults.source_code.inner().get(fault.span.clone());
                assert!(underlined.is_some(), "{fault:?}");
            }
            let mut shown = String::new();
            miette::GraphicalReportHandler::new_themed(miette::GraphicalTheme::none())
                .render_report(&mut shown, &Error::Scene(faults))
                .expect("it renders");
        }
        Err(other) => panic!("{other}"),
    }
}

/// Replaces a stretch of a scene, moved to the nearest character boundaries.
fn mutate(text: &mut String, at: usize, length: usize, piece: &str) {
    let floor = |text: &str, at: usize| (0..=at).rev().find(|&i| text.is_char_boundary(i));
    let from = floor(text, at % (text.len() + 1)).unwrap_or(0);
    let to = floor(text, (from + length).min(text.len())).unwrap_or(from);
    text.replace_range(from..to.max(from), piece);
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(400))]

    #[test]
    fn random_text_is_refused_or_valid(text in "(?s).{0,200}") {
        survives(&text);
    }

    #[test]
    fn random_tokens_are_refused_or_valid(
        tokens in prop::collection::vec(prop::sample::select(&PIECES[..]), 0..60)
    ) {
        survives(&tokens.concat());
        survives(&tokens.join(" "));
    }

    #[test]
    fn mutated_scenes_are_refused_or_valid(
        scene in prop::sample::select(&SCENES[..]),
        edits in prop::collection::vec(
            (any::<usize>(), 0usize..12, prop::sample::select(&PIECES[..])),
            1..6,
        ),
    ) {
        let mut text = scene.to_owned();
        for (at, length, piece) in edits {
            mutate(&mut text, at, length, piece);
        }
        survives(&text);
    }

    #[test]
    fn scenes_cut_short_are_refused_or_valid(
        scene in prop::sample::select(&SCENES[..]),
        at in any::<prop::sample::Index>(),
    ) {
        survives(&scene[..at.index(scene.len())]);
    }

    #[test]
    fn any_f64_as_radius_is_refused_or_valid(bits in any::<u64>()) {
        let radius = f64::from_bits(bits);
        let text = format!(
            "camera = {{ eye = [0, 0, 5], target = [0, 0, 0] }}\n[[sphere]]\nradius = {radius:e}\n"
        )
        .replace("NaN", "nan");
        let kept = parse_str(&text, "radius.toml", Path::new("."), &policy()).is_ok();
        prop_assert_eq!(kept, (1e-15..=1e15).contains(&radius), "{}", text);
    }
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(50))]

    #[test]
    fn random_bytes_in_a_file_are_refused(bytes in prop::collection::vec(any::<u8>(), 1..300)) {
        let folder = tempfile::tempdir().expect("a temporary folder");
        let path = folder.path().join("bytes.toml");
        std::fs::write(&path, &bytes).expect("written");
        // 300 random bytes do not hold a camera.
        prop_assert!(load(&path, &policy()).is_err());
    }
}
