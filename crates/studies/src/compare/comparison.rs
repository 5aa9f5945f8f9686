//! Comparison of several finishes on one case.

use asperity::Contacts;
use asperity::case::CaseInput;
use asperity::case::LoadedCase;
use asperity::case::train::Train;
use asperity::message::outside_codes;
use asperity::oil::{BaseOil, Lubricant};
use asperity::pipeline::{Kept, Progress};
use asperity::result::loss_band::Uncertainty;
use asperity::result::{GearboxReport, MeshOutcome, OffsetRow, Regime, RunResult, Scope};
use asperity::train::{MeshRow, Outcome};
use asperity::uncertainty::{
    DecidingMeasurement, DrawnMesh, PairedDifference, Quantiles, deciding, difference_of_meshes,
};
use asperity::{Error, PositionError, Run};
use asperity_core::{Code, Estimate, Fault, PROGRAM, unique};
use asperity_report::tables::FlankTables;
use asperity_report::{Input, Setting, StudySettings, Watch, Work, settings};
use serde::Serialize;
use serde_json::Value;

use super::statistics::rank_correlation;
use super::windows::{self, ComparedRoughness};
use crate::diff::{Change, changed_keys};

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
    /// Scope; efficiencies, losses and differences are always of the mesh, or of all meshes of a gear train.
    pub scope: Scope,
    /// Power into the meshes \[W\].
    pub power_in_w: f64,
    /// The finishes, or other variants.
    pub finishes: Vec<FinishResult>,
    /// Whether the variants differ by their flanks only.
    #[serde(skip)]
    pub(crate) are_finishes: bool,
    /// Torque, speed and temperature in words; `None` if the variants differ in them.
    #[serde(skip)]
    pub(crate) operation: Option<String>,
    /// Rank correlations of roughness with the computed loss, strongest first; empty of fewer than three finishes, of variants that
    /// differ by more than their flanks, of a gear train, and if a finish has fewer than 5 windows.
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
    /// Efficiency at the loss below.
    pub efficiency: f64,
    /// Power into the meshes \[W\].
    pub power_in_w: f64,
    /// Loss \[W\]: the median of the draws, without draws the loss of the run.
    pub loss_w: f64,
    /// Loss of the run with every constant at its median \[W\]; `None` without draws.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub loss_at_medians_w: Option<f64>,
    /// The uncertainty of the loss of a pair of gears; `None` if the model has none.
    pub uncertainty: Option<Uncertainty>,
    /// Median, quantiles and spread of the loss of a gear train.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub loss_distribution: Option<Quantiles>,
    /// Loss minus the loss of the first finish with the same draws; `None` for the first, and if the model has no
    /// uncertainty.
    pub difference: Option<PairedDifference>,
    /// Measurements that would narrow the difference, the one that leaves the narrowest interval first.
    #[serde(skip_serializing_if = "Vec::is_empty")]
    pub deciding: Vec<DecidingMeasurement>,
    /// Keys of the case that differ from the first one, unless these are of the flanks only.
    #[serde(skip_serializing_if = "Vec::is_empty")]
    pub changes: Vec<ChangedKey>,
    /// Loss of the flanks run in \[W\], scaled as `loss_w`, if the case sets `operation.running_in`.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub run_in_loss_w: Option<f64>,
    /// Losses of the gearbox, if the case states them; the same parts for every finish.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub gearbox: Option<GearboxReport>,
    /// Share of the path of a pair of gears in mixed lubrication.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub mixed_share: Option<f64>,
    /// Lubrication regime of a pair of gears.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub regime: Option<Regime>,
    /// Base oil, if the case has one.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub base_oil: Option<&'static str>,
    /// Kinematic viscosity at the bulk temperature, of a gear train of its first mesh \[mm²/s\].
    pub viscosity_mm2_per_s: f64,
    /// Meshes of a gear train.
    #[serde(skip_serializing_if = "Vec::is_empty")]
    pub meshes: Vec<MeshOfFinish>,
    /// Codes and texts of the warnings.
    pub warnings: Vec<String>,
    /// Losses of a pair of gears by offset.
    #[serde(skip)]
    pub offsets: Vec<OffsetRow>,
    /// Run of a pair of gears.
    #[serde(skip)]
    pub(crate) pair: Option<PairOfFinish>,
}

