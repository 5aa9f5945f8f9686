//! Rows of the losses and of the friction laws.

use asperity::result::{ComparisonOutcome, RunResult};
use serde::Serialize;

/// Row of `losses.csv`: a part of the loss.
#[derive(Debug, Clone, Copy, PartialEq, Serialize)]
pub struct LossRow {
    /// Name of the part.
    pub part: &'static str,
    /// Its power \[W\].
    pub power_w: f64,
    /// Its share of the loss \[%\].
    pub share_of_loss_percent: f64,
    /// Its share of the power into the mesh \[%\].
    pub share_of_power_in_percent: f64,
}

/// Parts of the loss: sliding and rolling always, the others where the formulation counts them.
pub fn losses(result: &RunResult) -> Vec<LossRow> {
    let s = &result.summary;
    let running_in = match result.running_in.included {
        true => result.running_in.first_pass_w,
        false => 0.0,
    };
    let parts = [
        ("sliding", s.sliding_w),
        ("rolling", s.rolling_w),
        ("deformation pinion", s.deformation_w[0]),
        ("deformation wheel", s.deformation_w[1]),
        ("hysteresis", s.hysteresis_w),
        ("running-in", running_in),
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

/// Row of `friction_laws.csv`: the efficiency with a friction law.
#[derive(Debug, Clone, PartialEq, Serialize)]
pub struct FrictionLawRow<'a> {
    /// Name of the law.
    pub law: &'a str,
    /// Efficiency \[%\].
    pub efficiency_percent: Option<f64>,
    /// Loss \[%\].
    pub loss_percent: Option<f64>,
    /// Reason why the law cannot be used here.
    pub refused: &'a str,
}

/// Rows of the friction laws.
pub fn friction_laws(result: &RunResult) -> Vec<FrictionLawRow<'_>> {
    let rows = result.friction_laws.iter().map(|entry| {
        let (efficiency, refused) = match &entry.outcome {
            ComparisonOutcome::Efficiency(value) => (Some(*value), ""),
            ComparisonOutcome::Refused(why) => (None, why.as_str()),
        };
        FrictionLawRow {
            law: &entry.law,
            efficiency_percent: efficiency.map(|value| 100.0 * value),
            loss_percent: efficiency.map(|value| 100.0 * (1.0 - value)),
            refused,
        }
    });
    rows.collect()
}
