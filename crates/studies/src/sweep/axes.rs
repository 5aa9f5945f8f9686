//! The crossed axes of a study.

use std::collections::{BTreeSet, HashSet};

use asperity::case::train::Train;
use asperity::case::{FILE_KEYS, FileSums};
use asperity_report::axis::{range, with_unit};

use super::amount::{Amount, text_of, written};
use super::error::SweepError;
use super::settings::{Settings, set};
use super::study_input::{AxisInput, Nodes, Spacing, StudyInput};

/// Largest number of points of an axis or a sample, which are stored in memory.
pub(super) const MOST_POINTS: usize = 1_000_000;

/// Crossed axis.
#[derive(Debug, Clone)]
struct CrossedAxis {
    /// Column of the table.
    name: String,
    /// Text of the column and settings of each node.
    nodes: Vec<(String, Settings)>,
}

/// The crossed axes of a study.
#[derive(Debug, Clone)]
pub(super) struct SweepAxes(Vec<CrossedAxis>);

impl SweepAxes {
    pub(super) fn from_input(study: &StudyInput) -> Result<Self, SweepError> {
        Ok(Self(study.axis.iter().map(axis).collect::<Result<_, _>>()?))
    }

    /// Number of points of the axes.
    pub(super) fn count(&self) -> usize {
        self.lengths().product()
    }

    /// Number of points of each axis.
    pub(super) fn lengths(&self) -> impl Iterator<Item = usize> {
        self.0.iter().map(|axis| axis.nodes.len())
    }

    /// Columns of the axes.
    pub(super) fn names(&self) -> impl Iterator<Item = &str> {
        self.0.iter().map(|axis| axis.name.as_str())
    }

    /// Column and text of each node, of every axis.
    pub(super) fn texts(&self) -> Vec<(String, Vec<String>)> {
        let texts = |axis: &CrossedAxis| axis.nodes.iter().map(|(text, _)| text.clone()).collect();
        let axes = self.0.iter().map(|axis| (axis.name.clone(), texts(axis)));
        axes.collect()
    }

    /// Keys that each axis sets.
    pub(super) fn keys(&self) -> impl Iterator<Item = BTreeSet<&str>> {
        self.0
            .iter()
            .map(|axis| axis.settings().map(|(key, _)| key.as_str()).collect())
    }

    /// Keys and values of all nodes of all axes.
    pub(super) fn settings(&self) -> impl Iterator<Item = &(String, String)> {
        self.0.iter().flat_map(CrossedAxis::settings)
    }

    /// Keys that an axis sets to one value in all cases.
    pub(super) fn constant(&self) -> Vec<(String, String)> {
        self.0.iter().flat_map(CrossedAxis::constant).collect()
    }

    /// Text and settings of each axis at the point `number`, in row-major order.
    pub(super) fn at(&self, number: usize) -> impl Iterator<Item = &(String, Settings)> {
        let mut remainder = number;
        let mut chosen = vec![0; self.0.len()];
        for (index, axis) in self.0.iter().enumerate().rev() {
            chosen[index] = remainder % axis.nodes.len();
            remainder /= axis.nodes.len();
        }
        let axes = self.0.iter().zip(chosen);
        axes.map(|(axis, node)| &axis.nodes[node])
    }

    /// Settings of the nodes of the axes that name files.
    pub(super) fn naming_files(&self) -> impl Iterator<Item = &Settings> {
        let axes = self.0.iter().filter(|axis| axis.names_files());
        axes.flat_map(|axis| axis.nodes.iter().map(|(_, settings)| settings))
    }

    /// Hashes of the files that `case` reads at any point of the axes.
    pub(super) fn files(&self, case: &Train) -> FileSums {
        let mut inputs = vec![case.input.clone()];
        for axis in self.0.iter().filter(|axis| axis.names_files()) {
            let crossed = inputs.iter().flat_map(|input| {
                axis.nodes.iter().map(|(_, settings)| {
                    let mut input = input.clone();
                    for (key, value) in settings {
                        // A key that cannot be set is an error of its cases, which then read no files.
                        let _ = set(&mut input, &case.defaults, key, value);
                    }
                    input
                })
            });
            inputs = crossed.collect();
        }
        case.files_of(&inputs)
    }
}

impl CrossedAxis {
    /// Keys and values of all nodes.
    fn settings(&self) -> impl Iterator<Item = &(String, String)> {
        self.nodes.iter().flat_map(|(_, settings)| settings)
    }

    /// Keys that every node sets to the same value.
    fn constant(&self) -> Vec<(String, String)> {
        let mut nodes = self.nodes.iter().map(|(_, settings)| settings);
        let first = nodes.next().into_iter().flatten();
        let of_all = first.filter(|setting| nodes.clone().all(|node| node.contains(setting)));
        of_all.cloned().collect()
    }

