//! A profile with all that was found out about its file.

use asperity_core::Profile;
use asperity_core::quantity::Length;
use serde::Serialize;

use super::format::Format;
use super::grid::SpacingSource;
use super::header::FilterState;
use super::layout::TableLayout;
use super::metadata::Metadata;
use super::options::{Encoding, LengthUnit};
use crate::warning::Warning;

/// A profile with all that was found out about its file. Serialises without the heights, as the echo.
#[derive(Debug, Clone, PartialEq, Serialize)]
#[non_exhaustive]
pub struct Reading {
    /// Name of the file as given.
    pub name: String,
    /// The profile, heights as in the file (no offset, form or tilt removed).
    #[serde(skip)]
    pub profile: Profile,
    /// Format of the file.
    pub format: Format,
    /// Character encoding; none for binary formats.
    pub encoding: Option<Encoding>,
    /// How the table is written; none for formats that are no table.
    pub table: Option<TableLayout>,
    /// Unit of x; none when the spacing was stated and no x column was needed.
    pub x_unit: Option<LengthUnit>,
    /// Unit of the heights in the file.
    pub z_unit: LengthUnit,
    /// Distance between points.
    pub spacing: Length,
    /// How the spacing was found.
    pub spacing_source: SpacingSource,
    /// Length of the trace, (n − 1)·dx.
    pub length: Length,
    /// Whether the file says its heights are filtered.
    pub filter_state: FilterState,
    /// Number of points n.
    pub points: usize,
    /// Points that were interpolated on request.
    pub gaps_filled: usize,
    /// What the file says beside the heights.
    pub metadata: Metadata,
    /// What the user should know.
    pub warnings: Vec<Warning>,
}
