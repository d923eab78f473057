//! What a scene's pictures take: which effects and why, which shader files, buffers and words.

use serde::Serialize;

use crate::bounds::Bounds;
use crate::effects::{
    DIVIDE_NATIVE, Device, EFFECTS, Effect, EffectSet, Entry, Fetch, Part, select_files,
    takes_samples,
};
use crate::error::{Error, Result};
use crate::flat::Counts;
use crate::gpu::program::{Access, Program, Source};
use crate::kernel::real::Real;
use crate::render::{Accuracy, Settings, bounded};
use crate::scene::Scene;
use crate::tier::{Bounded, Double, Extended, Formulas, Robust, Textbook, Width};

/// Of pictures that are made of one ray through each pixel.
pub const RAYS: &str = "rays";

/// Of pictures that are made of paths of light.
pub const PATHS: &str = "paths";

/// What a scene's pictures are made of: [`RAYS`] or [`PATHS`].
pub fn traced(counts: &Counts, forced: EffectSet) -> &'static str {
    if takes_samples(counts, forced) {
        PATHS
    } else {
        RAYS
    }
}

/// What a scene's pictures take.
#[derive(Debug, Clone, PartialEq, Serialize)]
pub struct ScenePlan {
    /// All effects, in the order of the table.
    pub effects: Vec<PlannedEffect>,
    /// What the pictures are made of: [`RAYS`] or [`PATHS`].
    pub traced: &'static str,
    /// The shader files that are in.
    pub files: Vec<&'static str>,
    /// Those of effects that are left out.
    pub files_left_out: Vec<&'static str>,
    /// The buffers that the shader binds.
    pub bindings: Vec<PlannedBinding>,
    /// 32-bit words of the shader's SPIR-V.
    pub shader_words: usize,
    /// The same with all effects, those of other volumes not among them.
    pub full_shader_words: usize,
}

/// An effect, on or off.
#[derive(Debug, Clone, PartialEq, Serialize)]
pub struct PlannedEffect {
    /// Its name.
    pub name: &'static str,
    /// Whether it is in.
    pub on: bool,
    /// Why.
    pub reason: String,
    /// Whether the scene can do without it, see [`crate::effects::without`].
    #[serde(skip)]
    pub is_removable: bool,
}

/// A buffer that the shader binds.
#[derive(Debug, Clone, PartialEq, Eq, Serialize)]
pub struct PlannedBinding {
    /// The variable's name.
    pub name: String,
    /// Its `@group`.
    pub group: u32,
    /// Its `@binding`.
    pub binding: u32,
    /// How it is used.
    pub access: &'static str,
    /// The effect that brings it; none for what each picture needs.
    pub effect: Option<&'static str>,
}

/// Plans the pictures of a scene; as the shaders are on a device that divides as it should and
/// reads from storage buffers.
///
/// # Errors
///
/// The faults of the scene; [`Error::Shader`] is a defect.
pub fn plan(scene: &Scene, settings: Settings) -> Result<ScenePlan> {
    scene.validate()?;
    match settings.accuracy {
        Accuracy::Textbook => plan_in::<Textbook>(scene, settings),
        Accuracy::Robust => plan_in::<Robust>(scene, settings),
        Accuracy::Extended => plan_in::<Extended>(scene, settings),
        Accuracy::Double => plan_in::<Double>(scene, settings),
        Accuracy::Adaptive => {
            let flat = bounded::<Robust>(scene, settings);
            if takes_samples(&flat.counts(), settings.forced) {
                plan_in::<Double>(scene, settings)
            } else {
                plan_in::<Bounded>(scene, settings)
            }
        }
    }
}

fn plan_in<R: Real>(scene: &Scene, settings: Settings) -> Result<ScenePlan> {
    let flat = bounded::<R>(scene, settings);
    let counts = flat.counts();
    let samples = takes_samples(&counts, settings.forced);
    let device = device_of(R::FORMULAS, R::WIDTH, samples);
    let is_on = |effect: &Effect| effect.is_called_for(&counts) || settings.forced.has(effect);
    let files = select_files(is_on, device);
    let program = Program::in_width(&files, R::WIDTH)?;
    Ok(ScenePlan {
        effects: EFFECTS
            .iter()
            .map(|effect| planned(effect, scene, &counts, settings, device.entry))
            .collect(),
        traced: traced(&counts, settings.forced),
        files_left_out: left_out(&files, device.entry),
        files: names_of(&files),
        bindings: bindings_of(&program),
        shader_words: program.spirv.len(),
        full_shader_words: full_words::<R>(&counts)?,
    })
}

