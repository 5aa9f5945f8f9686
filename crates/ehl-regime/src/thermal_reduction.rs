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
//! (1992) 269 (form confirmed in Arana, Larrañaga and Ulacia 2019, eq. 24); L. E. Murch and
//! W. R. D. Wilson, ASME J. Lubr. Technol. 97 (1975) 212, written 1/(1 + 0.254 L^0.62) by Wilson
//! and Sheu (1983), who also say that it holds for pure rolling only. Sliding therefore puts a
//! note on Murch–Wilson. Gupta's numerator turns negative at very high p₀/E′ and L, where the film would
//! vanish as the oil thickens; it is held at 0.3, with a note (judgement: a switch to another law there would
//! be a step of 3 to 7 in the film).

use asperity_core::quantity::{DynamicViscosity, PerKelvin, Pressure, Speed, ThermalConductivity};
use asperity_core::{Checked, DomainError, FittedRange, Treatment, cite};
use serde::{Deserialize, Serialize};

use crate::error::RegimeError;

/// Least numerator of Gupta's factor (judgement: 0.49 or more on an e-drive down to -30 °C).
const LEAST_NUMERATOR: f64 = 0.3;

/// Range in which Gupta's numerator is above its lower bound: no published range is narrower.
const GUPTA_NUMERATOR: FittedRange = FittedRange::new(
    "13.2 (p0/E') L^0.42",
    0.0,
    1.0 - LEAST_NUMERATOR,
    "-",
    "Gupta (numerator held at 0.3)",
);

/// Range in which the factor falls less steeply with the speed than the isothermal film rises (V_e^0.69, Dowson and
/// Toyoda); outside it the film would thin as the gears turn faster.
const GUPTA_FALL: FittedRange = FittedRange::new(
    "-d ln(factor)/d ln(speed)",
    0.0,
    0.69,
    "-",
    "Gupta (film falls as the speed rises)",
);

/// Murch and Wilson's analysis has equal surface speeds (Wilson and Sheu 1983).
const PURE_ROLLING: FittedRange =
    FittedRange::new("slide-to-roll ratio", 0.0, 0.0, "-", "Murch-Wilson");

/// Gupta et al. 1992: factor and exponent of the pressure term.
const PRESSURE_TERM: (f64, f64) = (13.2, 0.42);
/// Gupta et al. 1992: factor and exponent of the thermal loading.
const LOADING_TERM: (f64, f64) = (0.213, 0.64);
/// Gupta et al. 1992: factor and exponent of the slide-to-roll ratio.
const SLIDING_TERM: (f64, f64) = (2.23, 0.83);
/// Murch and Wilson 1975: constant and exponent of the thermal loading.
const MURCH_WILSON: (f64, f64) = (3.94, 0.62);

/// Reduction of film and rolling resistance by inlet shear heating.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash, Default, Serialize, Deserialize)]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
#[serde(rename_all = "kebab-case", deny_unknown_fields)]
pub enum ThermalLaw {
    /// Gupta et al. 1992: pressure, thermal loading and sliding.
    #[default]
    Gupta,
    /// Murch and Wilson 1975: thermal loading in pure rolling.
    MurchWilson,
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
            Self::MurchWilson => {
                let mut factor = Checked::inside(murch_wilson(loading)?);
                PURE_ROLLING.check(checked_sliding(slide_to_roll)?, &mut factor.outside);
                Ok(factor)
            }
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
/// φ = max(0.3, 1 − 13.2 (p₀/E′) L^0.42) / (1 + 0.213 (1 + 2.23 |SRR|^0.83) L^0.64)   [P10]
/// ```
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
    let p0 = DomainError::non_negative("maximum pressure", max_pressure)?;
    let e = 2.0 * DomainError::positive("reduced modulus", reduced_modulus)?;
    let l = checked_loading(loading)?;
    let srr = checked_sliding(slide_to_roll)?;
    let pressure = PRESSURE_TERM.0 * (p0 / e) * l.powf(PRESSURE_TERM.1);
    let sliding = 1.0 + SLIDING_TERM.0 * srr.powf(SLIDING_TERM.1);
    let loading = LOADING_TERM.0 * sliding * l.powf(LOADING_TERM.1);
    let mut outside = Vec::new();
    GUPTA_NUMERATOR.check_as(Treatment::Held, pressure, &mut outside);
    let numerator = (1.0 - pressure).max(LEAST_NUMERATOR);
    // −d ln φ/d ln V_e: L grows with the square of the speed.
    let of_numerator = match numerator > LEAST_NUMERATOR {
        true => PRESSURE_TERM.1 * pressure / numerator,
        false => 0.0,
    };
    let fall = 2.0 * (of_numerator + LOADING_TERM.1 * loading / (1.0 + loading));
    GUPTA_FALL.check(fall, &mut outside);
    Ok(Checked {
        value: numerator / (1.0 + loading),
        outside,
    })
}

/// Thermal reduction in pure rolling by Murch and Wilson.
///
/// ```text
/// φ = 3.94/(3.94 + L^0.62)                                               [Murch-Wilson]
/// ```
///
/// # Errors
/// When L is negative or not finite.
///
/// ```
/// use asperity_ehl_regime::thermal_reduction::murch_wilson;
/// assert_eq!(murch_wilson(0.0)?, 1.0);
/// # Ok::<(), asperity_ehl_regime::RegimeError>(())
/// ```
pub fn murch_wilson(loading: f64) -> Result<f64, RegimeError> {
    cite!("Murch-Wilson");
    let l = checked_loading(loading)?;
    let (c, n) = MURCH_WILSON;
    Ok(c / (c + l.powf(n)))
}
