//! Solver of rough line contacts: cascadic multigrid, window, iteration, verification.
//!
//! A coarse solution shows where the bodies touch; the finest grid is solved there by projected
//! conjugate gradients, and the result is certified on the whole grid with one more displacement.

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

use std::collections::BTreeMap;

use asperity_core::cancel::Cancelled;
use asperity_core::quantity::{Length, LineEnergy, Pressure};
use asperity_core::{DomainError, cite};
use rustfft::FftPlanner;

use crate::boundary::Boundary;
use crate::convolution::{Buffers, EvenFilter};
use crate::error::{ContactError, SolverShape};
use crate::half_plane::{cite_kernel, displacement_filter, inverse_filter, line_load};
use crate::plasticity::{dissipated_energy, plastic_displacement};
use crate::problem::{
    ContactProblem, ContactSolution, LEAST_POINTS, MAX_TOLERANCE, SolverSettings,
};
use cascadic_multigrid::{Window, grids, is_smooth, prolong, prolong_slopes, restrict};
use discrete_problem::{DiscreteProblem, touching};
use single_grid::minimise;
use workspace::{Assessment, Level, Task, Workspace};

/// Points of a grid from which on the operators of one size only are kept.
const LARGE_GRID: usize = 1 << 18;
/// Windows tried before the whole grid is solved.
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

/// Plans and buffers for many problems with the same number of points and the same boundary.
///
/// Spacing and modulus may differ from problem to problem: the plans do not depend on them.
pub struct Solver {
    shape: SolverShape,
    levels: Levels,
    work: Workspace,
}

/// The operators of every number of points met so far.
struct Levels {
    boundary: Boundary,
    /// Kernel of free ends, of which a coarser grid takes the first cells.
    column: Vec<f64>,
    planner: FftPlanner<f64>,
    inverse_planner: FftPlanner<f32>,
    displacements: BTreeMap<usize, EvenFilter>,
    singles: BTreeMap<usize, EvenFilter<f32>>,
    inverses: BTreeMap<usize, EvenFilter<f32>>,
}

impl Levels {
    /// Forgets other sizes before a large one is made: memory is then what counts.
    fn make_room(&mut self, points: usize) {
        if points > LARGE_GRID && !self.displacements.contains_key(&points) {
            self.column = vec![];
            self.displacements.clear();
            self.singles.clear();
            self.inverses.clear();
            self.planner = FftPlanner::new();
            self.inverse_planner = FftPlanner::new();
        }
    }

    /// The displacement of a grid, with room for it in `buffers`.
    fn displacement(&mut self, points: usize, buffers: &mut Buffers) -> &EvenFilter {
        self.make_room(points);
        let (planner, column) = (&mut self.planner, &mut self.column);
        let filter = self.displacements.entry(points).or_insert_with(|| {
            displacement_filter(planner, points, self.boundary, column, buffers)
        });
        shed(column);
        buffers.reserve(filter);
        filter
    }

    /// The operators of an iteration on a grid, with room for them in the workspace.
    fn level(&mut self, points: usize, work: &mut Workspace) -> Level<'_> {
        self.make_room(points);
        let planner = &mut self.inverse_planner;
        let inverse = self
            .inverses
            .entry(points)
            .or_insert_with(|| inverse_filter(planner, points));
        work.single_buffers.reserve(inverse);
        let (planner, column, buffers) = (&mut self.planner, &mut self.column, &mut work.buffers);
        let displacement = self.displacements.entry(points).or_insert_with(|| {
            displacement_filter(planner, points, self.boundary, column, buffers)
        });
        shed(column);
        buffers.reserve(displacement);
        let planner = &mut self.inverse_planner;
        let single = self
            .singles
            .entry(points)
            .or_insert_with(|| displacement.single(planner));
        work.single_buffers.reserve(single);
        Level {
            displacement,
            single,
            inverse,
            boundary: self.boundary,
        }
    }
}

/// Gives back a column whose memory counts.
fn shed(column: &mut Vec<f64>) {
    if column.len() > LARGE_GRID {
        *column = vec![];
    }
}

/// Properties of a pressure on the whole grid.
struct Certified {
    /// Range of the deformation about the contact in m.
    deformation: f64,
    /// Scale of the certificate in m.
    reference_gap: f64,
    assessment: Assessment,
}

