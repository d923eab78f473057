//! Hands `tobj` (or no one) one checked line at a time, so that no second copy of the file
//! is held and the line at fault is known when `tobj` stops.

use std::io::{self, BufRead, BufReader, Read};

use super::read::{Fault, LogicalLines};
use crate::scene::guard::Capped;

/// Checks the lines of a file and rewrites them for `tobj`.
pub(super) trait Translate {
    /// Appends to `out` what `tobj` shall see of `line`, without a line end;
    /// nothing to leave the line out.
    fn line(&mut self, line: &str, number: usize, out: &mut String) -> Result<(), Fault>;

    /// Called once, after the last line.
    fn end(&mut self) -> Result<(), Fault>;
}

/// A reader of translated lines. Each `fill_buf` shows at most one line, so
/// that `tobj` parses a line before the next is looked at.
pub(super) struct Feed<R, T> {
    lines: LogicalLines<BufReader<Capped<R>>>,
    translate: T,
    raw: Vec<u8>,
    text: String,
    /// How much of `text` was taken.
    taken: usize,
    number: usize,
    fault: Option<Fault>,
}

impl<R: Read, T: Translate> Feed<R, T> {
    pub fn new(file: Capped<R>, translate: T) -> Self {
        Self {
            lines: LogicalLines::new(BufReader::with_capacity(1 << 16, file)),
            translate,
            raw: Vec::new(),
            text: String::new(),
            taken: 0,
            number: 0,
            fault: None,
        }
    }

    /// Reads to the end what the translator keeps to itself: it passes nothing on. Gives it
    /// and the bytes read.
    pub fn run(mut self) -> Result<(T, u64), Fault> {
        self.advance()?;
        let seen = self.lines.inner().get_ref().seen();
        Ok((self.translate, seen))
    }

    /// The translator, once `tobj` is done; or the fault, worded by `explain`
    /// from the line that `tobj` stopped at if the fault is of its finding.
    pub fn finish(
        self,
        error: Option<&tobj::LoadError>,
        explain: impl Fn(&str, &tobj::LoadError) -> String,
    ) -> Result<T, Fault> {
        match (self.fault, error) {
            (Some(fault), _) => Err(fault),
            (None, Some(error)) => Err(Fault::at(self.number, explain(&self.text, error))),
            (None, None) => Ok(self.translate),
        }
    }

    fn advance(&mut self) -> Result<(), Fault> {
        self.text.clear();
        self.taken = 0;
        while self.text.is_empty() {
            let next = self.lines.next(&mut self.raw);
            let next = next.map_err(|error| Fault::whole(format!("cannot be read: {error}")))?;
            let Some(number) = next else {
                return self.translate.end();
            };
            self.number = number;
            let line = String::from_utf8_lossy(&self.raw);
            self.translate.line(&line, number, &mut self.text)?;
        }
        self.text.push('\n');
        Ok(())
    }
}

impl<R: Read, T: Translate> BufRead for Feed<R, T> {
    fn fill_buf(&mut self) -> io::Result<&[u8]> {
        if self.taken == self.text.len() {
            self.advance().map_err(|fault| {
                self.fault = Some(fault);
                io::Error::other("a fault in the file")
            })?;
        }
        Ok(&self.text.as_bytes()[self.taken..])
    }

    fn consume(&mut self, amount: usize) {
        self.taken = (self.taken + amount).min(self.text.len());
    }
}

impl<R: Read, T: Translate> Read for Feed<R, T> {
    fn read(&mut self, buffer: &mut [u8]) -> io::Result<usize> {
        let count = self.fill_buf()?.read(buffer)?;
        self.consume(count);
        Ok(count)
    }
}
