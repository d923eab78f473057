//! `rayproof mesh`.

use super::Outcome;
use super::flags::{Common, MeshArguments};
use super::report::{self, table};
use rayproof::error::{Error, Result};
use rayproof::frame;
use rayproof::scene::mesh::{build, write_obj};

/// Writes a built-in mesh as an OBJ file.
pub(super) fn run(arguments: &MeshArguments, common: &Common) -> Result<Outcome> {
    frame::check_writable(&arguments.output)?;
    let detail = arguments.detail.unwrap_or(arguments.name.default_detail());
    let mesh = build(arguments.name, detail);
    let mut text = Vec::new();
    write_obj(&mesh, arguments.name.name(), &mut text).map_err(|source| Error::Output {
        path: arguments.output.clone(),
        source,
    })?;
    frame::write_atomically(&arguments.output, &text)?;
    let figures = serde_json::json!({
        "mesh": arguments.name.name(),
        "file": arguments.output.display().to_string(),
        "triangles": mesh.triangles.len(),
        "vertices": mesh.positions.len(),
        "bytes": text.len(),
    });
    if common.json {
        report::print(&report::json(&figures))?;
    } else if !common.quiet {
        report::print(&table(&[
            ("mesh", arguments.name.name().to_string()),
            ("file", arguments.output.display().to_string()),
            ("triangles", mesh.triangles.len().to_string()),
            ("vertices", mesh.positions.len().to_string()),
        ]))?;
    }
    Ok(Outcome::Done)
}
