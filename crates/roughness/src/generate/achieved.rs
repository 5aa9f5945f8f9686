//! Measured properties of a generated profile.

use asperity_core::Profile;
use asperity_core::quantity::Length;
use serde::{Deserialize, Serialize};

use crate::spectral;

/// A generated profile with its measured parameters.
#[derive(Debug, Clone, PartialEq, Serialize)]
#[non_exhaustive]
pub struct Generated {
    /// The profile.
    #[serde(skip)]
    pub profile: Profile,
    /// Measured parameters.
    pub achieved: Achieved,
}

impl Generated {
    /// Measures a profile over its whole length.
    pub fn new(profile: Profile) -> Self {
        let achieved = Achieved::from_profile(&profile);
        Self { profile, achieved }
    }
}

/// Parameters of a generated profile over its whole length, about its mean.
#[derive(Debug, Clone, Copy, PartialEq, Serialize, Deserialize)]
#[non_exhaustive]
pub struct Achieved {
    /// Arithmetic mean height.
    pub ra: Length,
    /// Root mean square height.
    pub rq: Length,
    /// Skewness; `None` for a flat profile.
    pub rsk: Option<f64>,
    /// Kurtosis; `None` for a flat profile.
    pub rku: Option<f64>,
    /// Difference of the highest and lowest height.
    pub rt: Length,
    /// Root mean square slope; `None` below seven points.
    pub rdq: Option<f64>,
    /// Root mean square error of the amplitudes of the spectrum, relative to the requested amplitudes.
    pub spectrum_error: Option<f64>,
    /// Number of iterations of an iterative recipe.
    pub iterations: Option<usize>,
}

impl Achieved {
    /// The parameters of `profile`.
    ///
    /// ```
    /// use asperity_core::{Profile, quantity::Length};
    /// use asperity_roughness::generate::Achieved;
    /// let heights = (0..100).map(|i| if i % 2 == 0 { 1e-6 } else { -1e-6 }).collect();
    /// let achieved = Achieved::from_profile(&Profile::new(Length::from_si(1e-6), heights)?);
    /// assert!((achieved.rq.si() - 1e-6).abs() < 1e-18);
    /// assert!((achieved.rku.unwrap() - 1.0).abs() < 1e-12);
    /// # Ok::<(), asperity_core::DomainError>(())
    /// ```
    pub fn from_profile(profile: &Profile) -> Self {
        let z = profile.heights();
        let n = z.len() as f64;
        let mean = z.iter().sum::<f64>() / n;
        let moment = |power: i32| z.iter().map(|z| (z - mean).powi(power)).sum::<f64>() / n;
        let rq = moment(2).sqrt();
        let shape = |power: i32| Some(moment(power) / rq.powi(power)).filter(|v| v.is_finite());
        let (low, high) = asperity_core::numerics::extremes(z);
        let slope = spectral::moments(profile)
            .ok()
            .map(|moments| moments.m2.sqrt());
        Self {
            ra: Length::from_si(z.iter().map(|z| (z - mean).abs()).sum::<f64>() / n),
            rq: Length::from_si(rq),
            rsk: shape(3),
            rku: shape(4),
            rt: Length::from_si(high - low),
            rdq: slope,
            spectrum_error: None,
            iterations: None,
        }
    }
}
