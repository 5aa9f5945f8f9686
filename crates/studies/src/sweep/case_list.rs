//! The cases of a study by their numbers.

use asperity::case::{CaseInput, DefaultUsed, LoadedCase};
use asperity_core::numerics::standard_normal_quantile;
use asperity_storage::whole_file;
use sha2::{Digest, Sha256};
use toml::Value;

use super::amount::{Amount, text_of, written};
use super::draws::{DIMENSIONS, Draws, LONGEST};
use super::error::SweepError;
use super::study::{
    AxisInput, Distribution, LARGEST_TABLE, Method, SampleInput, Spacing, Study, identity, short,
};

/// Keys and the values that they are set to.
pub(super) type Settings = Vec<(String, String)>;

/// A crossed axis.
#[derive(Debug, Clone)]
struct Axis {
    /// Column of the table.
    name: String,
    /// Text of the column and what is set, node by node.
    nodes: Vec<(String, Settings)>,
}

/// An input that is sampled.
#[derive(Debug, Clone)]
struct Varied {
    key: String,
    unit: String,
    law: Law,
}

#[derive(Debug, Clone, Copy)]
enum Law {
    Uniform([f64; 2]),
    LogUniform([f64; 2]),
    Normal([f64; 2]),
    Triangular([f64; 3]),
}

impl Law {
    /// The value below which a share `u` of the distribution lies.
    fn quantile(self, u: f64) -> f64 {
        match self {
            Self::Uniform([a, b]) => a + (b - a) * u,
            Self::LogUniform([a, b]) => a * (b / a).powf(u),
            Self::Normal([mean, deviation]) => mean + deviation * standard_normal_quantile(u),
            Self::Triangular([a, m, b]) => {
                let left = (m - a) / (b - a);
                match u < left {
                    true => a + (u * (b - a) * (m - a)).sqrt(),
                    false => b - ((1.0 - u) * (b - a) * (b - m)).sqrt(),
                }
            }
        }
    }
}

/// The sample of a study.
#[derive(Debug, Clone)]
enum Sample {
    /// The case alone.
    One,
    /// Drawn.
    Drawn {
        inputs: Vec<Varied>,
        draws: Draws,
        count: usize,
        /// A sample of Saltelli: blocks A, B and A with one input of B.
        has_blocks: bool,
    },
    /// Rows of a table.
    Rows {
        keys: Vec<(String, String)>,
        rows: Vec<Vec<f64>>,
    },
}

/// Most cases of a study.
const MOST_CASES: usize = 10_000_000;

fn too_many() -> String {
    format!("a study has at most {MOST_CASES} cases; leave out axes or points")
}

/// Every case of a study.
#[derive(Debug, Clone)]
pub(super) struct CaseList {
    axes: Vec<Axis>,
    sample: Sample,
}

/// A case of a study before it is resolved.
#[derive(Debug, Clone)]
pub(super) struct Place {
    /// Text of every column of the inputs.
    pub columns: Vec<String>,
    pub settings: Settings,
}

impl CaseList {
    pub(super) fn of(study: &Study) -> Result<Self, SweepError> {
        let axes = study
            .input
            .axis
            .iter()
            .map(axis)
            .collect::<Result<_, _>>()?;
        let sample = match &study.input.sample {
            None => Sample::One,
            Some(given) if given.method == Method::List => list(study, given)?,
            Some(given) => drawn(given)?,
        };
        let list = Self { axes, sample };
        match list.count_within(MOST_CASES) {
            true => Ok(list),
            false => Err(SweepError::key("axis", too_many())),
        }
    }

    /// Whether there are at most so many cases: the numbers of axes and sample are not multiplied before.
    fn count_within(&self, most: usize) -> bool {
        let points = self
            .axes
            .iter()
            .try_fold(1_usize, |points, axis| points.checked_mul(axis.nodes.len()));
        let cases = points.and_then(|points| points.checked_mul(self.samples()));
        cases.is_some_and(|cases| cases <= most)
    }

    pub(super) fn count(&self) -> usize {
        self.per_sample() * self.samples()
    }

