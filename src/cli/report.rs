//! What the user is told, and where: results on standard output, all else on
//! standard error.

use std::io::{ErrorKind, IsTerminal, Write};
use std::process::ExitCode;

use serde::Serialize;
use tracing_subscriber::filter::LevelFilter;

use super::Outcome;
use super::flags::Common;
use rayproof::error::{Error, Result};

/// The version of the JSON objects.
const SCHEMA: u32 = 1;

/// A JSON object with the schema's version in front.
#[derive(Serialize)]
struct Versioned<'a, T> {
    schema: u32,
    #[serde(flatten)]
    body: &'a T,
}

/// Prints a result to standard output. Who closes the pipe has seen enough.
///
/// # Errors
///
/// [`Error::Output`] when standard output takes no more.
pub(super) fn print(text: &str) -> Result<()> {
    let mut out = std::io::stdout().lock();
    match out.write_all(text.as_bytes()).and_then(|()| out.flush()) {
        Ok(()) => Ok(()),
        Err(error) if error.kind() == ErrorKind::BrokenPipe => std::process::exit(0),
        Err(source) => Err(Error::Output {
            path: "standard output".into(),
            source,
        }),
    }
}

/// A result as one JSON object, on a line of its own.
pub(super) fn json<T: Serialize>(body: &T) -> String {
    let object = Versioned {
        schema: SCHEMA,
        body,
    };
    // Plain structs of numbers and strings always serialise.
    serde_json::to_string_pretty(&object).unwrap_or_default() + "\n"
}

/// Two columns, the first as wide as it must be.
pub(super) fn table(rows: &[(&str, String)]) -> String {
    let width = rows.iter().map(|(name, _)| name.len()).max().unwrap_or(0);
    rows.iter()
        .map(|(name, value)| format!("{name:width$}  {value}\n"))
        .collect()
}

/// clap's own message and exit code: 0 for `--help`, 2 for wrong usage.
pub(super) fn usage(error: &clap::Error) -> ExitCode {
    let _ = error.print();
    ExitCode::from(if error.use_stderr() { 2 } else { 0 })
}

/// Prints an error, if there is one, and gives the exit code.
pub(super) fn exit_code(result: Result<Outcome>) -> u8 {
    match result {
        Ok(Outcome::Done) => 0,
        Ok(Outcome::FellShort) => 1,
        Err(error) => {
            let code = error.exit_code();
            // Nobody may be listening any more; the exit code still tells.
            let _ = writeln!(std::io::stderr(), "{:?}", miette::Report::new(error));
            code
        }
    }
}

/// Says how errors look: in whole lines, for a name that is broken in two is not
/// found by `grep`; and without the system's own message underneath, for ours
/// holds it.
pub(super) fn format_errors() {
    // Fails only if it was called before.
    let _ = miette::set_hook(Box::new(|_| {
        Box::new(
            miette::MietteHandlerOpts::new()
                .wrap_lines(false)
                .without_cause_chain()
                .build(),
        )
    }));
}

/// Keeps Mesa from remarks that tell a user nothing: that lavapipe claims no
/// conformance (the self-check looks closer), and that there is no desktop.
pub(super) fn quiet_drivers() {
    #[expect(unsafe_code, reason = "the environment is the only way to tell Mesa")]
    // SAFETY: called first in main, before any other thread exists.
    unsafe {
        std::env::set_var("MESA_VK_IGNORE_CONFORMANCE_WARNING", "1");
        if std::env::var_os("XDG_RUNTIME_DIR").is_none() {
            std::env::set_var("XDG_RUNTIME_DIR", std::env::temp_dir());
        }
    }
}

/// Sends the log to standard error.
pub(super) fn start_logging(common: &Common) {
    let level = match (common.quiet, common.verbose) {
        (true, _) => LevelFilter::ERROR,
        (false, 0) => LevelFilter::WARN,
        (false, 1) => LevelFilter::INFO,
        (false, _) => LevelFilter::DEBUG,
    };
    tracing_subscriber::fmt()
        .with_writer(std::io::stderr)
        .with_ansi(std::io::stderr().is_terminal())
        .with_max_level(level)
        .with_target(false)
        // It would panic where standard error is closed.
        .log_internal_errors(false)
        .without_time()
        .init();
}

/// Columns side by side, each as wide as it must be, flush right but the first.
pub(super) fn columns<const N: usize>(
    head: [&str; N],
    rows: impl Iterator<Item = [String; N]>,
) -> String {
    columns_of(
        head.map(str::to_string).to_vec(),
        rows.map(Vec::from).collect(),
    )
}

/// As [`columns`], as many as `head` has.
pub(super) fn columns_of(head: Vec<String>, rows: Vec<Vec<String>>) -> String {
    let count = head.len();
    let mut lines = vec![head];
    lines.extend(rows);
    let widths: Vec<usize> = (0..count)
        .map(|column| lines.iter().map(|l| l[column].len()).max().unwrap_or(0))
        .collect();
    let mut text = String::new();
    for line in &lines {
        let mut row = format!("{:<1$}", line[0], widths[0]);
        for (cell, width) in line.iter().zip(&widths).skip(1) {
            row += &format!("  {cell:>width$}");
        }
        text += row.trim_end();
        text += "\n";
    }
    text
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn columns_are_as_wide_as_they_must_be() {
        let rows = [["cpu", "10.25"], ["gpu no. 1", "-"]].map(|row| row.map(str::to_string));
        assert_eq!(
            columns(["backend", "ms"], rows.into_iter()),
            "backend       ms\n\
             cpu        10.25\n\
             gpu no. 1      -\n"
        );
    }
}
