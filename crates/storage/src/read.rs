//! Reading of regular files of a bounded size. `clippy.toml` forbids the functions of the standard library that open
//! any kind of file of any size.

use std::fs::{File, metadata};
use std::io::{Error, ErrorKind, Read, Result};
use std::path::Path;

/// Opens the regular file at `path`. Opening a pipe would wait for its writer, and a device never ends.
///
/// # Errors
/// When the system refuses, or it is a folder, a device or a pipe.
pub fn regular_file(path: &Path) -> Result<File> {
    let kind = metadata(path)?.file_type();
    if kind.is_dir() {
        return Err(Error::new(
            ErrorKind::IsADirectory,
            "it is a folder and not a file",
        ));
    }
    if !kind.is_file() {
        return Err(Error::other("it is a device or a pipe and not a file"));
    }
    #[expect(
        clippy::disallowed_methods,
        reason = "the one reader, once it is a file"
    )]
    File::open(path)
}

/// Reads the file at `path` of at most `most` bytes.
///
/// # Errors
/// When the system refuses, it is not a regular file, or it is larger.
///
/// ```
/// use asperity_storage::whole_file;
/// assert!(whole_file("Cargo.toml".as_ref(), 10).is_err_and(|error| error.to_string().contains("larger")));
/// assert!(whole_file("Cargo.toml".as_ref(), 1 << 20)?.starts_with(b"[package]"));
/// # Ok::<(), std::io::Error>(())
/// ```
pub fn whole_file(path: &Path, most: u64) -> Result<Vec<u8>> {
    let mut bytes = Vec::new();
    regular_file(path)?
        .take(most.saturating_add(1))
        .read_to_end(&mut bytes)?;
    if bytes.len() as u64 > most {
        return Err(Error::other(format!(
            "it is larger than {} MB, the most that is read",
            most / 1_000_000
        )));
    }
    Ok(bytes)
}

/// Reads the UTF-8 text of the file at `path` of at most `most` bytes.
///
/// # Errors
/// As [`whole_file`], and when it is not UTF-8.
///
/// ```
/// use asperity_storage::whole_text;
/// assert!(whole_text("Cargo.toml".as_ref(), 1 << 20)?.contains("[package]"));
/// # Ok::<(), std::io::Error>(())
/// ```
pub fn whole_text(path: &Path, most: u64) -> Result<String> {
    let bytes = whole_file(path, most)?;
    String::from_utf8(bytes).map_err(|_| Error::new(ErrorKind::InvalidData, "it is not UTF-8 text"))
}
