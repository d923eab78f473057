//! Shader files and their concatenation.
//!
//! WGSL's module scope knows no order, so a module is simply the files that a
//! scene calls for, one after the other.

/// A shader file, embedded in the program.
#[derive(Debug, Clone, Copy)]
pub struct Source {
    /// The file's name under `shaders/`.
    pub name: &'static str,
    /// Its text.
    pub text: &'static str,
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
            wgsl.push_str(file.text);
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
            Source {
                name: "one.wgsl",
                text: "a\nb\n",
            },
            Source {
                name: "two.wgsl",
                text: "c\nd\n",
            },
        ]);
        let at = |letter| assembly.place(assembly.wgsl.find(letter).unwrap());
        assert_eq!(at('b'), "shaders/one.wgsl:2");
        assert_eq!(at('c'), "shaders/two.wgsl:1");
        assert_eq!(at('d'), "shaders/two.wgsl:2");
    }
}
