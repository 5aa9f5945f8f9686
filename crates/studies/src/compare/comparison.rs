//! Comparison of several finishes on one case.

use asperity::Error;
use asperity::Run;
use asperity::case::LoadedCase;
use asperity::flanks::Surfaces;
use asperity::pipeline::KeptFields;
use asperity::pipeline::Progress;
use asperity::result::loss_band::Uncertainty;
use asperity::result::{GearboxReport, OffsetRow, Outcome, Regime, RunResult, Scope};
use asperity::uncertainty::{self, PairedDifference, Predictive};
use asperity_report::tables::FlankTables;
use serde::Serialize;

use super::statistics::rank_correlation;
use super::windows::{self, Value, WindowRoughness};

/// Finish to compare: name, and case with its traces, a pair of gears or a gear train.
#[derive(Debug, Clone)]
pub struct Finish<C = LoadedCase> {
    /// Name.
    pub name: String,
    /// Case.
    pub case: C,
}

/// Results of several finishes; the first is the reference.
#[derive(Debug, Clone, PartialEq, Serialize)]
#[non_exhaustive]
pub struct Comparison {
    /// Program and version.
    pub program: String,
    /// Title of the case.
    pub title: String,
    /// Scope; efficiencies, losses and differences are always of the mesh.
    pub scope: Scope,
    /// Power into the mesh \[W\].
    pub power_in_w: f64,
    /// The finishes.
    pub finishes: Vec<FinishResult>,
    /// Rank correlations of roughness with the computed loss, strongest first; empty of fewer than three finishes, and if
    /// a finish has fewer than 5 windows.
    pub correlations: Vec<Correlation>,
    /// Number of windows in the correlations: offsets of all finishes.
    pub windows: usize,
}

/// Result of a finish.
#[derive(Debug, Clone, PartialEq, Serialize)]
#[non_exhaustive]
pub struct FinishResult {
    /// Name.
    pub name: String,
    /// Names and SHA-256 of the files that it read.
    pub files: Vec<[String; 2]>,
    /// Mean efficiency.
    pub efficiency: f64,
    /// Power into the mesh \[W\].
    pub power_in_w: f64,
    /// Mean loss with every constant at its median \[W\].
    pub loss_w: f64,
    /// The uncertainty of the loss; `None` if the model has none.
    pub uncertainty: Option<Uncertainty>,
    /// Loss minus the loss of the first finish with the same draws; `None` for the first, and if the model has no
    /// uncertainty.
    pub difference: Option<PairedDifference>,
    /// Losses of the gearbox, if the case states them; the same parts for every finish.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub gearbox: Option<GearboxReport>,
    /// Share of the path in mixed lubrication.
    pub mixed_share: f64,
    /// Lubrication regime of the mesh.
    pub regime: Regime,
    /// Codes and texts of the warnings.
    pub warnings: Vec<String>,
    /// Losses by offset.
    #[serde(skip)]
    pub offsets: Vec<OffsetRow>,
    /// Draws of the loss.
    #[serde(skip)]
    pub(crate) predictive: Option<Predictive>,
    /// The flanks.
    #[serde(skip)]
    pub(crate) surfaces: Surfaces,
    /// The result of the run.
    #[serde(skip)]
    pub(crate) result: RunResult,
    /// Traces and spectra of pinion and wheel; `None` for a flank without a trace.
    #[serde(skip)]
    pub(crate) tables: [Option<FlankTables>; 2],
    /// Roughness under the contact by offset.
    #[serde(skip)]
    pub(crate) roughness: Vec<WindowRoughness>,
}

/// Rank correlation of a roughness parameter with the computed loss.
#[derive(Debug, Clone, PartialEq, Serialize)]
#[non_exhaustive]
pub struct Correlation {
    /// Name of the parameter.
    pub parameter: &'static str,
    /// Spearman's rank correlation with the loss: 1 if the loss always increases with the parameter.
    pub with_loss: f64,
    /// Rank correlation within one finish, mean over the finishes.
    pub within_finishes: f64,
}

