//! Profiles: read, generated, prepared, evaluated, written.

use std::path::{Path, PathBuf};

use asperity::case::Trace as CaseTrace;
use asperity::case::{HeldTrace, Statements};
use asperity::core::Profile;
use asperity::message::{Code, Fault};
use asperity::profile_io::Warning as ReadWarning;
use asperity::profile_io::read::{FilterState, Metadata, ReadOptions, Reading, read};
use asperity::profile_io::write::{WrittenFormat, write_filtered};
use asperity::quantity::Length;
use asperity::roughness::autocorrelation::autocorrelation;
use asperity::roughness::form::Form;
use asperity::roughness::gaussian_filter::{Ends, mean_line};
use asperity::roughness::generate::{
    Achieved, Like, Method, Recipe, State as StateOfTest, Surface,
};
use asperity::roughness::height_parameters::Mode;
use asperity::roughness::involute::{Involute, form_left, remove};
use asperity::roughness::material_ratio::{abbott_curve, material_ratio_percent};
use asperity::roughness::preparation::{Preparation, Prepared, RoughnessFilter, profiles};
use asperity::roughness::robust_filter::robust_mean_line;
use asperity::roughness::spectral::power_spectrum;
use asperity::roughness::{Parameters, RoughnessError, Warning};
use asperity_report::profile_json::{heights, material, spectral, um};
use numpy::PyArray1;
use pyo3::prelude::*;
use pyo3::types::PyDict;
use serde::Deserialize;
use serde_json::{Value, json};

use crate::arrays::{Input, columns, copied, owned};
use crate::choices::{FormOfProfile, named};
use crate::failure::{self, Failure};
use crate::work::alone;

/// Sections of a trace that is not filtered.
const SECTIONS: usize = 5;

/// A profile with what is known of it.
#[pyclass(frozen, module = "asperity._asperity")]
#[derive(Clone)]
pub struct Trace {
    pub profile: Profile,
    metadata: Metadata,
    /// Cut-offs that the file states, long and short, of heights that were not filtered with them.
    stated: [Option<Length>; 2],
    /// Cut-off of the roughness filter that the heights have been through.
    cutoff: Option<Length>,
    /// Doubts of the reader, which a case with these heights has, too.
    doubts: Vec<ReadWarning>,
    about: Value,
}

impl Trace {
    fn made(profile: Profile, about: Value) -> Self {
        Self {
            profile,
            metadata: Metadata::default(),
            stated: [None, None],
            cutoff: None,
            doubts: Vec::new(),
            about,
        }
    }

    fn read(reading: Reading) -> Result<Self, Failure> {
        let is_rough = reading.filter_state == FilterState::Roughness;
        let [long, short] = [reading.metadata.lambda_c, reading.metadata.lambda_s];
        let warnings: Vec<Value> = reading
            .warnings
            .iter()
            .map(|warning| {
                told(
                    warning.code(),
                    warning.to_string(),
                    &warning.remedy().to_string(),
                )
            })
            .collect();
        let mut about = json!(reading);
        about["warnings"] = json!(warnings);
        Ok(Self {
            stated: if is_rough {
                [None, None]
            } else {
                [long, short]
            },
            cutoff: None,
            doubts: reading.record.warnings,
            metadata: reading.record.metadata,
            profile: reading.profile,
            about,
        })
    }

    /// The filters that the heights have been through.
    fn filter_state(&self) -> FilterState {
        match (self.about.get("preparation"), self.cutoff) {
            (Some(_), Some(_)) => FilterState::Roughness,
            _ => {
                let of_file = self.about.get("filter_state").cloned();
                let state = of_file.and_then(|state| serde_json::from_value(state).ok());
                state.unwrap_or(FilterState::Unknown)
            }
        }
    }

    /// The trace as a case holds it.
    pub fn held(&self) -> HeldTrace {
        HeldTrace {
            profile: self.profile.clone(),
            statements: self.statements(),
        }
    }

    fn statements(&self) -> Statements {
        let filter_state = self.filter_state();
        // The case judges the heights itself.
        let is_of_reading =
            |warning: &&ReadWarning| !matches!(warning, ReadWarning::ImplausibleHeights { .. });
        let mut warnings: Vec<ReadWarning> =
            self.doubts.iter().filter(is_of_reading).cloned().collect();
        if filter_state == FilterState::Roughness
            && !warnings.contains(&ReadWarning::AlreadyFiltered)
        {
            warnings.push(ReadWarning::AlreadyFiltered);
        }
        Statements {
            filter_state,
            cutoffs: [self.cutoff.or(self.stated[0]), self.stated[1]],
            warnings,
        }
    }

