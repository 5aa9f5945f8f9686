//! Solver of rough line contacts, in four stages.
//!
//! 1. Start: the contact is solved on grids of half as many points each, from the coarsest up, and
//!    every solution starts the next finer grid (`cascadic_multigrid`; Bornemann and Deuflhard
//!    1996). No correction goes back to a coarser grid.
//! 2. Window: with free ends the finest grid is solved only where the coarse solution is in contact.
//! 3. Solution: by exact sets for a line of few touching points (`few_points`); for others by iteration with an active set (`active_set`; Hintermüller, Ito and Kunisch 2002), then, where the
//!    sets do not settle, projected gradients (`projected_gradient`; after Polonsky and Keer 1999).
//! 4. Certificate: one displacement on the whole grid gives the gap there and bounds the error. A
//!    contact point outside of the window fails here, and a wider window is solved.

mod active_set;
mod cascadic_multigrid;
mod coarse_nodes;
mod coarse_space;
mod contact_patches;
mod direct_patches;
mod discrete_problem;
mod feasible_pressure;
mod few_points;
mod line_search;
mod operators;
mod projected_gradient;
mod search_direction;
mod single_grid;
mod workspace;

use std::cell::Cell;

use asperity_core::cancel::Cancelled;
use asperity_core::numerics::extremes;
use asperity_core::quantity::{Length, LineEnergy, Pressure};
use asperity_core::{DomainError, cite};

use crate::boundary::Boundary;
use crate::cells::{Cells, Lead};
use crate::dense_reference::solve_dense;
use crate::error::{ContactError, SolverShape};
use crate::grid::LARGE_GRID;
use crate::half_plane::{cell_compliance, check_lengths, cite_kernel, line_load};
use crate::plasticity::{dissipated_energy, plastic_displacement};
use crate::problem::{
    ContactProblem, ContactSolution, LEAST_POINTS, MAX_TOLERANCE, SolverSettings,
};
use cascadic_multigrid::{
    Window, grids, is_smooth, prolong, prolong_rows, prolong_slopes, restrict,
};
use discrete_problem::{DiscreteProblem, touching};
use operators::Operators;
use workspace::{Assessment, Task, Workspace};

/// Windows tried before the whole grid is solved. A window that misses a contact point costs a
/// displacement on the whole grid; the next window also covers the points that overlapped.
const MAX_WINDOWS: usize = 3;

/// Certificate of a contact whose sets are exact: of a few dozen points about 1e-15 is seen.
const ROUND_OFF: f64 = 1e-13;

/// Solves one problem.
///
/// # Errors
/// When the problem is not well posed, or not solved to the tolerance.
///
/// ```
/// use asperity_contact::{Boundary, ContactProblem, Control, SolverSettings, solve};
/// // A cylinder of 3 mm radius under 300 N/mm: Hertz's largest pressure is 1.91646 GPa.
/// let gap: Vec<f64> = (0..1000).map(|i| (0.6e-6 * (f64::from(i) - 499.5)).powi(2) / 6e-3).collect();
/// let problem = ContactProblem {
///     gap: &gap, spacing: "0.6 um".parse()?, modulus: "115.384615385 GPa".parse()?,
///     boundary: Boundary::FreeEnds, control: Control::Load("300 N/mm".parse()?),
///     lead: None, prescribed_pressure: None, pressure_limit: None, start: None,
/// };
/// let solution = solve(&problem, &SolverSettings::default())?;
/// assert!((solution.max_pressure.si() / 1.91646e9 - 1.0).abs() < 1e-5);
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
pub fn solve(
    problem: &ContactProblem,
    settings: &SolverSettings,
) -> Result<ContactSolution, ContactError> {
    Solver::from_problem(problem)?.solve(problem, settings)
}

/// Solver of many problems with the same number of points and the same boundary, whose plans and
/// buffers it reuses.
///
/// Spacing and modulus may differ from problem to problem: the plans do not depend on them.
pub struct Solver {
    shape: SolverShape,
    operators: Operators,
    work: Workspace,
}

