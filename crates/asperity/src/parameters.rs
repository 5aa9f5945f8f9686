//! Uncertain constants with their distributions.
//!
//! | constant | 5 % | median | 95 % | distribution |
//! |---|---|---|---|---|
//! | boundary friction μ_b | 0.066 | 0.09 | 0.123 | lognormal |
//! | boundary layer h_b | 5 nm | 10 nm | 20 nm | lognormal |
//! | lay γ | 0.008 | 1/12 | 0.158 | uniform, 0 to 1/6 |
//! | limiting shear stress over pressure Λ | -13 % | of the family | +15 % | lognormal |
//! | Eyring stress τ₀ | low of the family | √(low high) | its high | lognormal |
//! | pressure-viscosity α, where it is estimated | -15 % | the estimate | +18 % | lognormal |
//!
//! The medians are the defaults of a run. Constants that the case calibrates
//! ([`CalibrationInput`](crate::case::CalibrationInput)) have the bands of the calibration instead: 95 % of a normal
//! distribution of the logarithms, with its correlations.
//!
//! The distributions are estimates of this project; measured losses bracket τ₀ of polyalphaolefin. Constants that the
//! case states are not drawn: their user has measured them.

use asperity_core::numerics::{Z_95, Z_975, standard_normal_below};
use asperity_core::quantity::{Length, Pressure, PressureViscosity};
use asperity_ehl_regime::inlet_flow::Lay;
use asperity_oil::{
    LIMITING_SHEAR_BAND, PRESSURE_VISCOSITY_BAND, ShearLawName, TractionConstants,
    eyring_stress_band,
};
use asperity_tribo_friction::boundary::{BOUNDARY_FRICTION_BAND, BOUNDARY_LAYER_BAND};

use crate::case::{CalibratedName, LoadedCase};
use crate::error::PositionError;
use asperity_mixed_film::InletSupply;
use serde::{Deserialize, Serialize};

/// Constants that can be drawn, each along its own axis of the hypercube whatever the others are.
pub(crate) const AXES: [UncertainParameter; 6] = [
    UncertainParameter::BoundaryFriction,
    UncertainParameter::BoundaryLayer,
    UncertainParameter::Lay,
    UncertainParameter::LimitingShear,
    UncertainParameter::EyringStress,
    UncertainParameter::PressureViscosity,
];

/// Upper end of the lay of ground and superfinished flanks, whose ridges run nearly across the face.
const MOST_LAY: f64 = 1.0 / 6.0;
/// An uncertain constant.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Serialize, Deserialize)]
#[serde(rename_all = "kebab-case")]
pub enum UncertainParameter {
    /// Coefficient of boundary friction μ_b.
    BoundaryFriction,
    /// Thickness of the boundary layer h_b \[m\].
    BoundaryLayer,
    /// Lay γ of both flanks.
    Lay,
    /// Limiting shear stress over pressure Λ.
    LimitingShear,
    /// Eyring stress τ₀ \[Pa\].
    EyringStress,
    /// Pressure-viscosity coefficient α at the bulk temperature \[1/Pa\].
    PressureViscosity,
}

/// A constant with its distribution in a case.
#[derive(Debug, Clone, Copy, PartialEq, Serialize, Deserialize)]
pub(crate) struct Ranged {
    pub kind: UncertainParameter,
    /// The median.
    pub value: f64,
    /// 5 % and 95 % quantiles, 2.5 % and 97.5 % of a calibrated one.
    pub low: f64,
    pub high: f64,
    /// Its name in the table of the case, where that gives value and range.
    pub calibrated: Option<CalibratedName>,
}

impl From<CalibratedName> for UncertainParameter {
    fn from(name: CalibratedName) -> Self {
        match name {
            CalibratedName::BoundaryFriction => Self::BoundaryFriction,
            CalibratedName::BoundaryLayer => Self::BoundaryLayer,
            CalibratedName::LimitingShear => Self::LimitingShear,
            CalibratedName::EyringStress => Self::EyringStress,
        }
    }
}

impl UncertainParameter {
    /// Its name in the table `calibration` of a case.
    const fn calibrated_name(self) -> Option<CalibratedName> {
        match self {
            Self::BoundaryFriction => Some(CalibratedName::BoundaryFriction),
            Self::BoundaryLayer => Some(CalibratedName::BoundaryLayer),
            Self::LimitingShear => Some(CalibratedName::LimitingShear),
            Self::EyringStress => Some(CalibratedName::EyringStress),
            Self::Lay | Self::PressureViscosity => None,
        }
    }

