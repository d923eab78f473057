//! `rayproof why`.

pub(super) mod flags;
mod text;

use serde::Serialize;

use self::flags::WhyArguments;
use super::Outcome;
use super::flags::Common;
use super::paths::warn_of_paths;
use super::progress::Progress;
use super::report;
use rayproof::error::Result;
use rayproof::why::{Why, explain};

/// The facts, with the scene's name.
#[derive(Serialize)]
struct Named<'a> {
    scene: String,
    #[serde(flatten)]
    why: &'a Why,
}

/// Explains a pixel.
pub(super) fn run(arguments: &WhyArguments, common: &Common) -> Result<Outcome> {
    let bounds = arguments.bounds()?;
    let scene = arguments
        .policy
        .load_scene(&arguments.scene, arguments.size)?;
    warn_of_paths(&scene, "`why` explains");
    let name = arguments.scene.display().to_string();
    let progress = Progress::new(common, name.clone());
    let why = explain(&scene, bounds, arguments.x, arguments.y, &progress)?;
    drop(progress);
    if common.json {
        let named = Named {
            scene: name,
            why: &why,
        };
        report::print(&report::json(&named))?;
    } else if !common.quiet {
        report::print(&text::explained(&name, &why, common.verbose > 0))?;
    }
    Ok(Outcome::Done)
}
