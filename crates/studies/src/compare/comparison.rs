//! Several finishes run on one case, and what sets them apart.

use std::path::Path;

use asperity::Error;
use asperity::case::LoadedCase;
use asperity::kept_fields::KeptFields;
use asperity::pipeline::{self, Progress};
use asperity::result::{OffsetRow, Outcome};
use serde::Serialize;

use super::statistics::{Interval, paired_interval, rank_correlation};
use super::windows::{self, Value, WindowRoughness};

/// Confidence of every interval.
pub const CONFIDENCE: f64 = 0.95;

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
    /// Names of the files of its traces, and their SHA-256.
    pub files: Vec<[String; 2]>,
    /// Mean efficiency.
    pub efficiency: f64,
    /// Mean loss \[W\] with its interval.
    pub loss_w: Interval,
    /// Loss less that of the first finish \[W\], offset by offset; none for the first.
    pub difference_w: Option<Interval>,
    /// Share of the path in mixed lubrication.
    pub mixed_share: f64,
    /// Codes and texts of the warnings.
    pub warnings: Vec<String>,
    /// Losses at each offset.
    #[serde(skip)]
    pub offsets: Vec<OffsetRow>,
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
        let outcome = pipeline::run_keeping(&finish.case, &KeptFields::Highest, &|_, _| {})?;
        title.clone_from(&outcome.result.title);
        power_in_w = outcome.result.summary.power_in_w;
        results.push(finish_result(finish, outcome, results.first())?);
        progress(results.len(), finishes.len());
    }
    let pooled = |finish: &FinishResult| finish.roughness.len().min(finish.offsets.len());
    Ok(Comparison {
        program: concat!("asperity ", env!("CARGO_PKG_VERSION")).to_owned(),
        title,
        power_in_w,
        correlations: correlations(&results),
        windows: results.iter().map(pooled).sum(),
        finishes: results,
    })
}

fn finish_result(
    finish: &Finish,
    outcome: Outcome,
    first: Option<&FinishResult>,
) -> Result<FinishResult, Error> {
    let roughness =
        windows::roughness(&finish.case).map_err(|error| Error::Whole(Box::new(error)))?;
    let losses: Vec<f64> = outcome.offsets.iter().map(|row| row.loss_w).collect();
    let difference_w = first.map(|first| {
        let pairs = first.offsets.iter().zip(&losses);
        let differences: Vec<f64> = pairs.map(|(base, loss)| loss - base.loss_w).collect();
        paired_interval(&differences, CONFIDENCE)
    });
    let result = outcome.result;
    // The folder of a trace is nobody's business; its sum tells which file it was.
    let named = result.flanks.iter().filter_map(|flank| {
        let file = Path::new(flank.file.as_deref()?).file_name()?;
        Some([file.to_string_lossy().into_owned(), flank.sha256.clone()?])
    });
    Ok(FinishResult {
        name: finish.name.clone(),
        files: named.collect(),
        efficiency: result.summary.efficiency,
        loss_w: paired_interval(&losses, CONFIDENCE),
        difference_w,
        mixed_share: result.summary.mixed_share,
        warnings: result.warnings.iter().map(ToString::to_string).collect(),
        offsets: outcome.offsets,
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
