//! An effect that is compiled in, but not called for: the picture is the same, bit for bit.

use super::device::Gpu;
use super::portions::Portions;
use super::program::Source;
use super::sampled::Sampled;
use crate::bounds::{Bounds, bound};
use crate::effects::{EFFECTS, Entry};
use crate::flat::Flat;
use crate::flatten::flatten;
use crate::frame::Frame;
use crate::kernel::real::Real;
use crate::samples::{Enough, take_samples};
use crate::scene::{Light, Scene};
use crate::tier::Extended;
use crate::watch::Unwatched;

/// Puts the files of an effect in place of those that stand for its absence.
fn force(files: &mut Vec<Source>, name: &str) {
    let effect = EFFECTS.iter().find(|effect| effect.name == name).unwrap();
    let count = files.len();
    for on in effect.files(true, Entry::Samples) {
        let stem = on.name.strip_suffix("_on.wgsl");
        let off = stem.map(|stem| format!("{stem}_off.wgsl"));
        files.retain(|file| Some(file.name) != off.as_deref());
        files.push(on);
    }
    assert!(files.len() <= count + 3, "readers of absent shapes at most");
}

fn picture<R: Real>(gpu: &Gpu, flat: &Flat<R>, change: &dyn Fn(&mut Vec<Source>)) -> Frame {
    let mut sampler = Sampled::changed(gpu, flat, Portions::default(), change).unwrap();
    let mut frame = Frame::new(flat.size[0], flat.size[1]).unwrap();
    let enough = Enough::default();
    take_samples(
        &mut sampler,
        &mut frame,
        flat.samples,
        enough,
        &Unwatched,
        None,
    )
    .unwrap();
    frame
}

fn check<R: Real>(gpu: &Gpu) {
    let file = format!("{}/assets/scenes/shapes.toml", env!("CARGO_MANIFEST_DIR"));
    let mut scene = Scene::load(file).unwrap().with_size(40, 30);
    scene.integrator.samples = 2;
    for light in &mut scene.lights {
        if let Light::Point { shadow, .. } | Light::Directional { shadow, .. } = light {
            *shadow = true;
        }
    }
    for bounds in [Bounds::None, Bounds::Tree] {
        let mut flat = flatten::<R>(&scene);
        bound(&mut flat, bounds);
        let without = picture(gpu, &flat, &|_| {});
        for name in ["depth of field", "motion blur"] {
            let with = picture(gpu, &flat, &|files| force(files, name));
            assert!(with.has_bits_of(&without), "{name}");
        }
        // The control: called for, it changes the picture.
        flat.camera_velocity = [0.1, 0.0, 0.0];
        let moving = picture(gpu, &flat, &|files| force(files, "motion blur"));
        assert!(!moving.has_bits_of(&without));
    }
}

#[test]
fn what_is_not_called_for_changes_no_bit() {
    let gpu = Gpu::open(None).unwrap();
    check::<f32>(&gpu);
    check::<Extended>(&gpu);
}
