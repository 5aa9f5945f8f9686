//! Data of a merged study.

use std::collections::BTreeMap;

use serde::Serialize;

use super::columns::InputColumn;
use super::effects::{Effect, Indices};

/// Merged study.
#[derive(Debug, Clone, PartialEq, Serialize)]
#[non_exhaustive]
pub struct Merged {
    /// Name of the study.
    pub name: String,
    /// Hash of the study.
    pub study: String,
    /// Title of the case.
    pub title: String,
    /// Number of cases.
    pub cases: usize,
    /// Number of cases without a result.
    pub failed: usize,
    /// Number of cases by the code of a warning about inputs outside of their ranges.
    pub outside: BTreeMap<String, usize>,
    /// SHA-256 of the table.
    pub sha256: String,
    /// Effects of all inputs on each result.
    pub effects: Vec<EffectRow>,
    /// The inputs: axes, then sampled keys.
    #[serde(skip)]
    pub inputs: Vec<InputColumn>,
    /// Number of axes among the inputs.
    #[serde(skip)]
    pub axes: usize,
    /// Keys that the axes set to one value in all cases.
    #[serde(skip)]
    pub constant: Vec<(String, String)>,
    /// Operating point in words, without what an axis or the sample varies; empty if they vary all of it.
    #[serde(skip)]
    pub conditions: String,
    /// Columns of the results, each with its value in every case; NaN where a case has no result.
    #[serde(skip)]
    pub outputs: Vec<(String, Vec<f64>)>,
    /// The table.
    #[serde(skip)]
    pub table: Vec<u8>,
}

/// Effect of an input on a result.
#[derive(Debug, Clone, PartialEq, Serialize)]
#[non_exhaustive]
pub struct EffectRow {
    /// Column of the result.
    pub output: String,
    /// Key or name of the input, with the choice where it is one: `finish: superfinished`.
    pub input: String,
    /// Effect by the regression.
    pub effect: Option<Effect>,
    /// Sobol's indices, if the sample has blocks for them.
    pub indices: Option<Indices>,
}
