//! Newton's method on the mass balances of all nodes with a primal-dual active set.
//!
//! | state of a node | unknown | condition | changes its state when |
//! |---|---|---|---|
//! | full | P | balance = 0, H ≥ H_b | P < 0: cavitated; H < H_b: contact |
//! | cavitated | void fraction θ | balance = 0, P = 0 | θ < 0: full; H < H_b: contact |
//! | contact | P | H = H_b, balance ≥ 0 | P < 0: cavitated; balance < 0: full |
//! | at the ceiling of P | depth of flow d | P = P_flow | d < 0: elastic |
//!
//! The cavitation conserves mass (Jakobsson, Floberg and Olsson; θ as in Elrod 1981). A node in contact has the
//! boundary film H_b; its balance may only lack oil, which the boundary film supplies.
//!
//! Each iteration solves the linearised equations with the present states, then moves every node whose condition is
//! violated to another state. This primal-dual active set is a semismooth Newton method (Hintermüller, Ito and Kunisch,
//! SIAM J. Optim. 13, 2002, 865-888): most time steps converge in seven iterations, but a node on the border of two
//! states may alternate between them without end. The constants `..._FROM` below resolve such cycles; each later one
//! relaxes the conditions further.

use std::f64::consts::FRAC_PI_2;

use asperity_core::cancel::checkpoint;
use asperity_core::cite;

use crate::bands::Bands;
use crate::fluid::Fluid;
use crate::grid::FilmGrid;
use crate::linear::{ElasticSystem, Linearised};
use crate::reynolds::{Reynolds, ReynoldsFields, Storage};

/// Largest void fraction: the oil of a node, (1 − θ)·ρ·H, stays positive.
const MAX_VOID: f64 = 1.0 - 1e-9;
/// Oil that a node in contact may absorb, over the boundary film: the residual that the linear systems of a
/// converged step leave.
const SWALLOW_TOLERANCE: f64 = 1e-3;
/// Iteration from which a node on the border of two states keeps its state within [`HYSTERESIS`]: most steps converge in
/// seven iterations, and a node that still changes its state after them usually alternates.
const HYSTERESIS_FROM: usize = 9;
/// Film that such a node may lack out of contact, and oil that it may absorb in contact, over the boundary film.
const HYSTERESIS: f64 = 1e-2;
/// Iteration from which such a node may stay out of contact with a film down to [`THINNEST_FILM`]: its oil is
/// conserved, and only H_b, which is not a measured length, is undercut.
const NO_NEW_CONTACT_FROM: usize = 12;
/// Thinnest film of a node out of contact, over the boundary film.
const THINNEST_FILM: f64 = 0.01;
/// Iteration from which no contact is released: a node that is too thin out of contact and absorbs oil in contact
/// has no consistent state, and is held in contact.
const NO_RELEASE_FROM: usize = 20;
/// Largest number of nodes without a consistent state in an accepted solution; with more of them the time step is
/// repeated at half its length. [`NewtonEffort::loose`] reports them.
const MAX_HELD_NODES: usize = 2;

/// State of a node of the film.
#[derive(Debug, Clone, Copy, PartialEq, Eq, serde::Serialize)]
#[serde(rename_all = "kebab-case")]
pub enum NodeState {
    /// Filled with oil under pressure.
    Full,
    /// Without pressure, partly filled.
    Cavitated,
    /// At the thickness of the boundary film.
    Contact,
}

/// Unknowns of the problem.
#[derive(Debug, Clone, PartialEq)]
pub(crate) struct Unknowns {
    pub(crate) pressure: Vec<f64>,
    pub(crate) void: Vec<f64>,
    pub(crate) state: Vec<NodeState>,
    /// Approach h₀ of the rigid bodies.
    pub(crate) rigid: f64,
    /// Depth to which a node at the ceiling has flowed; `None` for an elastic node.
    pub(crate) flow: Vec<Option<f64>>,
}

/// Ceiling of the pressure: a node below it is elastic; a node at it has flowed plastically to the depth d.
///
/// Hᵢ += dᵢ, 0 ≤ dᵢ ⊥ P_flow − Pᵢ ≥ 0                                       `[EHL-ceiling]`
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) struct Ceiling {
    pub(crate) pressure: f64,
}

/// One nonlinear problem.
#[derive(Clone, Copy)]
pub(crate) struct NewtonProblem<'a> {
    pub(crate) grid: &'a FilmGrid,
    pub(crate) fluid: &'a Fluid,
    /// Undeformed gap of the nodes.
    pub(crate) gap: &'a [f64],
    /// Boundary film H_b.
    pub(crate) contact_film: f64,
    pub(crate) storage: Option<Storage<'a>>,
    pub(crate) ceiling: Option<Ceiling>,
}

