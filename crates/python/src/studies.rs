//! Comparisons of finishes, changes of one thing at a time, and maps.

use std::path::{Path, PathBuf};

use asperity::case::Train;
use asperity::message::Code;
use asperity::profile_io::read::read_table;
use asperity_report::StudyResult;
use asperity_studies::compare::{self as comparing, CompareSettings, Finish};
use asperity_studies::cycle as driving;
use asperity_studies::export::{AddedLoss, Format, With, export};
use asperity_studies::map::{self as mapping, MapExtras, MapSettings, Numbers, Point};
use numpy::{IntoPyArray, PyArray1};
use pyo3::prelude::*;
use pyo3::types::PyDict;

use crate::arrays::owned;
use crate::case::Case;
use crate::choices::named;
use crate::failure::{self, Failure};
use crate::study::{Study, stated};
use crate::work::{alone, in_parallel};

type Named<'py> = Vec<(String, PyRef<'py, Case>)>;

fn finishes(named: Named<'_>) -> Vec<Finish<Train>> {
    let finish = |(name, case): (String, PyRef<'_, Case>)| Finish {
        name,
        case: case.train().clone(),
    };
    named.into_iter().map(finish).collect()
}

/// A comparison, the rows of the offsets of every finish as JSON, and each difference from the first finish in words.
type Compared = (Study, String, Vec<String>);

/// Compares cases by the names of their finishes; the first is the reference.
#[pyfunction]
pub fn compare(
    py: Python<'_>,
    named: Named<'_>,
    settings: &str,
    threads: Option<isize>,
    progress: Option<Bound<'_, PyAny>>,
) -> PyResult<Compared> {
    stated::<CompareSettings>(settings)?
        .check()
        .map_err(Failure::from)?;
    let finishes = finishes(named);
    in_parallel(py, threads, progress.as_ref(), |told| {
        let found = comparing::compare(&finishes, &|done, total| told.tell(done, total))?;
        let offsets: Vec<_> = found.finishes.iter().map(|of| &of.offsets).collect();
        let (offsets, verdicts) = (failure::json(&offsets)?, found.verdicts());
        Ok((Study::of(found)?, offsets, verdicts))
    })
}

/// Losses over torque, speed and temperature.
#[pyclass(frozen, module = "asperity._asperity")]
pub struct Map(mapping::Map);

/// Nodes of a range such as `10..100:5`.
#[pyfunction]
pub fn axis(text: &str) -> PyResult<Vec<f64>> {
    Ok(asperity_report::axis::axis(text).map_err(Failure::from)?)
}

/// Maps cases by the names of their finishes over torque, speed and temperature.
#[pyfunction]
pub fn map(
    py: Python<'_>,
    of_finishes: Named<'_>,
    settings: &str,
    threads: Option<isize>,
    progress: Option<Bound<'_, PyAny>>,
) -> PyResult<Map> {
    let finishes = finishes(of_finishes);
    let Some(first) = finishes.first() else {
        return Err(Failure::new(Code::E205, "a map needs a case").into());
    };
    let settings: MapSettings = stated(settings)?;
    let axes = settings.axes(&first.case).map_err(Failure::from)?;
    let band = settings.band;
    in_parallel(py, threads, progress.as_ref(), |told| {
        let found = mapping::map(&finishes, &axes, band, &|done, total| {
            told.tell(done, total)
        })?;
        Ok(Map(found))
    })
}

/// Energy lost over a cycle, a table called `name`, on a map at one of its temperatures; `keys` change its vehicle.
#[pyfunction]
pub fn cycle(
    py: Python<'_>,
    map: PyRef<'_, Map>,
    trace: (String, Option<String>),
    temperature: usize,
    keys: Vec<(String, String)>,
    allow_outside: bool,
) -> PyResult<Study> {
    let (name, table) = trace;
    let mut map = map.0.clone();
    alone(py, || {
        for (key, value) in &keys {
            map.input.set(key, value)?;
        }
        let file = Path::new(&name);
        let table = table.map_or_else(|| text(file), Ok)?;
        let trace = driving::cycle(&table, map.input.vehicle.as_ref());
        let trace = trace.map_err(|error| Failure::from(error).about(&name))?;
        let stem = file.file_stem().unwrap_or_default().to_string_lossy();
        let found = driving::evaluate(&map, temperature, (&trace, &stem), allow_outside);
        let found = found.map_err(|error| match error.code() {
            Code::E314 => error.about(&name),
            _ => error,
        })?;
        let (json, summary) = (failure::json(&found)?, found.summary(&map));
        Ok(Study::new(json, summary, move |folder| {
            found.write(&map, folder)
        }))
    })
}

/// The map in a folder.
#[pyfunction]
pub fn read_map(py: Python<'_>, folder: PathBuf) -> PyResult<Map> {
    alone(py, || Ok(Map(mapping::read(&folder)?)))
}

