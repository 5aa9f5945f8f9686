//! Newton's method on the balances of all nodes with a primal-dual active set.
//!
//! A node is full (P > 0, its balance holds), cavitated (P = 0, void fraction θ > 0, its balance holds)
//! or in contact (H = H_b, its balance may only lack oil: a boundary film supplies oil and swallows
//! none). Above a ceiling of the pressure the surface yields locally.

use std::f64::consts::FRAC_PI_2;

use asperity_core::cite;

use crate::bands::Bands;
use crate::fluid::Fluid;
use crate::grid::Grid;
use crate::linear::{ElasticSystem, Linearised};
use crate::reynolds::{Fields, Reynolds, Storage};

/// Largest void fraction.
const MOST_VOID: f64 = 1.0 - 1e-9;
/// Iteration from which a node on the border of two states keeps them within [`SLACK`].
const PATIENCE: usize = 9;
/// Film that such a node may lack when full, and oil that it may swallow in contact, over the boundary film.
const SLACK: f64 = 1e-2;
/// Oil that a node in contact may swallow before, over the boundary film.
const RELEASE: f64 = 1e-3;
/// Iteration from which nodes stay in contact: one that is too thin when full and swallows oil in contact
/// has no consistent state.
const LAST_RELEASE: usize = 16;
/// Most nodes without a consistent state in an accepted solution.
const MOST_HELD: usize = 2;

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
}

/// Ceiling of the pressure as a local compliance above it.
///
/// Hᵢ += c·max(0, Pᵢ − P_flow)                                              `[EHL-ceiling]`
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) struct Ceiling {
    pub(crate) pressure: f64,
    pub(crate) compliance: f64,
}

impl Ceiling {
    /// Compliance at a pressure.
    fn at(self, pressure: f64) -> f64 {
        if pressure > self.pressure {
            self.compliance
        } else {
            0.0
        }
    }
}

/// One nonlinear problem.
#[derive(Clone, Copy)]
pub(crate) struct Problem<'a> {
    pub(crate) grid: &'a Grid,
    pub(crate) fluid: &'a Fluid,
    /// Undeformed gap of the nodes.
    pub(crate) gap: &'a [f64],
    /// Boundary film H_b.
    pub(crate) contact_film: f64,
    pub(crate) storage: Option<Storage<'a>>,
    pub(crate) ceiling: Option<Ceiling>,
}

/// When to stop.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) struct Limits {
    /// Largest change of the pressure in the last iteration.
    pub(crate) tolerance: f64,
    /// Residual of the linear systems.
    pub(crate) linear_tolerance: f64,
    /// Largest change of the pressure in one iteration.
    pub(crate) largest_change: f64,
    pub(crate) iterations: usize,
    /// Nodes that may change state in the last iteration.
    pub(crate) flips: usize,
    /// Error of the load, over the load.
    pub(crate) load: f64,
}

/// Loosest residual of a linear system far from the solution.
const LOOSEST_LINEAR: f64 = 1e-3;
/// Residual over the square of the last change: what is left is then that of Newton's method.
const FORCING: f64 = 0.1;

impl Limits {
    /// Residual of the next linear system, no finer than Newton's method is there.
    ///
    /// tol = clamp(0.1·δ², linear tolerance, 10⁻³), δ the last change of the pressure.
    fn forcing(&self, effort: &Effort) -> f64 {
        let wanted = match effort.iterations {
            0 => LOOSEST_LINEAR,
            _ => FORCING * effort.change * effort.change,
        };
        wanted.clamp(
            self.linear_tolerance,
            LOOSEST_LINEAR.max(self.linear_tolerance),
        )
    }
}

/// How an iteration ended.
#[derive(Debug, Clone, Copy, PartialEq, Default)]
pub(crate) struct Effort {
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
    pub(crate) effort: Effort,
}

