//! Steady film of smooth surfaces: cold start, grid sequence, results.
//!
//! An even grid is solved on coarser grids first (cascadic multigrid: each solution is the start on the next finer
//! grid, never corrected on a coarser one). If the sequence fails, it is repeated with tight linear systems, then the
//! finest grid is solved from the Hertz pressure, then by continuation from a thicker film, whose inlet is less steep.

use asperity_core::cancel::checkpoint;
use asperity_core::quantity::{Length, LineLoad, Pressure};
use asperity_core::{DomainError, cite};
use asperity_oil::PressureViscosityLaw;
use serde::{Deserialize, Serialize};

use crate::dimensionless::{LineContact, Scales};
use crate::error::EhlError;
use crate::evidence::{Evidence, Solved};
use crate::fluid::Fluid;
use crate::grid::FilmGrid;
use crate::linear::{ElasticSystem, FourierSystem};
use crate::newton::{Limits, Newton, NewtonEffort, NewtonProblem, NodeState, Solution, Unknowns};
use crate::oil::Oil;

/// The number of cells must be a multiple of this, for the coarse level of the preconditioner and the grid sequence.
pub const CELL_MULTIPLE: usize = 64;
/// Largest number of cells.
const MOST_CELLS: usize = 1 << 16;
/// Fewest cells of a grid in the sequence.
const COARSEST: usize = 64;
/// Cells that the inlet zone must span on a grid coarser than a quarter of the cells: the solution on a grid that skips
/// the inlet has another film thickness, and so is a poor start.
const COARSE_INLET: f64 = 1.0;
/// Limits of the steady iteration.
pub(crate) const LIMITS: Limits = Limits {
    // The error after a step of this size is its square, 1e-11, plus the linear tolerance times it, 3e-11.
    tolerance: 3e-6,
    linear_tolerance: 1e-5,
    loosest: 1e-3,
    largest_change: 0.3,
    iterations: 60,
    flips: 0,
    load: 1e-10,
};
/// Limits on the grids before the finest, whose discretisation error is larger than these.
const COARSE_LIMITS: Limits = Limits {
    tolerance: 2e-2,
    linear_tolerance: 1e-4,
    flips: 4,
    load: 1e-2,
    ..LIMITS
};
/// Factors of λ in the continuation from a thicker film; the film grows with λ^0.7 as in film formulas.
const CONTINUATION: [f64; 5] = [30.0, 10.0, 5.0, 2.0, 1.0];

/// Window and grid of a steady solution.
#[derive(Debug, Clone, Copy, PartialEq, Serialize, Deserialize)]
pub struct SteadySettings {
    /// Cells of the even grid, a multiple of 64.
    pub cells: usize,
    /// Inlet and outlet in half-widths; by default [`Window::tabulated`].
    pub window: Option<Window>,
}

impl Default for SteadySettings {
    fn default() -> Self {
        Self {
            cells: 512,
            window: None,
        }
    }
}

/// Ends of the film in half-widths a.
#[derive(Debug, Clone, Copy, PartialEq, Serialize, Deserialize)]
pub struct Window {
    /// Inlet position, negative.
    pub inlet: f64,
    /// End behind the contact.
    pub outlet: f64,
}

impl Window {
    /// Window of rough transient records; −2.5 starves the film by one per cent.
    pub const ROUGH: Self = Self {
        inlet: -2.5,
        outlet: 1.5,
    };

    /// Window that grows with the film, so that the inlet is flooded to 0.2 %.
    ///
    /// X_in = −max(4, √(600·H_c)), X_out = max(1.5, 1 + 3·√H_c)            `[EHL-window]`
    pub fn tabulated(scales: &Scales) -> Self {
        cite!("EHL-window");
        let film = scales.film_guess();
        Self {
            inlet: -(600.0 * film).sqrt().max(4.0),
            outlet: (1.0 + 3.0 * film.sqrt()).max(1.5),
        }
    }

    fn check(self) -> Result<Self, EhlError> {
        DomainError::require(
            self.inlet.is_finite() && self.inlet <= -1.2,
            "inlet",
            self.inlet,
            "half-widths",
            "must lie at -1.2 or before it",
        )?;
        DomainError::require(
            self.outlet.is_finite() && self.outlet >= 1.05,
            "outlet",
            self.outlet,
            "half-widths",
            "must lie at 1.05 or behind it",
        )?;
        Ok(self)
    }
}

