//! Files are written whole or not at all.

use std::fs;
use std::io::{self, ErrorKind, Write};
use std::path::{Path, PathBuf};
use std::sync::Mutex;

use tempfile::{Builder, NamedTempFile};

use crate::{Error, Result};

/// Held while a temporary file exists.
static WRITING: Mutex<()> = Mutex::new(());

/// Calls `end` at a moment when no file is being written, so that a process which
/// ends in it leaves no temporary file behind.
pub fn while_nothing_is_written<T>(end: impl FnOnce() -> T) -> T {
    let _nothing = WRITING.lock().unwrap_or_else(|e| e.into_inner());
    end()
}

/// Writes a file so that `path` holds the old content or all of the new one,
/// never a part: the bytes go to a temporary file in the same folder, to the
/// disk, and then to their name in one step. A new file gets the permissions
/// that the umask leaves, an old one keeps its own, and a symbolic link stays
/// one. What is no regular file (a device, a pipe) is written directly.
///
/// # Errors
/// [`Error::Output`] with what the system said.
pub fn write_atomically(path: &Path, bytes: &[u8]) -> Result<()> {
    let write = || match destination(path)? {
        Destination::Special => fs::OpenOptions::new()
            .write(true)
            .open(path)?
            .write_all(bytes),
        Destination::File { path, old } => while_nothing_is_written(|| {
            let mut file = temporary_beside(&path)?;
            file.write_all(bytes)?;
            if let Some(old) = old {
                file.as_file().set_permissions(old)?;
            }
            file.as_file().sync_all()?;
            file.persist(&path).map_err(|e| e.error)?;
            Ok(())
        }),
    };
    write().map_err(|source| output_error(path, source))
}

/// Whether [`write_atomically`] could write here now; asked before a long
/// render. Makes and removes an empty temporary file in the folder.
///
/// # Errors
/// [`Error::Output`] where the folder is missing or cannot be written to, where
/// `path` is a folder, or where the old file is read-only.
pub fn check_writable(path: &Path) -> Result<()> {
    let check = || match destination(path)? {
        Destination::Special => Ok(()),
        Destination::File { path, .. } => {
            while_nothing_is_written(|| temporary_beside(&path).map(drop))
        }
    };
    check().map_err(|source| output_error(path, source))
}

pub(super) fn output_error(path: &Path, source: io::Error) -> Error {
    Error::Output {
        path: path.to_owned(),
        source,
    }
}

enum Destination {
    /// A device, a pipe or a socket.
    Special,
    /// A regular file, links followed, with its permissions if there is one.
    File {
        path: PathBuf,
        old: Option<fs::Permissions>,
    },
}

fn destination(path: &Path) -> io::Result<Destination> {
    let metadata = match fs::metadata(path) {
        Err(e) if e.kind() == ErrorKind::NotFound => return new_file(path),
        metadata => metadata?,
    };
    if metadata.is_dir() {
        let message = "it is a folder: name a file in it";
        return Err(io::Error::new(ErrorKind::IsADirectory, message));
    }
    if !metadata.is_file() {
        return Ok(Destination::Special);
    }
    // Renaming would replace it all the same, against its owner's wish.
    if metadata.permissions().readonly() {
        let message = "the old file is read-only";
        return Err(io::Error::new(ErrorKind::PermissionDenied, message));
    }
    Ok(Destination::File {
        path: path.canonicalize()?,
        old: Some(metadata.permissions()),
    })
}

fn new_file(path: &Path) -> io::Result<Destination> {
    if path.file_name().is_none() {
        let message = "the path names no file";
        return Err(io::Error::new(ErrorKind::InvalidInput, message));
    }
    if path.is_symlink() {
        let message = "it is a symbolic link to a file that does not exist";
        return Err(io::Error::new(ErrorKind::NotFound, message));
    }
    let folder = folder_of(path);
    if !folder.is_dir() {
        let message = format!("there is no folder '{}'", folder.display());
        return Err(io::Error::new(ErrorKind::NotFound, message));
    }
    Ok(Destination::File {
        path: path.to_owned(),
        old: None,
    })
}

fn folder_of(path: &Path) -> &Path {
    match path.parent() {
        Some(folder) if !folder.as_os_str().is_empty() => folder,
        _ => Path::new("."),
    }
}

fn temporary_beside(path: &Path) -> io::Result<NamedTempFile> {
    let mut builder = Builder::new();
    builder.prefix(".rayproof-").suffix(".tmp");
    // A temporary file is its owner's alone by default; the picture is to have
    // what any new file has. The system takes the umask off.
    #[cfg(unix)]
    {
        use std::os::unix::fs::PermissionsExt;
        builder.permissions(fs::Permissions::from_mode(0o666));
    }
    builder.tempfile_in(folder_of(path))
}

#[cfg(test)]
mod tests;
