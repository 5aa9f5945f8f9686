//! Reduction of film and rolling resistance by the heat of the inlet shear.
//!
//! | symbol | meaning | unit |
//! |---|---|---|
//! | φ | thermal reduction factor | - |
//! | L | thermal loading parameter | - |
//! | p₀ | maximum Hertz pressure | Pa |
//! | E′ | 2 E* | Pa |
//! | SRR | slide-to-roll ratio (u₁ − u₂)/V_e | - |
//! | β_T | temperature coefficient of viscosity, −(dη/dT)/η₀ | 1/K |
//! | k_oil | thermal conductivity of the oil | W/(m K) |
//!
//! Sources: P. K. Gupta, H. S. Cheng, D. Zhu, N. H. Forster and J. B. Schrand, Tribol. Trans. 35
//! (1992) 269 (form confirmed in Arana, Larrañaga and Ulacia 2019, eq. 24). Gupta's factor falls ever faster with L, and its numerator turns negative: a colder or faster contact
//! would have less film. Beyond the loading L₁ at which the film no longer rises with the speed, its steepness is held, with a
//! note (assumed: a switch to another law there would be a step of 3 to 7 in the film).

use asperity_core::quantity::{DynamicViscosity, PerKelvin, Pressure, Speed, ThermalConductivity};
use asperity_core::{Checked, DomainError, FittedRange, Treatment, cite};
use serde::{Deserialize, Serialize};

use crate::error::RegimeError;

/// Steepest fall −d ln φ/d ln L of Gupta's factor: half the power of the speed in the isothermal film of Dowson and Toyoda,
/// V_e^0.69, as L grows with the square of the speed. Steeper, the film would thin as the gears turn faster. Film and rolling rise
/// with the viscosity by at least its power 0.65.
const STEEPEST: f64 = 0.345;

/// Range in which the factor falls less steeply.
const GUPTA_FALL: FittedRange = FittedRange::new(
    "-d ln(factor)/d ln(loading)",
    0.0,
    STEEPEST,
    "-",
    GUPTA_HELD,
);
/// Name of Gupta's factor in notes about loadings at which its steepness is held.
pub const GUPTA_HELD: &str = "Gupta (steepness held)";
/// Least numerator of Gupta's factor as printed.
const LEAST_NUMERATOR: f64 = 0.01;

/// Gupta et al. 1992: factor and exponent of the pressure term.
const PRESSURE_TERM: (f64, f64) = (13.2, 0.42);
/// Gupta et al. 1992: factor and exponent of the thermal loading.
const LOADING_TERM: (f64, f64) = (0.213, 0.64);
/// Gupta et al. 1992: factor and exponent of the slide-to-roll ratio.
const SLIDING_TERM: (f64, f64) = (2.23, 0.83);
/// Reduction of film and rolling resistance by inlet shear heating.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash, Default, Serialize, Deserialize)]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
#[serde(rename_all = "kebab-case", deny_unknown_fields)]
pub enum ThermalLaw {
    /// Gupta et al. 1992: pressure, thermal loading and sliding.
    #[default]
    Gupta,
    /// No reduction, φ = 1, as in the 2022 paper.
    None,
}

/// Thermal loading of the inlet.
///
/// ```text
/// L = η₀ β_T V_e²/k_oil                                                  [Thermal-load]
/// ```
///
/// # Errors
/// When the viscosity or conductivity is not positive, β_T is negative, or a value not finite.
///
/// ```
/// use asperity_ehl_regime::thermal_loading;
/// let loading = thermal_loading(
///     "97.5 mPa s".parse()?, "0.045 1/K".parse()?, "4.5679 m/s".parse()?, "0.135 W/(m K)".parse()?,
/// )?;
/// assert!((loading - 0.67814).abs() < 1e-5);
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
pub fn thermal_loading(
    viscosity: DynamicViscosity,
    temperature_coefficient: PerKelvin,
    entrainment: Speed,
    conductivity: ThermalConductivity,
) -> Result<f64, RegimeError> {
    cite!("Thermal-load");
    let eta = DomainError::positive("viscosity", viscosity)?;
    let beta = DomainError::non_negative("temperature coefficient", temperature_coefficient)?;
    let v = DomainError::finite("entrainment speed", entrainment)?;
    let k = DomainError::positive("oil conductivity", conductivity)?;
    Ok(eta * beta * v * v / k)
}

impl ThermalLaw {
    /// The factor φ on film and rolling resistance, from the maximum Hertz pressure p₀, the
    /// reduced modulus E*, the thermal loading L and the slide-to-roll ratio.
    ///
    /// # Errors
    /// When p₀ or L is negative, E* not positive, or a value not finite.
    ///
    /// ```
    /// use asperity_core::quantity::Pressure;
    /// use asperity_ehl_regime::ThermalLaw;
    /// let (p0, modulus) = (Pressure::from_si(598.54e6), Pressure::from_si(115.3846e9));
    /// let factor = ThermalLaw::Gupta.reduction(p0, modulus, 0.67814, 0.0)?;
    /// assert!((factor.value - 0.83260).abs() < 1e-5);
    /// # Ok::<(), asperity_ehl_regime::RegimeError>(())
    /// ```
    pub fn reduction(
        self,
        max_pressure: Pressure,
        reduced_modulus: Pressure,
        loading: f64,
        slide_to_roll: f64,
    ) -> Result<Checked<f64>, RegimeError> {
        match self {
            Self::Gupta => gupta(max_pressure, reduced_modulus, loading, slide_to_roll),
            Self::None => Ok(Checked::inside(1.0)),
        }
    }
}

fn checked_loading(loading: f64) -> Result<f64, DomainError> {
    DomainError::require(
        loading.is_finite() && loading >= 0.0,
        "thermal loading L",
        loading,
        "-",
        "must be finite and not negative",
    )
}

