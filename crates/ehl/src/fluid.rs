//! Dimensionless laws of the oil on the scales of a contact.

use asperity_oil::{RelativeDensity, RelativeViscosity, ShearThinning};

use crate::dimensionless::Scales;
use crate::oil::Oil;

/// Dimensionless laws of one problem: P = p/p₀, H = h·R/a².
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) struct Fluid {
    pub(crate) viscosity: RelativeViscosity,
    pub(crate) density: RelativeDensity,
    pub(crate) thinning: ShearThinning,
    /// λ of the Reynolds equation.
    pub(crate) speed: f64,
    /// Standard deviation of the ridges across the flow, over the film scale.
    pub(crate) roughness: f64,
}

impl Fluid {
    /// The laws of `oil` on the scales of a contact.
    pub(crate) fn new(oil: &Oil, scales: &Scales) -> Self {
        let p_0 = scales.max_pressure.si();
        let sheared =
            |stress: f64| oil.viscosity.si() * scales.sliding.abs() / (scales.film * stress);
        let thinning = if scales.sliding == 0.0 {
            ShearThinning::None
        } else {
            oil.shear_law.thinning(sheared)
        };
        Self {
            viscosity: oil.viscosity_over(p_0),
            density: oil.density_law.relative(p_0),
            thinning,
            speed: scales.speed,
            roughness: 0.0,
        }
    }

    /// These laws without shear thinning.
    pub(crate) fn newtonian(self) -> Self {
        Self {
            thinning: ShearThinning::None,
            ..self
        }
    }
}
