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
use asperity_core::quantity::{Length, PerKelvin, Pressure, PressureViscosity, Temperature};
use asperity_oil::{
    LIMITING_SHEAR_BAND, PRESSURE_VISCOSITY_BAND, ShearLawName, TractionConstants,
    eyring_stress_band,
};
use asperity_tribo_friction::boundary::{BOUNDARY_FRICTION_BAND, BOUNDARY_LAYER_BAND};

use asperity_case::case::{CalibratedName, Case, FittedName, LoadedCase};
use asperity_case::error::{Error, PositionError};
use asperity_case::flanks::flank_lay::{FlankLay, mean_at, with_mean};
use asperity_mixed_film::InletSupply;
use serde::{Deserialize, Serialize};

/// Constants that can be drawn, each along its own axis of the hypercube whatever the others are. A further constant is
/// appended, so that the draws of the others remain.
pub const AXES: [UncertainParameter; 9] = [
    UncertainParameter::BoundaryFriction,
    UncertainParameter::BoundaryLayer,
    UncertainParameter::Lay,
    UncertainParameter::LimitingShear,
    UncertainParameter::EyringStress,
    UncertainParameter::PressureViscosity,
    UncertainParameter::LimitingShearTemperature,
    UncertainParameter::PressureViscosityFactor,
    UncertainParameter::TemperatureError,
];

// The number of a constant is its place among the axes.
const _: () = {
    let mut k = 0;
    while k < AXES.len() {
        assert!(AXES[k] as usize == k);
        k += 1;
    }
};

/// An uncertain constant.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Serialize, Deserialize)]
#[serde(rename_all = "kebab-case")]
pub enum UncertainParameter {
    /// Coefficient of boundary friction μ_b.
    BoundaryFriction,
    /// Thickness of the boundary layer h_b \[m\].
    BoundaryLayer,
    /// Lay γ, mean of both flanks.
    Lay,
    /// Limiting shear stress over pressure Λ.
    LimitingShear,
    /// Eyring stress τ₀ \[Pa\].
    EyringStress,
    /// Pressure-viscosity coefficient α at the bulk temperature \[1/Pa\].
    PressureViscosity,
    /// Fall of ln Λ with temperature b_L \[1/K\].
    LimitingShearTemperature,
    /// Ratio f of the pressure-viscosity coefficient of the friction to the coefficient of the film thickness.
    PressureViscosityFactor,
    /// Error of the stated temperature \[K\].
    TemperatureError,
}

