//! Xu's regression of thermal mixed EHL solutions.
//!
//! | symbol | meaning | unit in the formula |
//! |---|---|---|
//! | SR | slide-to-roll ratio V_s/V_e | - |
//! | P_h | **maximum** Hertz pressure | GPa |
//! | ν₀ | dynamic viscosity at the inlet temperature and ambient pressure | cP = mPa s |
//! | V_e | mean surface speed | m/s |
//! | R | relative radius of curvature | m |
//! | S | combined root-mean-square roughness | um |
//! | q | \|SR\| P_h log₁₀ ν₀ | - |
//!
//! Source: H. Xu, dissertation, The Ohio State University, 2005, as used in H. Xu, A. Kahraman,
//! N. E. Anderson and D. G. Maddock (2007). The nine coefficients agree in two independent public
//! copies; one of them computes with P_h in GPa, the other labels it MPa, with which q would be in
//! the hundreds and the friction vanish. Fitted to a 75W90 gear oil. Ranges: those over which
//! the regression is usually applied; the table of its own cases was not available, so a note says
//! only that a value should be checked.
//!
//! The roughness enters as e^(b₉ e^S), a double exponential: relative to S = 0.42 um it is ×0.72
//! at 0, ×2.1 at 1 um and ×38 at 2 um. [`RoughnessReading::Clamped`] therefore holds S at 0.6 um
//! and says so. ν₀ ≤ 1 cP is refused: log₁₀ ν₀ would turn the sign of q.

use asperity_core::quantity::{DynamicViscosity, Length, Pressure, Speed};
use asperity_core::{Checked, DomainError, FittedRange, OutOfRange, Treatment, cite};
use serde::{Deserialize, Serialize};

use crate::error::FrictionError;

/// Largest S [um] that the clamped reading lets into the double exponential: the upper end of
/// the usual range of S.
const LARGEST_ROUGHNESS: f64 = 0.6;

/// The coefficients b₁ … b₉.
#[derive(Debug, Clone, Copy, PartialEq, Serialize, Deserialize)]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
#[serde(deny_unknown_fields)]
pub struct XuCoefficients {
    /// Constant in the exponent.
    pub b1: f64,
    /// Power of P_h.
    pub b2: f64,
    /// Power of |SR|.
    pub b3: f64,
    /// Factor of q in the exponent.
    pub b4: f64,
    /// Factor of e^(−q) in the exponent.
    pub b5: f64,
    /// Power of V_e.
    pub b6: f64,
    /// Power of ν₀.
    pub b7: f64,
    /// Power of R.
    pub b8: f64,
    /// Factor of e^S in the exponent.
    pub b9: f64,
}

impl XuCoefficients {
    /// Xu 2005, table of the coefficients of the EHL-based formula, 75W90.
    pub const XU_2005: Self = Self {
        b1: -8.916465,
        b2: 1.03303,
        b3: 1.036077,
        b4: -0.354068,
        b5: 2.812084,
        b6: -0.100601,
        b7: 0.752755,
        b8: -0.390958,
        b9: 0.620305,
    };

    fn all(&self) -> [f64; 9] {
        let Self {
            b1,
            b2,
            b3,
            b4,
            b5,
            b6,
            b7,
            b8,
            b9,
        } = *self;
        [b1, b2, b3, b4, b5, b6, b7, b8, b9]
    }
}

impl Default for XuCoefficients {
    fn default() -> Self {
        Self::XU_2005
    }
}

/// A coefficient file: a user's own calibration of the same form.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
#[serde(deny_unknown_fields)]
pub struct XuCalibration {
    /// Source of the numbers.
    pub source: String,
    /// The oil they were fitted to.
    pub oil: String,
    /// The coefficients.
    pub coefficients: XuCoefficients,
}

impl XuCalibration {
    /// Reads the text of a coefficient file (JSON).
    ///
    /// # Errors
    /// When the text is not JSON, a key is missing, unknown or not a number.
    ///
    /// ```
    /// use asperity_tribo_friction::XuCalibration;
    /// let text = r#"{
    ///     "source": "own twin-disc tests, 2024", "oil": "0W-20 transmission fluid",
    ///     "coefficients": { "b1": -8.9, "b2": 1.0, "b3": 1.0, "b4": -0.35, "b5": 2.8,
    ///                       "b6": -0.1, "b7": 0.75, "b8": -0.39, "b9": 0.62 }
    /// }"#;
    /// assert_eq!(XuCalibration::from_json(text)?.coefficients.b7, 0.75);
    /// # Ok::<(), asperity_tribo_friction::FrictionError>(())
    /// ```
    pub fn from_json(text: &str) -> Result<Self, FrictionError> {
        serde_json::from_str(text).map_err(FrictionError::coefficient_file)
    }
}

/// Treatment of a roughness beyond the usual range.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash, Default, Serialize, Deserialize)]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
#[serde(rename_all = "kebab-case", deny_unknown_fields)]
pub enum RoughnessReading {
    /// S is held at 0.6 um, with a note.
    #[default]
    Clamped,
    /// S enters as it is, with a note, as in the 2022 paper.
    AsIs,
}

/// Xu's law with its choices.
#[derive(Debug, Clone, Copy, PartialEq, Serialize, Deserialize)]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
#[serde(default, deny_unknown_fields)]
pub struct XuLaw {
    /// Coefficients; those of a file by [`XuCalibration`].
    pub coefficients: XuCoefficients,
    /// Treatment of a roughness above 0.6 um.
    pub roughness: RoughnessReading,
    /// Factor on the coefficient for another oil than the fitted one.
    pub friction_scale: f64,
}

