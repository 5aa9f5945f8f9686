//! The runs of a sensitivity study.

use asperity::case::LoadedCase;
use asperity::core::cancel::checkpoint;
use asperity::pipeline::{Progress, contacts, losses, losses_with};
use asperity::result::{Losses, Summary};
use asperity::uncertainty::DrawnLosses;
use asperity::{Contacts, Error};
use serde::Serialize;

use super::changes::{Change, changes};

/// What the loss of a case does when one thing changes.
#[derive(Debug, Clone, PartialEq, Serialize)]
#[non_exhaustive]
pub struct Sensitivity {
    /// Title of the case.
    pub title: String,
    /// Its loss \[W\].
    pub loss_w: f64,
    /// Its mesh efficiency.
    pub efficiency: f64,
    /// Parts that the case states beside the mesh, and that are in no number here.
    #[serde(skip_serializing_if = "Vec::is_empty")]
    pub left_aside: Vec<String>,
    /// One row per change.
    pub rows: Vec<SensitivityRow>,
}

/// A change.
#[derive(Debug, Clone, PartialEq, Serialize)]
#[non_exhaustive]
pub struct SensitivityRow {
    /// What it is of: flanks, boundary layer, oil, gears.
    pub group: &'static str,
    /// What is changed, with its value where it has one.
    pub what: String,
    /// To what.
    pub to: String,
    /// What follows; none where the changed case cannot be run.
    pub effect: Option<Effect>,
    /// Why it cannot.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub refused: Option<Refused>,
}

/// Why a changed case cannot be run.
#[derive(Debug, Clone, PartialEq, Serialize)]
pub struct Refused {
    /// Code of the error.
    pub code: String,
    /// The error.
    pub message: String,
}

/// Differences to the case, at the same windows of its traces \[W\].
#[derive(Debug, Clone, Copy, PartialEq, Serialize)]
#[non_exhaustive]
pub struct Effect {
    /// Change of the loss.
    pub difference_w: f64,
    /// The same over the loss.
    pub change: f64,
    /// Half the width of its 95 % interval by the sampling of the flanks; none where that has no interval.
    pub sampling_half_width_w: Option<f64>,
    /// Change of the friction in the film.
    pub film_w: f64,
    /// Change of the friction of lubricated asperities.
    pub lubricated_asperity_w: f64,
    /// Change of the friction of the boundary layer.
    pub boundary_w: f64,
    /// Change of the rolling loss.
    pub rolling_w: f64,
}

/// Runs `case`, then every change of it; `progress` is told how many runs are done.
///
/// # Errors
/// When the case itself has no result. A change without one has the reason in its row.
pub fn sensitivity(case: &LoadedCase, progress: Progress<'_>) -> Result<Sensitivity, Error> {
    let gearbox = case.case.gearbox.iter();
    let parts = gearbox.flat_map(|gearbox| &gearbox.parts);
    let left_aside = parts.map(|part| part.name.clone()).collect();
    // Not at the temperatures of the changes either, which its table need not reach.
    let mut mesh = case.clone();
    mesh.case.gearbox = None;
    let case = &mesh;
    let changes = changes(case);
    let runs = 1 + changes.len();
    let tables = contacts(case).ok();
    let base = run(case, tables.as_ref())?;
    progress(1, runs);
    let sampled = DrawnLosses::of(case, &base);
    let mut rows = Vec::new();
    for change in changes {
        rows.push(row(change, (&base, &sampled), tables.as_ref()));
        checkpoint()?;
        progress(1 + rows.len(), runs);
    }
    Ok(Sensitivity {
        title: case.case.title.clone(),
        loss_w: base.summary.loss_w,
        efficiency: base.summary.efficiency,
        left_aside,
        rows,
    })
}

/// Losses with the contacts made before where they are those of the case.
fn run(case: &LoadedCase, tables: Option<&Contacts>) -> Result<Losses, Error> {
    if let Some(tables) = tables
        && let Ok(found) = losses_with(tables, case)
    {
        return Ok(found);
    }
    losses(case)
}

fn row(
    change: Change,
    (base, sampled): (&Losses, &DrawnLosses),
    tables: Option<&Contacts>,
) -> SensitivityRow {
    let tables = tables.filter(|_| change.keeps_contacts);
    let found = change.case.and_then(|case| run(&case, tables));
    let (effect, refused) = match found {
        Ok(changed) => (Some(effect(base, &changed, sampled)), None),
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

fn effect(base: &Losses, changed: &Losses, sampled: &DrawnLosses) -> Effect {
    let difference = |of: fn(&Summary) -> f64| of(&changed.summary) - of(&base.summary);
    let difference_w = difference(|summary| summary.loss_w);
    // The windows are the same, so their differences scatter, not the losses themselves.
    let pairs = base.offsets.iter().zip(&changed.offsets);
    let by_window: Vec<f64> = pairs.map(|(a, b)| b.loss_w - a.loss_w).collect();
    Effect {
        difference_w,
        change: difference_w / base.summary.loss_w,
        sampling_half_width_w: sampled.half_width_of(&by_window),
        film_w: difference(|summary| summary.film_w),
        lubricated_asperity_w: difference(|summary| summary.lubricated_asperity_w),
        boundary_w: difference(|summary| summary.boundary_w),
        rolling_w: difference(|summary| summary.rolling_w),
    }
}
