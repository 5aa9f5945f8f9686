//! Names of the windows in contact in a case file.

use serde::{Deserialize, Serialize};

/// Part of the flanks that meets in a window.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Serialize, Deserialize)]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
#[serde(rename_all = "kebab-case")]
#[non_exhaustive]
pub enum ContactName {
    /// Two traces, as ridges without an end along the lead.
    Lines,
    /// Two surfaces with all of their rows: scans, or one scan and a surface made from the other trace.
    Patch,
}