/// A key whose value differs from the first case; without a value where it is not stated and has no default.
#[derive(Debug, Clone, PartialEq, Eq, Serialize)]
#[non_exhaustive]
pub struct ChangedKey {
    /// The key.
    pub key: String,
    /// Value of the first case.
    pub first: String,
    /// Value of this one.
    pub value: String,
}

/// A mesh of a gear train with the flanks of a finish, or one of its equal meshes.
#[derive(Debug, Clone, PartialEq, Serialize)]
#[non_exhaustive]
pub struct MeshOfFinish {
    /// Name.
    pub mesh: String,
    /// Number of equal meshes.
    pub count: u32,
    /// Loss of one such mesh \[W\], scaled as the loss of all meshes to its median.
    pub loss_w: f64,
    /// Loss of its run with every constant at its median \[W\]; `None` without draws.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub loss_at_medians_w: Option<f64>,
    /// 5 and 95 % quantiles of its loss \[W\]; `None` without draws.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub loss_quantiles_w: Option<[f64; 2]>,
    /// Loss minus the loss of the mesh with the first finish, as of a finish.
    pub difference: Option<PairedDifference>,
    /// Share of the path in mixed lubrication.
    pub mixed_share: f64,
    /// Lubrication regime.
    pub regime: Regime,
}

/// The run of a pair of gears with a finish.
#[derive(Debug, Clone, PartialEq)]
pub(crate) struct PairOfFinish {
    /// The result of the run.
    pub result: RunResult,
    /// Traces and spectra of pinion and wheel; `None` for a flank without a trace.
    pub tables: [Option<FlankTables>; 2],
    /// Roughness under the contact by offset.
    pub roughness: Vec<ComparedRoughness>,
}

impl Comparison {
    /// The finishes of a pair of gears with their runs.
    pub(crate) fn pairs(&self) -> impl Iterator<Item = (&FinishResult, &PairOfFinish)> {
        let finishes = self.finishes.iter();
        finishes.filter_map(|finish| Some((finish, finish.pair.as_ref()?)))
    }
}

impl FinishResult {
    /// The loss with its 5 and 95 % quantiles \[W\]; `None` without draws.
    #[must_use]
    pub fn drawn_w(&self) -> Option<Estimate> {
        let of_pair = self.uncertainty.as_ref().map(|found| found.loss.drawn());
        of_pair.or(self.loss_distribution.map(|loss| loss.drawn))
    }

    /// Codes of the warnings about inputs outside of their ranges, with spaces.
    #[must_use]
    pub fn outside(&self) -> String {
        let codes = self.warnings.iter();
        outside_codes(codes.filter_map(|warning| warning.split(' ').next()?.parse().ok()))
    }

    /// Roughness under the contact of a pair of gears by offset.
    pub(crate) fn roughness(&self) -> &[ComparedRoughness] {
        self.pair.as_ref().map_or(&[], |pair| &pair.roughness)
    }
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

settings! {
    /// Settings of a comparison.
    pub struct CompareSettings {
        /// Number of offsets along the traces at which the flanks are paired [default: those that each finish needs]
        offsets: Option<usize>,
    }
}

/// A case on several finishes.
#[derive(Debug, Clone)]
pub struct Finishes(pub Vec<Finish<Train>>);

impl Finishes {
    /// The arguments of a case and its finishes.
    pub(crate) fn arguments(
        case: &'static str,
        kind: &'static str,
        finishes: &'static str,
    ) -> Vec<Setting> {
        vec![
            Setting::new("case", "CaseOfFinishes", case, None),
            Setting::new("finishes", kind, finishes, None),
        ]
    }

    /// Refuses to compare a single finish.
    ///
    /// # Errors
    /// When `count` is below two.
    pub fn check_count(count: usize) -> Result<(), Fault> {
        if count < 2 {
            let message = "a single finish or variant cannot be compared; give at least two";
            Err(Fault::new(Code::E205, message))
        } else {
            Ok(())
        }
    }

