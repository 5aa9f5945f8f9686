//! The oil file: constants of the film friction of one oil, fitted to traction curves, with their 95 % intervals.

use std::path::Path;
use std::sync::Arc;

use asperity_core::numerics::range;
use asperity_core::quantity::{PerKelvin, Pressure, Temperature};
use asperity_core::{Code, Estimate};
use asperity_oil::{LubricantError, LubricantInput, PressureLaw, TractionConstants};
use serde::{Deserialize, Serialize};

use crate::input::calibration::{CalibratedName, CorrelationInput, correlation};
use crate::input::case_input::CaseInput;
use crate::input::model::ModelInput;
use crate::source::case_error::CaseError;
use crate::source::section::Section;
use crate::source::source_text::Source;
use asperity_core::message::Warning;

/// Squares of the residuals per point above which the law explains the curves poorly.
pub const POORLY_EXPLAINED: f64 = 1.5;
/// Steepest fall of ln Λ of a band \[1/K\]: a wider one has draws for which a film has several temperatures.
pub const STEEPEST_FALL: f64 = 0.016;
/// Difference of the sums of squares that decides the law of pressure: odds of 20 to 1.
pub const DECISIVE: f64 = 6.0;
/// Standard deviation of the error of a law that explains the curves, and of one that explains them poorly (assumed).
const LAW_ERROR: [f64; 2] = [0.02, 0.12];
/// Distance beyond the tested temperatures \[K\] from which the error of the law grows, and its standard deviation per
/// kelvin (assumed).
const FAR: f64 = 20.0;
const ERROR_PER_KELVIN: f64 = 0.10 / 40.0;
/// An oil file: `asperity oil fit` writes it, and a case names it by `lubricant.oil_file`.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
#[serde(deny_unknown_fields)]
pub struct OilFile {
    /// Name of the format.
    pub schema: OilSchema,
    /// The oil, as in a case.
    #[serde(default)]
    pub lubricant: LubricantInput,
    /// Constants of the film friction.
    pub film_friction: FittedFriction,
    /// The same by the other law of pressure, if the curves do not decide between the two.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub other_law: Option<FittedFriction>,
}

/// Name of the format.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Serialize, Deserialize)]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
pub enum OilSchema {
    /// Version 1.
    #[serde(rename = "asperity-oil-1")]
    Version1,
}

/// Constants of the film friction with the points that they were fitted to.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
#[serde(deny_unknown_fields)]
pub struct FittedFriction {
    /// Law of pressure of the fit, instead of the default of `model.film_pressure_law`.
    pub pressure_law: PressureLaw,
    /// Eyring stress.
    pub eyring_stress: OilConstant<Pressure>,
    /// Limiting shear stress over pressure at 90 °C.
    pub limiting_shear: OilConstant<f64>,
    /// Fall of the logarithm of the limiting shear stress with temperature \[1/K\]; its distribution is normal, the others are
    /// lognormal.
    pub limiting_shear_temperature: OilConstant<f64>,
    /// Pressure-viscosity coefficient of the friction over the one of the film thickness.
    pub pressure_viscosity_factor: OilConstant<f64>,
    /// Correlations of the logarithms (of `limiting_shear_temperature` itself); a pair that is left out has none.
    #[serde(default)]
    pub correlations: Vec<CorrelationInput<FittedName>>,
    /// Temperatures of the curves.
    pub temperatures: Vec<Temperature>,
    /// Largest Hertz pressure of the curves.
    pub pressure_max: Pressure,
    /// Quality of the fit.
    pub fit: FitQuality,
    /// Files of the curves with their SHA-256.
    pub source: String,
    /// Whether the curves were simulated.
    #[serde(default, skip_serializing_if = "std::ops::Not::not")]
    pub simulated: bool,
    /// What speaks against the constants, if anything does: what the fit had to assume of the machine or the oil.
    #[serde(default, skip_serializing_if = "Vec::is_empty")]
    pub doubts: Vec<String>,
}

/// A fitted constant with its 95 % interval.
#[derive(Debug, Clone, Copy, PartialEq, Serialize, Deserialize)]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
#[serde(deny_unknown_fields)]
pub struct OilConstant<T> {
    /// Value and 95 % interval.
    #[serde(flatten)]
    pub fitted: Estimate<T>,
    /// Whether the curves determine it; default true. If not, value and band are mostly those of the family.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub identified: Option<bool>,
}

/// Quality of a fit.
#[derive(Debug, Clone, Copy, PartialEq, Serialize, Deserialize)]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
#[serde(deny_unknown_fields)]
pub struct FitQuality {
    /// Points.
    pub points: usize,
    /// Squares of the residuals of the points over their number.
    pub chi2_per_point: f64,
    /// Sum of squares by the other law of pressure.
    pub other_law: f64,
    /// Sum of squares by `pressure_law`.
    pub this_law: f64,
}

/// A constant of an oil file.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Serialize, Deserialize)]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
#[serde(rename_all = "snake_case")]
pub enum FittedName {
    /// τ₀.
    EyringStress,
    /// Λ.
    LimitingShear,
    /// b_L.
    LimitingShearTemperature,
    /// f.
    PressureViscosityFactor,
}

