//! Atomic writing of files and folders, and bounded reading of files.
//!
//! It is used by all crates that read or write files, above all `case`, `report` and `studies`. It does not know what a file contains.
//!
//! | task | method |
//! |---|---|
//! | reading a file ([`whole_file`]) | regular files of a bounded size; no device, no pipe |
//! | writing a file ([`save`]) | written to a draft, flushed to the disk, renamed |
//! | writing a file whose name the user did not choose ([`save_new`]) | as [`save`], but never replacing another file |
//! | replacing a folder ([`replace_folder`]) | filled as a draft, flushed, exchanged with the older folder by one rename, or by two with a journal if the system has no exchange |
//! | files in a folder with other files ([`write_among`]) | each by [`save`], the manifest before and after |
//! | a stored result ([`seal`], [`unseal`]) | used only with the right name, version and SHA-256 |
//! | files read back ([`check_written`]) | by the manifest that was written with them |
//! | ownership | a manifest with the SHA-256 of every file; a file that is not in it, or was changed, is never touched; a manifest with a path out of its folder is not accepted |
//! | killed processes | the system releases the locks of their drafts; the next process that writes there recovers or removes them |
//! | signals | [`abandon`] removes the drafts of this process |
//!
//! Links are never followed. Parent folders are created for a folder, but not for a single file.
//!
//! The feature `write` (on by default) has everything that writes; without it the crate reads files, checks numbers and
//! makes text harmless.
//!
#![doc = include_str!("../README.md")]

mod checksum;
mod finite;
mod json;
mod plain_text;
mod read;
mod sealed;
#[cfg(feature = "write")]
mod write;

pub use checksum::{hex, sha256};
pub use finite::{NotFinite, check_finite};
pub use json::{NotJson, json_line, json_text, json_value};
pub use plain_text::{cell, line_of_cells, one_line, printable, text_of_cell};
pub use read::{regular_file, whole_file, whole_text};
pub use sealed::{seal, unseal};
#[cfg(feature = "write")]
pub use write::{
    Draft, MANIFEST, StorageError, abandon, check_among, check_folder, check_written, new_folder,
    new_folder_of, replace_folder, save, save_new, write_among,
};
