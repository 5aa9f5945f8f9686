//! Settings of the rough contact of a case.

use asperity_contact::SolverSettings;
use asperity_contact::plasticity::softer_flow_pressure;
use asperity_core::DomainError;
use asperity_core::quantity::Pressure;

use crate::case::Case;

/// Flow pressure of the softer flank.
pub(super) fn softer(case: &Case) -> Result<Pressure, DomainError> {
    let [pinion, wheel] = case.flow_pressure;
    softer_flow_pressure(pinion, wheel)
}

/// Settings of the contact solver.
pub(super) fn settings(case: &Case) -> SolverSettings {
    SolverSettings {
        tolerance: case.model.tolerance,
        ..SolverSettings::default()
    }
}