/// Arrays of the iteration, kept between problems on one grid.
pub(crate) struct Newton {
    reynolds: Reynolds,
    film: Vec<f64>,
    displacement: Vec<f64>,
    balance: Vec<f64>,
    right: Vec<f64>,
    step: Vec<f64>,
    change: Vec<f64>,
    cavitated: Vec<bool>,
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
            cavitated: vec![false; nodes],
            local: Bands::zero(nodes),
        }
    }

    /// Solves `problem` from `start`.
    ///
    /// # Errors
    /// With what the last iteration did, when it does not converge.
    pub(crate) fn solve(
        &mut self,
        problem: &Problem,
        system: &mut impl ElasticSystem,
        start: Unknowns,
        limits: &Limits,
    ) -> Result<Solution, Effort> {
        if problem.ceiling.is_some() {
            cite!("EHL-ceiling");
        }
        let mut unknowns = start;
        let mut effort = Effort::default();
        loop {
            self.evaluate(problem, system, &unknowns);
            let load = problem.grid.integral(&unknowns.pressure) / FRAC_PI_2;
            let is_loaded = (load - 1.0).abs() <= limits.load;
            let least = -release_limit(effort.iterations) * problem.contact_film;
            let is_settled = effort.change < limits.tolerance && effort.flips <= limits.flips;
            if effort.iterations > 0 && is_loaded && is_settled {
                let most = if effort.iterations < LAST_RELEASE {
                    0
                } else {
                    MOST_HELD
                };
                let held = self.swallowing(least, &unknowns);
                if held <= most {
                    effort.loose = held > 0;
                    return Ok(self.solution(unknowns, effort));
                }
            }
            if effort.iterations >= limits.iterations || !effort.change.is_finite() {
                return Err(effort);
            }
            if (1..LAST_RELEASE).contains(&effort.iterations) {
                self.release(least, &mut unknowns);
            }
            self.linearise(problem, &unknowns);
            let linearised = Linearised {
                film: &self.reynolds.slopes[1],
                local: &self.local,
                cavitated: &self.cavitated,
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
        problem: &Problem,
        system: &mut impl ElasticSystem,
        unknowns: &Unknowns,
    ) {
        system.displacement(&unknowns.pressure, &mut self.displacement);
        for (i, film) in self.film.iter_mut().enumerate() {
            *film = unknowns.rigid + problem.gap[i] + self.displacement[i];
        }
        if let Some(ceiling) = problem.ceiling {
            for (film, p) in self.film.iter_mut().zip(&unknowns.pressure) {
                *film += ceiling.compliance * (p - ceiling.pressure).max(0.0);
            }
        }
        let fields = Fields {
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

    /// Number of nodes in contact with a balance below `least`.
    fn swallowing(&self, least: f64, unknowns: &Unknowns) -> usize {
        let nodes = unknowns.state.iter().zip(&self.balance);
        nodes
            .filter(|(state, balance)| **state == NodeState::Contact && **balance < least)
            .count()
    }

    /// Releases the nodes in contact that would swallow oil.
    fn release(&self, least: f64, unknowns: &mut Unknowns) {
        for (state, balance) in unknowns.state.iter_mut().zip(&self.balance) {
            if *state == NodeState::Contact && *balance < least {
                *state = NodeState::Full;
            }
        }
    }

    /// Rows of the ends and of the contact, the mask of the void fraction, the right-hand side.
    fn linearise(&mut self, problem: &Problem, unknowns: &Unknowns) {
        let nodes = self.film.len();
        let [pressure, film, void] = &mut self.reynolds.slopes;
        for i in 0..nodes {
            self.cavitated[i] = unknowns.state[i] == NodeState::Cavitated;
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
        for k in 0..4 {
            let (local, p) = (&mut self.local.diagonal[k], &pressure.diagonal[k]);
            local.copy_from_slice(p);
            for (j, cavitated) in self.cavitated.iter().enumerate() {
                // Row i = j − k + 2 has this node on its diagonal k.
                if *cavitated && j + 2 >= k && j + 2 - k < nodes {
                    local[j + 2 - k] = void.diagonal[k][j + 2 - k];
                }
            }
        }
        if let Some(ceiling) = problem.ceiling {
            self.add_ceiling(ceiling, &unknowns.pressure);
        }
    }

    /// A node above the ceiling opens its film by its own pressure.
    fn add_ceiling(&mut self, ceiling: Ceiling, pressure: &[f64]) {
        let nodes = pressure.len();
        for (j, p) in pressure.iter().enumerate() {
            let compliance = ceiling.at(*p);
            if compliance > 0.0 {
                for k in 0..4 {
                    if j + 2 >= k && j + 2 - k < nodes {
                        let i = j + 2 - k;
                        self.local.diagonal[k][i] +=
                            compliance * self.reynolds.slopes[1].diagonal[k][i];
                    }
                }
            }
        }
    }

    /// Takes the damped step and changes states.
    fn advance(
        &mut self,
        problem: &Problem,
        system: &mut impl ElasticSystem,
        unknowns: &mut Unknowns,
        limits: &Limits,
        effort: &mut Effort,
    ) {
        let nodes = self.film.len();
        for i in 0..nodes {
            self.change[i] = if self.cavitated[i] { 0.0 } else { self.step[i] };
        }
        effort.change = largest(&self.change);
        let factor = (limits.largest_change / effort.change).min(1.0);
        system.displacement(&self.change, &mut self.displacement);
        let approach = self.step[nodes];
        effort.flips = 0;
        let lack = if effort.iterations < PATIENCE {
            0.0
        } else {
            SLACK
        };
        let touching = problem.contact_film * (1.0 - lack);
        for i in 1..nodes - 1 {
            let opened = problem.ceiling.map_or(0.0, |c| c.at(unknowns.pressure[i]));
            let film =
                self.film[i] + factor * (self.displacement[i] + approach + opened * self.change[i]);
            unknowns.pressure[i] += factor * self.change[i];
            if self.cavitated[i] {
                unknowns.void[i] += factor * self.step[i];
            }
            let old = unknowns.state[i];
            let is_touching = film < touching;
            let new = next_state(old, unknowns.pressure[i], unknowns.void[i], is_touching);
            effort.flips += usize::from(new != old);
            unknowns.state[i] = new;
            if new == NodeState::Cavitated {
                unknowns.pressure[i] = 0.0;
                unknowns.void[i] = unknowns.void[i].clamp(0.0, MOST_VOID);
            } else {
                unknowns.pressure[i] = unknowns.pressure[i].max(0.0);
                unknowns.void[i] = 0.0;
            }
        }
        unknowns.rigid += factor * approach;
    }

    fn solution(&self, unknowns: Unknowns, effort: Effort) -> Solution {
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

/// Oil that a node in contact may swallow, over the boundary film.
fn release_limit(iterations: usize) -> f64 {
    if iterations < PATIENCE {
        RELEASE
    } else {
        SLACK
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

fn next_state(old: NodeState, pressure: f64, void: f64, is_touching: bool) -> NodeState {
    let new = match old {
        NodeState::Full | NodeState::Contact if pressure < 0.0 => NodeState::Cavitated,
        NodeState::Cavitated if void < 0.0 => NodeState::Full,
        _ => old,
    };
    if new == NodeState::Full && is_touching {
        NodeState::Contact
    } else {
        new
    }
}
