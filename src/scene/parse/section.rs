//! A table of the file, read key by key; what was not asked for is unknown.

use std::ops::Range;

use toml::de::{DeTable, DeValue};

use super::faults::Faults;
use super::near::suggestion;
use super::value::{Value, type_name, wrong_type};

/// Something read, and where it stands.
#[derive(Debug, Clone)]
pub(super) struct Found<T> {
    pub(super) value: T,
    pub(super) span: Range<usize>,
}

impl<T> Found<T> {
    pub(super) fn map<U>(self, f: impl FnOnce(T) -> U) -> Found<U> {
        Found {
            value: f(self.value),
            span: self.span,
        }
    }
}

/// One table being read.
pub(super) struct Section<'a, 'i> {
    /// As a user would write it: `[camera]`, `[[sphere]]`, `grid`.
    title: &'static str,
    /// The header, for what is missing.
    pub(super) span: Range<usize>,
    table: &'a DeTable<'i>,
    asked: Vec<&'static str>,
}

impl<'a, 'i> Section<'a, 'i> {
    pub(super) fn new(title: &'static str, span: Range<usize>, table: &'a DeTable<'i>) -> Self {
        Self {
            title,
            span,
            table,
            asked: Vec::new(),
        }
    }

    /// The table within a value.
    pub(super) fn within(
        title: &'static str,
        value: &'a Value<'i>,
        faults: &mut Faults<'_>,
    ) -> Option<Self> {
        match value.get_ref() {
            DeValue::Table(table) => Some(Self::new(title, value.span(), table)),
            _ => {
                wrong_type(value, title, "a table", faults);
                None
            }
        }
    }

    /// The value of a key as it stands.
    pub(super) fn value(&mut self, key: &'static str) -> Option<&'a Value<'i>> {
        self.asked.push(key);
        self.table.get(key)
    }

    /// Where the value of a key stands; the key stays unknown until it is asked for.
    pub(super) fn span_of(&self, key: &str) -> Option<Range<usize>> {
        self.table.get(key).map(Value::span)
    }

    /// Accepts keys without reading them.
    pub(super) fn know(&mut self, keys: &[&'static str]) {
        self.asked.extend(keys);
    }

    /// Is the key there? It stays unknown until it is asked for.
    pub(super) fn has(&self, key: &str) -> bool {
        self.table.contains_key(key)
    }

    /// A key that may be absent.
    pub(super) fn optional<T>(
        &mut self,
        key: &'static str,
        faults: &mut Faults<'_>,
        read: impl FnOnce(&Value<'_>, &str, &mut Faults<'_>) -> Option<T>,
    ) -> Option<Found<T>> {
        let value = self.value(key)?;
        Some(Found {
            value: read(value, key, faults)?,
            span: value.span(),
        })
    }

    /// A key that may be absent, with its default. A fault stands in the list,
    /// so that it does not matter what is returned for it.
    pub(super) fn or<T>(
        &mut self,
        key: &'static str,
        default: T,
        faults: &mut Faults<'_>,
        read: impl FnOnce(&Value<'_>, &str, &mut Faults<'_>) -> Option<T>,
    ) -> T {
        self.optional(key, faults, read)
            .map_or(default, |found| found.value)
    }

    /// A key that must be there.
    pub(super) fn required<T>(
        &mut self,
        key: &'static str,
        faults: &mut Faults<'_>,
        read: impl FnOnce(&Value<'_>, &str, &mut Faults<'_>) -> Option<T>,
    ) -> Option<Found<T>> {
        if !self.has(key) {
            self.asked.push(key);
            if faults.is_whole(&self.span) {
                faults.push(
                    self.span.clone(),
                    format!("{} lacks `{key}`", self.title),
                    &format!("`{key}` is missing"),
                    format!("add `{key} = ...`"),
                );
            }
            return None;
        }
        self.optional(key, faults, read)
    }

    /// Tables under a key, written `[[key]]` or as an array of inline tables.
    pub(super) fn tables(
        &mut self,
        key: &'static str,
        title: &'static str,
        faults: &mut Faults<'_>,
    ) -> Vec<Section<'a, 'i>> {
        let Some(value) = self.value(key) else {
            return Vec::new();
        };
        let DeValue::Array(items) = value.get_ref() else {
            wrong_brackets(value, &format!("one {title} or more"), title, faults);
            return Vec::new();
        };
        items
            .iter()
            .filter_map(|item| Section::within(title, item, faults))
            .collect()
    }

    /// The table under a key, where there is one.
    pub(super) fn table(
        &mut self,
        key: &'static str,
        title: &'static str,
        faults: &mut Faults<'_>,
    ) -> Option<Section<'a, 'i>> {
        let value = self.value(key)?;
        let DeValue::Table(table) = value.get_ref() else {
            wrong_brackets(value, &format!("one {title}"), title, faults);
            return None;
        };
        Some(Section::new(title, value.span(), table))
    }

    /// Records every key that nobody asked for.
    pub(super) fn close(self, faults: &mut Faults<'_>) {
        for key in self.table.keys() {
            let name = key.get_ref().as_ref();
            if !self.asked.contains(&name) {
                faults.push(
                    key.span(),
                    format!("unknown key `{name}` in {}", self.title),
                    "unknown key",
                    match faults.is_full() {
                        true => String::new(),
                        false => suggestion(name, "known keys are", self.asked.iter().copied()),
                    },
                );
            }
        }
    }

    /// Records a fault with the whole table; its keys are then not looked at.
    pub(super) fn reject(self, faults: &mut Faults<'_>, message: String, help: &str) {
        faults.push(self.span, message, "here", help);
    }
}

fn wrong_brackets(value: &Value<'_>, expected: &str, title: &str, faults: &mut Faults<'_>) {
    let found = type_name(value.get_ref());
    faults.push(
        value.span(),
        format!("expected {expected}, found {found}"),
        found,
        format!("write the header as {title}"),
    );
}
