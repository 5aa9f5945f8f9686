//! Data of a merged study.

use serde::Serialize;

use super::effects::{Effect, Indices};

/// Merged study.
#[derive(Debug, Clone, PartialEq, Serialize)]
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
    /// SHA-256 of the table.
    pub sha256: String,
    /// Effects of the sampled inputs on each result, averaged over the axes.
    pub effects: Vec<EffectRow>,
    /// The table.
    #[serde(skip)]
    pub table: Vec<u8>,
}

/// Effect of an input on a result.
#[derive(Debug, Clone, PartialEq, Serialize)]
pub struct EffectRow {
    /// Column of the result.
    pub output: String,
    /// Key of the input.
    pub input: String,
    /// Main effect.
    pub effect: Option<Effect>,
    /// Sobol's indices, if the sample has blocks for them.
    pub indices: Option<Indices>,
}
