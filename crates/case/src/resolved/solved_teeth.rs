//! The load over the teeth as it is solved to check a case.

use asperity_core::derived::Derived;
use asperity_gear::GearError;

use super::assumed_relief::{AssumedRelief, ReliefInputs};
use super::gears::refused;
use super::load_inputs::LoadInputs;
use crate::source::case_error::CaseError;
use crate::source::source_text::Source;

/// Inputs of the load over the teeth, which is solved once so that a law or number that these gears do not admit is reported with its
/// place.
#[derive(Debug, Clone, PartialEq)]
pub(crate) struct LoadCheck {
    pub load: LoadInputs,
    /// Positions into which the path is divided; `None` if a single one represents it.
    pub positions: Option<usize>,
}

impl LoadCheck {
    /// Solves for the load.
    pub(crate) fn solve(&self, source: &Source) -> Result<(), CaseError> {
        let not_for = |key: &'static str| {
            move |error| match error {
                GearError::Domain(_)
                | GearError::UndercutContact { .. }
                | GearError::ReliefStart { .. } => refused(error, source),
                error => CaseError::not_for_these_gears(source.place_of(key), key, error),
            }
        };
        let map = self.load.by_its_law();
        let map = map.map_err(not_for("model.load_distribution"))?;
        if let Some(positions) = self.positions {
            map.cells(positions).map_err(not_for("model.positions"))?;
        }
        Ok(())
    }
}

/// Solutions of the load over the teeth of a case.
#[derive(Debug, Clone)]
pub(crate) struct SolvedTeeth {
    check: Derived<LoadCheck, ()>,
    /// The tip relief that the case does not state; a formulation without one has no inputs of it.
    relief: Derived<Option<ReliefInputs>, Option<AssumedRelief>>,
}

impl SolvedTeeth {
    /// Checks the load, and finds the relief of the gears that state none; `known` is not solved again.
    pub(crate) fn new(
        known: Option<&Self>,
        check: LoadCheck,
        relief: Option<ReliefInputs>,
        source: &Source,
    ) -> Result<Self, CaseError> {
        let check = Derived::renewed(known.map(|known| &known.check), check, |check| {
            check.solve(source)
        })?;
        let found = |inputs: &Option<ReliefInputs>| match inputs {
            None => Ok(None),
            Some(inputs) => {
                AssumedRelief::from_inputs(inputs).map_err(|error| refused(error, source))
            }
        };
        let relief = Derived::renewed(known.map(|known| &known.relief), relief, found)?;
        Ok(Self { check, relief })
    }

    /// The tip relief that the case does not state.
    pub(crate) fn relief(&self) -> Option<&AssumedRelief> {
        self.relief.value().as_ref()
    }
}
