//! A calibration in its case: what it may hold beside the other keys, and where its values go.

use asperity_core::DomainError;

use super::calibration::{Calibrated, CalibratedName, CalibrationInput, cholesky};
use super::domain::domain;
use super::error::CaseError;
use super::input::{Formulation, ModelInput};
use super::source::Source;

/// Puts the parameters of the boundary layer in place of their defaults.
pub(super) fn put_into(given: &CalibrationInput, model: &ModelInput) -> ModelInput {
    let mut model = model.clone();
    if let Some(found) = given.boundary_friction {
        model.boundary_friction = Some(found.value);
    }
    if let Some(found) = given.boundary_layer {
        model.boundary_layer = Some(found.value);
    }
    model
}

/// Refuses bands that hold no value, correlations that contradict each other, and values given twice.
pub(super) fn check(
    given: &CalibrationInput,
    model: &ModelInput,
    formulation: Formulation,
    source: &Source,
) -> Result<(), CaseError> {
    let conflict = |key: &'static str, rule: &'static str| CaseError::Conflict {
        place: source.place_of(key),
        key,
        rule,
    };
    if formulation == Formulation::Paper {
        let rule = "belongs to the corrected formulation; leave one of the two out";
        return Err(conflict("calibration", rule));
    }
    let twice = [
        (
            given.boundary_friction.is_some() && model.boundary_friction.is_some(),
            CalibratedName::BoundaryFriction,
        ),
        (
            given.boundary_layer.is_some() && model.boundary_layer.is_some(),
            CalibratedName::BoundaryLayer,
        ),
    ];
    for (is_twice, name) in twice {
        if is_twice {
            let rule = "is given in the table model as well; leave one of the two out";
            return Err(conflict(name.path(), rule));
        }
    }
    for name in CalibratedName::ALL {
        let Some(Calibrated { value, low, high }) = given.of(name) else {
            continue;
        };
        let holds = low > 0.0 && low < high && (low..=high).contains(&value) && high.is_finite();
        if !holds {
            let rule = "needs 0 < low < high with the value between them";
            return Err(conflict(name.path(), rule));
        }
    }
    let limiting = given.limiting_shear.map_or(0.0, |found| found.value);
    DomainError::require(
        limiting < 1.0,
        "limiting shear",
        limiting,
        "-",
        "must be below 1",
    )
    .map_err(domain(source, "calibration.limiting_shear"))?;
    if cholesky(given, &CalibratedName::ALL).is_none() {
        let rule = "contradict each other: no measurements have these correlations";
        return Err(conflict("calibration.correlations", rule));
    }
    Ok(())
}
