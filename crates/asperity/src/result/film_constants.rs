//! Constants of film and boundary layer that no data sheet states, for the result.

use asperity_core::Estimate;
use asperity_core::numerics::{Z_95, Z_975};
use asperity_core::quantity::Length;
use asperity_efficiency::swept::{HYSTERESIS, HYSTERESIS_BAND};
use asperity_oil::{FilmConstantName, LubricantError, Mark, MarkedValue, base_oil_source};
use asperity_tribo_friction::boundary::{
    BOUNDARY_FRICTION, BOUNDARY_FRICTION_BAND, BOUNDARY_LAYER, BOUNDARY_LAYER_BAND,
};
use serde::{Deserialize, Serialize};

use asperity_case::case::{CalibratedName, Case, FittedName, OperatingCase};

/// A constant of the oil's family, with what is known of it.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
#[non_exhaustive]
pub struct FilmConstant {
    /// Its name, with its unit.
    pub name: FilmConstantName,
    /// The value used with its band, its confidence and its source.
    #[serde(flatten)]
    pub constant: MarkedValue,
}

impl FilmConstant {
    fn new(name: FilmConstantName, of: Estimate, mark: Mark, source: impl Into<String>) -> Self {
        let constant = MarkedValue {
            value: of.value,
            low: Some(of.low),
            high: Some(of.high),
            mark,
            source: source.into(),
        };
        Self { name, constant }
    }
}

/// The constants of the oil's family in use; none if neither film friction nor load share depends on it.
pub(crate) fn film_constants(case: &OperatingCase) -> Result<Vec<FilmConstant>, LubricantError> {
    let (Some(_), Some(base)) = (case.rheology(), case.lubricant.base_oil()) else {
        return Ok(Vec::new());
    };
    let given_conductivity = case.lubricant.given_thermal_conductivity().is_some();
    let given_alpha = case.lubricant.given_pressure_viscosity().is_some();
    // What the case gives is among its inputs.
    let calibration = case.input.calibration.as_ref();
    let is_calibrated = |name| calibration.is_some_and(|found| found.of(name).is_some());
    let is_fitted = case.oil_file.is_some();
    let used = |name: FilmConstantName| match name {
        FilmConstantName::LimitingShear => {
            !is_fitted && !is_calibrated(CalibratedName::LimitingShear)
        }
        FilmConstantName::EyringStress => {
            !is_fitted && !is_calibrated(CalibratedName::EyringStress)
        }
        FilmConstantName::Conductivity => !given_conductivity,
        FilmConstantName::GoldFactor => !given_alpha,
        _ => true,
    };
    let constants = base.constants()?;
    let constants = constants.into_iter().filter(|(name, _)| used(*name));
    let of_oil = constants.map(|(name, constant)| FilmConstant {
        name,
        constant: MarkedValue {
            source: base_oil_source(&constant.source)
                .unwrap_or_default()
                .to_owned(),
            ..constant.clone()
        },
    });
    Ok(of_oil
        .chain(calibrated(case))
        .chain(fitted(case))
        .chain(of_boundary(case))
        .collect())
}

/// A constant calibrated on a rig, with its 5 % and 95 % quantiles.
fn calibrated(case: &Case) -> impl Iterator<Item = FilmConstant> + '_ {
    let calibration = case.input.calibration.iter();
    calibration.flat_map(|calibration| {
        CalibratedName::ALL.into_iter().filter_map(|name| {
            let found = calibration.of(name)?;
            let name = match name {
                CalibratedName::BoundaryFriction => FilmConstantName::BoundaryFriction,
                CalibratedName::BoundaryLayer => FilmConstantName::BoundaryLayer,
                CalibratedName::LimitingShear => FilmConstantName::LimitingShear,
                CalibratedName::EyringStress => FilmConstantName::EyringStress,
            };
            let source = calibration.source.as_deref();
            let source = source.unwrap_or("calibration of the case");
            let drawn = logarithmic(found);
            Some(FilmConstant::new(name, drawn, Mark::Calibrated, source))
        })
    })
}

/// 5 % and 95 % quantiles of a lognormal constant with these 2.5 % and 97.5 % quantiles.
fn logarithmic(found: Estimate) -> Estimate {
    found.map(|end| found.value * (end / found.value).powf(Z_95 / Z_975))
}

/// A constant of the oil file that the case does not replace, with its 5 % and 95 % quantiles.
fn fitted(case: &Case) -> impl Iterator<Item = FilmConstant> + '_ {
    let names = FittedName::ALL.into_iter();
    let own = names.filter(|name| name.replaced_by(&case.input).is_none());
    let files = case.oil_file.iter();
    files.zip(std::iter::repeat(own)).flat_map(|(file, names)| {
        names.map(|name| {
            let friction = &file.film_friction;
            let found = friction.of(name);
            let value = found.value;
            let drawn = match name {
                FittedName::LimitingShearTemperature => {
                    found.map(|end| value + (end - value) * Z_95 / Z_975)
                }
                _ => logarithmic(found),
            };
            let name = match name {
                FittedName::EyringStress => FilmConstantName::EyringStress,
                FittedName::LimitingShear => FilmConstantName::LimitingShear,
                FittedName::LimitingShearTemperature => FilmConstantName::LimitingShearTemperature,
                FittedName::PressureViscosityFactor => FilmConstantName::PressureViscosityFactor,
            };
            let source = format!("traction curves: {}", friction.source);
            FilmConstant::new(name, drawn, Mark::Calibrated, source)
        })
    })
}

/// Defaults of the boundary layer and of hysteresis, where the case gives no other.
fn of_boundary(case: &Case) -> impl Iterator<Item = FilmConstant> {
    let model = &case.model;
    let rows = [
        (
            FilmConstantName::BoundaryFriction,
            model.boundary_friction,
            BOUNDARY_FRICTION,
            BOUNDARY_FRICTION_BAND,
            Mark::Judged,
            "between 0.065 to 0.07 of ground FZG flanks (Arana 2019) and 0.12 of tribometers",
        ),
        (
            FilmConstantName::BoundaryLayer,
            model.boundary_layer.si(),
            BOUNDARY_LAYER.si(),
            BOUNDARY_LAYER_BAND.map(Length::si),
            Mark::Judged,
            "boundary layer with the roughness below a short-wave cut-off of 2.5 um",
        ),
        (
            FilmConstantName::Hysteresis,
            model.hysteresis,
            HYSTERESIS,
            HYSTERESIS_BAND,
            Mark::Seen,
            "share of cycled elastic energy that hardened bearing steel loses, Johnson 1985, as quoted by others",
        ),
    ];
    let calibration = case.input.calibration.clone().unwrap_or_default();
    let is_calibrated = [
        calibration.boundary_friction.is_some(),
        calibration.boundary_layer.is_some(),
        false,
    ];
    let rows = rows.into_iter().zip(is_calibrated);
    let defaults = rows.filter(|(row, is_calibrated)| row.1 == row.2 && !is_calibrated);
    let defaults = defaults.map(|(row, _)| row);
    defaults.map(|(name, value, _, ends, mark, source)| {
        FilmConstant::new(name, Estimate::new(value, ends), mark, source)
    })
}
