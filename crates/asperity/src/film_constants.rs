//! Constants of film friction that no data sheet states, for the result.

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
    /// How sure it is: seen in its source, calibrated here, from memory, or judged.
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
    Ok(constants
        .map(|(name, constant)| FilmConstant {
            name: name.to_owned(),
            value: constant.value,
            low: constant.low,
            high: constant.high,
            mark: constant.mark,
            source: family_source(&constant.source)
                .unwrap_or_default()
                .to_owned(),
        })
        .collect())
}
