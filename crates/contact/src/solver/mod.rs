//! Solver of rough line contacts, in four stages.
//!
//! 1. Start: the contact is solved on grids of half as many points each, from the coarsest up, and
//!    every solution starts the next finer grid (`cascadic_multigrid`; Bornemann and Deuflhard
//!    1996). No correction goes back to a coarser grid.
//! 2. Window: with free ends the finest grid is solved only where the coarse solution is in contact.
//! 3. Iteration: an active set (`active_set`; Hintermüller, Ito and Kunisch 2002), then, where the
//!    sets do not settle, projected gradients (`projected_gradient`; after Polonsky and Keer 1999).
//! 4. Certificate: one displacement on the whole grid gives the gap there and bounds the error. A
//!    contact point outside of the window fails here, and a wider window is solved.

mod active_set;
mod cascadic_multigrid;
mod coarse_nodes;
mod coarse_space;
mod contact_patches;
mod discrete_problem;
mod feasible_pressure;
mod line_search;
mod projected_gradient;
mod search_direction;
mod single_grid;
mod workspace;

use std::cell::Cell;
use std::collections::BTreeMap;

use asperity_core::cancel::Cancelled;
use asperity_core::numerics::{FourierNumber, extremes};
use asperity_core::quantity::{Length, LineEnergy, Pressure};
use asperity_core::{DomainError, cite};

use crate::boundary::Boundary;
use crate::convolution::{Buffers, EvenFilter};
use crate::dense_reference::solve_dense;
use crate::error::{ContactError, SolverShape};
use crate::half_plane::{
    cell_compliance, cite_kernel, displace, displacement_filter, inverse_filter, line_load,
};
use crate::plasticity::{dissipated_energy, plastic_displacement};
use crate::problem::{
    ContactProblem, ContactSolution, LEAST_POINTS, MAX_TOLERANCE, SolverSettings,
};
use cascadic_multigrid::{Window, grids, is_smooth, prolong, prolong_slopes, restrict};
use coarse_space::CoarseSpace;
use discrete_problem::{DiscreteProblem, touching};
use single_grid::minimise;
use workspace::{Assessment, Level, Task, Workspace};

/// Number of points above which the operators of only one grid size are cached. A displacement
/// operator takes 18 bytes per point besides its plan, more than the arrays of the problem itself.
const LARGE_GRID: usize = 1 << 18;
/// Windows tried before the whole grid is solved. A window that misses a contact point costs a
/// displacement on the whole grid; the next window also covers the points that overlapped.
const MAX_WINDOWS: usize = 3;

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
///     prescribed_pressure: None, pressure_limit: None, start: None,
/// };
/// let solution = solve(&problem, &SolverSettings::default())?;
/// assert!((solution.max_pressure.si() / 1.91646e9 - 1.0).abs() < 1e-5);
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
pub fn solve(
    problem: &ContactProblem,
    settings: &SolverSettings,
) -> Result<ContactSolution, ContactError> {
    Solver::new(problem.gap.len(), problem.boundary)?.solve(problem, settings)
}

/// Solver of many problems with the same number of points and the same boundary, whose plans and
/// buffers it reuses.
///
/// Spacing and modulus may differ from problem to problem: the plans do not depend on them.
pub struct Solver {
    shape: SolverShape,
    levels: Levels,
    work: Workspace,
}

thread_local! {
    /// Operators and buffers of the solver that was dropped last: the windows of a contact are solved one after the other, and to
    /// make their operators anew costs a third of a solution.
    static LAST: Cell<Option<(SolverShape, Levels, Workspace)>> = const { Cell::new(None) };
}

impl Drop for Solver {
    fn drop(&mut self) {
        if self.shape.points <= LARGE_GRID {
            // Its planner has a history.
            self.work.coarse = CoarseSpace::default();
            let own = (
                self.shape,
                std::mem::take(&mut self.levels),
                std::mem::take(&mut self.work),
            );
            // At the end of a thread nothing is kept.
            let _ = LAST.try_with(|last| last.set(Some(own)));
        }
    }
}

/// Operators by number of points, cached for the grids and windows solved so far. Each has a planner of its own: what a planner
/// has planned before shows in the rounding of its transforms.
#[derive(Default)]
struct Levels {
    /// Kernel of free ends of the largest grid so far; smaller grids use its first cells.
    column: Vec<f64>,
    displacements: BTreeMap<usize, EvenFilter>,
    singles: BTreeMap<usize, EvenFilter<f32>>,
    inverses: BTreeMap<usize, EvenFilter<f32>>,
}

