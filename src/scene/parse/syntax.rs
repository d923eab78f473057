//! What the TOML parser cannot read is cut out, so that one slip of the pen
//! hides as little as possible of the rest.
//!
//! The parser stops at a key without a value, and an unclosed bracket swallows
//! every line after it. So a text with errors is taken apart at the lines that
//! look like table headers; in each part the offending line, or where it cannot
//! be told the whole part, is overwritten with spaces. Spans stay what they were.

use std::ops::Range;

use toml::de::DeTable;

/// Lines that are cut out of one table before the rest of it is given up.
const MAX_CUTS: usize = 8;

/// A text that TOML can read, and what was lost on the way.
pub(super) struct Readable {
    /// As long as the original.
    pub(super) text: String,
    pub(super) errors: Vec<SyntaxError>,
    /// The tables that are not whole, in order.
    pub(super) broken: Vec<Range<usize>>,
}

/// Something that is not TOML.
pub(super) struct SyntaxError {
    pub(super) span: Range<usize>,
    pub(super) message: String,
}

/// Cuts out what is not TOML. Tables that stand twice are left in: each by
/// itself is sound.
pub(super) fn readable(text: &str) -> Readable {
    let mut errors = Vec::new();
    let mut broken = Vec::new();
    let mut cleaned = String::with_capacity(text.len());
    for part in parts(text) {
        let known = errors.len();
        let clean = clean(&text[part.clone()], part.start, &mut errors);
        cleaned.push_str(&clean);
        if errors.len() > known {
            broken.push(part);
        }
    }
    Readable {
        text: cleaned,
        errors,
        broken,
    }
}

/// The first thing that the parser refuses. Only one, because a hostile file
/// has more of them than fit in memory.
fn first_error(text: &str) -> Option<SyntaxError> {
    DeTable::parse(text).err().map(SyntaxError::from)
}

impl From<toml::de::Error> for SyntaxError {
    fn from(error: toml::de::Error) -> Self {
        let message = match error.message() {
            // What the parser supposes of any word without quotes.
            m if m.starts_with("string values must be quoted") => {
                "expected a value: a number, \"text\", true, false, [...] or {...}"
            }
            m => m,
        };
        Self {
            span: error.span().unwrap_or(0..0),
            message: message.to_owned(),
        }
    }
}

/// The text from each header to the next, beginning with what has no header.
fn parts(text: &str) -> Vec<Range<usize>> {
    let mut starts = vec![0];
    let mut at = 0;
    for line in text.split_inclusive('\n') {
        if is_header(line) && at > 0 {
            starts.push(at);
        }
        at += line.len();
    }
    let ends = starts.iter().skip(1).copied().chain([text.len()]);
    starts
        .iter()
        .copied()
        .zip(ends)
        .map(|(a, b)| a..b)
        .collect()
}

/// Is this line a table's header, if perhaps a misspelt one?
fn is_header(line: &str) -> bool {
    let line = line.trim_start();
    let name = line.trim_start_matches('[');
    let brackets = line.len() - name.len();
    (1..=2).contains(&brackets)
        && name.starts_with(|c: char| c.is_alphabetic() || c == '_')
        && !name.contains([',', '='])
}

/// One part without what cannot be read.
fn clean(part: &str, offset: usize, errors: &mut Vec<SyntaxError>) -> String {
    let mut part = part.to_owned();
    let body = match part.split_inclusive('\n').next() {
        Some(line) if is_header(line) => line.len()..part.len(),
        _ => 0..part.len(),
    };
    for cut in 1.. {
        let Some(error) = first_error(&part) else {
            break;
        };
        let line = line_around(&part, error.span.start);
        let whole_statement =
            stands_on_one_line(&part[line.clone()], error.span.start - line.start);
        let hole = if line.start < body.start {
            0..part.len()
        } else if whole_statement && cut < MAX_CUTS {
            line
        } else {
            body.clone()
        };
        part = blank(&part, &hole);
        errors.push(SyntaxError {
            span: offset + error.span.start..offset + error.span.end,
            ..error
        });
        // An empty body cannot be at fault, so the loop ends here at the latest.
        if hole.end == part.len() && hole.start <= body.start {
            break;
        }
    }
    part
}

