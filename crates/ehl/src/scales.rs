//! Scales and numbers that fix a lubricated line contact.

use asperity_core::quantity::{Length, Pressure};
use serde::Serialize;

/// Scales and numbers of a lubricated line contact.
#[derive(Debug, Clone, Copy, PartialEq, Serialize)]
pub struct Scales {
    /// Half width a of the Hertz contact.
    pub half_width: Length,
    /// Largest Hertz pressure p₀.
    pub max_pressure: Pressure,
    /// Film scale a²/R \[m\].
    #[serde(skip)]
    pub(crate) film: f64,
    /// Mean speed u_m \[m/s\].
    #[serde(skip)]
    pub(crate) entrainment: f64,
    /// Sliding speed u₁ − u₂ \[m/s\].
    #[serde(skip)]
    pub(crate) sliding: f64,
    /// λ of the Reynolds equation.
    pub speed: f64,
    /// Slide-to-roll ratio (u₁ − u₂)/u_m.
    pub slide_to_roll: f64,
    /// Moes' load parameter M.
    pub moes_load: f64,
    /// Moes' lubricant parameter L; zero for an isoviscous oil.
    pub moes_lubricant: f64,
}