thread_local! {
    /// Operators and buffers of the solver that was dropped last: the windows of a contact are solved one after the other, and to
    /// make their operators again costs a third of a solution.
    static LAST: Cell<Option<(SolverShape, Operators, Workspace)>> = const { Cell::new(None) };
}

impl Drop for Solver {
    fn drop(&mut self) {
        if self.shape.points <= LARGE_GRID {
            // Its planner has a history.
            self.work.coarse = std::mem::take(&mut self.work.coarse).anew();
            let own = (
                self.shape,
                std::mem::replace(&mut self.operators, Operators::new(self.shape.rows)),
                std::mem::take(&mut self.work),
            );
            // At the end of a thread nothing is kept.
            let _ = LAST.try_with(|last| last.set(Some(own)));
        }
    }
}

/// Error bounds of a pressure on the whole grid, and their scale.
struct Certified {
    /// Range of the deformation about the contact in m.
    deformation: f64,
    /// Scale of the error bounds in m.
    reference_gap: f64,
    assessment: Assessment,
}

impl Solver {
    /// Makes a solver of problems with this number of points and this boundary.
    ///
    /// # Errors
    /// When there are fewer than two points.
    pub fn new(points: usize, boundary: Boundary) -> Result<Self, ContactError> {
        Self::of_patch([points, 1], boundary)
    }

    /// Makes a solver of patches with this number of points along rolling and of rows along the lead.
    ///
    /// # Errors
    /// When there are fewer than two points along rolling or no rows.
    pub fn of_patch([columns, rows]: [usize; 2], boundary: Boundary) -> Result<Self, ContactError> {
        if columns < LEAST_POINTS || rows == 0 {
            let points = columns.min(rows * columns);
            return Err(ContactError::too_few_points(points, LEAST_POINTS));
        }
        let shape = SolverShape {
            points: columns * rows,
            rows,
            boundary,
        };
        let last = LAST.take().filter(|(of, ..)| *of == shape);
        let (_, operators, work) =
            last.unwrap_or_else(|| (shape, Operators::new(rows), Workspace::default()));
        Ok(Self {
            shape,
            operators,
            work,
        })
    }

    /// Makes a solver of problems with the shape of `problem`.
    ///
    /// # Errors
    /// When there are too few points.
    pub fn from_problem(problem: &ContactProblem) -> Result<Self, ContactError> {
        Self::of_patch(problem.cells()?.shape(), problem.boundary)
    }

    /// Number of points and boundary of the problems that it solves.
    pub fn shape(&self) -> SolverShape {
        self.shape
    }

    /// Writes the displacement in m by `pressure` in Pa, with the operator of its problems of this spacing, lead and modulus.
    ///
    /// # Errors
    /// When a spacing or the modulus is not positive, an array does not have one value per cell, or the solver is one of
    /// another number of rows.
    pub fn displacement(
        &mut self,
        spacing: Length,
        lead: Option<Lead>,
        modulus: Pressure,
        pressure: &[f64],
        displacement: &mut [f64],
    ) -> Result<(), ContactError> {
        cite_kernel(self.shape.boundary);
        let compliance = cell_compliance(spacing, modulus)?;
        let SolverShape {
            points, boundary, ..
        } = self.shape;
        check_lengths(points, pressure, displacement)?;
        let cells = Cells::new(points, spacing, lead)?;
        let rows = cells.rows;
        if rows != self.shape.rows {
            let asked = SolverShape { rows, ..self.shape };
            return Err(ContactError::solver_mismatch(self.shape, asked));
        }
        let buffers = &mut self.work.buffers;
        (self.operators).displace(cells, boundary, buffers, (compliance, pressure));
        displacement.copy_from_slice(buffers.signal(points));
        Ok(())
    }

