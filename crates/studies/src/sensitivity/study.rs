//! Computation of a sensitivity study.

use asperity::case::train::Train;
use asperity::case::{LoadedCase, ShareLaw};
use asperity::core::cancel::checkpoint;
use asperity::pipeline::Progress;
use asperity::result::{Losses, Summary};
use asperity::train::total_of;
use asperity::uncertainty::{Predictive, change_between, change_of, predictive};
use asperity::{Contacts, Error, PositionError, Run};
use asperity_core::quantity::Power;
use asperity_core::{Code, Estimate, Fault};
use asperity_report::{StudySettings, Watch, Work, settings};
use serde::Serialize;

use super::changes::{CHANGES, Change, FILTERS, SCANS, changes};

/// Sensitivity of the loss of a case to single changes.
#[derive(Debug, Clone, PartialEq, Serialize)]
#[non_exhaustive]
pub struct Sensitivity {
    /// Title of the case.
    pub title: String,
    /// Operating point, and numbers of positions and offsets, in words; empty for a train of several meshes.
    #[serde(skip_serializing_if = "String::is_empty")]
    pub conditions: String,
    /// Loss \[W\]: the median of the draws, to which all changes are scaled; without draws the loss of the run.
    pub loss_w: f64,
    /// Loss of the run with every constant at its median \[W\]; `None` without draws.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub loss_at_medians_w: Option<f64>,
    /// Mesh efficiency.
    pub efficiency: f64,
    /// Losses in addition to the mesh that the case states; not included in any number here.
    #[serde(skip_serializing_if = "Vec::is_empty")]
    pub left_aside: Vec<String>,
    /// One row per change.
    pub rows: Vec<SensitivityRow>,
}

/// Change with its effect.
#[derive(Debug, Clone, PartialEq, Serialize)]
#[non_exhaustive]
pub struct SensitivityRow {
    /// Group: flanks, filters, scans, boundary layer, oil, gears.
    pub group: &'static str,
    /// Changed quantity, with its present value if it has one.
    pub what: String,
    /// New value.
    pub to: String,
    /// Effect; `None` if the changed case has no result.
    pub effect: Option<Effect>,
    /// Error if it has no result.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub refused: Option<Refused>,
}

impl SensitivityRow {
    /// Whether both rows have the same change.
    fn is_change_of(&self, other: &Self) -> bool {
        (self.group, &self.what, &self.to) == (other.group, &other.what, &other.to)
    }
}

/// Error of a changed case.
#[derive(Debug, Clone, PartialEq, Serialize)]
#[non_exhaustive]
pub struct Refused {
    /// Code of the error.
    pub code: Code,
    /// Message.
    pub message: String,
}

/// Differences from the unchanged case \[W\], at the same windows of its traces unless their filters change.
#[derive(Debug, Clone, Copy, PartialEq, Default, Serialize)]
#[non_exhaustive]
pub struct Effect {
    /// Change of the loss.
    pub difference_w: f64,
    /// Change relative to the loss.
    pub change: f64,
    /// 5 % and 95 % quantiles of the change, of what differs between both cases; `None` without draws, and where the contact of the
    /// flanks is another.
    pub quantiles_w: Option<[f64; 2]>,
    /// Change of the friction in the film.
    pub film_w: f64,
    /// Change of the friction of lubricated asperities.
    pub lubricated_asperity_w: f64,
    /// Change of the friction of the boundary layer.
    pub boundary_w: f64,
    /// Change of the rolling loss.
    pub rolling_w: f64,
}

impl Effect {
    /// The same of losses that are `factor` times as large, with the quantiles of the draws.
    fn times(self, factor: f64) -> Self {
        Self {
            difference_w: factor * self.difference_w,
            change: self.change,
            quantiles_w: self.quantiles_w,
            film_w: factor * self.film_w,
            lubricated_asperity_w: factor * self.lubricated_asperity_w,
            boundary_w: factor * self.boundary_w,
            rolling_w: factor * self.rolling_w,
        }
    }

    /// The parts of the change: film, lubricated asperities, boundary layer, rolling.
    pub(super) fn parts(&self) -> [f64; 4] {
        [
            self.film_w,
            self.lubricated_asperity_w,
            self.boundary_w,
            self.rolling_w,
        ]
    }
}

/// Loss and rows of a mesh.
struct OfMesh {
    /// With every constant at its median.
    loss_w: f64,
    drawn: Option<Predictive>,
    rows: Vec<SensitivityRow>,
}

