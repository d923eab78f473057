//! The flags that say how often what is measured is run.

use clap::Args;

use rayproof::measure::Plan;

/// Runs at most; more would only heat the machine.
const MOST_RUNS: i64 = 10_000;

#[derive(Debug, Args)]
pub(super) struct PlanFlags {
    /// Runs of each configuration that count, interleaved
    #[arg(long, value_name = "N", default_value_t = 5,
          value_parser = clap::value_parser!(u32).range(1..=MOST_RUNS))]
    runs: u32,
    /// Runs of each configuration before those
    #[arg(long, value_name = "N", default_value_t = 1,
          value_parser = clap::value_parser!(u32).range(0..=MOST_RUNS))]
    warmup: u32,
    /// Seconds after which a configuration is run no more, and told from what it has
    #[arg(long, value_name = "SECONDS", default_value_t = 60.0, value_parser = parse_seconds)]
    budget: f64,
}

impl PlanFlags {
    /// How often to run.
    pub(super) fn plan(&self) -> Plan {
        Plan {
            warm_ups: self.warmup,
            runs: self.runs,
            budget: self.budget,
        }
    }
}

pub(super) fn parse_seconds(text: &str) -> Result<f64, String> {
    match text.parse() {
        Ok(seconds) if (0.0..f64::INFINITY).contains(&seconds) => Ok(seconds),
        _ => Err(format!("`{text}` is not a number of seconds")),
    }
}