    /// Solves a problem.
    ///
    /// # Errors
    /// When the problem is of another shape, not well posed, or not solved to the tolerance.
    pub fn solve(
        &mut self,
        problem: &ContactProblem,
        settings: &SolverSettings,
    ) -> Result<ContactSolution, ContactError> {
        self.check(problem, settings)?;
        // What the solver solved before must not show, not even in the rounding of a result.
        self.work.coarse.forget_nodes();
        let discrete = self.discrete(problem)?;
        let start = self.start(&discrete, settings)?;
        let (iterations, certified) = self.solve_finest(&discrete, settings, start)?;
        self.solution(&discrete, settings, iterations, &certified)
    }

    /// Checks that a problem is well posed and of the shape of the solver.
    fn check(
        &self,
        problem: &ContactProblem,
        settings: &SolverSettings,
    ) -> Result<(), ContactError> {
        cite_kernel(problem.boundary);
        problem.validate()?;
        let tolerance = settings.tolerance;
        if tolerance > MAX_TOLERANCE {
            return Err(ContactError::tolerance_too_large(tolerance, MAX_TOLERANCE));
        }
        DomainError::require(
            tolerance.is_finite() && tolerance > 0.0,
            "tolerance",
            tolerance,
            "-",
            "must be finite and positive",
        )?;
        let shape = SolverShape {
            points: problem.gap.len(),
            rows: problem.cells()?.rows,
            boundary: problem.boundary,
        };
        if shape != self.shape {
            return Err(ContactError::solver_mismatch(self.shape, shape));
        }
        Ok(())
    }

    /// Solves a problem as [`solve`](Self::solve), then finds its exact sets if it has another error than round-off.
    ///
    /// # Errors
    /// As [`solve`](Self::solve), and when the contact has too many touching points or its sets do not settle.
    pub fn solve_exactly(
        &mut self,
        problem: &ContactProblem,
        settings: &SolverSettings,
    ) -> Result<ContactSolution, ContactError> {
        let solution = self.solve(problem, settings)?;
        if solution.certificate.within(ROUND_OFF) {
            return Ok(solution);
        }
        let sets = ContactProblem {
            start: Some(&solution.pressure),
            ..*problem
        };
        let exact = solve_dense(&sets)?.pressure;
        self.solved_by(problem, settings, &exact, solution.iterations)
    }

    /// The solution of a problem whose pressure is known, with its certificate and the number of iterations that found it.
    ///
    /// # Errors
    /// When the pressure is not the solution within the tolerance.
    pub fn solved_by(
        &mut self,
        problem: &ContactProblem,
        settings: &SolverSettings,
        pressure: &[f64],
        iterations: usize,
    ) -> Result<ContactSolution, ContactError> {
        self.check(problem, settings)?;
        let discrete = self.discrete(problem)?;
        self.open_whole_grid(&discrete, settings, pressure);
        let certified = self.certify(&discrete, settings);
        self.solution(&discrete, settings, iterations, &certified)
    }

