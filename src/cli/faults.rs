//! The faults of a scene as records: for continuous integration and editors.

use miette::SourceCode;
use serde::Serialize;

use rayproof::error::{Error, Fault, SceneFaults};

/// A scene that does not load.
#[derive(Serialize)]
pub(super) struct Faulty {
    scene: String,
    faults: Vec<Record>,
}

/// One fault, where it stands and what would be right.
#[derive(Serialize)]
struct Record {
    file: String,
    /// Counted from 1; none where the whole file is at fault.
    line: Option<usize>,
    /// Counted from 1.
    column: Option<usize>,
    message: String,
    help: Option<String>,
}

impl Faulty {
    /// What is wrong with a scene; none where the scene is not to blame.
    pub(super) fn of(scene: String, error: &Error) -> Option<Self> {
        let faults = match error {
            Error::Scene(scene) => scene.faults.iter().map(|f| record(scene, f)).collect(),
            Error::Asset {
                path,
                line,
                message,
            } => vec![Record {
                file: path.display().to_string(),
                line: *line,
                column: None,
                message: message.clone(),
                help: None,
            }],
            _ => return None,
        };
        Some(Self { scene, faults })
    }
}

fn record(scene: &SceneFaults, fault: &Fault) -> Record {
    // The same count of lines and columns as under the printed message.
    let place = scene
        .source_code
        .read_span(&fault.span.clone().into(), 0, 0)
        .ok();
    Record {
        file: scene.source_code.name().to_string(),
        line: place.as_ref().map(|place| place.line() + 1),
        column: place.as_ref().map(|place| place.column() + 1),
        message: fault.message.clone(),
        help: fault.help.clone(),
    }
}
