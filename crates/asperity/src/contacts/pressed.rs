//! Pressures of film and solids along one window: the film takes its share of the load at once, the solids the rest.

use asperity_contact::plasticity::softer_flow_pressure;
use asperity_contact::{Boundary, ContactProblem, ContactSolution, Control, Solver};
use asperity_core::DomainError;
use asperity_core::quantity::{Length, LineLoad, Pressure};

use crate::mesh::MeshPosition;
use asperity_case::case::Case;
use asperity_case::error::PositionError;
use asperity_case::flanks::WindowPair;
use asperity_case::window_pressures::{LoadStep, Pressed};

/// Points at which the loading history is recorded, in addition to the full load.
const HISTORY_POINTS: usize = 8;

/// Flow pressure of the softer flank.
pub(crate) fn softer(case: &Case) -> Result<Pressure, DomainError> {
    let [pinion, wheel] = case.flow_pressure;
    softer_flow_pressure(pinion, wheel)
}

/// A window under a film that carries a share of the load.
pub(crate) struct Pressing<'a> {
    pub case: &'a Case,
    pub position: &'a MeshPosition,
    pub pair: &'a WindowPair,
    /// Share of the load that the film carries.
    pub film_share: f64,
}

impl Pressing<'_> {
    /// The film's pressure, a share of Hertz's, is prescribed; the solids carry the rest of the load.
    ///
    /// # Errors
    /// When the contact has no solution.
    pub(crate) fn solve(&self) -> Result<Pressed, PositionError> {
        let fluid = self
            .position
            .hertz_pressure(&self.pair.x, self.film_share)?;
        let solids = self.solids(&mut self.solver()?, &fluid, self.solid_load(), None)?;
        Ok(Pressed {
            fluid,
            solids: Some(solids),
            history: Vec::new(),
        })
    }

    fn solver(&self) -> Result<Solver, PositionError> {
        Ok(Solver::new(self.pair.gap.len(), Boundary::FreeEnds)?)
    }

    /// Load on the solids: (1 − c_f) f.
    fn solid_load(&self) -> f64 {
        (1.0 - self.film_share) * self.position.load.si()
    }

    fn solids(
        &self,
        solver: &mut Solver,
        fluid: &[f64],
        load: f64,
        start: Option<&[f64]>,
    ) -> Result<ContactSolution, PositionError> {
        let problem = ContactProblem {
            gap: &self.pair.gap,
            spacing: self.pair.spacing,
            lead: None,
            modulus: self.case.modulus,
            boundary: Boundary::FreeEnds,
            control: Control::Load(LineLoad::from_si(load)),
            prescribed_pressure: Some(fluid),
            pressure_limit: Some(softer(self.case)?),
            start,
        };
        Ok(solver.solve(&problem, &self.case.model.contact_settings())?)
    }
}

/// The way to the solution `pressed`: load on the solids against approach, the film at its full share.
///
/// # Errors
/// When a step has no solution.
pub(crate) fn pressing_history(
    pressing: &Pressing<'_>,
    pressed: &Pressed,
) -> Result<Vec<LoadStep>, PositionError> {
    let Some(full) = &pressed.solids else {
        return Ok(Vec::new());
    };
    let target = pressing.position.load.si();
    let load_fluid = pressing.film_share * target;
    let mut solver = pressing.solver()?;
    let mut rows = Vec::with_capacity(HISTORY_POINTS + 1);
    let mut start: Option<Vec<f64>> = None;
    for step in 1..=HISTORY_POINTS {
        let load = pressing.solid_load() * step as f64 / (HISTORY_POINTS + 1) as f64;
        let solution = pressing.solids(&mut solver, &pressed.fluid, load, start.as_deref())?;
        rows.push((solution.approach, load));
        start = Some(solution.pressure);
    }
    rows.push((full.approach, full.load.si()));
    let origin = rows
        .first()
        .map_or(Length::from_si(0.0), |(first, _)| *first);
    let step = |(approach, load_solid): (Length, f64)| LoadStep {
        approach: approach.si() - origin.si(),
        load_solid,
        load_fluid,
        load_error: (load_solid + load_fluid - target).abs() / target,
    };
    Ok(rows.into_iter().map(step).collect())
}
