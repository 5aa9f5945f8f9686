//! Compliance of a tooth and its foundation after Weber and Banaschek.
//!
//! Source: C. Weber and K. Banaschek 1953, the base of ISO 6336-1 and DIN 3990 (constants from memory,
//! source not reached; checked against the stiffness polynomial of ISO 6336-1 and finite elements).
//!
//! | symbol | meaning | unit |
//! |---|---|---|
//! | q₁ | bending, shear and compression of the tooth, per metre of contact line | m²/N |
//! | q₂ | yielding of the half-plane below the root chord | m²/N |
//! | L | height η of the load line on the centre line of the tooth | m |
//! | s_f | root chord | m |
//! | a′ | angle of the load line | rad |
//! | X(η) | half thickness of the tooth | m |
//!
//! Limits: prismatic teeth on a massive body; a load line below the root chord (L < 0) bends
//! nothing, q₁ = 0, and q₂ is taken with L as it is.

use std::f64::consts::PI;
use std::num::NonZeroUsize;

use asperity_core::cite;
use asperity_core::material::Material;

use crate::quadrature::gauss_legendre;
use crate::tooth_outline::{LoadLine, Outline};

/// Points on the involute between the root and the load line.
const INVOLUTE_ORDER: NonZeroUsize = NonZeroUsize::MIN.saturating_add(15);

/// Compliance of one tooth of a gear.
#[derive(Debug, Clone)]
pub(crate) struct ToothCompliance {
    pub(crate) outline: Outline,
    young: f64,
    poisson: f64,
    rule: Vec<(f64, f64)>,
}

impl ToothCompliance {
    pub(crate) fn new(outline: Outline, material: &Material) -> Self {
        cite!("Compliance-1");
        cite!("Compliance-2");
        Self {
            outline,
            young: material.young.si(),
            poisson: material.poisson,
            rule: gauss_legendre(INVOLUTE_ORDER),
        }
    }

    /// q₁ + q₂ for a contact at the roll length ρ of the virtual gear.
    pub(crate) fn total(&self, roll: f64) -> f64 {
        let load = self.outline.load_line(roll);
        self.bending(&load) + self.foundation(&load)
    }

    /// q₁ = cos² a′·\[12 (1 − ν²)/E·∫₀ᴸ (L − η)²/(2X)³ dη
    /// + (2.4 (1 + ν)/E + tan² a′ (1 − ν²)/E)·∫₀ᴸ dη/(2X)\]                       [Compliance-1]
    pub(crate) fn bending(&self, load: &LoadLine) -> f64 {
        let top = load.arm;
        if top <= 0.0 {
            return 0.0;
        }
        let [moment, area] = self.outline.integrate(top, &self.rule, |eta, half| {
            let width = 2.0 * half;
            [(top - eta).powi(2) / width.powi(3), 1.0 / width]
        });
        let (e, nu) = (self.young, self.poisson);
        let plane = (1.0 - nu * nu) / e;
        load.angle.cos().powi(2)
            * (12.0 * plane * moment
                + (2.4 * (1.0 + nu) / e + load.angle.tan().powi(2) * plane) * area)
    }

    /// q₂ = cos² a′ (1 − ν²)/E·\[18/π (L/s_f)² + 2 (1 − 2ν)/(1 − ν)·L/s_f
    /// + 4.8/π·(1 + (1 − ν)/2.4·tan² a′)\]                                       [Compliance-2]
    pub(crate) fn foundation(&self, load: &LoadLine) -> f64 {
        let nu = self.poisson;
        let arm = load.arm / self.outline.root_chord;
        load.angle.cos().powi(2) * (1.0 - nu * nu) / self.young
            * (18.0 / PI * arm * arm
                + 2.0 * (1.0 - 2.0 * nu) / (1.0 - nu) * arm
                + 4.8 / PI * (1.0 + (1.0 - nu) / 2.4 * load.angle.tan().powi(2)))
    }
}
