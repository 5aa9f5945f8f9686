//! Film and asperities together: the film takes its share of the load at once, the solids the rest.

use asperity_contact::{Boundary, ContactProblem, ContactSolution, Control, Solver};
use asperity_core::quantity::LineLoad;

use super::carried::Carried;
use super::full_film::hertz_pressure;
use super::rough_contact::{settings, softer};
use crate::case::Case;
use crate::encounter::Encounter;
use crate::error::PositionError;
use crate::result::HistoryRow;
use crate::station::Station;

/// Points at which the loading path is recorded, in addition to the full load.
const LOAD_PATH_POINTS: usize = 8;

/// Parts of the mixed contact of one encounter.
pub(crate) struct Mixed<'a> {
    pub case: &'a Case,
    pub station: &'a Station,
    pub encounter: &'a Encounter,
    /// Share of the load that the film carries.
    pub film_share: f64,
}

impl Mixed<'_> {
    /// A solver for windows of this size.
    pub(crate) fn solver(&self) -> Result<Solver, PositionError> {
        Ok(Solver::new(self.encounter.gap.len(), Boundary::FreeEnds)?)
    }

    /// Load on the solids: (1 − c_f) f.
    fn solid_load(&self) -> f64 {
        (1.0 - self.film_share) * self.station.load.si()
    }

    fn solve(
        &self,
        solver: &mut Solver,
        fluid: &[f64],
        load: f64,
        start: Option<&[f64]>,
    ) -> Result<ContactSolution, PositionError> {
        let problem = ContactProblem {
            gap: &self.encounter.gap,
            spacing: self.encounter.spacing,
            modulus: self.case.modulus,
            boundary: Boundary::FreeEnds,
            control: Control::Load(LineLoad::from_si(load)),
            prescribed_pressure: Some(fluid),
            pressure_limit: Some(softer(self.case)?),
            start,
        };
        Ok(solver.solve(&problem, &settings(self.case))?)
    }
}

/// The film's pressure, a share of Hertz's, prescribed; the solids under the rest of the load.
pub(crate) fn mixed(problem: &Mixed<'_>, solver: &mut Solver) -> Result<Carried, PositionError> {
    let fluid = hertz_pressure(problem.station, &problem.encounter.x, problem.film_share)?;
    let solids = problem.solve(solver, &fluid, problem.solid_load(), None)?;
    Ok(Carried {
        fluid,
        solids: Some(solids),
        history: Vec::new(),
    })
}

/// The way to the solution `carried`: load on the solids against approach, film at its full share.
pub(crate) fn load_path(
    problem: &Mixed<'_>,
    solver: &mut Solver,
    carried: &Carried,
) -> Result<Vec<HistoryRow>, PositionError> {
    let Some(full) = &carried.solids else {
        return Ok(Vec::new());
    };
    let target = problem.station.load.si();
    let load_fluid = problem.film_share * target;
    let mut rows = Vec::with_capacity(LOAD_PATH_POINTS + 1);
    let mut start: Option<Vec<f64>> = None;
    let mut first = None;
    for step in 1..=LOAD_PATH_POINTS {
        let load = problem.solid_load() * step as f64 / (LOAD_PATH_POINTS + 1) as f64;
        let solution = problem.solve(solver, &carried.fluid, load, start.as_deref())?;
        rows.push((solution.approach.si(), load));
        first.get_or_insert(solution.approach.si());
        start = Some(solution.pressure);
    }
    rows.push((full.approach.si(), full.load.si()));
    let origin = first.unwrap_or(full.approach.si());
    Ok(rows
        .into_iter()
        .enumerate()
        .map(|(step, (approach, load_solid))| HistoryRow {
            step: step + 1,
            approach: approach - origin,
            load_solid,
            load_fluid,
            load_error: (load_solid + load_fluid - target).abs() / target,
        })
        .collect())
}
