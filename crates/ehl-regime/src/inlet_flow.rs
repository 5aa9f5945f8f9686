//! Gap that the inlet of a rough line contact supplies with oil.
//!
//! | symbol | meaning | unit |
//! |---|---|---|
//! | h_c | central film of smooth flanks, with its thermal reduction | m |
//! | σ_d | standard deviation of the attenuated roughness in the window | m |
//! | γ | lay: 0 ridges across the whole face, 1 isotropic | - |
//! | t | lay factor (3/(1 + γ) − 1)/2 | - |
//! | Ψ | mean gap of rough flanks over the film of smooth ones | - |
//! | φ | share of the load on the asperities | - |
//! | h̄ | mean gap supplied | m |
//!
//! Ψ is Grubin's inlet with the exact flow factor of transverse ridges, ⟨h⁻³⟩ = h⁻³ (1 + 6 s²/h²), in its limit of
//! small s: d(Ψ²)/d(σ_d/h_c)² is 2.341 to 2.348 in four contacts. t is Tripp's lay factor: 1/(1 + γ) is the mean of k_x²/k²
//! over an elliptical spectrum. Compared with a mixed-EHL solver of plane strain for σ_d/h_c up to 3: root mean
//! square 6.5 % of the gap over 51 cases; hot and slow contacts beyond that are outside it.
//!
//! The film thickens as the asperities take load off it: h ∝ w^(−0.13) and, with the stiffness, −0.03
//! more (Johnson, Greenwood and Poon's 6.3 is its inverse).

use asperity_core::quantity::{Density, Length, Pressure};
use asperity_core::{DomainError, cite};
use asperity_oil::dowson_higginson_density;

use serde::de::{self, Visitor};
use serde::{Deserialize, Deserializer, Serialize};

use crate::error::RegimeError;
use crate::gap_law::GapLaw;

/// Slope of Ψ² over (σ_d/h_c)² for transverse ridges, from Grubin's inlet.
const INLET_SLOPE: f64 = 2.342;
/// Largest asperity share that the supply is evaluated at, and that a contact is given.
pub const LARGEST_SHARE: f64 = 0.99;

/// Lay of the roughness: how far the ridges run across the face.
#[derive(Debug, Clone, Copy, PartialEq, PartialOrd, Serialize)]
#[serde(into = "f64")]
pub struct Lay(f64);

/// Lays with a name, γ 0 and 1.
const NAMED: [(&str, Lay); 2] = [("across", Lay::ACROSS), ("isotropic", Lay::ISOTROPIC)];

impl<'de> Deserialize<'de> for Lay {
    fn deserialize<D: Deserializer<'de>>(deserializer: D) -> Result<Self, D::Error> {
        deserializer.deserialize_any(LayVisitor)
    }
}

struct LayVisitor;

impl Visitor<'_> for LayVisitor {
    type Value = Lay;

    fn expecting(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        write!(f, "across, isotropic, or a number from 0 to 1")
    }

    fn visit_f64<E: de::Error>(self, gamma: f64) -> Result<Lay, E> {
        Lay::new(gamma).map_err(E::custom)
    }

    fn visit_i64<E: de::Error>(self, gamma: i64) -> Result<Lay, E> {
        self.visit_f64(gamma as f64)
    }

    fn visit_u64<E: de::Error>(self, gamma: u64) -> Result<Lay, E> {
        self.visit_f64(gamma as f64)
    }

    fn visit_str<E: de::Error>(self, name: &str) -> Result<Lay, E> {
        let named = NAMED.into_iter().find(|(own, _)| *own == name);
        named
            .map(|(_, lay)| lay)
            .ok_or_else(|| E::invalid_value(de::Unexpected::Str(name), &self))
    }
}

#[cfg(feature = "schema")]
impl schemars::JsonSchema for Lay {
    fn schema_name() -> std::borrow::Cow<'static, str> {
        "Lay".into()
    }

    fn json_schema(_: &mut schemars::SchemaGenerator) -> schemars::Schema {
        schemars::json_schema!({
            "anyOf": [
                { "type": "number", "minimum": 0.0, "maximum": 1.0 },
                { "type": "string", "enum": NAMED.map(|(name, _)| name) }
            ]
        })
    }
}

