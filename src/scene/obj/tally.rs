//! What was left out of a mesh: counted, then told in one sentence a kind.

use super::read::Fault;

/// How often something happened, and where first.
#[derive(Debug, Clone, Copy, Default, PartialEq, Eq)]
pub(super) struct Tally {
    pub count: u64,
    pub first_line: usize,
}

impl Tally {
    pub fn add(&mut self, line: usize) {
        if self.count == 0 || line < self.first_line {
            self.first_line = line;
        }
        self.count += 1;
    }

    /// `one` or `many`, with the count in front and the first line behind; none if it did
    /// not happen.
    pub fn sentence(&self, one: &str, many: &str) -> Option<String> {
        match self.count {
            0 => None,
            1 => Some(format!("1 {one} (line {})", self.first_line)),
            count => Some(format!(
                "{count} {many} (the first in line {})",
                self.first_line
            )),
        }
    }
}

/// The kinds of things that a mesh is read without.
#[derive(Debug, Clone, Default)]
pub(super) struct Dropped {
    pub lines_and_points: Tally,
    pub too_few_corners: Tally,
    pub degenerate: Tally,
    pub non_finite: Tally,
    pub fanned: Tally,
    pub wild_uvs: Tally,
    pub unread: Tally,
}

impl Dropped {
    /// One warning a kind; if `strict`, the first of all as a fault.
    pub fn report(&self, strict: bool) -> Result<Vec<String>, Fault> {
        let kinds = [
            (
                &self.lines_and_points,
                "line or point element dropped",
                "line and point elements dropped",
            ),
            (
                &self.too_few_corners,
                "face with fewer than three corners dropped",
                "faces with fewer than three corners dropped",
            ),
            (
                &self.degenerate,
                "degenerate face dropped",
                "degenerate faces dropped",
            ),
            (
                &self.non_finite,
                "non-finite face dropped: corners must stay below 1e15",
                "non-finite faces dropped: corners must stay below 1e15",
            ),
            (
                &self.fanned,
                "polygon cut as a fan: it crosses itself or is warped",
                "polygons cut as fans: they cross themselves or are warped",
            ),
            (
                &self.wild_uvs,
                "face with non-finite texture coordinates taken without: they must stay below 1e15",
                "faces with non-finite texture coordinates taken without: they must stay below 1e15",
            ),
            (
                &self.unread,
                "line with a keyword that is not read",
                "lines with a keyword that is not read",
            ),
        ];
        let told = kinds.iter().filter(|(tally, _, _)| tally.count > 0);
        let first = told.clone().min_by_key(|(tally, _, _)| tally.first_line);
        if let Some((tally, one, _)) = first
            && strict
        {
            return Err(Fault::at(
                tally.first_line,
                format!("{one}, which strict reading refuses"),
            ));
        }
        Ok(told
            .filter_map(|(tally, one, many)| tally.sentence(one, many))
            .collect())
    }
}
