//! What is wrong in a file, and what a line of it is.

use std::io::{self, BufRead};
use std::path::Path;

use crate::error::Error;

/// What is wrong in a file, and where.
#[derive(Debug, Clone, PartialEq, Eq)]
pub(super) struct Fault {
    /// Counted from 1.
    pub line: Option<usize>,
    pub message: String,
}

impl Fault {
    pub fn at(line: usize, message: impl Into<String>) -> Self {
        Self {
            line: Some(line),
            message: message.into(),
        }
    }

    pub fn whole(message: impl Into<String>) -> Self {
        Self {
            line: None,
            message: message.into(),
        }
    }

    pub fn into_error(self, path: &Path) -> Error {
        Error::Asset {
            path: path.to_path_buf(),
            line: self.line,
            message: self.message,
        }
    }
}

/// Splits bytes into logical lines: LF, CRLF and CR end a line, a backslash at
/// the end joins the next one, a byte-order mark is no part of the first.
pub(super) struct LogicalLines<R> {
    inner: R,
    /// Physical lines read so far.
    count: usize,
    /// The last line ended in CR: an LF in front of the next belongs to it.
    after_cr: bool,
}

const UTF8_MARK: &[u8] = b"\xef\xbb\xbf";
const UTF16_MARKS: [&[u8]; 2] = [b"\xff\xfe", b"\xfe\xff"];

impl<R: BufRead> LogicalLines<R> {
    pub fn new(inner: R) -> Self {
        Self {
            inner,
            count: 0,
            after_cr: false,
        }
    }

    pub fn inner(&self) -> &R {
        &self.inner
    }

    /// Fills `line` with the next logical line and returns the number of its
    /// first physical line, counted from 1; `None` at the end of the file.
    pub fn next(&mut self, line: &mut Vec<u8>) -> io::Result<Option<usize>> {
        line.clear();
        if !self.append_physical(line)? {
            return Ok(None);
        }
        let number = self.count;
        if number == 1 {
            strip_mark(line)?;
        }
        // A comment may end in a backslash (`# made from C:\models\`).
        while line.ends_with(b"\\") && !line.contains(&b'#') {
            line.pop();
            line.push(b' ');
            if !self.append_physical(line)? {
                break;
            }
        }
        Ok(Some(number))
    }

    fn append_physical(&mut self, line: &mut Vec<u8>) -> io::Result<bool> {
        let mut begun = false;
        loop {
            let buffer = self.inner.fill_buf()?;
            let Some(&first) = buffer.first() else {
                self.count += usize::from(begun);
                return Ok(begun);
            };
            if std::mem::take(&mut self.after_cr) && first == b'\n' {
                self.inner.consume(1);
                continue;
            }
            if let Some(end) = buffer.iter().position(|&b| b == b'\n' || b == b'\r') {
                line.extend_from_slice(&buffer[..end]);
                self.after_cr = buffer[end] == b'\r';
                self.inner.consume(end + 1);
                self.count += 1;
                return Ok(true);
            }
            begun = true;
            let length = buffer.len();
            line.extend_from_slice(buffer);
            self.inner.consume(length);
        }
    }
}

fn strip_mark(line: &mut Vec<u8>) -> io::Result<()> {
    if line.starts_with(UTF8_MARK) {
        line.drain(..UTF8_MARK.len());
    }
    if UTF16_MARKS.iter().any(|mark| line.starts_with(mark)) {
        return Err(io::Error::other("the text is UTF-16; save it as UTF-8"));
    }
    Ok(())
}

#[cfg(test)]
mod tests {
    use super::*;

    fn lines(text: &[u8]) -> Vec<(usize, String)> {
        // Two bytes at a time, so that every ending meets a buffer's edge.
        let mut reader = LogicalLines::new(io::BufReader::with_capacity(2, text));
        let (mut line, mut all) = (Vec::new(), Vec::new());
        while let Some(number) = reader.next(&mut line).expect("in memory") {
            all.push((number, String::from_utf8_lossy(&line).into_owned()));
        }
        all
    }

    #[test]
    fn all_line_endings_count_alike() {
        let expected = [(1, "a"), (2, "bc"), (3, ""), (4, "d")].map(|(n, s)| (n, s.to_string()));
        for text in [
            "a\nbc\n\nd",
            "a\r\nbc\r\n\r\nd\r\n",
            "a\rbc\r\rd\r",
            "a\nbc\r\n\rd",
        ] {
            assert_eq!(lines(text.as_bytes()), expected, "{text:?}");
        }
    }

    #[test]
    fn continuations_keep_the_number_of_their_first_line() {
        let expected = [(1, "f 1  2  3"), (4, "g")].map(|(n, s)| (n, s.to_string()));
        assert_eq!(lines(b"f 1 \\\n2 \\\r\n3\ng"), expected);
        assert_eq!(lines(b"a\\"), [(1, "a ".to_string())]);
    }

    #[test]
    fn a_comment_ends_with_its_line() {
        let expected = [(1, "# C:\\"), (2, "v")].map(|(n, s)| (n, s.to_string()));
        assert_eq!(lines(b"# C:\\\nv"), expected);
    }

    #[test]
    fn byte_order_marks() {
        assert_eq!(lines(b"\xef\xbb\xbfv\nv")[0].1, "v");
        let mut reader = LogicalLines::new(&b"\xff\xfev\0"[..]);
        assert!(reader.next(&mut Vec::new()).is_err());
    }
}
