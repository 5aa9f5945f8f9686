//! Scatter of the heights between teeth, from a few traces of which each is of another tooth.
//!
//! Sources: Efron and Stein 1981, the jackknife estimate of variance; Paulson 1942, the normal approximation of a ratio of variances;
//! Wilson and Hilferty 1931, the quantiles of χ².
//!
//! | symbol | meaning | unit |
//! |---|---|---|
//! | y_j | logarithm of Rq of trace j, of m | - |
//! | y_(b) | the same without block b, of B | - |
//! | s_y | standard deviation of y_j, with m − 1 degrees of freedom | - |
//! | v | variance of y_j by sampling within a tooth | - |
//! | τ | standard deviation between teeth of the logarithm of the heights | - |
//! | N | standard normal number of a generated tooth | - |
//! | χ²_p | quantile p of χ² with m − 1 degrees of freedom | - |

use asperity_core::numerics::{deviation, mean, standard_normal_quantile};
use asperity_core::quantity::Length;
use asperity_core::{DomainError, Estimate, Profile, cite};

use super::random::Random;
use crate::error::RoughnessError;
use crate::gaussian_filter::{Ends, mean_line};
use crate::preparation::LAMBDA_C;

/// Length of a block \[m\]: roughness has no wave as long.
const BLOCK: f64 = 300e-6;
/// Quantile of the normal distribution beyond which traces scatter more than sampling within a tooth explains.
const CERTAIN: f64 = 0.95;
/// Stream of random numbers for the factors, apart from the stream of the pieces.
const STREAM: u64 = 0x7EE7;

/// Scatter of the heights between teeth.
#[derive(Debug, Clone, PartialEq)]
pub struct Teeth {
    /// Standard deviation between teeth of the logarithm of the heights, from 5 to 95 %; zero where sampling within a tooth explains
    /// the scatter of the traces, `None` for one trace.
    pub scatter: Option<Estimate>,
    /// Factor of the heights of each trace about the mean tooth.
    factors: Vec<f64>,
    /// Mean of the factors.
    mean: f64,
    /// Standard deviation of the logarithm of the factors of generated teeth.
    drawn: f64,
}

impl Teeth {
    /// The scatter between `traces` of equal spacings, each of another tooth.
    ///
    /// ```text
    /// v = (1/m) Σ_j (B − 1)/B Σ_b (y_(b) − ȳ_(·))²,  τ² = s_y² − v if s_y²/v is beyond 95 %, else 0      [Teeth-1]
    /// ```
    ///
    /// # Errors
    /// When a trace is shorter than its filter needs.
    pub fn of(traces: &[Profile]) -> Result<Self, RoughnessError> {
        cite!("Teeth-1");
        let none = |scatter| Self {
            scatter,
            factors: vec![1.0; traces.len()],
            mean: 1.0,
            drawn: 0.0,
        };
        let (mut levels, mut within, mut freedom) = (Vec::new(), Vec::new(), 0.0);
        for trace in traces {
            let Some((level, variance, blocks)) = jackknife(trace)? else {
                return Ok(none(None));
            };
            levels.push(level);
            within.push(variance);
            freedom += blocks - 1.0;
        }
        let spare = traces.len() as f64 - 1.0;
        let Some(total) = deviation(&levels).map(|s| s * s).filter(|_| spare > 0.0) else {
            return Ok(none(None));
        };
        let within = mean(within);
        let quantile = |p: f64| chi_squared(spare, p) / spare;
        let at = |p: f64| (total / quantile(p) - within).max(0.0).sqrt();
        let explained = exceeds(total / within, spare, freedom) <= CERTAIN;
        if explained || total <= within {
            return Ok(none(Some(Estimate::new(0.0, [0.0, at(0.05)]))));
        }
        // The part of a level that is of the tooth.
        let share = (total - within) / total;
        let middle = mean(levels.iter().copied());
        let factors = levels.iter().map(|y| (share * (y - middle)).exp());
        let factors: Vec<f64> = factors.collect();
        let drawn = at(0.5);
        Ok(Self {
            scatter: Some(Estimate::new(drawn, [at(0.95), at(0.05)])),
            mean: mean(factors.iter().copied()),
            factors,
            drawn,
        })
    }

    /// The scatter in words, where there is one.
    #[must_use]
    pub fn words(&self) -> Option<String> {
        let scatter = self.scatter.filter(|scatter| scatter.value > 0.0)?;
        let [middle, low, high] =
            [scatter.value, scatter.low, scatter.high].map(|part| 100.0 * part);
        Some(format!(
            "heights scatter by {middle:.0} % ({low:.0} to {high:.0} %) between teeth"
        ))
    }