/// Runs the mesh of `case` and all its changes.
fn of_mesh(case: &LoadedCase, progress: Progress<'_>) -> Result<OfMesh, Error> {
    // The gearbox is removed: its loss table need not cover the temperatures of the changes.
    let mut mesh = case.without_gearbox();
    let tables = Run::new(&mesh).contacts().unwrap_or_default();
    if let Some(tables) = tables.first() {
        // Every change is computed at the same windows.
        let offsets = tables.offsets();
        mesh = mesh.with(|input| input.model.offsets = Some(offsets))?;
    }
    let case = &mesh;
    let changes = changes(case);
    let runs = 1 + changes.len();
    let losses = run(case, &tables)?;
    let base = Base {
        drawn: predictive(case, &losses, tables.first())?,
        case,
        losses,
    };
    progress(1, runs);
    let mut rows = Vec::new();
    for change in changes {
        rows.push(row(change, &base, &tables));
        checkpoint()?;
        progress(1 + rows.len(), runs);
    }
    Ok(OfMesh {
        loss_w: base.losses.summary.loss_w,
        drawn: base.drawn,
        rows,
    })
}

settings! {
    /// Settings of a study of single changes: none.
    pub struct SensitivitySettings {}
}

impl StudySettings for SensitivitySettings {
    type Input = Train;
    type Found = Sensitivity;
    const COMMAND: &'static str = "sensitivity";
    const ABOUT: &'static str = "Sensitivity of the loss to single changes: heights, wavelengths, boundary layer, oil, tip relief";
    const EXAMPLES: &'static [&'static [(&'static str, &'static str)]] =
        &[&[("case", "demo/case.toml")]];
    const METHOD: &'static str = "Each row is a run of the model with one thing changed, at the same windows of the traces. To vary \
        keys of your own choice, with distributions, see the command sweep.";
    const STEPS: &'static str = "changes";

    fn work(&self, train: &Train) -> Result<Option<Work>, Fault> {
        let meshes = train.cases().cloned().collect();
        Ok(Some(Work::new(meshes, 1 + CHANGES)))
    }

    fn run(&self, train: Train, watch: &Watch<'_>) -> Result<Sensitivity, Fault> {
        Ok(sensitivity(&train, watch.progress)?)
    }
}

/// Runs every mesh of a case and all its changes; `progress` is called with the number of completed runs. A change that all meshes have is made in all of them, another one
/// has the name of its mesh. Oil temperature and torques are held where they follow from the losses. The intervals of equal changes of several meshes add up, as for equal flanks.
///
/// # Errors
/// When a mesh has no result, or a shaft no speed or torque. The row of a change without a result holds its error.
pub fn sensitivity(train: &Train, progress: Progress<'_>) -> Result<Sensitivity, Error> {
    let train = &Run::new(train).settled()?;
    let parts = train.gearbox.iter().flat_map(|gearbox| &gearbox.parts);
    let left_aside = parts.map(|part| part.name.clone()).collect();
    let counts = train.counts();
    let mut of_meshes: Vec<OfMesh> = Vec::new();
    for (k, mesh) in train.meshes().enumerate() {
        let shown = |done, of| progress(k * of + done, counts.len() * of);
        of_meshes.push(of_mesh(&mesh.case, &shown)?);
    }
    let losses = of_meshes.iter().map(|mesh| Power::from_si(mesh.loss_w));
    let losses: Vec<Power> = losses.collect();
    let at_medians_w = train.loss(&losses).si();
    let drawn = total_of(train, of_meshes.iter().map(|mesh| mesh.drawn.as_ref()));
    let loss_w = drawn.map_or(at_medians_w, |drawn| drawn.drawn.value);
    let to_median = loss_w / at_medians_w;
    let losses: Vec<Power> = losses.iter().map(|loss| *loss * to_median).collect();
    let power_in = train.shafting.power_in(&train.by_stage(&losses));
    let power_in = power_in.map_err(|error| Box::new(PositionError::from(error)))?;
    let mut rows: Vec<SensitivityRow> = Vec::new();
    for (mesh, study) in train.meshes().zip(&of_meshes) {
        for row in &study.rows {
            let same = |other: &&SensitivityRow| other.is_change_of(row);
            let all = of_meshes.iter().map(|study| study.rows.iter().find(same));
            let counted = counts.iter().map(|count| f64::from(*count));
            match all.collect::<Option<Vec<_>>>() {
                Some(_) if rows.iter().any(|known| known.is_change_of(row)) => {}
                Some(all) => rows.push(together(row, all.into_iter().zip(counted), at_medians_w)),
                None => {
                    let is_own = |other: &OfMesh| std::ptr::eq(other, study);
                    let own = of_meshes.iter().zip(counted);
                    let count = own
                        .filter(|(other, _)| is_own(other))
                        .map(|(_, count)| count);
                    let of_mesh = SensitivityRow {
                        what: format!("{} ({})", row.what, mesh.name),
                        ..row.clone()
                    };
                    rows.push(together(
                        &of_mesh,
                        count.map(|count| (row, count)),
                        at_medians_w,
                    ));
                }
            }
        }
    }
    for effect in rows.iter_mut().filter_map(|row| row.effect.as_mut()) {
        *effect = effect.times(to_median);
    }
    Ok(Sensitivity {
        title: train.title.clone(),
        conditions: train
            .only()
            .map_or(String::new(), |mesh| mesh.case.conditions()),
        loss_w,
        loss_at_medians_w: drawn.map(|_| at_medians_w),
        efficiency: 1.0 - loss_w / power_in.si(),
        left_aside,
        rows,
    })
}

