//! Compliance of the Hertzian flattening of two flanks, which is less than proportional to the load.
//!
//! Source: C. Weber and K. Banaschek 1953 (line contact between the centre lines of the teeth;
//! derived again by references/small_constants.py).
//!
//! | symbol | meaning | unit |
//! |---|---|---|
//! | q_H | flattening over load, per metre of contact line | m²/N |
//! | h_i | distance from the contact to the centre line of tooth i | m |
//! | a | half width of the contact | m |
//! | R, E* | relative radius, reduced modulus | m, Pa |

use std::f64::consts::PI;

use asperity_core::cite;
use asperity_core::material::Material;

use crate::error::GearError;

/// Elastic constants of the flattening of two bodies.
#[derive(Debug, Clone, Copy)]
pub(crate) struct HertzCompliance {
    /// (1 − ν²)/(π E) of each body.
    factor: [f64; 2],
    /// ν/(1 − ν) of each body.
    lateral: [f64; 2],
    /// 1/(π E*) = Σ (1 − ν²)/(π E).
    pub(crate) sum: f64,
}

impl HertzCompliance {
    pub(crate) fn new(materials: &[Material; 2]) -> Result<Self, GearError> {
        let mut factor = [0.0; 2];
        for (factor, material) in factor.iter_mut().zip(materials) {
            *factor = material.compliance()? / PI;
        }
        Ok(Self {
            factor,
            lateral: [0, 1].map(|i| {
                let nu = materials[i].poisson;
                nu / (1.0 - nu)
            }),
            sum: factor[0] + factor[1],
        })
    }

    /// q_H = Σ (1 − ν²)/(π E)·\[ln(4 h²/a²) − ν/(1 − ν)\], a² = 4 f R/(π E*)          [Compliance-3]
    pub(crate) fn at(&self, depth: [f64; 2], radius: f64, load: f64) -> f64 {
        cite!("Compliance-3");
        self.shape(depth) - self.sum * (4.0 * load * radius * self.sum).ln()
    }

    /// The part of `at` that does not depend on the load.
    pub(crate) fn shape(&self, depth: [f64; 2]) -> f64 {
        (0..2)
            .map(|i| self.factor[i] * ((4.0 * depth[i] * depth[i]).ln() - self.lateral[i]))
            .sum()
    }
}
