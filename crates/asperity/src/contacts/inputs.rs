//! All that the rough contacts of a mesh follow from. Contacts are computed from these inputs and from nothing else, and are
//! stored under them.

use std::sync::Arc;

use asperity_contact::SolverSettings;
use asperity_core::quantity::{Length, LineLoad, Pressure};
use asperity_mixed_film::{PatchWindow, RoughContact};

use crate::mesh::MeshInputs;
use asperity_case::case::{Case, LEAST_OFFSETS, LoadedCase};
use asperity_case::error::PositionError;
use asperity_case::flanks::Surfaces;

/// Loosest tolerance of the contacts that decide the loss: at 1e-4 it would move by 3e-5.
const LOOSEST_TOLERANCE: f64 = 1e-8;
/// Ratio of the tolerances of a patch and a line: the loss of isotropic scans moves by 3e-8, as a patch is a mean over its rows.
const PATCH_TOLERANCE: f64 = 1e3;
/// Offsets of each pair of surrogates of a case that states none: the pairs are many, and each is a sample of its own.
const OFFSETS_OF_SURROGATES: usize = 4;
/// Offsets of two scans of a case that states none: each patch holds as many windows as it has rows that differ, and the scatter
/// between patches needs several.
const OFFSETS_OF_PATCHES: usize = 4;

/// Inputs of the contacts of a mesh; two equal ones have the same contacts. Neither oil nor speed nor temperature is among them.
#[derive(Debug, Clone, PartialEq)]
pub(crate) struct ContactInputs {
    pub mesh: MeshInputs,
    pub windows: Arc<WindowInputs>,
    pub offsets: Offsets,
}

/// Inputs of the contact of a window, except its place, load and radius.
#[derive(Debug, Clone, PartialEq)]
pub(crate) struct WindowInputs {
    /// Both flanks, prepared and placed.
    pub surfaces: Surfaces,
    /// Half-widths of the contact to each side of a window.
    pub reach: f64,
    pub modulus: Pressure,
    flow_pressure: [Pressure; 2],
    tolerance: f64,
    exact: bool,
}

/// Number of offsets of each pair of traces.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(crate) enum Offsets {
    /// Stated by the case, or the only choice.
    Fixed(usize),
    /// As many as the contacts need, at least [`LEAST_OFFSETS`].
    Needed,
}

impl Offsets {
    /// The offsets that a case states, or those that follow from its flanks.
    pub(crate) fn from_case(loaded: &LoadedCase) -> Self {
        let (case, surfaces) = (&loaded.case, &loaded.surfaces);
        let default = case.model.offsets;
        let is_stated = case.input.model.offsets.is_some() || case.overrides.offsets.is_some();
        if is_stated || case.formulation.pressures().is_some() {
            return Self::Fixed(default);
        }
        if surfaces.is_surrogate() {
            return Self::Fixed(default.min(OFFSETS_OF_SURROGATES));
        }
        if surfaces.sheets().is_some() {
            return Self::Fixed(default.min(OFFSETS_OF_PATCHES));
        }
        let follows_from_windows = case.share_law().contact().is_some()
            && surfaces.are_measured()
            && surfaces.placement().is_none();
        if follows_from_windows {
            Self::Needed
        } else {
            Self::Fixed(default)
        }
    }

    /// The number that is computed first.
    pub(crate) fn first(self) -> usize {
        match self {
            Self::Fixed(number) => number,
            Self::Needed => LEAST_OFFSETS,
        }
    }
}

impl ContactInputs {
    pub(crate) fn from_case(loaded: &LoadedCase) -> Self {
        Self {
            mesh: MeshInputs::from_case(&loaded.case),
            windows: Arc::new(WindowInputs::new(&loaded.case, &loaded.surfaces)),
            offsets: Offsets::from_case(loaded),
        }
    }
}

impl WindowInputs {
    pub(crate) fn new(case: &Case, surfaces: &Surfaces) -> Self {
        Self {
            surfaces: surfaces.clone(),
            reach: case.model.window,
            modulus: case.modulus,
            flow_pressure: case.flow_pressure,
            tolerance: case.model.tolerance,
            exact: case.overrides.exact_contacts,
        }
    }

    /// The rough contact of heights `composite` in rows, with the distances of points and rows, under a load with a radius; a line is
    /// one row.
    ///
    /// # Errors
    /// When the contact refuses the numbers.
    pub(crate) fn rough_contact(
        &self,
        load: LineLoad,
        radius: Length,
        composite: &[f64],
        rows: usize,
        spacings: [Length; 2],
    ) -> Result<RoughContact, PositionError> {
        let [pinion, wheel] = self.flow_pressure.map(Pressure::si);
        let of_line = self.tolerance.min(LOOSEST_TOLERANCE);
        Ok(RoughContact::of_patch(&PatchWindow {
            composite,
            columns: composite.len() / rows.max(1),
            rows,
            spacings,
            load,
            radius,
            modulus: self.modulus,
            flow_pressure: Pressure::from_si(pinion.min(wheel)),
            settings: SolverSettings {
                tolerance: of_line * if rows > 1 { PATCH_TOLERANCE } else { 1.0 },
                ..SolverSettings::default()
            },
        })?
        .exactly(self.exact))
    }
}
