//! Profiles with a given spectrum and a given height distribution.
//!
//! Source: Pérez-Ràfols and Almqvist 2019: alternately imposes the spectrum and the heights.
//!
//! | symbol | meaning | unit |
//! |---|---|---|
//! | C(q) | spectrum of the self-affine recipe | m³ |
//! | h_(k) | ordered heights of the distribution | m |
//!
//! The height distribution is exact, the spectrum approximate; the result contains the measured parameters.

use asperity_core::cite;
use asperity_core::numerics::real_transforms;
use asperity_core::{DomainError, Profile};
use realfft::num_complex::Complex;
use serde::{Deserialize, Serialize};

use super::achieved::{Achieved, Generated};
use super::scaling::scaled;
use super::self_affine::SelfAffine;
use crate::material_ratio::ascending;

/// Distribution of heights about their mean.
#[derive(Debug, Clone, Copy, PartialEq, Serialize, Deserialize)]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
#[serde(rename_all = "kebab-case", deny_unknown_fields)]
#[non_exhaustive]
pub enum HeightDistribution {
    /// Normal heights, Rsk 0 and Rku 3.
    Gaussian,
    /// Uniform heights, Rsk 0 and Rku 1.8: turned or honed flats.
    Uniform,
    /// Weibull heights with a tail of peaks: Rsk 2 at shape 1, 0 at 3.6.
    WeibullPeaks {
        /// Shape, positive.
        shape: f64,
    },
    /// Inverted Weibull heights, with a tail of valleys: finished flanks.
    WeibullDales {
        /// Shape, positive.
        shape: f64,
    },
}

impl HeightDistribution {
    /// Quantile at probability 0 < p < 1, in arbitrary units and offset.
    fn quantile(self, p: f64) -> f64 {
        let weibull = |p: f64, shape: f64| (-(1.0 - p).ln()).powf(1.0 / shape);
        match self {
            Self::Gaussian => normal_quantile(p),
            Self::Uniform => p,
            Self::WeibullPeaks { shape } => weibull(p, shape),
            Self::WeibullDales { shape } => -weibull(1.0 - p, shape),
        }
    }
}

/// Recipe of a non-Gaussian profile.
#[derive(Debug, Clone, Copy, PartialEq, Serialize, Deserialize)]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
#[serde(rename_all = "kebab-case", deny_unknown_fields)]
pub struct NonGaussian {
    /// Spectrum, Rq, size and seed.
    pub spectrum: SelfAffine,
    /// Height distribution.
    pub heights: HeightDistribution,
}

impl NonGaussian {
    /// z ← h_(rank z) after |F z| ← √C, until the order of the heights converges     `[NonGaussian-1]`
    ///
    /// # Errors
    /// As [`SelfAffine::generate`], and when a shape is not positive.
    ///
    /// ```
    /// use asperity_core::quantity::Length;
    /// use asperity_roughness::generate::{HeightDistribution, NonGaussian, SelfAffine};
    /// let recipe = NonGaussian {
    ///     spectrum: SelfAffine {
    ///         points: 8192, spacing: Length::from_si(0.5e-6), rq: Length::from_si(0.3e-6), hurst: 0.8,
    ///         roll_off: Length::from_si(50e-6), short_cut: Length::from_si(5e-6), seed: 7,
    ///     },
    ///     heights: HeightDistribution::WeibullDales { shape: 1.5 },
    /// };
    /// let generated = recipe.generate()?;
    /// // Skewness of Weibull heights of shape 1.5: 1.072 (Johnson, Kotz, Balakrishnan 1994, chapter 21).
    /// assert!((generated.achieved.rsk.unwrap() + 1.072).abs() < 0.01);
    /// assert!(generated.achieved.spectrum_error.unwrap() < 0.1);
    /// # Ok::<(), asperity_core::DomainError>(())
    /// ```
    pub fn generate(&self) -> Result<Generated, DomainError> {
        cite!("NonGaussian-1");
        self.check()?;
        let start = self.spectrum.generate()?;
        let targets = self.targets(start.len());
        let whole = Band {
            transmission: None,
            targets: &targets,
        };
        let imposed = with_heights(start.into_heights(), &[whole]);
        let profile = Profile::new(self.spectrum.spacing, imposed.heights)?;
        let achieved = Achieved {
            spectrum_error: Some(imposed.spectrum_error),
            iterations: Some(imposed.iterations),
            ..Achieved::from_profile(&profile)
        };
        Ok(Generated { profile, achieved })
    }