    /// Trace `k` at the height of the mean tooth.
    pub(super) fn levelled(&self, k: usize, trace: &Profile) -> Result<Profile, DomainError> {
        times(trace, self.factors[k].recip())
    }

    /// Factor of the heights of the tooth of a `seed`. The median of the estimate of its scatter over samples of the finish is τ.
    ///
    /// ```text
    /// f = f̄ exp(τ N − τ²/2),  τ² = (m − 1) s_y²/χ²_0.5 − v                                [Teeth-2]
    /// ```
    pub(super) fn factor(&self, seed: u64) -> f64 {
        if self.drawn == 0.0 {
            return self.mean;
        }
        cite!("Teeth-2");
        let mut random = Random::new(seed ^ (STREAM << 48));
        // Never 0 or 1, whose quantiles are infinite.
        let share = (random.uniform() + 0.5 * f64::EPSILON).min(1.0 - f64::EPSILON);
        let drawn = self.drawn;
        self.mean * (drawn * standard_normal_quantile(share) - 0.5 * drawn * drawn).exp()
    }
}

/// `trace` with all heights times `factor`.
pub(super) fn times(trace: &Profile, factor: f64) -> Result<Profile, DomainError> {
    let heights = trace.heights().iter().map(|z| z * factor);
    Profile::new(trace.spacing(), heights.collect())
}

/// Logarithm of Rq of a trace, its variance by leaving out blocks, and their number; `None` for fewer than two blocks or no roughness.
fn jackknife(trace: &Profile) -> Result<Option<(f64, f64, f64)>, RoughnessError> {
    let line = mean_line(trace, LAMBDA_C, Ends::Reg1)?;
    let squares: Vec<f64> = (trace.heights().iter().zip(&line))
        .map(|(z, w)| (z - w).powi(2))
        .collect();
    let blocks = (trace.length() / Length::from_si(BLOCK)) as usize;
    if blocks < 2 {
        return Ok(None);
    }
    let size = squares.len().div_ceil(blocks);
    let sums: Vec<[f64; 2]> = squares
        .chunks(size)
        .map(|part| [part.iter().sum::<f64>(), part.len() as f64])
        .collect();
    let [all, points] = [0, 1].map(|k| sums.iter().map(|sum| sum[k]).sum::<f64>());
    let without: Vec<f64> = sums
        .iter()
        .map(|[sum, count]| 0.5 * ((all - sum) / (points - count)).ln())
        .collect();
    let level = 0.5 * (all / points).ln();
    let count = without.len() as f64;
    let middle = mean(without.iter().copied());
    let spread: f64 = without.iter().map(|y| (y - middle).powi(2)).sum();
    let variance = (count - 1.0) / count * spread;
    Ok(
        (level.is_finite() && variance.is_finite() && variance > 0.0)
            .then_some((level, variance, count)),
    )
}

/// Share of ratios of two variances below `ratio`, where these are equal.
///
/// ```text
/// z = ((1 − 2/(9 ν₂)) F^⅓ − (1 − 2/(9 ν₁)))/√(2/(9 ν₂) F^⅔ + 2/(9 ν₁))
/// ```
fn exceeds(ratio: f64, first: f64, second: f64) -> f64 {
    let [a, b] = [first, second].map(|freedom| 2.0 / (9.0 * freedom));
    let root = ratio.cbrt();
    let z = ((1.0 - b) * root - (1.0 - a)) / (b * root * root + a).sqrt();
    asperity_core::numerics::standard_normal_below(z)
}

/// Quantile `p` of χ² with `freedom` degrees of freedom.
///
/// ```text
/// χ²_p = ν (1 − 2/(9 ν) + z_p √(2/(9 ν)))³
/// ```
fn chi_squared(freedom: f64, p: f64) -> f64 {
    let part = 2.0 / (9.0 * freedom);
    let root = 1.0 - part + standard_normal_quantile(p) * part.sqrt();
    freedom * root.max(0.0).powi(3)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn quantiles_are_those_of_tables() {
        // Abramowitz and Stegun, tables 26.8 and 26.9: χ² with 5, and F with 5 and 60 degrees of freedom.
        for (p, value) in [(0.05, 1.145), (0.5, 4.351), (0.95, 11.07)] {
            let found = chi_squared(5.0, p);
            assert!((found / value - 1.0).abs() < 0.02, "{p}: {found}");
        }
        assert!((exceeds(2.37, 5.0, 60.0) - 0.95).abs() < 0.003);
    }
}