    /// The case of the first finish.
    pub(crate) fn first(&self) -> Result<&Train, Fault> {
        let first = self.0.first().map(|finish| &finish.case);
        first.ok_or_else(|| Fault::new(Code::E205, "finishes: none is given"))
    }
}

impl Input for Finishes {
    fn described() -> Vec<Setting> {
        Self::arguments(
            "The case, whose traces are replaced by the traces of each finish; the finishes of a gear train are cases",
            "Finishes",
            "By name a profile or file for both flanks (mirrored for the wheel), a pair of pinion and wheel, other values of keys, or a case; a single one that is no trace is compared with the case, as is",
        )
    }

    fn title(&self) -> String {
        let first = self.0.first();
        first.map_or_else(String::new, |first| first.case.title.clone())
    }
}

impl CompareSettings {
    /// The finishes with the stated number of offsets.
    fn applied(&self, Finishes(finishes): Finishes) -> Result<Finishes, Fault> {
        Finishes::check_count(finishes.len())?;
        let Some(offsets) = self.offsets else {
            return Ok(Finishes(finishes));
        };
        if offsets < 2 {
            let message = format!("offsets = {offsets}: must be at least 2, as one has no spread");
            return Err(Fault::new(Code::E209, message));
        }
        let on = |Finish { name, case }: Finish<Train>| {
            let case = case.with(&|input| input.model.offsets = Some(offsets))?;
            Ok(Finish { name, case })
        };
        let changed = finishes.into_iter().map(on);
        Ok(Finishes(changed.collect::<Result<_, Error>>()?))
    }
}

impl StudySettings for CompareSettings {
    type Input = Finishes;
    type Found = Comparison;
    const COMMAND: &'static str = "compare";
    const ABOUT: &'static str =
        "Compare finishes, oils, gears and other variants of a case, with paired differences";
    const EXAMPLES: &'static [&'static [(&'static str, &'static str)]] = &[
        &[
            ("case", "demo/case.toml"),
            (
                "finishes",
                "ground=demo/ground_pinion.csv,demo/ground_wheel.csv",
            ),
            (
                "finishes",
                "superfinished=demo/superfinished_pinion.csv,demo/superfinished_wheel.csv",
            ),
        ],
        &[
            ("case", "demo/case.toml"),
            ("variants", "pao: lubricant.oil=pao100"),
            ("variants", "mineral: lubricant.oil=m100"),
        ],
    ];
    const METHOD: &'static str = "The first is the reference for the others. Two variants have the samples of a constant in common where \
        the thing that it belongs to is the same in both, as the Eyring stress of one oil. Where it differs each has samples of its own. \
        A variant that names an oil leaves out all other numbers of the oil of the case, and its calibration.";
    const STEPS: &'static str = "variants";

    fn work(&self, given: &Finishes) -> Result<Option<Work>, Fault> {
        let finishes = self.applied(given.clone())?;
        let meshes = finishes.first()?.cases().cloned().collect();
        Ok(Some(Work::new(meshes, finishes.0.len())))
    }

    fn run(&self, given: Finishes, watch: &Watch<'_>) -> Result<Comparison, Fault> {
        Ok(compare(&self.applied(given)?.0, watch.progress)?)
    }
}

