//! Uncertain parameters with their ranges.
//!
//! | parameter | range | drawn |
//! |---|---|---|
//! | boundary friction μ_b | 0.065 to 0.12, gears and tribometers | evenly in the logarithm |
//! | boundary layer h_b | 5 to 20 nm | evenly in the logarithm |
//! | lay γ | 0, ridges across the whole face, to 1/6 | evenly |
//! | limiting shear stress over pressure Λ | ±15 % | evenly in the logarithm |
//! | Eyring stress τ₀ | the family's band; 3/4 to 11/8 of it where none is known | evenly in the logarithm |
//!
//! What the case calibrates ([`CalibrationInput`](crate::case::CalibrationInput)) is drawn from the bands of that
//! calibration instead: a normal distribution of the logarithms, 95 % of it in the band, with its correlations.
//!
//! The ranges are judgement of this project, that of τ₀ of polyalphaolefin is bracketed by measured losses. What the
//! case states is not drawn: whoever measured it knows better.

use asperity_core::quantity::{Length, Pressure};
use asperity_ehl_regime::inlet_flow::Lay;
use asperity_oil::{ShearLawName, TractionConstants};
use asperity_tribo_friction::boundary::{BOUNDARY_FRICTION_BAND, BOUNDARY_LAYER_BAND};

use crate::case::{CalibratedName, LoadedCase};
use crate::error::PositionError;
use asperity_mixed_film::InletSupply;

/// Parameters that can be drawn, each along its own axis of the hypercube whatever the others are.
pub(crate) const AXES: [UncertainParameter; 5] = [
    UncertainParameter::BoundaryFriction,
    UncertainParameter::BoundaryLayer,
    UncertainParameter::Lay,
    UncertainParameter::LimitingShear,
    UncertainParameter::EyringStress,
];

/// Upper end of the lay of ground and superfinished flanks, whose ridges run across the face.
const MOST_LAY: f64 = 1.0 / 6.0;
/// Limiting shear stress over pressure, down and up.
const LIMITING_SHEAR: [f64; 2] = [0.85, 1.15];
/// Eyring stress where the family has no band: that of polyalphaolefin, 3 to 5.5 MPa about 4 MPa.
const EYRING_STRESS: [f64; 2] = [0.75, 1.375];

/// An uncertain parameter.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
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
}

/// A parameter with its range in a case.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) struct Ranged {
    pub kind: UncertainParameter,
    pub value: f64,
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
            Self::Lay => None,
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
        }
    }

    /// Its unit; "-" for a number.
    #[must_use]
    pub const fn unit(self) -> &'static str {
        match self {
            Self::BoundaryLayer => "m",
            Self::EyringStress => "Pa",
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
        }
    }

    /// Whether the loss depends on it.
    fn acts(self, loaded: &LoadedCase) -> bool {
        let case = &loaded.case;
        let supply = case.load_share().supply();
        let supply = supply.filter(|_| loaded.surfaces.are_measured());
        let shear = case.rheology.as_ref().map(|rheology| rheology.laws().0);
        match self {
            Self::BoundaryFriction => true,
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
            (Self::Lay, _) => range(case.model.lay[0].gamma(), [0.0, MOST_LAY]),
            (Self::LimitingShear, Some(constants)) => {
                let value = constants.limiting_shear;
                range(value, LIMITING_SHEAR.map(|factor| factor * value))
            }
            (Self::EyringStress, Some(constants)) => {
                let value = constants.eyring_stress.si();
                range(value, eyring_range(loaded, value)?)
            }
            (Self::LimitingShear | Self::EyringStress, None) => None,
        })
    }
}

/// The family's band of the Eyring stress.
fn eyring_range(loaded: &LoadedCase, value: f64) -> Result<[f64; 2], PositionError> {
    let known = match loaded.case.lubricant.base_oil() {
        Some(base) => {
            let stress = &base.data()?.eyring_stress;
            stress.low.zip(stress.high)
        }
        None => None,
    };
    Ok(match known {
        Some((low, high)) => [low, high],
        None => EYRING_STRESS.map(|factor| factor * value),
    })
}

/// An uncertain parameter and its axis.
pub(crate) type OnAxis = (usize, Ranged);

/// The uncertain parameters of a case by the axis of each, and names of those that the case states.
pub(crate) fn parameters(loaded: &LoadedCase) -> Result<(Vec<OnAxis>, Vec<String>), PositionError> {
    let (mut drawn, mut held) = (Vec::new(), Vec::new());
    for (axis, kind) in AXES.into_iter().enumerate() {
        if !kind.acts(loaded) {
            continue;
        }
        match kind.ranged(loaded)? {
            _ if kind.is_stated(loaded) => held.push(kind.name().to_owned()),
            Some(ranged) => drawn.push((axis, ranged)),
            None => {}
        }
    }
    Ok((drawn, held))
}

impl Ranged {
    /// The value at the place `u` of the range, 0 at its lower end and 1 at its upper.
    pub(crate) fn at(&self, u: f64) -> f64 {
        match self.kind.is_logarithmic() {
            true => self.low * (self.high / self.low).powf(u),
            false => self.low + u * (self.high - self.low),
        }
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
    match &from.case.rheology {
        Some(rheology) => set_traction(to, |constants| {
            constants.limiting_shear = rheology.constants().limiting_shear;
            constants.eyring_stress = rheology.constants().eyring_stress;
        }),
        None => Ok(()),
    }
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