impl Lay {
    /// Ridges across the whole face width, γ = 0: ground and superfinished gear flanks.
    pub const ACROSS: Self = Self(0.0);
    /// Ridges nearly across the face, γ = 1/12: the middle of 0 to 1/6 measured on ground flanks.
    pub const GROUND: Self = Self(1.0 / 12.0);
    /// No lay, γ = 1.
    pub const ISOTROPIC: Self = Self(1.0);
    /// Largest lay at which the contact of lines is confirmed, γ = 1/6.
    pub const CONFIRMED: Self = Self(1.0 / 6.0);
    /// Largest lay of a reference solution, γ = 1/3.
    pub const RECORDED: Self = Self(1.0 / 3.0);

    /// The lay of this γ.
    ///
    /// # Errors
    /// When γ is not within 0..1.
    pub fn new(gamma: f64) -> Result<Self, RegimeError> {
        let rule = "must lie between 0 (ridges across the face) and 1 (isotropic)";
        DomainError::require((0.0..=1.0).contains(&gamma), "lay", gamma, "-", rule)?;
        Ok(Self(gamma))
    }

    /// γ.
    #[must_use]
    pub const fn gamma(self) -> f64 {
        self.0
    }

    /// The lay of two flanks together, weighted with the squares of their Rq; across for two smooth ones.
    ///
    /// # Errors
    /// When an Rq is negative or not finite.
    pub fn of_pair(lays: [Self; 2], rq: [Length; 2]) -> Result<Self, RegimeError> {
        let first = DomainError::non_negative("Rq1", rq[0])?.powi(2);
        let second = DomainError::non_negative("Rq2", rq[1])?.powi(2);
        if first + second == 0.0 {
            return Ok(Self::ACROSS);
        }
        Ok(Self(
            (lays[0].0 * first + lays[1].0 * second) / (first + second),
        ))
    }

    /// Lay factor t = (3/(1 + γ) − 1)/2: 1 for ridges across the face, ¼ without a lay.
    #[must_use]
    pub fn factor(self) -> f64 {
        0.5 * (3.0 / (1.0 + self.0) - 1.0)
    }
}

impl Default for Lay {
    fn default() -> Self {
        Self::ACROSS
    }
}

impl TryFrom<f64> for Lay {
    type Error = RegimeError;

    fn try_from(gamma: f64) -> Result<Self, RegimeError> {
        Self::new(gamma)
    }
}

impl From<Lay> for f64 {
    fn from(lay: Lay) -> Self {
        lay.0
    }
}

/// Mean gap of rough flanks over the film of smooth ones.
///
/// ```text
/// Ψ = √(1 + 2.342 t (σ_d/h_c)²),  t = (3/(1 + γ) − 1)/2                     [Inlet-flow]
/// ```
///
/// # Errors
/// When σ_d is negative or the film not positive.
///
/// ```
/// use asperity_core::quantity::Length;
/// use asperity_ehl_regime::inlet_flow::{Lay, inlet_factor};
/// let factor = inlet_factor(Length::from_si(0.3e-6), Length::from_si(0.1e-6), Lay::ACROSS)?;
/// assert!((factor - (1.0f64 + 2.342 * 9.0).sqrt()).abs() < 1e-12);
/// # Ok::<(), asperity_ehl_regime::RegimeError>(())
/// ```
pub fn inlet_factor(
    attenuated_rms: Length,
    smooth_film: Length,
    lay: Lay,
) -> Result<f64, RegimeError> {
    cite!("Inlet-flow");
    let sigma = DomainError::non_negative("attenuated roughness", attenuated_rms)?;
    let h = DomainError::positive("smooth film", smooth_film)?;
    Ok((1.0 + INLET_SLOPE * lay.factor() * (sigma / h).powi(2)).sqrt())
}