    /// Points of the crossed axes.
    pub(super) fn per_sample(&self) -> usize {
        self.axes.iter().map(|axis| axis.nodes.len()).product()
    }

    /// Points of the sample.
    pub(super) fn samples(&self) -> usize {
        match &self.sample {
            Sample::One => 1,
            Sample::Drawn {
                inputs,
                count,
                has_blocks,
                ..
            } => count * if *has_blocks { inputs.len() + 2 } else { 1 },
            Sample::Rows { rows, .. } => rows.len(),
        }
    }

    /// Points of a block of the sample, where it has blocks for Sobol's indices.
    pub(super) fn block(&self) -> Option<usize> {
        match &self.sample {
            Sample::Drawn {
                count,
                has_blocks: true,
                ..
            } => Some(*count),
            _ => None,
        }
    }

    /// Columns of the inputs: axes, then what is sampled.
    pub(super) fn columns(&self) -> Vec<String> {
        let axes = self.axes.iter().map(|axis| axis.name.clone());
        axes.chain(self.sampled()).collect()
    }

    /// Keys that are sampled.
    pub(super) fn sampled(&self) -> Vec<String> {
        match &self.sample {
            Sample::One => Vec::new(),
            Sample::Drawn { inputs, .. } => inputs.iter().map(|input| input.key.clone()).collect(),
            Sample::Rows { keys, .. } => keys.iter().map(|(key, _)| key.clone()).collect(),
        }
    }

    /// The sampled numbers of a case.
    pub(super) fn numbers(&self, number: usize) -> Vec<f64> {
        let point = number % self.samples();
        match &self.sample {
            Sample::One => Vec::new(),
            Sample::Rows { rows, .. } => rows[point].clone(),
            Sample::Drawn {
                inputs,
                draws,
                count,
                has_blocks,
            } => {
                let (block, point) = (point / count, point % count);
                let value = |(index, input): (usize, &Varied)| {
                    // A takes the first numbers, B the others; block 2 + i is A with input i of B.
                    let of_b = *has_blocks && (block == 1 || block == index + 2);
                    let dimension = if of_b { inputs.len() + index } else { index };
                    input.law.quantile(draws.at(point, dimension))
                };
                inputs.iter().enumerate().map(value).collect()
            }
        }
    }

    /// What is set in a case, by its number: row-major in the axes, then the sample.
    pub(super) fn place(&self, number: usize) -> Place {
        let mut rest = number / self.samples();
        let mut chosen = vec![0; self.axes.len()];
        for (index, axis) in self.axes.iter().enumerate().rev() {
            chosen[index] = rest % axis.nodes.len();
            rest /= axis.nodes.len();
        }
        let mut place = Place {
            columns: Vec::new(),
            settings: Vec::new(),
        };
        for (axis, node) in self.axes.iter().zip(chosen) {
            let (text, settings) = &axis.nodes[node];
            place.columns.push(text.clone());
            place.settings.extend(settings.iter().cloned());
        }
        let units: Vec<&str> = match &self.sample {
            Sample::One => Vec::new(),
            Sample::Drawn { inputs, .. } => {
                inputs.iter().map(|input| input.unit.as_str()).collect()
            }
            Sample::Rows { keys, .. } => keys.iter().map(|(_, unit)| unit.as_str()).collect(),
        };
        let values = self.numbers(number).into_iter().zip(units);
        for (key, (value, unit)) in self.sampled().into_iter().zip(values) {
            let text = text_of(value, unit);
            place.columns.push(text.clone());
            place.settings.push((key, text));
        }
        place
    }
}