/// Is the fault one of this line alone? Not where a bracket is left open, and
/// not where the fault comes before the `=`: then an earlier line is unfinished.
fn stands_on_one_line(line: &str, column: usize) -> bool {
    let count = |c: char| line.matches(c).count();
    let closed = count('[') == count(']') && count('{') == count('}');
    let empty = line.trim().is_empty();
    let has_key = line.find('=').is_some_and(|equals| equals <= column);
    let bare = !line.contains('=');
    closed && !empty && (has_key || bare)
}

/// The line that holds a byte, with its end.
fn line_around(text: &str, at: usize) -> Range<usize> {
    let bytes = text.as_bytes();
    let at = at.min(bytes.len());
    let start = bytes[..at].iter().rposition(|&b| b == b'\n');
    let end = bytes[at..].iter().position(|&b| b == b'\n');
    start.map_or(0, |i| i + 1)..end.map_or(bytes.len(), |i| at + i + 1)
}

/// The text with spaces in place of some whole lines.
fn blank(text: &str, hole: &Range<usize>) -> String {
    let spaces = |s: &str| -> String {
        s.bytes()
            .map(|b| if b == b'\n' { '\n' } else { ' ' })
            .collect()
    };
    [
        &text[..hole.start],
        &spaces(&text[hole.clone()]),
        &text[hole.end..],
    ]
    .concat()
}

#[cfg(test)]
mod tests {
    use super::*;

    fn told(text: &str) -> (Vec<usize>, String) {
        let readable = readable(text);
        assert_eq!(readable.text.len(), text.len());
        assert!(first_error(&readable.text).is_none(), "{}", readable.text);
        let line = |at: usize| text[..at].matches('\n').count() + 1;
        let lines = readable.errors.iter().map(|e| line(e.span.start)).collect();
        let left = readable.text.split_whitespace().collect::<Vec<_>>();
        (lines, left.join(" "))
    }

    #[test]
    fn a_line_that_cannot_be_read_costs_only_itself() {
        for bad in [
            "b",
            "b 2",
            "b = ",
            "b = 1 2",
            "b = x",
            "b = \"x",
            "= 3",
            "b = 01",
            "b = [1 2]",
        ] {
            let text = format!("[t]\na = 1\n{bad}\nc = 3\n[u]\n");
            assert_eq!(
                told(&text),
                (vec![3], "[t] a = 1 c = 3 [u]".into()),
                "{bad}"
            );
        }
    }

    #[test]
    fn two_bad_lines_are_both_told() {
        let (lines, left) = told("a = x\nb = 2\nc = y\nd = 4");
        assert_eq!((lines, left.as_str()), (vec![1, 3], "b = 2 d = 4"));
    }

    #[test]
    fn an_open_bracket_costs_its_table_and_no_other() {
        for open in ["b = [1, 2", "b = {x = 1", "b = '''x"] {
            let text = format!("[t]\na = 1\n{open}\nc = 3\n[[u]]\nd = 4\n");
            let (lines, left) = told(&text);
            assert_eq!(left, "[t] [[u]] d = 4", "{open}");
            assert_eq!(lines.len(), 1, "{open}");
        }
    }

    #[test]
    fn a_bad_header_takes_its_lines_with_it() {
        for header in ["[x", "[[x]", "[x]]"] {
            let text = format!("[t]\na = 1\n{header}\na = 3\n[u]\n");
            assert_eq!(told(&text), (vec![3], "[t] a = 1 [u]".into()), "{header}");
        }
    }

    #[test]
    fn rows_of_numbers_are_not_headers() {
        let text = "[t]\na = [\n[1, 2],\n [3, 4],\n]\nb = x\n";
        assert_eq!(told(text).0, vec![6]);
        assert!(first_error("[t]\na = [\n[1, 2],\n]\n").is_none());
    }
}
