//! The paper's way to the load: lower the surfaces into each other step by step until the pressures
//! of solids and fluid together carry it.

use asperity::PositionError;
use asperity::window_pressures::{LoadStep, Pressed, WindowConditions};
use asperity_contact::plasticity::softer_flow_pressure;
use asperity_contact::{Boundary, ContactProblem, ContactSolution, Control, Solver};
use asperity_core::quantity::Length;
use asperity_core::remedy::{Remedy, Setting, Value};
use asperity_core::{Code, Fault};

use super::film_pressure::pressure_at_gap;

/// Steps made while the surfaces are still apart, so that the history shows where they touch.
const STEPS_APART: usize = 5;
/// Most steps; at the paper's 80 nm this is 0.8 mm, far beyond any contact.
const MOST_STEPS: usize = 10_000;
/// Most halvings of a step that went past the load; 2⁻⁴⁰ of a step is below round-off.
const MOST_HALVINGS: usize = 40;

/// State of the marching.
struct March<'a> {
    window: &'a WindowConditions<'a>,
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
pub(crate) fn march(window: &WindowConditions<'_>) -> Result<Pressed, PositionError> {
    let pair = window.pair;
    let lowest = pair.gap.iter().copied().fold(f64::INFINITY, f64::min);
    let march = March {
        window,
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
        let target = self.window.position.load.si();
        let mut step = self.window.paper.delta_step.si();
        let mut approach = self.touch - STEPS_APART as f64 * step;
        let mut start: Option<Vec<f64>> = None;
        let mut halvings = 0;
        let mut error = 1.0;
        while self.history.len() < MOST_STEPS && halvings < MOST_HALVINGS {
            let made = self.step(approach + step, start.as_deref())?;
            error = (made.total - target).abs() / target;
            if error < self.window.paper.numerical_error {
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
        let allowed = self.window.paper.numerical_error;
        Err(load_not_reached(error, allowed, self.history.len()))
    }

    fn step(&mut self, approach: f64, start: Option<&[f64]>) -> Result<Step, PositionError> {
        let [pinion, wheel] = self.window.flow_pressure;
        let problem = ContactProblem {
            gap: &self.window.pair.gap,
            spacing: self.window.pair.spacing,
            modulus: self.window.modulus,
            boundary: Boundary::FreeEnds,
            control: Control::Approach {
                approach: Length::from_si(approach),
                datum: self.datum,
            },
            lead: None,
            prescribed_pressure: None,
            pressure_limit: Some(softer_flow_pressure(pinion, wheel)?),
            start,
        };
        let settings = self.window.model.contact_settings();
        let solids = self.solver.solve(&problem, &settings)?;
        let fluid = pressure_at_gap(self.window, &solids.gap)?;
        let dx = self.window.pair.spacing.si();
        let load_fluid: f64 = fluid.iter().sum::<f64>() * dx;
        let load_solid = solids.load.si();
        let total = load_solid + load_fluid;
        let target = self.window.position.load.si();
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

/// The march did not reach the load within the `allowed` error.
fn load_not_reached(error: f64, allowed: f64, steps: usize) -> PositionError {
    let [left, allowed] = [error, allowed].map(|error| percent(100.0 * error));
    let text = format!(
        "lowering the surfaces step by step left a load error of {left} % after {steps} steps (allowed {allowed} %)"
    );
    let smaller = Remedy::state(Setting::Key("paper.delta_step")).because("to a smaller one");
    let larger = smaller
        .or_set(Setting::Key("paper.numerical_error"), Value::Any)
        .because("to a larger one");
    Fault::new(Code::E304, text).with(larger).into()
}

/// Digits that mean something, however small the value.
fn percent(value: f64) -> String {
    if value >= 0.01 {
        format!("{value:.2}")
    } else {
        format!("{value:.1e}")
    }
}
