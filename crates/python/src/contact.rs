//! Rough line contacts: over a gap, of two flanks, and the stress below.

use std::sync::Mutex;

use asperity::contact::running_in::RunningIn;
use asperity::contact::subsurface::subsurface_stress as stress_below;
use asperity::contact::two_flanks::TwoFlanks;
use asperity::contact::{
    Boundary, ContactError, ContactProblem, ContactSolution, ContactWarning, Control, Lead,
    PeriodicKernel, Solver, SolverSettings,
};
use asperity::message::Code;
use asperity::quantity::{Length, LineLoad, Pressure};
use asperity::remedy::Remedy;
use pyo3::prelude::*;
use pyo3::types::PyDict;
use serde::{Deserialize, Serialize};
use serde_json::json;

use crate::arrays::{Input, columns, copied};
use crate::choices::{BoundaryOfContact, named};
use crate::failure::{self, Failure};
use crate::trace::Trace;
use crate::work::alone;

/// Numbers and settings of a contact, as JSON from Python, in SI units.
#[derive(serde::Deserialize)]
#[serde(deny_unknown_fields)]
struct Asked {
    spacing: f64,
    rows: Option<usize>,
    lead_spacing: Option<f64>,
    modulus: f64,
    load: Option<f64>,
    approach: Option<f64>,
    datum: Option<f64>,
    boundary: String,
    pressure_limit: Option<f64>,
    settings: SolverSettings,
}

impl Asked {
    fn boundary(&self) -> Result<Boundary, Failure> {
        Ok(match named("boundary", &self.boundary)? {
            BoundaryOfContact::Free => Boundary::FreeEnds,
            BoundaryOfContact::Periodic => Boundary::Periodic(PeriodicKernel::Strip),
            BoundaryOfContact::PeriodicSpectral => Boundary::Periodic(PeriodicKernel::Spectral),
        })
    }

    /// Rows along the lead of a patch.
    fn lead(&self) -> Option<Lead> {
        let (rows, spacing) = self.rows.zip(self.lead_spacing)?;
        let spacing = Length::from_si(spacing);
        Some(Lead { rows, spacing })
    }

    fn control(&self, points: usize) -> Result<Control, Failure> {
        let window = self.spacing * (points / self.rows.unwrap_or(1).max(1)) as f64;
        match (self.load, self.approach) {
            (Some(load), None) => Ok(Control::Load(LineLoad::from_si(load))),
            (None, Some(approach)) => Ok(Control::Approach {
                approach: Length::from_si(approach),
                datum: Length::from_si(self.datum.unwrap_or(2.0 * window)),
            }),
            _ => {
                let message = "load and approach: one of both is needed";
                let help = Remedy::act("give either load or approach");
                Err(Failure::new(Code::E205, message).advising(help))
            }
        }
    }
}

/// Solver of the last contact over a gap, whose operators and buffers the next contact of its shape uses.
static LAST: Mutex<Option<Solver>> = Mutex::new(None);
/// Largest number of points of a stored solver, which then holds some 20 MB.
const MOST_STORED: usize = 1 << 18;

/// Solves a problem by the last solver if it has the shape of the problem. Does not wait for another thread.
fn solve(
    problem: &ContactProblem,
    settings: &SolverSettings,
) -> Result<ContactSolution, ContactError> {
    let points = problem.gap.len();
    let last = LAST.try_lock().ok().and_then(|mut last| last.take());
    let rows = problem.lead.map_or(1, |lead| lead.rows);
    let fits = |last: &Solver| {
        let shape = last.shape();
        (shape.points, shape.rows, shape.boundary) == (points, rows, problem.boundary)
    };
    let mut solver = match last.filter(fits) {
        Some(last) => last,
        None => Solver::from_problem(problem)?,
    };
    let solution = solver.solve(problem, settings)?;
    if points <= MOST_STORED
        && let Ok(mut last) = LAST.try_lock()
    {
        *last = Some(solver);
    }
    Ok(solution)
}

