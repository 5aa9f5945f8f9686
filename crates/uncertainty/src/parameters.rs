//! Uncertain constants with their distributions.
//!
//! | constant | 5 % | median | 95 % | distribution |
//! |---|---|---|---|---|
//! | boundary friction μ_b | 0.066 | 0.09 | 0.123 | lognormal |
//! | boundary layer h_b | 5 nm | 10 nm | 20 nm | lognormal |
//! | lay γ, mean of both flanks | 0.008 | 1/12 | 0.158 | uniform, 0 to 1/6; lognormal where a surface shows it |
//! | limiting shear stress over pressure Λ | -13 % | of the family | +15 % | lognormal |
//! | Eyring stress τ₀ | low of the family | √(low high) | its high | lognormal |
//! | pressure-viscosity α, where it is estimated | -15 % | the estimate | +18 % | lognormal |
//! | fall of Λ with temperature b_L | of the oil file | | | normal |
//! | pressure-viscosity factor of the friction f | of the oil file | | | lognormal |
//! | error of the stated temperature, where the case states its deviation s | -1.645 s | 0 | 1.645 s | normal |
//!
//! The medians are the defaults of a run. Constants that the case calibrates
//! ([`CalibrationInput`](asperity_case::case::CalibrationInput)) have the bands of the calibration instead: 95 % of a normal
//! distribution of the logarithms, with its correlations. Constants of an [oil file](asperity_case::case::OilFile) likewise, except
//! those that the case states or calibrates; if f is drawn from it, α is drawn in the film thickness only, as the curves
//! state f times its estimate.
//!
//! The flanks are warmer or colder by the error of the stated temperature, of the oil or of the flanks: the change of the heating by
//! the loss is left out, as with the other constants.
//!
//! The distributions are estimates of this project; measured losses bracket τ₀ of polyalphaolefin. Constants that the
//! case states are not drawn: their user has measured them.

use asperity_core::Estimate;
use asperity_core::numerics::{Z_95, Z_975};
use asperity_core::quantity::Length;
use asperity_oil::{
    LIMITING_SHEAR_BAND, PRESSURE_VISCOSITY_BAND, ShearLawName, eyring_stress_band,
};
use asperity_tribo_friction::boundary::{BOUNDARY_FRICTION_BAND, BOUNDARY_LAYER_BAND};

use asperity_case::case::{LoadedCase, Measured, OperatingCase, UncertainParameter};
use asperity_case::error::PositionError;
use asperity_case::flanks::flank_lay::{FlankLay, mean_at};
use asperity_mixed_film::InletSupply;
use serde::{Deserialize, Serialize};

/// A constant with its distribution in a case.
#[derive(Debug, Clone, Copy, PartialEq, Serialize, Deserialize)]
pub struct Ranged {
    /// The constant.
    pub kind: UncertainParameter,
    /// Median with 5 % and 95 % quantiles; with 2.5 % and 97.5 % quantiles, as files state them, of a calibration or an oil file.
    #[serde(flatten)]
    pub estimate: Estimate,
    /// Measurements that state value and range.
    #[serde(rename = "calibrated")]
    pub measured: Option<Measured>,
    /// Lays of both flanks, whose mean is the value; `None` for another constant, and if both are assumed.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub lays: Option<[FlankLay; 2]>,
}

/// The value of a constant in a case with its 5 % and 95 % quantile; `None` if the loss does not depend on it.
///
/// # Errors
/// When the family of the oil is not known.
pub fn range(
    kind: UncertainParameter,
    case: &OperatingCase,
) -> Result<Option<Estimate>, PositionError> {
    if !acts(kind, case) {
        return Ok(None);
    }
    let ranged = ranged(kind, case)?;
    Ok(ranged.map(|ranged| ranged.quantiles()))
}

/// Standard deviation of the logarithm of a constant by the traction curves of an oil file; `None` if they do not state it.
///
/// # Errors
/// As [`range`].
pub fn deviation_of_curves(
    kind: UncertainParameter,
    case: &OperatingCase,
) -> Result<Option<f64>, PositionError> {
    let of_curves =
        |ranged: &Ranged| ranged.measured == Some(Measured::OilFile) && ranged.estimate.low > 0.0;
    let ranged = ranged(kind, case)?.filter(of_curves);
    Ok(ranged.map(|ranged| ranged.estimate.log_width() / (2.0 * Z_975)))
}

/// Whether the case states it.
#[must_use]
pub fn is_stated(kind: UncertainParameter, loaded: &LoadedCase) -> bool {
    let model = &loaded.case.input.model;
    match kind {
        UncertainParameter::BoundaryFriction => model.boundary_friction.is_some(),
        UncertainParameter::BoundaryLayer => model.boundary_layer.is_some(),
        UncertainParameter::Lay => model.lay.is_some(),
        UncertainParameter::LimitingShear
        | UncertainParameter::EyringStress
        | UncertainParameter::TemperatureError => false,
        UncertainParameter::LimitingShearTemperature
        | UncertainParameter::PressureViscosityFactor => {
            let name = kind.fitted_name();
            name.is_some_and(|name| name.replaced_by(&loaded.case.input).is_some())
        }
        UncertainParameter::PressureViscosity => {
            loaded.case.lubricant.given_pressure_viscosity().is_some()
        }
    }
}

