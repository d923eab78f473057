//! Shader files and their concatenation.
//!
//! WGSL's module scope knows no order, so a module is simply the files that a
//! scene calls for, one after the other.

use std::borrow::Cow;

/// A shader file, embedded in the program.
#[derive(Debug, Clone, Copy)]
pub struct Source {
    /// The file's name under `shaders/`.
    pub name: &'static str,
    /// Its text.
    pub text: &'static str,
    /// Whether it is taken for f32 whatever the geometry's width, see [`Source::in_f32`].
    pub single: bool,
}

impl Source {
    /// A file.
    pub const fn new(name: &'static str, text: &'static str) -> Self {
        Self {
            name,
            text,
            single: false,
        }
    }

    /// The file once more for f32: `real` becomes `f32`, and each name that it defines gets
    /// the ending `_f32`. WGSL has no generics.
    pub const fn in_f32(self) -> Self {
        Self {
            single: true,
            ..self
        }
    }

    fn joined_text(&self) -> Cow<'static, str> {
        if self.single {
            in_f32(self.text).into()
        } else {
            self.text.into()
        }
    }
}

/// See [`Source::in_f32`].
fn in_f32(text: &str) -> String {
    let defined: Vec<&str> = text
        .lines()
        .filter_map(|line| {
            let rest = ["fn ", "const ", "struct "]
                .iter()
                .find_map(|word| line.strip_prefix(word))?;
            rest.split(|c: char| !is_word(c)).next()
        })
        .collect();
    let mut changed = String::with_capacity(text.len());
    let mut rest = text;
    while let Some(begin) = rest.find(is_word) {
        let word = &rest[begin..];
        let end = word.find(|c| !is_word(c)).unwrap_or(word.len());
        changed.push_str(&rest[..begin]);
        match &word[..end] {
            "real" => changed.push_str("f32"),
            name if defined.contains(&name) => {
                changed.push_str(name);
                changed.push_str("_f32");
            }
            other => changed.push_str(other),
        }
        rest = &word[end..];
    }
    changed.push_str(rest);
    changed
}

fn is_word(c: char) -> bool {
    c.is_ascii_alphanumeric() || c == '_'
}

/// Files joined into one module.
#[derive(Debug, Clone)]
pub struct Assembly {
    /// The module's text.
    pub wgsl: String,
    /// Each file's name and the byte at which it begins.
    files: Vec<(&'static str, usize)>,
}

impl Assembly {
    /// Joins files in the order given.
    pub fn join(files: &[Source]) -> Self {
        let mut wgsl = String::new();
        let mut starts = Vec::new();
        for file in files {
            starts.push((file.name, wgsl.len()));
            wgsl.push_str(&file.joined_text());
            wgsl.push('\n');
        }
        Self {
            wgsl,
            files: starts,
        }
    }

    /// Where a byte of the module stands, as `file:line`.
    pub fn place(&self, byte: usize) -> String {
        let byte = byte.min(self.wgsl.len());
        let Some(&(name, start)) = self.files.iter().rev().find(|(_, start)| *start <= byte) else {
            return format!("byte {byte}");
        };
        let line = self.wgsl[start..byte].matches('\n').count() + 1;
        format!("shaders/{name}:{line}")
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_byte_is_mapped_to_its_file_and_line() {
        let assembly = Assembly::join(&[
            Source::new("one.wgsl", "a\nb\n"),
            Source::new("two.wgsl", "c\nd\n"),
        ]);
        let at = |letter| assembly.place(assembly.wgsl.find(letter).unwrap());
        assert_eq!(at('b'), "shaders/one.wgsl:2");
        assert_eq!(at('c'), "shaders/two.wgsl:1");
        assert_eq!(at('d'), "shaders/two.wgsl:2");
    }

    #[test]
    fn a_file_is_taken_for_f32_too() {
        let text =
            "const K: f32 = 1;\nfn half(a: real) -> real {\n    return a * K + halfway(a);\n}";
        let single = "const K_f32: f32 = 1;\nfn half_f32(a: f32) -> f32 {\n    return a * K_f32 + halfway(a);\n}";
        let file = Source::new("half.wgsl", text);
        assert_eq!(file.in_f32().joined_text(), single);
        assert_eq!(file.joined_text(), text);
    }
}