impl Default for XuLaw {
    fn default() -> Self {
        Self {
            coefficients: XuCoefficients::XU_2005,
            roughness: RoughnessReading::Clamped,
            friction_scale: 1.0,
        }
    }
}

/// Inputs of Xu's law at a mesh position.
#[derive(Debug, Clone, Copy, PartialEq, Serialize)]
pub struct XuConditions {
    /// Slide-to-roll ratio V_s/V_e, of either sign.
    pub slide_to_roll: f64,
    /// Maximum Hertz pressure.
    pub max_pressure: Pressure,
    /// Viscosity at the inlet temperature and ambient pressure.
    pub viscosity: DynamicViscosity,
    /// Mean surface speed.
    pub entrainment: Speed,
    /// Relative radius of curvature.
    pub radius: Length,
    /// Combined root-mean-square roughness S.
    pub combined_roughness: Length,
}

const NAME: &str = "Xu";

/// Usual ranges of |SR|, P_h, V_e, R and ν₀ (see the header).
const RANGES: [FittedRange; 5] = [
    FittedRange::new("slide-to-roll ratio", 0.0, 1.0, "-", NAME),
    FittedRange::new("maximum pressure", 0.5, 2.5, "GPa", NAME),
    FittedRange::new("entrainment speed", 1.0, 20.0, "m/s", NAME),
    FittedRange::new("radius", 5.0, 80.0, "mm", NAME),
    // A 75W90 from about 120 °C down to 40 °C (assumed).
    FittedRange::new("viscosity", 5.0, 50.0, "mPa s", NAME),
];

impl RoughnessReading {
    /// S [um] as it enters the formula; notes one that is too large.
    fn read(self, roughness: f64, outside: &mut Vec<OutOfRange>) -> f64 {
        let mut range =
            FittedRange::new("combined roughness S", 0.0, LARGEST_ROUGHNESS, "um", NAME);
        match self {
            Self::Clamped => {
                range.correlation = "Xu (S is held at 0.6 um)";
                range.check_as(Treatment::Held, roughness, outside);
                roughness.min(LARGEST_ROUGHNESS)
            }
            Self::AsIs => {
                range.check(roughness, outside);
                roughness
            }
        }
    }
}

impl XuLaw {
    /// Xu's friction coefficient.
    ///
    /// ```text
    /// μ = e^f P_h^b₂ |SR|^b₃ V_e^b₆ ν₀^b₇ R^b₈,
    /// f = b₁ + b₄ q + b₅ e^(−q) + b₉ e^S,  q = |SR| P_h log₁₀ ν₀                     [P7]
    /// ```
    ///
    /// Without sliding the coefficient is 0. For given conditions μ(SR) is largest at
    /// q = 0.505195, whatever the other inputs.
    ///
    /// # Errors
    /// When pressure, speed or radius is not positive, ν₀ ≤ 1 cP, the roughness is negative, or
    /// an input, coefficient or the result is not finite.
    ///
    /// ```
    /// use asperity_tribo_friction::xu::{XuConditions, XuLaw};
    /// let position = XuConditions {
    ///     slide_to_roll: 0.5, max_pressure: "1.5 GPa".parse()?, viscosity: "10 cP".parse()?,
    ///     entrainment: "10 m/s".parse()?, radius: "10 mm".parse()?,
    ///     combined_roughness: "0.1 um".parse()?,
    /// };
    /// assert!((XuLaw::default().coefficient(&position)?.value - 0.0155240).abs() < 1e-7);
    /// # Ok::<(), Box<dyn std::error::Error>>(())
    /// ```
    pub fn coefficient(&self, position: &XuConditions) -> Result<Checked<f64>, FrictionError> {
        cite!("P7");
        let sr = finite("slide-to-roll ratio", position.slide_to_roll)?.abs();
        let p_h = DomainError::positive("maximum pressure", position.max_pressure)? * 1e-9;
        let nu_0 = viscosity_in_centipoise(position.viscosity)?;
        let v_e = DomainError::positive("entrainment speed", position.entrainment)?;
        let r = DomainError::positive("radius", position.radius)?;
        let s = DomainError::non_negative("combined roughness", position.combined_roughness)?;
        let scale = positive("friction scale", self.friction_scale)?;

        let mut outside = Vec::new();
        for (range, value) in RANGES.iter().zip([sr, p_h, v_e, r * 1e3, nu_0]) {
            range.check(value, &mut outside);
        }
        let s = self.roughness.read(s * 1e6, &mut outside);

        let [b1, b2, b3, b4, b5, b6, b7, b8, b9] = self.coefficients.all();
        let q = sr * p_h * nu_0.log10();
        let f = b1 + b4 * q + b5 * (-q).exp() + b9 * s.exp();
        let powers = p_h.powf(b2) * sr.powf(b3) * v_e.powf(b6) * nu_0.powf(b7) * r.powf(b8);
        let value = finite("friction coefficient", scale * f.exp() * powers)?;
        Ok(Checked { value, outside })
    }
}

fn viscosity_in_centipoise(viscosity: DynamicViscosity) -> Result<f64, DomainError> {
    let nu_0 = viscosity.si() * 1e3;
    DomainError::require(
        nu_0.is_finite() && nu_0 > 1.0,
        "viscosity",
        nu_0,
        "mPa s",
        "must be finite and above 1 mPa s for Xu's law",
    )
}

fn finite(name: &'static str, value: f64) -> Result<f64, DomainError> {
    DomainError::require(value.is_finite(), name, value, "-", "must be finite")
}

fn positive(name: &'static str, value: f64) -> Result<f64, DomainError> {
    let rule = "must be finite and greater than zero";
    DomainError::require(value.is_finite() && value > 0.0, name, value, "-", rule)
}
