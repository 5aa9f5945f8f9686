//! Cells of a window, along a line or over a patch.

use asperity_core::DomainError;
use asperity_core::quantity::Length;
use serde::{Deserialize, Serialize};

use crate::error::ContactError;

/// Rows of a patch: the window has an extent along the lead, over which it is periodic.
#[derive(Debug, Clone, Copy, PartialEq, Serialize, Deserialize)]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
#[serde(rename_all = "kebab-case", deny_unknown_fields)]
pub struct Lead {
    /// Number of rows.
    pub rows: usize,
    /// Distance of the rows.
    pub spacing: Length,
}

/// Cells of a grid.
#[derive(Debug, Clone, Copy, PartialEq, PartialOrd)]
pub(crate) struct Cells {
    /// Cells along rolling.
    pub(crate) columns: usize,
    /// Cells along the lead.
    pub(crate) rows: usize,
    /// Spacing along the lead over the one along rolling; zero for a line.
    pub(crate) aspect: f64,
}

impl Cells {
    /// Cells of a line or a patch with this number of points.
    pub(crate) fn new(
        points: usize,
        spacing: Length,
        lead: Option<Lead>,
    ) -> Result<Self, ContactError> {
        let dx = DomainError::positive("spacing", spacing)?;
        let (mut rows, mut aspect) = (1, 0.0);
        if let Some(lead) = lead {
            let dy = DomainError::positive("spacing along the lead", lead.spacing)?;
            let is_patch = lead.rows > 0 && points.is_multiple_of(lead.rows);
            let rule = "must divide the number of points";
            DomainError::require(is_patch, "rows", lead.rows as f64, "-", rule)?;
            rows = lead.rows;
            aspect = if rows == 1 { 0.0 } else { dy / dx };
        }
        Ok(Self {
            columns: points / rows,
            rows,
            aspect,
        })
    }

    pub(crate) fn points(self) -> usize {
        self.columns * self.rows
    }

    pub(crate) fn shape(self) -> [usize; 2] {
        [self.columns, self.rows]
    }

    /// Numbers that differ from grid to grid.
    pub(crate) fn key(self) -> (usize, usize, u64) {
        (self.columns, self.rows, self.aspect.to_bits())
    }
}