    fn discrete<'a>(
        &mut self,
        problem: &'a ContactProblem<'a>,
    ) -> Result<DiscreteProblem<'a>, ContactError> {
        let (cells, buffers) = (problem.cells()?, &mut self.work.buffers);
        DiscreteProblem::new(problem, |prescribed, compliance| {
            let pressure = (compliance, prescribed);
            (self.operators).displace(cells, self.shape.boundary, buffers, pressure);
            buffers.signal(cells.points())
        })
    }

    /// Start pressure of the finest grid: the start of the problem, or the solution on coarser grids,
    /// or, without coarser grids, a uniform pressure.
    fn start(
        &mut self,
        discrete: &DiscreteProblem,
        settings: &SolverSettings,
    ) -> Result<Vec<f64>, ContactError> {
        if let Some(start) = discrete.scaled_start() {
            return Ok(start);
        }
        // The buffers are made once, for the finest grid, instead of growing from grid to grid.
        if self.shape.points <= LARGE_GRID {
            let buffers = &mut self.work.buffers;
            (self.operators).prepare(discrete.cells, self.shape.boundary, buffers);
        }
        let mut grids = grids(discrete.cells);
        if !settings.cascade {
            grids.truncate(1);
        }
        let mut gaps: Vec<Vec<f64>> = vec![];
        for finer_grid in &grids[..grids.len() - 1] {
            let finer: &[f64] = gaps.last().map_or(&discrete.gap, |gap| gap);
            gaps.push(restrict(finer, finer_grid.columns));
        }
        let coarsest = grids[grids.len() - 1];
        let mut pressure = vec![discrete.even_pressure(); coarsest.points()];
        for (halvings, gap) in gaps.iter().enumerate().rev() {
            let grid = grids[halvings + 1];
            let touches = touching(gap, &pressure);
            // The coarsest grid starts from a uniform pressure, which does not show the contact.
            let shows_contact = grid != coarsest;
            let smooth = shows_contact && is_smooth(&touches, grid.rows);
            // A coarse grid is not certified outside of its window: the finest grid is.
            let window = if self.windowed(settings) && shows_contact {
                Window::around(grid, &touches)
            } else {
                Window::whole(grid.columns)
            };
            let gap = window.cut(gap, grid.columns);
            let cells = window.of(grid);
            let task = discrete.coarse_task(&gap, cells, halvings as i32 + 1, smooth, settings)?;
            self.minimise((window, grid), &task, &mut pressure)?;
            let along = if smooth { prolong_slopes } else { prolong };
            pressure = prolong_rows((&pressure, grid), grids[halvings], along);
        }
        Ok(pressure)
    }

    /// Whether windows are solved. A period has no outside: its mean displacement couples all points.
    fn windowed(&self, settings: &SolverSettings) -> bool {
        settings.window && self.shape.boundary == Boundary::FreeEnds
    }

    /// Solves the contact within the window and sets the pressure outside of it to zero. Returns the
    /// number of iterations.
    fn minimise(
        &mut self,
        (window, grid): (Window, Cells),
        task: &Task,
        pressure: &mut [f64],
    ) -> Result<usize, Cancelled> {
        let columns = grid.columns;
        self.work.pressure.clear();
        self.work
            .pressure
            .extend_from_slice(&window.cut(pressure, columns));
        let work = (&mut self.work, task);
        let iterations = (self.operators).minimise(window.of(grid), self.shape.boundary, work)?;
        window.paste(&self.work.pressure, pressure, columns);
        Ok(iterations)
    }

    /// Solves the finest grid, on windows first, and leaves the result in the workspace. Returns the
    /// number of iterations and the error bounds of the result.
    fn solve_finest(
        &mut self,
        discrete: &DiscreteProblem,
        settings: &SolverSettings,
        mut pressure: Vec<f64>,
    ) -> Result<(usize, Certified), Cancelled> {
        let grid = discrete.cells;
        let mut touches = touching(&discrete.gap, &pressure);
        let (mut iterations, mut attempt, mut was_whole) = (0, 0, false);
        loop {
            let window = if self.windowed(settings) && attempt < MAX_WINDOWS {
                Window::around(grid, &touches)
            } else {
                Window::whole(grid.columns)
            };
            let gap = window.cut(&discrete.gap, grid.columns);
            let left = settings.max_iterations - iterations;
            let task = discrete.task(&gap, window.points, settings, left);
            iterations += self.minimise((window, grid), &task, &mut pressure)?;
            let is_whole = window.points == grid.columns;
            if !is_whole {
                self.open_whole_grid(discrete, settings, &pressure);
            }
            let certified = self.certify(discrete, settings);
            // The tolerance is relative to the reference gap, which the iteration takes from its start. A
            // poor start gives a wrong scale, so the whole grid gets a second solution on the right one.
            let solved = certified.assessment.within(settings.tolerance);
            if solved || attempt == MAX_WINDOWS || (is_whole && was_whole) {
                return Ok((iterations, certified));
            }
            (attempt, was_whole) = (attempt + 1, is_whole);
            // The next window covers the points with pressure and those that overlap.
            touches.clear();
            touches.extend(self.work.runs.iter().flat_map(|run| run.range()));
        }
    }

    /// Computes the gap on the whole grid under the pressure of a window.
    fn open_whole_grid(
        &mut self,
        discrete: &DiscreteProblem,
        settings: &SolverSettings,
        pressure: &[f64],
    ) {
        let task = discrete.whole_task(settings);
        self.work.pressure.clear();
        self.work.pressure.extend_from_slice(pressure);
        if pressure.len() > LARGE_GRID {
            self.work.release();
        }
        let work = (&mut self.work, &task);
        (self.operators).refresh(discrete.cells, self.shape.boundary, work);
    }

    /// Assesses the pressure on the whole grid, relative to the reference gap of its own deformation.
    fn certify(&mut self, discrete: &DiscreteProblem, settings: &SolverSettings) -> Certified {
        let task = &discrete.whole_task(settings);
        let deformation = self.work.deformation(task);
        let reference_gap = task.reference_bounds.between(deformation);
        let task = Task {
            reference_gap,
            ..*task
        };
        Certified {
            deformation,
            reference_gap,
            assessment: self.work.assess(&task),
        }
    }

    /// Returns the solution that the workspace holds if its certificate is within the tolerance. Its gap is
    ///
    /// g = h + u − δ  `[Gap-deformed]`
    fn solution(
        &mut self,
        discrete: &DiscreteProblem,
        settings: &SolverSettings,
        iterations: usize,
        certified: &Certified,
    ) -> Result<ContactSolution, ContactError> {
        let Certified {
            deformation,
            reference_gap,
            assessment,
        } = *certified;
        let certificate = discrete.certificate(&self.work.pressure, &assessment, reference_gap);
        if !certificate.within(settings.tolerance) {
            return Err(ContactError::NotConverged {
                iterations,
                certificate,
                tolerance: settings.tolerance,
            });
        }
        // As `deformed_gap`, but in place. Until here the opening v = u + h holds no approach.
        cite!("Gap-deformed");
        let pressure = std::mem::take(&mut self.work.pressure);
        let problem = discrete.problem;
        let rows = discrete.cells.rows as f64;
        let approach = discrete.approach(&pressure, assessment.approach);
        let mut gap = std::mem::take(&mut self.work.opening);
        for g in &mut gap {
            *g -= assessment.approach;
        }
        let displacement: Vec<f64> = gap
            .iter()
            .zip(problem.gap)
            .map(|(g, h)| g - h + approach)
            .collect();
        let limit = problem.pressure_limit;
        // Points at the pressure limit overlap elastically. The overlap is the plastic displacement.
        let (plastic_displacement, dissipated) = if limit.is_some() {
            let w = plastic_displacement(&pressure, &gap, limit);
            let dissipated = dissipated_energy(&w, problem.spacing, limit) / rows;
            gap.iter_mut().zip(&w).for_each(|(g, w)| *g += w);
            (w, dissipated)
        } else {
            (vec![0.0; pressure.len()], LineEnergy::from_si(0.0))
        };
        let touching = pressure.iter().filter(|&&p| p > 0.0).count();
        Ok(ContactSolution {
            load: line_load(&pressure, problem.spacing) / rows,
            approach: Length::from_si(approach),
            datum: problem.datum(),
            contact_fraction: touching as f64 / pressure.len() as f64,
            max_pressure: Pressure::from_si(extremes(&pressure).1),
            dissipated,
            elastic_energy: discrete.elastic_energy(&pressure, &displacement),
            plastic_displacement,
            end_pressure: Pressure::from_si(match problem.boundary {
                Boundary::FreeEnds => end_pressure(&pressure, discrete.cells.columns),
                Boundary::Periodic(_) => 0.0,
            }),
            gap_range: discrete.gap_range(),
            deformation: Length::from_si(deformation),
            pressure,
            displacement,
            gap,
            iterations,
            certificate,
        })
    }
}

/// Largest pressure in the first and the last column.
fn end_pressure(pressure: &[f64], columns: usize) -> f64 {
    let rows = pressure.chunks_exact(columns);
    rows.map(|row| f64::max(row[0], row[columns - 1]))
        .fold(0.0, f64::max)
}