/// Whether the loss depends on it.
fn acts(kind: UncertainParameter, loaded: &OperatingCase) -> bool {
    let case = &loaded.case;
    let law = case.share_law();
    let contact = law.contact().filter(|_| loaded.surfaces.are_measured());
    // Where no contact is solved, or its spots rub dry, there is no layer to look at.
    let has_layer = contact.is_some_and(|contact| contact.supply != InletSupply::Smooth);
    let shear = loaded.rheology().map(|rheology| rheology.laws().0);
    match kind {
        UncertainParameter::BoundaryFriction | UncertainParameter::PressureViscosity => true,
        UncertainParameter::BoundaryLayer | UncertainParameter::Lay => has_layer,
        UncertainParameter::LimitingShear
        | UncertainParameter::LimitingShearTemperature
        | UncertainParameter::PressureViscosityFactor => shear.is_some(),
        UncertainParameter::EyringStress => shear == Some(ShearLawName::Eyring),
        UncertainParameter::TemperatureError => {
            case.input.operation.temperature_deviation.is_some()
        }
    }
}

fn ranged(
    kind: UncertainParameter,
    loaded: &OperatingCase,
) -> Result<Option<Ranged>, PositionError> {
    let case = &loaded.case;
    let constants = loaded.rheology().map(|rheology| *rheology.constants());
    let ranged = |estimate, measured| Ranged {
        kind,
        estimate,
        measured,
        lays: None,
    };
    if let Some((estimate, measured)) = kind.measured(case) {
        return Ok(Some(ranged(estimate, Some(measured))));
    }
    let range = |value: f64, ends: [f64; 2]| Some(ranged(Estimate::new(value, ends), None));
    Ok(match (kind, constants) {
        (UncertainParameter::BoundaryFriction, _) => {
            range(case.model.boundary_friction, BOUNDARY_FRICTION_BAND)
        }
        (UncertainParameter::BoundaryLayer, _) => range(
            case.model.boundary_layer.si(),
            BOUNDARY_LAYER_BAND.map(Length::si),
        ),
        (UncertainParameter::Lay, _) => {
            let lays = loaded.flank_lays();
            let [low, value, high] = [-Z_95, 0.0, Z_95].map(|z| mean_at(lays, z));
            let is_measured = lays.map(|lay| lay != FlankLay::ASSUMED);
            let measured = (is_measured == [true; 2]).then_some(Measured::Surfaces);
            Some(Ranged {
                lays: is_measured.contains(&true).then_some(lays),
                ..ranged(Estimate { value, low, high }, measured)
            })
        }
        (UncertainParameter::PressureViscosity, _) => {
            let value = loaded.oil().pressure_viscosity.si();
            range(value, PRESSURE_VISCOSITY_BAND.map(|factor| factor * value))
        }
        (UncertainParameter::LimitingShear, Some(constants)) => {
            let value = constants.limiting_shear;
            range(value, LIMITING_SHEAR_BAND.map(|factor| factor * value))
        }
        (UncertainParameter::EyringStress, Some(constants)) => {
            let value = constants.eyring_stress.si();
            range(value, eyring_stress_band(case.lubricant.base_oil(), value)?)
        }
        (UncertainParameter::TemperatureError, _) => {
            let deviation = case.input.operation.temperature_deviation;
            deviation.and_then(|one| range(0.0, [-Z_95, Z_95].map(|z| z * one.si())))
        }
        (UncertainParameter::LimitingShear | UncertainParameter::EyringStress, None)
        | (
            UncertainParameter::LimitingShearTemperature
            | UncertainParameter::PressureViscosityFactor,
            _,
        ) => None,
    })
}

/// The uncertain constants of a case, and names of those that the case states.
pub fn parameters(loaded: &OperatingCase) -> Result<(Vec<Ranged>, Vec<String>), PositionError> {
    let (mut drawn, mut held) = (Vec::new(), Vec::new());
    for kind in UncertainParameter::ALL
        .into_iter()
        .filter(|kind| acts(*kind, loaded))
    {
        match ranged(kind, loaded)? {
            _ if is_stated(kind, loaded) => held.push(kind.name().to_owned()),
            Some(ranged) => drawn.push(ranged),
            None => {}
        }
    }
    Ok((drawn, held))
}

impl Ranged {
    /// The median with the 5 % and 95 % quantile.
    #[must_use]
    pub fn quantiles(&self) -> Estimate {
        match self.measured {
            None | Some(Measured::Surfaces) => self.estimate,
            Some(Measured::Calibration | Measured::OilFile) => {
                Estimate::new(self.estimate.value, [-Z_95, Z_95].map(|z| self.at(z)))
            }
        }
    }

    /// The value at `z` of the standard normal distribution of the constant.
    ///
    /// ```text
    /// v = v₀ exp(s± z),  s± = ln(v±/v₀)/z₉₅;  lay: v = Φ(z)/6;  b_L, ΔT: v = v₀ + |v± − v₀| z/z₉₅   [Constant-draw]
    /// ```
    ///
    /// The lay is the mean of both flanks; measured on a surface it is v₀ exp(s± z), at most 1, or uniform up to its bound.
    /// v± are the 5 % and 95 % quantiles, on either side of v₀ its own; z₉₅ = 1.645, and 1.960 of a measured constant.
    pub fn at(&self, z: f64) -> f64 {
        asperity_core::cite!("Constant-draw");
        let Estimate { value, low, high } = self.estimate;
        let end = if z < 0.0 { low } else { high };
        let z_end = match self.measured {
            Some(_) => Z_975,
            None => Z_95,
        };
        match self.kind {
            UncertainParameter::Lay => mean_at(self.lays.unwrap_or([FlankLay::ASSUMED; 2]), z),
            UncertainParameter::LimitingShearTemperature | UncertainParameter::TemperatureError => {
                value + (end - value).abs() * z / z_end
            }
            _ => value * ((end / value).ln().abs() * z / z_end).exp(),
        }
    }
}
