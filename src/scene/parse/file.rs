//! The scene file's bytes: a regular file, of bounded size, in UTF-8.

use std::fs::{self, File};
use std::io::Read;
use std::path::Path;

use crate::{Error, Result};

/// Reads the text of a scene file, without a byte-order mark.
pub(super) fn read(path: &Path, max_bytes: u64) -> Result<String> {
    let fail = |line, message| Error::Asset {
        path: path.to_owned(),
        line,
        message,
    };
    let system = |error: std::io::Error| fail(None, format!("cannot be read: {error}"));
    // Before it is opened: opening a FIFO waits for a writer.
    if !fs::metadata(path).map_err(system)?.is_file() {
        let message = "is not a regular file; a scene is a TOML file";
        return Err(fail(None, message.into()));
    }
    let mut bytes = Vec::new();
    File::open(path)
        .and_then(|file| {
            file.take(max_bytes.saturating_add(1))
                .read_to_end(&mut bytes)
        })
        .map_err(system)?;
    if bytes.len() as u64 > max_bytes {
        let message = format!(
            "is larger than {max_bytes} bytes, the most that a scene file may have; \
             `grid` and [[mesh]] describe many shapes in few bytes"
        );
        return Err(fail(None, message));
    }
    String::from_utf8(bytes).map_err(|error| {
        let valid = error.utf8_error().valid_up_to();
        let bytes = error.as_bytes();
        let line = 1 + bytes[..valid].iter().filter(|&&b| b == b'\n').count();
        let message = format!(
            "the byte 0x{:02x} is not UTF-8; save the file in UTF-8",
            bytes.get(valid).copied().unwrap_or_default()
        );
        fail(Some(line), message)
    })
}
