//! Recipes fitted to measured traces: other traces of the same kind.
//!
//! The spectrum is averaged over bands of its lines and over the traces; the heights of roughness and waviness, split at
//! λc = 0.25 mm, are pooled. A periodic profile several times as long as a trace gets random phases, this spectrum and these
//! heights, and a part of the length of a trace is cut out of it, so that the parameters differ from seed to seed as between
//! traces.
//!
//! The order of the phases is lost: ridges and valleys of a certain shape, marks at even distances and single scratches become
//! noise with their spectrum and their heights.

use std::f64::consts::TAU;

use asperity_core::numerics::{interpolate, real_transforms};
use asperity_core::quantity::Length;
use asperity_core::{DomainError, Profile};
use realfft::num_complex::Complex;
use serde::{Deserialize, Serialize};

use super::achieved::{Achieved, Generated};
use super::non_gaussian::{Band, Imposed, with_heights};
use super::random::Random;
use super::scaling::{check_points, scaled};
use crate::error::RoughnessError;
use crate::form::{self, Form};
use crate::gaussian_filter::{Ends, mean_line, transmission};
use crate::preparation::LAMBDA_C;
use crate::spectral::{PowerSpectrum, power_spectrum};

/// Length of the periodic profile in lengths of the trace, as long as it has at most [`PARENT_POINTS`], and at least.
const PARENT: usize = 8;
const PARENT_LEAST: usize = 2;
const PARENT_POINTS: usize = 1 << 20;
/// Least number of spectral lines in a band, and ratio of the ends of wider bands.
const LINES: usize = 4;
const BAND: f64 = 1.15;
/// Number of heights of the fitted distribution between its tails.
const INNER: usize = 512;
/// Number of heights at each end of the distribution that are stored singly.
const TAIL: usize = 64;
/// Micrometres in a metre.
pub(super) const MICRO: f64 = 1e6;

/// Recipe of a trace with the spectrum and the heights of measured ones.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
#[serde(rename_all = "kebab-case", deny_unknown_fields)]
pub struct Fitted {
    /// Number of points.
    pub points: usize,
    /// Distance between points.
    pub spacing: Length,
    /// Spatial frequency \[1/um\] of each band and density \[um3\], in ascending order of the frequency.
    pub spectrum: Vec<[f64; 2]>,
    /// Heights of the roughness: share of lower heights, from 0 to 1, and height \[um\], both in ascending order.
    pub roughness: Vec<[f64; 2]>,
    /// Heights of the waviness, in the same form.
    pub waviness: Vec<[f64; 2]>,
    /// Seed of the random phases.
    pub seed: u64,
}

impl Fitted {
    /// The recipe of `first` and `others`, traces of one surface with equal spacings.
    ///
    /// A straight line is removed from each; the recipe has as many points as `first`.
    ///
    /// # Errors
    /// When a trace has too few points, or the spacings differ.
    ///
    /// ```
    /// use asperity_core::quantity::Length;
    /// use asperity_roughness::generate::{Fitted, SelfAffine};
    /// let measured = SelfAffine {
    ///     points: 4096, spacing: Length::from_si(0.5e-6), rq: Length::from_si(0.3e-6), hurst: 0.8,
    ///     roll_off: Length::from_si(50e-6), short_cut: Length::from_si(5e-6), seed: 7,
    /// }.generate()?;
    /// let other = Fitted::to(&measured, &[], 1)?.generate()?;
    /// assert!((other.achieved.rq.si() / 0.3e-6 - 1.0).abs() < 0.2);
    /// # Ok::<(), asperity_roughness::RoughnessError>(())
    /// ```
    pub fn to(first: &Profile, others: &[Profile], seed: u64) -> Result<Self, RoughnessError> {
        let (mut spectra, mut roughness, mut waviness) = (Vec::new(), Vec::new(), Vec::new());
        for level in levelled(first, others)? {
            spectra.push(power_spectrum(&level)?);
            let line = mean_line(&level, LAMBDA_C, Ends::Reg1)?;
            roughness.extend(level.heights().iter().zip(&line).map(|(z, w)| z - w));
            waviness.extend(line);
        }
        Ok(Self {
            points: first.len(),
            spacing: first.spacing(),
            spectrum: bands(&spectra, LINES),
            roughness: distribution(roughness, TAIL, INNER),
            waviness: distribution(waviness, TAIL, INNER),
            seed,
        })
    }

