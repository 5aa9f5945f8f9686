//! Dense solver: the matrix of the touching points with an active set, O(n³), exact to round-off.
//!
//! The tests of the fast solver compare with it, [`Solver::solve_exactly`](crate::Solver::solve_exactly) finishes a contact
//! with it, and the gradient of a contact is solved with its factor ([`FixedSets`]).
//!
//! Every point is apart, touching or flowing. With these sets known the problem is linear and is
//! solved by a Cholesky factorisation; points whose pressure or gap has the wrong sign then change
//! sets until none does. This takes three to fifteen steps of O(n³), one or two from a converged start.
//!
//! | symbol | meaning | unit |
//! |---|---|---|
//! | y = p·a/(π·E*) | pressure in units that make the matrix dimensionless | m |
//! | A = C/a | dimensionless kernel, with the datum | - |
//! | h, g, α | undeformed gap, gap, approach | m |

use std::f64::consts::TAU;

use asperity_core::cite;
use asperity_core::numerics::Cholesky;
use asperity_core::quantity::{Length, Pressure};
use serde::Serialize;

use crate::boundary::{Boundary, PeriodicKernel};
use crate::convolution::vectorised;
use crate::error::ContactError;
use crate::grid::plane_kernel;
use crate::half_plane::cell_compliance;
use crate::problem::{ContactProblem, Control};
use crate::strip_kernel::{column_of_period, spectral_symbol, strip, strip_column};

/// Largest number of touching points: a factor of 9 MB.
pub const MAX_POINTS: usize = 1500;
/// Steps after which sets that still change are assumed to cycle.
const MAX_SET_UPDATES: usize = 100;
/// Overlap, relative to the range of the gap, that counts as round-off and leaves a point in its set.
const ROUND_OFF: f64 = 1e-12;

/// Solution that is exact except for round-off.
#[derive(Debug, Clone, PartialEq, Serialize)]
#[non_exhaustive]
pub struct DenseSolution {
    /// Pressure between the solids in Pa.
    pub pressure: Vec<f64>,
    /// Approach, relative to the same datum as in [`ContactSolution`](crate::ContactSolution).
    pub approach: Length,
    /// Linear systems solved.
    pub steps: usize,
}

#[derive(Clone, Copy, PartialEq)]
enum State {
    Apart,
    Touching,
    Flowing,
}

/// The problem in the units of the matrix.
struct DenseProblem {
    matrix: Matrix,
    /// h plus the displacement by the prescribed pressure, minus a controlled approach, in m.
    gap: Vec<f64>,
    /// Σy if the load is controlled.
    sum: Option<f64>,
    limit: f64,
}

/// Solves a problem with at most [`MAX_POINTS`] touching points to round-off. The sets begin as in the start of the problem;
/// without one all points touch.
///
/// # Errors
/// When the problem is not well posed or too large, or its active set does not settle.
///
/// ```
/// use asperity_contact::{Boundary, ContactProblem, Control, dense_reference::solve_dense};
/// let problem = ContactProblem {
///     gap: &[1e-6, 0.0, 1e-6], spacing: "1 um".parse()?, modulus: "100 GPa".parse()?,
///     boundary: Boundary::FreeEnds, control: Control::Load("1 N/mm".parse()?),
///     lead: None, prescribed_pressure: None, pressure_limit: None, start: None,
/// };
/// let pressure = solve_dense(&problem)?.pressure;
/// assert!(pressure[0] == 0.0 && (pressure[1] - 1e9).abs() < 1.0);
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
pub fn solve_dense(problem: &ContactProblem) -> Result<DenseSolution, ContactError> {
    problem.validate()?;
    let compliance = cell_compliance(problem.spacing, problem.modulus)?;
    let dense = DenseProblem::new(problem, compliance)?;
    let mut states = dense.first_states(problem);
    let mut changes = states.len();
    for steps in 1..=MAX_SET_UPDATES {
        let touching = touching(&states);
        if touching.len() > MAX_POINTS {
            return Err(ContactError::too_many_points(touching.len(), MAX_POINTS));
        }
        let Some((y, alpha)) = dense.pressures(&states, &touching) else {
            return Err(ContactError::active_set_unsettled(steps, changes));
        };
        changes = dense.update(&mut states, &y, alpha);
        if changes == 0 {
            return Ok(DenseSolution {
                pressure: pressures(problem, &states, &y, compliance),
                approach: dense.approach(problem, compliance, alpha),
                steps,
            });
        }
    }
    Err(ContactError::active_set_unsettled(MAX_SET_UPDATES, changes))
}

