//! The faults found so far, and which of them are worth telling.

use std::ops::Range;

use miette::NamedSource;

use super::lines::Lines;
use super::syntax::SyntaxError;
use crate::error::{Error, Fault, SceneFaults};
use crate::scene::check::{Flaw, Verdict};

/// More faults than this are only counted: nobody reads them, and underlining
/// each costs a pass over the file.
const MAX_FAULTS: usize = 100;

/// Collects the faults of one file.
pub(super) struct Faults<'t> {
    text: &'t str,
    lines: Lines,
    list: Vec<Fault>,
    left_out: usize,
    /// The tables that could not be read whole, in order: whether something is
    /// missing there cannot be said.
    broken: Vec<Range<usize>>,
    /// Could one of them be the camera?
    pub(super) hides_camera: bool,
    /// Could one of them be a material?
    pub(super) hides_material: bool,
}

impl<'t> Faults<'t> {
    /// Starts with what the TOML parser could not read.
    pub(super) fn new(text: &'t str, syntax: Vec<SyntaxError>, broken: Vec<Range<usize>>) -> Self {
        let may_hide = |name| {
            let header = |part: &Range<usize>| text.get(part.clone())?.lines().next();
            let mut headers = broken.iter().filter_map(header);
            headers.any(|line| line.contains(name))
        };
        let mut faults = Self {
            text,
            lines: Lines::of(text),
            list: Vec::new(),
            left_out: 0,
            hides_camera: may_hide("camera"),
            hides_material: may_hide("material"),
            broken,
        };
        for SyntaxError { span, message } in syntax {
            faults.add(span, format!("TOML syntax: {message}"), "here", None);
        }
        faults
    }

    /// Records a fault.
    pub(super) fn push(
        &mut self,
        span: Range<usize>,
        message: impl Into<String>,
        label: &str,
        help: impl Into<String>,
    ) {
        self.add(span, message.into(), label, Some(help.into()));
    }

    /// Is the table whose header stands there free of syntax errors?
    pub(super) fn is_whole(&self, header: &Range<usize>) -> bool {
        let next = self.broken.partition_point(|b| b.start <= header.start);
        !self.broken[..next]
            .last()
            .is_some_and(|b| b.contains(&header.start))
    }

    /// Are faults only counted by now? Then their help need not be thought of.
    pub(super) fn is_full(&self) -> bool {
        self.list.len() == MAX_FAULTS
    }

    /// Records a broken rule; was the rule kept?
    pub(super) fn judge(&mut self, span: Range<usize>, verdict: Verdict) -> bool {
        match verdict {
            Ok(()) => true,
            Err(Flaw {
                message,
                label,
                help,
            }) => {
                self.push(span, message, label, help);
                false
            }
        }
    }

    /// The file's text at a span, for messages.
    pub(super) fn text_at(&self, span: Range<usize>) -> &'t str {
        self.text.get(span).unwrap_or_default()
    }

    /// The line of a header, from 1.
    pub(super) fn line_of(&self, header: &Range<usize>) -> u32 {
        self.lines.line(header.start)
    }

    /// Is the file without a fault so far?
    pub(super) fn is_empty(&self) -> bool {
        self.list.is_empty()
    }

    /// The error that tells all faults in the order of the file.
    pub(super) fn into_error(mut self, name: &str) -> Error {
        self.list.sort_by_key(|fault| fault.span.start);
        if self.left_out > 0 {
            self.list.push(Fault {
                message: format!("and {} more faults", self.left_out),
                help: Some(format!("the first {MAX_FAULTS} found are listed above")),
                span: self.text.len()..self.text.len(),
                label: "end of the file".into(),
            });
        }
        Error::Scene(Box::new(SceneFaults {
            source_code: NamedSource::new(name, self.text.to_owned()),
            faults: self.list,
        }))
    }

    fn add(&mut self, span: Range<usize>, message: String, label: &str, help: Option<String>) {
        if self.is_full() {
            self.left_out += 1;
            return;
        }
        self.list.push(Fault {
            message,
            help,
            span,
            label: label.into(),
        });
    }
}
