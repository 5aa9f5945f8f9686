//! Oils: traction of ball and disc, constants from traction curves, plans, boundary friction.

use std::path::Path;

use asperity::case::LoadedCase;
use asperity::message::Code;
use asperity::quantity::{Force, Length, Speed, Temperature};
use asperity::tribo_friction::boundary::BOUNDARY_FRICTION;
use asperity_calibration::oil::error::of_table;
use asperity_calibration::oil::fit::PointErrors;
use asperity_calibration::oil::problem::Zero;
use asperity_calibration::oil::{
    ConstantsOf, FitSettings, Machine, OilBase, OilFit, OilPlan, PlanSettings, Probe, Readings,
    Stribeck, TractionCurves, TractionRange,
};
use asperity_calibration::table_text;
use pyo3::prelude::*;

use crate::case::Case;
use crate::choices::named;
use crate::failure::Failure;
use crate::study::Study;
use crate::work::{alone, in_parallel};

/// Oil of the library, or of a case.
#[derive(FromPyObject)]
pub enum Oil<'py> {
    /// A name.
    Name(String),
    /// A case.
    Case(PyRef<'py, Case>),
}

impl Oil<'_> {
    fn base(&self, constants: ConstantsOf) -> Result<(OilBase, Option<LoadedCase>), Failure> {
        match self {
            Self::Name(name) => Ok((OilBase::of_library(name)?, None)),
            Self::Case(case) => {
                let case = case.only()?.clone();
                Ok((OilBase::of_case(&case.case, constants)?, Some(case)))
            }
        }
    }
}

/// Radii of ball and second body \[m\], roughness of both together \[m\].
type Specimens = (f64, Option<f64>, f64);

fn machine((ball, second, roughness): Specimens) -> Result<Machine, Failure> {
    let length = Length::from_si;
    let second = second.map(length);
    Ok(Machine::ball_on_disc(
        length(ball),
        second,
        length(roughness),
    )?)
}

/// Zeros, relative error of a point and its least error.
type Errors = (String, f64, f64);

fn errors((zero, relative, floor): Errors) -> Result<(Zero, PointErrors), Failure> {
    let zero: Zero = named("zero", &zero)?;
    let is_valid = |value: f64| value > 0.0 && value < 1.0;
    match is_valid(relative) && is_valid(floor) {
        true => Ok((zero, PointErrors { relative, floor })),
        false => {
            let message = "point_sd, point_floor: must be positive and below 1";
            Err(Failure::new(Code::E209, message))
        }
    }
}

/// Tables by name, each with its text, or a file of that name where there is none.
type Tables = Vec<(String, Option<String>)>;

fn readings(tables: Tables, machine: &Machine, column: &str) -> Result<Readings, Failure> {
    let probe: Probe = named("temperature_column", column)?;
    let mut readings = Readings::default();
    for (name, text) in tables {
        let text = match text {
            Some(text) => text,
            None => table_text(Path::new(&name)).map_err(of_table)?,
        };
        readings.append(Readings::read(&name, &text, machine, probe)?);
    }
    Ok(readings)
}

/// Predicts traction curves; load and speed in SI units, temperatures in °C.
#[pyfunction]
pub fn oil_traction(
    py: Python<'_>,
    oil: Oil<'_>,
    conditions: (f64, f64, f64),
    temperatures: Vec<f64>,
    specimens: Specimens,
    threads: Option<isize>,
) -> PyResult<Study> {
    let (oil, _) = oil.base(ConstantsOf::File)?;
    let (load, speed, slide_to_roll) = conditions;
    if temperatures.is_empty() {
        return Err(Failure::new(Code::E209, "temperature: at least one is required").into());
    }
    let range = TractionRange {
        machine: machine(specimens)?,
        load: Force::from_si(load),
        mean_speed: Speed::from_si(speed),
        slide_to_roll,
        temperatures: temperatures
            .into_iter()
            .map(Temperature::from_celsius)
            .collect(),
        boundary_friction: BOUNDARY_FRICTION,
    };
    in_parallel(py, threads, None, |_| {
        Study::of(TractionCurves::of(&oil, &range)?)
    })
}

/// Fits the constants of an oil to traction curves.
#[pyfunction]
#[expect(clippy::too_many_arguments, reason = "those of the function in Python")]
pub fn oil_fit(
    py: Python<'_>,
    tables: Tables,
    oil: Oil<'_>,
    specimens: Specimens,
    temperature_column: &str,
    wide: bool,
    errors_of: Errors,
    force: bool,
    threads: Option<isize>,
) -> PyResult<Study> {
    let (oil, _) = oil.base(ConstantsOf::Family)?;
    let (zero, errors) = errors(errors_of)?;
    let readings = readings(tables, &machine(specimens)?, temperature_column)?;
    let settings = FitSettings {
        is_wide: wide,
        zero,
        errors,
        is_forced: force,
    };
    in_parallel(py, threads, None, |_| {
        Study::of(OilFit::of(&oil, readings, settings)?)
    })
}

/// Plans traction measurements, for the loss of a case if there is one.
#[pyfunction]
pub fn oil_plan(
    py: Python<'_>,
    oil: Oil<'_>,
    case: Option<PyRef<'_, Case>>,
    specimens: Specimens,
    wide: bool,
    errors_of: Errors,
    threads: Option<isize>,
) -> PyResult<Study> {
    let (oil, own) = oil.base(ConstantsOf::Family)?;
    let case = match case {
        Some(case) => Some(case.only()?.clone()),
        None => own,
    };
    let (zero, errors) = errors(errors_of)?;
    let settings = PlanSettings {
        machine: machine(specimens)?,
        is_wide: wide,
        zero,
        errors,
        simulate: None,
    };
    in_parallel(py, threads, None, |_| {
        Study::of(OilPlan::of(&oil, case.as_ref(), &settings)?)
    })
}

/// Finds the boundary friction in Stribeck curves; `rubbing` holds one time in seconds for each table, or none.
#[pyfunction]
pub fn stribeck(
    py: Python<'_>,
    tables: Tables,
    oil: Oil<'_>,
    rubbing: Vec<f64>,
    specimens: Specimens,
    temperature_column: &str,
) -> PyResult<Study> {
    let (oil, _) = oil.base(ConstantsOf::Family)?;
    if !rubbing.is_empty() && rubbing.len() != tables.len() {
        let message = "rubbing: takes one time for each table";
        return Err(Failure::new(Code::E205, message).into());
    }
    let machine = machine(specimens)?;
    let mut all = Readings::default();
    for (k, table) in tables.into_iter().enumerate() {
        let mut of_table = readings(vec![table], &machine, temperature_column)?;
        for reading in &mut of_table.all {
            reading.rubbing_s = reading.rubbing_s.or(rubbing.get(k).copied());
        }
        all.append(of_table);
    }
    alone(py, || Study::of(Stribeck::of(&oil, all)?))
}
