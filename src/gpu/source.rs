//! Shader files and their concatenation.
//!
//! WGSL's module scope knows no order, so a module is simply the files that a
//! scene calls for, one after the other.

use std::collections::HashSet;

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

    /// Whether it is the same file, taken for the same numbers.
    pub fn is_same(&self, other: &Self) -> bool {
        self.name == other.name && self.single == other.single
    }

    /// The file once more for f32: `real` becomes `f32`, and each name that it defines gets
    /// the ending `_f32`. WGSL has no generics.
    pub const fn in_f32(self) -> Self {
        Self {
            single: true,
            ..self
        }
    }
}

/// The names that a file defines.
fn defined_names(text: &str) -> impl Iterator<Item = &str> {
    text.lines().filter_map(|line| {
        let mut kinds = ["fn ", "const ", "struct "].into_iter();
        let rest = kinds.find_map(|kind| line.strip_prefix(kind))?;
        rest.split(|c: char| !is_word(c)).next()
    })
}

/// See [`Source::in_f32`]; `names` are those of all such files.
fn in_f32(text: &str, names: &HashSet<&str>) -> String {
    let mut changed = String::with_capacity(text.len());
    let mut rest = text;
    while let Some(begin) = rest.find(is_word) {
        let word = &rest[begin..];
        let end = word.find(|c| !is_word(c)).unwrap_or(word.len());
        changed.push_str(&rest[..begin]);
        match &word[..end] {
            "real" => changed.push_str("f32"),
            name if names.contains(name) => {
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
        let singles = files.iter().filter(|file| file.single);
        let names = singles.flat_map(|file| defined_names(file.text)).collect();
        for file in files {
            starts.push((file.name, wgsl.len()));
            if file.single {
                wgsl.push_str(&in_f32(file.text, &names));
            } else {
                wgsl.push_str(file.text);
            }
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
        let one = "const K: f32 = 1;\nfn half(a: real) -> real { return a * K + two(a); }";
        let two = "fn two(a: real) -> real { return a + halfway(a); }";
        let [one, two] = [Source::new("one.wgsl", one), Source::new("two.wgsl", two)];
        let single = Assembly::join(&[one.in_f32(), two.in_f32()]).wgsl;
        let expected = "const K_f32: f32 = 1;\n\
            fn half_f32(a: f32) -> f32 { return a * K_f32 + two_f32(a); }\n\
            fn two_f32(a: f32) -> f32 { return a + halfway(a); }\n";
        assert_eq!(single, expected);
        assert!(Assembly::join(&[one]).wgsl.starts_with(one.text));
    }
}
