//! rayproof: a headless GPU ray tracer whose pictures can be trusted.
//!
//! The way of the data, and the order in which to read the modules: a scene file
//! becomes a [`scene`] (f64, validated); [`effects`] says what it calls for;
//! [`mod@flatten`] turns it into plain arrays, the same bytes for both tracers;
//! [`gpu`] or [`cpu`] traces them, the one with the shaders, the other with the
//! [`kernel`], their twin; the result is a [`frame`], and [`compare`] says how two
//! of them differ. The [`oracle`] says what would be exact, [`accuracy`] how far each tier
//! is from it, [`why`] what a single pixel shows, [`stability`] where ray tracers break;
//! [`report`] draws what was measured.
//!
//! # Example
//!
//! ```
//! use rayproof::{Accuracy, Backend, Scene, Tolerance, Unwatched, compare_frames, render};
//!
//! let scene = Scene::load("assets/scenes/shapes.toml")?.with_size(64, 64);
//! let on_gpu = render(&scene, &Backend::auto()?, Accuracy::Robust, &Unwatched)?;
//! let on_cpu = render(&scene, &Backend::Cpu(None), Accuracy::Robust, &Unwatched)?;
//! let comparison = compare_frames(&on_gpu.frame, &on_cpu.frame, &Tolerance::default())?;
//! assert_eq!(comparison.different_pixels, 0);
//! # Ok::<(), rayproof::Error>(())
//! ```

pub mod accuracy;
pub mod bounds;
mod color;
pub mod compare;
pub mod count;
pub mod cpu;
pub mod effects;
pub mod error;
pub mod flat;
pub mod flatten;
pub mod found;
pub mod frame;
pub mod gpu;
pub mod kernel;
pub mod layout;
pub mod measure;
pub mod oracle;
pub mod paths;
pub mod plan;
mod ramp;
pub mod random;
pub mod render;
pub mod report;
pub mod samples;
pub mod scene;
pub mod stability;
pub mod tier;
pub mod watch;
pub mod why;

pub use compare::{Comparison, Tolerance, compare_frames};
pub use error::{Error, Result};
pub use frame::{Frame, Layer};
pub use render::{Accuracy, Backend, Rendering, render};
pub use scene::Scene;
pub use watch::{Unwatched, Watch};