    fn prepared(&self, found: &Prepared, cutoff: Option<Length>, more: &[Warning]) -> Self {
        let warnings = found.warnings.iter().chain(more).map(of_roughness);
        let about = json!({
            "preparation": found.record,
            "first_index": found.first_index,
            "warnings": warnings.collect::<Vec<_>>(),
        });
        Self {
            profile: found.profile.clone(),
            metadata: self.metadata.clone(),
            stated: self.stated,
            cutoff,
            doubts: self.doubts.clone(),
            about,
        }
    }
}

fn told(code: Code, text: String, remedy: &str) -> Value {
    json!({ "code": code, "text": text, "help": remedy })
}

fn of_roughness(warning: &Warning) -> Value {
    told(
        warning.code(),
        warning.to_string(),
        &warning.remedy().to_string(),
    )
}

/// A length in metres as a cut-off: zero turns the filter off.
fn on(length: f64) -> Option<Length> {
    (length != 0.0).then(|| Length::from_si(length))
}

/// How a trace is prepared.
#[derive(serde::Deserialize)]
struct Plan {
    form: String,
    /// Zero turns the filter off; none takes what the file states, or the usual.
    cutoff: Option<f64>,
    noise_cutoff: Option<f64>,
    ends: Option<Ends>,
    robust: bool,
    base_radius: Option<f64>,
    roll_length: Option<f64>,
    towards_root: bool,
}

impl Plan {
    fn recipe(&self, trace: &Trace) -> Result<Preparation, Failure> {
        let usual = Preparation::default();
        let of = |given: Option<f64>, stated: Option<Length>, usual: Option<Length>| match given {
            Some(length) => on(length),
            None => stated.or(usual),
        };
        let form = match self.form()? {
            FormOfProfile::None | FormOfProfile::Involute => Form::None,
            FormOfProfile::Mean => Form::Mean,
            FormOfProfile::Level => Form::Level,
            FormOfProfile::Poly2 => Form::Poly2,
            FormOfProfile::Circle => Form::Circle,
        };
        let recipe = Preparation {
            form,
            lambda_c: of(self.cutoff, trace.stated[0], usual.lambda_c),
            lambda_s: of(self.noise_cutoff, trace.stated[1], usual.lambda_s),
            ends: self.ends.unwrap_or(usual.ends),
        };
        if self.robust && recipe.lambda_c.is_none() {
            return Err(Failure::new(
                Code::E205,
                "robust applies to the filter at cutoff, which is off",
            ));
        }
        Ok(recipe)
    }

    fn form(&self) -> Result<FormOfProfile, Failure> {
        named("form", &self.form)
    }

    fn filter(&self) -> RoughnessFilter {
        if self.robust { RoughnessFilter::RobustGaussian } else { RoughnessFilter::Gaussian }
    }

    fn involute(&self) -> Result<Option<Involute>, Failure> {
        match (self.form()?, self.base_radius, self.roll_length) {
            (FormOfProfile::Involute, Some(base), Some(roll)) => Ok(Some(Involute {
                base_radius: Length::from_si(base),
                roll_length: Length::from_si(roll),
                towards_root: self.towards_root,
            })),
            (FormOfProfile::Involute, ..) => {
                let message = "form = \"involute\" needs base_radius, and roll_length at the middle of the trace";
                Err(Failure::new(Code::E205, message))
            }
            (_, None, None) => Ok(None),
            _ => Err(Failure::new(
                Code::E205,
                "base_radius and roll_length go with form = \"involute\" only",
            )),
        }
    }
}

type Heights<'py> = Bound<'py, PyArray1<f64>>;
type State<'py> = (
    Heights<'py>,
    f64,
    String,
    Option<f64>,
    [Option<f64>; 2],
    String,
);
type Reduced<'py> = (Bound<'py, PyAny>, State<'py>);

