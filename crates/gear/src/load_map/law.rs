//! Laws of load distribution, and the settings of a load map.

use asperity_core::DomainError;
use serde::{Deserialize, Serialize};

use crate::error::GearError;
use crate::load_sharing::LoadSharing;
use crate::pair::GearPair;
use crate::tooth_outline::RootForm;

/// Factor of theory to measurement, C_M (ISO 6336-1:2019, method B).
const STIFFNESS_FACTOR: f64 = 0.8;

/// Coupling length of the deflection along the face, in normal modules: finite elements of racks and gears give 1.31 to
/// 1.9, and 1.55 for common gears.
const FACE_COUPLING: f64 = 1.55;

/// Minimum number of cells across the face of a pair whose load varies over it.
const MIN_CELLS: usize = 64;

/// Cells across the face for each unit of overlap ratio.
const CELLS_PER_OVERLAP: f64 = 16.0;

/// Maximum number of cells.
const MAX_CELLS: usize = 4096;

/// Law of the load distribution over the lines of contact.
#[derive(Debug, Clone, PartialEq, Default, Serialize, Deserialize)]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
#[serde(rename_all = "kebab-case", deny_unknown_fields)]
pub enum LoadLaw {
    /// Elastic teeth according to Weber and Banaschek, coupled along the face.
    #[default]
    Elastic,
    /// Elastic teeth with the stiffness of ISO 6336-1, coupled along the face.
    IsoStiffness,
    /// Rigid teeth: uniform line load at each instant.
    Uniform,
    /// Equal shares at the mean length of the contact lines, as in the 2022 paper.
    MeanLength,
    /// Minimum elastic potential energy (Pedrero and Pleguezuelos). 1 < ε_α ≤ 2.
    MinPotential,
    /// 1/3 rising to 2/3, 1, 2/3 falling to 1/3. Spur pairs with 1 < ε_α ≤ 2.
    Trapezoid,
    /// Rows (position from 0 at A to 1 at E, weight), as [`LoadSharing::Table`].
    Table(Vec<(f64, f64)>),
}

impl LoadLaw {
    /// Name in a case file.
    pub fn name(&self) -> &'static str {
        match self {
            Self::Elastic => "elastic",
            Self::IsoStiffness => "iso-stiffness",
            Self::Uniform => "uniform",
            Self::MeanLength => "mean-length",
            Self::MinPotential => "min-potential",
            Self::Trapezoid => "trapezoid",
            Self::Table(_) => "table",
        }
    }

    /// Whether the law includes deflections, and therefore supports modified flanks and transmission error.
    pub fn is_elastic(&self) -> bool {
        matches!(self, Self::Elastic | Self::IsoStiffness)
    }

    /// Every law except `Table`, in the order of a report.
    pub fn all() -> [Self; 6] {
        [
            Self::Elastic,
            Self::IsoStiffness,
            Self::Uniform,
            Self::MeanLength,
            Self::MinPotential,
            Self::Trapezoid,
        ]
    }

    /// The weights of a law without deflections.
    pub(crate) fn sharing(&self) -> LoadSharing {
        match self {
            Self::MinPotential => LoadSharing::MinPotential,
            Self::Trapezoid => LoadSharing::Trapezoid,
            Self::Table(rows) => LoadSharing::Table(rows.clone()),
            _ => LoadSharing::Uniform,
        }
    }
}

/// Settings of a load map.
#[derive(Debug, Clone, Copy, PartialEq, Serialize, Deserialize)]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
#[serde(default, deny_unknown_fields)]
pub struct LoadMapSettings {
    /// Factor C_M of theory to measurement.
    pub stiffness_factor: f64,
    /// Coupling length of the deflection along the face, in normal modules; 0 for independent slices.
    pub face_coupling: f64,
    /// Root of the basic rack of each gear.
    pub root: [RootForm; 2],
    /// Whether tip edges may be in contact outside the path of contact.
    pub edge_contact: bool,
    /// Cells across the face; default: 16 per unit of overlap ratio, at least 64.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub cells: Option<usize>,
}

impl Default for LoadMapSettings {
    fn default() -> Self {
        Self {
            stiffness_factor: STIFFNESS_FACTOR,
            face_coupling: FACE_COUPLING,
            root: [RootForm::default(); 2],
            edge_contact: false,
            cells: None,
        }
    }
}

impl LoadMapSettings {
    pub(crate) fn check(&self) -> Result<(), GearError> {
        let positive = |name, value: f64, rule| {
            DomainError::require(value.is_finite() && value > 0.0, name, value, "-", rule)
        };
        let above = "must be finite and greater than zero";
        positive("stiffness factor", self.stiffness_factor, above)?;
        let coupling = self.face_coupling;
        DomainError::require(
            coupling.is_finite() && coupling >= 0.0,
            "face coupling",
            coupling,
            "-",
            "must be finite and not negative",
        )?;
        for root in self.root {
            positive("dedendum", root.dedendum, above)?;
            let fillet = root.fillet_radius;
            DomainError::require(
                fillet.is_finite() && fillet >= 0.0,
                "fillet radius",
                fillet,
                "-",
                "must be finite and not negative",
            )?;
        }
        let cells = self.cells.unwrap_or(MIN_CELLS);
        DomainError::require(
            (1..=MAX_CELLS).contains(&cells),
            "cells across the face",
            cells as f64,
            "-",
            "must be from 1 to 4096",
        )?;
        Ok(())
    }

    /// Cells across the face of this pair; one if the load is constant over it.
    pub(crate) fn cell_count(&self, pair: &GearPair, varies_across_the_face: bool) -> usize {
        if pair.is_spur() && !varies_across_the_face {
            return 1;
        }
        let by_overlap = (CELLS_PER_OVERLAP * pair.path.eps_beta).ceil() as usize;
        self.cells
            .unwrap_or_else(|| by_overlap.clamp(MIN_CELLS, MAX_CELLS))
    }
}