    fn check(&self) -> Result<(), DomainError> {
        use HeightDistribution::{WeibullDales, WeibullPeaks};
        if let WeibullPeaks { shape } | WeibullDales { shape } = self.heights {
            let rule = "must lie between 0.2 and 100";
            DomainError::require((0.2..=100.0).contains(&shape), "shape", shape, "-", rule)?;
        }
        Ok(())
    }

    /// The heights in ascending order, with zero mean and the Rq of the recipe.
    fn targets(&self, n: usize) -> Vec<f64> {
        let at = |k: usize| self.heights.quantile((k as f64 + 0.5) / n as f64);
        let raw: Vec<f64> = (0..n).map(at).collect();
        let fallback = raw.clone();
        scaled(self.spectrum.spacing, raw, self.spectrum.rq)
            .map_or(fallback, |profile| profile.heights().to_vec())
    }
}

/// Heights of a distribution in an order that has nearly the spectrum of a given profile.
pub(super) struct Imposed {
    pub(super) heights: Vec<f64>,
    /// Root mean square error of the amplitudes, relative to those of the given profile.
    pub(super) spectrum_error: f64,
    pub(super) iterations: usize,
}

/// Part of a profile whose heights are given.
pub(super) struct Band<'a> {
    /// Share of each line of the spectrum in the part; `None` for the whole profile.
    pub(super) transmission: Option<Vec<f64>>,
    /// Heights in ascending order, as many as the profile has points.
    pub(super) targets: &'a [f64],
}

/// Orders the heights of each of the `bands` of a profile so that the spectrum of their sum is near that of `start`.
pub(super) fn with_heights(start: Vec<f64>, bands: &[Band<'_>]) -> Imposed {
    cite!("NonGaussian-1");
    const MAX_ITERATIONS: usize = 100;
    // Relative change of the spectrum error below which further iterations change only single points.
    const TOLERANCE: f64 = 1e-4;
    let n = start.len();
    let (forward, inverse) = real_transforms(n);
    let mut spectrum = forward.make_output_vec();
    let done = forward.process(&mut start.clone(), &mut spectrum);
    debug_assert!(done.is_ok(), "buffers are made by the plan");
    let amplitudes: Vec<f64> = spectrum.iter().map(|value| value.norm()).collect();
    let total: f64 = amplitudes.iter().map(|a| a * a).sum();
    let part = |spectrum: &[Complex<f64>], band: &Band<'_>| {
        let mut lines = spectrum.to_vec();
        for (line, share) in lines.iter_mut().zip(band.transmission.iter().flatten()) {
            *line *= *share;
        }
        let mut heights = inverse.make_output_vec();
        let done = inverse.process(&mut lines, &mut heights);
        debug_assert!(done.is_ok(), "buffers are made by the plan");
        heights
    };
    let mut parts: Vec<Vec<f64>> = bands
        .iter()
        .map(|band| match band.transmission {
            Some(_) => part(&spectrum, band),
            None => start.clone(),
        })
        .collect();
    let (mut error, mut iterations) = (f64::INFINITY, 0);
    let mut heights = start;
    while iterations < MAX_ITERATIONS {
        iterations += 1;
        heights.fill(0.0);
        for (z, band) in parts.iter().zip(bands) {
            let order = ascending(z.iter().copied());
            for (at, target) in order.into_iter().zip(band.targets) {
                heights[at] += *target;
            }
        }
        let done = forward.process(&mut heights.clone(), &mut spectrum);
        debug_assert!(done.is_ok(), "buffers are made by the plan");
        let off = |(value, a): (&Complex<f64>, &f64)| (value.norm() - a).powi(2);
        let squares: f64 = spectrum.iter().zip(&amplitudes).map(off).sum();
        let next = (squares / total).sqrt();
        let is_done = (error - next).abs() < TOLERANCE * error;
        error = next;
        if is_done {
            break;
        }
        for (k, (value, a)) in spectrum.iter_mut().zip(&amplitudes).enumerate() {
            let norm = value.norm();
            *value = if norm > 0.0 {
                *value * (a / norm)
            } else {
                Complex::new(0.0, 0.0)
            };
            // The first and last coefficient of a real signal are real.
            if k == 0 || 2 * k == n {
                value.im = 0.0;
            }
        }
        for (z, band) in parts.iter_mut().zip(bands) {
            *z = part(&spectrum, band);
        }
    }
    Imposed {
        heights,
        spectrum_error: error,
        iterations,
    }
}

