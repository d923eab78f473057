//! Exit code 130: Ctrl-C while the program is at work.

use std::fs::{self, File};
use std::io::{BufRead, BufReader};
use std::process::{Child, Command, Stdio};
use std::time::{Duration, Instant};

use super::{CAMERA, RAYPROOF, Room};

/// A render that takes hours.
fn endless_scene() -> String {
    let image = "[image]\nwidth = 1000\nheight = 1000\n";
    let mesh = "[[mesh]]\nbuiltin = \"terrain\"\ndetail = 2000000\n";
    let light = "[ambient]\ncolor = [1, 1, 1]\n";
    format!("{image}{CAMERA}{light}{mesh}")
}

/// Work that is killed, should a test fail before its end.
pub(super) struct Work(Child);

impl Drop for Work {
    fn drop(&mut self) {
        let _ = self.0.kill();
        let _ = self.0.wait();
    }
}

impl Work {
    pub(super) fn start(room: &Room, line: &str) -> Self {
        let child = Command::new(RAYPROOF)
            .args(line.split_whitespace())
            .current_dir(room.0.path())
            .stdout(Stdio::null())
            .stderr(Stdio::piped())
            .spawn();
        Self(child.expect("a process"))
    }

    pub(super) fn signal(&self, name: &str) {
        let id = self.0.id().to_string();
        let sent = Command::new("sh")
            .args(["-c", "kill -s $0 $1", name, &id])
            .status();
        assert!(sent.expect("a shell").success(), "{name} to {id}");
    }

    /// Waits until the process catches SIGINT: proc(5), a mask in hexadecimal with
    /// the first signal in its last bit.
    fn await_handler(&self) {
        const SIGINT: u32 = 2;
        let catches = || {
            let status = fs::read_to_string(format!("/proc/{}/status", self.0.id())).ok()?;
            let mask = status.lines().find_map(|l| l.strip_prefix("SigCgt:"))?;
            let mask = u64::from_str_radix(mask.trim(), 16).ok()?;
            Some(mask >> (SIGINT - 1) & 1 == 1)
        };
        let started = Instant::now();
        while catches() != Some(true) {
            assert!(started.elapsed() < super::PATIENCE, "it heeds no signal");
            std::thread::sleep(Duration::from_millis(5));
        }
    }

    /// Waits for the first line on standard error.
    pub(super) fn await_progress(&mut self) {
        let stderr = self.0.stderr.take().expect("piped");
        let mut lines = BufReader::new(stderr);
        let mut line = String::new();
        lines.read_line(&mut line).expect("a line");
        assert!(line.contains("progress"), "{line}");
        // Read on, or a full pipe would hold the program up.
        std::thread::spawn(move || std::io::copy(&mut lines, &mut std::io::sink()));
    }

    /// Whether it has not ended.
    pub(super) fn is_running(&mut self) -> bool {
        self.0.try_wait().expect("a child").is_none()
    }

    /// The exit code, and how long it took.
    pub(super) fn end(&mut self) -> (Option<i32>, Duration) {
        let started = Instant::now();
        loop {
            if let Some(status) = self.0.try_wait().expect("a child") {
                return (status.code(), started.elapsed());
            }
            assert!(started.elapsed() < super::PATIENCE, "it does not end");
            std::thread::sleep(Duration::from_millis(5));
        }
    }
}

/// The grace of two seconds, on a busy machine.
pub(super) const SOON: Duration = Duration::from_secs(8);

#[test]
fn an_interrupt_ends_a_render_and_leaves_the_old_file() {
    for (backend, signal) in [("cpu", "INT"), ("gpu", "INT"), ("cpu", "TERM")] {
        let room = Room::new();
        room.write("endless.toml", endless_scene());
        room.write("a.png", "old");
        let line = format!(
            "render endless.toml -o a.png --backend {backend} --bounds none --progress json"
        );
        let mut work = Work::start(&room, &line);
        work.await_progress();
        work.signal(signal);
        let (code, took) = work.end();
        assert_eq!(code, Some(130), "{backend} {signal}");
        assert!(took < SOON, "{backend} {signal}: {took:?}");
        assert_eq!(room.names(), ["a.png", "endless.toml", "ok.toml"]);
        assert_eq!(room.read("a.png"), b"old");
    }
}

#[test]
fn an_interrupt_ends_a_benchmark() {
    let room = Room::new();
    room.write("endless.toml", endless_scene());
    let line = "bench endless.toml --bounds none --progress json";
    let mut work = Work::start(&room, line);
    work.await_progress();
    work.signal("INT");
    let (code, took) = work.end();
    assert_eq!(code, Some(130));
    assert!(took < SOON, "{took:?}");
}

#[test]
fn an_interrupt_ends_the_hard_cases() {
    let room = Room::new();
    let mut work = Work::start(&room, "stability --thorough --progress json");
    work.await_progress();
    work.signal("INT");
    let (code, took) = work.end();
    assert_eq!(code, Some(130));
    assert!(took < SOON, "{took:?}");
}

#[test]
fn an_interrupt_ends_what_does_not_ask_for_it() {
    let room = Room::new();
    let line = "mesh knot --detail 10000000 -o a.obj";
    let mut work = Work::start(&room, line);
    work.await_handler();
    work.signal("INT");
    let (code, took) = work.end();
    assert_eq!(code, Some(130));
    assert!(took < SOON, "{took:?}");
    assert_eq!(room.names(), ["ok.toml"]);
}

/// Standard output that nobody reads and that takes no more would hold the
/// program up for ever; so does opening a FIFO. The second signal ends that.
#[test]
fn a_second_interrupt_ends_at_once() {
    let room = Room::new();
    room.shell("mkfifo fifo.json").with(0);
    let mut work = Work::start(
        &room,
        "render ok.toml -o a.png --backend cpu --stats fifo.json",
    );
    // The picture is there, and the figures wait for a reader.
    let started = Instant::now();
    while !room.path("a.png").exists() {
        assert!(started.elapsed() < super::PATIENCE);
        std::thread::sleep(Duration::from_millis(10));
    }
    work.signal("INT");
    std::thread::sleep(Duration::from_millis(300));
    assert!(work.is_running(), "the first one ended it");
    work.signal("INT");
    let (code, took) = work.end();
    assert_eq!(code, Some(130));
    // Sooner than the grace after the first.
    assert!(took < Duration::from_millis(1500), "{took:?}");
}

#[test]
fn a_run_that_nobody_interrupts_ends_with_0() {
    let room = Room::new();
    let mut work = Work::start(&room, "render ok.toml -o a.png --progress json");
    work.await_progress();
    assert_eq!(work.end().0, Some(0));
    File::open(room.path("a.png")).expect("a picture");
}
