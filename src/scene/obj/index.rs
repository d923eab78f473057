//! The corners of a face: `v`, `v/vt`, `v//vn` or `v/vt/vn`.

use super::read::Fault;

/// Numbers of `v`, `vt` and `vn` lines, in this order.
pub(super) type Counts = [u64; 3];

const NAMES: [&str; 3] = ["v", "vt", "vn"];

/// What a corner has beside its position.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) struct Present {
    pub uv: bool,
    pub normal: bool,
}

/// Checks the indices of faces. Some may point at lines that are yet to come.
#[derive(Debug, Default)]
pub(super) struct Indices {
    /// For each kind, indices that were ahead of the count when they were met,
    /// with their lines: each larger than the one before, so that the first
    /// beyond the final count is in the first line at fault.
    ahead: [Vec<(u64, usize)>; 3],
}

impl Indices {
    /// Checks one corner against the lines counted so far and says what it
    /// has beside its position.
    pub fn corner(&mut self, word: &str, counts: &Counts, line: usize) -> Result<Present, Fault> {
        let mut parts = word.split('/');
        let mut present = [false; 3];
        for kind in 0..3 {
            let Some(part) = parts.next() else { break };
            if !part.is_empty() {
                present[kind] = true;
                self.index(part, kind, counts[kind], line)
                    .map_err(|message| Fault::at(line, message))?;
            }
        }
        if !present[0] || parts.next().is_some() {
            return Err(Fault::at(
                line,
                format!("`{word}` is not a corner: {CORNER_FORMS}"),
            ));
        }
        Ok(Present {
            uv: present[1],
            normal: present[2],
        })
    }

    fn index(&mut self, text: &str, kind: usize, count: u64, line: usize) -> Result<(), String> {
        let name = NAMES[kind];
        let Ok(index) = text.parse::<i64>() else {
            return Err(if is_integer(text) {
                format!("index {text} is out of range: {}", range(name, count))
            } else {
                format!("`{text}` is not an index: {CORNER_FORMS}")
            });
        };
        if index == 0 {
            return Err(format!(
                "index 0 refers to nothing: indices count from 1, or from -1 backwards; {}",
                range(name, count)
            ));
        }
        let distance = index.unsigned_abs();
        if distance <= count {
            return Ok(());
        }
        if index < 0 {
            return Err(format!(
                "index {index} reaches back before the first `{name}`: {}",
                range(name, count)
            ));
        }
        let ahead = &mut self.ahead[kind];
        if ahead.last().is_none_or(|&(largest, _)| largest < distance) {
            ahead.push((distance, line));
        }
        Ok(())
    }

    /// Checks the indices that were ahead, now that all lines are counted.
    pub fn end(&self, counts: &Counts) -> Result<(), Fault> {
        let faults = (0..3).filter_map(|kind| {
            let beyond = self.ahead[kind]
                .iter()
                .find(|(index, _)| *index > counts[kind]);
            beyond.map(|&(index, line)| (kind, index, line))
        });
        match faults.min_by_key(|&(_, _, line)| line) {
            None => Ok(()),
            Some((kind, index, line)) => Err(Fault::at(
                line,
                format!(
                    "index {index} is out of range: {}",
                    range(NAMES[kind], counts[kind])
                ),
            )),
        }
    }
}

const CORNER_FORMS: &str = "a corner is v, v/vt, v//vn or v/vt/vn, with whole numbers";

fn is_integer(text: &str) -> bool {
    let digits = text.strip_prefix(['-', '+']).unwrap_or(text);
    !digits.is_empty() && digits.bytes().all(|b| b.is_ascii_digit())
}

fn range(name: &str, count: u64) -> String {
    match count {
        0 => format!("there is no `{name}` line"),
        1 => format!("there is one `{name}` line"),
        _ => format!("there are {count} `{name}` lines"),
    }
}
