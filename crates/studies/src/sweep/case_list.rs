//! The cases of a study by number.

use std::collections::BTreeSet;
use std::path::Path;

use asperity::case::train::Train;
use asperity::core::nearest_name;
use asperity::oil::library_oil;
use asperity::profile_io::read::table_text;
use asperity_core::numerics::standard_normal_quantile;
use asperity_core::{Code, Fault};
use asperity_table::Table;
use toml::Value;

use super::amount::{Amount, text_of};
use super::axes::{MOST_POINTS, SweepAxes};
use super::draws::{DIMENSIONS, Draws, LONGEST};
use super::error::SweepError;
use super::known_columns::known_columns;
use super::settings::{Settings, set, set_all};
use super::study::Study;
use super::study_input::{Distribution, Method, SampleInput};

/// Key of the oil of the library.
const OIL: &str = "lubricant.oil";
/// Number of digits of the fingerprint of a case in its row.
const ID: usize = 16;
/// Number of axes of which both ends are combined with those of the others.
const MOST_CROSSED: usize = 16;
/// Largest number of cases of a study, whose numbers are stored in memory.
const MOST_CASES: f64 = 1e7;

/// Sampled input.
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
    /// Quantile `u` of the distribution.
    fn quantile(self, u: f64) -> f64 {
        match self {
            Self::Uniform([a, b]) => a + (b - a) * u,
            Self::LogUniform([a, b]) => a * (b / a).powf(u),
            Self::Normal([mean, deviation]) => mean + deviation * standard_normal_quantile(u),
            Self::Triangular([a, m, b]) => {
                let left = (m - a) / (b - a);
                if u < left {
                    a + (u * (b - a) * (m - a)).sqrt()
                } else {
                    b - ((1.0 - u) * (b - a) * (b - m)).sqrt()
                }
            }
        }
    }
}

/// Sample of a study.
#[derive(Debug, Clone)]
enum Sample {
    /// No sample: only the case.
    One,
    /// Random or quasi-random sample.
    Drawn {
        inputs: Vec<Varied>,
        draws: Draws,
        count: usize,
        /// Sample of Saltelli: blocks A, B, and A with one input from B each.
        has_blocks: bool,
    },
    /// Rows of a table.
    Rows {
        keys: Vec<(String, String)>,
        rows: Vec<Vec<f64>>,
    },
}

/// All cases of a study.
#[derive(Debug, Clone)]
pub(super) struct CaseList {
    axes: SweepAxes,
    sample: Sample,
}

/// Inputs of a case of a study.
#[derive(Debug, Clone)]
pub(super) struct CaseInputs {
    /// Text of all input columns.
    pub columns: Vec<String>,
    pub settings: Settings,
}

impl CaseList {
    pub(super) fn new(study: &Study) -> Result<Self, SweepError> {
        let sample = match &study.input.sample {
            None => Sample::One,
            Some(input) if input.method == Method::List => list(study)?,
            Some(input) => drawn(input)?,
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
        if cases <= MOST_CASES {
            list.check_keys()?;
            list.check_known(study)?;
            Ok(list)
        } else {
            Err(SweepError::key(
                "axis",
                format!("{cases:.0} cases are more than {MOST_CASES:.0}: use fewer values"),
            ))
        }
    }

    /// Every key has its values from a single axis or the sample.
    fn check_keys(&self) -> Result<(), SweepError> {
        let sampled = self.sampled();
        let sampled = sampled.iter().map(|key| BTreeSet::from([key.as_str()]));
        let mut all = BTreeSet::new();
        for keys in self.axes.keys().chain(sampled) {
            if let Some(key) = keys.iter().find(|key| all.contains(*key)) {
                return Err(SweepError::key(key, "has values from two axes or samples"));
            }
            all.extend(keys);
        }
        Ok(())
    }

    /// Every key is one of a case, and every column one of a result.
    fn check_known(&self, study: &Study) -> Result<(), SweepError> {
        let sampled = self.inputs(0).settings;
        let mut checked = BTreeSet::new();
        for (key, value) in self.axes.settings().chain(&sampled) {
            if checked.insert(key) {
                let mut input = study.case.input.clone();
                match set(&mut input, &study.case.defaults, key, value) {
                    Err(unknown) if unknown.code() == Code::E203 => return Err(unknown),
                    // A value that cannot be set is an error of its cases.
                    _ => {}
                }
            }
        }
        let known = known_columns(&study.case);
        let columns = study.input.columns.iter().flatten();
        match columns.into_iter().find(|column| !known.contains(column)) {
            None => Ok(()),
            Some(column) => Err(SweepError::Column {
                column: column.clone(),
                nearest: nearest_name(column, &known),
            }),
        }
    }

    /// Every value of every axis, and those of the first point of the sample, can be set, the files that they name are read,
    /// and the library has the oils.
    pub(super) fn check_values(&self, study: &Study) -> Result<(), SweepError> {
        let sampled = self.inputs(0).settings;
        for (key, value) in self.axes.settings().chain(&sampled) {
            let mut input = study.case.input.clone();
            set(&mut input, &study.case.defaults, key, value)?;
            if let (OIL, Some(name)) = (&**key, &input.lubricant.oil) {
                library_oil(name).map_err(Fault::from)?;
            }
        }
        let settings = self.axes.naming_files().chain([&sampled]);
        let mut unread = settings.filter_map(|settings| {
            let settings = settings.clone();
            let columns = Vec::new();
            resolved(study, &CaseInputs { columns, settings }).err()
        });
        // Any other error may be of this combination only, which the study need not have.
        match unread.find(SweepError::is_of_file) {
            Some(error) => Err(error),
            None => Ok(()),
        }
    }

    /// Names and texts of the nodes of the axes.
    pub(super) fn axes(&self) -> Vec<(String, Vec<String>)> {
        self.axes.texts()
    }

    pub(super) fn count(&self) -> usize {
        self.per_sample() * self.samples()
    }

    /// Numbers of the cases at both ends of every axis, at the first and the last point of the sample.
    pub(super) fn corners(&self) -> impl Iterator<Item = usize> {
        let lengths: Vec<usize> = self.axes.lengths().collect();
        let samples = self.samples();
        let ends = 1_usize << lengths.len().min(MOST_CROSSED);
        (0..ends).flat_map(move |corner| {
            let at = lengths.iter().enumerate().fold(0, |at, (axis, length)| {
                let is_last = corner >> axis.min(MOST_CROSSED) & 1 == 1;
                at * length + if is_last { length - 1 } else { 0 }
            });
            [0, samples - 1].map(|point| at * samples + point)
        })
    }

    /// Number of points of the crossed axes.
    pub(super) fn per_sample(&self) -> usize {
        self.axes.count()
    }

    /// Number of points of the sample.
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

    /// Number of points per block, if the sample has blocks for Sobol's indices.
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

    /// Columns of the inputs: axes, then sampled keys.
    pub(super) fn columns(&self) -> Vec<String> {
        let axes = self.axes.names().map(str::to_owned);
        axes.chain(self.sampled()).collect()
    }

    /// Sampled keys.
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
                    // A has the first numbers, B the others; block 2 + i is A with input i from B.
                    let of_b = *has_blocks && (block == 1 || block == index + 2);
                    let dimension = if of_b { inputs.len() + index } else { index };
                    input.law.quantile(draws.at(point, dimension))
                };
                inputs.iter().enumerate().map(value).collect()
            }
        }
    }

    /// Inputs of a case by its number: row-major in the axes, then the sample.
    pub(super) fn inputs(&self, number: usize) -> CaseInputs {
        let mut inputs = CaseInputs {
            columns: Vec::new(),
            settings: Vec::new(),
        };
        for (text, settings) in self.axes.at(number / self.samples()) {
            inputs.columns.push(text.clone());
            inputs.settings.extend(settings.iter().cloned());
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
            inputs.columns.push(text.clone());
            inputs.settings.push((key, text));
        }
        inputs
    }
}

