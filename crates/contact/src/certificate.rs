//! Upper bounds of the error of a pressure.
//!
//! The contact problem is to minimise ½ p'Ap + h'p over 0 ≤ p ≤ p_max with Σ p·dx = W. For any α the
//! dual problem gives a lower bound of the energy, so the difference is an upper bound of the error of
//! the energy, and hence of ½ |p − p*|_A².
//!
//! | symbol | meaning | unit |
//! |---|---|---|
//! | p, p_max | pressure, its limit | Pa |
//! | v = A p + h | gap before the approach | m |
//! | α | approach | m |
//! | g = v − α | gap | m |
//! | u = v − h | deformation of both bodies together | m |
//! | g_ref | reference gap: the smaller of the ranges of h and of u about the contact | m |
//!
//! The errors are relative to the deformation if the gap has a larger range: a distant deep point would
//! otherwise make any relative error small.

use asperity_core::cite;
use asperity_core::quantity::Length;
use serde::Serialize;

/// Three measures of error, each zero for the exact solution.
#[derive(Debug, Clone, Copy, PartialEq, Serialize)]
#[non_exhaustive]
pub struct Certificate {
    /// Bound of the energy error, relative to Σp·g_ref (see [`duality_gap`]).
    pub duality_gap: f64,
    /// Largest overlap of points below the pressure limit, relative to g_ref.
    pub penetration: f64,
    /// |Σ p·dx − W|/W; zero when the approach is controlled.
    pub load_error: f64,
    /// g_ref: the smaller of the range of the gap (including the displacement by a prescribed pressure)
    /// and the range of the deformation from half a contact width before the first point in contact to
    /// half a contact width behind the last. At least a thousandth of the deformation, which applies to
    /// bodies with a nearly constant gap.
    pub reference_gap: Length,
}

impl Certificate {
    /// Whether all three errors are within `tolerance`; false if one is NaN.
    pub fn within(&self, tolerance: f64) -> bool {
        self.duality_gap <= tolerance
            && self.penetration <= tolerance
            && self.load_error <= tolerance
    }
}

/// Without limit Σ p·(g − λ); with one min(Σ p·g⁺ + (p_max − p)·(−g)⁺, Σ p·(g⁺ − λ))    [Duality-1]
///
/// with λ = min(g, 0) over the points below the limit. `pressure` in Pa and `gap` in m belong to
/// one solution; `limit` is p_max in Pa, infinite without a limit. The result in Pa m is at least the
/// excess of the energy over its minimum under the same load. With a limit, the first bound is the
/// Lagrangian at g and the second the Lagrangian at g − λ, which does not grow with the limit.
///
/// ```
/// use asperity_contact::certificate::duality_gap;
/// // Complementary: pressure where the gap is closed, and nowhere else.
/// assert_eq!(duality_gap(&[0.0, 2.0], &[1e-6, 0.0], f64::INFINITY), 0.0);
/// assert_eq!(duality_gap(&[0.0, 2.0], &[0.0, 1.0], f64::INFINITY), 2.0);
/// // At any limit an overlap of 1e-9 saves at most the load times 1e-9.
/// assert_eq!(duality_gap(&[0.0, 2.0], &[-1e-9, 0.0], 1e9), 2e-9);
/// ```
pub fn duality_gap(pressure: &[f64], gap: &[f64], limit: f64) -> f64 {
    cite!("Duality-1");
    let pairs = || pressure.iter().zip(gap);
    let below = pairs().filter(|&(&p, _)| p < limit);
    let least = below.fold(0.0_f64, |least, (_, &g)| least.min(g));
    if limit.is_finite() {
        let fixed: f64 = pairs()
            .map(|(&p, &g)| p * g.max(0.0) + (limit - p) * (-g).max(0.0))
            .sum();
        let shifted: f64 = pairs().map(|(&p, &g)| p * (g.max(0.0) - least)).sum();
        fixed.min(shifted)
    } else {
        pairs().map(|(&p, &g)| p * (g - least)).sum()
    }
}
