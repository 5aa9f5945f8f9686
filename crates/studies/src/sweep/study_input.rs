//! Keys of a study file.

use std::collections::BTreeMap;
use std::path::PathBuf;

use serde::Deserialize;
use toml::Value;

/// A study as its file has it.
#[derive(Debug, Clone, Deserialize)]
#[serde(deny_unknown_fields)]
pub(super) struct StudyInput {
    /// Case file, relative to the study; in memory the case is at hand.
    #[serde(default)]
    pub case: Option<PathBuf>,
    pub detail: Option<Detail>,
    pub columns: Option<Vec<String>>,
    #[serde(default)]
    pub axis: Vec<AxisInput>,
    pub sample: Option<SampleInput>,
}

/// What is computed of a case.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default, Deserialize)]
#[serde(rename_all = "kebab-case")]
pub(super) enum Detail {
    /// What the losses need.
    #[default]
    Losses,
    /// The rough contact at every offset besides.
    Contacts,
}

/// An axis: values of a key, or named choices of several keys.
#[derive(Debug, Clone, Deserialize)]
#[serde(deny_unknown_fields)]
pub(super) struct AxisInput {
    pub key: Option<String>,
    pub name: Option<String>,
    pub values: Option<Vec<Value>>,
    pub from: Option<Value>,
    pub to: Option<Value>,
    pub count: Option<usize>,
    pub spacing: Option<Spacing>,
    pub choice: Option<BTreeMap<String, BTreeMap<String, Value>>>,
}

/// Steps of an axis.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default, Deserialize)]
#[serde(rename_all = "kebab-case")]
pub(super) enum Spacing {
    /// Equal steps.
    #[default]
    Linear,
    /// Equal ratios.
    Log,
}

/// How the inputs are sampled.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Deserialize)]
#[serde(rename_all = "kebab-case")]
pub enum Method {
    /// Sobol's sequence, scrambled by the seed.
    Sobol,
    /// Each input evenly in layers, the layers of the inputs shuffled.
    LatinHypercube,
    /// Independent.
    Random,
    /// Rows of a table.
    List,
}

/// The sample.
#[derive(Debug, Clone, Deserialize)]
#[serde(deny_unknown_fields)]
pub(super) struct SampleInput {
    pub method: Method,
    pub count: Option<usize>,
    #[serde(default)]
    pub seed: u64,
    /// Whether the sample is one of Saltelli for Sobol's indices: count times the number of inputs plus two.
    #[serde(default)]
    pub indices: bool,
    #[serde(default)]
    pub vary: BTreeMap<String, Distribution>,
    /// Table of a list.
    pub file: Option<PathBuf>,
}

/// Distribution of an input.
#[derive(Debug, Clone, Deserialize)]
#[serde(rename_all = "kebab-case")]
pub(super) enum Distribution {
    /// Even from the first to the second.
    Uniform([Value; 2]),
    /// Even in the logarithm.
    LogUniform([Value; 2]),
    /// Mean and standard deviation.
    Normal([Value; 2]),
    /// Smallest, most likely, largest.
    Triangular([Value; 3]),
}