type Column = (&'static str, fn(&Numbers) -> Option<f64>);

/// The numbers of a point.
pub const COLUMNS: [Column; 16] = [
    ("loss_w", |n| Some(n.loss_w)),
    ("loss_median_w", |n| n.loss_median_w),
    ("loss_p05_w", |n| Some(n.loss_quantiles_w?[0])),
    ("loss_p95_w", |n| Some(n.loss_quantiles_w?[1])),
    ("loss_torque_nm", |n| Some(n.loss_torque_nm)),
    ("loss_torque_deviation_nm", |n| n.loss_torque_deviation_nm),
    ("efficiency", |n| n.efficiency),
    ("efficiency_deviation", |n| n.efficiency_deviation),
    ("sliding_w", |n| Some(n.sliding_w)),
    ("film_w", |n| Some(n.film_w)),
    ("lubricated_asperity_w", |n| Some(n.lubricated_asperity_w)),
    ("boundary_w", |n| Some(n.boundary_w)),
    ("rolling_w", |n| Some(n.rolling_w)),
    ("deformation_w", |n| Some(n.deformation_w)),
    ("mu_equivalent", |n| n.mu_equivalent),
    ("mixed_share", |n| Some(n.mixed_share)),
];

/// Names and contents of files, and warnings as JSON.
type Exported = (Vec<(PathBuf, Vec<u8>)>, String);

/// Interpolated values, and whether each lies outside the nodes.
type Interpolated<'py> = (Bound<'py, PyArray1<f64>>, Bound<'py, PyArray1<bool>>);

#[pymethods]
impl Map {
    /// The map as the command prints it with --json: axes, finishes, warnings, without the points.
    fn json(&self) -> PyResult<String> {
        Ok(failure::json(&self.0)?)
    }

    /// The points of a finish, temperature by temperature, torque by torque, speed by speed; NaN where a point has no
    /// such number.
    fn points<'py>(&self, py: Python<'py>, finish: usize) -> PyResult<Bound<'py, PyDict>> {
        let none = || Failure::new(Code::E402, format!("the map has no finish number {finish}"));
        let points = &self.0.finishes.get(finish).ok_or_else(none)?.points;
        let arrays = PyDict::new(py);
        for (name, of) in COLUMNS {
            let value = |point: &Point| point.numbers.as_ref().and_then(of).unwrap_or(f64::NAN);
            arrays.set_item(name, owned(py, points.iter().map(value).collect()))?;
        }
        let extended: Vec<bool> = points.iter().map(Point::is_extended).collect();
        arrays.set_item("extended", extended.into_pyarray(py))?;
        let codes: Vec<Option<&str>> = points
            .iter()
            .map(|point| Some(point.code?.as_str()))
            .collect();
        arrays.set_item("code", codes)?;
        let regime = |point: &Point| point.numbers.as_ref().map(|n| n.regime().name());
        let regimes: Vec<Option<&str>> = points.iter().map(regime).collect();
        arrays.set_item("regime", regimes)?;
        Ok(arrays)
    }

    /// Loss torque in N m by interpolation between the nodes, and whether the places lie outside of them.
    fn loss_torque<'py>(
        &self,
        py: Python<'py>,
        finish: usize,
        temperature: usize,
        torque: Vec<f64>,
        speed: Vec<f64>,
    ) -> PyResult<Interpolated<'py>> {
        let none = || {
            Failure::new(
                Code::E402,
                format!("the map has no finish number {finish} at that temperature"),
            )
        };
        let found = self.0.finishes.get(finish).ok_or_else(none)?;
        let surface = found.surface(&self.0.axes, temperature).ok_or_else(none)?;
        let places = torque.into_iter().zip(speed);
        let (values, marks): (Vec<f64>, Vec<bool>) = places
            .map(|(torque, speed)| surface.loss_torque(torque, speed))
            .map(|found| (found.value, found.is_outside))
            .unzip();
        Ok((owned(py, values), marks.into_pyarray(py)))
    }

    /// The summary as text.
    fn summary(&self) -> String {
        self.0.summary(MapExtras::default())
    }

    /// Writes the folder of the map.
    fn write(&self, py: Python<'_>, folder: PathBuf) -> PyResult<()> {
        alone(py, || Ok(self.0.write(MapExtras::default(), &folder)?))
    }

    /// Names and contents of the files of a format, and the warnings about both tables as JSON; `added` is a table of other
    /// losses, `cycle` a drive cycle.
    fn export(
        &self,
        py: Python<'_>,
        format: &str,
        added: Option<PathBuf>,
        drive: Option<PathBuf>,
    ) -> PyResult<Exported> {
        let format: Format = named("format", format)?;
        alone(py, || {
            let added = match &added {
                Some(file) => {
                    let name = file.file_name().unwrap_or_default().to_string_lossy();
                    let found = AddedLoss::read(&name, &text(file)?);
                    Some(found?)
                }
                None => None,
            };
            let cycle = match &drive {
                Some(file) => {
                    let found = driving::cycle(&text(file)?, self.0.input.vehicle.as_ref());
                    let name = file.display().to_string();
                    Some(found.map_err(|error| Failure::from(error).about(&name))?)
                }
                None => None,
            };
            let with = With {
                added: added.as_ref(),
                cycle: cycle.as_ref(),
                beside: None,
            };
            let files = export(&self.0, format, with)?;
            let files = files.into_iter().map(|file| (file.name, file.bytes));
            Ok((files.collect(), failure::json(&with.warnings())?))
        })
    }
}

/// Bytes of the largest table that is read.
const LARGEST_TABLE: u64 = 100_000_000;

fn text(file: &Path) -> Result<String, Failure> {
    Ok(read_table(file, LARGEST_TABLE)?)
}