#[pymethods]
impl Trace {
    /// A profile of these heights in m, out of the material, `spacing` in m apart.
    #[staticmethod]
    fn of(heights: Input<'_>, spacing: f64) -> PyResult<Self> {
        let heights = copied(&heights);
        let spacing = Length::from_si(spacing);
        // The checks of a trace that goes into a case.
        CaseTrace::from_heights(&heights, spacing).map_err(Failure::from)?;
        let profile = Profile::new(spacing, heights).map_err(Failure::from)?;
        Ok(Self::made(profile, json!({ "warnings": [] })))
    }

    /// The profile that another process had: heights in m, spacing in m, what is known as JSON, cut-off that it has been
    /// through, cut-offs that its file states, doubts of the reader as JSON.
    #[staticmethod]
    fn restored(
        heights: Input<'_>,
        spacing: f64,
        about: &str,
        cutoff: Option<f64>,
        stated: [Option<f64>; 2],
        doubts: &str,
    ) -> PyResult<Self> {
        let profile = Profile::new(Length::from_si(spacing), copied(&heights));
        let about: Value = failure::asked(about)?;
        let metadata = about.get("metadata").cloned().map(serde_json::from_value);
        Ok(Self {
            metadata: metadata.and_then(Result::ok).unwrap_or_default(),
            stated: stated.map(|length| length.map(Length::from_si)),
            cutoff: cutoff.map(Length::from_si),
            doubts: failure::asked(doubts)?,
            ..Self::made(profile.map_err(Failure::from)?, about)
        })
    }

