//! The refusal of oil files in a build without the feature `case-files`.

use std::path::Path;
use std::sync::Arc;

use super::oil_file::OilFile;
use crate::input::files::{FileSums, Files, OIL_FILE};
use crate::source::case_error::CaseError;
use crate::source::section::Section;
use crate::source::source_text::Source;

/// Refuses an oil file.
pub(crate) fn oil_file(
    name: Option<&Path>,
    source: &Source,
    _: &Files,
) -> Result<(Option<Arc<OilFile>>, Arc<FileSums>), CaseError> {
    match name {
        None => Ok((None, Arc::default())),
        Some(_) => {
            let message = "is read only by a build with feature case-files";
            Err(Section::new(source, OIL_FILE).value("", message))
        }
    }
}
