//! The command line: a thin layer over the library.
//!
//! [`flags`] declares the flags and turns them into checked options; one file
//! for each command does the work; [`report`] says how it went.

mod accuracy;
mod bench;
mod check;
mod compare;
mod doctor;
mod effect_flags;
mod faults;
mod flags;
mod memory;
mod mesh;
mod paths;
mod plan;
mod plan_flags;
mod progress;
mod render;
mod report;
mod shown;
mod stability;
mod tracing_flags;
mod until_flags;
mod why;

use std::process::ExitCode;

use clap::Parser;

use self::flags::{Cli, Command};
use rayproof::error::Result;

/// How a command ended that met no error.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
enum Outcome {
    /// Exit code 0.
    Done,
    /// A comparison fell short: exit code 1.
    FellShort,
}

/// Parses the command line, runs the command and gives the exit code.
pub fn main() -> ExitCode {
    let cli = match Cli::try_parse() {
        Ok(cli) => cli,
        Err(error) => return report::usage(&error),
    };
    report::quiet_drivers();
    report::format_errors();
    report::start_logging(&cli.common);
    progress::watch_for_interrupts();
    // Not by returning: dropping a device that hangs would hang as well.
    std::process::exit(i32::from(report::exit_code(run(&cli))))
}

fn run(cli: &Cli) -> Result<Outcome> {
    match &cli.command {
        Command::Render(arguments) => render::run(arguments, &cli.common),
        Command::Compare(arguments) => compare::run(arguments, &cli.common),
        Command::Bench(arguments) => bench::run(arguments, &cli.common),
        Command::Accuracy(arguments) => accuracy::run(arguments, &cli.common),
        Command::Stability(arguments) => stability::run(arguments, &cli.common),
        Command::Plan(arguments) => plan::run(arguments, &cli.common),
        Command::Why(arguments) => why::run(arguments, &cli.common),
        Command::Check(arguments) => check::run(arguments, &cli.common),
        Command::Doctor => doctor::run(&cli.common),
        Command::Mesh(arguments) => mesh::run(arguments, &cli.common),
    }
}