/// Warning about a solution.
#[derive(Debug, Clone, Copy, PartialEq, Serialize)]
#[non_exhaustive]
pub enum Warning {
    /// The inlet zone (0.53·H_c)^(2/3) spans fewer than two cells: the film reads low.
    InletUnresolved {
        /// Cells that it spans.
        cells: f64,
    },
    /// Barus' law with α·p₀ above 14: its spike grows with refinement.
    SteepBarus {
        /// α·p₀.
        exponent: f64,
    },
    /// Pressure above 4 GPa, far beyond the measurements of any viscosity law.
    ExtrapolatedViscosity {
        /// Largest pressure.
        pressure: Pressure,
    },
}

/// Steady film of a smooth contact.
#[derive(Debug, Clone, PartialEq, Serialize)]
pub struct SteadyFilm {
    /// Scales of the contact.
    pub scales: Scales,
    /// Places of the nodes over a.
    pub x: Vec<f64>,
    /// Pressure over p₀.
    pub pressure: Vec<f64>,
    /// Film over a²/R.
    pub film: Vec<f64>,
    /// Void fraction of cavitated nodes.
    pub void: Vec<f64>,
    /// Film at x = 0.
    pub central_film: Length,
    /// Thinnest film under pressure.
    pub minimum_film: Length,
    /// Place of the thinnest film over a.
    pub minimum_place: f64,
    /// Flux of oil over the flux at ambient density through one a²/R: ρH at the centre.
    pub flux: f64,
    /// Pressure spike before the outlet over p₀ and its place over a, if there is one.
    pub spike: Option<(f64, f64)>,
    /// Last place under pressure, over a.
    pub exit: f64,
    /// Rolling force on one surface, ∫ (h/2)·dp/dx dx.
    pub rolling_force: LineLoad,
    /// Warnings.
    pub warnings: Vec<Warning>,
}

/// Steady film of a smooth contact from a cold start.
///
/// # Errors
/// When an input is outside its domain or no start converges.
///
/// ```
/// use asperity_ehl::{LineContact, Oil, SteadySettings, steady};
/// use asperity_oil::{DensityLaw, ShearLaw, PressureViscosityLaw};
/// let oil = Oil {
///     viscosity: "10 mPa s".parse()?,
///     pressure_viscosity: "18 1/GPa".parse()?,
///     viscosity_law: PressureViscosityLaw::Roelands { exponent: 0.6 },
///     density_law: DensityLaw::DowsonHigginson,
///     shear_law: ShearLaw::Newtonian,
/// };
/// let contact = LineContact::at_pressure(
///     "10 mm".parse()?, "115.4 GPa".parse()?, "1.2 GPa".parse()?, "5 m/s".parse()?, 0.0,
/// )?;
/// let film = steady::solve(&contact, &oil, &SteadySettings::default())?;
/// assert!((film.value.central_film.si() / 279e-9 - 1.0).abs() < 0.01);
/// assert!(film.evidence.load_error < 1e-10);
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
pub fn solve(
    contact: &LineContact,
    oil: &Oil,
    settings: &SteadySettings,
) -> Result<Solved<SteadyFilm>, EhlError> {
    solve_over_ridges(contact, oil, settings, Length::from_si(0.0))
}

/// Steady mean film over ridges across the flow with a standard deviation `roughness` of both surfaces together.
///
/// The ridges are much shorter than the contact, as high on either surface and not flattened. To the second order in their height
/// the flow is the mean over them (`EHL-flux`).
///
/// # Errors
/// As [`solve`], and when the roughness is negative.
pub fn solve_over_ridges(
    contact: &LineContact,
    oil: &Oil,
    settings: &SteadySettings,
    roughness: Length,
) -> Result<Solved<SteadyFilm>, EhlError> {
    let scales = contact.scales(oil)?;
    let roughness = DomainError::non_negative("roughness", roughness)?;
    let fluid = Fluid {
        roughness: roughness / scales.film,
        ..Fluid::new(oil, &scales)
    };
    let window = settings
        .window
        .unwrap_or_else(|| Window::tabulated(&scales));
    let solved = solve_sequence(&scales, &fluid, window, settings.cells, &LIMITS)?;
    let evidence = Evidence {
        newton_iterations: solved.newton_iterations,
        gmres_iterations: solved.gmres_iterations,
        ..Evidence::new(&solved.grid, &solved.solution, 0.0)
    };
    let film = SteadyFilm::new(&scales, oil, &solved.grid, solved.solution);
    Ok(Solved {
        value: film,
        evidence,
    })
}

