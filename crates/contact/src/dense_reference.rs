//! Dense reference solver: the full matrix with an active set, O(n³), exact to round-off.
//!
//! Built with the feature `oracle`; the tests of the fast solver compare with it.
//!
//! Every point is apart, touching or flowing. With these sets known the problem is linear and is
//! solved by a Cholesky factorisation; points whose pressure or gap has the wrong sign then change
//! sets until none does. This takes three to fifteen steps of O(n³).
//!
//! | symbol | meaning | unit |
//! |---|---|---|
//! | y = p·a/(π·E*) | pressure in units that make the matrix dimensionless | m |
//! | A = C/a | dimensionless kernel, with the datum | - |
//! | h, g, α | undeformed gap, gap, approach | m |

use std::f64::consts::TAU;

use asperity_core::quantity::{Length, Pressure};
use faer::linalg::solvers::Solve;
use faer::{Mat, Side};
use serde::Serialize;

use crate::boundary::{Boundary, PeriodicKernel};
use crate::error::ContactError;
use crate::half_plane::cell_compliance;
use crate::problem::{ContactProblem, Control};
use crate::strip_kernel::{column_of_period, spectral_symbol, strip, strip_column};

/// Largest number of points: a matrix of 18 MB.
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
    /// First column of A.
    column: Vec<f64>,
    /// h plus the displacement by the prescribed pressure, minus a controlled approach, in m.
    gap: Vec<f64>,
    /// Σy if the load is controlled.
    sum: Option<f64>,
    limit: f64,
}

/// Solves a problem of at most [`MAX_POINTS`] points to round-off. Its start is ignored.
///
/// # Errors
/// When the problem is not well posed or too large, or its active set does not settle.
///
/// ```
/// use asperity_contact::{Boundary, ContactProblem, Control, dense_reference::solve_dense};
/// let problem = ContactProblem {
///     gap: &[1e-6, 0.0, 1e-6], spacing: "1 um".parse()?, modulus: "100 GPa".parse()?,
///     boundary: Boundary::FreeEnds, control: Control::Load("1 N/mm".parse()?),
///     prescribed_pressure: None, pressure_limit: None, start: None,
/// };
/// let pressure = solve_dense(&problem)?.pressure;
/// assert!(pressure[0] == 0.0 && (pressure[1] - 1e9).abs() < 1.0);
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
pub fn solve_dense(problem: &ContactProblem) -> Result<DenseSolution, ContactError> {
    problem.validate()?;
    let points = problem.gap.len();
    if points > MAX_POINTS {
        return Err(ContactError::TooManyPoints {
            points,
            most: MAX_POINTS,
        });
    }
    let compliance = cell_compliance(problem.spacing, problem.modulus)?;
    let dense = DenseProblem::new(problem, compliance);
    let mut states = dense.first_states();
    let mut changes = points;
    for steps in 1..=MAX_SET_UPDATES {
        let Some((y, alpha)) = dense.pressures(&states) else {
            return Err(ContactError::ActiveSetUnsettled { steps, changes });
        };
        changes = dense.update(&mut states, &y, alpha);
        if changes == 0 {
            return Ok(DenseSolution {
                pressure: y.iter().map(|y| y / compliance).collect(),
                approach: dense.approach(problem, compliance, alpha),
                steps,
            });
        }
    }
    Err(ContactError::ActiveSetUnsettled {
        steps: MAX_SET_UPDATES,
        changes,
    })
}

impl DenseProblem {
    fn new(problem: &ContactProblem, compliance: f64) -> Self {
        let points = problem.gap.len();
        let datum = datum_term(problem);
        let column: Vec<f64> = match problem.boundary {
            Boundary::FreeEnds => strip_column(points),
            Boundary::Periodic(PeriodicKernel::Strip) => column_of_period(points),
            Boundary::Periodic(PeriodicKernel::Spectral) => spectral_column(points),
        }
        .iter()
        .map(|c| c + datum)
        .collect();
        let mut dense = Self {
            column,
            gap: problem.gap.to_vec(),
            sum: None,
            limit: problem.pressure_limit.map_or(f64::INFINITY, Pressure::si) * compliance,
        };
        if let Some(prescribed) = problem.prescribed_pressure {
            let y: Vec<f64> = prescribed.iter().map(|p| p * compliance).collect();
            let displaced = dense.displacement(&y);
            for (h, u) in dense.gap.iter_mut().zip(displaced) {
                *h += u;
            }
        }
        match problem.control {
            Control::Load(load) => dense.sum = Some(load.si() / problem.spacing.si() * compliance),
            Control::Approach { approach, .. } => {
                for h in &mut dense.gap {
                    *h -= approach.si();
                }
            }
        }
        dense
    }

    /// First sets: all points touching under a load, or the points that overlap before deformation.
    fn first_states(&self) -> Vec<State> {
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
        let row = |i: usize| {
            y.iter()
                .enumerate()
                .map(|(j, y)| self.column[i.abs_diff(j)] * y)
                .sum()
        };
        (0..y.len()).map(row).collect()
    }

    /// p = π·E*·C⁻¹·(δ − h)                                                                 `[P3]`
    ///
    /// Pressures and approach that close the gap of the touching points; `None` if no touching point is
    /// left to carry the rest of the load.
    fn pressures(&self, states: &[State]) -> Option<(Vec<f64>, f64)> {
        asperity_core::cite!("P3");
        let touching: Vec<usize> = (0..states.len())
            .filter(|&i| states[i] == State::Touching)
            .collect();
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
        let size = touching.len();
        let matrix = Mat::from_fn(size, size, |i, j| {
            self.column[touching[i].abs_diff(touching[j])]
        });
        // The pressures are those at zero approach (first column) plus α times those of a unit approach (second).
        let right = Mat::from_fn(size, 2, |i, k| {
            let i = touching[i];
            if k == 0 {
                -self.gap[i] - flowing[i]
            } else {
                1.0
            }
        });
        let solved = matrix.llt(Side::Lower).ok()?.solve(&right);
        let column_sum = |k: usize| (0..size).map(|i| solved[(i, k)]).sum::<f64>();
        let alpha = self.sum.map_or(0.0, |sum| {
            (sum - y.iter().sum::<f64>() - column_sum(0)) / column_sum(1)
        });
        for (i, &point) in touching.iter().enumerate() {
            y[point] = solved[(i, 0)] + alpha * solved[(i, 1)];
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
                let total = self.sum.unwrap_or(0.0) + prescribed * compliance;
                Length::from_si(alpha - datum_term(problem) * total)
            }
        }
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
