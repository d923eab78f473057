//! Progress on standard error, and Ctrl-C.

use std::io::{IsTerminal, Write};
use std::sync::Mutex;
use std::sync::atomic::{AtomicBool, AtomicU32, Ordering};
use std::time::{Duration, Instant};

use indicatif::{ProgressBar, ProgressDrawTarget, ProgressStyle};

use super::flags::{Common, ProgressMode};
use super::report;
use rayproof::error::Error;
use rayproof::frame::while_nothing_is_written;
use rayproof::watch::Watch;

/// Work that takes less shows no bar.
const PATIENCE: Duration = Duration::from_secs(1);

/// Steps of the bar, and of the JSON lines.
const STEPS: u32 = 1000;

static INTERRUPTED: AtomicBool = AtomicBool::new(false);

/// How long work may take to notice an interrupt. Tracing asks often; reading a
/// large mesh, a driver's compiling and packing a large picture do not.
const GRACE: Duration = Duration::from_secs(2);

/// On the first Ctrl-C (or SIGTERM) the work stops and nothing half is left; on
/// the second the process ends at once.
pub(super) fn watch_for_interrupts() {
    let handler = ctrlc::set_handler(|| {
        if INTERRUPTED.swap(true, Ordering::SeqCst) {
            std::process::exit(130);
        }
        // Not here: a second signal waits for this function to return.
        std::thread::spawn(|| {
            std::thread::sleep(GRACE);
            while_nothing_is_written(|| {
                let code = report::exit_code(Err(Error::Interrupted));
                std::process::exit(i32::from(code));
            });
        });
    });
    if let Err(error) = handler {
        tracing::debug!("Ctrl-C ends the process at once: {error}");
    }
}

/// Shows how far a render is.
pub(super) struct Progress {
    mode: ProgressMode,
    label: String,
    started: Instant,
    /// Steps done that were shown.
    shown: AtomicU32,
    bar: Mutex<Option<ProgressBar>>,
}

impl Progress {
    /// Progress of the work that `label` names.
    pub(super) fn new(common: &Common, label: impl Into<String>) -> Self {
        let mode = match common.progress {
            _ if common.quiet => ProgressMode::Never,
            ProgressMode::Auto if !std::io::stderr().is_terminal() => ProgressMode::Never,
            mode => mode,
        };
        Self {
            mode,
            label: label.into(),
            started: Instant::now(),
            shown: AtomicU32::new(0),
            bar: Mutex::new(None),
        }
    }

    fn show(&self, steps: u32) {
        match self.mode {
            ProgressMode::Never => {}
            ProgressMode::Json => {
                let object = serde_json::json!({
                    "progress": f64::from(steps) / f64::from(STEPS),
                    "seconds": self.started.elapsed().as_secs_f64(),
                    "work": self.label,
                });
                // Who closed standard error does without.
                let _ = writeln!(std::io::stderr(), "{object}");
            }
            ProgressMode::Auto if self.started.elapsed() < PATIENCE => {}
            ProgressMode::Auto | ProgressMode::Always => {
                let mut bar = self.bar.lock().unwrap_or_else(|e| e.into_inner());
                bar.get_or_insert_with(|| self.new_bar())
                    .set_position(u64::from(steps));
            }
        }
    }

    fn new_bar(&self) -> ProgressBar {
        let target = ProgressDrawTarget::stderr();
        let bar = ProgressBar::with_draw_target(Some(u64::from(STEPS)), target);
        let style = ProgressStyle::with_template("{msg} [{wide_bar}] {percent:>3}%  {eta} left");
        if let Ok(style) = style {
            bar.set_style(style.progress_chars("=> "));
        }
        bar.set_message(self.label.clone());
        bar.with_elapsed(self.started.elapsed())
    }
}

impl Watch for Progress {
    fn progress(&self, done: f64) {
        let steps = (done * f64::from(STEPS)) as u32;
        if steps > self.shown.fetch_max(steps, Ordering::Relaxed) {
            self.show(steps);
        }
    }

    fn cancelled(&self) -> bool {
        INTERRUPTED.load(Ordering::Relaxed)
    }
}

impl Drop for Progress {
    fn drop(&mut self) {
        let bar = self.bar.lock().unwrap_or_else(|e| e.into_inner()).take();
        if let Some(bar) = bar {
            bar.finish_and_clear();
        }
    }
}