impl FittedName {
    /// All, in the order of the file.
    pub const ALL: [Self; 4] = [
        Self::EyringStress,
        Self::LimitingShear,
        Self::LimitingShearTemperature,
        Self::PressureViscosityFactor,
    ];

    /// The key in the file.
    #[must_use]
    pub const fn key(self) -> &'static str {
        match self {
            Self::EyringStress => "eyring_stress",
            Self::LimitingShear => "limiting_shear",
            Self::LimitingShearTemperature => "limiting_shear_temperature",
            Self::PressureViscosityFactor => "pressure_viscosity_factor",
        }
    }

    /// The key of a case that replaces the constant, if `input` states it.
    #[must_use]
    pub fn replaced_by(self, input: &CaseInput) -> Option<&'static str> {
        let calibrated = |name| {
            let calibration = input.calibration.as_ref()?;
            calibration.of(name)
        };
        let lubricant = &input.lubricant;
        match self {
            Self::EyringStress => {
                calibrated(CalibratedName::EyringStress).map(|_| "calibration.eyring_stress")
            }
            Self::LimitingShear => {
                calibrated(CalibratedName::LimitingShear).map(|_| "calibration.limiting_shear")
            }
            Self::LimitingShearTemperature => lubricant
                .limiting_shear_temperature
                .map(|_| "lubricant.limiting_shear_temperature"),
            Self::PressureViscosityFactor => lubricant
                .pressure_viscosity_factor
                .map(|_| "lubricant.pressure_viscosity_factor"),
        }
    }
}

impl FittedFriction {
    /// Probability of the other law of pressure, by the odds of the two fits.
    ///
    /// ```text
    /// p = 1/(1 + exp(Δχ²/2))                                                      [Law-odds]
    /// ```
    ///
    /// Δχ²: sum of squares by the other law less the sum by this one.
    #[must_use]
    pub fn probability_of_other_law(&self) -> f64 {
        asperity_core::cite!("Law-odds");
        1.0 / (1.0 + (0.5 * (self.fit.other_law - self.fit.this_law)).exp())
    }

    /// Value and 95 % interval of a constant in SI units.
    #[must_use]
    pub fn of(&self, name: FittedName) -> Estimate {
        match name {
            FittedName::EyringStress => self.eyring_stress.fitted.map(Pressure::si),
            FittedName::LimitingShear => self.limiting_shear.fitted,
            FittedName::LimitingShearTemperature => self.limiting_shear_temperature.fitted,
            FittedName::PressureViscosityFactor => self.pressure_viscosity_factor.fitted,
        }
    }

    /// Sets a constant of an oil.
    pub fn put_into(&self, name: FittedName, constants: &mut TractionConstants) {
        let value = self.of(name).value;
        match name {
            FittedName::EyringStress => constants.eyring_stress = Pressure::from_si(value),
            FittedName::LimitingShear => constants.limiting_shear = value,
            FittedName::LimitingShearTemperature => {
                constants.limiting_shear_fall = PerKelvin::from_si(value);
            }
            FittedName::PressureViscosityFactor => constants.pressure_viscosity_factor = value,
        }
    }

    /// Correlation of two constants.
    #[must_use]
    pub fn correlation(&self, first: FittedName, other: FittedName) -> f64 {
        correlation(&self.correlations, first, other)
    }

    /// Distance of a temperature from the temperatures of the curves \[K\]; 0 within them.
    #[must_use]
    pub(crate) fn beyond_temperatures(&self, temperature: Temperature) -> f64 {
        let [low, high] = self.temperature_range().map(Temperature::si);
        let t = temperature.si();
        (low - t).max(t - high).max(0.0)
    }

    /// Lowest and highest temperature of the curves.
    #[must_use]
    pub fn temperature_range(&self) -> [Temperature; 2] {
        let kelvin = self.temperatures.iter().map(|one| one.si());
        range(kelvin).map(Temperature::from_si)
    }

    /// Whether a temperature is so far from the curves that the error of the law grows.
    #[must_use]
    pub fn is_far(&self, temperature: Temperature) -> bool {
        self.beyond_temperatures(temperature) > FAR
    }

    /// Standard deviation of the logarithm of the film friction by the law, at a temperature.
    ///
    /// ```text
    /// s² = s_law² + (0.1 ΔT/40 K)² for ΔT > 20 K                                [Film-law-error]
    /// ```
    ///
    /// s_law is 0.02, and 0.12 if the squares of the residuals exceed 1.5 per point; ΔT is the distance from the temperatures
    /// of the curves.
    #[must_use]
    pub fn law_error(&self, temperature: Temperature) -> f64 {
        asperity_core::cite!("Film-law-error");
        let own = law_error(self.fit.chi2_per_point);
        if self.is_far(temperature) {
            own.hypot(ERROR_PER_KELVIN * self.beyond_temperatures(temperature))
        } else {
            own
        }
    }
}

