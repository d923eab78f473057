//! From a place in the file to its line.

/// Where the lines of a text end.
pub(super) struct Lines(Vec<usize>);

impl Lines {
    pub(super) fn of(text: &str) -> Self {
        Self(text.match_indices('\n').map(|(at, _)| at).collect())
    }

    /// The line of a byte, from 1.
    pub(super) fn line(&self, at: usize) -> u32 {
        // A file has fewer than 2^32 lines: `Policy::max_scene_bytes` is far below.
        u32::try_from(1 + self.0.partition_point(|end| *end < at)).unwrap_or(u32::MAX)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn lines_are_counted_from_1_and_end_with_their_break() {
        let lines = Lines::of("a\n\nb");
        let of_each = [0, 1, 2, 3, 4].map(|at| lines.line(at));
        assert_eq!(of_each, [1, 1, 2, 3, 3]);
    }
}
