//! Atomic writing of files and folders.

mod among;
mod draft;
mod error;
mod file;
mod folder;
mod manifest;
mod recovery;
mod system;

pub use among::{check_among, check_written, write_among};
pub use draft::{Draft, abandon};
pub use error::StorageError;
pub use file::{save, save_new};
pub use folder::{check_folder, new_folder, new_folder_of, replace_folder};
pub use manifest::MANIFEST;