/// The contact over a gap in m; numbers and settings in JSON.
#[pyfunction]
pub fn solve_contact<'py>(
    py: Python<'py>,
    gap: Input<'py>,
    asked: &str,
    prescribed_pressure: Option<Input<'py>>,
    start: Option<Input<'py>>,
) -> PyResult<(String, Bound<'py, PyDict>)> {
    let asked: Asked = failure::asked(asked)?;
    let gap = copied(&gap);
    let prescribed = prescribed_pressure.as_ref().map(copied);
    let start = start.as_ref().map(copied);
    let solution = alone(py, || {
        let problem = ContactProblem {
            gap: &gap,
            spacing: Length::from_si(asked.spacing),
            modulus: Pressure::from_si(asked.modulus),
            boundary: asked.boundary()?,
            control: asked.control(gap.len())?,
            prescribed_pressure: prescribed.as_deref(),
            pressure_limit: asked.pressure_limit.map(Pressure::from_si),
            lead: asked.lead(),
            start: start.as_deref(),
        };
        Ok(solve(&problem, &asked.settings)?)
    })?;
    let numbers = ContactNumbers {
        rows: asked.rows,
        lead_spacing_m: asked.lead_spacing,
        ..ContactNumbers::of(&solution, asked.spacing)
    };
    found(py, solution, gap, &numbers)
}

/// A run-in before the contact of two flanks.
#[derive(serde::Deserialize)]
struct RunIn {
    passes: usize,
    first_share: f64,
}

/// The contact of two flanks on a curved body, run in first where that is asked for.
#[pyfunction]
pub fn press_flanks<'py>(
    py: Python<'py>,
    first: &Trace,
    second: &Trace,
    radius: f64,
    asked: &str,
    run_in: Option<&str>,
) -> PyResult<(String, Bound<'py, PyDict>)> {
    let asked: Asked = failure::asked(asked)?;
    let run_in: Option<RunIn> = run_in.map(failure::asked).transpose()?;
    let (solution, gap, numbers) = alone(py, || {
        let load = asked
            .load
            .ok_or_else(|| Failure::new(Code::E205, "two flanks need a load"))?;
        let flanks = TwoFlanks {
            first: &first.profile,
            second: &second.profile,
            radius: Length::from_si(radius),
            load: LineLoad::from_si(load),
            modulus: Pressure::from_si(asked.modulus),
            pressure_limit: asked.pressure_limit.map(Pressure::from_si),
        };
        let ran_in = match &run_in {
            Some(plan) => {
                let shares = [plan.first_share, 1.0 - plan.first_share];
                let plan = RunningIn::evenly(first.profile.len(), plan.passes)?;
                Some(RunningIn { shares, ..plan }.run(&flanks, &asked.settings)?)
            }
            None => None,
        };
        let worn = match &ran_in {
            Some(ran_in) => {
                let [first, second] = &ran_in.flanks;
                TwoFlanks {
                    first,
                    second,
                    ..flanks
                }
            }
            None => flanks,
        };
        let running_in = ran_in.iter().flat_map(|ran_in| &ran_in.cycles);
        let running_in = running_in.map(|cycle| RunningInCycle {
            plastic_energy_j_per_m: cycle.dissipated.si(),
            largest_flow_m: cycle.largest_flow.si(),
            contact_fraction: cycle.contact_fraction,
            rq_first_m: cycle.rq[0].si(),
            rq_second_m: cycle.rq[1].si(),
            peak_first_m: cycle.peak[0].si(),
            peak_second_m: cycle.peak[1].si(),
        });
        let solution = worn.press(&asked.settings)?;
        let numbers = ContactNumbers {
            running_in: Some(running_in.collect()),
            ..ContactNumbers::of(&solution, worn.spacing()?.si())
        };
        Ok((solution, worn.gap()?, numbers))
    })?;
    found(py, solution, gap, &numbers)
}

/// Bounds of the error of a contact.
#[derive(Clone, Serialize, Deserialize)]
struct ContactCertificate {
    duality_gap: f64,
    penetration: f64,
    load_error: f64,
    reference_gap_m: f64,
}

/// A warning about a contact.
#[derive(Clone, Serialize, Deserialize)]
struct ContactNote {
    code: String,
    text: String,
}

/// A cycle of running-in.
#[derive(Clone, Serialize, Deserialize)]
struct RunningInCycle {
    /// Plastic energy of the cycle \[J/m\].
    plastic_energy_j_per_m: f64,
    /// Largest plastic displacement of a point in it \[m\].
    largest_flow_m: f64,
    /// Share of the points in contact.
    contact_fraction: f64,
    /// Rq of the first surface after it \[m\].
    rq_first_m: f64,
    /// Rq of the second surface after it \[m\].
    rq_second_m: f64,
    /// Height of the highest peak of the first surface after it \[m\].
    peak_first_m: f64,
    /// Height of the highest peak of the second surface after it \[m\].
    peak_second_m: f64,
}