    /// The recipe with a `seed` and all heights times `factor`.
    pub(super) fn times(&self, factor: f64, seed: u64) -> Self {
        let scaled = |list: &[[f64; 2]], factor: f64| -> Vec<[f64; 2]> {
            list.iter()
                .map(|[at, value]| [*at, factor * value])
                .collect()
        };
        Self {
            spectrum: scaled(&self.spectrum, factor * factor),
            roughness: scaled(&self.roughness, factor),
            waviness: scaled(&self.waviness, factor),
            seed,
            ..self.clone()
        }
    }

    /// Heights and spectrum of the fit with random phases: a part of a longer periodic profile.
    ///
    /// # Errors
    /// When a number is outside its domain, or a list is not in ascending order.
    pub fn generate(&self) -> Result<Generated, DomainError> {
        let imposed = self.imposed()?;
        let heights = imposed.heights.into_iter().take(self.points).collect();
        let profile = Profile::new(self.spacing, heights)?;
        let achieved = Achieved {
            spectrum_error: Some(imposed.spectrum_error),
            iterations: Some(imposed.iterations),
            ..Achieved::from_profile(&profile)
        };
        Ok(Generated { profile, achieved })
    }

    /// The whole periodic profile, several times as long as a trace; traces cut out of it at any place are of one kind.
    ///
    /// # Errors
    /// As [`generate`](Self::generate).
    ///
    /// ```
    /// use asperity_core::quantity::Length;
    /// use asperity_roughness::generate::{Fitted, SelfAffine};
    /// let measured = SelfAffine {
    ///     points: 2048, spacing: Length::from_si(0.5e-6), rq: Length::from_si(0.3e-6), hurst: 0.8,
    ///     roll_off: Length::from_si(50e-6), short_cut: Length::from_si(5e-6), seed: 7,
    /// }.generate()?;
    /// let fitted = Fitted::to(&measured, &[], 1)?;
    /// let whole = fitted.generate_whole()?;
    /// assert_eq!(whole.len(), 8 * 2048);
    /// assert_eq!(whole.heights()[..2048], *fitted.generate()?.profile.heights());
    /// # Ok::<(), asperity_roughness::RoughnessError>(())
    /// ```
    pub fn generate_whole(&self) -> Result<Profile, DomainError> {
        Profile::new(self.spacing, self.imposed()?.heights)
    }

    fn imposed(&self) -> Result<Imposed, DomainError> {
        let n = check_points(self.points)?;
        DomainError::positive("spacing", self.spacing)?;
        check_list("spectrum", &self.spectrum)?;
        let parent = parent_of(n)?;
        let [roughness, waviness] = [
            heights("roughness", &self.roughness, parent)?,
            heights("waviness", &self.waviness, parent)?,
        ];
        let start = gaussian(
            &self.spectrum,
            (self.spacing, n),
            mean_square(&roughness) + mean_square(&waviness),
            parent,
            &mut Random::new(self.seed),
        )?;
        let length = self.spacing * parent as f64;
        let transmitted: Vec<f64> = (0..=parent / 2)
            .map(|k| match k {
                0 => Ok(1.0),
                k => transmission(length / k as f64, LAMBDA_C),
            })
            .collect::<Result<_, _>>()?;
        let rest = transmitted.iter().map(|share| 1.0 - share).collect();
        let band = |transmission, targets| Band {
            transmission: Some(transmission),
            targets,
        };
        Ok(with_heights(
            start,
            &[band(rest, &roughness), band(transmitted, &waviness)],
        ))
    }
}

/// Gaussian heights at `n` points with a spectrum and this mean square height \[m²\], without waves longer than `points`.
pub(super) fn gaussian(
    spectrum: &[[f64; 2]],
    (spacing, points): (Length, usize),
    square: f64,
    n: usize,
    random: &mut Random,
) -> Result<Vec<f64>, DomainError> {
    let (_, plan) = real_transforms(n);
    let mut lines = plan.make_input_vec();
    let micrometres = spacing.si() * MICRO;
    let step = 1.0 / (n as f64 * micrometres);
    let longest = 1.0 / (points as f64 * micrometres);
    let logarithms: Vec<[f64; 2]> = spectrum
        .iter()
        .map(|[f, density]| [f.ln(), density.max(f64::MIN_POSITIVE).ln()])
        .collect();
    for (k, line) in lines.iter_mut().enumerate() {
        let phase = TAU * random.uniform();
        let f = k as f64 * step;
        // Waves longer than the trace went with its straight line; the last line has no phase of its own.
        if f >= longest && 2 * k < n {
            let density = interpolate(&logarithms, f.ln()).exp();
            *line = Complex::from_polar(density.sqrt(), phase);
        }
    }
    let mut heights = plan.make_output_vec();
    let done = plan.process(&mut lines, &mut heights);
    debug_assert!(done.is_ok(), "buffers are made by the plan");
    let rq = Length::from_si(square.sqrt());
    Ok(scaled(spacing, heights, rq)?.into_heights())
}

