//! Several traces of a flank as a result keeps them: which they are, and the loss of every pair.

use serde::{Deserialize, Serialize};

use crate::result::FlankRecord;
use crate::result::PairSampling;
use asperity_case::flanks::trace_pairs::SampledTrace;

/// All pairs of several traces.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
#[non_exhaustive]
pub struct TracePairs {
    /// Traces of pinion and wheel.
    pub traces: [Vec<ToothTrace>; 2],
    /// Loss \\[W\\] of each tooth of the pinion, row by row, on each of the wheel.
    pub losses_w: Vec<Vec<f64>>,
    /// The mean of these with its standard error and the parts of that; none of a single pair of teeth.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub sampling: Option<PairSampling>,
}

/// One of several traces of a flank.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
#[non_exhaustive]
pub struct ToothTrace {
    /// Row or column of the losses, from 1.
    pub tooth: usize,
    /// Number of the tooth as the case states it.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub tooth_number: Option<u32>,
    /// Place across the face \\[mm\\], where the case states it.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub y_mm: Option<f64>,
    /// Its row in the file, from 1, where the traces are rows of one scan.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub row: Option<usize>,
    /// Distance of this row from the first one of the scan \\[mm\\].
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub row_mm: Option<f64>,
    /// Loss \\[W\\] of this trace, mean over its pairs with the traces of the other flank; their scatter is `sampling.between_w`.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub loss_w: Option<f64>,
    /// The trace as read and prepared.
    #[serde(flatten)]
    pub record: FlankRecord,
}

impl From<&SampledTrace> for ToothTrace {
    fn from(trace: &SampledTrace) -> Self {
        Self {
            tooth: trace.tooth + 1,
            tooth_number: trace.number,
            y_mm: trace.y.map(|y| y.si() * 1e3),
            row: trace.row.map(|row| row.number),
            row_mm: trace.row.and_then(|row| Some(row.along_lead?.si() * 1e3)),
            loss_w: None,
            record: FlankRecord::from(&trace.report),
        }
    }
}
