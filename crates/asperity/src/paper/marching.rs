//! The paper's way to the load: lower the surfaces into each other step by step until the pressures
//! of solids and fluid together carry it.

use asperity_contact::{Boundary, ContactProblem, ContactSolution, Control, Solver};
use asperity_core::quantity::Length;

use super::film_pressure::pressure_at_gap;
use crate::contacts::{LoadStep, Pressed, settings, softer};
use crate::mesh::MeshPosition;
use asperity_case::case::Case;
use asperity_case::error::PositionError;
use asperity_case::flanks::WindowPair;

/// Steps made while the surfaces are still apart, so that the history shows where they touch.
const STEPS_APART: usize = 5;
/// Most steps; at the paper's 80 nm this is 0.8 mm, far beyond any contact.
const MOST_STEPS: usize = 10_000;
/// Most halvings of a step that went past the load; 2⁻⁴⁰ of a step is below round-off.
const MOST_HALVINGS: usize = 40;

/// State of the marching.
struct March<'a> {
    case: &'a Case,
    position: &'a MeshPosition,
    pair: &'a WindowPair,
    solver: Solver,
    /// Approach at which the highest points of the undeformed flanks touch.
    touch: f64,
    datum: Length,
    history: Vec<LoadStep>,
}

/// One step: what the solids carry, what the fluid carries.
struct Step {
    solids: ContactSolution,
    fluid: Vec<f64>,
    total: f64,
}

/// Lowers the surfaces by `delta_step` until |F − F_target| < `numerical_error`·F_target; a step
/// past the load is taken back and halved.
///
/// # Errors
/// When the contact solver fails or the load is not met.
pub(crate) fn march(
    case: &Case,
    position: &MeshPosition,
    pair: &WindowPair,
) -> Result<Pressed, PositionError> {
    let lowest = pair.gap.iter().copied().fold(f64::INFINITY, f64::min);
    let march = March {
        case,
        position,
        pair,
        solver: Solver::new(pair.gap.len(), Boundary::FreeEnds)?,
        touch: lowest,
        // Twice the window, as the solver's own default: the approach is defined up to this choice.
        datum: pair.spacing * (2 * pair.gap.len()) as f64,
        history: Vec::new(),
    };
    march.run()
}

impl March<'_> {
    fn run(mut self) -> Result<Pressed, PositionError> {
        let target = self.position.load.si();
        let mut step = self.case.model.delta_step.si();
        let mut approach = self.touch - STEPS_APART as f64 * step;
        let mut start: Option<Vec<f64>> = None;
        let mut halvings = 0;
        let mut error = 1.0;
        while self.history.len() < MOST_STEPS && halvings < MOST_HALVINGS {
            let made = self.step(approach + step, start.as_deref())?;
            error = (made.total - target).abs() / target;
            if error < self.case.model.numerical_error {
                return Ok(Pressed {
                    fluid: made.fluid,
                    solids: Some(made.solids),
                    history: self.history,
                });
            }
            if made.total > target {
                step *= 0.5;
                halvings += 1;
            } else {
                approach += step;
                start = Some(made.solids.pressure);
            }
        }
        Err(PositionError::marching(
            100.0 * error,
            100.0 * self.case.model.numerical_error,
            self.history.len(),
        ))
    }

    fn step(&mut self, approach: f64, start: Option<&[f64]>) -> Result<Step, PositionError> {
        let problem = ContactProblem {
            gap: &self.pair.gap,
            spacing: self.pair.spacing,
            modulus: self.case.modulus,
            boundary: Boundary::FreeEnds,
            control: Control::Approach {
                approach: Length::from_si(approach),
                datum: self.datum,
            },
            prescribed_pressure: None,
            pressure_limit: Some(softer(self.case)?),
            start,
        };
        let solids = self.solver.solve(&problem, &settings(self.case))?;
        let fluid = pressure_at_gap(self.case, self.position, &self.pair.x, &solids.gap)?;
        let dx = self.pair.spacing.si();
        let load_fluid: f64 = fluid.iter().sum::<f64>() * dx;
        let load_solid = solids.load.si();
        let total = load_solid + load_fluid;
        let target = self.position.load.si();
        self.history.push(LoadStep {
            approach: approach - self.touch,
            load_solid,
            load_fluid,
            load_error: (total - target).abs() / target,
        });
        Ok(Step {
            solids,
            fluid,
            total,
        })
    }
}