/// The `n` heights \[m\] of a distribution in ascending order.
pub(super) fn heights(
    name: &'static str,
    list: &[[f64; 2]],
    n: usize,
) -> Result<Vec<f64>, DomainError> {
    check_list(name, list)?;
    let at = |k: usize| interpolate(list, (k as f64 + 0.5) / n as f64);
    Ok((0..n).map(|k| at(k) / MICRO).collect())
}

/// Points of the periodic profile of which `n` are cut out.
pub(super) fn parent_of(n: usize) -> Result<usize, DomainError> {
    let times = (PARENT_POINTS / n).clamp(PARENT_LEAST, PARENT);
    check_points(n.saturating_mul(times))
}

/// Traces of equal spacings without their straight lines.
pub(super) fn levelled(
    first: &Profile,
    others: &[Profile],
) -> Result<Vec<Profile>, RoughnessError> {
    const SAME: f64 = 1e-5;
    let level = |trace: &Profile| {
        let [own, common] = [trace.spacing(), first.spacing()];
        if (own / common - 1.0).abs() > SAME {
            Err(RoughnessError::SpacingDiffers {
                first: common,
                second: own,
            })
        } else {
            form::remove(trace, Form::Level)
        }
    };
    std::iter::once(first).chain(others).map(level).collect()
}

/// Mean square about the mean.
pub(super) fn mean_square(heights: &[f64]) -> f64 {
    let n = heights.len() as f64;
    let mean = heights.iter().sum::<f64>() / n;
    heights.iter().map(|z| (z - mean).powi(2)).sum::<f64>() / n
}

fn check_list(name: &'static str, list: &[[f64; 2]]) -> Result<(), DomainError> {
    const LEAST: usize = 2;
    let count = list.len();
    let rule = "must have two entries at least";
    DomainError::require(count >= LEAST, name, count as f64, "-", rule)?;
    for pair in list.windows(2) {
        let [[a, _], [b, value]] = [pair[0], pair[1]];
        let rule = "must be finite, in ascending order";
        let is_sound = a >= 0.0 && a < b && b.is_finite() && value.is_finite();
        DomainError::require(is_sound, name, b, "-", rule)?;
    }
    let [place, value] = list[0];
    let rule = "must be finite and not negative";
    DomainError::require(place >= 0.0 && value.is_finite(), name, place, "-", rule)?;
    Ok(())
}

/// Mean densities of the spectra over bands of at least `least` lines of the first one.
pub(super) fn bands(spectra: &[PowerSpectrum], least: usize) -> Vec<[f64; 2]> {
    let Some(first) = spectra.first() else {
        return Vec::new();
    };
    let step = first.frequency_step;
    let mut bands = Vec::new();
    let mut low = 1;
    while low < first.density.len() {
        let high = (low + least).max((low as f64 * BAND) as usize);
        let [from, to] = [low, high].map(|k| (k as f64 - 0.5) * step);
        let (mut sum, mut count) = (0.0, 0_usize);
        for spectrum in spectra {
            let lines = [from, to].map(|f| (f / spectrum.frequency_step).ceil() as usize);
            let end = lines[1].min(spectrum.density.len());
            let densities = spectrum.density.get(lines[0]..end).unwrap_or_default();
            sum += densities.iter().sum::<f64>();
            count += densities.len();
        }
        if count > 0 {
            let middle = (from.max(0.5 * step) * to).sqrt();
            bands.push([middle / MICRO, sum / count as f64 * MICRO.powi(3)]);
        }
        low = high;
    }
    bands
}

/// Shares and heights \[um\] of heights \[m\]: all of the `tail` lowest and highest ones, and `inner` between them.
pub(super) fn distribution(mut sorted: Vec<f64>, tail: usize, inner: usize) -> Vec<[f64; 2]> {
    sorted.sort_unstable_by(f64::total_cmp);
    let n = sorted.len();
    let stride = (n.saturating_sub(2 * tail) / inner).max(1);
    let is_kept = |k: usize| k < tail || k + tail >= n || (k - tail).is_multiple_of(stride);
    let of = |k: usize| [(k as f64 + 0.5) / n as f64, sorted[k] * MICRO];
    (0..n).filter(|k| is_kept(*k)).map(of).collect()
}