/// Standard deviation of the error of a law that leaves these squares of the residuals per point.
#[must_use]
pub fn law_error(chi2_per_point: f64) -> f64 {
    LAW_ERROR[usize::from(chi2_per_point > POORLY_EXPLAINED)]
}

impl OilFile {
    /// The file with the constants of the law of pressure that a case states; without one, of the law that explains the
    /// curves better.
    pub(crate) fn by_law(self: Arc<Self>, stated: Option<PressureLaw>) -> Arc<Self> {
        let Some(other) = &self.other_law else {
            return self;
        };
        let is_first = match stated {
            Some(law) => law != other.pressure_law,
            None => self.film_friction.fit.this_law <= other.fit.this_law,
        };
        if is_first {
            return self;
        }
        let swapped = Self {
            film_friction: other.clone(),
            other_law: Some(self.film_friction.clone()),
            ..Self::clone(&self)
        };
        swapped.into()
    }

    /// The oil of a case that names this file.
    ///
    /// # Errors
    /// When the oil is not in the library.
    pub(crate) fn completing(
        &self,
        own: &LubricantInput,
    ) -> Result<LubricantInput, LubricantError> {
        own.completed_by(&self.lubricant)
    }

    /// Refuses a case that does not use the constants, and returns the choices of the model with the law of pressure.
    pub(crate) fn put_into(
        &self,
        model: &ModelInput,
        source: &Source,
    ) -> Result<ModelInput, CaseError> {
        let law = self.film_friction.pressure_law;
        if model.film_pressure_law.is_some_and(|own| own != law) {
            let rule = "is not the law of pressure that the constants of lubricant.oil_file were fitted by; leave it out, or fit the curves again";
            return Err(Section::new(source, "model").conflict("film_pressure_law", rule));
        }
        Ok(ModelInput {
            film_pressure_law: Some(law),
            ..model.clone()
        })
    }

    /// Replaces the constants of the family in `constants`, except those that the case states.
    pub(crate) fn set_constants(&self, input: &CaseInput, constants: &mut TractionConstants) {
        for name in FittedName::ALL {
            if name.replaced_by(input).is_none() {
                self.film_friction.put_into(name, constants);
            }
        }
    }

    /// W442: what the case states as well; W443: limits of the fit.
    pub(crate) fn warnings(&self, input: &CaseInput, temperature: Temperature) -> Vec<Warning> {
        let file = input.lubricant.oil_file.as_deref().unwrap_or(Path::new(""));
        let file = file.display();
        let of_constants = FittedName::ALL
            .into_iter()
            .filter_map(|name| name.replaced_by(input));
        let mut replaced: Vec<String> = of_constants.map(str::to_owned).collect();
        replaced.extend(self.other_properties(&input.lubricant));
        let mut found = Vec::new();
        if !replaced.is_empty() {
            let text = format!(
                "{} of the case replaces the value of {file}",
                replaced.join(", ")
            );
            found.push(Warning::new(Code::W442, text));
        }
        let fitted = &self.film_friction;
        let doubts = fitted.doubts.iter();
        found.extend(
            doubts.map(|doubt| Warning::new(Code::W441, format!("fit of {file}: {doubt}"))),
        );
        let mut limit =
            |text: String| found.push(Warning::new(Code::W443, format!("{file}: {text}")));
        if fitted.is_far(temperature) {
            let [low, high] = fitted.temperature_range().map(Temperature::celsius);
            limit(format!(
                "the curves were measured at {low:.0} to {high:.0} °C, the flanks are at {:.0} °C: the film friction is sampled with an error of {:.0} %",
                temperature.celsius(),
                100.0 * fitted.law_error(temperature)
            ));
        }
        if fitted.fit.chi2_per_point > POORLY_EXPLAINED {
            limit(format!(
                "the law explains the curves poorly, the residuals are {:.1} times the stated errors: the film friction is sampled with an error of {:.0} %",
                fitted.fit.chi2_per_point.sqrt(),
                100.0 * fitted.law_error(temperature)
            ));
        }
        match (&self.other_law, input.model.film_pressure_law) {
            (Some(other), None) => limit(format!(
                "the curves do not decide the law of pressure: the run has {}, the interval has {} as well, with a probability of {:.0} %",
                fitted.pressure_law.name(),
                other.pressure_law.name(),
                100.0 * fitted.probability_of_other_law()
            )),
            _ if fitted.fit.other_law - fitted.fit.this_law < DECISIVE => {
                limit("the curves do not decide the law of pressure".to_owned());
            }
            _ => {}
        }
        found
    }

    /// Keys of the oil that the case states with another value.
    fn other_properties(&self, own: &LubricantInput) -> Vec<String> {
        let named = own.oil.as_ref().filter(|_| {
            self.lubricant.oil.is_none() && self.lubricant != LubricantInput::default()
        });
        let named = named.map(|_| "lubricant.oil".to_owned()).into_iter();
        let others = own.stated_otherwise(&self.lubricant);
        named
            .chain(others.map(|key| format!("lubricant.{key}")))
            .collect()
    }
}
