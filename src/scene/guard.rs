//! The guarded reader: which files may be opened, and how much is read of them.

use std::fs::{self, File};
use std::io::{self, Read};
use std::path::{Path, PathBuf};

use crate::error::{Error, Result};

/// Why a file was not opened.
#[derive(Debug)]
pub(super) enum Refusal {
    Missing,
    Refused(String),
}

impl From<io::Error> for Refusal {
    fn from(error: io::Error) -> Self {
        match error.kind() {
            io::ErrorKind::NotFound => Refusal::Missing,
            _ => Refusal::Refused(format!("cannot be read: {error}")),
        }
    }
}

/// Opens regular files under one folder.
#[derive(Debug)]
pub(super) struct Guard {
    root: Option<PathBuf>,
}

impl Guard {
    /// `root` is the folder that files must lie under, symbolic links resolved.
    pub fn new(root: Option<&Path>) -> Result<Self> {
        let canonical = |root: &Path| {
            root.canonicalize().map_err(|error| Error::Asset {
                path: root.to_path_buf(),
                line: None,
                message: format!("the folder that files must lie under cannot be read: {error}"),
            })
        };
        Ok(Self {
            root: root.map(canonical).transpose()?,
        })
    }

    /// Opens `path` if it is a regular file of at most `max_bytes` under the
    /// root. The metadata comes first, for opening a FIFO would block.
    pub fn open(&self, path: &Path, max_bytes: u64) -> std::result::Result<Capped, Refusal> {
        let real = path.canonicalize()?;
        if let Some(root) = &self.root
            && !real.starts_with(root)
        {
            return Err(Refusal::Refused(format!(
                "`{}` lies outside `{}`; only files under that folder are read",
                path.display(),
                root.display()
            )));
        }
        let metadata = fs::metadata(&real)?;
        if !metadata.is_file() {
            return Err(Refusal::Refused(format!(
                "`{}` is not a regular file but {}",
                path.display(),
                if metadata.is_dir() {
                    "a folder"
                } else {
                    "a device, pipe or socket"
                }
            )));
        }
        if metadata.len() > max_bytes {
            return Err(Refusal::Refused(format!(
                "`{}` has {} bytes, more than the {max_bytes} allowed",
                path.display(),
                metadata.len()
            )));
        }
        Ok(Capped::new(File::open(&real)?, max_bytes))
    }
}

/// A file that fails once more than `max_bytes` came out of it: it may have
/// grown since its size was looked up, or (as under `/proc`) have none.
#[derive(Debug)]
pub(super) struct Capped<R = File> {
    inner: R,
    max_bytes: u64,
    seen: u64,
}

impl<R> Capped<R> {
    pub fn new(inner: R, max_bytes: u64) -> Self {
        Self {
            inner,
            max_bytes,
            seen: 0,
        }
    }

    pub fn seen(&self) -> u64 {
        self.seen
    }
}

impl<R: Read> Read for Capped<R> {
    fn read(&mut self, buffer: &mut [u8]) -> io::Result<usize> {
        let count = self.inner.read(buffer)?;
        self.seen += count as u64;
        if self.seen > self.max_bytes {
            return Err(io::Error::other(format!(
                "more than the {} bytes allowed",
                self.max_bytes
            )));
        }
        Ok(count)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_cap_holds_while_reading() {
        let read = |cap| {
            let mut bytes = Vec::new();
            Capped::new(&[0u8; 10][..], cap).read_to_end(&mut bytes)
        };
        assert!(read(10).is_ok());
        assert!(read(9).is_err());
    }
}