/// Numbers of a contact, as the command has them.
#[derive(Clone, Serialize, Deserialize)]
pub struct ContactNumbers {
    points: usize,
    spacing_m: f64,
    /// Rows along the lead of a patch.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    rows: Option<usize>,
    /// Distance of the rows \[m\].
    #[serde(default, skip_serializing_if = "Option::is_none")]
    lead_spacing_m: Option<f64>,
    load_n_per_m: f64,
    approach_m: f64,
    approach_datum_m: f64,
    contact_fraction: f64,
    p_max_pa: f64,
    p_end_pa: f64,
    plastic_energy_j_per_m: f64,
    elastic_energy_j_per_m: f64,
    iterations: usize,
    certificate: ContactCertificate,
    warnings: Vec<ContactNote>,
    /// Place on the path of a contact of a case.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub path_fraction: Option<f64>,
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub hertz_p_max_pa: Option<f64>,
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub hertz_half_width_m: Option<f64>,
    /// Cycles of running-in of two flanks.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    running_in: Option<Vec<RunningInCycle>>,
}

impl ContactNumbers {
    /// Numbers of a solution over a gap whose points are `spacing` in m apart.
    pub fn of(solution: &ContactSolution, spacing: f64) -> Self {
        let certificate = &solution.certificate;
        let note = |warning: ContactWarning| {
            let code = match warning {
                ContactWarning::PressureAtEnd { .. } => Code::W413,
                _ => Code::W414,
            };
            ContactNote {
                code: code.as_str().to_owned(),
                text: warning.to_string(),
            }
        };
        Self {
            points: solution.pressure.len(),
            spacing_m: spacing,
            rows: None,
            lead_spacing_m: None,
            load_n_per_m: solution.load.si(),
            approach_m: solution.approach.si(),
            approach_datum_m: solution.datum.si(),
            contact_fraction: solution.contact_fraction,
            p_max_pa: solution.max_pressure.si(),
            p_end_pa: solution.end_pressure.si(),
            plastic_energy_j_per_m: solution.dissipated.si(),
            elastic_energy_j_per_m: solution.elastic_energy.si(),
            iterations: solution.iterations,
            certificate: ContactCertificate {
                duality_gap: certificate.duality_gap,
                penetration: certificate.penetration,
                load_error: certificate.load_error,
                reference_gap_m: certificate.reference_gap.si(),
            },
            warnings: solution.warnings().into_iter().map(note).collect(),
            path_fraction: None,
            hertz_p_max_pa: None,
            hertz_half_width_m: None,
            running_in: None,
        }
    }
}

/// The numbers as JSON, and the arrays.
pub fn found<'py>(
    py: Python<'py>,
    solution: ContactSolution,
    gap: Vec<f64>,
    numbers: &ContactNumbers,
) -> PyResult<(String, Bound<'py, PyDict>)> {
    let points = gap.len() / numbers.rows.unwrap_or(1).max(1);
    let middle = 0.5 * points.saturating_sub(1) as f64;
    let x = (0..points)
        .map(|i| (i as f64 - middle) * numbers.spacing_m)
        .collect();
    let arrays = [
        ("x", x),
        ("undeformed", gap),
        ("pressure", solution.pressure),
        ("gap", solution.gap),
        ("displacement", solution.displacement),
        ("plastic_displacement", solution.plastic_displacement),
    ];
    Ok((failure::json(numbers)?, columns(py, arrays)?))
}

/// Stress under a surface: numbers as JSON; arrays with a row per depth, flat.
#[pyfunction]
pub fn subsurface_stress<'py>(
    py: Python<'py>,
    pressure: Input<'py>,
    traction: Option<Input<'py>>,
    spacing: f64,
    depths: Input<'py>,
    poisson: f64,
) -> PyResult<(String, Bound<'py, PyDict>)> {
    let (pressure, depths) = (copied(&pressure), copied(&depths));
    let traction = traction.as_ref().map(copied);
    let (field, von_mises, peak) = alone(py, || {
        let spacing = Length::from_si(spacing);
        let field = stress_below(&pressure, traction.as_deref(), spacing, &depths)?;
        let von_mises = field.von_mises(poisson)?;
        let peak = field.peak(&von_mises);
        Ok((field, von_mises, peak))
    })?;
    let numbers = json!({
        "von_mises_max_pa": peak.map(|peak| peak.value.si()),
        "von_mises_position_m": peak.map(|peak| peak.position.si()),
        "von_mises_depth_m": peak.map(|peak| peak.depth.si()),
    });
    let arrays = [
        ("depths", field.depths),
        ("sigma_xx", field.sigma_xx),
        ("sigma_zz", field.sigma_zz),
        ("tau_xz", field.tau_xz),
        ("von_mises", von_mises),
    ];
    Ok((failure::json(&numbers)?, columns(py, arrays)?))
}