    /// For pickle: `restored` and its arguments.
    fn __reduce__<'py>(&self, py: Python<'py>) -> PyResult<Reduced<'py>> {
        let restored = py.get_type::<Self>().getattr("restored")?;
        let stated = self.stated.map(|length| length.map(Length::si));
        let heights = self.heights(py);
        let about = self.about()?;
        let doubts = failure::json(&self.doubts)?;
        Ok((
            restored,
            (
                heights,
                self.spacing(),
                about,
                self.cutoff(),
                stated,
                doubts,
            ),
        ))
    }

    /// Heights in m.
    #[getter]
    fn heights<'py>(&self, py: Python<'py>) -> Bound<'py, PyArray1<f64>> {
        owned(py, self.profile.heights().to_vec())
    }

    /// Distance of the points in m.
    #[getter]
    fn spacing(&self) -> f64 {
        self.profile.spacing().si()
    }

    /// All else that is known, as JSON.
    #[getter]
    fn about(&self) -> PyResult<String> {
        Ok(failure::json(&self.about)?)
    }

    /// Cut-off in m of the roughness filter that the heights have been through.
    #[getter]
    fn cutoff(&self) -> Option<f64> {
        self.cutoff.map(Length::si)
    }

    /// Without form, filtered as the plan in JSON says: primary profile, waviness where a filter parts it, roughness.
    fn prepare(&self, py: Python<'_>, plan: &str) -> PyResult<(Self, Option<Self>, Self)> {
        alone(py, || {
            let plan: Plan = failure::asked(plan)?;
            let recipe = plan.recipe(self)?;
            let involute = plan.involute()?;
            let without = involute
                .as_ref()
                .map(|flank| remove(&self.profile, flank))
                .transpose()?;
            let left = involute
                .as_ref()
                .map(|flank| form_left(&self.profile, flank))
                .transpose()?;
            let trace = without.as_ref().unwrap_or(&self.profile);
            let parts = profiles(trace, &recipe, plan.filter())?;
            let left: Vec<Warning> = left.flatten().into_iter().collect();
            let none = json!({ "warnings": [] });
            let with = |profile: Profile| Self {
                metadata: self.metadata.clone(),
                ..Self::made(profile, none.clone())
            };
            let rough = self.prepared(&parts.roughness, recipe.lambda_c, &left);
            Ok((with(parts.primary), parts.waviness.map(with), rough))
        })
    }

    /// Mean line of the Gaussian filter at `cutoff` in m, or of the robust one.
    fn mean_line(&self, py: Python<'_>, cutoff: f64, robust: bool, ends: &str) -> PyResult<Self> {
        let ends: Ends = named("ends", ends)?;
        alone(py, || {
            let cutoff = Length::from_si(cutoff);
            let line = if robust { robust_mean_line(&self.profile, cutoff)?.heights } else { mean_line(&self.profile, cutoff, ends)? };
            let line = Profile::new(self.profile.spacing(), line)?;
            Ok(Self::made(line, json!({ "warnings": [] })))
        })
    }

    /// Parameters as JSON, lengths in um as in the command's: of so many sections, of sections of `cutoff` in m, or
    /// of sections of the cut-off that the heights have been through.
    fn parameters(
        &self,
        py: Python<'_>,
        standard: &str,
        sections: Option<i64>,
        cutoff: Option<f64>,
    ) -> PyResult<String> {
        let mode: Mode = named("standard", standard)?;
        let sections = sections.map(|count| {
            let few = || Failure::new(Code::E209, format!("sections = {count}: must be 1 or more"));
            usize::try_from(count).map_err(|_| few())
        });
        let sections = sections.transpose()?;
        alone(py, || {
            let length = cutoff.map(Length::from_si).or(self.cutoff);
            let found = match (sections, length) {
                (Some(count), _) => Parameters::with_sections(&self.profile, mode, count)?,
                (None, Some(length)) => Parameters::from_profile(&self.profile, mode, length)?,
                (None, None) => Parameters::with_sections(&self.profile, mode, SECTIONS)?,
            };
            failure::json(&json!({
                "heights": heights(&found.heights),
                "material_ratio": material(&found.material),
                "spectral": spectral(&found.spectral),
                "section_um": um(found.lambda_c),
                "warnings": found.warnings.iter().map(of_roughness).collect::<Vec<_>>(),
            }))
        })
    }

    /// The points from `first` to before `end`.
    fn cut(&self, first: usize, end: usize) -> PyResult<Self> {
        let cut = self.profile.slice(first..end);
        let cut = cut.ok_or_else(|| {
            let points = self.profile.len();
            let message = format!("points {first} to {end}: the profile has {points} points");
            Failure::new(Code::E209, message)
        })?;
        // The checks of a trace that goes into a case.
        CaseTrace::from_heights(cut.heights(), cut.spacing()).map_err(Failure::from)?;
        Ok(Self {
            profile: cut,
            ..self.clone()
        })
    }

    /// One-sided power spectral density: frequencies in 1/m, densities in m3.
    fn psd<'py>(&self, py: Python<'py>) -> PyResult<Bound<'py, PyDict>> {
        let spectrum = alone(py, || Ok(power_spectrum(&self.profile)?))?;
        let places = 0..spectrum.density.len();
        let frequencies = places.map(|k| k as f64 * spectrum.frequency_step);
        let arrays = [
            ("frequency_per_m", frequencies.collect()),
            ("density_m3", spectrum.density),
        ];
        columns(py, arrays)
    }

    /// Autocorrelation by shifts in m.
    fn autocorrelation<'py>(&self, py: Python<'py>) -> PyResult<Bound<'py, PyDict>> {
        let found = alone(py, || Ok(autocorrelation(self.profile.heights())?))?;
        let shifts = (0..found.len()).map(|k| k as f64 * self.spacing());
        let arrays = [("shift_m", shifts.collect()), ("autocorrelation", found)];
        columns(py, arrays)
    }

    /// Material ratio curve: heights in m from the highest, by the share of material.
    fn material_ratio<'py>(&self, py: Python<'py>) -> PyResult<Bound<'py, PyDict>> {
        let curve = alone(py, || Ok(abbott_curve(self.profile.heights())?))?;
        let ratios = (0..curve.len()).map(|k| material_ratio_percent(k, curve.len()));
        let arrays = [
            ("material_ratio_percent", ratios.collect()),
            ("height_m", curve),
        ];
        columns(py, arrays)
    }

    /// Heights with what is stated of them as JSON, as a case holds them.
    #[staticmethod]
    fn of_case(heights: Input<'_>, spacing: f64, stated: &str) -> PyResult<Self> {
        let profile = Profile::new(Length::from_si(spacing), copied(&heights));
        let profile = profile.map_err(Failure::from)?;
        let of_heights: Statements = failure::asked(stated)?;
        let [lambda_c, lambda_s] = of_heights.cutoffs;
        Ok(Self {
            metadata: Metadata {
                lambda_c,
                lambda_s,
                ..Metadata::default()
            },
            stated: of_heights.cutoffs,
            doubts: of_heights.warnings,
            ..Self::made(
                profile,
                json!({ "filter_state": of_heights.filter_state, "warnings": [] }),
            )
        })
    }

    /// Statements about the heights as JSON; empty if nothing is stated.
    #[getter]
    fn statements_json(&self) -> PyResult<String> {
        let stated = self.statements();
        if stated == Statements::default() {
            return Ok(String::new());
        }
        Ok(failure::json(&stated)?)
    }

    /// The same run from its other end.
    fn mirrored(&self) -> PyResult<Self> {
        let mut heights = self.profile.heights().to_vec();
        heights.reverse();
        let profile = Profile::new(self.profile.spacing(), heights).map_err(Failure::from)?;
        Ok(Self {
            profile,
            ..self.clone()
        })
    }

    /// Writes the profile in the format that the name asks for.
    fn write(&self, py: Python<'_>, path: PathBuf) -> PyResult<()> {
        let name = path.display().to_string();
        let refused = |reason: &str| Failure::from(Fault::unwritten(&name, reason));
        alone(py, || {
            let format = WrittenFormat::of_name(&name);
            let format = format.ok_or_else(|| refused("name it .csv, .x3p or .smd"))?;
            let metadata = Metadata {
                lambda_c: self.cutoff.or(self.metadata.lambda_c),
                ..self.metadata.clone()
            };
            let bytes = write_filtered(&self.profile, &metadata, self.filter_state(), format);
            let bytes = bytes.map_err(|error| refused(&error.to_string()))?;
            asperity_storage::save(&path, &bytes)
                .map_err(|error| Failure::new(Code::E401, error.to_string()))
        })
    }
}