/// Quantile of the normal distribution with an error of 1.2·10⁻⁹ (rational fits of Acklam 2003).
fn normal_quantile(p: f64) -> f64 {
    const A: [f64; 6] = [
        -3.969_683_028_665_376e1,
        2.209_460_984_245_205e2,
        -2.759_285_104_469_687e2,
        1.383_577_518_672_69e2,
        -3.066_479_806_614_716e1,
        2.506_628_277_459_239,
    ];
    const B: [f64; 5] = [
        -5.447_609_879_822_406e1,
        1.615_858_368_580_409e2,
        -1.556_989_798_598_866e2,
        6.680_131_188_771_972e1,
        -1.328_068_155_288_572e1,
    ];
    const C: [f64; 6] = [
        -7.784_894_002_430_293e-3,
        -3.223_964_580_411_365e-1,
        -2.400_758_277_161_838,
        -2.549_732_539_343_734,
        4.374_664_141_464_968,
        2.938_163_982_698_783,
    ];
    const D: [f64; 4] = [
        7.784_695_709_041_462e-3,
        3.224_671_290_700_398e-1,
        2.445_134_137_142_996,
        3.754_408_661_907_416,
    ];
    const TAIL: f64 = 0.024_25;
    let horner = |c: &[f64], x: f64| c.iter().fold(0.0, |sum, c| sum * x + c);
    let tail = |p: f64| {
        let q = (-2.0 * p.ln()).sqrt();
        horner(&C, q) / (horner(&D, q) * q + 1.0)
    };
    if p < TAIL {
        tail(p)
    } else if p > 1.0 - TAIL {
        -tail(1.0 - p)
    } else {
        let q = p - 0.5;
        let r = q * q;
        horner(&A, r) * q / (horner(&B, r) * r + 1.0)
    }
}

#[cfg(test)]
mod tests {
    use asperity_core::quantity::Length;

    use super::*;

    #[test]
    fn the_normal_quantile_is_that_of_tables() {
        // 1.959963985 and 3.090232306: Abramowitz and Stegun 1964, table 26.5.
        assert!((normal_quantile(0.975) - 1.959_963_985).abs() < 1e-8);
        assert!((normal_quantile(0.001) + 3.090_232_306).abs() < 1e-8);
        assert!(normal_quantile(0.5).abs() < 1e-12);
    }

    #[test]
    fn heights_are_those_of_the_distribution_and_the_spectrum_is_near() {
        let spectrum = SelfAffine {
            points: 4096,
            spacing: Length::from_si(0.5e-6),
            rq: Length::from_si(0.3e-6),
            hurst: 0.8,
            roll_off: Length::from_si(50e-6),
            short_cut: Length::from_si(5e-6),
            seed: 3,
        };
        for (heights, rsk, rku) in [
            (HeightDistribution::Gaussian, 0.0, 3.0),
            (HeightDistribution::Uniform, 0.0, 1.8),
            // Exponential heights: skewness 2, kurtosis 9.
            (HeightDistribution::WeibullPeaks { shape: 1.0 }, 2.0, 9.0),
            (HeightDistribution::WeibullDales { shape: 1.0 }, -2.0, 9.0),
        ] {
            let found = NonGaussian { spectrum, heights }
                .generate()
                .unwrap()
                .achieved;
            // The tails of 4096 quantiles are cut at 1/8192.
            assert!((found.rsk.unwrap() - rsk).abs() < 0.03, "{found:?}");
            assert!((found.rku.unwrap() / rku - 1.0).abs() < 0.05, "{found:?}");
            assert!((found.rq.si() / 0.3e-6 - 1.0).abs() < 1e-12);
            // Exponential heights have no valleys: their spectrum gives way by a fifth.
            assert!(found.spectrum_error.unwrap() < 0.2, "{found:?}");
        }
    }
}
