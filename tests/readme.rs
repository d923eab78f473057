//! Plays the README: runs its commands and holds their output to what it prints.
//!
//! In a block marked `console`, a line `$ COMMAND` is a command and the lines up
//! to the next one are what it prints, on standard output and standard error
//! together. All blocks share one folder with a copy of `assets/scenes`, the
//! commands of a block one shell. A command may fail only if the next one is
//! `echo $?`, whose output then tells the exit code. An example is built, then
//! run like any other command; of the rest of `make` and `cargo`, only that it
//! would do something is checked.
//!
//! What depends on the machine is masked before it is compared: the rows of
//! tables and the fields of JSON named in [`ROWS`] and [`FIELDS`], and the
//! adapter in `gpu (ADAPTER)`. In the tables of `bench`, whose lines begin as
//! [`COLUMNS`] says, numbers with a point are, and the width of the columns.
//!
//! `RAYPROOF_README=write cargo test --test readme` writes what is printed now
//! into the README, in place of what differs.
#![cfg(unix)]

use std::fs;
use std::ops::Range;
use std::path::Path;
use std::process::{Command, Stdio};

const ROOT: &str = env!("CARGO_MANIFEST_DIR");
const RAYPROOF: &str = env!("CARGO_BIN_EXE_rayproof");

/// Rows of tables that show times, or what a device is like.
const ROWS: &[&str] = &[
    "time",
    "adapter",
    "driver",
    "limits",
    "features",
    "contraction",
    "rounding",
    "special values",
    "f64",
    "loops",
    "reading",
];

/// Fields of JSON objects that do.
const FIELDS: &[&str] = &[
    "adapter",
    "driver",
    "seconds",
    "trace_ms",
    "build_ms",
    "mrays_per_s",
];

/// How lines of tables begin whose columns are times and ratios.
const COLUMNS: &[&str] = &[
    "backend  ",
    "cpu  ",
    "gpu  ",
    "cpu, ",
    "  n^",
    "arithmetic/odd-rays-in-time",
    "All ",
];

/// Parts what one command prints from what the next one does: a control
/// character that no output holds.
const SEPARATOR: char = '\u{1e}';

/// A command and the lines of the README that hold its output.
struct Exchange {
    command: String,
    output: Range<usize>,
}

/// What a command did.
struct Reply {
    output: Vec<String>,
    status: i32,
}

/// The exchanges of each console block.
fn sessions(readme: &[String]) -> Vec<Vec<Exchange>> {
    let mut sessions = Vec::new();
    let mut block: Option<Vec<Exchange>> = None;
    for (number, line) in readme.iter().enumerate() {
        if line.starts_with("```") {
            sessions.extend(block.take());
            block = (line == "```console").then(Vec::new);
        } else if let Some(exchanges) = &mut block {
            if let Some(command) = line.strip_prefix("$ ") {
                exchanges.push(Exchange {
                    command: command.to_string(),
                    output: number + 1..number + 1,
                });
            } else if let Some(last) = exchanges.last_mut() {
                last.output.end = number + 1;
            }
        }
    }
    sessions
}

/// Runs the commands of one block in one shell.
fn play(exchanges: &[Exchange], folder: &Path) -> Vec<Reply> {
    let mut script = String::from("exec 2>&1\n");
    for exchange in exchanges {
        script += &in_folder(&exchange.command);
        script += "\nstatus=$?; printf '\\036%s\\n' $status; (exit $status)\n";
    }
    let programs = Path::new(RAYPROOF).parent().unwrap().display();
    let path = std::env::var("PATH").unwrap_or_default();
    let shell = Command::new("sh")
        .args(["-c", &script])
        .current_dir(folder)
        .env("PATH", format!("{programs}:{path}"))
        .env_remove("RUST_BACKTRACE")
        // Without a desktop, Mesa remarks on its absence.
        .env("XDG_RUNTIME_DIR", folder)
        .stdin(Stdio::null())
        .output()
        .unwrap();
    let text = String::from_utf8(shell.stdout).unwrap();
    let mut replies = Vec::new();
    let mut rest = text.as_str();
    while let Some((output, after)) = rest.split_once(SEPARATOR) {
        let (status, after) = after.split_once('\n').unwrap();
        replies.push(Reply {
            output: output.lines().map(str::to_string).collect(),
            status: status.parse().unwrap(),
        });
        rest = after;
    }
    replies
}

