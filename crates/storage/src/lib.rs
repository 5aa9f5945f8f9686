//! Files and folders written whole or not at all, and the one reader of files.
//!
//! | what | how |
//! |---|---|
//! | a file that is read ([`whole_file`]) | a regular file of a bounded size; no device, no pipe |
//! | a file ([`save`]) | written beside its place, flushed to the disk, renamed |
//! | a file whose name nobody chose ([`save_new`]) | the same, but never over another |
//! | a folder ([`replace_folder`]) | filled beside its place, flushed, exchanged with the older one by one rename where the system can, by two with a journal where it cannot |
//! | our files among others ([`write_among`]) | each as a file, the manifest before and after |
//! | what is ours | a manifest with the SHA-256 of every file; whatever is not in it, or was changed since, is never touched; a manifest with a name that leads out of its folder is not ours |
//! | a killed process | its drafts hold a lock with a text of ours, which the system released; the next process that writes there restores and removes |
//! | a signal | [`abandon`] removes the drafts of this process |
//!
//! Links are never followed onto the file behind them. Folders on the way are made for a folder, not for
//! a single file, whose folder must exist.

mod among;
mod draft;
mod error;
mod file;
mod finite;
mod folder;
mod manifest;
mod plain_text;
mod read;
mod recovery;
mod system;

pub use among::{check_among, write_among};
pub use draft::{Draft, abandon};
pub use error::StorageError;
pub use file::{save, save_new};
pub use finite::{NotFinite, check_finite};
pub use folder::{check_folder, new_folder, replace_folder};
pub use manifest::MANIFEST;
pub use plain_text::{cell, one_line, printable};
pub use read::{regular_file, whole_file, whole_text};
