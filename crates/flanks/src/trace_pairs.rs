//! Several traces of a flank, as read and prepared.

use asperity_core::quantity::Length;

use crate::surfaces::FlankReport;
use crate::trace_sites::{ScanRow, TraceSite};

/// One of several traces of a flank, as read and prepared.
#[derive(Debug, Clone, PartialEq)]
#[non_exhaustive]
pub struct SampledTrace {
    /// Index of the tooth, from 0 in the order of the case.
    pub tooth: usize,
    /// Number of the tooth as the case states it.
    pub number: Option<u32>,
    /// Place across the face, where the case states it.
    pub y: Option<Length>,
    /// Its row, of several rows of one scan.
    pub row: Option<ScanRow>,
    /// Reading and preparation.
    pub report: FlankReport,
}

/// The traces of both flanks where one has several.
#[derive(Debug, Clone, PartialEq, Default)]
#[non_exhaustive]
pub struct SampledFlanks {
    /// Traces of pinion and wheel.
    pub traces: [Vec<SampledTrace>; 2],
    /// Teeth of pinion and wheel that the case names; more than are paired, where these are too many.
    pub named: [usize; 2],
}

impl SampledTrace {
    /// A trace with the record of its preparation.
    #[must_use]
    pub fn new(site: TraceSite, report: FlankReport) -> Self {
        Self {
            tooth: site.tooth,
            number: site.number,
            y: site.y,
            row: site.row,
            report,
        }
    }
}

impl SampledFlanks {
    /// The traces of both flanks, of which `named` teeth are named.
    #[must_use]
    pub fn new(traces: [Vec<SampledTrace>; 2], named: [usize; 2]) -> Self {
        Self { traces, named }
    }

    /// Every report, of the pinion first.
    pub fn reports(&self) -> impl Iterator<Item = &FlankReport> {
        self.traces.iter().flatten().map(|trace| &trace.report)
    }
}
