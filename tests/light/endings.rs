//! When a picture of samples ends, and what is shown of it on the way.

use std::sync::atomic::{AtomicU32, Ordering};
use std::time::Duration;

use rayproof::render::{Backend, Until, render_until};
use rayproof::samples::{Enough, Preview};
use rayproof::{Accuracy, Error, Frame, Rendering, Result, Scene, Unwatched, Watch};

use crate::common::{assert_same_bits, gpu};
use crate::scenes::{picture, room};

fn backends() -> [Backend; 2] {
    [Backend::Cpu(None), Backend::Gpu(Box::new(gpu()))]
}

fn until(
    scene: &Scene,
    backend: &Backend,
    watch: &dyn Watch,
    until: Until<'_>,
) -> Result<Rendering> {
    render_until(scene, backend, Accuracy::Robust, watch, until)
}

fn with_noise(scene: &Scene, backend: &Backend, noise: f64) -> Rendering {
    let enough = Enough {
        noise: Some(noise),
        ..Enough::default()
    };
    let wanted = Until {
        enough,
        ..Until::default()
    };
    until(scene, backend, &Unwatched, wanted).unwrap()
}

/// It ends at the first look at which the noise is no more, with as many samples on both
/// backends, and is the picture of so many samples.
#[test]
fn a_picture_ends_when_its_noise_is_low() {
    let scene = room(24, 4096, 2);
    let whole = |samples| {
        let scene = room(24, samples, 2);
        rayproof::render(&scene, &Backend::Cpu(None), Accuracy::Robust, &Unwatched).unwrap()
    };
    let wanted = 1.05 * whole(48).stats.noise.unwrap();
    let ends = backends().map(|backend| with_noise(&scene, &backend, wanted));
    for end in &ends {
        assert_eq!(end.stats.samples, 48);
        assert!(end.stats.noise.unwrap() <= wanted);
    }
    let of_as_many = whole(48);
    assert!(whole(32).stats.noise.unwrap() > wanted);
    assert_same_bits(&ends[0].frame, &ends[1].frame);
    assert_same_bits(&ends[0].frame, &of_as_many.frame);
    assert_eq!(ends[0].stats.noise, of_as_many.stats.noise);
    assert_eq!(ends[0].stats.noise, ends[1].stats.noise);
    // The controls: less noise takes more samples; all of them, where it is never reached.
    let more = with_noise(&scene, &Backend::Cpu(None), 0.8 * wanted);
    assert!(more.stats.samples > 48 && more.stats.samples.is_multiple_of(16));
    let few = with_noise(&room(24, 40, 2), &Backend::Cpu(None), 0.0);
    assert_eq!(few.stats.samples, 40);
}

/// Of a picture that would take hours, the first sample is there when its time is over.
#[test]
fn a_picture_ends_when_its_time_is_over() {
    let scene = room(48, 65_536, 4);
    for backend in backends() {
        let ended = |time| {
            let enough = Enough {
                time: Some(time),
                ..Enough::default()
            };
            let wanted = Until {
                enough,
                ..Until::default()
            };
            until(&scene, &backend, &Unwatched, wanted).unwrap()
        };
        let least = ended(Duration::ZERO);
        assert_eq!((least.stats.samples, least.stats.noise), (1, None));
        // More time, more samples, and each picture is the one of as many.
        let more = ended(Duration::from_millis(300));
        let samples = more.stats.samples;
        assert!((2..65_536).contains(&samples), "{samples}");
        assert_same_bits(&more.frame, &picture(&room(48, samples, 4), &backend));
    }
}

/// With no time in between it is shown after each sample but the last, each time as it would
/// be if it ended.
#[test]
fn a_picture_is_shown_on_its_way() {
    let scene = room(24, 8, 1);
    for backend in backends() {
        let mut shown: Vec<(Frame, u32)> = Vec::new();
        let mut show = |frame: &Frame, samples: u32| {
            shown.push((frame.clone(), samples));
            Ok(())
        };
        let wanted = Until {
            preview: Some(Preview {
                every: Duration::ZERO,
                show: &mut show,
            }),
            ..Until::default()
        };
        let made = until(&scene, &backend, &Unwatched, wanted).unwrap();
        let counts: Vec<u32> = shown.iter().map(|(_, samples)| *samples).collect();
        assert_eq!(counts, [1, 2, 3, 4, 5, 6, 7]);
        for (frame, samples) in &shown {
            assert_eq!((frame.width, frame.height), (24, 18));
            // A picture of one sample has it in the middle of the pixel.
            if *samples == 1 {
                continue;
            }
            let of_as_many = picture(&room(24, *samples, 1), &backend);
            assert_same_bits(frame, &of_as_many);
        }
        // What was shown is not in the picture.
        assert_same_bits(&made.frame, &picture(&scene, &backend));
        assert!(!made.frame.has_bits_of(&shown[6].0));
    }
}

/// Now and then only, where there is time in between.
#[test]
fn nothing_is_shown_before_its_time() {
    let mut show = |_: &Frame, _: u32| -> Result<()> { panic!("shown too early") };
    let wanted = Until {
        preview: Some(Preview {
            every: Duration::from_secs(3600),
            show: &mut show,
        }),
        ..Until::default()
    };
    until(&room(24, 4, 1), &Backend::Cpu(None), &Unwatched, wanted).unwrap();
}

/// What is wrong with the preview is what is wrong with the picture.
#[test]
fn a_preview_that_fails_ends_the_picture() {
    for backend in backends() {
        let mut calls = 0;
        let mut show = |_: &Frame, samples: u32| {
            calls += 1;
            if samples == 3 {
                return Err(Error::Usage("the window was closed".into()));
            }
            Ok(())
        };
        let wanted = Until {
            preview: Some(Preview {
                every: Duration::ZERO,
                show: &mut show,
            }),
            ..Until::default()
        };
        let error = until(&room(24, 8, 1), &backend, &Unwatched, wanted).unwrap_err();
        assert!(matches!(&error, Error::Usage(text) if text == "the window was closed"));
        assert_eq!(calls, 3);
    }
}

/// Asks to stop after so many questions whether to.
struct Patience {
    left: AtomicU32,
    told: AtomicU32,
}

impl Patience {
    fn of(questions: u32) -> Self {
        Self {
            left: AtomicU32::new(questions),
            told: AtomicU32::new(0),
        }
    }
}

impl Watch for Patience {
    fn progress(&self, done: f64) {
        assert!((0.0..=1.0).contains(&done), "{done}");
        self.told.fetch_add(1, Ordering::Relaxed);
    }

    fn cancelled(&self) -> bool {
        let left = &self.left;
        let less = |left: u32| left.checked_sub(1);
        left.fetch_update(Ordering::Relaxed, Ordering::Relaxed, less)
            .is_err()
    }
}

#[test]
fn a_picture_can_be_interrupted() {
    let scene = room(24, 65_536, 1);
    for backend in backends() {
        for questions in [0, 40] {
            let patience = Patience::of(questions);
            let error = until(&scene, &backend, &patience, Until::default()).unwrap_err();
            assert!(matches!(error, Error::Interrupted), "{error:?}");
            let told = patience.told.into_inner();
            assert!(told > 0 || questions == 0, "{told}");
        }
        // The control: enough patience.
        let patience = Patience::of(u32::MAX);
        until(&room(24, 4, 1), &backend, &patience, Until::default()).unwrap();
    }
}