/// Limits of the iteration.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) struct Limits {
    /// Largest change of the pressure in the last iteration.
    pub(crate) tolerance: f64,
    /// Residual of the linear systems near the solution.
    pub(crate) linear_tolerance: f64,
    /// Residual of the linear systems far from it.
    pub(crate) loosest: f64,
    /// Largest change of the pressure in one iteration.
    pub(crate) largest_change: f64,
    pub(crate) iterations: usize,
    /// Nodes that may change state in the last iteration.
    pub(crate) flips: usize,
    /// Error of the load, over the load.
    pub(crate) load: f64,
}

/// Residual of the linear system over the square of the last change. Newton's error is about the square of the change,
/// so that a tenth of it does not slow the convergence (inexact Newton: Eisenstat and Walker, SIAM J. Sci. Comput. 17,
/// 1996, 16-32).
const FORCING: f64 = 0.1;

impl Limits {
    /// Residual of the next linear system, no smaller than the error of the Newton step needs.
    ///
    /// clamp(0.1·δ², tightest, loosest), δ the last change of the pressure.
    fn forcing(&self, effort: &NewtonEffort) -> f64 {
        let residual = match effort.iterations {
            0 => self.loosest,
            _ => FORCING * effort.change * effort.change,
        };
        residual.clamp(self.linear_tolerance, self.loosest)
    }
}

/// Outcome of an iteration.
#[derive(Debug, Clone, Copy, PartialEq, Default)]
pub(crate) struct NewtonEffort {
    pub(crate) iterations: usize,
    pub(crate) linear_iterations: usize,
    /// Largest change of the pressure in the last iteration.
    pub(crate) change: f64,
    /// Nodes that changed state in the last iteration.
    pub(crate) flips: usize,
    /// Whether a node without a consistent state was held in contact.
    pub(crate) loose: bool,
    /// Linear systems that ended at the cap of their iterations.
    pub(crate) capped: usize,
}

/// Solution of one problem.
#[derive(Debug, Clone)]
pub(crate) struct Solution {
    pub(crate) unknowns: Unknowns,
    pub(crate) film: Vec<f64>,
    pub(crate) mass: Vec<f64>,
    pub(crate) flux: Vec<f64>,
    /// Balance of every node, storage included.
    pub(crate) balance: Vec<f64>,
    pub(crate) effort: NewtonEffort,
}

/// Arrays of the iteration, reused for every problem on one grid.
pub(crate) struct Newton {
    reynolds: Reynolds,
    film: Vec<f64>,
    displacement: Vec<f64>,
    balance: Vec<f64>,
    right: Vec<f64>,
    step: Vec<f64>,
    change: Vec<f64>,
    /// Nodes whose unknown is the void fraction or the depth of flow.
    masked: Vec<bool>,
    local: Bands,
}

impl Newton {
    pub(crate) fn new(nodes: usize) -> Self {
        Self {
            reynolds: Reynolds::new(nodes),
            film: vec![0.0; nodes],
            displacement: vec![0.0; nodes],
            balance: vec![0.0; nodes],
            right: vec![0.0; nodes + 1],
            step: vec![0.0; nodes + 1],
            change: vec![0.0; nodes],
            masked: vec![false; nodes],
            local: Bands::zero(nodes),
        }
    }

