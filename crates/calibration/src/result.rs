//! Data of a calibration.

use asperity::message::Warning;
use asperity_core::{Estimate, EstimateKeys, estimate_keys};
use serde::{Deserialize, Serialize};

/// Identification of a parameter by a design.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Serialize, Deserialize)]
#[serde(rename_all = "kebab-case")]
pub enum Verdict {
    /// The points determine it to better than half its prior, and narrow its range of a case without calibration.
    Identified,
    /// Points and prior have similar weight, or the band is not narrower than that range.
    Partly,
    /// The prior dominates; the parameter keeps its default and its range.
    NotIdentified,
}

impl Verdict {
    /// In words.
    #[must_use]
    pub const fn text(self) -> &'static str {
        match self {
            Self::Identified => "identified",
            Self::Partly => "identified in part",
            Self::NotIdentified => "not identified",
        }
    }
}

/// Identifiability of the parameters, reported before the fit.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
#[non_exhaustive]
pub struct Identifiability {
    /// Distinct operating points.
    pub points: usize,
    /// Temperatures \[°C\], grouped within 5 K.
    pub temperatures_c: Vec<f64>,
    /// Smallest and largest Λ* of the points, as median over the path.
    pub lambda_star: Option<[f64; 2]>,
    /// The parameters.
    pub parameters: Vec<IdentifiedParameter>,
    /// The two parameters that are hardest to separate, and their correlation.
    pub worst_correlation: Option<(String, String, f64)>,
    /// Most useful further measurements, best first.
    pub helpful: Vec<HelpfulPoint>,
}

impl Identifiability {
    /// The further measurement that narrows its parameter most, if that is noticeable.
    #[must_use]
    pub fn next(&self) -> Option<&HelpfulPoint> {
        /// Least gain that is worth a measurement.
        const LEAST: f64 = 0.1;
        let left = |point: &HelpfulPoint| point.deviation[1] / point.deviation[0];
        let points = self.helpful.iter();
        let best = points.min_by(|a, b| left(a).total_cmp(&left(b)));
        best.filter(|best| left(best) <= 1.0 - LEAST)
    }
}

/// Identification of one parameter.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
#[non_exhaustive]
pub struct IdentifiedParameter {
    /// Key in the table `calibration` of a case.
    pub key: String,
    /// Name in words.
    pub name: String,
    /// Standard deviation of its logarithm by the points, without its own prior; `None` if they do not determine it.
    pub deviation: Option<f64>,
    /// Standard deviation of the prior of the fit.
    pub prior: f64,
    /// Verdict.
    pub verdict: Verdict,
}

/// Further measurement and its gain.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
#[non_exhaustive]
pub struct HelpfulPoint {
    /// Torque \[N m\].
    pub torque_nm: f64,
    /// Speed \[1/min\].
    pub speed_rpm: f64,
    /// Temperature \[°C\].
    pub temperature_c: f64,
    /// Name of the parameter with the largest gain.
    pub gains_most: String,
    /// Standard deviation of its logarithm by the points, without and with this one; the prior where they do not determine it.
    pub deviation: [f64; 2],
}

/// Result of a calibration.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
#[non_exhaustive]
pub struct Calibration {
    /// Version of this structure.
    pub schema_version: u32,
    /// Program and version.
    pub program: String,
    /// Title of the case.
    pub title: String,
    /// Name of the table.
    pub table: String,
    /// Its SHA-256.
    pub sha256: String,
    /// Whether the losses of the table are simulated.
    pub is_simulated: bool,
    /// Assemblies in the table.
    pub assemblies: Vec<String>,
    /// Identifiability of the parameters.
    pub identifiability: Identifiability,
    /// Stages before the last fit.
    pub stages: Vec<StageRow>,
    /// The parameters with their bands.
    pub parameters: Vec<FittedParameter>,
    /// Correlations of their logarithms.
    pub correlations: Vec<Vec<f64>>,
    /// Nuisance terms.
    pub nuisance: Vec<NuisanceRow>,
    /// Sum of the squared residuals of measurements and nuisance terms in standard deviations.
    pub chi_squared: f64,
    /// Measurements minus fitted parameters.
    pub freedom: usize,
    /// √(χ²/ν): the scatter relative to the stated errors. All bands are widened by a ratio above 1.
    pub birge_ratio: f64,
    /// Cross-validation: every temperature predicted from the others.
    pub held_out: Vec<HeldOut>,
    /// Accuracy of the response surfaces.
    pub evidence: Evidence,
    /// Measurements with their fitted values.
    pub points: Vec<FittedPoint>,
    /// Warnings.
    pub warnings: Vec<Warning>,
    /// The table `calibration` for a case.
    pub block: String,
}