/// Runs all finishes and compares them with the first. Each loses what a run of it alone gives.
///
/// # Errors
/// When a finish has no solution.
pub fn compare<C: Clone + Into<Train>>(
    finishes: &[Finish<C>],
    progress: Progress<'_>,
) -> Result<Comparison, Error> {
    let mut runs: Vec<(&str, Train, Outcome)> = Vec::with_capacity(finishes.len());
    // Contacts do not depend on the oil: the variants share them.
    let mut contacts: Vec<Contacts> = Vec::new();
    for finish in finishes {
        let case: Train = finish.case.clone().into();
        let run = Run::new(&case).pictures(Kept::Nothing).interval(true);
        let outcome = run.known(&contacts).execute()?;
        contacts.extend(outcome.contacts.iter().cloned());
        runs.push((finish.name.as_str(), case, outcome));
        progress(runs.len(), finishes.len());
    }
    let Some((_, first, _)) = runs.first() else {
        return Err(Error::Whole(Box::new(PositionError::no_profile())));
    };
    let title = first.title.clone();
    let mut results: Vec<FinishResult> = Vec::with_capacity(runs.len());
    for (k, (name, case, outcome)) in runs.iter().enumerate() {
        let first = (k > 0).then(|| &runs[0].2);
        results.push(finish_result(name, case, outcome, first)?);
    }
    let are_finishes = runs
        .iter()
        .all(|(_, case, _)| differs_by_flanks(&runs[0].1, case));
    if !are_finishes {
        for (finish, (_, case, _)) in results.iter_mut().zip(&runs).skip(1) {
            finish.changes = changes(&runs[0].1, case)?;
        }
    }
    let operations = runs
        .iter()
        .map(|(_, case, _)| case.input.operation.in_words());
    let operation = unique(operations);
    let pooled = |finish: &FinishResult| finish.roughness().len().min(finish.offsets.len());
    Ok(Comparison {
        program: PROGRAM.to_owned(),
        title,
        scope: if results.iter().any(|finish| finish.gearbox.is_some()) {
            Scope::Gearbox
        } else {
            Scope::Mesh
        },
        power_in_w: results.last().map_or(0.0, |finish| finish.power_in_w),
        // Other oils or gears order the losses, too.
        correlations: if are_finishes {
            correlations(&results)
        } else {
            Vec::new()
        },
        windows: results.iter().map(pooled).sum(),
        finishes: results,
        are_finishes,
        operation: match operation.as_slice() {
            [one] => Some(one.clone()),
            _ => None,
        },
    })
}

/// Whether two cases differ by their flanks only.
pub(crate) fn differs_by_flanks(first: &Train, other: &Train) -> bool {
    let without_flanks = |case: &Train| -> Vec<CaseInput> {
        let inputs = case.cases().map(|mesh| mesh.case.input.clone());
        inputs
            .map(|input| CaseInput {
                title: Default::default(),
                surface: Default::default(),
                ..input
            })
            .collect()
    };
    without_flanks(first) == without_flanks(other)
}

/// Keys by which two cases differ.
fn changes(first: &Train, other: &Train) -> Result<Vec<ChangedKey>, Error> {
    let of = |case: &'_ Train| (case.input.clone(), case.defaults.clone());
    let ((a, by_first), (b, by_other)) = (of(first), of(other));
    let found = changed_keys((&a, &by_first), (&b, &by_other));
    let found =
        found.map_err(|error| Error::Whole(Box::new(PositionError::from(Fault::internal(error)))));
    let text = |value: Option<Value>| match value {
        None => String::new(),
        Some(Value::String(text)) => text,
        Some(value) => value.to_string(),
    };
    let row = |change: Change| ChangedKey {
        key: change.key,
        first: text(change.first),
        value: text(change.second),
    };
    Ok(found?.into_iter().map(row).collect())
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
    name: &str,
    case: &Train,
    outcome: &Outcome,
    first: Option<&Outcome>,
) -> Result<FinishResult, Error> {
    let compared = first.and_then(|first| first.drawn_beside(outcome));
    let difference = compared
        .as_ref()
        .map(|[first, own]| difference_of_meshes(first, own));
    let result = &outcome.whole;
    let oil = case.meshes().next().map(|mesh| &mesh.case.case.lubricant);
    let Some(of_first) = outcome.meshes.first() else {
        return Err(Error::Whole(Box::new(PositionError::no_profile())));
    };
    let mut finish = FinishResult {
        name: name.to_owned(),
        files: unique(case.meshes().flat_map(|mesh| files(&mesh.case))),
        efficiency: result.efficiency,
        power_in_w: result.meshes_power_in_w(),
        loss_w: result.loss_w,
        loss_at_medians_w: result.loss_at_medians_w,
        uncertainty: None,
        loss_distribution: result.loss_distribution,
        difference,
        deciding: compared
            .as_ref()
            .map_or(Vec::new(), |[first, own]| deciding(first, own)),
        changes: Vec::new(),
        run_in_loss_w: run_in_loss(outcome),
        gearbox: result.gearbox.clone(),
        mixed_share: None,
        regime: None,
        base_oil: oil.and_then(Lubricant::base_oil).map(BaseOil::name),
        viscosity_mm2_per_s: 1e6 * of_first.result.lubricant.kinematic_viscosity.si(),
        meshes: Vec::new(),
        warnings: warnings(outcome),
        offsets: Vec::new(),
        pair: None,
    };
    let Some((loaded, run)) = case.only().zip(outcome.only()) else {
        let meshes = result.meshes.iter().zip(&outcome.meshes).enumerate();
        finish.meshes = meshes
            .map(|(k, (row, run))| {
                let pair = compared.as_ref().and_then(|[of_first, own]| {
                    let mut names = first?.whole.meshes.iter();
                    let same = names.position(|known| known.mesh == row.mesh)?;
                    Some((of_first.get(same)?, own.get(k)?))
                });
                let summary = &run.result.summary;
                MeshOfFinish {
                    mesh: row.mesh.clone(),
                    count: row.count,
                    loss_w: row.loss_w,
                    loss_at_medians_w: row.loss_at_medians_w,
                    loss_quantiles_w: row.drawn_w().map(Estimate::ends),
                    difference: pair
                        .map(|(first, own)| difference_of_meshes(&[single(first)], &[single(own)])),
                    mixed_share: summary.mixed_share,
                    regime: summary.regime,
                }
            })
            .collect();
        return Ok(finish);
    };
    let result = run.result.clone();
    let roughness = windows::roughness(loaded, run.offsets.len())
        .map_err(|error| Error::Whole(Box::new(error)))?;
    let flank = |body: usize| {
        FlankTables::new(&result.flanks[body], run.traces[body].as_ref())
            .map_err(|error| Error::Whole(Box::new(error.into())))
    };
    let tables = [flank(0)?, flank(1)?];
    finish.efficiency = result.summary.efficiency;
    finish.power_in_w = result.summary.power_in_w;
    finish.uncertainty.clone_from(&result.uncertainty);
    finish.loss_distribution = None;
    finish.gearbox.clone_from(&result.gearbox);
    finish.mixed_share = Some(result.summary.mixed_share);
    finish.regime = Some(result.summary.regime);
    finish.offsets.clone_from(&run.offsets);
    finish.pair = Some(PairOfFinish {
        result,
        tables,
        roughness,
    });
    Ok(finish)
}

