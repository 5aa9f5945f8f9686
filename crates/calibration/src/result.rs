//! A calibration as data.

use asperity::message::Warning;
use serde::{Deserialize, Serialize};

/// Version of the structure of `calibration.json`.
pub const SCHEMA_VERSION: u32 = 1;

/// Whether a design finds a parameter.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Serialize, Deserialize)]
#[serde(rename_all = "kebab-case")]
pub enum Verdict {
    /// Its points tell it to better than half the prior.
    Found,
    /// Its points and the prior have about the same say.
    Partly,
    /// The prior has the say; the parameter keeps its default and its range.
    NotFound,
}

impl Verdict {
    /// In words.
    #[must_use]
    pub const fn text(self) -> &'static str {
        match self {
            Self::Found => "found",
            Self::Partly => "partly, held by its prior",
            Self::NotFound => "not found",
        }
    }
}

/// What a design can find, told before the fit.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
#[non_exhaustive]
pub struct Identifiability {
    /// Distinct operating points.
    pub points: usize,
    /// Temperatures \[°C\], those within 5 K as one.
    pub temperatures_c: Vec<f64>,
    /// Smallest and largest Λ* of the points, each the median over the path.
    pub lambda_star: Option<[f64; 2]>,
    /// The parameters.
    pub parameters: Vec<IdentifiedParameter>,
    /// The two parameters that are told apart worst, and their correlation.
    pub worst_correlation: Option<(String, String, f64)>,
    /// The further measurements that would help most, the best first.
    pub helpful: Vec<HelpfulPoint>,
}

/// How well a design finds a parameter.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
#[non_exhaustive]
pub struct IdentifiedParameter {
    /// Key in the table `calibration` of a case.
    pub key: String,
    /// Name in words.
    pub name: String,
    /// Standard deviation of its logarithm by the points, its own prior left out; none where they do not tell it.
    pub deviation: Option<f64>,
    /// Standard deviation of the prior.
    pub prior: f64,
    /// Verdict.
    pub verdict: Verdict,
}

/// A further measurement, and what it would make of each standard deviation.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
#[non_exhaustive]
pub struct HelpfulPoint {
    /// Torque \[N m\].
    pub torque_nm: f64,
    /// Speed \[1/min\].
    pub speed_rpm: f64,
    /// Temperature \[°C\].
    pub temperature_c: f64,
    /// Name of the parameter that gains most.
    pub gains_most: String,
    /// Standard deviation of its logarithm without and with the point, priors included.
    pub deviation: [f64; 2],
}

/// A calibration.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
#[non_exhaustive]
pub struct Calibration {
    /// Version of this structure.
    pub schema_version: u32,
    /// The program and its version.
    pub program: String,
    /// Title of the case.
    pub title: String,
    /// Name of the table.
    pub table: String,
    /// Its SHA-256.
    pub sha256: String,
    /// Whether the table says that its losses are simulated.
    pub is_simulated: bool,
    /// Assemblies in the table.
    pub assemblies: Vec<String>,
    /// What the design can find.
    pub identifiability: Identifiability,
    /// The fits before the last one.
    pub stages: Vec<StageRow>,
    /// The parameters with their bands.
    pub parameters: Vec<FittedParameter>,
    /// Correlations of their logarithms.
    pub correlations: Vec<Vec<f64>>,
    /// Nuisance terms.
    pub nuisance: Vec<NuisanceRow>,
    /// Sum of the squared residuals of the measurements in standard deviations.
    pub chi_squared: f64,
    /// Measurements less what the fit took from them.
    pub freedom: f64,
    /// Every temperature predicted from the others.
    pub held_out: Vec<HeldOut>,
    /// Evidence that the fit is that of the model.
    pub evidence: Evidence,
    /// The measurements beside the fit.
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
    /// Measurements that it took.
    pub points: usize,
    /// Names and values in SI units of the parameters that it moved.
    pub values: Vec<(String, f64)>,
}

/// A parameter with its bands, values in SI units.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
#[non_exhaustive]
pub struct FittedParameter {
    /// Key in the table `calibration` of a case.
    pub key: String,
    /// Name in words.
    pub name: String,
    /// Value.
    pub value: f64,
    /// 95 % band that goes into the block.
    pub band: [f64; 2],
    /// 95 % band by the profile likelihood.
    pub profile_band: [f64; 2],
    /// Whether an end of that was not reached.
    pub is_open: [bool; 2],
    /// Values and the rise of the sum of squares there.
    pub profile: Vec<[f64; 2]>,
    /// Middle 95 % of the bootstrap over assemblies; none with a single one.
    pub bootstrap: Option<[f64; 2]>,
    /// Default of the case.
    pub default: f64,
    /// Range of a case without calibration.
    pub default_range: [f64; 2],
    /// Standard deviation of its logarithm, prior included.
    pub deviation: f64,
    /// Whether the design finds it; what it does not find is left out of the block.
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

/// A temperature that was predicted from the others.
#[derive(Debug, Clone, Copy, PartialEq, Serialize, Deserialize)]
#[non_exhaustive]
pub struct HeldOut {
    /// Mean temperature \[°C\].
    pub temperature_c: f64,
    /// Measurements.
    pub points: usize,
    /// Mean of ln(measured/predicted).
    pub mean_error: f64,
    /// Root of its mean square.
    pub rms_error: f64,
    /// What measurements and parameters lead one to expect of that.
    pub expected_error: f64,
}

/// Evidence of a fit.
#[derive(Debug, Clone, Copy, PartialEq, Serialize, Deserialize)]
#[non_exhaustive]
pub struct Evidence {
    /// Response surfaces made one after the other.
    pub rounds: usize,
    /// Evaluations of the model.
    pub evaluations: usize,
    /// Largest difference of surface and model at the fit, in logarithms.
    pub largest_surface_error: f64,
    /// The same in standard deviations of the measurement.
    pub largest_surface_error_sigma: f64,
    /// Samples of the bootstrap.
    pub bootstrap_samples: usize,
}

/// A measurement beside the fit.
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
    /// ln(measured/fitted) in standard deviations.
    pub residual_sigma: f64,
    /// Λ* at the default parameters, median over the path.
    pub lambda_star: Option<f64>,
    /// Share of the load on the boundary layer, at the default parameters.
    pub boundary_share: f64,
}