/// A stage of the fit.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
#[non_exhaustive]
pub struct StageRow {
    /// Its purpose.
    pub name: String,
    /// Number of measurements.
    pub points: usize,
    /// Names and values in SI units of the fitted parameters.
    pub values: Vec<(String, f64)>,
}

estimate_keys! {
    pub(crate) Ranged: "value" "range";
    Default: "default" "default_range";
}

/// A parameter with its bands, values in SI units.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
#[non_exhaustive]
pub struct FittedParameter {
    /// Key in the table `calibration` of a case.
    pub key: String,
    /// Name in words.
    pub name: String,
    /// Value with its 5 % and 95 % quantile, as printed.
    #[serde(flatten, with = "Ranged")]
    pub fitted: Estimate,
    /// 2.5 % and 97.5 % quantile, as the block states them.
    pub band: [f64; 2],
    /// 5 % and 95 % quantile by the profile likelihood.
    pub profile_range: [f64; 2],
    /// Whether an end of the band was not reached by the profile likelihood.
    pub is_open: [bool; 2],
    /// Values with the rise of the sum of squares over the square of the widening.
    pub profile: Vec<[f64; 2]>,
    /// 5 % and 95 % quantile of the bootstrap over assemblies; `None` with a single assembly.
    pub bootstrap: Option<[f64; 2]>,
    /// Default of the case with the range of a case without calibration.
    #[serde(flatten, with = "Default")]
    pub default: Estimate,
    /// Standard deviation of its logarithm, prior included, widened by the Birge ratio.
    pub deviation: f64,
    /// Identification by the points with their errors widened by the Birge ratio; a parameter that is not identified is omitted from the block.
    pub verdict: Verdict,
}

/// A nuisance term.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
#[non_exhaustive]
pub struct NuisanceRow {
    /// Name.
    pub name: String,
    /// Value.
    pub value: f64,
    /// Standard deviation after the fit.
    pub deviation: f64,
    /// Standard deviation of its prior.
    pub prior: f64,
    /// Unit.
    pub unit: String,
}

/// Prediction of one temperature from the others.
#[derive(Debug, Clone, Copy, PartialEq, Serialize, Deserialize)]
#[non_exhaustive]
pub struct HeldOut {
    /// Mean temperature \[°C\].
    pub temperature_c: f64,
    /// Measurements.
    pub points: usize,
    /// Mean of ln(measured/predicted).
    pub mean_error: f64,
    /// Root mean square of ln(measured/predicted).
    pub rms_error: f64,
    /// Expected root mean square from the uncertainty of measurements and parameters, widened by the Birge ratio.
    pub expected_error: f64,
}

/// Accuracy of the response surfaces of a fit.
#[derive(Debug, Clone, Copy, PartialEq, Serialize, Deserialize)]
#[non_exhaustive]
pub struct Evidence {
    /// Number of rounds of response surfaces.
    pub rounds: usize,
    /// Number of evaluations of the model.
    pub evaluations: usize,
    /// Largest difference between surface and model at the fit, in logarithms.
    pub largest_surface_error: f64,
    /// The same difference in standard deviations of the measurement.
    pub largest_surface_error_sigma: f64,
    /// Number of bootstrap samples.
    pub bootstrap_samples: usize,
}

/// Measurement with its fitted value.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
#[non_exhaustive]
pub struct FittedPoint {
    /// Line in the table.
    pub line: usize,
    /// Assembly.
    pub assembly: String,
    /// Torque \[N m\].
    pub torque_nm: f64,
    /// Speed \[1/min\].
    pub speed_rpm: f64,
    /// Temperature \[°C\].
    pub temperature_c: f64,
    /// Measured loss \[W\].
    pub measured_w: f64,
    /// Its standard deviation \[W\].
    pub sigma_w: f64,
    /// Fitted loss \[W\], nuisance terms included.
    pub fitted_w: f64,
    /// Loss of the mesh by the model with the constants before \[W\].
    pub default_w: f64,
    /// Loss of the mesh by the model with the constants of the block \[W\].
    pub calibrated_w: f64,
    /// ln(measured/fitted) in standard deviations.
    pub residual_sigma: f64,
    /// Λ* at the default parameters, median over the path.
    pub lambda_star: Option<f64>,
    /// Share of the load on the boundary layer, at the default parameters.
    pub boundary_share: f64,
}
