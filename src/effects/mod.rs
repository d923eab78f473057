//! What a scene calls for, and which shader files that brings in.
//!
//! What a scene does not call for is not in its shader: not branched over but absent, its
//! bindings too. [`table`] is the only place that knows; nothing else in the program asks
//! whether an effect is on.

mod cause;
mod device;
mod files;
mod removal;
mod set;
pub mod table;

pub use cause::Cause;
pub use device::{DIVIDE_CORRECTED, DIVIDE_NATIVE, Device, Entry, Fetch};
pub use files::{select_files, shader_files};
pub use removal::without;
pub use set::EffectSet;
pub use table::EFFECTS;

use crate::flat::Counts;
use crate::gpu::program::Source;
use crate::scene::Scene;

/// The shader file of a name, with its text.
macro_rules! file {
    ($name:literal) => {
        $crate::gpu::program::Source::new($name, include_str!(concat!("../../shaders/", $name)))
    };
}
use file;

/// A part of the shader that only some scenes need.
pub struct Effect {
    /// The name for people.
    pub name: &'static str,
    /// What kind of part it is.
    pub part: Part,
    /// Whether the scene calls for it.
    called_for: fn(&Counts) -> bool,
    /// The shader files with it.
    on: &'static [Source],
    /// The shader files without it: the same functions, doing nothing.
    off: &'static [Source],
    /// Those that paths of light need besides, with it and without.
    along_paths: [&'static [Source]; 2],
    /// The buffers that it brings, by the names of the shader's variables.
    pub bindings: &'static [&'static str],
    /// What in a scene calls for it; none for volumes, which the settings ask for.
    cause: Option<fn(&Scene) -> Option<Cause>>,
    /// Takes what calls for it out of a scene; none for shapes, and for volumes.
    removal: Option<fn(&mut Scene)>,
}

/// What kind of part of the shader an effect is.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Part {
    /// Primitives of a kind.
    Primitives,
    /// Bounding volumes of a kind: what `--bounds` chooses.
    Bounds,
    /// The screen, divided among the volumes: no use to rays that do not go through a pixel's
    /// one point.
    Screen,
    /// Light, or what a surface looks like, in every picture.
    Light,
    /// Light by way of further rays, or by many samples: pictures that have such an effect
    /// are made of samples, by a path each.
    Path,
}

impl Effect {
    const fn new(
        name: &'static str,
        part: Part,
        called_for: fn(&Counts) -> bool,
        on: &'static [Source],
        off: &'static [Source],
    ) -> Self {
        Self {
            name,
            part,
            called_for,
            on,
            off,
            along_paths: [&[], &[]],
            bindings: &[],
            cause: None,
            removal: None,
        }
    }

    /// With further files for paths of light.
    const fn along_paths(self, on: &'static [Source], off: &'static [Source]) -> Self {
        Self {
            along_paths: [on, off],
            ..self
        }
    }

    /// With buffers of its own.
    const fn binding(self, bindings: &'static [&'static str]) -> Self {
        Self { bindings, ..self }
    }

    /// With what calls for it.
    const fn caused_by(self, cause: fn(&Scene) -> Option<Cause>) -> Self {
        let cause = Some(cause);
        Self { cause, ..self }
    }

    /// With how what calls for it is taken out of a scene.
    const fn removed_by(self, removal: fn(&mut Scene)) -> Self {
        let removal = Some(removal);
        Self { removal, ..self }
    }

    /// The shader files with the effect, or without it, as an entry needs them.
    pub fn files(&self, on: bool, entry: Entry) -> impl Iterator<Item = Source> {
        let samples = entry == Entry::Samples;
        let concerns = samples || self.part != Part::Path;
        let on = on && !(samples && self.part == Part::Screen);
        let everywhere = if on { self.on } else { self.off };
        let along = self.along_paths[usize::from(!on)];
        let along: &[Source] = if samples { along } else { &[] };
        let files = everywhere.iter().chain(along).copied();
        files.filter(move |_| concerns)
    }

    /// What in the scene calls for it.
    pub fn cause(&self, scene: &Scene) -> Option<Cause> {
        self.cause.and_then(|cause| cause(scene))
    }

    /// Whether what calls for it can be taken out of a scene.
    pub fn is_removable(&self) -> bool {
        self.removal.is_some()
    }

    /// All its files for an entry that do something, whichever entries it concerns.
    pub fn all_files(&self, entry: Entry) -> impl Iterator<Item = Source> {
        let [along, _] = self.along_paths;
        let along: &[Source] = if entry == Entry::Samples { along } else { &[] };
        self.on.iter().chain(along).copied()
    }

    /// Whether it may be in a shader whose scene does not call for it: volumes may not, they
    /// would be searched.
    pub fn may_be_forced(&self) -> bool {
        !matches!(self.part, Part::Bounds | Part::Screen)
    }

    /// Whether a scene calls for it.
    pub fn is_called_for(&self, counts: &Counts) -> bool {
        (self.called_for)(counts)
    }
}

/// The names of the effects that the scene calls for, in a picture of samples or of one ray a
/// pixel.
pub fn effects_of(counts: &Counts, samples: bool) -> Vec<&'static str> {
    let is_of_use = |effect: &&Effect| !(samples && effect.part == Part::Screen);
    let on = EFFECTS.iter().filter(is_of_use);
    let on = on.filter(|effect| effect.is_called_for(counts));
    on.map(|effect| effect.name).collect()
}

/// The names of the effects that a scene calls for and that need paths of light.
pub fn path_effects_of(scene: &Scene) -> Vec<&'static str> {
    let paths = EFFECTS.iter().filter(|effect| effect.part == Part::Path);
    let on = paths.filter(|effect| effect.cause(scene).is_some());
    on.map(|effect| effect.name).collect()
}

/// Whether a scene's pictures are made of samples, by a path each, since an effect asks for
/// it that the scene calls for or that is forced.
pub fn takes_samples(counts: &Counts, forced: EffectSet) -> bool {
    let mut paths = EFFECTS.iter().filter(|effect| effect.part == Part::Path);
    paths.any(|effect| effect.is_called_for(counts) || forced.has(effect))
}