impl Levels {
    /// Drops the operators of other sizes before a large grid's are made, which bounds the memory.
    fn make_room(&mut self, points: usize) {
        if points > LARGE_GRID && !self.displacements.contains_key(&points) {
            self.column = vec![];
            self.displacements.clear();
            self.singles.clear();
            self.inverses.clear();
        }
    }

    /// Displacement operator of a grid; enlarges `buffers` to what it needs.
    fn displacement(
        &mut self,
        points: usize,
        boundary: Boundary,
        buffers: &mut Buffers,
    ) -> &EvenFilter {
        self.make_room(points);
        let column = &mut self.column;
        let filter = (self.displacements.entry(points)).or_insert_with(|| {
            displacement_filter(&mut f64::planner(), points, boundary, column, buffers)
        });
        free_if_large(column);
        buffers.reserve(filter);
        filter
    }

    /// Operators of an iteration on a grid; enlarges the buffers of the workspace to what they need.
    fn level(&mut self, points: usize, boundary: Boundary, work: &mut Workspace) -> Level<'_> {
        self.displacement(points, boundary, &mut work.buffers);
        let inverse = (self.inverses.entry(points))
            .or_insert_with(|| inverse_filter(&mut f32::planner(), points));
        work.single_buffers.reserve(inverse);
        let displacement = &self.displacements[&points];
        let single = (self.singles.entry(points))
            .or_insert_with(|| displacement.single(&mut f32::planner()));
        work.single_buffers.reserve(single);
        Level {
            displacement,
            single,
            inverse,
            boundary,
        }
    }
}