    /// The value in a case, and the range that the band draws it from; `None` if the loss does not depend on it.
    ///
    /// # Errors
    /// When the family of the oil is not known.
    pub fn range(self, loaded: &LoadedCase) -> Result<Option<(f64, [f64; 2])>, PositionError> {
        if !self.acts(loaded) {
            return Ok(None);
        }
        let ranged = self.ranged(loaded)?;
        Ok(ranged.map(|ranged| (ranged.value, [ranged.low, ranged.high])))
    }

    /// Its name in words.
    #[must_use]
    pub const fn name(self) -> &'static str {
        match self {
            Self::BoundaryFriction => "boundary friction",
            Self::BoundaryLayer => "boundary layer",
            Self::Lay => "lay",
            Self::LimitingShear => "limiting shear",
            Self::EyringStress => "Eyring stress",
            Self::PressureViscosity => "pressure-viscosity",
        }
    }

    /// Its unit; "-" for a number.
    #[must_use]
    pub const fn unit(self) -> &'static str {
        match self {
            Self::BoundaryLayer => "m",
            Self::EyringStress => "Pa",
            Self::PressureViscosity => "1/Pa",
            _ => "-",
        }
    }

    pub(crate) const fn is_logarithmic(self) -> bool {
        !matches!(self, Self::Lay)
    }

    /// Whether the case states it.
    fn is_stated(self, loaded: &LoadedCase) -> bool {
        let model = &loaded.case.input.model;
        match self {
            Self::BoundaryFriction => model.boundary_friction.is_some(),
            Self::BoundaryLayer => model.boundary_layer.is_some(),
            Self::Lay => model.lay.is_some(),
            Self::LimitingShear | Self::EyringStress => false,
            Self::PressureViscosity => loaded.case.lubricant.given_pressure_viscosity().is_some(),
        }
    }

    /// Whether the loss depends on it.
    fn acts(self, loaded: &LoadedCase) -> bool {
        let case = &loaded.case;
        let supply = case.load_share().supply();
        let supply = supply.filter(|_| loaded.surfaces.are_measured());
        let shear = case.rheology.as_ref().map(|rheology| rheology.laws().0);
        match self {
            Self::BoundaryFriction | Self::PressureViscosity => true,
            // Where no contact is solved, or its spots rub dry, there is no layer to look at.
            Self::BoundaryLayer => supply == Some(InletSupply::Rough),
            Self::Lay => supply == Some(InletSupply::Rough),
            Self::LimitingShear => shear.is_some(),
            Self::EyringStress => shear == Some(ShearLawName::Eyring),
        }
    }

    fn ranged(self, loaded: &LoadedCase) -> Result<Option<Ranged>, PositionError> {
        let case = &loaded.case;
        let constants = case.rheology.as_ref().map(|rheology| *rheology.constants());
        let calibration = case.input.calibration.as_ref();
        if let (Some(given), Some(name)) = (calibration, self.calibrated_name())
            && let Some(found) = given.of(name)
        {
            return Ok(Some(Ranged {
                kind: self,
                value: found.value,
                low: found.low,
                high: found.high,
                calibrated: Some(name),
            }));
        }
        let range = |value: f64, [low, high]: [f64; 2]| {
            Some(Ranged {
                kind: self,
                value,
                low,
                high,
                calibrated: None,
            })
        };
        Ok(match (self, constants) {
            (Self::BoundaryFriction, _) => {
                range(case.model.boundary_friction, BOUNDARY_FRICTION_BAND)
            }
            (Self::BoundaryLayer, _) => range(
                case.model.boundary_layer.si(),
                BOUNDARY_LAYER_BAND.map(Length::si),
            ),
            (Self::Lay, _) => {
                let ends = [-Z_95, Z_95].map(|z| MOST_LAY * standard_normal_below(z));
                range(case.model.lay[0].gamma(), ends)
            }
            (Self::PressureViscosity, _) => {
                let value = case.oil.pressure_viscosity.si();
                range(value, PRESSURE_VISCOSITY_BAND.map(|factor| factor * value))
            }
            (Self::LimitingShear, Some(constants)) => {
                let value = constants.limiting_shear;
                range(value, LIMITING_SHEAR_BAND.map(|factor| factor * value))
            }
            (Self::EyringStress, Some(constants)) => {
                let value = constants.eyring_stress.si();
                range(value, eyring_stress_band(case.lubricant.base_oil(), value)?)
            }
            (Self::LimitingShear | Self::EyringStress, None) => None,
        })
    }
}

/// The uncertain constants of a case, and names of those that the case states.
pub(crate) fn parameters(loaded: &LoadedCase) -> Result<(Vec<Ranged>, Vec<String>), PositionError> {
    let (mut drawn, mut held) = (Vec::new(), Vec::new());
    for kind in AXES.into_iter().filter(|kind| kind.acts(loaded)) {
        match kind.ranged(loaded)? {
            _ if kind.is_stated(loaded) => held.push(kind.name().to_owned()),
            Some(ranged) => drawn.push(ranged),
            None => {}
        }
    }
    Ok((drawn, held))
}

