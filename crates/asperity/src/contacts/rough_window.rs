//! The rough contact of one window, as a case states its steels and tolerance.

use asperity_contact::SolverSettings;
use asperity_core::line_contact::LineContact;
use asperity_core::quantity::{Length, Pressure};
use asperity_mixed_film::{RoughContact, RoughWindow};

use asperity_case::case::Case;
use asperity_case::error::PositionError;

/// Loosest tolerance of the contacts that decide the loss: at 1e-4 it would move by 3e-5.
const LOOSEST_TOLERANCE: f64 = 1e-8;

/// The rough contact of heights `composite`, points `spacing` apart, in the line contact `contact`.
pub(crate) fn rough_window(
    case: &Case,
    contact: &LineContact,
    composite: &[f64],
    spacing: Length,
) -> Result<RoughContact, PositionError> {
    let [pinion, wheel] = case.flow_pressure.map(Pressure::si);
    Ok(RoughContact::new(&RoughWindow {
        composite,
        spacing,
        load: contact.load,
        radius: contact.radius,
        modulus: contact.modulus,
        flow_pressure: Pressure::from_si(pinion.min(wheel)),
        settings: SolverSettings {
            tolerance: case.model.tolerance.min(LOOSEST_TOLERANCE),
            ..SolverSettings::default()
        },
    })?
    .exactly(case.laws.exact_contacts))
}
