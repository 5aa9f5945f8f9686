//! Cases, gear trains and oil files as text, and keys set by name.
//!
//! Built with the feature `case-files`; without it `no_text.rs` is in the place of this module.

mod case_file;
mod check;
mod gathered;
mod key_names;
mod keyed;
pub(super) mod known_keys;
mod load;
mod oil_file;
mod oil_file_text;
mod page;
mod parsed;
mod plain_words;
mod set;
mod symbols;
mod written;

pub(super) use case_file::is_key_of_named_meshes;
pub use case_file::{schema, schema_of_named_meshes};
pub use check::{Findings, check};
pub(super) use key_names::{key_of, missing_key};
pub use load::{
    Change, Resolver, from_contents, from_text, load, load_holding, load_set, load_with,
    open_source,
};
pub(super) use oil_file::oil_file;
pub use page::markdown;
