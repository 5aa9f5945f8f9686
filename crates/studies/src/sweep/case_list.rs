//! The cases of a study by their numbers.

use asperity::case::LoadedCase;
use asperity_core::numerics::standard_normal_quantile;
use toml::Value;

use super::amount::{Amount, text_of};
use super::axes::{Axes, MOST_POINTS};
use super::draws::{DIMENSIONS, Draws, LONGEST};
use super::error::SweepError;
use super::settings::{Settings, set};
use super::study::Study;
use super::study_input::{Distribution, Method, SampleInput};

/// Digits of the fingerprint of a case in its row.
const ID: usize = 16;
/// Most cases of a study, whose numbers are held in memory.
const MOST_CASES: f64 = 1e7;

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

/// Every case of a study.
#[derive(Debug, Clone)]
pub(super) struct CaseList {
    axes: Axes,
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
        let sample = match &study.input.sample {
            None => Sample::One,
            Some(given) if given.method == Method::List => list(study)?,
            Some(given) => drawn(given)?,
        };
        let list = Self {
            axes: study.axes.clone(),
            sample,
        };
        let cases = list
            .axes
            .lengths()
            .map(|length| length as f64)
            .product::<f64>();
        let cases = cases * list.samples() as f64;
        match cases <= MOST_CASES {
            true => Ok(list),
            false => Err(SweepError::key(
                "axis",
                format!("{cases:.0} cases are more than {MOST_CASES:.0}: use fewer values"),
            )),
        }
    }

    pub(super) fn count(&self) -> usize {
        self.per_sample() * self.samples()
    }

    /// Points of the crossed axes.
    pub(super) fn per_sample(&self) -> usize {
        self.axes.count()
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
        let axes = self.axes.names().map(str::to_owned);
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
        let mut place = Place {
            columns: Vec::new(),
            settings: Vec::new(),
        };
        for (text, settings) in self.axes.at(number / self.samples()) {
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

fn drawn(given: &SampleInput) -> Result<Sample, SweepError> {
    let count = given.count.unwrap_or_default();
    if !(1..=MOST_POINTS).contains(&count) || given.vary.is_empty() {
        let rule = "needs a count from 1 to 1000000 and at least one key to vary";
        return Err(SweepError::key("sample", rule));
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
fn list(study: &Study) -> Result<Sample, SweepError> {
    let table = study.table.as_deref();
    let table = table.ok_or_else(|| SweepError::key("sample.file", "a list needs its table"))?;
    let refused = |error: csv::Error| SweepError::key("sample.file", error.to_string());
    let mut reader = csv::ReaderBuilder::new()
        .comment(Some(b'#'))
        .trim(csv::Trim::All)
        .from_reader(table);
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
pub(super) fn resolved(study: &Study, place: &Place) -> Result<(LoadedCase, String), SweepError> {
    let base = &study.case;
    let mut input = base.case.input.clone();
    for (key, value) in &place.settings {
        set(&mut input, &base.case.defaults, key, value)?;
    }
    let case = base.with(|now| *now = input)?;
    // The rows of a study are of one content of every file.
    for (name, sum) in case.files_read() {
        if study.sums.get(&name) != Some(&sum) {
            return Err(SweepError::Changed { file: name });
        }
    }
    let id = case.fingerprint()[..ID].to_owned();
    Ok((case, id))
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
