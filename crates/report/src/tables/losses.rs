//! Tables of the losses and of the friction laws.

use asperity::result::{PublishedOutcome, RunResult};
use serde::Serialize;

/// Row of `losses.csv`: a part of the loss.
#[derive(Debug, Clone, Copy, PartialEq, Serialize)]
pub struct LossRow {
    /// Name of the part.
    pub part: &'static str,
    /// Power \[W\].
    pub power_w: f64,
    /// Share of the loss \[%\].
    pub share_of_loss_percent: f64,
    /// Share of the input power \[%\].
    pub share_of_power_in_percent: f64,
}

/// Parts of the loss: sliding, rolling and the others of the formulation; then the parts of sliding and rolling.
pub fn losses(result: &RunResult) -> Vec<LossRow> {
    let s = &result.summary;
    let parts = [
        ("sliding", s.sliding_w),
        ("rolling", s.rolling_w),
        ("deformation pinion", s.deformation_w[0]),
        ("deformation wheel", s.deformation_w[1]),
        ("of sliding: film", s.film_w),
        ("of sliding: lubricated asperities", s.lubricated_asperity_w),
        ("of sliding: boundary", s.boundary_w),
        ("of rolling: hysteresis", s.hysteresis_w),
    ];
    let share = |power: f64| {
        if s.loss_w > 0.0 {
            100.0 * power / s.loss_w
        } else {
            0.0
        }
    };
    parts
        .into_iter()
        .enumerate()
        .filter(|(k, (_, power))| *k < 2 || *power != 0.0)
        .map(|(_, (part, power))| LossRow {
            part,
            power_w: power,
            share_of_loss_percent: share(power),
            share_of_power_in_percent: 100.0 * power / s.power_in_w,
        })
        .collect()
}

/// Row of `friction_laws.csv`: a published friction law instead of film and asperity friction.
#[derive(Debug, Clone, PartialEq, Serialize)]
pub struct FrictionLawRow<'a> {
    /// Name of the law.
    pub law: &'a str,
    /// Whether its coefficient includes asperity friction.
    pub includes_asperities: bool,
    /// Whether all inputs are within the range of the fit.
    pub inside_its_range: bool,
    /// Loss \[W\].
    pub loss_w: Option<f64>,
    /// Sliding loss \[W\].
    pub sliding_w: Option<f64>,
    /// Efficiency \[%\].
    pub efficiency_percent: Option<f64>,
    /// Data of the fit.
    pub fitted_to: &'a str,
    /// Inputs outside of the range.
    pub outside: String,
    /// Reason why the law does not apply.
    pub refused: &'a str,
}

/// Rows of `friction_laws.csv`.
pub fn friction_laws(result: &RunResult) -> Vec<FrictionLawRow<'_>> {
    let rows = result.published_laws.iter().map(|entry| {
        let mut row = FrictionLawRow {
            law: &entry.law,
            includes_asperities: entry.includes_asperities,
            inside_its_range: entry.inside_its_range,
            loss_w: None,
            sliding_w: None,
            efficiency_percent: None,
            fitted_to: &entry.fitted_to,
            outside: entry.outside.join("; "),
            refused: "",
        };
        match &entry.outcome {
            PublishedOutcome::Applied {
                loss_w,
                sliding_w,
                efficiency,
            } => {
                (row.loss_w, row.sliding_w) = (Some(*loss_w), Some(*sliding_w));
                row.efficiency_percent = Some(100.0 * efficiency);
            }
            PublishedOutcome::Refused(why) => row.refused = why,
            _ => (),
        }
        row
    });
    rows.collect()
}
