//! Several finishes run on one case, and what sets them apart.

use asperity::Error;
use asperity::Run;
use asperity::case::LoadedCase;
use asperity::pipeline::KeptFields;
use asperity::pipeline::Progress;
use asperity::result::loss_band::LossBand;
use asperity::result::{GearboxReport, OffsetRow, Outcome, Scope};
use asperity::uncertainty::{self, DrawnLosses, PairedDifference};
use serde::Serialize;

use super::statistics::rank_correlation;
use super::windows::{self, Value, WindowRoughness};

/// A finish to compare: its name and the case with its traces.
#[derive(Debug, Clone)]
pub struct Finish {
    /// Its name.
    pub name: String,
    /// The case.
    pub case: LoadedCase,
}

/// Results of several finishes; the first is the one the others are compared with.
#[derive(Debug, Clone, PartialEq, Serialize)]
pub struct Comparison {
    /// The program and its version.
    pub program: String,
    /// The case's title.
    pub title: String,
    /// What the comparison covers; efficiencies, losses and differences are of the mesh.
    pub scope: Scope,
    /// Power into the mesh \[W\].
    pub power_in_w: f64,
    /// The finishes.
    pub finishes: Vec<FinishResult>,
    /// Rank correlation of roughness with the computed loss, the closest first; none from fewer than 5 windows
    /// of a finish.
    pub correlations: Vec<Correlation>,
    /// Offsets and finishes pooled in the correlations.
    pub windows: usize,
}

/// Result of a finish.
#[derive(Debug, Clone, PartialEq, Serialize)]
pub struct FinishResult {
    /// Its name.
    pub name: String,
    /// Names of the files that it read, and their SHA-256.
    pub files: Vec<[String; 2]>,
    /// Mean efficiency.
    pub efficiency: f64,
    /// Power into the mesh \[W\].
    pub power_in_w: f64,
    /// Mean loss with every parameter at its default \[W\].
    pub loss_w: f64,
    /// 5 % and 95 % quantiles of the loss \[W\].
    pub quantiles_w: [f64; 2],
    /// The band with its parts; none where the model has none, and the quantiles are of the sampling alone.
    pub band: Option<LossBand>,
    /// Loss minus that of the first finish by the same draws; none for the first.
    pub difference: Option<PairedDifference>,
    /// The gearbox around the mesh, where the case states one; the same parts for every finish.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub gearbox: Option<GearboxReport>,
    /// Share of the path in mixed lubrication.
    pub mixed_share: f64,
    /// Codes and texts of the warnings.
    pub warnings: Vec<String>,
    /// Losses at each offset.
    #[serde(skip)]
    pub offsets: Vec<OffsetRow>,
    /// Losses at each offset of each draw.
    #[serde(skip)]
    pub(crate) drawn: DrawnLosses,
    /// Roughness under the contact at each offset.
    #[serde(skip)]
    pub(crate) roughness: Vec<WindowRoughness>,
}

/// Rank correlation of a roughness parameter with the loss that the model computes from it.
#[derive(Debug, Clone, PartialEq, Serialize)]
pub struct Correlation {
    /// Name of the parameter.
    pub parameter: &'static str,
    /// Rank correlation of Spearman with the loss: 1 when the loss always grows with it.
    pub with_loss: f64,
    /// The same among the windows of one finish, mean over the finishes.
    pub within_finishes: f64,
}

/// Runs every finish and compares them; the first is what the others are compared with.
///
/// # Errors
/// When a finish has no solution.
pub fn compare(finishes: &[Finish], progress: Progress<'_>) -> Result<Comparison, Error> {
    let mut results: Vec<FinishResult> = Vec::with_capacity(finishes.len());
    let (mut title, mut power_in_w) = (String::new(), 0.0);
    for finish in finishes {
        let kept = KeptFields::Highest;
        let (outcome, drawn) = Run::new(&finish.case).fields(&kept).draw()?;
        title.clone_from(&outcome.result.title);
        power_in_w = outcome.result.summary.power_in_w;
        results.push(finish_result(finish, outcome, drawn, results.first())?);
        progress(results.len(), finishes.len());
    }
    let pooled = |finish: &FinishResult| finish.roughness.len().min(finish.offsets.len());
    Ok(Comparison {
        program: concat!("asperity ", env!("CARGO_PKG_VERSION")).to_owned(),
        title,
        scope: match results.iter().any(|finish| finish.gearbox.is_some()) {
            true => Scope::Gearbox,
            false => Scope::Mesh,
        },
        power_in_w,
        correlations: correlations(&results),
        windows: results.iter().map(pooled).sum(),
        finishes: results,
    })
}

/// Names of the files that `case` read, and their SHA-256. The folder of a file is nobody's business; its sum tells
/// which file it was.
pub(crate) fn files(case: &LoadedCase) -> Vec<[String; 2]> {
    let read = case.files_read().into_iter();
    let named = read.filter_map(|(path, sum)| {
        let name = path.file_name()?.to_string_lossy().into_owned();
        Some([name, sum])
    });
    named.collect()
}

fn finish_result(
    finish: &Finish,
    outcome: Outcome,
    drawn: DrawnLosses,
    first: Option<&FinishResult>,
) -> Result<FinishResult, Error> {
    let roughness =
        windows::roughness(&finish.case).map_err(|error| Error::Whole(Box::new(error)))?;
    let difference = first.map(|first| uncertainty::difference(&first.drawn, &drawn));
    let result = outcome.result;
    Ok(FinishResult {
        name: finish.name.clone(),
        files: files(&finish.case),
        efficiency: result.summary.efficiency,
        power_in_w: result.summary.power_in_w,
        loss_w: result.summary.loss_w,
        quantiles_w: drawn.quantiles(),
        band: result.band,
        difference,
        gearbox: result.gearbox,
        mixed_share: result.summary.mixed_share,
        warnings: result.warnings.iter().map(ToString::to_string).collect(),
        offsets: outcome.offsets,
        drawn,
        roughness,
    })
}

/// Fewest pairs for which a correlation is given.
const FEWEST_PAIRS: usize = 5;

fn correlations(finishes: &[FinishResult]) -> Vec<Correlation> {
    let few =
        |finish: &FinishResult| finish.roughness.len().min(finish.offsets.len()) < FEWEST_PAIRS;
    if finishes.iter().any(few) {
        return Vec::new();
    }
    let pairs = |finish: &FinishResult, of: Value| -> Vec<[f64; 2]> {
        let rows = finish.roughness.iter().zip(&finish.offsets);
        rows.map(|(window, row)| [of(window), row.loss_w]).collect()
    };
    let mut found: Vec<Correlation> = windows::PARAMETERS
        .iter()
        .map(|&(parameter, of)| {
            let all: Vec<[f64; 2]> = finishes
                .iter()
                .flat_map(|finish| pairs(finish, of))
                .collect();
            let within = finishes
                .iter()
                .map(|finish| rank_correlation(&pairs(finish, of)));
            Correlation {
                parameter,
                with_loss: rank_correlation(&all),
                within_finishes: within.sum::<f64>() / finishes.len() as f64,
            }
        })
        .collect();
    found.sort_by(|a, b| b.with_loss.abs().total_cmp(&a.with_loss.abs()));
    found
}
