//! Further evaluations of a profile: line of Rk by secant, correlation, summits, spectrum, Hurst exponent, and the
//! ambiguity of the parameters.

use asperity_core::quantity::Length;
use asperity_roughness::RoughnessError;
use asperity_roughness::ambiguity::{Ambiguity, ambiguity};
use asperity_roughness::autocorrelation::{self, AutocorrelationLengths};
use asperity_roughness::hurst::{HurstFit, hurst_fit};
use asperity_roughness::material_ratio::{Line, RkParameters, rk_parameters_with};
use asperity_roughness::spectral::{PowerSpectrum, power_spectrum};
use asperity_roughness::summits::{SummitStatistics, summit_statistics};

use super::evaluated::EvaluatedFile;
use super::levels::Levels;
use crate::args::{ProfileInfoArgs, Wavelengths};

/// Details of a profile; `None` if a flat or short profile does not have them.
pub struct Details {
    /// The Rk family with the secant line.
    pub secant: Option<RkParameters>,
    /// Correlation lengths.
    pub correlation: Option<AutocorrelationLengths>,
    /// Half width over which the curvatures of summits are evaluated.
    pub window: Length,
    /// The summits.
    pub summits: Option<SummitStatistics>,
    /// Power spectral density.
    pub spectrum: Option<PowerSpectrum>,
    /// Wavelengths of the Hurst fit.
    pub wavelengths: Wavelengths,
    /// The Hurst fit, or its error.
    pub hurst: Result<HurstFit, RoughnessError>,
    /// Requested material ratios and heights.
    pub levels: Levels,
    /// The ranges of the parameters.
    pub ambiguity: Vec<Ambiguity>,
}

impl Details {
    /// Evaluates the details requested in `args`; the Hurst exponent by default over the wavelengths that the filters
    /// leave.
    pub fn new(evaluated: &EvaluatedFile, args: &ProfileInfoArgs) -> Self {
        let (plan, rough) = (&evaluated.plan, &evaluated.parts.roughness.profile);
        let window = plan.recipe.lambda_s.unwrap_or_default();
        let window = Length::from_si(window.si().max(rough.spacing().si()));
        let wavelengths = args.hurst.unwrap_or_else(|| usual_wavelengths(evaluated));
        let (recipe, filter) = (&plan.recipe, plan.filter);
        let open = ambiguity(evaluated.trace(), rough, recipe, filter, plan.sections);
        Self {
            secant: rk_parameters_with(rough.heights(), Line::Secant).ok(),
            correlation: autocorrelation::lengths(rough).ok(),
            window,
            summits: summit_statistics(rough, window).ok(),
            spectrum: power_spectrum(rough).ok(),
            hurst: hurst_fit(rough, wavelengths.longest, wavelengths.shortest),
            wavelengths,
            levels: Levels::new(evaluated, args),
            ambiguity: open.unwrap_or_default(),
        }
    }

    /// Wavelength that divides the power of the profile into halves.
    pub fn median_wavelength(&self) -> Option<Length> {
        let spectrum = self.spectrum.as_ref()?;
        let half = 0.5 * spectrum.density.iter().sum::<f64>();
        let mut power = 0.0;
        let k = spectrum.density.iter().position(|density| {
            power += density;
            power >= half
        })?;
        (k > 0).then(|| Length::from_si(1.0 / (k as f64 * spectrum.frequency_step)))
    }
}

/// Wavelengths whose density the filters change by less than about a tenth: from λc/3, where the Gaussian filter
/// transmits 99.8 % of a wave, to 5 λs, where it transmits 97 %; without filters, a quarter of the length to five
/// points.
fn usual_wavelengths(evaluated: &EvaluatedFile) -> Wavelengths {
    const LONG: f64 = 3.0;
    const SHORT: f64 = 5.0;
    const UNFILTERED: f64 = 4.0;
    let (recipe, rough) = (&evaluated.plan.recipe, &evaluated.parts.roughness.profile);
    let quarter = rough.length() / UNFILTERED;
    let short = recipe.lambda_s.unwrap_or_default().si();
    Wavelengths {
        longest: recipe.lambda_c.map_or(quarter, |lambda_c| lambda_c / LONG),
        shortest: Length::from_si(SHORT * short.max(rough.spacing().si())),
    }
}