/// Measurements that state the distribution of a constant.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Serialize, Deserialize)]
#[serde(rename_all = "kebab-case")]
pub enum Measured {
    /// Losses on a rig, in the table `calibration` of the case.
    Calibration,
    /// Traction curves, in an oil file.
    OilFile,
    /// The surfaces of both flanks.
    Surfaces,
}

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
            _ => None,
        }
    }

    /// Its name in an oil file.
    const fn fitted_name(self) -> Option<FittedName> {
        match self {
            Self::LimitingShear => Some(FittedName::LimitingShear),
            Self::EyringStress => Some(FittedName::EyringStress),
            Self::LimitingShearTemperature => Some(FittedName::LimitingShearTemperature),
            Self::PressureViscosityFactor => Some(FittedName::PressureViscosityFactor),
            _ => None,
        }
    }

    /// Value and 95 % band by measurements that the case names.
    fn measured(self, case: &Case) -> Option<(Estimate, Measured)> {
        let calibration = case.input.calibration.as_ref();
        let calibrated = calibration.and_then(|given| given.of(self.calibrated_name()?));
        let fitted = || {
            let (file, name) = (case.oil_file.as_ref()?, self.fitted_name()?);
            let is_own = name.replaced_by(&case.input).is_none();
            is_own.then(|| (file.film_friction.of(name), Measured::OilFile))
        };
        calibrated
            .map(|band| (band, Measured::Calibration))
            .or_else(fitted)
    }

    /// Correlation with `other`, which the same measurements state; 0 if they state none.
    pub fn correlation(self, other: Self, measured: Measured, case: &Case) -> f64 {
        let of_calibration = || {
            let names = (self.calibrated_name()?, other.calibrated_name()?);
            let given = case.input.calibration.as_ref()?;
            Some(given.correlation(names.0, names.1))
        };
        let of_file = || {
            let names = (self.fitted_name()?, other.fitted_name()?);
            let file = case.oil_file.as_ref()?;
            Some(file.film_friction.correlation(names.0, names.1))
        };
        let found = match measured {
            Measured::Calibration => of_calibration(),
            Measured::OilFile => of_file(),
            Measured::Surfaces => None,
        };
        found.unwrap_or(0.0)
    }

    /// The value in a case with its 5 % and 95 % quantile; `None` if the loss does not depend on it.
    ///
    /// # Errors
    /// When the family of the oil is not known.
    pub fn range(self, loaded: &LoadedCase) -> Result<Option<Estimate>, PositionError> {
        if !self.acts(loaded) {
            return Ok(None);
        }
        let ranged = self.ranged(loaded)?;
        Ok(ranged.map(|ranged| ranged.quantiles()))
    }

    /// Standard deviation of its logarithm by the traction curves of an oil file; `None` if they do not state it.
    ///
    /// # Errors
    /// As [`range`](Self::range).
    pub fn deviation_of_curves(self, loaded: &LoadedCase) -> Result<Option<f64>, PositionError> {
        let of_curves = |ranged: &Ranged| {
            ranged.measured == Some(Measured::OilFile) && ranged.estimate.low > 0.0
        };
        let ranged = self.ranged(loaded)?.filter(of_curves);
        Ok(ranged.map(|ranged| ranged.estimate.log_width() / (2.0 * Z_975)))
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
            Self::LimitingShearTemperature => "fall of the limiting shear",
            Self::PressureViscosityFactor => "pressure-viscosity factor of the friction",
            Self::TemperatureError => "error of the temperature",
        }
    }

    /// Its unit; "-" for a number.
    #[must_use]
    pub const fn unit(self) -> &'static str {
        match self {
            Self::BoundaryLayer => "m",
            Self::EyringStress => "Pa",
            Self::PressureViscosity => "1/Pa",
            Self::LimitingShearTemperature => "1/K",
            Self::TemperatureError => "K",
            _ => "-",
        }
    }

    /// Whether the film and the roughness in it depend on it, and not only their friction.
    #[must_use]
    pub const fn changes_film(self) -> bool {
        matches!(
            self,
            Self::Lay | Self::PressureViscosity | Self::TemperatureError
        )
    }

    /// Whether the case states it.
    fn is_stated(self, loaded: &LoadedCase) -> bool {
        let model = &loaded.case.input.model;
        match self {
            Self::BoundaryFriction => model.boundary_friction.is_some(),
            Self::BoundaryLayer => model.boundary_layer.is_some(),
            Self::Lay => model.lay.is_some(),
            Self::LimitingShear | Self::EyringStress | Self::TemperatureError => false,
            Self::LimitingShearTemperature | Self::PressureViscosityFactor => {
                let name = self.fitted_name();
                name.is_some_and(|name| name.replaced_by(&loaded.case.input).is_some())
            }
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
            Self::LimitingShear
            | Self::LimitingShearTemperature
            | Self::PressureViscosityFactor => shear.is_some(),
            Self::EyringStress => shear == Some(ShearLawName::Eyring),
            Self::TemperatureError => case.input.operation.temperature_deviation.is_some(),
        }
    }

    fn ranged(self, loaded: &LoadedCase) -> Result<Option<Ranged>, PositionError> {
        let case = &loaded.case;
        let constants = case.rheology.as_ref().map(|rheology| *rheology.constants());
        let ranged = |estimate, measured| Ranged {
            kind: self,
            estimate,
            measured,
            lays: None,
        };
        if let Some((estimate, measured)) = self.measured(case) {
            return Ok(Some(ranged(estimate, Some(measured))));
        }
        let range = |value: f64, ends: [f64; 2]| Some(ranged(Estimate::new(value, ends), None));
        Ok(match (self, constants) {
            (Self::BoundaryFriction, _) => {
                range(case.model.boundary_friction, BOUNDARY_FRICTION_BAND)
            }
            (Self::BoundaryLayer, _) => range(
                case.model.boundary_layer.si(),
                BOUNDARY_LAYER_BAND.map(Length::si),
            ),
            (Self::Lay, _) => {
                let lays = loaded.flank_lays();
                let [low, value, high] = [-Z_95, 0.0, Z_95].map(|z| mean_at(lays, z));
                let is_measured = lays.map(|lay| lay != FlankLay::ASSUMED);
                let measured = (is_measured == [true; 2]).then_some(Measured::Surfaces);
                Some(Ranged {
                    lays: is_measured.contains(&true).then_some(lays),
                    ..ranged(Estimate { value, low, high }, measured)
                })
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
            (Self::TemperatureError, _) => {
                let deviation = case.input.operation.temperature_deviation;
                deviation.and_then(|one| range(0.0, [-Z_95, Z_95].map(|z| z * one.si())))
            }
            (Self::LimitingShear | Self::EyringStress, None)
            | (Self::LimitingShearTemperature | Self::PressureViscosityFactor, _) => None,
        })
    }
}

