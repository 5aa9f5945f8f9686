//! Tables of the losses and of the friction laws.

use std::path::Path;

use serde::Serialize;

use super::ReportError;
use super::tables::write;
use crate::result::{ComparisonOutcome, RunResult};

/// `losses.csv`: the parts of the loss.
pub(super) fn losses(result: &RunResult, file: &Path) -> Result<(), ReportError> {
    #[derive(Serialize)]
    struct Row {
        part: &'static str,
        power_w: f64,
        share_of_loss_percent: f64,
        share_of_power_in_percent: f64,
    }
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
    // Sliding and rolling always; the others where the formulation counts them.
    let rows = parts
        .into_iter()
        .enumerate()
        .filter(|(k, (_, power))| *k < 2 || *power != 0.0);
    let share = |power: f64| {
        if s.loss_w > 0.0 {
            100.0 * power / s.loss_w
        } else {
            0.0
        }
    };
    write(
        file,
        rows.map(|(_, (part, power))| Row {
            part,
            power_w: power,
            share_of_loss_percent: share(power),
            share_of_power_in_percent: 100.0 * power / s.power_in_w,
        }),
    )
}

/// `friction_laws.csv`: the efficiency with each friction law.
pub(super) fn friction_laws(result: &RunResult, file: &Path) -> Result<(), ReportError> {
    #[derive(Serialize)]
    struct Row<'a> {
        law: &'a str,
        efficiency_percent: Option<f64>,
        loss_percent: Option<f64>,
        refused: &'a str,
    }
    let rows = result.friction_laws.iter().map(|entry| {
        let (efficiency, refused) = match &entry.outcome {
            ComparisonOutcome::Efficiency(value) => (Some(*value), ""),
            ComparisonOutcome::Refused(why) => (None, why.as_str()),
        };
        Row {
            law: &entry.law,
            efficiency_percent: efficiency.map(|value| 100.0 * value),
            loss_percent: efficiency.map(|value| 100.0 * (1.0 - value)),
            refused,
        }
    });
    write(file, rows)
}
