//! Gear loss factors: sliding loss divided by friction coefficient and input power.
//!
//! Sources: Ohlendorf 1958, as in ISO/TR 14179-2:2001 (`[Loss-1]`); Wimmer 2006 (`[Loss-2]`, the
//! local loss factor H_VL).
//!
//! | symbol | meaning | unit |
//! |---|---|---|
//! | H_V | loss factor P_sliding/(μ P_in) at constant μ | - |
//! | f | load per length of contact line | N/m |
//! | V_s | sliding speed | m/s |
//! | v_b | speed of the base circles, ω₁ r_b1 | m/s |
//! | u | gear ratio z₂/z₁ | - |
//! | φ, v(ξ) | mesh phase, weight of the load sharing law | - |
//!
//! Limits: `[Loss-1]` holds for equal shares on a spur pair whose pitch point lies in single
//! contact; for helical pairs it is a convention. The other equations hold for any pair and law.

use std::num::NonZeroUsize;

use asperity_core::cite;
use serde::Serialize;

use crate::error::GearError;
use crate::load_sharing::{LoadSharing, Weights};
use crate::pair::GearPair;
use crate::quadrature::{breakpoints, gauss_legendre, integrate};

/// Points per segment; the integrands are products of polynomials and at most half a cosine wave,
/// integrated to the last digit.
const ORDER: NonZeroUsize = NonZeroUsize::MIN.saturating_add(15);

/// The loss factors of a pair.
#[derive(Debug, Clone, Copy, PartialEq, Serialize)]
pub struct LossFactors {
    /// H_V according to Ohlendorf, which depends only on the geometry.
    pub ohlendorf: f64,
    /// H_V with the line load of [`GearPair::line_load`] along the path, for helical pairs at the mean length of the
    /// contact lines.
    pub local: f64,
    /// H_V with the load shared between the contact lines at each instant, averaged over the mesh cycle. Equal to
    /// `local` on spur pairs.
    pub local_phase_averaged: f64,
}

impl GearPair {
    /// All loss factors for a load sharing law.
    ///
    /// # Errors
    /// When the law does not hold for this pair.
    ///
    /// ```
    /// use asperity_gear::{GearPair, GearPairInput, LoadSharing};
    /// let pair = GearPair::new(&GearPairInput::standard(
    ///     [50, 120], "1.3 mm".parse()?, "30 deg".parse()?, "50 mm".parse()?,
    /// ))?;
    /// let factors = pair.loss_factors(&LoadSharing::Uniform)?;
    /// assert!((factors.ohlendorf - 0.060808).abs() < 1e-6);
    /// assert!((factors.local_phase_averaged - 0.073279).abs() < 1e-6);
    /// # Ok::<(), Box<dyn std::error::Error>>(())
    /// ```
    pub fn loss_factors(&self, sharing: &LoadSharing) -> Result<LossFactors, GearError> {
        let weights = self.weights(sharing)?;
        let local = self.local_loss_factor(&weights);
        Ok(LossFactors {
            ohlendorf: self.ohlendorf_loss_factor(),
            local,
            local_phase_averaged: if self.is_spur() {
                local
            } else {
                self.phase_averaged_loss_factor(&weights)
            },
        })
    }

    /// H_V = π(u + 1)/(z₁ u cos β_b)·(1 − ε_α + ε₁² + ε₂²)                      [Loss-1]
    ///
    /// ```
    /// use asperity_gear::{GearPair, GearPairInput};
    /// let pair = GearPair::new(&GearPairInput::standard(
    ///     [50, 120], "1.3 mm".parse()?, "0 deg".parse()?, "50 mm".parse()?,
    /// ))?;
    /// assert!((pair.ohlendorf_loss_factor() - 0.0740759).abs() < 1e-7);
    /// # Ok::<(), Box<dyn std::error::Error>>(())
    /// ```
    pub fn ohlendorf_loss_factor(&self) -> f64 {
        cite!("Loss-1");
        let path = &self.path;
        self.loss_scale() * (1.0 - path.eps_alpha + path.eps_1.powi(2) + path.eps_2.powi(2))
    }

    /// π(u + 1)/(z₁ u cos β_b) = (1 + 1/u)·p_et/(2 r_b1 cos β_b)
    fn loss_scale(&self) -> f64 {
        let (u, z1) = (self.ratio, f64::from(self.teeth[0]));
        std::f64::consts::PI * (u + 1.0) / (z1 * u * self.base_helix.si().cos())
    }

    /// H_V = (b/(cos β_b p_et))·∫_A^E f·|V_s| ds/(F_bt v_b)                     [Loss-2]
    fn local_loss_factor(&self, weights: &Weights<'_>) -> f64 {
        cite!("Loss-2");
        let ends = self.segment_ends();
        // A kink in the weight of one tooth pair causes a kink in the shares of all pairs in contact with it.
        let reach = self.path.eps_alpha.ceil() as i32;
        let kinks = weights
            .knots()
            .into_iter()
            .flat_map(|knot| (-reach..=reach).map(move |j| knot + f64::from(j)));
        let breaks = breakpoints(0.0, self.path.eps_alpha, ends.into_iter().chain(kinks));
        let pitch_point = self.path.eps_2;
        let integral = integrate(&breaks, &gauss_legendre(ORDER), |xi| {
            self.unit_line_load(weights, xi) * (xi - pitch_point).abs()
        });
        2.0 * self.loss_scale() * self.contact_per_coordinate().si() * integral
    }

    /// H_V = ∫₀¹ (∫ v|V_s| dξ / ∫ v dξ) dφ/(v_b cos β_b), inner integrals over the strips in
    /// contact at the phase φ                                                   [Loss-3]
    fn phase_averaged_loss_factor(&self, weights: &Weights<'_>) -> f64 {
        cite!("Loss-3");
        let rule = gauss_legendre(ORDER);
        let pitch_point = self.path.eps_2;
        let mut knots = weights.knots();
        knots.push(pitch_point);
        let phases = self.phase_breakpoints(knots.iter().copied());
        let mean = integrate(&phases, &rule, |phase| {
            let (mut sliding, mut load) = (0.0, 0.0);
            for (from, to) in self.strips(phase) {
                let breaks = breakpoints(from, to, knots.iter().copied());
                sliding += integrate(&breaks, &rule, |xi| {
                    weights.at(xi) * (xi - pitch_point).abs()
                });
                load += integrate(&breaks, &rule, |xi| weights.at(xi));
            }
            sliding / load
        });
        2.0 * self.loss_scale() * mean
    }
}