impl Solver {
    /// A solver of problems with this many points and these ends.
    ///
    /// # Errors
    /// When there are fewer than two points.
    pub fn new(points: usize, boundary: Boundary) -> Result<Self, ContactError> {
        if points < LEAST_POINTS {
            return Err(ContactError::TooFewPoints {
                points,
                least: LEAST_POINTS,
            });
        }
        Ok(Self {
            shape: SolverShape { points, boundary },
            levels: Levels {
                boundary,
                column: vec![],
                planner: FftPlanner::new(),
                inverse_planner: FftPlanner::new(),
                displacements: BTreeMap::new(),
                singles: BTreeMap::new(),
                inverses: BTreeMap::new(),
            },
            work: Workspace::default(),
        })
    }

    /// Points and ends that the solver is made for.
    pub fn shape(&self) -> SolverShape {
        self.shape
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
        cite_kernel(problem.boundary);
        problem.validate()?;
        let tolerance = settings.tolerance;
        if tolerance > MAX_TOLERANCE {
            return Err(ContactError::ToleranceTooLarge {
                tolerance,
                most: MAX_TOLERANCE,
            });
        }
        let sensible = tolerance.is_finite() && tolerance > 0.0;
        DomainError::require(
            sensible,
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
            return Err(ContactError::SolverMismatch {
                solver: self.shape,
                problem: shape,
            });
        }
        let buffers = &mut self.work.buffers;
        let discrete = DiscreteProblem::new(problem, |prescribed, compliance| {
            let whole = self.levels.displacement(shape.points, buffers);
            whole.filter(buffers, compliance, prescribed);
            buffers.signal(shape.points)
        })?;
        let start = self.start(&discrete, settings)?;
        let (iterations, certified) = self.descend(&discrete, settings, start)?;
        self.conclude(&discrete, settings, iterations, &certified)
    }

    /// The pressure to start from: as given, from coarser grids, or even.
    fn start(
        &mut self,
        discrete: &DiscreteProblem,
        settings: &SolverSettings,
    ) -> Result<Vec<f64>, ContactError> {
        if let Some(start) = discrete.given_start() {
            return Ok(start);
        }
        // Buffers that have the size of the finest grid need not grow from grid to grid.
        if self.shape.points <= LARGE_GRID {
            let buffers = &mut self.work.buffers;
            self.levels.displacement(self.shape.points, buffers);
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
            // What the even start of the coarsest grid touches says nothing.
            let begun = gap.len() != coarsest;
            let smooth = begun && is_smooth(&touches);
            // What a window misses is found on the finest grid.
            let window = if self.windowed(settings) && begun {
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

    fn windowed(&self, settings: &SolverSettings) -> bool {
        settings.window && self.shape.boundary == Boundary::FreeEnds
    }

    /// Improves the pressure within the window, which is all there is then; returns the iterations.
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
        let level = self.levels.level(window.points, &mut self.work);
        let iterations = minimise(level, &mut self.work, task)?;
        pressure.fill(0.0);
        pressure[window.range()].copy_from_slice(&self.work.pressure);
        Ok(iterations)
    }

    /// Solves the finest grid, windows first, and leaves the result in the workspace. Returns the
    /// iterations and what is certified of the result.
    fn descend(
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
                self.spread(discrete, settings, &pressure);
            }
            let certified = self.certify(&discrete.task(Window::whole(points), settings, 0));
            // The whole grid is solved again when its reference gap was that of a poor start.
            let solved = certified.assessment.within(settings.tolerance);
            if solved || attempt == MAX_WINDOWS || (is_whole && was_whole) {
                return Ok((iterations, certified));
            }
            (attempt, was_whole) = (attempt + 1, is_whole);
            touches.clear();
            touches.extend(self.work.runs.iter().flat_map(|run| run.range()));
        }
    }

    /// Takes the pressure of a window, and the gap under it, to the whole grid.
    fn spread(&mut self, discrete: &DiscreteProblem, settings: &SolverSettings, pressure: &[f64]) {
        let task = discrete.task(Window::whole(pressure.len()), settings, 0);
        self.work.pressure.clear();
        self.work.pressure.extend_from_slice(pressure);
        if pressure.len() > LARGE_GRID {
            self.work.release();
        }
        let buffers = &mut self.work.buffers;
        let displacement = self.levels.displacement(pressure.len(), buffers);
        self.work.refresh(displacement, &task);
    }

    /// Assessment of the pressure on the whole grid by the reference gap that follows from it.
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

    /// The solution that the workspace holds, when its certificate is good enough, with its gap
    ///
    /// g = h + u − δ  `[Gap-deformed]`
    fn conclude(
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
        // The gap of `deformed_gap`, in place.
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
            max_pressure: Pressure::from_si(pressure.iter().fold(0.0, |m, &p| f64::max(m, p))),
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
