//! The command line from outside: exit codes, streams, files, signals. On Linux,
//! with a Vulkan driver (software will do): without one these tests fail.

mod accuracy;
mod bench;
mod checks;
mod codes;
mod includes;
mod interrupts;
mod kills;
mod limits;
mod meshes;
mod outputs;
mod paths;
mod plan;
mod renders;
mod stability;
mod streams;
mod why;

use std::fs;
use std::path::PathBuf;
use std::time::Duration;

use serde_json::Value;
use tempfile::TempDir;

const RAYPROOF: &str = env!("CARGO_BIN_EXE_rayproof");

/// Nothing here takes as long, even on a busy machine; what hangs is killed.
const PATIENCE: Duration = Duration::from_secs(60);

/// A small scene with two kinds of shape.
const SCENE: &str = r#"
[image]
width = 48
height = 32

[camera]
eye = [0, 1, 6]
target = [0, 0.5, 0]

[background]
from = [0.9, 0.9, 0.95]
to = [0.3, 0.5, 0.9]

[ambient]
color = [0.1, 0.1, 0.1]

[[light]]
kind = "directional"
direction = [1, 2, 3]
shadow = false

[[material]]
name = "clay"
albedo = [0.7, 0.4, 0.3]

[[sphere]]
radius = 1
material = "clay"

[[plane]]
point = [0, -1, 0]
normal = [0, 1, 0]
"#;

/// What a scene cannot do without.
const CAMERA: &str = "[camera]\neye = [0, 1, 6]\ntarget = [0, 0.5, 0]\n";

/// A folder in which the program runs; `ok.toml` in it is [`SCENE`].
struct Room(TempDir);

impl Room {
    fn new() -> Self {
        let room = Self(tempfile::tempdir().expect("a temporary folder"));
        room.write("ok.toml", SCENE);
        room
    }

    fn path(&self, name: &str) -> PathBuf {
        self.0.path().join(name)
    }

    fn write(&self, name: &str, text: impl AsRef<[u8]>) {
        fs::write(self.path(name), text).expect("a file");
    }

    fn read(&self, name: &str) -> Vec<u8> {
        fs::read(self.path(name)).expect("a file that was written")
    }

    /// The names of all files, sorted.
    fn names(&self) -> Vec<String> {
        let entries = fs::read_dir(self.0.path()).expect("a folder");
        let mut names: Vec<_> = entries
            .map(|entry| entry.expect("an entry").file_name())
            .map(|name| name.into_string().expect("a plain name"))
            .collect();
        names.sort();
        names
    }

    /// Runs `rayproof` with the words of a line.
    fn run(&self, line: &str) -> Ended {
        self.run_with(line, &[])
    }

    /// The same, with variables of the environment set.
    fn run_with(&self, line: &str, variables: &[(&str, &str)]) -> Ended {
        let mut command = assert_cmd::Command::new(RAYPROOF);
        command.args(line.split_whitespace());
        command.envs(variables.iter().copied());
        self.finish(command)
    }

    /// Runs a line of the shell, in which `rayproof` is `"$0"`.
    fn shell(&self, line: &str) -> Ended {
        let mut command = assert_cmd::Command::new("sh");
        command.args(["-c", line, RAYPROOF]);
        self.finish(command)
    }

    fn finish(&self, mut command: assert_cmd::Command) -> Ended {
        let output = command
            .current_dir(self.0.path())
            .timeout(PATIENCE)
            .output()
            .expect("a process");
        Ended {
            code: output.status.code(),
            out: String::from_utf8(output.stdout).expect("text"),
            err: String::from_utf8(output.stderr).expect("text"),
        }
    }
}

/// A process that ended; `code` is none where a signal or the time-out ended it.
#[derive(Debug)]
struct Ended {
    code: Option<i32>,
    out: String,
    err: String,
}

impl Ended {
    /// Asserts the exit code.
    #[track_caller]
    fn with(self, code: i32) -> Self {
        assert_eq!(self.code, Some(code), "{self:#?}");
        self
    }

    /// Asserts that an error was told, with these words, on standard error only.
    #[track_caller]
    fn telling(self, words: &[&str]) -> Self {
        assert!(self.out.is_empty(), "{self:#?}");
        for word in words {
            assert!(self.err.contains(word), "no `{word}` in {self:#?}");
        }
        self
    }

    /// Standard output as one JSON object of the first schema.
    #[track_caller]
    fn json(&self) -> Value {
        let value: Value = serde_json::from_str(&self.out).unwrap_or_else(|_| panic!("{self:#?}"));
        assert_eq!(value["schema"], 1, "{self:#?}");
        value
    }
}

/// Asserts that a JSON object has these fields.
#[track_caller]
fn has_fields(object: &Value, names: &str) {
    for name in names.split_whitespace() {
        assert!(object.get(name).is_some(), "no `{name}` in {object:#}");
    }
}
