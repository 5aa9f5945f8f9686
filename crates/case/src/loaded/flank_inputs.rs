//! All that the flanks of a case follow from, except the content of their files.

use asperity_core::quantity::Length;
use asperity_ehl_regime::Lay;
use asperity_flanks::flank_form::{FormError, shortest_form};
use asperity_flanks::meeting::{largest_spacing, needed_length};
use asperity_flanks::trace_filters::StatedFilters;
use asperity_gear::{Gear, GearPair};
use asperity_mixed_film::InletSupply;
use asperity_roughness::preparation::Preparation;

use crate::input::case_input::{Side, SurfaceInput};
use crate::input::gear_input::GearFlankInput;
use crate::input::one_or_two::OneOrTwo;
use crate::input::path_point::Positions;
use crate::resolved::resolve::Case;
use crate::resolved::share_law::ShareLaw;

/// Inputs of the flanks: two equal ones have the same flanks, as long as the files are the same.
#[derive(Debug, Clone, PartialEq)]
pub(crate) struct FlankInputs {
    pub surface: SurfaceInput,
    /// Side of the teeth that carries the load.
    pub side: Side,
    pub gears: GearPair,
    /// Whether the relief of pinion and wheel is taken from their traces.
    form_of_trace: [bool; 2],
    /// Shortest wave of such a form, if there is one.
    pub shortest_form: Result<Option<Length>, FormError>,
    /// Largest spacing of the traces that the contacts admit.
    pub largest_spacing: Length,
    /// Length of a scan that their windows need.
    pub needed_length: Length,
    pub preparation: Preparation,
    /// Lay of pinion and wheel, if the case states it.
    pub lay: Option<[Lay; 2]>,
    /// Whether the contact of the flanks is solved, so that flanks without a trace need surrogates.
    pub solves_contact: bool,
    /// Whether scans can be taken whole: patches have the solved contact with the gap law of the inlet, and no running-in.
    pub has_patches: bool,
    /// Whether a single position represents the mesh, which has no zones across the face.
    pub has_one_position: bool,
}

impl FlankInputs {
    pub(crate) fn from_case(case: &Case) -> Self {
        let stated = &case.input.gears;
        let form_of_trace = [&stated.pinion, &stated.wheel]
            .map(|flank| flank.as_ref().is_some_and(GearFlankInput::is_from_trace));
        let form = || shortest_form(&case.gears, case.torque, case.speed, case.modulus);
        let law = case.named_share();
        let solves = case.formulation.pressures().is_none();
        Self {
            surface: case.input.surface.clone(),
            side: case.input.surface.loaded_side(case.torque),
            gears: case.gears.clone(),
            form_of_trace,
            shortest_form: match form_of_trace {
                [false, false] => Ok(None),
                _ => form().map(Some),
            },
            largest_spacing: largest_spacing(&case.gears, case.torque, case.modulus),
            needed_length: needed_length(&case.gears, case.torque, case.modulus, case.model.window),
            preparation: case.preparation,
            lay: case.input.model.lay.map(OneOrTwo::both),
            solves_contact: solves
                && (law.contact().is_some() || matches!(law, ShareLaw::Reference)),
            has_patches: solves
                && (law.contact()).is_some_and(|contact| contact.supply != InletSupply::Starved)
                && case.running_in.is_none(),
            has_one_position: case.formulation.positions() == Positions::Single,
        }
    }

    /// Whether the relief of `gear` is taken from its trace.
    pub(crate) fn has_form_of_trace(&self, gear: Gear) -> bool {
        self.form_of_trace[gear as usize]
    }

    /// Filters of the traces.
    pub(crate) fn filters(&self) -> StatedFilters {
        let stated = &self.surface;
        StatedFilters {
            preparation: self.preparation,
            cutoffs: [stated.cutoff, stated.noise_cutoff],
            ends: stated.ends,
            form: stated.form,
        }
    }
}