/// The command as it is run in the folder: without what would build or install.
fn in_folder(command: &str) -> String {
    let words: Vec<&str> = command.split_whitespace().collect();
    match words.as_slice() {
        ["cargo", "run", "--example", name, rest @ ..] => {
            let arguments = rest.strip_prefix(&["--"]).unwrap_or(rest).join(" ");
            format!("{} {arguments}", build_example(name))
        }
        ["cargo", "install", "--path", "."] => ":".into(),
        ["cargo", "test", "--test", name] => {
            let file = Path::new(ROOT).join("tests").join(name);
            assert!(
                file.with_extension("rs").exists() || file.join("main.rs").exists(),
                "there is no test `{name}`"
            );
            ":".into()
        }
        ["make", target] => {
            let dry = Command::new("make")
                .args(["-n", target])
                .current_dir(ROOT)
                .output()
                .expect("`make`, which the README uses, is not installed");
            assert!(dry.status.success(), "make has no target `{target}`");
            ":".into()
        }
        ["make" | "cargo" | "git", ..] => panic!("this test does not know about `{command}`"),
        _ => command.to_string(),
    }
}

/// Builds an example in the profile of this test, and tells where it lies.
fn build_example(name: &str) -> String {
    let folder = Path::new(RAYPROOF).parent().unwrap();
    let profile = match folder.file_name().and_then(|name| name.to_str()) {
        Some("debug") => "dev",
        other => other.unwrap(),
    };
    let built = Command::new(env!("CARGO"))
        .args(["build", "--quiet", "--example", name, "--profile", profile])
        .current_dir(ROOT)
        .status()
        .unwrap();
    assert!(built.success(), "the example `{name}` does not build");
    folder.join("examples").join(name).display().to_string()
}

/// The line without what depends on the machine.
fn mask(line: &str) -> String {
    let field = line.trim().trim_start_matches('"').split_once("\": ");
    if let Some((name, _)) = field.filter(|(name, _)| FIELDS.contains(name)) {
        return format!("\"{name}\": *");
    }
    let row = line.split_once("  ");
    if let Some((name, _)) = row.filter(|(name, _)| ROWS.contains(name)) {
        return format!("{name}  *");
    }
    if COLUMNS.iter().any(|start| line.starts_with(start)) {
        let words = line.split_whitespace();
        let figure = |word: &str| word.contains('.') && word.contains(|c: char| c.is_ascii_digit());
        let masked = words.map(|word| if figure(word) { "*" } else { word });
        return masked.collect::<Vec<_>>().join(" ");
    }
    match (line.find("gpu ("), line.rfind(')')) {
        (Some(start), Some(end)) if start < end => {
            format!("{}gpu (*{}", &line[..start], &line[end..])
        }
        _ => line.to_string(),
    }
}

/// What is wrong with the printed output of a session, each with its lines.
fn faults<'a>(
    readme: &[String],
    exchanges: &'a [Exchange],
    replies: &'a [Reply],
) -> Vec<(&'a Exchange, &'a Reply, String)> {
    let mut faults = Vec::new();
    for (index, (exchange, reply)) in exchanges.iter().zip(replies).enumerate() {
        let printed: Vec<String> = readme[exchange.output.clone()].to_vec();
        let masked = |lines: &[String]| lines.iter().map(|l| mask(l)).collect::<Vec<_>>();
        let announced = exchanges
            .get(index + 1)
            .is_some_and(|next| next.command == "echo $?");
        let place = format!(
            "README.md:{}: `{}`",
            exchange.output.start, exchange.command
        );
        let real = reply.output.join("\n");
        if reply.status != 0 && !announced {
            let text = format!("{place} exits with {}:\n{real}", reply.status);
            faults.push((exchange, reply, text));
        } else if masked(&printed) != masked(&reply.output) {
            let text = format!("{place} prints\n{real}\nand not\n{}", printed.join("\n"));
            faults.push((exchange, reply, text));
        }
    }
    faults
}

fn lines(text: &str) -> Vec<String> {
    text.lines().map(str::to_string).collect()
}

fn folder_with_scenes() -> tempfile::TempDir {
    let folder = tempfile::tempdir().unwrap();
    for scenes in ["", "skies", "textures"].map(|part| format!("assets/scenes/{part}")) {
        let copies = folder.path().join(&scenes);
        fs::create_dir_all(&copies).unwrap();
        for entry in fs::read_dir(Path::new(ROOT).join(&scenes)).unwrap() {
            let file = entry.unwrap().path();
            if file.is_file() {
                fs::copy(&file, copies.join(file.file_name().unwrap())).unwrap();
            }
        }
    }
    folder
}

