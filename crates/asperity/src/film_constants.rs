//! Constants of film and boundary layer that no data sheet states, for the result.

use asperity_core::quantity::Length;
use asperity_efficiency::swept::{HYSTERESIS, HYSTERESIS_BAND};
use asperity_tribo_friction::boundary::{
    BOUNDARY_FRICTION, BOUNDARY_FRICTION_BAND, BOUNDARY_LAYER, BOUNDARY_LAYER_BAND,
};
use asperity_tribo_friction::film_friction::{Mark, family_source};
use asperity_tribo_friction::{FrictionError, OilFamily};
use serde::{Deserialize, Serialize};

use crate::case::Case;

/// A constant of the oil's family, with what is known of it.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
#[non_exhaustive]
pub struct FilmConstant {
    /// Its name, with its unit.
    pub name: String,
    /// The value used.
    pub value: f64,
    /// Lower end of its band, where one is known.
    pub low: Option<f64>,
    /// Upper end of its band, where one is known.
    pub high: Option<f64>,
    /// Confidence: seen in its source, calibrated here, from memory, or judged.
    pub mark: Mark,
    /// Its source.
    pub source: String,
}

/// The constants of the oil's family in use; none where neither film friction nor load share look at it.
pub(crate) fn film_constants(case: &Case) -> Result<Vec<FilmConstant>, FrictionError> {
    let (Some(_), Some(base)) = (&case.rheology, case.lubricant.base_oil()) else {
        return Ok(Vec::new());
    };
    let given_conductivity = case.lubricant.given_thermal_conductivity().is_some();
    let given_alpha = case.lubricant.given_pressure_viscosity().is_some();
    // What the case gives is among its inputs.
    let used = |name: &str| match name {
        "conductivity_w_per_m_k" => !given_conductivity,
        "gold_factor_per_gpa" => !given_alpha,
        _ => true,
    };
    let constants = OilFamily::from(base).constants()?;
    let constants = constants.into_iter().filter(|(name, _)| used(name));
    let of_oil = constants.map(|(name, constant)| FilmConstant {
        name: name.to_owned(),
        value: constant.value,
        low: constant.low,
        high: constant.high,
        mark: constant.mark,
        source: family_source(&constant.source)
            .unwrap_or_default()
            .to_owned(),
    });
    Ok(of_oil.chain(of_boundary(case)).collect())
}

/// Defaults of the boundary layer and of hysteresis, where the case gives no other.
fn of_boundary(case: &Case) -> impl Iterator<Item = FilmConstant> {
    let model = &case.model;
    let [least, most] = BOUNDARY_LAYER_BAND.map(Length::si);
    let rows = [
        (
            "boundary_friction",
            model.boundary_friction,
            BOUNDARY_FRICTION,
            BOUNDARY_FRICTION_BAND,
            Mark::Judged,
            "between 0.065 to 0.07 of ground FZG flanks (Arana 2019) and 0.12 of tribometers",
        ),
        (
            "boundary_layer_m",
            model.boundary_layer.si(),
            BOUNDARY_LAYER.si(),
            [least, most],
            Mark::Judged,
            "boundary layer with the roughness below a short-wave cut-off of 2.5 um; judgement",
        ),
        (
            "hysteresis",
            model.hysteresis,
            HYSTERESIS,
            HYSTERESIS_BAND,
            Mark::Memory,
            "share of cycled elastic energy that steel loses; from memory",
        ),
    ];
    let defaults = rows.into_iter().filter(|row| row.1 == row.2);
    defaults.map(|(name, value, _, [low, high], mark, source)| FilmConstant {
        name: name.to_owned(),
        value,
        low: Some(low),
        high: Some(high),
        mark,
        source: source.to_owned(),
    })
}