/// Frees a kernel of more than [`LARGE_GRID`] cells.
fn free_if_large(column: &mut Vec<f64>) {
    if column.len() > LARGE_GRID {
        *column = vec![];
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
        if points < LEAST_POINTS {
            return Err(ContactError::too_few_points(points, LEAST_POINTS));
        }
        let shape = SolverShape { points, boundary };
        let last = LAST.take().filter(|(of, ..)| *of == shape);
        let (_, levels, work) = last.unwrap_or((shape, Levels::default(), Workspace::default()));
        Ok(Self {
            shape,
            levels,
            work,
        })
    }

    /// Number of points and boundary of the problems that it solves.
    pub fn shape(&self) -> SolverShape {
        self.shape
    }

    /// Writes the displacement in m by `pressure` in Pa, with the operator of its problems.
    ///
    /// # Errors
    /// When spacing or modulus is not positive, or an array does not have one value per cell.
    pub fn displacement(
        &mut self,
        (spacing, modulus): (Length, Pressure),
        pressure: &[f64],
        displacement: &mut [f64],
    ) -> Result<(), ContactError> {
        cite_kernel(self.shape.boundary);
        let compliance = cell_compliance(spacing, modulus)?;
        let buffers = &mut self.work.buffers;
        let filter = (self.levels).displacement(self.shape.points, self.shape.boundary, buffers);
        displace(filter, buffers, compliance, pressure, displacement)
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
            boundary: problem.boundary,
        };
        if shape != self.shape {
            return Err(ContactError::solver_mismatch(self.shape, shape));
        }
        Ok(())
    }

    /// Solves a problem as [`solve`](Self::solve), then finds its exact sets: its error is round-off.
    ///
    /// # Errors
    /// As [`solve`](Self::solve), and when the contact has too many touching points or its sets do not settle.
    pub fn solve_exactly(
        &mut self,
        problem: &ContactProblem,
        settings: &SolverSettings,
    ) -> Result<ContactSolution, ContactError> {
        let solution = self.solve(problem, settings)?;
        let sets = ContactProblem {
            start: Some(&solution.pressure),
            ..*problem
        };
        let exact = solve_dense(&sets)?.pressure;
        self.solved_by(problem, settings, (&exact, solution.iterations))
    }

    /// The solution of a problem whose pressure is known, with its certificate and the number of iterations that found it.
    ///
    /// # Errors
    /// When the pressure is not the solution within the tolerance.
    pub fn solved_by(
        &mut self,
        problem: &ContactProblem,
        settings: &SolverSettings,
        (pressure, iterations): (&[f64], usize),
    ) -> Result<ContactSolution, ContactError> {
        self.check(problem, settings)?;
        let discrete = self.discrete(problem)?;
        self.open_whole_grid(&discrete, settings, pressure);
        let whole = Window::whole(self.shape.points);
        let certified = self.certify(&discrete.task(whole, settings, 0));
        self.solution(&discrete, settings, iterations, &certified)
    }

    fn discrete<'a>(
        &mut self,
        problem: &'a ContactProblem<'a>,
    ) -> Result<DiscreteProblem<'a>, ContactError> {
        let (points, buffers) = (self.shape.points, &mut self.work.buffers);
        DiscreteProblem::new(problem, |prescribed, compliance| {
            let whole = (self.levels).displacement(points, self.shape.boundary, buffers);
            whole.filter(buffers, compliance, prescribed);
            buffers.signal(points)
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
            (self.levels).displacement(self.shape.points, self.shape.boundary, buffers);
        }
        let mut grids = grids(self.shape.points);
        if !settings.cascade {
            grids.truncate(1);
        }
        let mut gaps: Vec<Vec<f64>> = vec![];
        for _ in 1..grids.len() {
            let finer: &[f64] = gaps.last().map_or(&discrete.gap, |gap| gap);
            gaps.push(restrict(finer));
        }
        let coarsest = grids[grids.len() - 1];
        let mut pressure = vec![discrete.even_pressure(); coarsest];
        for (halvings, gap) in gaps.iter().enumerate().rev() {
            let touches = touching(gap, &pressure);
            // The coarsest grid starts from a uniform pressure, which does not show the contact.
            let shows_contact = gap.len() != coarsest;
            let smooth = shows_contact && is_smooth(&touches);
            // A coarse grid is not certified outside of its window: the finest grid is.
            let window = if self.windowed(settings) && shows_contact {
                Window::around(gap.len(), &touches)
            } else {
                Window::whole(gap.len())
            };
            let gap = &gap[window.range()];
            let task = discrete.coarse_task(gap, halvings as i32 + 1, smooth, settings)?;
            self.minimise(window, &task, &mut pressure)?;
            let finer = if smooth { prolong_slopes } else { prolong };
            pressure = finer(&pressure, grids[halvings]);
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
        window: Window,
        task: &Task,
        pressure: &mut [f64],
    ) -> Result<usize, Cancelled> {
        self.work.pressure.clear();
        self.work
            .pressure
            .extend_from_slice(&pressure[window.range()]);
        let level = (self.levels).level(window.points, self.shape.boundary, &mut self.work);
        let iterations = minimise(level, &mut self.work, task)?;
        pressure.fill(0.0);
        pressure[window.range()].copy_from_slice(&self.work.pressure);
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
        let points = self.shape.points;
        let mut touches = touching(&discrete.gap, &pressure);
        let (mut iterations, mut attempt, mut was_whole) = (0, 0, false);
        loop {
            let window = if self.windowed(settings) && attempt < MAX_WINDOWS {
                Window::around(points, &touches)
            } else {
                Window::whole(points)
            };
            let task = discrete.task(window, settings, settings.max_iterations - iterations);
            iterations += self.minimise(window, &task, &mut pressure)?;
            let is_whole = window.points == points;
            if !is_whole {
                self.open_whole_grid(discrete, settings, &pressure);
            }
            let certified = self.certify(&discrete.task(Window::whole(points), settings, 0));
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
        let task = discrete.task(Window::whole(pressure.len()), settings, 0);
        self.work.pressure.clear();
        self.work.pressure.extend_from_slice(pressure);
        if pressure.len() > LARGE_GRID {
            self.work.release();
        }
        let buffers = &mut self.work.buffers;
        let boundary = self.shape.boundary;
        let displacement = (self.levels).displacement(pressure.len(), boundary, buffers);
        self.work.refresh(displacement, &task);
    }

    /// Assesses the pressure on the whole grid, relative to the reference gap of its own deformation.
    fn certify(&mut self, task: &Task) -> Certified {
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
            let dissipated = dissipated_energy(&w, problem.spacing, limit);
            gap.iter_mut().zip(&w).for_each(|(g, w)| *g += w);
            (w, dissipated)
        } else {
            (vec![0.0; pressure.len()], LineEnergy::from_si(0.0))
        };
        let touching = pressure.iter().filter(|&&p| p > 0.0).count();
        Ok(ContactSolution {
            load: line_load(&pressure, problem.spacing),
            approach: Length::from_si(approach),
            datum: problem.datum(),
            contact_fraction: touching as f64 / pressure.len() as f64,
            max_pressure: Pressure::from_si(extremes(&pressure).1),
            dissipated,
            elastic_energy: discrete.elastic_energy(&pressure, &displacement),
            plastic_displacement,
            end_pressure: Pressure::from_si(match problem.boundary {
                Boundary::FreeEnds => f64::max(pressure[0], pressure[pressure.len() - 1]),
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