impl DenseProblem {
    fn new(problem: &ContactProblem, compliance: f64) -> Result<Self, ContactError> {
        let rows = problem.cells()?.rows as f64;
        let mut dense = Self {
            matrix: Matrix::of(problem)?,
            gap: problem.gap.to_vec(),
            sum: None,
            limit: limit_of(problem) * compliance,
        };
        if let Some(prescribed) = problem.prescribed_pressure {
            let y: Vec<f64> = prescribed.iter().map(|p| p * compliance).collect();
            let displaced = dense.displacement(&y);
            for (h, u) in dense.gap.iter_mut().zip(displaced) {
                *h += u;
            }
        }
        match problem.control {
            Control::Load(load) => {
                dense.sum = Some(load.si() / problem.spacing.si() * compliance * rows);
            }
            Control::Approach { approach, .. } => {
                for h in &mut dense.gap {
                    *h -= approach.si();
                }
            }
        }
        Ok(dense)
    }

    /// First sets: the sets of a start; without one all points touching under a load, or the points that overlap before
    /// deformation.
    fn first_states(&self, problem: &ContactProblem) -> Vec<State> {
        let start = problem.start;
        if let Some(start) = start.filter(|start| start.iter().any(|p| *p > 0.0)) {
            return states_of(problem, start);
        }
        let first = |&h: &f64| {
            if self.sum.is_some() || h < 0.0 {
                State::Touching
            } else {
                State::Apart
            }
        };
        self.gap.iter().map(first).collect()
    }

    /// Moves points whose pressure or gap has the wrong sign to another set and returns their number.
    fn update(&self, states: &mut [State], y: &[f64], alpha: f64) -> usize {
        let displaced = self.displacement(y);
        let range = |m: f64, h: &f64| m.max((h - self.gap[0]).abs());
        let overlap = ROUND_OFF * self.gap.iter().fold(f64::MIN_POSITIVE, range);
        let mut changes = 0;
        for (i, state) in states.iter_mut().enumerate() {
            let g = displaced[i] + self.gap[i] - alpha;
            let next = match *state {
                State::Touching if y[i] < 0.0 => State::Apart,
                State::Touching if y[i] >= self.limit => State::Flowing,
                State::Apart if g < -overlap => State::Touching,
                State::Flowing if g > overlap => State::Touching,
                same => same,
            };
            changes += usize::from(next != *state);
            *state = next;
        }
        changes
    }

    /// A y
    fn displacement(&self, y: &[f64]) -> Vec<f64> {
        let (kernel, columns) = (&self.matrix.kernel, self.matrix.columns);
        // The kernel over positive and negative lags along rolling, row after row: the displacement by a point is a part of each.
        let rows = kernel.chunks_exact(columns);
        let lags = rows.flat_map(|row| row[1..].iter().rev().chain(row));
        let lags: Vec<f64> = lags.copied().collect();
        let mut displacement = vec![0.0; y.len()];
        let pressed = y.iter().enumerate().filter(|(_, y)| **y != 0.0);
        vectorised(
            #[inline(always)]
            || {
                for (j, &y) in pressed {
                    let (row, column) = (j / columns, j % columns);
                    let displaced = displacement.chunks_exact_mut(columns);
                    for (other, displaced) in displaced.enumerate() {
                        let first = (2 * columns - 1) * row.abs_diff(other) + columns - 1 - column;
                        for (u, c) in displaced.iter_mut().zip(&lags[first..]) {
                            *u += c * y;
                        }
                    }
                }
            },
        );
        displacement
    }

