//! Keys of a study file.

use std::collections::BTreeMap;
use std::path::PathBuf;

use serde::Deserialize;
use toml::Value;

/// Keys of a study.
#[derive(Debug, Clone, Deserialize)]
#[serde(deny_unknown_fields)]
pub(super) struct StudyInput {
    /// Case file, relative to the study; not used for a case in memory.
    #[serde(default)]
    pub case: Option<PathBuf>,
    /// Single mesh of a gear train that the study is of.
    pub mesh: Option<String>,
    pub detail: Option<Detail>,
    pub columns: Option<Vec<String>>,
    #[serde(default)]
    pub axis: Vec<AxisInput>,
    pub sample: Option<SampleInput>,
}

/// Extent of the computation of a case.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default, Deserialize)]
#[serde(rename_all = "kebab-case")]
pub(super) enum Detail {
    /// Only the losses.
    #[default]
    Losses,
    /// Also the rough contact at every offset.
    Contacts,
}

/// Axis: values of a key, or named choices of several keys.
#[derive(Debug, Clone, Deserialize)]
#[serde(deny_unknown_fields)]
pub(super) struct AxisInput {
    pub key: Option<String>,
    pub name: Option<String>,
    pub values: Option<Nodes>,
    pub from: Option<Value>,
    pub to: Option<Value>,
    pub count: Option<usize>,
    pub spacing: Option<Spacing>,
    pub choice: Option<BTreeMap<String, BTreeMap<String, Value>>>,
}

/// Values of an axis.
#[derive(Debug, Clone, Deserialize)]
#[serde(untagged)]
pub(super) enum Nodes {
    /// Each value.
    Each(Vec<Value>),
    /// Text with their unit, `10..100:5 N m`.
    Text(String),
}

/// Spacing of an axis.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default, Deserialize)]
#[serde(rename_all = "kebab-case")]
pub(super) enum Spacing {
    /// Equal steps.
    #[default]
    Linear,
    /// Equal ratios.
    Log,
}

/// Sampling method.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Deserialize)]
#[serde(rename_all = "kebab-case")]
pub enum Method {
    /// Sobol's sequence, scrambled by the seed.
    Sobol,
    /// Latin hypercube: one point in each layer of each input, layers permuted.
    LatinHypercube,
    /// Independent random numbers.
    Random,
    /// Rows of a table.
    List,
}

/// Sample of a study.
#[derive(Debug, Clone, Deserialize)]
#[serde(deny_unknown_fields)]
pub(super) struct SampleInput {
    pub method: Method,
    pub count: Option<usize>,
    #[serde(default)]
    pub seed: u64,
    /// Whether the sample is a sample of Saltelli for Sobol's indices: count times the number of inputs plus two.
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
    /// Uniform between the two values.
    Uniform([Value; 2]),
    /// Uniform in the logarithm.
    LogUniform([Value; 2]),
    /// Mean and standard deviation.
    Normal([Value; 2]),
    /// Smallest, most likely, largest.
    Triangular([Value; 3]),
}
