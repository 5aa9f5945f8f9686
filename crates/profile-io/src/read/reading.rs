//! A profile with the facts about its file.

use std::ops::Deref;

use asperity_core::Profile;
use asperity_core::quantity::Length;
use serde::{Deserialize, Serialize};

use super::cut::TraceCut;
use super::error::{ReadError, ReadFault};
use super::format::Format;
use super::grid::SpacingSource;
use super::header::FilterState;
use super::layout::TableLayout;
use super::metadata::Metadata;
use super::options::{Encoding, LengthUnit};
use super::steepness::implausible;
use crate::warning::Warning;

/// A profile with the record of its reading, whose facts are read as its own. The heights are not serialised.
#[derive(Debug, Clone, PartialEq, Serialize)]
#[non_exhaustive]
pub struct Reading {
    /// The profile, heights out of the material, as in the file (no offset, form or tilt removed).
    #[serde(skip)]
    pub profile: Profile,
    /// The facts about the file.
    #[serde(flatten)]
    pub record: ReadingRecord,
    /// Whether the header of the file scaled the heights.
    #[serde(skip)]
    pub(super) is_scaled: bool,
}

impl Deref for Reading {
    type Target = ReadingRecord;

    fn deref(&self) -> &ReadingRecord {
        &self.record
    }
}

/// The facts about the file of a profile.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
pub struct ReadingRecord {
    /// Name of the file.
    pub name: String,
    /// Format of the file.
    pub format: Format,
    /// Character encoding; `None` for binary formats.
    pub encoding: Option<Encoding>,
    /// Dialect of the table; `None` for formats without a table.
    pub table: Option<TableLayout>,
    /// Unit of x; `None` if the spacing was stated.
    pub x_unit: Option<LengthUnit>,
    /// Unit of the heights in the file.
    pub z_unit: LengthUnit,
    /// Distance between points.
    pub spacing: Length,
    /// Origin of the spacing.
    pub spacing_source: SpacingSource,
    /// Length of the trace, (n − 1)·dx.
    pub length: Length,
    /// Filter state according to the file.
    pub filter_state: FilterState,
    /// Number of points n.
    pub points: usize,
    /// Points that were interpolated on request.
    pub gaps_filled: usize,
    /// Record of the cut, if only a part of the trace is used.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub cut: Option<TraceCut>,
    /// Metadata of the file.
    pub metadata: Metadata,
    /// Warnings.
    pub warnings: Vec<Warning>,
}

impl Reading {
    /// Returns an error for implausible heights: a root mean square slope above 2 or below 1e-6 (unless all heights are
    /// equal), or a single step steeper than 5. The reading has the corresponding warning.
    ///
    /// # Errors
    /// When the heights are too steep or too smooth. The error states the unit or the mark for missing points that
    /// explains it, if there is one.
    ///
    /// ```
    /// use asperity_profile_io::read::{ReadOptions, read_bytes};
    /// let rows = |scale: f64| {
    ///     let row = |i: u32| format!("{};{:.4}\n", 0.5 * f64::from(i), scale * (0.1 * f64::from(i)).sin());
    ///     format!("x [um];z [um]\n{}", (0..200).map(row).collect::<String>())
    /// };
    /// let options = ReadOptions::default();
    /// assert!(read_bytes("a.csv", rows(1.0).as_bytes(), &options)?.check_heights().is_ok());
    /// let steep = read_bytes("a.csv", rows(1000.0).as_bytes(), &options)?;
    /// let refused = steep.check_heights().unwrap_err();
    /// assert_eq!(refused.code(), "E131");
    /// assert!(refused.to_string().ends_with("would be plausible in nm"));
    /// # Ok::<(), Box<dyn std::error::Error>>(())
    /// ```
    pub fn check_heights(&self) -> Result<(), ReadError> {
        let steep = self.warnings.iter().find_map(|warning| match warning {
            Warning::ImplausibleHeights { steepness } => Some(*steepness),
            _ => None,
        });
        steep.map_or(Ok(()), |steepness| {
            Err(ReadFault::implausible_heights(steepness).in_file(&self.name))
        })
    }

    /// The reading with its profile replaced, for example after the replacement of spikes, and checked again.
    #[must_use]
    pub fn corrected(mut self, profile: Profile) -> Self {
        let is_of_heights = |w: &Warning| {
            matches!(
                w,
                Warning::ImplausibleHeights { .. } | Warning::EqualHeights
            )
        };
        self.record.warnings.retain(|w| !is_of_heights(w));
        Self { profile, ..self }.checked()
    }

    /// Adds a warning if the heights are implausible or all equal.
    pub(super) fn checked(mut self) -> Self {
        let heights = self.profile.heights();
        if heights.iter().all(|height| *height == heights[0]) {
            self.record.warnings.push(Warning::EqualHeights);
        }
        if let Some(mut steepness) = implausible(&self.profile, self.z_unit) {
            let start = self.cut.as_ref().map_or(Length::default(), |cut| cut.start);
            steepness.suspicion = steepness.suspicion.on_trace(start);
            if self.is_scaled {
                steepness.suspicion = steepness.suspicion.of_scaled();
            }
            self.record
                .warnings
                .push(Warning::ImplausibleHeights { steepness });
        }
        self
    }
}