/// Converged solution on an even grid with its solver.
pub(crate) struct EvenGridSolution {
    pub(crate) grid: FilmGrid,
    pub(crate) system: FourierSystem,
    pub(crate) newton: Newton,
    pub(crate) solution: Solution,
    pub(crate) newton_iterations: usize,
    pub(crate) gmres_iterations: usize,
}

/// An even grid with its solver.
struct Level {
    grid: FilmGrid,
    gap: Vec<f64>,
    system: FourierSystem,
    newton: Newton,
}

impl Level {
    fn new(window: Window, cells: usize) -> Self {
        let grid = FilmGrid::uniform(window.inlet, window.outlet, cells);
        let gap = parabola(&grid);
        let system = FourierSystem::new(grid.spacing[0], cells);
        let newton = Newton::new(grid.nodes());
        Self {
            grid,
            gap,
            system,
            newton,
        }
    }

    fn solve(
        &mut self,
        fluid: &Fluid,
        start: Unknowns,
        limits: &Limits,
        work: &mut (usize, usize),
    ) -> Result<Solution, NewtonEffort> {
        let problem = NewtonProblem {
            grid: &self.grid,
            fluid,
            gap: &self.gap,
            contact_film: 0.0,
            storage: None,
            ceiling: None,
        };
        let result = self.newton.solve(&problem, &mut self.system, start, limits);
        let effort = result.as_ref().map_or_else(|effort| *effort, |s| s.effort);
        work.0 += effort.iterations;
        work.1 += effort.linear_iterations;
        result
    }
}

/// X²/2.
pub(crate) fn parabola(grid: &FilmGrid) -> Vec<f64> {
    grid.x.iter().map(|x| 0.5 * x * x).collect()
}

/// Number of cells that the two-level solver accepts.
pub(crate) fn check_cells(cells: usize) -> Result<usize, EhlError> {
    if cells.is_multiple_of(CELL_MULTIPLE) && (CELL_MULTIPLE..=MOST_CELLS).contains(&cells) {
        Ok(cells)
    } else {
        Err(EhlError::cells(cells, CELL_MULTIPLE, MOST_CELLS))
    }
}

/// Solves on coarser and coarser cells first; falls back to a direct start, then to continuation.
pub(crate) fn solve_sequence(
    scales: &Scales,
    fluid: &Fluid,
    window: Window,
    cells: usize,
    limits: &Limits,
) -> Result<EvenGridSolution, EhlError> {
    let (cells, window) = (check_cells(cells)?, window.check()?);
    let film = scales.film_guess();
    let mut work = (0, 0);
    let mut level = Level::new(window, cells);
    let tight = &Limits {
        loosest: limits.linear_tolerance,
        ..*limits
    };
    let result = sequence(fluid, window, film, &mut level, limits, &mut work)
        .or_else(|_| sequence(fluid, window, film, &mut level, tight, &mut work))
        .or_else(|_| {
            let start = hertz_start(&level.grid, &mut level.system, film);
            level.solve(fluid, start, tight, &mut work)
        })
        .or_else(|_| continuation(fluid, film, &mut level, tight, &mut work));
    match result {
        Ok(solution) => Ok(EvenGridSolution {
            grid: level.grid,
            system: level.system,
            newton: level.newton,
            solution,
            newton_iterations: work.0,
            gmres_iterations: work.1,
        }),
        Err(effort) => {
            checkpoint()?;
            Err(EhlError::not_converged(
                cells,
                effort.iterations,
                effort.change,
                effort.flips,
                "use more cells, or a law that bends (Roelands) where Barus' exponent alpha p0 exceeds 14",
            ))
        }
    }
}

fn sequence(
    fluid: &Fluid,
    window: Window,
    film: f64,
    level: &mut Level,
    limits: &Limits,
    work: &mut (usize, usize),
) -> Result<Solution, NewtonEffort> {
    let cells = level.grid.spacing.len();
    let coarse_limits = Limits {
        loosest: COARSE_LIMITS.linear_tolerance.max(limits.loosest),
        ..COARSE_LIMITS
    };
    let mut known: Option<(FilmGrid, Solution)> = None;
    for part in parts(cells, window, film) {
        let mut coarse = Level::new(window, cells / part);
        let start = match &known {
            None => hertz_start(&coarse.grid, &mut coarse.system, film),
            Some((grid, solution)) => transfer(grid, solution, &coarse.grid),
        };
        let solution = coarse.solve(fluid, start, &coarse_limits, work)?;
        known = Some((coarse.grid, solution));
    }
    let start = match &known {
        None => hertz_start(&level.grid, &mut level.system, film),
        Some((grid, solution)) => transfer(grid, solution, &level.grid),
    };
    level.solve(fluid, start, limits, work)
}