fn drawn(input: &SampleInput) -> Result<Sample, SweepError> {
    let count = input.count.unwrap_or_default();
    if !(1..=MOST_POINTS).contains(&count) || input.vary.is_empty() {
        let rule = "needs a count from 1 to 1000000 and at least one key to vary";
        return Err(SweepError::key("sample", rule));
    }
    let inputs = input
        .vary
        .iter()
        .map(|(key, distribution)| varied(key, distribution))
        .collect::<Result<Vec<_>, _>>()?;
    let dimensions = inputs.len() * if input.indices { 2 } else { 1 };
    if input.method == Method::Sobol && (count > LONGEST || dimensions > DIMENSIONS) {
        let rule = format!("Sobol's sequence has {LONGEST} points of {DIMENSIONS} numbers at most");
        return Err(SweepError::key("sample.count", rule));
    }
    Ok(Sample::Drawn {
        draws: Draws::new(input.method, count, dimensions, input.seed),
        inputs,
        count,
        has_blocks: input.indices,
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

/// Rows of a table whose header has one key per column, with its unit in brackets: `operation.torque [N m]`.
fn list(study: &Study) -> Result<Sample, SweepError> {
    let table = study.table.as_deref();
    let table = table.ok_or_else(|| SweepError::key("sample.file", "a list needs its table"))?;
    let refused = |rule: String| SweepError::key("sample.file", rule);
    let text =
        table_text("sample.file", table).map_err(|error| refused(error.fault.to_string()))?;
    let file = study
        .input
        .sample
        .as_ref()
        .and_then(|of| of.file.as_deref());
    let file = file.unwrap_or(Path::new("")).display();
    let table = Table::read(&text).map_err(|error| refused(format!("{file}: {error}")))?;
    let keys: Vec<(String, String)> = table
        .heads()
        .map(|head| match head.split_once('[') {
            Some((key, unit)) => (
                key.trim().to_owned(),
                unit.trim_end_matches(']').trim().to_owned(),
            ),
            None => (head.to_owned(), String::new()),
        })
        .collect();
    let rows = table.values(|row| row.numbers());
    let rows = rows.map_err(|fault| refused(format!("{file}:{fault}")))?;
    if rows.is_empty() {
        Err(SweepError::key("sample.file", "the table has no rows"))
    } else {
        Ok(Sample::Rows { keys, rows })
    }
}

/// Resolves a case of a study from its inputs, with its id.
pub(super) fn resolved(study: &Study, inputs: &CaseInputs) -> Result<(Train, String), SweepError> {
    let base = &study.case;
    let mut input = base.input.clone();
    set_all(&mut input, &base.defaults, &inputs.settings)?;
    let case = base.with_input(input)?;
    // All rows of a study must be computed from the same content of each file.
    for (name, sum) in case.files_read() {
        if study.sums.get(&name) != Some(&sum) {
            return Err(SweepError::Changed { file: name });
        }
    }
    let id = case.fingerprint()[..ID].to_owned();
    Ok((case, id))
}
