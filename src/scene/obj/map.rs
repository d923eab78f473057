//! What stands behind `map_Kd`: options, then a file's name.

use super::elements::name;
use super::read::Fault;
use crate::scene::MAX_MAGNITUDE;

/// An image that a material names.
#[derive(Debug, Clone, PartialEq)]
pub(super) struct Map {
    /// The file, relative to that of the material, with `/` between folders.
    pub file: String,
    /// How often it repeats, across and upward (`-s`).
    pub repeat: [f64; 2],
    /// The line that names it.
    pub line: usize,
}

/// The words behind each option that is not applied, and the values that change nothing.
const OPTIONS: &[(&str, usize, &[&str])] = &[
    ("-blendu", 1, &["on"]),
    ("-blendv", 1, &["on"]),
    ("-boost", 1, &["0"]),
    ("-bm", 1, &["1"]),
    ("-cc", 1, &["off"]),
    ("-clamp", 1, &["off"]),
    ("-imfchan", 1, &[]),
    ("-mm", 2, &["0", "1"]),
    ("-texres", 1, &[]),
    ("-type", 1, &[]),
];

/// An image and its options; false if one of them says what is not applied.
pub(super) fn map(rest: &str, line: usize) -> Result<(Map, bool), Fault> {
    let mut rest = name(rest);
    let mut repeat = [1.0; 2];
    let mut all_applied = true;
    loop {
        let (option, after) = word(rest);
        let option = option.to_ascii_lowercase();
        if option == "-s" {
            let (numbers, after) = numbers(after);
            repeat = [0, 1].map(|axis| numbers.get(axis).copied().unwrap_or(1.0));
            let good = |x: &f64| *x != 0.0 && x.abs() <= MAX_MAGNITUDE;
            if numbers.is_empty() || !repeat.iter().all(good) {
                let message = "how often an image repeats is `-s u v`, finite numbers but 0";
                return Err(Fault::at(line, message));
            }
            rest = after;
        } else if option == "-o" || option == "-t" {
            let (numbers, after) = numbers(after);
            all_applied &= numbers.iter().all(|&x| x == 0.0);
            rest = after;
        } else if let Some((_, count, idle)) = OPTIONS.iter().find(|(name, ..)| *name == option) {
            rest = after;
            for i in 0..*count {
                let (value, after) = word(rest);
                all_applied &= idle.get(i).is_some_and(|idle| is_same(value, idle));
                rest = after;
            }
        } else {
            break;
        }
    }
    if rest.is_empty() {
        let message = "an image without a name: `map_Kd FILE`";
        return Err(Fault::at(line, message));
    }
    let map = Map {
        file: rest.replace('\\', "/"),
        repeat,
        line,
    };
    Ok((map, all_applied))
}

/// Are two values the same word, or the same number?
fn is_same(a: &str, b: &str) -> bool {
    match (a.parse::<f64>(), b.parse::<f64>()) {
        (Ok(a), Ok(b)) => a == b,
        _ => a.eq_ignore_ascii_case(b),
    }
}

/// The first word, and what follows it.
fn word(rest: &str) -> (&str, &str) {
    let (word, after) = rest.split_once(char::is_whitespace).unwrap_or((rest, ""));
    (word, after.trim_start())
}

/// Up to three numbers, and what follows them; the last word is a file's name, whatever it
/// looks like.
fn numbers(mut rest: &str) -> (Vec<f64>, &str) {
    let mut numbers = Vec::new();
    while numbers.len() < 3 {
        let (first, after) = word(rest);
        match first.parse() {
            Ok(number) if !after.is_empty() => numbers.push(number),
            _ => break,
        }
        rest = after;
    }
    (numbers, rest)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn options_and_names() {
        for (text, file, repeat, all_applied) in [
            ("a.png", "a.png", [1.0, 1.0], true),
            (
                "  my own  image.png  # made",
                "my own  image.png",
                [1.0; 2],
                true,
            ),
            (
                r"textures\wood 2.png",
                "textures/wood 2.png",
                [1.0; 2],
                true,
            ),
            ("-s 2 3 1 a.png", "a.png", [2.0, 3.0], true),
            ("-s 2 a.png", "a.png", [2.0, 1.0], true),
            ("-s 2 3", "3", [2.0, 1.0], true),
            ("-s -1 -1 -o 0 0 0 a.png", "a.png", [-1.0, -1.0], true),
            ("-o 0.5 a.png", "a.png", [1.0; 2], false),
            ("-Clamp ON a.png", "a.png", [1.0; 2], false),
            ("-clamp off -mm 0.0 1 -S 4 4 a.png", "a.png", [4.0; 2], true),
            ("-mm 0 2 a.png", "a.png", [1.0; 2], false),
            ("-imfchan r a.png", "a.png", [1.0; 2], false),
            ("-odd a.png", "-odd a.png", [1.0; 2], true),
        ] {
            let expected = Map {
                file: file.into(),
                repeat,
                line: 7,
            };
            assert_eq!(map(text, 7), Ok((expected, all_applied)), "{text}");
        }
    }

    #[test]
    fn no_name_and_no_size_are_faults() {
        for text in [
            "",
            " # a.png",
            "-clamp on",
            "-s",
            "-s 0 1 a.png",
            "-s inf a.png",
        ] {
            assert_eq!(
                map(text, 7).map_err(|fault| fault.line),
                Err(Some(7)),
                "{text}"
            );
        }
        assert!(map("-s a.png", 7).is_err());
    }
}