/// |SRR|
fn checked_sliding(slide_to_roll: f64) -> Result<f64, DomainError> {
    DomainError::require(
        slide_to_roll.is_finite(),
        "slide-to-roll ratio",
        slide_to_roll,
        "-",
        "must be finite",
    )
    .map(f64::abs)
}

/// Thermal reduction by Gupta et al.
///
/// ```text
/// φ = (1 − 13.2 (p₀/E′) L^0.42) / (1 + 0.213 (1 + 2.23 |SRR|^0.83) L^0.64) up to L₁, φ(L₁) (L₁/L)^0.345 beyond     [P10]
/// ```
///
/// L₁ is where −d ln φ/d ln L is 0.345.
///
/// # Errors
/// When p₀ or L is negative, E* not positive, or a value not finite.
///
/// ```
/// use asperity_core::quantity::Pressure;
/// use asperity_ehl_regime::thermal_reduction::gupta;
/// let (p0, modulus) = (Pressure::from_si(1e9), Pressure::from_si(113.5e9));
/// assert!((gupta(p0, modulus, 1.0, 0.2)?.value - 0.70398).abs() < 1e-5);
/// # Ok::<(), asperity_ehl_regime::RegimeError>(())
/// ```
pub fn gupta(
    max_pressure: Pressure,
    reduced_modulus: Pressure,
    loading: f64,
    slide_to_roll: f64,
) -> Result<Checked<f64>, RegimeError> {
    cite!("P10");
    let form = Gupta::new(max_pressure, reduced_modulus, slide_to_roll)?;
    let l = checked_loading(loading)?;
    let fall = form.fall(l);
    let mut outside = Vec::new();
    GUPTA_FALL.check_as(Treatment::Held, fall, &mut outside);
    let value = if fall > STEEPEST {
        let end = form.end(l);
        form.factor(end) * (end / l).powf(STEEPEST)
    } else {
        form.factor(l)
    };
    Ok(Checked { value, outside })
}

/// [`gupta`] as printed at every loading, its numerator at least a hundredth: how far the held steepness is from the printed form is
/// a part of the interval of a loss.
///
/// # Errors
/// As [`gupta`].
///
/// ```
/// use asperity_core::quantity::Pressure;
/// use asperity_ehl_regime::thermal_reduction::{gupta, gupta_as_printed};
/// let (p0, modulus) = (Pressure::from_si(1e9), Pressure::from_si(113.5e9));
/// assert_eq!(gupta_as_printed(p0, modulus, 1.0, 0.2)?, gupta(p0, modulus, 1.0, 0.2)?.value);
/// assert!(gupta_as_printed(p0, modulus, 100.0, 0.2)? < 0.7 * gupta(p0, modulus, 100.0, 0.2)?.value);
/// # Ok::<(), asperity_ehl_regime::RegimeError>(())
/// ```
pub fn gupta_as_printed(
    max_pressure: Pressure,
    reduced_modulus: Pressure,
    loading: f64,
    slide_to_roll: f64,
) -> Result<f64, RegimeError> {
    let form = Gupta::new(max_pressure, reduced_modulus, slide_to_roll)?;
    let [pressure, of_loading] = form.terms(checked_loading(loading)?);
    Ok((1.0 - pressure).max(LEAST_NUMERATOR) / (1.0 + of_loading))
}

/// Gupta's form at one pressure and slide-to-roll ratio.
struct Gupta {
    /// 13.2 p₀/E′
    pressure: f64,
    /// 0.213 (1 + 2.23 |SRR|^0.83)
    loading: f64,
}

impl Gupta {
    fn new(
        max_pressure: Pressure,
        reduced_modulus: Pressure,
        slide_to_roll: f64,
    ) -> Result<Self, RegimeError> {
        let p0 = DomainError::non_negative("maximum pressure", max_pressure)?;
        let e = 2.0 * DomainError::positive("reduced modulus", reduced_modulus)?;
        let srr = checked_sliding(slide_to_roll)?;
        Ok(Self {
            pressure: PRESSURE_TERM.0 * (p0 / e),
            loading: LOADING_TERM.0 * (1.0 + SLIDING_TERM.0 * srr.powf(SLIDING_TERM.1)),
        })
    }

    fn terms(&self, l: f64) -> [f64; 2] {
        [
            self.pressure * l.powf(PRESSURE_TERM.1),
            self.loading * l.powf(LOADING_TERM.1),
        ]
    }

    fn factor(&self, l: f64) -> f64 {
        let [pressure, loading] = self.terms(l);
        (1.0 - pressure) / (1.0 + loading)
    }

    /// −d ln φ/d ln L, which rises with L; 42 where the numerator is below a hundredth.
    fn fall(&self, l: f64) -> f64 {
        let [pressure, loading] = self.terms(l);
        let of_numerator = if 1.0 - pressure > LEAST_NUMERATOR {
            pressure / (1.0 - pressure)
        } else {
            1.0 / LEAST_NUMERATOR
        };
        PRESSURE_TERM.1 * of_numerator + LOADING_TERM.1 * loading / (1.0 + loading)
    }

    /// L₁ below a loading at which the fall is steeper, by bisection of ln L to its last digit.
    fn end(&self, l: f64) -> f64 {
        /// Without loading there is no fall: e^−1000 of a finite loading is 0.
        const REACH: f64 = 1e3;
        const HALVINGS: usize = 64;
        let [mut low, mut high] = [l.ln() - REACH, l.ln()];
        for _ in 0..HALVINGS {
            let middle = 0.5 * (low + high);
            if self.fall(middle.exp()) > STEEPEST {
                high = middle
            } else {
                low = middle
            }
        }
        low.exp()
    }
}