fn axis(input: &AxisInput) -> Result<Axis, SweepError> {
    let name = input.name.clone().or_else(|| input.key.clone());
    let name =
        name.ok_or_else(|| SweepError::key("axis", "needs a key, or a name with choices"))?;
    if let Some(choices) = &input.choice {
        let node = |(name, keys): (&String, &std::collections::BTreeMap<String, Value>)| {
            let settings = keys
                .iter()
                .map(|(key, value)| (key.clone(), written(value)));
            (name.clone(), settings.collect())
        };
        let nodes: Vec<_> = choices.iter().map(node).collect();
        return some(name, nodes);
    }
    let key = input.key.clone();
    let key = key.ok_or_else(|| SweepError::key(&name, "needs a key, or choices"))?;
    let node = |text: String| (text.clone(), vec![(key.clone(), text)]);
    if let Some(values) = &input.values {
        return some(name, values.iter().map(written).map(node).collect());
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
    if count < 2 || (spacing == Spacing::Log && !(from > 0.0 && to > 0.0)) {
        let rule = "needs a count of at least 2, and positive ends for log";
        return Err(SweepError::key(&name, rule));
    }
    if count > MOST_CASES {
        return Err(SweepError::key(&name, too_many()));
    }
    let value = |k: usize| {
        let share = k as f64 / (count - 1) as f64;
        match spacing {
            _ if k == 0 => from,
            _ if k + 1 == count => to,
            Spacing::Linear => from + (to - from) * share,
            Spacing::Log => from * (to / from).powf(share),
        }
    };
    some(
        name,
        (0..count).map(|k| node(text_of(value(k), &unit))).collect(),
    )
}

fn some(name: String, nodes: Vec<(String, Settings)>) -> Result<Axis, SweepError> {
    match nodes.is_empty() {
        true => Err(SweepError::key(&name, "has no values")),
        false => Ok(Axis { name, nodes }),
    }
}

fn drawn(given: &SampleInput) -> Result<Sample, SweepError> {
    let count = given.count.unwrap_or_default();
    if count == 0 || given.vary.is_empty() {
        let rule = "needs a count and at least one key to vary";
        return Err(SweepError::key("sample", rule));
    }
    if count > MOST_CASES {
        return Err(SweepError::key("sample.count", too_many()));
    }
    let inputs = given
        .vary
        .iter()
        .map(|(key, distribution)| varied(key, distribution))
        .collect::<Result<Vec<_>, _>>()?;
    let dimensions = inputs.len() * if given.indices { 2 } else { 1 };
    if given.method == Method::Sobol && (count > LONGEST || dimensions > DIMENSIONS) {
        let rule = format!("Sobol's sequence has {LONGEST} points of {DIMENSIONS} numbers at most");
        return Err(SweepError::key("sample.count", rule));
    }
    Ok(Sample::Drawn {
        draws: Draws::new(given.method, count, dimensions, given.seed),
        inputs,
        count,
        has_blocks: given.indices,
    })
}

fn varied(key: &str, distribution: &Distribution) -> Result<Varied, SweepError> {
    let named = format!("sample.vary.{key}");
    let values: &[Value] = match distribution {
        Distribution::Uniform(values)
        | Distribution::LogUniform(values)
        | Distribution::Normal(values) => values,
        Distribution::Triangular(values) => values,
    };
    let (numbers, unit) = Amount::list(&named, values)?;
    let law = match (distribution, numbers.as_slice()) {
        (Distribution::Uniform(_), &[a, b]) if a < b => Some(Law::Uniform([a, b])),
        (Distribution::LogUniform(_), &[a, b]) if 0.0 < a && a < b => Some(Law::LogUniform([a, b])),
        (Distribution::Normal(_), &[mean, deviation]) if deviation > 0.0 => {
            Some(Law::Normal([mean, deviation]))
        }
        (Distribution::Triangular(_), &[a, m, b]) if a <= m && m <= b && a < b => {
            Some(Law::Triangular([a, m, b]))
        }
        _ => None,
    };
    let rule =
        "the numbers must rise, those of log-uniform and the deviation of normal be positive";
    let law = law.ok_or_else(|| SweepError::key(&named, rule))?;
    Ok(Varied {
        key: key.to_owned(),
        unit,
        law,
    })
}

/// The rows of a table whose header has a key each, with its unit in brackets: `operation.torque [N m]`.
fn list(study: &Study, given: &SampleInput) -> Result<Sample, SweepError> {
    let file = given.file.as_ref();
    let file = file.ok_or_else(|| SweepError::key("sample.file", "a list needs its table"))?;
    let path = study.folder.join(file);
    let refused = |error: csv::Error| SweepError::key("sample.file", error.to_string());
    let table = whole_file(&path, LARGEST_TABLE).map_err(|error| refused(error.into()))?;
    let mut reader = csv::ReaderBuilder::new()
        .comment(Some(b'#'))
        .trim(csv::Trim::All)
        .from_reader(table.as_slice());
    let header = reader.headers().map_err(refused)?;
    let keys: Vec<(String, String)> = header
        .iter()
        .map(|name| match name.split_once('[') {
            Some((key, unit)) => (
                key.trim().to_owned(),
                unit.trim_end_matches(']').trim().to_owned(),
            ),
            None => (name.to_owned(), String::new()),
        })
        .collect();
    let mut rows = Vec::new();
    for (index, record) in reader.records().enumerate() {
        let record = record.map_err(refused)?;
        let numbers = record.iter().map(|text| {
            let number = text.parse().ok().filter(|value: &f64| value.is_finite());
            let rule = format!("row {}: {text:?} is no finite number", index + 1);
            number.ok_or_else(|| SweepError::key("sample.file", rule))
        });
        rows.push(numbers.collect::<Result<Vec<f64>, _>>()?);
    }
    match rows.is_empty() {
        true => Err(SweepError::key("sample.file", "the table has no rows")),
        false => Ok(Sample::Rows { keys, rows }),
    }
}

/// The case of a study at a place of it, with its id.
pub(super) fn resolved(
    base: &LoadedCase,
    place: &Place,
) -> Result<(LoadedCase, String), SweepError> {
    let mut input = base.case.input.clone();
    for (key, value) in &place.settings {
        set(&mut input, &base.case.defaults, key, value)?;
    }
    let case = base.with(|now| *now = input)?;
    let mut sum = Sha256::new();
    sum.update(identity(&case)?.as_bytes());
    let id = short(sum);
    Ok((case, id))
}

/// Sets a key of the case; a number at its end is the place in a list, `gears.profile_shift.0`, which the case gives
/// or has by default.
fn set(
    input: &mut CaseInput,
    defaults: &[DefaultUsed],
    key: &str,
    value: &str,
) -> Result<(), SweepError> {
    let of_list = key
        .rsplit_once('.')
        .and_then(|(list, index)| Some((list, index.parse::<usize>().ok()?)));
    let Some((list, index)) = of_list else {
        return Ok(input.set(key, value)?);
    };
    let as_text = |error: &dyn std::fmt::Display| SweepError::key(key, error.to_string());
    let root = Value::try_from(&*input).map_err(|error| as_text(&error))?;
    let found = list
        .split('.')
        .try_fold(&root, |table, part| table.get(part));
    let by_default = || {
        let default = defaults.iter().find(|default| default.key == list)?;
        let values: Vec<f64> = serde_json::from_str(&default.value).ok()?;
        Some(values.into_iter().map(Value::Float).collect())
    };
    let given = match found {
        Some(Value::Array(values)) => Some(values.clone()),
        _ => by_default(),
    };
    let none = || SweepError::key(key, "is no list of the case");
    let mut values = given.ok_or_else(none)?;
    let Some(entry) = values.get_mut(index) else {
        return Err(SweepError::key(key, "is beyond the end of the list"));
    };
    *entry = match (entry.is_str(), value.parse::<f64>()) {
        (false, Ok(number)) => Value::Float(number),
        _ => Value::String(value.to_owned()),
    };
    Ok(input.set(list, &Value::Array(values).to_string())?)
}

/// The key of a case without what its contact tables do not depend on, so that cases can share them.
pub(super) fn key_of_tables(case: &LoadedCase) -> Option<String> {
    let mut input = serde_json::to_value(&case.case.input).ok()?;
    let root = input.as_object_mut()?;
    root.remove("lubricant");
    root.remove("title");
    let operation = root.get_mut("operation")?.as_object_mut()?;
    operation.remove("speed");
    operation.remove("temperature");
    if let Some(model) = root
        .get_mut("model")
        .and_then(|model| model.as_object_mut())
    {
        for key in [
            "boundary_friction",
            "boundary_layer",
            "friction_scale",
            "spot_speed",
            "asperity_share_factor",
            "hysteresis",
        ] {
            model.remove(key);
        }
    }
    serde_json::to_string(&input).ok()
}
