//! Keys of a study file.

use std::collections::BTreeMap;
use std::fmt;
use std::path::PathBuf;

use serde::de::{IgnoredAny, MapAccess, Visitor};
use serde::{Deserialize, Deserializer};
use toml::{Spanned, Value};

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
    pub choice: Option<AxisChoices>,
}

/// Settings of named choices, in the order of their text.
#[derive(Debug, Clone)]
pub(super) struct AxisChoices(pub Vec<(String, BTreeMap<String, Value>)>);

impl<'de> Deserialize<'de> for AxisChoices {
    fn deserialize<D: Deserializer<'de>>(from: D) -> Result<Self, D::Error> {
        from.deserialize_map(InOrder)
    }
}

struct InOrder;

impl<'de> Visitor<'de> for InOrder {
    type Value = AxisChoices;

    fn expecting(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str("tables of keys by the names of choices")
    }

    fn visit_map<A: MapAccess<'de>>(self, mut map: A) -> Result<AxisChoices, A::Error> {
        let mut found = Vec::new();
        while let Some(choice) = map.next_entry()? {
            found.push(choice);
        }
        Ok(AxisChoices(found))
    }
}

/// Where the choices of the axes stand in the text of a study: the reader of TOML returns them by name.
#[derive(Deserialize)]
struct Places {
    #[serde(default)]
    axis: Vec<PlacesOfAxis>,
}

#[derive(Deserialize)]
struct PlacesOfAxis {
    #[serde(default)]
    choice: BTreeMap<String, Spanned<IgnoredAny>>,
}

impl StudyInput {
    /// Reads the text of a study file.
    pub(crate) fn of_toml(text: &str) -> Result<Self, toml::de::Error> {
        let mut input: Self = toml::from_str(text)?;
        let places: Places = toml::from_str(text)?;
        for (axis, places) in input.axis.iter_mut().zip(&places.axis) {
            if let Some(AxisChoices(choices)) = &mut axis.choice {
                choices.sort_by_key(|(name, _)| places.choice.get(name).map(|at| at.span().start));
            }
        }
        Ok(input)
    }
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

#[cfg(test)]
mod tests {
    use super::{AxisChoices, StudyInput};

    #[test]
    fn choices_stay_in_the_order_of_the_text() -> Result<(), Box<dyn std::error::Error>> {
        let tables = "[[axis]]\nname = 'n'\n[[axis]]\nname = 'f'\n[axis.choice.z]\nk = 1\n[axis.choice.a]\nk = 2\n";
        let inline = "[[axis]]\nname = 'f'\nchoice.z.k = 1\nchoice.a = { k = 2 }\n";
        let whole = "[[axis]]\nname = 'f'\nchoice = { z = { k = 1 }, a = { k = 2 } }\n";
        let json = r#"{"axis": [{"name": "f", "choice": {"z": {"k": 1}, "a": {"k": 2}}}]}"#;
        for study in [
            StudyInput::of_toml(tables)?,
            StudyInput::of_toml(inline)?,
            StudyInput::of_toml(whole)?,
            serde_json::from_str(json)?,
        ] {
            let last = study.axis.last().and_then(|axis| axis.choice.as_ref());
            let Some(AxisChoices(choices)) = last else {
                return Err("no choices".into());
            };
            let names: Vec<_> = choices.iter().map(|(name, _)| name.as_str()).collect();
            assert_eq!(names, ["z", "a"]);
        }
        Ok(())
    }
}