    /// Solves `problem` from `start`.
    ///
    /// # Errors
    /// The effort spent, when the iteration does not converge.
    pub(crate) fn solve(
        &mut self,
        problem: &NewtonProblem,
        system: &mut impl ElasticSystem,
        start: Unknowns,
        limits: &Limits,
    ) -> Result<Solution, NewtonEffort> {
        if problem.ceiling.is_some() {
            cite!("EHL-ceiling");
        }
        let mut unknowns = start;
        let mut effort = NewtonEffort::default();
        // Evaluate, test, change the states that the balances refute, solve the linear system, step.
        loop {
            if checkpoint().is_err() {
                // The caller passes a checkpoint before it tries again.
                return Err(effort);
            }
            self.evaluate(problem, system, &unknowns);
            let load = problem.grid.integral(&unknowns.pressure) / FRAC_PI_2;
            let is_loaded = (load - 1.0).abs() <= limits.load;
            let least = -release_limit(effort.iterations) * problem.contact_film;
            // The last change of the pressure measures the error. A residual of the balances does not: their size varies
            // by decades between inlet and contact.
            let is_settled = effort.change < limits.tolerance && effort.flips <= limits.flips;
            if effort.iterations > 0 && is_loaded && is_settled {
                let most = if effort.iterations < NO_RELEASE_FROM {
                    0
                } else {
                    MAX_HELD_NODES
                };
                let held = self.absorbing(least, &unknowns);
                if held <= most {
                    effort.loose = held > 0;
                    return Ok(self.solution(unknowns, effort));
                }
            }
            if effort.iterations >= limits.iterations || !effort.change.is_finite() {
                return Err(effort);
            }
            if (1..NO_RELEASE_FROM).contains(&effort.iterations) {
                self.release(least, &mut unknowns);
            }
            self.linearise(problem, &unknowns);
            let linearised = Linearised {
                film: &self.reynolds.slopes[1],
                local: &self.local,
                masked: &self.masked,
                weights: &problem.grid.weights,
                transient: problem.storage.is_some(),
            };
            let linear = system.solve(
                &linearised,
                &self.right,
                &mut self.step,
                limits.forcing(&effort),
            );
            effort.linear_iterations += linear.iterations;
            effort.capped += usize::from(linear.capped);
            effort.iterations += 1;
            self.advance(problem, system, &mut unknowns, limits, &mut effort);
        }
    }

    /// Film, flux and balances of the unknowns.
    fn evaluate(
        &mut self,
        problem: &NewtonProblem,
        system: &mut impl ElasticSystem,
        unknowns: &Unknowns,
    ) {
        system.displacement(&unknowns.pressure, &mut self.displacement);
        for (i, film) in self.film.iter_mut().enumerate() {
            *film = unknowns.rigid + problem.gap[i] + self.displacement[i];
        }
        if problem.ceiling.is_some() {
            for (film, depth) in self.film.iter_mut().zip(&unknowns.flow) {
                *film += depth.unwrap_or(0.0);
            }
        }
        let fields = ReynoldsFields {
            pressure: &unknowns.pressure,
            film: &self.film,
            void: &unknowns.void,
        };
        self.reynolds.evaluate(problem.grid, problem.fluid, fields);
        self.reynolds.balance(&mut self.balance);
        if let Some(storage) = problem.storage {
            self.reynolds
                .add_storage(problem.grid, storage, &mut self.balance);
        }
    }

    /// Number of nodes in contact that absorb oil: with a balance below `least`.
    fn absorbing(&self, least: f64, unknowns: &Unknowns) -> usize {
        let nodes = unknowns.state.iter().zip(&self.balance);
        nodes
            .filter(|(state, balance)| **state == NodeState::Contact && **balance < least)
            .count()
    }

    /// Releases the nodes in contact that absorb oil.
    fn release(&self, least: f64, unknowns: &mut Unknowns) {
        for (state, balance) in unknowns.state.iter_mut().zip(&self.balance) {
            if *state == NodeState::Contact && *balance < least {
                *state = NodeState::Full;
            }
        }
    }

    /// Rows of the ends and of the contact, the mask of the void fraction, the right-hand side.
    fn linearise(&mut self, problem: &NewtonProblem, unknowns: &Unknowns) {
        let nodes = self.film.len();
        let [pressure, film, void] = &mut self.reynolds.slopes;
        // Row of each node: P = 0 at both ends, H = H_b in contact, else the balance.
        for i in 0..nodes {
            let is_cavitated = unknowns.state[i] == NodeState::Cavitated;
            self.masked[i] = is_cavitated || unknowns.flow[i].is_some();
            self.right[i] = -self.balance[i];
            if i == 0 || i + 1 == nodes {
                pressure.set_row(i, 1.0);
                film.set_row(i, 0.0);
                void.set_row(i, 1.0);
                self.right[i] = 0.0;
            } else if unknowns.state[i] == NodeState::Contact {
                pressure.set_row(i, 0.0);
                film.set_row(i, 1.0);
                void.set_row(i, 0.0);
                self.right[i] = problem.contact_film - self.film[i];
            }
        }
        self.right[nodes] = FRAC_PI_2 - problem.grid.integral(&unknowns.pressure);
        // Column of each node: the slope over its own unknown, so that one matrix serves all states.
        for k in 0..4 {
            let (local, p) = (&mut self.local.diagonal[k], &pressure.diagonal[k]);
            local.copy_from_slice(p);
            for (j, masked) in self.masked.iter().enumerate() {
                // Row i = j − k + 2 has this node on its diagonal k.
                if *masked && j + 2 >= k && j + 2 - k < nodes {
                    let slopes = match unknowns.flow[j] {
                        Some(_) => &*film,
                        None => &*void,
                    };
                    local[j + 2 - k] = slopes.diagonal[k][j + 2 - k];
                }
            }
        }
    }