#[test]
fn the_readme_prints_what_its_commands_print() {
    let path = Path::new(ROOT).join("README.md");
    let readme = lines(&fs::read_to_string(&path).unwrap());
    let folder = folder_with_scenes();
    let sessions = sessions(&readme);
    let commands: usize = sessions.iter().map(Vec::len).sum();
    assert!(commands > 10, "only {commands} commands were found");

    let mut corrected = readme.clone();
    let mut wrong = Vec::new();
    let replies: Vec<_> = sessions.iter().map(|s| play(s, folder.path())).collect();
    // From the end, so that the lines of what comes before stay where they are.
    for (exchanges, replies) in sessions.iter().zip(&replies).rev() {
        assert_eq!(exchanges.len(), replies.len(), "a command ended its shell");
        for (exchange, reply, text) in faults(&readme, exchanges, replies).into_iter().rev() {
            corrected.splice(exchange.output.clone(), reply.output.clone());
            wrong.push(text);
        }
    }
    wrong.reverse();
    if std::env::var("RAYPROOF_README").is_ok_and(|mode| mode == "write") {
        fs::write(&path, corrected.join("\n") + "\n").unwrap();
    }
    assert!(wrong.is_empty(), "{}", wrong.join("\n\n"));
}

/// The control: each of these READMEs but the first is wrong in one way.
#[test]
fn a_wrong_readme_is_noticed() {
    let cases = [
        ("$ echo 0 of 9; echo end\n0 of 9\nend", 0),
        ("$ echo 0 of 9; echo end\n1 of 9\nend", 1),
        ("$ echo 0 of 9; echo end\n0 of 9", 1),
        ("$ echo 0 of 9; echo end\n0 of 9\nend\nend", 1),
        ("$ false\n$ echo $?\n1", 0),
        ("$ false\n$ echo $?\n0", 1),
        ("$ false", 1),
        ("$ echo 'time  3 ms'\ntime  4 ms", 0),
        ("$ echo 'times  3 ms'\ntimes  4 ms", 1),
        ("$ echo 'a on gpu (x (y)) b'\na on gpu (z) b", 0),
        ("$ echo 'a on gpu (x (y)) b'\na on gpu (z) c", 1),
        (
            "$ echo 'cpu  1  tree  3  4.25   1.00 (0.50-2.00)'\ncpu  1  tree  3  14.5  0.98 (0.7-1.3)",
            0,
        ),
        ("$ echo 'cpu  1  tree  3  4.25'\ncpu  1  none  3  4.25", 1),
        ("$ echo 'cpu  1  tree  3  4.25'\ncpu  1  tree  2  4.25", 1),
        ("$ echo 'cpu  1  tree  3  4.25'\ncpu  1  tree  3  -", 1),
        ("$ echo 'x  1  tree  3  4.25'\nx  1  tree  3  4.5", 1),
        ("$ echo '  \"seconds\": 3,'\n  \"seconds\": 4,", 0),
        ("$ echo '  \"pixels\": 3,'\n  \"pixels\": 4,", 1),
        ("$ rayproof check assets/scenes/none.toml\n$ echo $?\n3", 1),
    ];
    for (text, expected) in cases {
        let readme = lines(&format!("```console\n{text}\n```"));
        let folder = folder_with_scenes();
        let sessions = sessions(&readme);
        let replies = play(&sessions[0], folder.path());
        let found = faults(&readme, &sessions[0], &replies).len();
        assert_eq!(found, expected, "{text}");
    }
}

/// The README's Rust stands in the documentation of the library too, whose
/// examples are run.
#[test]
fn the_example_in_rust_is_one_that_is_run() {
    let readme = fs::read_to_string(Path::new(ROOT).join("README.md")).unwrap();
    let library = fs::read_to_string(Path::new(ROOT).join("src/lib.rs")).unwrap();
    let (_, after) = readme.split_once("```rust\n").unwrap();
    let (code, _) = after.split_once("```").unwrap();
    let documented: String = code
        .lines()
        .map(|line| format!("//! {line}").trim_end().to_string() + "\n")
        .collect();
    assert!(library.contains(&documented), "not in src/lib.rs:\n{code}");
}

#[test]
fn what_the_documents_link_to_is_there() {
    for document in ["README.md", "docs/design.md", "docs/json.md"] {
        let path = Path::new(ROOT).join(document);
        let text = fs::read_to_string(&path).unwrap();
        let targets: Vec<&str> = text
            .split("](")
            .skip(1)
            .filter_map(|rest| Some(rest.split_once(')')?.0))
            .filter(|target| !target.starts_with("http"))
            .collect();
        assert!(!targets.is_empty(), "{document} has no links");
        for target in targets {
            let file = target.split('#').next().unwrap();
            let there = path.parent().unwrap().join(file);
            assert!(there.exists(), "{document} links to {target}");
        }
    }
}
