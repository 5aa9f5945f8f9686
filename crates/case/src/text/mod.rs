//! Cases, gear trains and oil files as text.
//!
//! Built with the feature `case-files`; without it `no_text.rs` is in the place of this module.

pub mod case_file;
pub mod gathered;
pub mod key_names;
pub mod keyed;
pub mod known_keys;
pub mod parsed;
pub mod plain_words;
pub mod symbols;
pub mod written;

pub(crate) use case_file::is_key_of_named_meshes;
pub(crate) use key_names::{key_of, missing_key};
