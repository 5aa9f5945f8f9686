//! Dense solver: the matrix of the touching points with an active set, O(n³), exact to round-off.
//!
//! The tests of the fast solver compare with it, [`Solver::solve_exactly`](crate::Solver::solve_exactly) finishes a contact
//! with it, and the gradient of a contact is solved with its factor ([`FixedSets`]).
//!
//! Its sets (`exact_sets`) take three to fifteen steps of O(n³), one or two from a converged start.
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
use crate::error::ContactError;
use crate::exact_sets::{ExactSets, Matrix, SetProblem, Settled, State, Unsettled};
use crate::grid::plane_kernel;
use crate::half_plane::cell_compliance;
use crate::problem::{ContactProblem, Control};
use crate::strip_kernel::{column_of_period, spectral_symbol, strip, strip_column};

/// Largest number of touching points: a factor of 9 MB.
pub const MAX_POINTS: usize = 1500;
/// Steps after which sets that still change are assumed to cycle.
const MAX_SET_UPDATES: usize = 100;

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

/// The problem in the units of the matrix.
struct DenseProblem {
    matrix: Matrix,
    columns: usize,
    constant: f64,
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
    let range = |m: f64, h: &f64| m.max((h - dense.gap[0]).abs());
    let range = dense.gap.iter().fold(f64::MIN_POSITIVE, range);
    let mut sets = ExactSets {
        states: dense.first_states(problem),
        ..ExactSets::default()
    };
    let settled = sets.settle(&SetProblem {
        matrix: &dense.matrix,
        gap: &dense.gap,
        columns: dense.columns,
        constant: dense.constant,
        sum: dense.sum,
        limit: dense.limit,
        range,
        most: [MAX_POINTS, MAX_SET_UPDATES],
    });
    let Settled { approach, steps } = settled.map_err(|unsettled| match unsettled {
        Unsettled::TooMany(points) => ContactError::too_many_points(points, MAX_POINTS),
        Unsettled::Changing { steps, points } => ContactError::active_set_unsettled(steps, points),
    })?;
    let limit = limit_of(problem);
    Ok(DenseSolution {
        pressure: sets.pressures(limit, compliance).collect(),
        approach: dense.approach(problem, compliance, approach),
        steps,
    })
}

impl DenseProblem {
    fn new(problem: &ContactProblem, compliance: f64) -> Result<Self, ContactError> {
        let cells = problem.cells()?;
        let (columns, rows) = (cells.columns, cells.rows as f64);
        let mut dense = Self {
            matrix: matrix_of(problem)?,
            columns,
            constant: datum_term(problem) / rows,
            gap: problem.gap.to_vec(),
            sum: None,
            limit: limit_of(problem) * compliance,
        };
        if let Some(prescribed) = problem.prescribed_pressure {
            let y = prescribed.iter().map(|p| p * compliance);
            let by_datum = dense.constant * y.clone().sum::<f64>();
            for h in &mut dense.gap {
                *h += by_datum;
            }
            let y: Vec<(usize, f64)> = y.enumerate().collect();
            dense.matrix.displace(&y, columns, &mut dense.gap);
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
            let limit = limit_of(problem);
            return start
                .iter()
                .map(|p| State::from_pressure(*p, limit))
                .collect();
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

    /// Approach relative to the datum of the problem; for periodic ends, to a displacement without mean.
    fn approach(&self, problem: &ContactProblem, compliance: f64, alpha: f64) -> Length {
        match (problem.control, problem.boundary) {
            (Control::Approach { approach, .. }, _) => approach,
            (Control::Load(_), Boundary::FreeEnds) => Length::from_si(alpha),
            (Control::Load(_), Boundary::Periodic(_)) => {
                let prescribed: f64 = problem.prescribed_pressure.unwrap_or(&[]).iter().sum();
                let total = self.sum.unwrap_or(0.0) + prescribed * compliance;
                Length::from_si(alpha - self.constant * total)
            }
        }
    }
}

fn limit_of(problem: &ContactProblem) -> f64 {
    problem.pressure_limit.map_or(f64::INFINITY, Pressure::si)
}

/// C/a of a problem.
fn matrix_of(problem: &ContactProblem) -> Result<Matrix, ContactError> {
    let cells = problem.cells()?;
    let kernel = match problem.boundary {
        boundary if cells.rows > 1 => plane_kernel(cells, boundary),
        Boundary::FreeEnds => strip_column(cells.columns),
        Boundary::Periodic(PeriodicKernel::Strip) => column_of_period(cells.columns),
        Boundary::Periodic(PeriodicKernel::Spectral) => spectral_column(cells.columns),
    };
    Ok(Matrix::from_kernel(&kernel, cells.columns))
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
    pub fn new(problem: &ContactProblem, pressure: &[f64]) -> Result<Self, ContactError> {
        problem.validate()?;
        let compliance = cell_compliance(problem.spacing, problem.modulus)?;
        let limit = limit_of(problem);
        let is_touching = |i: &usize| State::from_pressure(pressure[*i], limit) == State::Touching;
        let touching: Vec<usize> = (0..pressure.len()).filter(is_touching).collect();
        if touching.len() > MAX_POINTS {
            return Err(ContactError::too_many_points(touching.len(), MAX_POINTS));
        }
        let is_load = matches!(
            (problem.boundary, problem.control),
            (Boundary::FreeEnds, Control::Load(_))
        );
        let cells = problem.cells()?;
        let grid = (cells.columns, datum_term(problem) / cells.rows as f64);
        match matrix_of(problem)?.factor(&touching, grid) {
            Some(factor) if is_load && !touching.is_empty() => Ok(Self {
                points: pressure.len(),
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