/// The uncertain constants of a case, and names of those that the case states.
pub fn parameters(loaded: &LoadedCase) -> Result<(Vec<Ranged>, Vec<String>), PositionError> {
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

impl UncertainParameter {
    /// Sets it in a case, past its input: a change of the case by its keys undoes it. The error of the temperature is added to
    /// the temperature of the flanks.
    ///
    /// # Errors
    /// When the value is outside its domain.
    pub fn set(self, loaded: &mut LoadedCase, value: f64) -> Result<(), Error> {
        if self == Self::TemperatureError {
            let flanks = Temperature::from_si(loaded.case.temperature.si() + value);
            *loaded = at_temperature(loaded, flanks)?;
            return Ok(());
        }
        Ok(self.set_constant(loaded, value).map_err(Box::new)?)
    }

    fn set_constant(self, loaded: &mut LoadedCase, value: f64) -> Result<(), PositionError> {
        let case = &mut loaded.case;
        match self {
            Self::BoundaryFriction => case.model.boundary_friction = value,
            Self::BoundaryLayer => case.model.boundary_layer = Length::from_si(value),
            Self::Lay => loaded.case.model.lay = with_mean(loaded.flank_lays(), value)?,
            Self::LimitingShear => set_traction(loaded, |constants| {
                constants.limiting_shear = value;
            })?,
            Self::EyringStress => set_traction(loaded, |constants| {
                constants.eyring_stress = Pressure::from_si(value);
            })?,
            Self::PressureViscosity => {
                let factor = value / case.oil.pressure_viscosity.si();
                case.oil.pressure_viscosity = PressureViscosity::from_si(value);
                let is_of_film = Self::PressureViscosityFactor.measured(case).is_some();
                let rheology = case.rheology.take();
                case.rheology = rheology.map(|oil| match is_of_film {
                    // The curves state the friction with α as estimated.
                    true => oil.with_film_alpha_factor(factor),
                    // The same factor in film thickness and film friction.
                    false => oil.with_alpha_factor(factor),
                });
            }
            Self::LimitingShearTemperature => set_traction(loaded, |constants| {
                constants.limiting_shear_fall = PerKelvin::from_si(value);
            })?,
            Self::PressureViscosityFactor => set_traction(loaded, |constants| {
                constants.pressure_viscosity_factor = value;
            })?,
            Self::TemperatureError => {}
        }
        Ok(())
    }
}

/// The case with its flanks at a temperature, its uncertain parameters where they are.
pub fn at_temperature(loaded: &LoadedCase, bulk: Temperature) -> Result<LoadedCase, Error> {
    let mut warmed = loaded.with(|input| {
        input.operation.set_bulk_temperature(bulk);
    })?;
    keep_parameters(loaded, &mut warmed).map_err(Box::new)?;
    // Bearings and jet stay in the oil, whatever the flanks are at.
    let oil = loaded.case.temperature;
    if let Some(gearbox) = &mut warmed.case.gearbox {
        gearbox.temperature.get_or_insert(oil);
    }
    Ok(warmed)
}

/// Copies the parameters of `from` to `to`, whose oil is the same.
///
/// # Errors
/// When a constant is outside its domain at the temperature of `to`.
fn keep_parameters(from: &LoadedCase, to: &mut LoadedCase) -> Result<(), PositionError> {
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
        constants.limiting_shear_fall = rheology.constants().limiting_shear_fall;
        constants.pressure_viscosity_factor = rheology.constants().pressure_viscosity_factor;
    })?;
    if let Some(own) = to.case.rheology.take() {
        let factor = rheology.alpha_over(&own);
        let of_film = rheology.film_alpha_factor();
        to.case.oil.pressure_viscosity = to.case.oil.pressure_viscosity * factor * of_film;
        to.case.rheology = Some(
            own.with_alpha_factor(factor)
                .with_film_alpha_factor(of_film),
        );
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