    /// p = π·E*·C⁻¹·(δ − h)                                                                 `[P3]`
    ///
    /// Pressures and approach that close the gap of the touching points; `None` if no touching point is
    /// left to carry the rest of the load.
    fn pressures(&self, states: &[State], touching: &[usize]) -> Option<(Vec<f64>, f64)> {
        cite!("P3");
        let mut y: Vec<f64> = states
            .iter()
            .map(|&state| {
                if state == State::Flowing {
                    self.limit
                } else {
                    0.0
                }
            })
            .collect();
        if touching.is_empty() {
            return self.sum.is_none().then_some((y, 0.0));
        }
        let flowing = self.displacement(&y);
        let factor = self.matrix.factor(touching)?;
        // The pressures are those at zero approach plus α times those of a unit approach.
        let closed = touching.iter().map(|&i| -self.gap[i] - flowing[i]);
        let mut closed: Vec<f64> = closed.collect();
        factor.solve(&mut closed);
        let mut unit = vec![1.0; touching.len()];
        factor.solve(&mut unit);
        let alpha = self.sum.map_or(0.0, |sum| {
            let carried = y.iter().sum::<f64>() + closed.iter().sum::<f64>();
            (sum - carried) / unit.iter().sum::<f64>()
        });
        for ((&point, closed), unit) in touching.iter().zip(&closed).zip(&unit) {
            y[point] = closed + alpha * unit;
        }
        Some((y, alpha))
    }

    /// Approach relative to the datum of the problem; for periodic ends, to a displacement without mean.
    fn approach(&self, problem: &ContactProblem, compliance: f64, alpha: f64) -> Length {
        match (problem.control, problem.boundary) {
            (Control::Approach { approach, .. }, _) => approach,
            (Control::Load(_), Boundary::FreeEnds) => Length::from_si(alpha),
            (Control::Load(_), Boundary::Periodic(_)) => {
                let prescribed: f64 = problem.prescribed_pressure.unwrap_or(&[]).iter().sum();
                let rows = self.matrix.rows as f64;
                let total = self.sum.unwrap_or(0.0) + prescribed * compliance;
                Length::from_si(alpha - datum_term(problem) / rows * total)
            }
        }
    }
}

fn limit_of(problem: &ContactProblem) -> f64 {
    problem.pressure_limit.map_or(f64::INFINITY, Pressure::si)
}

/// Pressures \[Pa\]; at the points that flow the limit to the last digit.
fn pressures(problem: &ContactProblem, states: &[State], y: &[f64], compliance: f64) -> Vec<f64> {
    let pressure = |(state, y): (&State, &f64)| match state {
        State::Apart => 0.0,
        State::Touching => y / compliance,
        State::Flowing => limit_of(problem),
    };
    states.iter().zip(y).map(pressure).collect()
}

/// Sets of the pressures \[Pa\] of a problem.
fn states_of(problem: &ContactProblem, pressure: &[f64]) -> Vec<State> {
    let limit = limit_of(problem);
    let state = |&p: &f64| match p > 0.0 {
        true if p >= limit => State::Flowing,
        true => State::Touching,
        false => State::Apart,
    };
    pressure.iter().map(state).collect()
}

fn touching(states: &[State]) -> Vec<usize> {
    let is_touching = |i: &usize| states[*i] == State::Touching;
    (0..states.len()).filter(is_touching).collect()
}

/// A, from the displacement by one cell.
struct Matrix {
    /// Displacement at the lags along rolling and along the lead, row after row.
    kernel: Vec<f64>,
    columns: usize,
    rows: usize,
}

impl Matrix {
    fn of(problem: &ContactProblem) -> Result<Self, ContactError> {
        let cells = problem.cells()?;
        let datum = datum_term(problem) / cells.rows as f64;
        let mut kernel = match problem.boundary {
            boundary if cells.rows > 1 => plane_kernel(cells, boundary),
            Boundary::FreeEnds => strip_column(cells.columns),
            Boundary::Periodic(PeriodicKernel::Strip) => column_of_period(cells.columns),
            Boundary::Periodic(PeriodicKernel::Spectral) => spectral_column(cells.columns),
        };
        kernel.iter_mut().for_each(|c| *c += datum);
        Ok(Self {
            kernel,
            columns: cells.columns,
            rows: cells.rows,
        })
    }

