//! Hurst exponent of a profile from its spectrum.
//!
//! Source: Jacobs, Junge, Pastewka 2017 (power law of the spectrum, averages over bands of equal ratio).
//!
//! | symbol | meaning | unit |
//! |---|---|---|
//! | C(f) | power spectral density | m³ |
//! | H | Hurst exponent | - |
//! | b | slope of log C against log f | - |
//!
//! The user states the wavelengths of the fit, because the slope differs above the roll-off and below the filter
//! cut-off of a spectrum.

use asperity_core::cite;
use asperity_core::quantity::Length;
use asperity_core::{DomainError, Profile};
use serde::{Deserialize, Serialize};

use crate::error::RoughnessError;
use crate::spectral::power_spectrum;

/// Bands per decade of wavelength.
const BANDS_PER_DECADE: f64 = 10.0;
/// Minimum number of bands of a fit.
const MIN_BANDS: usize = 4;

/// A fitted power law.
#[derive(Debug, Clone, Copy, PartialEq, Serialize, Deserialize)]
#[non_exhaustive]
pub struct HurstFit {
    /// Hurst exponent H = −(b + 1)/2; outside 0 .. 1 the profile is not self-affine.
    pub hurst: f64,
    /// Standard error of H, from the scatter of the bands about the line.
    pub standard_error: f64,
    /// Slope b of log C against log f.
    pub slope: f64,
    /// Number of fitted bands.
    pub bands: usize,
}

/// log C = a + b log f,  H = −(b + 1)/2                                          `[Hurst-1]`
///
/// A least-squares line through the means of C over bands of a tenth of a decade, from wavelength
/// `longest` to `shortest`.
///
/// # Errors
/// When the wavelengths are out of order or outside the range of the profile, or span fewer than four bands.
///
/// ```
/// use asperity_core::quantity::Length;
/// use asperity_roughness::{generate::SelfAffine, hurst::hurst_fit};
/// let recipe = SelfAffine {
///     points: 1 << 16, spacing: Length::from_si(0.5e-6), rq: Length::from_si(0.3e-6), hurst: 0.7,
///     roll_off: Length::from_si(400e-6), short_cut: Length::from_si(4e-6), seed: 3,
/// };
/// let fit = hurst_fit(&recipe.generate()?, Length::from_si(200e-6), Length::from_si(8e-6))?;
/// assert!((fit.hurst - 0.7).abs() < 0.05, "{fit:?}");
/// # Ok::<(), asperity_roughness::RoughnessError>(())
/// ```
pub fn hurst_fit(
    profile: &Profile,
    longest: Length,
    shortest: Length,
) -> Result<HurstFit, RoughnessError> {
    cite!("Hurst-1");
    let (long, short) = (
        DomainError::positive("longest wavelength", longest)?,
        DomainError::positive("shortest wavelength", shortest)?,
    );
    let (length, dx) = (profile.length().si(), profile.spacing().si());
    DomainError::require(
        short < long && long <= length && short >= 2.0 * dx,
        "longest wavelength",
        long,
        "m",
        "must be above the shortest, within the profile, and the shortest at least two spacings",
    )?;
    let points = bands(profile, long, short)?;
    RoughnessError::at_least(
        points.len(),
        MIN_BANDS,
        "a Hurst fit, counted in bands of a tenth of a decade",
    )?;
    let (slope, error) = line(&points);
    Ok(HurstFit {
        hurst: -0.5 * (slope + 1.0),
        standard_error: 0.5 * error,
        slope,
        bands: points.len(),
    })
}

/// Mean log f and log C of each band with power.
fn bands(profile: &Profile, long: f64, short: f64) -> Result<Vec<(f64, f64)>, RoughnessError> {
    let spectrum = power_spectrum(profile)?;
    let band = |f: f64| ((f * long).log10() * BANDS_PER_DECADE).floor();
    let mut bands: Vec<(f64, f64, f64, f64)> = Vec::new();
    for (k, density) in spectrum.density.iter().enumerate() {
        let f = k as f64 * spectrum.frequency_step;
        if f < 1.0 / long || f > 1.0 / short {
            continue;
        }
        match bands.last_mut() {
            Some(last) if last.0 == band(f) => {
                last.1 += f.log10();
                last.2 += density;
                last.3 += 1.0;
            }
            _ => bands.push((band(f), f.log10(), *density, 1.0)),
        }
    }
    let means = bands.iter().map(|(_, f, c, n)| (f / n, (c / n).log10()));
    Ok(means.filter(|(_, c)| c.is_finite()).collect())
}

/// Slope of the least-squares line and its standard error.
fn line(points: &[(f64, f64)]) -> (f64, f64) {
    let n = points.len() as f64;
    let mean = |value: fn(&(f64, f64)) -> f64| points.iter().map(value).sum::<f64>() / n;
    let (x0, y0) = (mean(|p| p.0), mean(|p| p.1));
    let square: f64 = points.iter().map(|(x, _)| (x - x0).powi(2)).sum();
    let product: f64 = points.iter().map(|(x, y)| (x - x0) * (y - y0)).sum();
    let slope = product / square;
    let off = |(x, y): &(f64, f64)| (y - y0 - slope * (x - x0)).powi(2);
    let scatter: f64 = points.iter().map(off).sum::<f64>() / (n - 2.0);
    (slope, (scatter / square).sqrt())
}
