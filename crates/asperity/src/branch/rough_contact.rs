//! Settings of the rough contact of a case.

use asperity_contact::SolverSettings;
use asperity_core::quantity::Pressure;

use crate::case::Case;

/// Flow pressure of the softer flank.
pub(super) fn softer(case: &Case) -> Pressure {
    let [pinion, wheel] = case.flow_pressure;
    Pressure::from_si(pinion.si().min(wheel.si()))
}

/// Settings of the contact solver.
pub(super) fn settings(case: &Case) -> SolverSettings {
    SolverSettings {
        tolerance: case.model.tolerance,
        ..SolverSettings::default()
    }
}