/// Reads a profile file; `options` is a JSON object with the keys of a flank in a case file.
#[pyfunction]
pub fn read_profile(py: Python<'_>, path: PathBuf, options: &str) -> PyResult<Trace> {
    let options: ReadOptions = failure::asked(options)?;
    alone(py, || Trace::read(read(Path::new(&path), &options)?))
}

/// A synthetic profile by a recipe in JSON.
#[pyfunction]
pub fn generate(py: Python<'_>, recipe: &str) -> PyResult<Trace> {
    let recipe: Recipe = failure::asked(recipe)?;
    alone(py, || {
        let made = recipe.generate().map_err(|error| match error {
            RoughnessError::Domain(error) => Failure::from(error),
            other => other.into(),
        })?;
        // The checks of a trace that goes into a case.
        CaseTrace::from_heights(made.profile.heights(), made.profile.spacing())?;
        let about = json!({
            "recipe": recipe, "achieved": of_achieved(&made.achieved), "synthetic": true, "warnings": [],
        });
        Ok(Trace::made(made.profile, about))
    })
}

/// A flank wanted like traces.
#[derive(Deserialize)]
struct Wanted {
    method: Option<Method>,
    state: Option<f64>,
    engagements: Option<f64>,
    /// Engagements at the stages of a test.
    stages: Vec<f64>,
    seed: u64,
}

/// A profile like `before`, or in a state of the test after whose stages `after` were measured, one stage after the other.
#[pyfunction]
pub fn generate_like(
    py: Python<'_>,
    before: Vec<PyRef<'_, Trace>>,
    after: Vec<PyRef<'_, Trace>>,
    wanted: &str,
) -> PyResult<Trace> {
    let wanted: Wanted = failure::asked(wanted)?;
    let profiles = |traces: &[PyRef<'_, Trace>]| -> Vec<Profile> {
        traces.iter().map(|trace| trace.profile.clone()).collect()
    };
    let (before, after) = (profiles(&before), profiles(&after));
    alone(py, || {
        let like = if after.is_empty() { Like::to(&before[0], &before[1..], wanted.method)? } else {
                let state = StateOfTest::stated(wanted.state, wanted.engagements, &wanted.stages)?;
                Like::of_stages(&before, &after, state)?
            };
        let made = like.generate(wanted.seed)?;
        let recipe = made.recipe.map(Surface::Fitted).map(Recipe::from_surface);
        let warnings: Vec<Value> = like.warnings.iter().map(of_roughness).collect();
        let about = json!({
            "recipe": recipe, "method": made.method, "pieces": made.pieces,
            "achieved": of_achieved(&made.generated.achieved), "synthetic": true, "warnings": warnings,
        });
        Ok(Trace::made(made.generated.profile, about))
    })
}

fn of_achieved(found: &Achieved) -> Value {
    json!({
        "ra_um": um(found.ra), "rq_um": um(found.rq), "rt_um": um(found.rt), "rsk": found.rsk, "rku": found.rku,
        "rdq": found.rdq, "spectrum_error": found.spectrum_error, "iterations": found.iterations,
    })
}