    /// Whether the axis sets a key that names files, or a part or a parent of such a key.
    fn names_files(&self) -> bool {
        let is_within = |part: &str, whole: &str| {
            part.strip_prefix(whole)
                .is_some_and(|rest| rest.is_empty() || rest.starts_with('.'))
        };
        let names_files = |key: &str| {
            let key = &*key_of_pair(key);
            let mut keys = FILE_KEYS.iter().chain([&"gearbox.tables"]);
            keys.any(|file| is_within(file, key) || is_within(key, file))
        };
        self.settings()
            .map(|(key, _)| key.as_str())
            .any(names_files)
    }
}

/// The key of a pair of gears for a key of a mesh of a gear train, or of sun, planet and ring.
fn key_of_pair(key: &str) -> String {
    let of_mesh = match key.strip_prefix("mesh.") {
        None => key,
        // A whole mesh has its flanks.
        Some(rest) => rest.split_once('.').map_or("surface", |(_, key)| key),
    };
    let gear = |part| match part {
        "sun" | "planet" => "pinion",
        "ring" => "wheel",
        part => part,
    };
    of_mesh.split('.').map(gear).collect::<Vec<_>>().join(".")
}

fn axis(input: &AxisInput) -> Result<CrossedAxis, SweepError> {
    let name = input.name.clone().or_else(|| input.key.clone());
    let name =
        name.ok_or_else(|| SweepError::key("axis", "needs a key, or a name with choices"))?;
    if let Some(choices) = &input.choice {
        let nodes = choices.0.iter().map(|(name, keys)| {
            let settings = keys
                .iter()
                .map(|(key, value)| (key.clone(), written(value)));
            (name.clone(), settings.collect())
        });
        return some(name, nodes.collect());
    }
    let key = input.key.clone();
    let key = key.ok_or_else(|| SweepError::key(&name, "needs a key, or choices"))?;
    let node = |text: String| (text.clone(), vec![(key.clone(), text)]);
    match &input.values {
        None => {}
        Some(Nodes::Each(values)) => {
            return some(name, values.iter().map(written).map(node).collect());
        }
        Some(Nodes::Text(text)) => {
            let nodes = with_unit(text);
            let (values, unit) = nodes.map_err(|fault| SweepError::key(&name, fault.message()))?;
            let texts = values.into_iter().map(|value| text_of(value, unit));
            return some(name, texts.map(node).collect());
        }
    }
    let (Some(from), Some(to), Some(count)) = (&input.from, &input.to, input.count) else {
        return Err(SweepError::key(
            &name,
            "needs values, or from, to and count",
        ));
    };
    let (ends, unit) = Amount::list(&name, &[from.clone(), to.clone()])?;
    let [from, to] = [ends[0], ends[1]];
    let spacing = input.spacing.unwrap_or_default();
    if !(2..=MOST_POINTS).contains(&count) || (spacing == Spacing::Log && !(from > 0.0 && to > 0.0))
    {
        let rule = "needs a count from 2 to 1000000, and positive ends for log";
        return Err(SweepError::key(&name, rule));
    }
    let values = range(from, to, count, spacing == Spacing::Log);
    let node = |value| node(text_of(value, &unit));
    some(name, values.into_iter().map(node).collect())
}

/// The axis of these nodes; a value that is stated twice counts once, as in a map.
fn some(name: String, nodes: Vec<(String, Settings)>) -> Result<CrossedAxis, SweepError> {
    let plain = |text: &str| match Amount::read(&name, &toml::Value::from(text)) {
        Ok(amount) => text_of(amount.value, &amount.unit),
        Err(_) => text.to_owned(),
    };
    let mut seen = HashSet::new();
    let is_new = |(text, settings): &(String, Settings)| {
        let values = settings
            .iter()
            .map(|(key, value)| (key.clone(), plain(value)));
        seen.insert((plain(text), values.collect::<Vec<_>>()))
    };
    let nodes: Vec<(String, Settings)> = nodes.into_iter().filter(is_new).collect();
    if nodes.is_empty() {
        Err(SweepError::key(&name, "has no values"))
    } else {
        Ok(CrossedAxis { name, nodes })
    }
}

#[cfg(test)]
mod tests {
    use super::{key_of_pair, some};

    #[test]
    fn a_value_that_is_stated_twice_counts_once() {
        let node = |text: &str| {
            let setting = ("operation.bulk_temperature".to_owned(), text.to_owned());
            (text.to_owned(), vec![setting])
        };
        let texts = ["90 °C", "100 °C", "90.0 °C", "100 °C"];
        let axis = some("temperature".to_owned(), texts.map(node).to_vec()).unwrap();
        let left: Vec<&str> = axis.nodes.iter().map(|(text, _)| text.as_str()).collect();
        assert_eq!(left, ["90 °C", "100 °C"]);
    }

    #[test]
    fn keys_of_meshes_are_read_as_keys_of_a_pair() {
        for (key, of_pair) in [
            ("surface.pinion.file", "surface.pinion.file"),
            ("mesh.first.surface.wheel.file", "surface.wheel.file"),
            ("surface.planet.traces", "surface.pinion.traces"),
            ("mesh.set.surface.ring", "surface.wheel"),
            ("mesh.first", "surface"),
            ("operation.torque", "operation.torque"),
        ] {
            assert_eq!(key_of_pair(key), of_pair);
        }
    }
}