    /// Applies the damped step and changes the states of nodes that violate their condition.
    fn advance(
        &mut self,
        problem: &NewtonProblem,
        system: &mut impl ElasticSystem,
        unknowns: &mut Unknowns,
        limits: &Limits,
        effort: &mut NewtonEffort,
    ) {
        let nodes = self.film.len();
        for i in 0..nodes {
            self.change[i] = if self.masked[i] { 0.0 } else { self.step[i] };
        }
        effort.change = largest(&self.change);
        // One factor for all unknowns keeps the linear relation between film and pressure.
        let factor = (limits.largest_change / effort.change).min(1.0);
        system.displacement(&self.change, &mut self.displacement);
        let approach = self.step[nodes];
        effort.flips = 0;
        let touching = problem.contact_film * least_film(effort.iterations);
        for i in 1..nodes - 1 {
            let flowed = match unknowns.flow[i] {
                Some(_) => self.step[i],
                None => 0.0,
            };
            // The film after the step; it is linear in pressure and approach, so no further product is needed.
            let film = self.film[i] + factor * (self.displacement[i] + approach + flowed);
            unknowns.pressure[i] += factor * self.change[i];
            match &mut unknowns.flow[i] {
                Some(depth) => *depth += factor * flowed,
                None if self.masked[i] => unknowns.void[i] += factor * self.step[i],
                None => {}
            }
            effort.flips += usize::from(flow_changes(problem.ceiling, unknowns, i));
            let old = unknowns.state[i];
            let is_touching = film < touching;
            let new = next_state(old, unknowns.pressure[i], unknowns.void[i], is_touching);
            effort.flips += usize::from(new != old);
            unknowns.state[i] = new;
            if new == NodeState::Cavitated {
                unknowns.pressure[i] = 0.0;
                unknowns.void[i] = unknowns.void[i].clamp(0.0, MAX_VOID);
            } else {
                unknowns.pressure[i] = unknowns.pressure[i].max(0.0);
                unknowns.void[i] = 0.0;
            }
        }
        unknowns.rigid += factor * approach;
    }

    fn solution(&self, unknowns: Unknowns, effort: NewtonEffort) -> Solution {
        Solution {
            unknowns,
            film: self.film.clone(),
            mass: self.reynolds.mass.clone(),
            flux: self.reynolds.flux.clone(),
            balance: self.balance.clone(),
            effort,
        }
    }
}

/// Moves node `i` to the ceiling or off it; returns whether its state changed.
fn flow_changes(ceiling: Option<Ceiling>, unknowns: &mut Unknowns, i: usize) -> bool {
    let Some(ceiling) = ceiling else {
        return false;
    };
    match unknowns.flow[i] {
        None if unknowns.pressure[i] > ceiling.pressure => {
            unknowns.pressure[i] = ceiling.pressure;
            unknowns.flow[i] = Some(0.0);
            true
        }
        Some(depth) if depth < 0.0 => {
            unknowns.flow[i] = None;
            true
        }
        _ => false,
    }
}

/// Film below which a node comes into contact, over the boundary film.
fn least_film(iterations: usize) -> f64 {
    match iterations {
        0..HYSTERESIS_FROM => 1.0,
        HYSTERESIS_FROM..NO_NEW_CONTACT_FROM => 1.0 - HYSTERESIS,
        _ => THINNEST_FILM,
    }
}

/// Oil that a node in contact may absorb, over the boundary film.
fn release_limit(iterations: usize) -> f64 {
    if iterations < HYSTERESIS_FROM {
        SWALLOW_TOLERANCE
    } else {
        HYSTERESIS
    }
}

fn largest(values: &[f64]) -> f64 {
    values.iter().fold(0.0, |m: f64, v| {
        let size = v.abs();
        if size.is_nan() {
            f64::INFINITY
        } else {
            m.max(size)
        }
    })
}

/// State of a node after a step, from the condition that its pressure, void fraction or film violates.
///
/// A cavitated node whose film is below the boundary film comes into contact: its pressure becomes an unknown that
/// rises from 0 and widens the film to H_b, and its void is gone.
fn next_state(old: NodeState, pressure: f64, void: f64, is_touching: bool) -> NodeState {
    let new = match old {
        NodeState::Full | NodeState::Contact if pressure < 0.0 => NodeState::Cavitated,
        NodeState::Cavitated if void < 0.0 || is_touching => NodeState::Full,
        _ => old,
    };
    if new == NodeState::Full && is_touching {
        NodeState::Contact
    } else {
        new
    }
}