/// Runs all finishes and compares them with the first. Where the case states no offsets, all have those of the finish that
/// needs most.
///
/// # Errors
/// When a finish has no solution.
pub fn compare(finishes: &[Finish], progress: Progress<'_>) -> Result<Comparison, Error> {
    let run = |case: &LoadedCase| Run::new(case).fields(&KeptFields::Highest).draw();
    let mut runs = Vec::with_capacity(finishes.len());
    for finish in finishes {
        runs.push(run(&finish.case)?);
        progress(runs.len(), finishes.len());
    }
    let of_each_pair =
        |finish: &Finish, rows: &[OffsetRow]| rows.len() / finish.case.surfaces.pairs();
    let numbers = finishes.iter().zip(&runs);
    let most = numbers.map(|(finish, (outcome, _))| of_each_pair(finish, &outcome.offsets));
    let most = most.max().unwrap_or(0);
    let mut results: Vec<FinishResult> = Vec::with_capacity(finishes.len());
    let (mut title, mut power_in_w) = (String::new(), 0.0);
    for (finish, (mut outcome, mut predictive)) in finishes.iter().zip(runs) {
        let is_chosen = finish.case.case.input.model.offsets.is_none();
        if is_chosen && of_each_pair(finish, &outcome.offsets) < most {
            let more = (finish.case).with(|input| input.model.offsets = Some(most))?;
            (outcome, predictive) = run(&more)?;
        }
        title.clone_from(&outcome.result.title);
        power_in_w = outcome.result.summary.power_in_w;
        results.push(finish_result(finish, outcome, predictive, results.first())?);
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

/// Names and SHA-256 of the files that `case` read. Folders are omitted, since they may be private; the hash identifies
/// the file.
pub(crate) fn files(case: &LoadedCase) -> Vec<[String; 2]> {
    let read = case.files_read().into_iter();
    let names_and_sums = read.filter_map(|(path, sum)| {
        let name = path.file_name()?.to_string_lossy().into_owned();
        Some([name, sum])
    });
    names_and_sums.collect()
}

fn finish_result(
    finish: &Finish,
    outcome: Outcome,
    predictive: Option<Predictive>,
    first: Option<&FinishResult>,
) -> Result<FinishResult, Error> {
    let roughness = windows::roughness(&finish.case, outcome.offsets.len())
        .map_err(|error| Error::Whole(Box::new(error)))?;
    let flank = |body: usize| {
        FlankTables::new(&outcome.result.flanks[body], outcome.traces[body].as_ref())
            .map_err(|error| Error::Whole(Box::new(error.into())))
    };
    let tables = [flank(0)?, flank(1)?];
    let result = outcome.result;
    let difference = first.and_then(|first| {
        Some(uncertainty::difference(
            (first.predictive.as_ref()?, first.uncertainty.as_ref()?),
            (predictive.as_ref()?, result.uncertainty.as_ref()?),
            first.surfaces.has_flanks_of(&finish.case.surfaces),
        ))
    });
    Ok(FinishResult {
        name: finish.name.clone(),
        files: files(&finish.case),
        efficiency: result.summary.efficiency,
        power_in_w: result.summary.power_in_w,
        loss_w: result.summary.loss_w,
        uncertainty: result.uncertainty.clone(),
        difference,
        gearbox: result.gearbox.clone(),
        mixed_share: result.summary.mixed_share,
        regime: result.summary.regime(),
        warnings: result.warnings.iter().map(ToString::to_string).collect(),
        offsets: outcome.offsets,
        predictive,
        surfaces: finish.case.surfaces.clone(),
        result,
        tables,
        roughness,
    })
}

/// Fewest pairs of a correlation.
const FEWEST_PAIRS: usize = 5;
/// Fewest finishes of a correlation: any parameter that differs between two finishes orders them.
const FEWEST_FINISHES: usize = 3;

fn correlations(finishes: &[FinishResult]) -> Vec<Correlation> {
    let few =
        |finish: &FinishResult| finish.roughness.len().min(finish.offsets.len()) < FEWEST_PAIRS;
    if finishes.len() < FEWEST_FINISHES || finishes.iter().any(few) {
        return Vec::new();
    }
    let pairs = |finish: &FinishResult, of: Value| -> Vec<[f64; 2]> {
        let rows = finish.roughness.iter().zip(&finish.offsets);
        rows.map(|(window, row)| [of(window), row.loss_w]).collect()
    };
    let mut correlations: Vec<Correlation> = windows::PARAMETERS
        .iter()
        .map(|&(parameter, of)| {
            let pooled: Vec<[f64; 2]> = finishes
                .iter()
                .flat_map(|finish| pairs(finish, of))
                .collect();
            let within = finishes
                .iter()
                .map(|finish| rank_correlation(&pairs(finish, of)));
            Correlation {
                parameter,
                with_loss: rank_correlation(&pooled),
                within_finishes: within.sum::<f64>() / finishes.len() as f64,
            }
        })
        .collect();
    correlations.sort_by(|a, b| b.with_loss.abs().total_cmp(&a.with_loss.abs()));
    correlations
}