/// Flow through a gap between ridges over the flow of the smooth gap; the inlet factor is its limit for a small σ_d.
///
/// ```text
/// φ_x = 1/(1 + 6 t (σ_d/h)²)                                                [Line-flow]
/// ```
///
/// ```
/// use asperity_core::quantity::Length;
/// use asperity_ehl_regime::inlet_flow::{Lay, flow_of_lines};
/// let flow = flow_of_lines(Length::from_si(0.3e-6), Length::from_si(0.1e-6), Lay::ACROSS);
/// assert!((flow - 0.6).abs() < 1e-12);
/// ```
#[must_use]
pub fn flow_of_lines(gap: Length, attenuated_rms: Length, lay: Lay) -> f64 {
    cite!("Line-flow");
    let ratio = attenuated_rms / gap;
    1.0 / (1.0 + 6.0 * lay.factor() * ratio * ratio)
}

/// Mean gap supplied to a contact whose asperities carry a share of the load.
///
/// ```text
/// h̄ = h_g Ψ, `power`: h_c Ψ (1 − min(φ, 0.99))^(−0.16)                               [Supply]
/// ```
///
/// # Errors
/// When film or Ψ is not positive or the share not within 0..1.
///
/// ```
/// use asperity_core::quantity::Length;
/// use asperity_ehl_regime::{GapLaw, inlet_flow::supplied_gap};
/// let gap = supplied_gap(GapLaw::Inlet, Length::from_si(0.1e-6), 2.0, 0.5)?;
/// assert_eq!(gap.si(), 0.2e-6);
/// # Ok::<(), asperity_ehl_regime::RegimeError>(())
/// ```
pub fn supplied_gap(
    law: GapLaw,
    smooth_film: Length,
    inlet_factor: f64,
    asperity_share: f64,
) -> Result<Length, RegimeError> {
    cite!("Supply");
    let h = DomainError::positive("smooth film", smooth_film)?;
    let fits = inlet_factor.is_finite() && inlet_factor > 0.0;
    let rule = "must be finite and positive";
    DomainError::require(fits, "inlet factor", inlet_factor, "-", rule)?;
    let fits = (0.0..=1.0).contains(&asperity_share);
    let rule = "must lie between 0 and 1";
    DomainError::require(fits, "asperity share", asperity_share, "-", rule)?;
    let fluid = 1.0 - asperity_share.min(LARGEST_SHARE);
    Ok(Length::from_si(
        h * inlet_factor * fluid.powf(law.supply_power()),
    ))
}

/// Reading of the central film of a formula: mass flow or gap.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash, Default)]
pub enum CentralFilm {
    /// As the formula gives it: mass flow over ambient density and mean speed.
    #[default]
    MassFlow,
    /// The gap, that is divided by the compression of the oil at p₀.
    Gap,
}

impl CentralFilm {
    /// The thickness under this reading.
    ///
    /// ```text
    /// h = h_c/(ρ(p₀)/ρ₀) for the gap                                          [Central-gap]
    /// ```
    ///
    /// # Errors
    /// When the film is negative or the pressure negative.
    ///
    /// ```
    /// use asperity_ehl_regime::CentralFilm;
    /// let gap = CentralFilm::Gap.thickness("0.2 um".parse()?, "1 GPa".parse()?)?;
    /// assert!((gap.si() - 0.2e-6 / (1.0 + 0.6 / 2.7)).abs() < 1e-18);
    /// # Ok::<(), Box<dyn std::error::Error>>(())
    /// ```
    pub fn thickness(self, formula: Length, max_pressure: Pressure) -> Result<Length, RegimeError> {
        DomainError::non_negative("central film", formula)?;
        match self {
            Self::MassFlow => Ok(formula),
            Self::Gap => {
                cite!("Central-gap");
                let ambient = Density::from_si(1.0);
                let compressed = dowson_higginson_density(ambient, max_pressure)?;
                Ok(formula / compressed.si())
            }
        }
    }
}
