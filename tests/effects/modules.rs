//! The module of every effect alone, of every pair and of all at once is valid, and binds what
//! the table says and nothing else.

use std::collections::BTreeSet;

use rayon::prelude::*;
use rayproof::effects::{DIVIDE_NATIVE, Device, EFFECTS, Effect, Entry, Fetch, Part, select_files};
use rayproof::gpu::program::Program;
use rayproof::tier::{Formulas, Width};

/// What is bound whatever a scene calls for.
const OF_RAYS: [&str; 7] = [
    "dispatch",
    "camera",
    "surroundings",
    "tables",
    "hits",
    "pixels",
    "scene",
];
const OF_PATHS: [&str; 8] = [
    "dispatch",
    "camera",
    "surroundings",
    "tables",
    "pixels",
    "tallies",
    "sampling",
    "scene",
];

/// Two effects, twice the same, or all of them.
type Choice = Option<[&'static str; 2]>;

/// Every effect alone, every pair, and all.
fn choices() -> Vec<Choice> {
    let mut choices = vec![None];
    for (index, one) in EFFECTS.iter().enumerate() {
        choices.extend(
            EFFECTS[index..]
                .iter()
                .map(|other| Some([one.name, other.name])),
        );
    }
    choices
}

fn is_chosen(choice: Choice, effect: &Effect) -> bool {
    choice.is_none_or(|names| names.contains(&effect.name))
}

fn program_of(choice: Choice, entry: Entry) -> Program {
    let device = Device {
        count: false,
        formulas: Formulas::Stable,
        width: Width::Single,
        entry,
        divide: DIVIDE_NATIVE,
        fetch: Fetch::Storage,
    };
    let files = select_files(|effect| is_chosen(choice, effect), device);
    Program::build(&files).unwrap_or_else(|error| panic!("{choice:?}: {error}"))
}

/// What the table has the module bind: some of it only together with other effects.
fn allowed(choice: Choice, entry: Entry) -> BTreeSet<&'static str> {
    let chosen = EFFECTS.iter().filter(|effect| is_chosen(choice, effect));
    let of_entry: &[&str] = match entry {
        Entry::Samples => &OF_PATHS,
        _ => &OF_RAYS,
    };
    let brought = chosen.flat_map(|effect| effect.bindings);
    of_entry.iter().chain(brought).copied().collect()
}

#[test]
fn every_module_is_valid_and_binds_what_the_table_says() {
    let choices = choices();
    assert_eq!(choices.len(), 1 + EFFECTS.len() * (EFFECTS.len() + 1) / 2);
    choices.into_par_iter().for_each(|choice| {
        for entry in [Entry::Tile, Entry::Samples] {
            let of_paths = |effect: &&Effect| effect.part == Part::Path;
            let has_paths = EFFECTS
                .iter()
                .filter(of_paths)
                .any(|e| is_chosen(choice, e));
            if has_paths && entry == Entry::Tile {
                continue;
            }
            let program = program_of(choice, entry);
            let bound: BTreeSet<&str> = program.bindings.iter().map(|b| b.name.as_str()).collect();
            let allowed = allowed(choice, entry);
            let surplus: Vec<_> = bound.difference(&allowed).collect();
            assert!(surplus.is_empty(), "{choice:?} {entry:?}: {surplus:?}");
            // All that it needs is there: each of its effects binds its own buffers.
            let chosen = EFFECTS.iter().filter(|effect| is_chosen(choice, effect));
            for effect in chosen.filter(|effect| is_read(effect, entry)) {
                for name in effect.bindings {
                    assert!(bound.contains(name), "{choice:?} does not bind {name}");
                }
            }
        }
    });
}

/// Whether an effect is there at all in an entry.
fn is_read(effect: &Effect, entry: Entry) -> bool {
    entry == Entry::Samples && effect.part == Part::Path || effect.part == Part::Light
}

/// The control: a module with an effect too many binds what it should not.
#[test]
fn a_surplus_effect_is_noticed() {
    let brings = |effect: &&Effect| effect.part == Part::Path && !effect.bindings.is_empty();
    for effect in EFFECTS.iter().filter(brings) {
        let program = program_of(Some([effect.name, effect.name]), Entry::Samples);
        let allowed = allowed(Some(["spheres", "spheres"]), Entry::Samples);
        let is_surplus = |name: &str| !allowed.contains(name);
        assert!(
            program
                .bindings
                .iter()
                .any(|binding| is_surplus(&binding.name)),
            "{} brings nothing",
            effect.name
        );
    }
}

/// The module of the 2017 report's spheres, as it was before there were paths of light: no
/// word and no binding more. SPIR-V words of naga 30.
#[test]
fn the_seed_pays_for_nothing() {
    const WORDS: usize = 9619;
    const BINDINGS: usize = 7;
    let scene = rayproof::scene::Scene::load("assets/scenes/seed-spheres.toml").unwrap();
    let plan = rayproof::plan::plan(&scene, rayproof::render::Settings::default()).unwrap();
    assert!(plan.shader_words <= WORDS, "{} words", plan.shader_words);
    assert!(plan.bindings.len() <= BINDINGS, "{:?}", plan.bindings);
    assert_eq!(plan.traced, "rays");
    // The control: one effect that is forced in, and there is more of it.
    let forced = rayproof::effects::EffectSet::of(["smooth normals", "triangles"]).unwrap();
    let settings = rayproof::render::Settings {
        forced,
        ..Default::default()
    };
    let more = rayproof::plan::plan(&scene, settings).unwrap();
    assert!(more.shader_words > WORDS);
}