/// The row `named` with the sum of the effects of rows, each with its number of equal meshes.
fn together<'a>(
    named: &SensitivityRow,
    rows: impl Iterator<Item = (&'a SensitivityRow, f64)>,
    loss_w: f64,
) -> SensitivityRow {
    let mut sum = Effect::default();
    let mut intervals = Some([0.0; 2]);
    let mut refused = None;
    for (row, count) in rows {
        let Some(effect) = &row.effect else {
            refused.clone_from(&row.refused);
            continue;
        };
        sum.difference_w += count * effect.difference_w;
        sum.film_w += count * effect.film_w;
        sum.lubricated_asperity_w += count * effect.lubricated_asperity_w;
        sum.boundary_w += count * effect.boundary_w;
        sum.rolling_w += count * effect.rolling_w;
        intervals = intervals
            .zip(effect.quantiles_w)
            .map(|(sum, own)| std::array::from_fn(|k| sum[k] + count * own[k]));
    }
    sum.change = sum.difference_w / loss_w;
    sum.quantiles_w = intervals;
    SensitivityRow {
        effect: refused.is_none().then_some(sum),
        refused,
        ..named.clone()
    }
}

/// Losses, with the contacts of the unchanged case if they are the same.
fn run(case: &LoadedCase, tables: &[Contacts]) -> Result<Losses, Error> {
    Run::new(case).known(tables).losses()?.into_only()
}

/// A case with its losses, and its draws if it has an uncertainty.
struct Base<'a> {
    case: &'a LoadedCase,
    losses: Losses,
    drawn: Option<Predictive>,
}

fn row(change: Change, base: &Base<'_>, tables: &[Contacts]) -> SensitivityRow {
    // Reference solutions have other windows than the offsets.
    let is_by_records = matches!(base.case.case.share_law(), ShareLaw::Reference);
    let has_other_contact = change.group == SCANS || is_by_records;
    let first = base.drawn.as_ref().filter(|_| !has_other_contact);
    let found = change.case.and_then(|case| match (first, change.group) {
        (Some(drawn), FILTERS) => {
            let tables = Run::new(&case).contacts()?;
            let losses = run(&case, &tables)?;
            let own = predictive(&case, &losses, tables.first())?;
            let change = own.map(|own| change_between((base.case, drawn), (&case, &own)));
            Ok(effect(base, &losses, change))
        }
        _ => {
            let losses = run(&case, tables)?;
            let change = first.map(|drawn| change_of((base.case, drawn), &case, &losses));
            Ok(effect(base, &losses, change.transpose()?))
        }
    });
    let (effect, refused) = match found {
        Ok(effect) => (Some(effect), None),
        Err(error) => {
            let refused = Refused {
                code: error.code().to_owned(),
                message: error.to_string(),
            };
            (None, Some(refused))
        }
    };
    SensitivityRow {
        group: change.group,
        what: change.what,
        to: change.to,
        effect,
        refused,
    }
}

fn effect(base: &Base<'_>, changed: &Losses, drawn: Option<Estimate>) -> Effect {
    let before = &base.losses.summary;
    let difference = |of: fn(&Summary) -> f64| of(&changed.summary) - of(before);
    let difference_w = difference(|summary| summary.loss_w);
    Effect {
        difference_w,
        change: difference_w / before.loss_w,
        quantiles_w: drawn.map(Estimate::ends),
        film_w: difference(|summary| summary.film_w),
        lubricated_asperity_w: difference(|summary| summary.lubricated_asperity_w),
        boundary_w: difference(|summary| summary.boundary_w),
        rolling_w: difference(|summary| summary.rolling_w),
    }
}