/// Loss of all meshes with their flanks run in \[W\]; `None` unless every mesh was run in.
fn run_in_loss(outcome: &Outcome) -> Option<f64> {
    let meshes = outcome.whole.meshes.iter().zip(&outcome.meshes);
    let of_mesh = |(row, run): (&MeshRow, &MeshOutcome)| {
        let run_in = run.result.run_in.as_ref()?;
        Some(f64::from(row.count) * run_in.summary.loss_w)
    };
    meshes.map(of_mesh).sum()
}

/// Distinct warnings of all meshes, with the name of the mesh unless they apply to all.
fn warnings(outcome: &Outcome) -> Vec<String> {
    let of = |run: &MeshOutcome| {
        run.result
            .warnings
            .iter()
            .map(ToString::to_string)
            .collect()
    };
    let all: Vec<Vec<String>> = outcome.meshes.iter().map(of).collect();
    let texts = outcome.whole.meshes.iter().zip(&all);
    unique(texts.flat_map(|(row, warnings)| {
        warnings.iter().map(|warning| {
            if all.iter().all(|other| other.contains(warning)) {
                warning.clone()
            } else {
                format!("{warning} [{}]", row.mesh)
            }
        })
    }))
}

/// One of equal meshes.
fn single<'a>(mesh: &DrawnMesh<'a>) -> DrawnMesh<'a> {
    DrawnMesh { count: 1, ..*mesh }
}

/// Fewest pairs of a correlation.
const FEWEST_PAIRS: usize = 5;
/// Fewest finishes of a correlation: any parameter that differs between two finishes orders them.
const FEWEST_FINISHES: usize = 3;

fn correlations(finishes: &[FinishResult]) -> Vec<Correlation> {
    let few =
        |finish: &FinishResult| finish.roughness().len().min(finish.offsets.len()) < FEWEST_PAIRS;
    if finishes.len() < FEWEST_FINISHES || finishes.iter().any(few) {
        return Vec::new();
    }
    let pairs = |finish: &FinishResult, of: windows::Value| -> Vec<[f64; 2]> {
        let rows = finish.roughness().iter().zip(&finish.offsets);
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
