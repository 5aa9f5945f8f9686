//! A whole file at once, where it is a file and of a bounded size.

use std::fs::{File, metadata};
use std::io::{Error, Read, Result};
use std::path::Path;

/// The file at `path`, opened: opening a pipe would wait for its writer, and a device never ends.
///
/// # Errors
/// When the system refuses, or it is a device or a pipe.
pub fn regular_file(path: &Path) -> Result<File> {
    let kind = metadata(path)?.file_type();
    if !kind.is_file() && !kind.is_dir() {
        return Err(Error::other("it is a device or a pipe and not a file"));
    }
    File::open(path)
}

/// The bytes of the file at `path`, of which there may be `most`.
///
/// # Errors
/// When the system refuses, it is a device or a pipe, or it is larger.
///
/// ```
/// use asperity_profile_io::read::whole_file;
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
        let text = format!(
            "it is larger than {} MB, the most that is read",
            most / 1_000_000
        );
        return Err(Error::other(text));
    }
    Ok(bytes)
}