/// Number of cells of the finest grid over the number of cells of each grid before it: as coarse as the inlet zone allows.
fn parts(cells: usize, window: Window, film: f64) -> Vec<usize> {
    let inlet = (0.53 * film).powf(2.0 / 3.0);
    let fits = |part: usize| {
        let coarse = cells / part;
        let cell = (window.outlet - window.inlet) / coarse as f64;
        coarse >= COARSEST
            && cells.is_multiple_of(4 * part)
            && (part <= 4 || inlet >= COARSE_INLET * cell)
    };
    [32, 16, 8, 4, 2]
        .into_iter()
        .filter(|part| fits(*part))
        .collect()
}

/// Continuation from a film of 30 times λ down to the requested film.
fn continuation(
    fluid: &Fluid,
    film: f64,
    level: &mut Level,
    limits: &Limits,
    work: &mut (usize, usize),
) -> Result<Solution, NewtonEffort> {
    let thicker = |factor: f64| film * factor.powf(0.7);
    let mut start = hertz_start(&level.grid, &mut level.system, thicker(CONTINUATION[0]));
    let mut last = Err(NewtonEffort::default());
    for factor in CONTINUATION {
        let thick = Fluid {
            speed: fluid.speed * factor,
            ..*fluid
        };
        let solution = level.solve(&thick, start, limits, work)?;
        start = solution.unknowns.clone();
        last = Ok(solution);
    }
    last
}

/// Start from the Hertz pressure, with `film` at the thinnest place and a void behind the contact.
pub(crate) fn hertz_start(grid: &FilmGrid, system: &mut impl ElasticSystem, film: f64) -> Unknowns {
    let mut pressure: Vec<f64> = grid
        .x
        .iter()
        .map(|x| (1.0 - x * x).max(0.0).sqrt())
        .collect();
    let mut shape = vec![0.0; grid.nodes()];
    system.displacement(&pressure, &mut shape);
    for (value, x) in shape.iter_mut().zip(&grid.x) {
        *value += 0.5 * x * x;
    }
    let rigid = film - shape.iter().copied().fold(f64::INFINITY, f64::min);
    let nodes = grid.nodes();
    let mut state = vec![NodeState::Full; nodes];
    let mut void = vec![0.0; nodes];
    for i in 1..nodes - 1 {
        if grid.x[i] >= 1.0 {
            state[i] = NodeState::Cavitated;
            pressure[i] = 0.0;
            void[i] = 1.0 - film / (rigid + shape[i]).max(film);
        }
    }
    Unknowns {
        flow: vec![None; nodes],
        pressure,
        void,
        state,
        rigid,
    }
}

/// Solution of one grid as the start on another.
pub(crate) fn transfer(grid: &FilmGrid, solution: &Solution, onto: &FilmGrid) -> Unknowns {
    let known = &solution.unknowns;
    let exit = (0..grid.nodes())
        .rev()
        .find(|&i| known.pressure[i] > 0.0)
        .map_or(1.0, |i| grid.x[i]);
    let nodes = onto.nodes();
    let mut unknowns = Unknowns {
        pressure: vec![0.0; nodes],
        void: vec![0.0; nodes],
        state: vec![NodeState::Full; nodes],
        rigid: known.rigid,
        flow: vec![None; nodes],
    };
    for i in 1..nodes - 1 {
        if onto.x[i] > exit {
            unknowns.state[i] = NodeState::Cavitated;
            unknowns.void[i] = grid.interpolate(&known.void, onto.x[i]);
        } else {
            unknowns.pressure[i] = grid.interpolate(&known.pressure, onto.x[i]);
        }
    }
    unknowns
}

