//! System calls: flushing to the disk, exchange of two names, metadata without following links.

use std::fs::{self, File, Metadata};
use std::io;
use std::path::Path;

/// The folder of `file`.
pub fn parent_of(file: &Path) -> &Path {
    match file.parent() {
        Some(parent) if !parent.as_os_str().is_empty() => parent,
        _ => Path::new("."),
    }
}

/// Metadata of `path` without following a link; `None` if it does not exist.
pub fn look(path: &Path) -> io::Result<Option<Metadata>> {
    match fs::symlink_metadata(path) {
        Ok(entry) => Ok(Some(entry)),
        Err(error)
            if matches!(
                error.kind(),
                io::ErrorKind::NotFound | io::ErrorKind::NotADirectory
            ) =>
        {
            Ok(None)
        }
        Err(error) => Err(error),
    }
}

/// Flushes the entries of `folder` to the disk, where the system can.
pub fn sync_folder(folder: &Path) -> io::Result<()> {
    if cfg!(unix) {
        #[expect(clippy::disallowed_methods, reason = "a folder, which is not read")]
        File::open(folder)?.sync_all()?;
    }
    Ok(())
}

/// Flushes every file and folder in `folder` to the disk.
pub fn sync_tree(folder: &Path) -> io::Result<()> {
    for entry in fs::read_dir(folder)? {
        let entry = entry?;
        if entry.file_type()?.is_dir() {
            sync_tree(&entry.path())?;
        } else {
            // Windows flushes files that are open for writing only.
            File::options()
                .read(true)
                .write(true)
                .open(entry.path())?
                .sync_all()?;
        }
    }
    sync_folder(folder)
}

/// Exchanges the names of `a` and `b` atomically; false if the system or the file system does not support it.
#[cfg(target_os = "linux")]
pub fn exchanged(a: &Path, b: &Path) -> io::Result<bool> {
    use rustix::fs::{CWD, RenameFlags, renameat_with};
    use rustix::io::Errno;
    match renameat_with(CWD, a, CWD, b, RenameFlags::EXCHANGE) {
        Ok(()) => Ok(true),
        Err(Errno::INVAL | Errno::NOSYS | Errno::NOTSUP) => Ok(false),
        Err(error) => Err(error.into()),
    }
}

/// Exchanges the names of `a` and `b` atomically; false if the system or the file system does not support it.
#[cfg(not(target_os = "linux"))]
pub fn exchanged(_a: &Path, _b: &Path) -> io::Result<bool> {
    Ok(false)
}
