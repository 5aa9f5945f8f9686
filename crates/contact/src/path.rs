//! Contacts along a path of loads, positions or offsets.
//!
//! Along a path every contact starts from the one before, so the contacts are solved in order.
//!
//! | symbol | meaning | unit |
//! |---|---|---|
//! | p₀, p₁ | pressures of the last two contacts | Pa |
//! | W₀, W₁, W | loads of the last two contacts and of the next | N/m |

use crate::boundary::Boundary;
use crate::error::ContactError;
use crate::problem::{ContactProblem, ContactSolution, Control, SolverSettings};
use crate::solver::Solver;

/// Series of contacts, solved in order on one thread.
///
/// ```
/// use asperity_contact::{Boundary, ContactProblem, Control, Path, SolverSettings};
/// use asperity_core::quantity::LineLoad;
/// let gap: Vec<f64> = (0..1000).map(|i| (0.6e-6 * (f64::from(i) - 499.5)).powi(2) / 6e-3).collect();
/// let mut path = Path::new(1000, Boundary::FreeEnds, SolverSettings::default())?;
/// let mut approach = 0.0;
/// for load in [1e5, 2e5, 3e5] {
///     let solution = path.step(&ContactProblem {
///         gap: &gap, spacing: "0.6 um".parse()?, modulus: "115.4 GPa".parse()?,
///         boundary: Boundary::FreeEnds, control: Control::Load(LineLoad::from_si(load)),
///         lead: None, prescribed_pressure: None, pressure_limit: None, start: None,
///     })?;
///     assert!(solution.approach.si() > approach);
///     approach = solution.approach.si();
/// }
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
pub struct Path {
    solver: Solver,
    settings: SolverSettings,
    last: Option<Step>,
    before: Option<Step>,
}

/// Pressure and load of a solved contact.
struct Step {
    pressure: Vec<f64>,
    load: f64,
}

impl Path {
    /// Makes a path of contacts with this number of points and this boundary.
    ///
    /// # Errors
    /// When there are fewer than two points.
    pub fn new(
        points: usize,
        boundary: Boundary,
        settings: SolverSettings,
    ) -> Result<Self, ContactError> {
        Ok(Self {
            solver: Solver::new(points, boundary)?,
            settings,
            last: None,
            before: None,
        })
    }

    /// Solves the next contact from its own start, or else from the last two contacts, extrapolated to
    /// the new load.
    ///
    /// # Errors
    /// As [`Solver::solve`].
    pub fn step(&mut self, problem: &ContactProblem) -> Result<ContactSolution, ContactError> {
        let start = self.start(problem);
        let problem = ContactProblem {
            start: problem.start.or(start.as_deref()),
            ..*problem
        };
        let solution = self.solver.solve(&problem, &self.settings)?;
        self.before = self.last.take();
        self.last = Some(Step {
            pressure: solution.pressure.clone(),
            load: solution.load.si(),
        });
        Ok(solution)
    }

    /// Rotates the last pressure by `points`, for a rough body that has moved relative to the window.
    pub fn shift(&mut self, points: isize) {
        self.before = None;
        if let Some(step) = &mut self.last {
            let n = step.pressure.len() as isize;
            step.pressure.rotate_right(points.rem_euclid(n) as usize);
        }
    }

    /// p₁ + (p₁ − p₀)·(W − W₁)/(W₁ − W₀) within the bounds, or p₁ if the load changes its direction.
    fn start(&self, problem: &ContactProblem) -> Option<Vec<f64>> {
        let last = self.last.as_ref()?;
        if last.pressure.len() != problem.gap.len() {
            return None;
        }
        let limit = problem
            .pressure_limit
            .map_or(f64::INFINITY, |limit| limit.si());
        let along = match (problem.control, &self.before) {
            (Control::Load(load), Some(before)) => {
                let ratio = (load.si() - last.load) / (last.load - before.load);
                // Beyond twice the last step a straight line is a worse start than p₁.
                (ratio > 0.0 && ratio <= 2.0).then_some((before, ratio))
            }
            _ => None,
        };
        let Some((before, ratio)) = along else {
            return Some(last.pressure.clone());
        };
        let pairs = last.pressure.iter().zip(&before.pressure);
        let onward = |(p1, p0): (&f64, &f64)| (p1 + ratio * (p1 - p0)).clamp(0.0, limit.max(0.0));
        Some(pairs.map(onward).collect())
    }
}