impl SteadyFilm {
    pub(crate) fn new(scales: &Scales, oil: &Oil, grid: &FilmGrid, solution: Solution) -> Self {
        let (pressure, film) = (solution.unknowns.pressure, solution.film);
        let (minimum_place, minimum) = thinnest(grid, &pressure, &film);
        let largest = pressure.iter().copied().fold(0.0, f64::max);
        let central = cubic_at(grid, &film, 0.0);
        let middle = solution.flux.len() / 2;
        let mut warnings = warnings(scales, oil, grid, central);
        let p_max = scales.max_pressure * largest;
        if p_max.si() > 4e9 {
            warnings.push(Warning::ExtrapolatedViscosity { pressure: p_max });
        }
        Self {
            scales: *scales,
            central_film: scales.film_length(central),
            minimum_film: scales.film_length(minimum),
            minimum_place,
            flux: solution.flux[middle],
            spike: spike(grid, &pressure),
            exit: (0..grid.nodes())
                .rev()
                .find(|&i| pressure[i] > 0.0)
                .map_or(0.0, |i| grid.x[i]),
            rolling_force: rolling_force(scales, &pressure, &film),
            x: grid.x.clone(),
            void: solution.unknowns.void,
            pressure,
            film,
            warnings,
        }
    }
}

fn warnings(scales: &Scales, oil: &Oil, grid: &FilmGrid, central: f64) -> Vec<Warning> {
    let mut warnings = Vec::new();
    let inlet_face = grid
        .x
        .partition_point(|x| *x < -1.0)
        .min(grid.spacing.len() - 1);
    let cells = (0.53 * central.max(0.0)).powf(2.0 / 3.0) / grid.spacing[inlet_face];
    if cells < 2.0 {
        warnings.push(Warning::InletUnresolved { cells });
    }
    let exponent = oil.pressure_viscosity.si() * scales.max_pressure.si();
    if oil.viscosity_law == PressureViscosityLaw::Barus && exponent > 14.0 {
        warnings.push(Warning::SteepBarus { exponent });
    }
    warnings
}

/// F_r = ∫ (h/2)·(dp/dx) dx on one surface                                    `[Rolling-force]`
fn rolling_force(scales: &Scales, pressure: &[f64], film: &[f64]) -> LineLoad {
    cite!("Rolling-force");
    let sum: f64 = pressure
        .windows(2)
        .zip(film.windows(2))
        .map(|(p, h)| 0.25 * (h[0] + h[1]) * (p[1] - p[0]))
        .sum();
    LineLoad::from_si(sum * scales.film * scales.max_pressure.si())
}

/// Thinnest film under pressure, by a parabola through three nodes: place and film.
fn thinnest(grid: &FilmGrid, pressure: &[f64], film: &[f64]) -> (f64, f64) {
    let nodes = grid.nodes();
    let least = (1..nodes - 1)
        .filter(|&i| pressure[i] > 0.0)
        .min_by(|&i, &j| film[i].total_cmp(&film[j]));
    let Some(i) = least else {
        return (0.0, film[nodes / 2]);
    };
    let (left, right) = (grid.x[i - 1] - grid.x[i], grid.x[i + 1] - grid.x[i]);
    let (d_left, d_right) = (
        (film[i - 1] - film[i]) / left,
        (film[i + 1] - film[i]) / right,
    );
    let curvature = (d_right - d_left) / (right - left);
    let slope = d_right - curvature * right;
    if curvature <= 0.0 {
        return (grid.x[i], film[i]);
    }
    let shift = (-0.5 * slope / curvature).clamp(left, right);
    (
        grid.x[i] + shift,
        film[i] + shift * (slope + curvature * shift),
    )
}

/// Cubic Lagrange value at `x`.
fn cubic_at(grid: &FilmGrid, values: &[f64], x: f64) -> f64 {
    let after = grid.x.partition_point(|&node| node < x);
    let first = after.saturating_sub(2).min(grid.nodes() - 4);
    (first..first + 4)
        .map(|i| {
            let weight: f64 = (first..first + 4)
                .filter(|&j| j != i)
                .map(|j| (x - grid.x[j]) / (grid.x[i] - grid.x[j]))
                .product();
            weight * values[i]
        })
        .sum()
}

/// Last local maximum of the pressure behind X = 0.3 with its place, where the pressure rose before it.
fn spike(grid: &FilmGrid, pressure: &[f64]) -> Option<(f64, f64)> {
    (1..grid.nodes() - 1)
        .rev()
        .take_while(|&i| grid.x[i] > 0.3)
        .find(|&i| pressure[i] > pressure[i - 1] && pressure[i] >= pressure[i + 1])
        .map(|i| (pressure[i], grid.x[i]))
}
