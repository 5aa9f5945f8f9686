//! Complete elliptic integrals.

use std::f64::consts::FRAC_PI_2;

/// Complete elliptic integrals of a complementary parameter m₁ = 1 − m.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct CompleteElliptic {
    /// K = ∫₀^(π/2) dt/√(1 − m sin² t).
    pub first: f64,
    /// E = ∫₀^(π/2) √(1 − m sin² t) dt.
    pub second: f64,
    /// (K − E)/m, which is π/4 at m = 0.
    pub difference: f64,
}

impl CompleteElliptic {
    /// The integrals by the arithmetic-geometric mean, to the last digits for 0 < m₁ ≤ 1; other arguments give numbers
    /// that are not finite.
    ///
    /// ```
    /// use asperity_core::numerics::CompleteElliptic;
    /// // m = 1/2: K = Γ(1/4)²/(4 √π).
    /// let half = CompleteElliptic::from_complement(0.5);
    /// assert!((half.first - 1.854_074_677_301_372).abs() < 1e-15);
    /// assert!((half.second - 1.350_643_881_047_675_5).abs() < 1e-15);
    /// ```
    #[must_use]
    pub fn from_complement(complement: f64) -> Self {
        /// Steps until both means agree to all digits for every argument: the number of digits doubles with each.
        const STEPS: usize = 10;
        let parameter = 1.0 - complement;
        let (mut mean, mut geometric) = (1.0, complement.sqrt());
        // E/K = 1 − Σ 2^(n − 1) c_n² with c₀² = m and c_n = c_(n−1)²/(4 a_n); `square` is c_n²/m.
        let mut root = parameter / (2.0 * (1.0 + geometric));
        let mut square = root / (2.0 * (1.0 + geometric));
        let (mut power, mut share) = (1.0, 0.5);
        for _ in 0..STEPS {
            share += power * square;
            power *= 2.0;
            (mean, geometric) = (0.5 * (mean + geometric), (mean * geometric).sqrt());
            let next = 0.5 * (mean + geometric);
            square *= root * root / (16.0 * next * next);
            root = root * root / (4.0 * next);
        }
        let first = FRAC_PI_2 / mean;
        Self {
            first,
            second: first * (1.0 - parameter * share),
            difference: first * share,
        }
    }
}

#[cfg(test)]
mod tests {
    use std::f64::consts::{FRAC_PI_2, FRAC_PI_4};

    use super::*;

    #[test]
    fn the_integrals_fulfil_legendres_relation_and_their_limits() {
        let round = CompleteElliptic::from_complement(1.0);
        assert_eq!([round.first, round.second], [FRAC_PI_2; 2]);
        assert_eq!(round.difference, FRAC_PI_4);
        for k in 1..60 {
            let m1 = 10_f64.powf(-0.2 * f64::from(k));
            let (one, other) = (
                CompleteElliptic::from_complement(m1),
                CompleteElliptic::from_complement(1.0 - m1),
            );
            // E K' + E' K − K K' = π/2: m₁ has an error of 1e-16, which m₁' = 1 − m₁ inherits.
            let legendre =
                one.second * other.first + other.second * one.first - one.first * other.first;
            assert!((legendre - FRAC_PI_2).abs() < 1e-14 * one.first, "{m1}");
            let difference = (one.first - one.second) / (1.0 - m1);
            assert!((one.difference / difference - 1.0).abs() < 1e-14, "{m1}");
        }
        // K → ln(4/√m₁), E → 1.
        let flat = CompleteElliptic::from_complement(1e-24);
        assert!((flat.first / 4e12_f64.ln() - 1.0).abs() < 1e-14);
        assert!((flat.second - 1.0).abs() < 1e-13);
        // Close to a circle (K − E)/m is π/4 (1 + 3 m/8).
        let near = CompleteElliptic::from_complement(1.0 - 1e-9);
        assert!((near.difference / FRAC_PI_4 - 1.0 - 0.375e-9).abs() < 1e-15);
    }
}
