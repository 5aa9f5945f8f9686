//! Use of a calibration in its case: its checks, and the choices that it replaces.

use asperity_core::{DomainError, Estimate};

use crate::input::calibration::{CalibratedName, CalibrationInput, cholesky};
use crate::input::model::ModelInput;
use crate::source::case_error::CaseError;
use crate::source::section::Section;
use crate::source::source_text::Source;

/// The choices of the model with the calibrated parameters of the boundary layer.
pub(crate) fn put_into(calibration: &CalibrationInput, model: &ModelInput) -> ModelInput {
    let mut model = model.clone();
    if let Some(fitted) = calibration.boundary_friction {
        model.boundary_friction = Some(fitted.value);
    }
    if let Some(fitted) = calibration.boundary_layer {
        model.boundary_layer = Some(fitted.value);
    }
    model
}

/// Refuses bands that do not contain their value, correlations that contradict each other, and values stated twice.
pub(crate) fn check(
    calibration: &CalibrationInput,
    model: &ModelInput,
    source: &Source,
) -> Result<(), CaseError> {
    let section = Section::new(source, "calibration");
    // The other keys need no check.
    let CalibrationInput {
        source: _,
        simulated: _,
        boundary_friction,
        boundary_layer,
        limiting_shear,
        eyring_stress: _,
        correlations: _,
    } = calibration;
    let twice = [
        (
            boundary_friction.is_some() && model.boundary_friction.is_some(),
            CalibratedName::BoundaryFriction,
        ),
        (
            boundary_layer.is_some() && model.boundary_layer.is_some(),
            CalibratedName::BoundaryLayer,
        ),
    ];
    if let Some((_, name)) = twice.into_iter().find(|(is_twice, _)| *is_twice) {
        let rule = "is given in the table model as well; leave one of the two out";
        return Err(section.conflict(name.key(), rule));
    }
    for name in CalibratedName::ALL {
        let Some(found) = calibration.of(name) else {
            continue;
        };
        let Estimate { value, low, high } = found;
        let holds = low > 0.0 && low < high && found.contains(value) && high.is_finite();
        if !holds {
            let rule = "needs 0 < low < high with the value between them";
            return Err(section.conflict(name.key(), rule));
        }
    }
    let limiting = limiting_shear.map_or(0.0, |fitted| fitted.value);
    let rule = "must be below 1";
    DomainError::require(limiting < 1.0, "limiting shear", limiting, "-", rule)
        .map_err(section.domain("limiting_shear"))?;
    if cholesky(CalibratedName::ALL.len(), calibration.correlations_of_all()).is_none() {
        let rule = "contradict each other: no measurements have these correlations";
        return Err(section.conflict("correlations", rule));
    }
    Ok(())
}
