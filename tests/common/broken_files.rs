//! Scene files that break one rule, and near-identical ones that keep it.

#![allow(dead_code, reason = "each test uses a part")]

use rayproof::Error;
use rayproof::error::SceneFaults;
use rayproof::scene::parse::{Loaded, parse_str};
use rayproof::scene::policy::Policy;

/// What every file below begins with.
pub const HEAD: &str = "\
[camera]
eye = [0, 0, 5]
target = [0, 0, 0]
[ambient]
color = [1, 1, 1]
[[material]]
name = \"red\"
albedo = [1, 0, 0]
";

/// Reads a scene in an empty folder.
pub fn parse(text: &str) -> rayproof::Result<Loaded> {
    let folder = tempfile::tempdir().expect("a temporary folder");
    parse_str(text, "test.toml", folder.path(), &Policy::default())
}

/// All that is wrong with a scene.
pub fn faults(text: &str) -> SceneFaults {
    match parse(text) {
        Err(Error::Scene(faults)) => *faults,
        Err(other) => panic!("not a scene error: {other}\n{text}"),
        Ok(_) => panic!("accepted:\n{text}"),
    }
}

/// `bad` has exactly one fault, which says `message` and underlines `at`; `good`
/// loads without a warning and passes `validate`.
pub fn breaks(bad: &str, message: &str, at: &str, good: &str) {
    let found = faults(bad);
    let source = found.source_code.inner();
    let all: Vec<_> = found.faults.iter().map(|f| &f.message).collect();
    assert_eq!(all.len(), 1, "{all:#?}\n{bad}");
    let fault = &found.faults[0];
    assert!(fault.message.contains(message), "{}\n{bad}", fault.message);
    assert_eq!(&source[fault.span.clone()], at, "{}\n{bad}", fault.message);
    assert!(fault.help.is_some(), "no help: {}", fault.message);
    let loaded = parse(good).unwrap_or_else(|e| panic!("{:?}\n{good}", miette::Report::new(e)));
    assert_eq!(loaded.warnings, Vec::<String>::new(), "{good}");
    loaded.scene.validate().expect("what loads is valid");
}

/// A key of a section: (section, bad line, message, underlined, good line).
pub type Case = (
    &'static str,
    &'static str,
    &'static str,
    &'static str,
    &'static str,
);

/// Each bad line is one fault in a lit scene, and each good line none.
pub fn each_breaks_alone(cases: &[Case]) {
    const LIT: &str = "[[sphere]]\nradius = 1\n";
    for (section, bad, message, at, good) in cases {
        let other = if section.starts_with("[[sphere]]") {
            ""
        } else {
            LIT
        };
        let file = |line: &str| format!("{HEAD}{other}{section}\n{line}\n");
        // A header is underlined whole, so it must be the one of this section.
        let (bad, good) = (file(bad), file(good));
        breaks(&bad, message, at, &good);
    }
}

/// Line and column, from 1, of each fault.
pub fn places(faults: &SceneFaults) -> Vec<(usize, usize)> {
    let text = faults.source_code.inner();
    let place = |at: usize| {
        let line_start = text[..at].rfind('\n').map_or(0, |i| i + 1);
        (text[..at].matches('\n').count() + 1, at - line_start + 1)
    };
    faults.faults.iter().map(|f| place(f.span.start)).collect()
}
