//! Transient reference solutions along the path of contact: the load share `ehl`.
//!
//! `PathRecords` solves the rough contact of a case at a few places of the path, each over a travel of some
//! half-widths, and interpolates shares, films and friction between them. [`RecordStore`] keeps what was solved
//! by its content, so that a second run solves nothing.

mod along_path;
mod path_record;
mod store;

pub(crate) use along_path::{PathRecords, PlacedRecord};
pub use asperity_case::recorded_share::RecordedShare;
pub use path_record::PathRecord;
pub use store::RecordStore;
