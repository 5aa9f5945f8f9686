//! Roughness in one contact, as used by the film and friction laws.

use asperity_core::quantity::Length;
use asperity_core::{DomainError, Profile};
use asperity_roughness::RoughnessError;
use asperity_roughness::composite::{Pairing, combined_rq, compose};
use asperity_roughness::material_ratio::rk_parameters;
use asperity_roughness::summits::{AsperityRadius, asperity_radius};

use crate::error::PositionError;

/// Number of asperities below which their mean radius is uncertain.
pub const FEW_ASPERITIES: usize = 5;

/// Roughness as used by the film and friction laws.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Roughness {
    /// Rq of both flanks \[m\].
    pub rq: [f64; 2],
    /// Ra of both flanks \[m\].
    pub ra: [f64; 2],
    /// Rz of both flanks \[m\]; for a trace the mean over its sections.
    pub rz: [f64; 2],
    /// Reduced peak height of the composite profile \[m\]; `None` if it is not known.
    pub reduced_peak: Option<f64>,
    /// Mean radius of the asperities of the composite profile; `None` if it is not known.
    pub asperity_radius: Option<Length>,
    /// Number of asperities of the composite profile.
    pub asperities: usize,
}

impl Roughness {
    /// Combined Rq of both flanks, S = √(Rq₁² + Rq₂²).
    ///
    /// # Errors
    /// When an Rq is negative or not finite.
    pub fn combined_rq(&self) -> Result<Length, DomainError> {
        combined_rq(Length::from_si(self.rq[0]), Length::from_si(self.rq[1]))
    }
}

/// Reduced peak height \[m\] of the composite of two windows, and its asperities if it has any.
pub fn peaks(
    windows: &[Profile; 2],
    lambda_s: Length,
) -> Result<(f64, Option<AsperityRadius>), PositionError> {
    let [first, second] = windows;
    let composite = compose(first, second, Pairing::default())?.profile;
    let peak = rk_parameters(composite.heights())?.rpk.si();
    match asperity_radius(&composite, lambda_s) {
        Ok(found) => Ok((peak, Some(found))),
        // A window without summits is smooth and has no asperity radius.
        Err(RoughnessError::NoSummit { .. } | RoughnessError::NoRadius { .. }) => Ok((peak, None)),
        Err(error) => Err(error.into()),
    }
}