    fn element(&self, i: usize, j: usize) -> f64 {
        if self.rows == 1 {
            return self.kernel[i.abs_diff(j)];
        }
        let [[row, column], [other_row, other]] =
            [i, j].map(|k| [k / self.columns, k % self.columns]);
        let rows = row.abs_diff(other_row);
        self.kernel[rows * self.columns + column.abs_diff(other)]
    }

    /// Factor of the rows and columns `touching`.
    fn factor(&self, touching: &[usize]) -> Option<Cholesky> {
        let element = |i: usize, j: usize| self.element(touching[i], touching[j]);
        Cholesky::new(touching.len(), element, 0.0)
    }
}

/// A solved contact under a load whose sets are held: its derivatives over the undeformed gap.
#[derive(Debug, Clone)]
pub struct FixedSets {
    points: usize,
    touching: Vec<usize>,
    factor: Cholesky,
    compliance: f64,
}

impl FixedSets {
    /// The sets of the solution `pressure` \[Pa\] of a problem with free ends and a controlled load.
    ///
    /// # Errors
    /// When the problem is not well posed, too large, of another kind, or no point touches.
    pub fn of(problem: &ContactProblem, pressure: &[f64]) -> Result<Self, ContactError> {
        problem.validate()?;
        let compliance = cell_compliance(problem.spacing, problem.modulus)?;
        let states = states_of(problem, pressure);
        let touching = touching(&states);
        if touching.len() > MAX_POINTS {
            return Err(ContactError::too_many_points(touching.len(), MAX_POINTS));
        }
        let is_load = matches!(
            (problem.boundary, problem.control),
            (Boundary::FreeEnds, Control::Load(_))
        );
        match Matrix::of(problem)?.factor(&touching) {
            Some(factor) if is_load && !touching.is_empty() => Ok(Self {
                points: states.len(),
                touching,
                factor,
                compliance,
            }),
            _ => Err(ContactError::active_set_unsettled(0, touching.len())),
        }
    }

    /// Derivative of a number J over the undeformed gap h of each point, through the pressures and the approach α.
    ///
    /// ```text
    /// A_TT dp − dα = −dh_T,  Σ dp = 0:  A_TT λ + ν = ∂J/∂p,  −Σ λ = ∂J/∂α,  ∂J/∂h_T = −λ    [Contact-adjoint]
    /// ```
    ///
    /// T are the touching points; the pressures of the others are fixed. `by_pressure` has a value for every point.
    #[must_use]
    pub fn gap_gradient(&self, by_pressure: &[f64], by_approach: f64) -> Vec<f64> {
        cite!("Contact-adjoint");
        let mut solved: Vec<f64> = self.touching.iter().map(|&i| by_pressure[i]).collect();
        self.factor.solve(&mut solved);
        let mut unit = vec![1.0; self.touching.len()];
        self.factor.solve(&mut unit);
        let by_load =
            (solved.iter().sum::<f64>() + self.compliance * by_approach) / unit.iter().sum::<f64>();
        let mut gradient = vec![0.0; self.points];
        for ((&point, solved), unit) in self.touching.iter().zip(&solved).zip(&unit) {
            gradient[point] = -(solved - by_load * unit) / self.compliance;
        }
        gradient
    }
}

/// Constant added to every element of the matrix: C₀/a, or one for periodic ends under a load, where any
/// value gives the same pressures and a positive one makes the matrix positive definite.
fn datum_term(problem: &ContactProblem) -> f64 {
    match (problem.boundary, problem.control) {
        (Boundary::FreeEnds, _) => -strip(2.0 * problem.datum().si() / problem.spacing.si()),
        (Boundary::Periodic(_), Control::Load(_)) => 1.0,
        (Boundary::Periodic(_), Control::Approach { .. }) => 0.0,
    }
}

/// Kernel of the spectral symbol, by direct summation of its waves.
fn spectral_column(points: usize) -> Vec<f64> {
    let n = points as f64;
    let element = |k: usize| {
        (1..points)
            .map(|wave| {
                let symbol = spectral_symbol(wave.min(points - wave), points);
                symbol / n * (TAU * (wave * k) as f64 / n).cos()
            })
            .sum()
    };
    (0..points).map(element).collect()
}
