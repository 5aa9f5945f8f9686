//! Maps: their points, and the losses between them.

use std::path::PathBuf;
use std::sync::Arc;

use asperity::message::Code;
use asperity_studies::cycle as driving;
use asperity_studies::export::{AddedLoss, Format, With, export};
use asperity_studies::map::{self as mapping, MapStudy, Numbers, Point};
use numpy::{IntoPyArray, PyArray1};
use pyo3::prelude::*;
use pyo3::types::PyDict;

use crate::arrays::owned;
use crate::choices::named;
use crate::failure::{self, Failure};
use crate::study::Study;
use crate::work::alone;

/// Losses over torque, speed and temperature.
#[pyclass(frozen, module = "asperity._asperity")]
pub struct Map(Arc<MapStudy>);

impl Map {
    fn map(&self) -> &mapping::Map {
        &self.0.map
    }
}

/// Nodes of a range such as `10..100:5`.
#[pyfunction]
pub fn axis(text: &str) -> PyResult<Vec<f64>> {
    Ok(asperity_report::axis::axis(text).map_err(Failure::from)?)
}

/// The map in a folder.
#[pyfunction]
pub fn read_map(py: Python<'_>, folder: PathBuf) -> PyResult<Study> {
    alone(py, || {
        Ok(Study::of(MapStudy::from(mapping::read(&folder)?)))
    })
}

type Column = (&'static str, fn(&Numbers) -> Option<f64>);

/// The numbers of a point.
pub const COLUMNS: [Column; 16] = [
    ("loss_w", |n| Some(n.loss_w)),
    ("loss_p05_w", |n| Some(n.drawn_w?.low)),
    ("loss_p95_w", |n| Some(n.drawn_w?.high)),
    ("loss_at_medians_w", |n| n.loss_at_medians_w),
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
    /// The map that a study holds.
    #[staticmethod]
    fn of(study: &Study) -> PyResult<Self> {
        Ok(Self(study.held()?))
    }

    /// The points of a finish, temperature by temperature, torque by torque, speed by speed; NaN where a point has no
    /// such number.
    fn points<'py>(&self, py: Python<'py>, finish: usize) -> PyResult<Bound<'py, PyDict>> {
        let none = || Failure::new(Code::E402, format!("the map has no finish number {finish}"));
        let points = &self.map().finishes.get(finish).ok_or_else(none)?.points;
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
        let found = self.map().finishes.get(finish).ok_or_else(none)?;
        let surface = found
            .surface(&self.map().axes, temperature)
            .ok_or_else(none)?;
        let places = torque.into_iter().zip(speed);
        let (values, marks): (Vec<f64>, Vec<bool>) = places
            .map(|(torque, speed)| surface.loss_torque(torque, speed))
            .map(|found| (found.value, found.is_outside))
            .unzip();
        Ok((owned(py, values), marks.into_pyarray(py)))
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
            let added = added.map(|file| AddedLoss::open(&file)).transpose()?;
            let vehicle = self.map().input.vehicle.as_ref();
            let cycle = drive
                .map(|file| driving::read(&file, vehicle))
                .transpose()?;
            let with = With {
                added: added.as_ref(),
                cycle: cycle.as_ref(),
                beside: None,
            };
            let files = export(self.map(), format, with)?;
            let files = files.into_iter().map(|file| (file.name, file.bytes));
            Ok((files.collect(), failure::json(&with.warnings())?))
        })
    }
}
