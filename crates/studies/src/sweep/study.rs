//! The study file.

use std::collections::BTreeMap;
use std::path::{Path, PathBuf};

use asperity::case::{self, LoadedCase};
use asperity_storage::{whole_file, whole_text};
use serde::Deserialize;
use sha2::{Digest, Sha256};
use toml::Value;

use super::error::SweepError;

/// Name of a study that was not read from a file.
const IN_MEMORY: &str = "study";
/// Bytes of the largest study that is read, and of the largest table of one.
const LARGEST_STUDY: u64 = 10_000_000;
pub(super) const LARGEST_TABLE: u64 = 1_000_000_000;

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

/// A study with its case.
#[derive(Debug, Clone)]
pub struct Study {
    pub(super) input: StudyInput,
    /// The case of the study.
    pub case: LoadedCase,
    /// Name of the study, without folder and ending.
    pub name: String,
    /// First sixteen hexadecimal digits of the SHA-256 of study, case, traces and version of the program.
    pub hash: String,
    /// Folder of the study.
    pub folder: PathBuf,
}

impl Study {
    /// Reads the study in `file` and the case that it names.
    ///
    /// # Errors
    /// When either cannot be read.
    pub fn load(file: &Path) -> Result<Self, SweepError> {
        let text = whole_text(file, LARGEST_STUDY).map_err(|source| SweepError::Open {
            path: file.to_owned(),
            source,
        })?;
        let folder = file.parent().unwrap_or(Path::new("")).to_owned();
        let input: StudyInput = toml::from_str(&text).map_err(|error| SweepError::Study {
            path: file.to_owned(),
            message: error.to_string().trim().replace('\n', "; "),
        })?;
        let named = input.case.as_ref();
        let named = named.ok_or_else(|| SweepError::Study {
            path: file.to_owned(),
            message: "missing field `case`".to_owned(),
        })?;
        let case = case::load(&folder.join(named), None)?;
        let stem = file.file_stem().unwrap_or_default();
        let name = stem.to_string_lossy().into_owned();
        Self::of(input, &text.replace('\r', ""), case, (name, folder))
    }

    /// A study of `case` whose other keys are those of a study file, as the text of a JSON object; files that it names
    /// are relative to `folder`.
    ///
    /// # Errors
    /// When the text is no study, or a file cannot be read.
    pub fn of_case(case: LoadedCase, text: &str, folder: &Path) -> Result<Self, SweepError> {
        let input = serde_json::from_str(text).map_err(|error| SweepError::Study {
            path: IN_MEMORY.into(),
            message: error.to_string(),
        })?;
        let place = (IN_MEMORY.to_owned(), folder.to_owned());
        Self::of(input, text, case, place)
    }

    fn of(
        input: StudyInput,
        text: &str,
        case: LoadedCase,
        (name, folder): (String, PathBuf),
    ) -> Result<Self, SweepError> {
        let mut sum = Sha256::new();
        sum.update(text.as_bytes());
        if let Some(list) = input
            .sample
            .as_ref()
            .and_then(|sample| sample.file.as_ref())
        {
            let path = folder.join(list);
            let bytes = whole_file(&path, LARGEST_TABLE)
                .map_err(|source| SweepError::Open { path, source })?;
            sum.update(bytes);
        }
        sum.update(identity(&case)?.as_bytes());
        Ok(Self {
            input,
            case,
            name,
            hash: short(sum),
            folder,
        })
    }
}

/// All that decides a result: the case as canonical JSON, the sums of its traces, the version of the program.
pub(super) fn identity(case: &LoadedCase) -> Result<String, SweepError> {
    let refused = |error: serde_json::Error| SweepError::key("case", error.to_string());
    // Keys of a value are sorted.
    let value = serde_json::to_value(&case.case.input).map_err(refused)?;
    let mut text = serde_json::to_string(&value).map_err(refused)?;
    for flank in case.all_traces() {
        text.push('\n');
        text.push_str(flank.sha256.as_deref().unwrap_or_default());
    }
    text.push('\n');
    text.push_str(env!("CARGO_PKG_VERSION"));
    Ok(text)
}

/// The first sixteen hexadecimal digits of a sum.
pub(super) fn short(sum: Sha256) -> String {
    let hex: String = sum
        .finalize()
        .iter()
        .map(|byte| format!("{byte:02x}"))
        .collect();
    hex[..16].to_owned()
}