impl Ranged {
    /// The value at `z` of the standard normal distribution of the constant.
    ///
    /// ```text
    /// v = v₀ exp(s± z),  s± = ln(v±/v₀)/z₉₅;  lay: v = Φ(z)/6                  [Constant-draw]
    /// ```
    ///
    /// v± are the 5 % and 95 % quantiles, on either side of v₀ its own; z₉₅ = 1.645, and 1.960 of a calibrated constant.
    pub(crate) fn at(&self, z: f64) -> f64 {
        asperity_core::cite!("Constant-draw");
        if !self.kind.is_logarithmic() {
            return MOST_LAY * standard_normal_below(z);
        }
        let end = if z < 0.0 { self.low } else { self.high };
        let z_end = match self.calibrated {
            Some(_) => Z_975,
            None => Z_95,
        };
        self.value * ((end / self.value).ln().abs() * z / z_end).exp()
    }
}

impl UncertainParameter {
    /// Sets it in a case, past its input: a change of the case by its keys undoes it.
    ///
    /// # Errors
    /// When the value is outside its domain.
    pub fn set(self, loaded: &mut LoadedCase, value: f64) -> Result<(), PositionError> {
        let case = &mut loaded.case;
        match self {
            Self::BoundaryFriction => case.model.boundary_friction = value,
            Self::BoundaryLayer => case.model.boundary_layer = Length::from_si(value),
            Self::Lay => case.model.lay = [Lay::new(value)?; 2],
            Self::LimitingShear => set_traction(loaded, |constants| {
                constants.limiting_shear = value;
            })?,
            Self::EyringStress => set_traction(loaded, |constants| {
                constants.eyring_stress = Pressure::from_si(value);
            })?,
            Self::PressureViscosity => {
                let factor = value / case.oil.pressure_viscosity.si();
                case.oil.pressure_viscosity = PressureViscosity::from_si(value);
                // The same factor in film thickness and film friction.
                let rheology = case.rheology.take();
                case.rheology = rheology.map(|oil| oil.with_alpha_factor(factor));
            }
        }
        Ok(())
    }
}

/// Copies the parameters of `from` to `to`, whose oil is the same.
///
/// # Errors
/// When a constant is outside its domain at the temperature of `to`.
pub(crate) fn keep_parameters(from: &LoadedCase, to: &mut LoadedCase) -> Result<(), PositionError> {
    let (kept, model) = (&from.case.model, &mut to.case.model);
    model.boundary_friction = kept.boundary_friction;
    model.boundary_layer = kept.boundary_layer;
    model.lay = kept.lay;
    model.offsets = kept.offsets;
    let Some(rheology) = &from.case.rheology else {
        return Ok(());
    };
    set_traction(to, |constants| {
        constants.limiting_shear = rheology.constants().limiting_shear;
        constants.eyring_stress = rheology.constants().eyring_stress;
    })?;
    if let Some(own) = to.case.rheology.take() {
        let factor = rheology.alpha_over(&own);
        to.case.oil.pressure_viscosity = to.case.oil.pressure_viscosity * factor;
        to.case.rheology = Some(own.with_alpha_factor(factor));
    }
    Ok(())
}

fn set_traction(
    loaded: &mut LoadedCase,
    change: impl FnOnce(&mut TractionConstants),
) -> Result<(), PositionError> {
    let rheology = loaded.case.rheology.take();
    loaded.case.rheology = match rheology {
        Some(rheology) => {
            let mut constants = *rheology.constants();
            change(&mut constants);
            Some(rheology.with_constants(constants)?)
        }
        None => None,
    };
    Ok(())
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn constants_have_the_quantiles_of_their_distributions() {
        let near = |a: f64, b: f64| (a / b - 1.0).abs() < 1e-12;
        let of = |kind, calibrated| Ranged {
            kind,
            value: 0.09,
            low: 0.066,
            high: 0.123,
            calibrated,
        };
        let prior = of(UncertainParameter::BoundaryFriction, None);
        assert!(
            near(prior.at(-Z_95), 0.066)
                && near(prior.at(0.0), 0.09)
                && near(prior.at(Z_95), 0.123)
        );
        let calibrated = of(
            UncertainParameter::BoundaryFriction,
            Some(CalibratedName::BoundaryFriction),
        );
        assert!(near(calibrated.at(Z_975), 0.123) && calibrated.at(Z_95) < 0.123);
        let lay = of(UncertainParameter::Lay, None);
        assert!(near(lay.at(0.0), 1.0 / 12.0) && near(lay.at(Z_95), 0.95 / 6.0));
    }
}