fn device_of(formulas: Formulas, width: Width, samples: bool) -> Device {
    Device {
        count: false,
        formulas,
        width,
        entry: if samples { Entry::Samples } else { Entry::Tile },
        divide: DIVIDE_NATIVE,
        fetch: Fetch::Storage,
    }
}

/// The words with all effects that may be forced, and the scene's own volumes.
fn full_words<R: Real>(counts: &Counts) -> Result<usize> {
    let all = EffectSet::all();
    let is_on = |effect: &Effect| effect.is_called_for(counts) || all.has(effect);
    let files = select_files(is_on, device_of(R::FORMULAS, R::WIDTH, true));
    Ok(Program::in_width(&files, R::WIDTH)?.spirv.len())
}

fn planned(
    effect: &Effect,
    scene: &Scene,
    counts: &Counts,
    settings: Settings,
    entry: Entry,
) -> PlannedEffect {
    let called_for = effect.is_called_for(counts);
    // Paths do not go through the one point of a pixel that its tile was asked about.
    let concerns = !(effect.part == Part::Screen && entry == Entry::Samples);
    let reason = match (called_for, effect.part) {
        (true, Part::Screen) if !concerns => {
            "no use to paths of light, which go through the list of spheres".into()
        }
        (true, Part::Bounds | Part::Screen) => of_bounds(settings.bounds),
        (true, _) => effect
            .cause(scene)
            .map_or_else(|| "the scene".into(), |cause| cause.to_string()),
        (false, _) if settings.forced.has(effect) => {
            "forced; the scene does not call for it".into()
        }
        (false, Part::Bounds | Part::Screen) => format!("not with {}", of_bounds(settings.bounds)),
        (false, _) => "nothing in the scene calls for it".into(),
    };
    PlannedEffect {
        name: effect.name,
        on: concerns && called_for || settings.forced.has(effect),
        reason,
        is_removable: effect.is_removable(),
    }
}

fn of_bounds(bounds: Bounds) -> String {
    format!("bounds `{}`", bounds.name())
}

fn names_of(files: &[Source]) -> Vec<&'static str> {
    let mut names: Vec<&'static str> = Vec::new();
    for file in files {
        if !names.contains(&file.name) {
            names.push(file.name);
        }
    }
    names
}

/// The files of all effects that are not in, stubs not among them.
fn left_out(files: &[Source], entry: Entry) -> Vec<&'static str> {
    let present = names_of(files);
    let all: Vec<Source> = EFFECTS
        .iter()
        .flat_map(|effect| effect.all_files(entry))
        .collect();
    let mut names = names_of(&all);
    names.retain(|name| !present.contains(name));
    names
}

fn bindings_of(program: &Program) -> Vec<PlannedBinding> {
    let of_effect = |name: &str| {
        let mut brings = EFFECTS
            .iter()
            .filter(|effect| effect.bindings.contains(&name));
        brings.next().map(|effect| effect.name)
    };
    let bindings = program.bindings.iter().map(|binding| PlannedBinding {
        name: binding.name.clone(),
        group: binding.group,
        binding: binding.binding,
        access: match binding.access {
            Access::Uniform => "uniform",
            Access::Read => "read",
            Access::Write => "read and written",
            Access::Texture => "texture",
        },
        effect: of_effect(&binding.name),
    });
    bindings.collect()
}

impl ScenePlan {
    /// The effects that are on.
    pub fn on(&self) -> impl Iterator<Item = &PlannedEffect> {
        self.effects.iter().filter(|effect| effect.on)
    }

    /// The effect of a name.
    ///
    /// # Errors
    ///
    /// [`Error::Usage`] where there is none.
    pub fn effect(&self, name: &str) -> Result<&PlannedEffect> {
        let found = self.effects.iter().find(|effect| effect.name == name);
        found.ok_or_else(|| Error::Usage(format!("no effect is named `{name}`")))
    }
}
