//! Steady film on graded grids with dense factors: reference values for tables.
//!
//! Built with the feature `oracle`; the tests of the iterative solver compare with it.
//!
//! The nodes cluster where pressure and film bend; grids are doubled and the last two extrapolated
//! (Richardson, second order). O(n³): seconds at a thousand nodes.

use asperity_core::cite;
use serde::Serialize;

use asperity_oil::RelativeViscosity;

use crate::dimensionless::{LineContact, Scales};
use crate::error::EhlError;
use crate::evidence::{Evidence, Solved};
use crate::fluid::Fluid;
use crate::grid::FilmGrid;
use crate::linear::DenseSystem;
use crate::newton::{Limits, Newton, NewtonEffort, NewtonProblem, Solution};
use crate::oil::Oil;
use crate::steady::{SteadyFilm, Window, hertz_start, parabola, transfer};

/// Limits of the dense iteration: tight, because the direct solution leaves no linear residual.
const LIMITS: Limits = Limits {
    tolerance: 1e-9,
    linear_tolerance: 0.0,
    loosest: 0.0,
    largest_change: 0.3,
    iterations: 80,
    flips: 0,
    load: 1e-10,
};
/// Points at which node densities are integrated: many more than nodes, so that their rounding does not show.
const FINE: usize = 20_000;
/// Largest growth of the node distance per distance: neighbouring cells differ by at most 6 %.
const GROWTH: f64 = 0.06;
/// Pressure-viscosity slopes, over p₀, from which an isoviscous film is reached by continuation.
const SOFTENING: [f64; 5] = [1.0, 0.6, 0.3, 0.1, 0.0];

/// Value extrapolated from two grids, with a third of their difference as its error.
#[derive(Debug, Clone, Copy, PartialEq, Serialize)]
pub struct Extrapolated {
    /// Value on an infinitely fine grid.
    pub value: f64,
    /// Estimate of its error.
    pub error: f64,
}

/// Reference values of a smooth steady film, in the units of Moes' diagram.
#[derive(Debug, Clone, PartialEq, Serialize)]
pub struct ReferenceFilm {
    /// Central film.
    pub central: Extrapolated,
    /// Minimum film.
    pub minimum: Extrapolated,
    /// Flux over the flux of one unit of film of ambient density.
    pub flux: Extrapolated,
    /// Central film of every grid, coarse to fine.
    pub sequence: Vec<f64>,
    /// Film on the finest grid.
    pub finest: SteadyFilm,
}

/// Reference values on grids of `cells`, twice, ... `cells`·2^`doublings`.
///
/// φ_∞ = φ_h + (φ_h − φ_2h)/3                                              `[Richardson]`
///
/// # Errors
/// When an input is outside its domain or a grid does not converge.
pub fn reference(
    contact: &LineContact,
    oil: &Oil,
    window: Option<Window>,
    cells: usize,
    doublings: usize,
) -> Result<Solved<ReferenceFilm>, EhlError> {
    cite!("Richardson");
    let scales = contact.scales(oil)?;
    let fluid = Fluid::new(oil, &scales);
    let window = window.unwrap_or_else(|| Window::tabulated(&scales));
    let mut work = (0, 0);
    let mut known = first(&scales, &fluid, window, cells, &mut work)
        .map_err(|effort| not_converged(cells, effort))?;
    let mut films = vec![SteadyFilm::new(&scales, oil, &known.0, known.1.clone())];
    for doubling in 1..=doublings.max(1) {
        let finer = cells << doubling;
        let grid = FilmGrid::new(bent_nodes(&known.0, &known.1, finer));
        let start = transfer(&known.0, &known.1, &grid);
        let solution = solve(&grid, &fluid, start, &mut work)
            .map_err(|effort| not_converged(finer, effort))?;
        films.push(SteadyFilm::new(&scales, oil, &grid, solution.clone()));
        known = (grid, solution);
    }
    let evidence = Evidence {
        newton_iterations: work.0,
        gmres_iterations: work.1,
        ..Evidence::new(&known.0, &known.1, 0.0)
    };
    Ok(Solved {
        value: summary(&scales, films),
        evidence,
    })
}

fn summary(scales: &Scales, mut films: Vec<SteadyFilm>) -> ReferenceFilm {
    let moes = |length: f64| scales.moes_film(length / scales.film);
    let values = |f: fn(&SteadyFilm) -> f64| -> Vec<f64> { films.iter().map(f).collect() };
    let central = values(|film| film.central_film.si());
    let minimum = values(|film| film.minimum_film.si());
    let flux = values(|film| film.flux);
    let scaled = |values: &[f64]| values.iter().map(|v| moes(*v)).collect::<Vec<_>>();
    let sequence = scaled(&central);
    let flux: Vec<f64> = flux.iter().map(|f| scales.moes_film(*f)).collect();
    ReferenceFilm {
        central: extrapolated(&sequence),
        minimum: extrapolated(&scaled(&minimum)),
        flux: extrapolated(&flux),
        sequence,
        finest: films.remove(films.len() - 1),
    }
}

fn extrapolated(values: &[f64]) -> Extrapolated {
    let (coarse, fine) = (values[values.len() - 2], values[values.len() - 1]);
    let third = (fine - coarse) / 3.0;
    Extrapolated {
        value: fine + third,
        error: third.abs(),
    }
}

fn not_converged(cells: usize, effort: NewtonEffort) -> EhlError {
    let hint = "start from other numbers of cells, or use the even grid";
    EhlError::not_converged(cells, effort.iterations, effort.change, effort.flips, hint)
}

fn solve(
    grid: &FilmGrid,
    fluid: &Fluid,
    start: crate::newton::Unknowns,
    work: &mut (usize, usize),
) -> Result<Solution, NewtonEffort> {
    let gap = parabola(grid);
    let problem = NewtonProblem {
        grid,
        fluid,
        gap: &gap,
        contact_film: 0.0,
        storage: None,
        ceiling: None,
    };
    let mut system = DenseSystem::new(grid);
    let result = Newton::new(grid.nodes()).solve(&problem, &mut system, start, &LIMITS);
    let effort = result.as_ref().map_or_else(|effort| *effort, |s| s.effort);
    work.0 += effort.iterations;
    work.1 += effort.linear_iterations;
    result
}

/// First grid from the Hertz pressure; isoviscous films by continuation from a soft exponential.
fn first(
    scales: &Scales,
    fluid: &Fluid,
    window: Window,
    cells: usize,
    work: &mut (usize, usize),
) -> Result<(FilmGrid, Solution), NewtonEffort> {
    let soft = fluid.viscosity == RelativeViscosity::Constant && scales.moes_load >= 2.0;
    let unit = (scales.moes_load / std::f64::consts::TAU).sqrt();
    let film = if soft {
        Scales {
            moes_lubricant: 1.0,
            ..*scales
        }
        .film_guess()
    } else {
        scales.film_guess()
    };
    let grid = FilmGrid::new(clustered_nodes(window, film, cells));
    let mut system = DenseSystem::new(&grid);
    let mut start = hertz_start(&grid, &mut system, film);
    let steps: &[f64] = if soft { &SOFTENING } else { &[0.0] };
    let mut last = Err(NewtonEffort::default());
    for factor in steps {
        let viscosity = if *factor > 0.0 {
            RelativeViscosity::Exponential {
                slope: factor * unit,
            }
        } else {
            fluid.viscosity
        };
        let solution = solve(
            &grid,
            &Fluid {
                viscosity,
                ..*fluid
            },
            start,
            work,
        )?;
        start = solution.unknowns.clone();
        last = Ok(solution);
    }
    last.map(|solution| (grid, solution))
}

/// Nodes clustered at inlet and outlet over the inlet length (0.53·H_c)^(2/3).
fn clustered_nodes(window: Window, film: f64, cells: usize) -> Vec<f64> {
    let length = (0.53 * film).max(1e-9).powf(2.0 / 3.0).min(0.5);
    let norm = ((1.0 + length) / length).ln();
    let width = window.outlet - window.inlet;
    let density = |x: f64| {
        let near = |place: f64| 1.0 / (length + (x - place).abs()) / (2.0 * norm);
        0.5 / width + 0.35 * near(-1.0) + 0.5 * near(0.97)
    };
    let places: Vec<f64> = (0..=FINE)
        .map(|k| window.inlet + width * k as f64 / FINE as f64)
        .collect();
    let densities: Vec<f64> = places.iter().map(|x| density(*x)).collect();
    equal_parts(&places, &densities, cells)
}

/// Nodes clustered where the pressure and the logarithm of the film bend.
fn bent_nodes(grid: &FilmGrid, solution: &Solution, cells: usize) -> Vec<f64> {
    let logs: Vec<f64> = solution.film.iter().map(|h| h.max(1e-12).ln()).collect();
    let pressure = roots_of_curvature(grid, &solution.unknowns.pressure);
    let film = roots_of_curvature(grid, &logs);
    let inner = FilmGrid::new(grid.x[1..grid.nodes() - 1].to_vec());
    let (inlet, outlet) = (grid.x[0], grid.x[grid.nodes() - 1]);
    let (p_sum, h_sum) = (inner.integral(&pressure), inner.integral(&film));
    let combined: Vec<f64> = pressure
        .iter()
        .zip(&film)
        .map(|(p, h)| 0.25 / (outlet - inlet) + 0.35 * p / p_sum + 0.4 * h / h_sum)
        .collect();
    let step = (outlet - inlet) / (2 * FINE) as f64;
    let places: Vec<f64> = (0..=2 * FINE).map(|k| inlet + step * k as f64).collect();
    let mut size: Vec<f64> = places
        .iter()
        .map(|x| 1.0 / (inner.interpolate(&combined, *x) * cells as f64))
        .collect();
    for k in 1..size.len() {
        size[k] = size[k].min(size[k - 1] + GROWTH * step);
    }
    for k in (0..size.len() - 1).rev() {
        size[k] = size[k].min(size[k + 1] + GROWTH * step);
    }
    let densities: Vec<f64> = size.iter().map(|s| 1.0 / s).collect();
    equal_parts(&places, &densities, cells)
}

/// Square roots of the second derivative at the inner nodes.
fn roots_of_curvature(grid: &FilmGrid, values: &[f64]) -> Vec<f64> {
    (1..grid.nodes() - 1)
        .map(|i| {
            let (left, right) = (grid.spacing[i - 1], grid.spacing[i]);
            let bend = (values[i + 1] - values[i]) / right - (values[i] - values[i - 1]) / left;
            (bend.abs() / (0.5 * (left + right))).sqrt()
        })
        .collect()
}

/// Places that divide the integral of a density into `cells` equal parts.
fn equal_parts(places: &[f64], densities: &[f64], cells: usize) -> Vec<f64> {
    let mut sums = vec![0.0];
    for (x, d) in places.windows(2).zip(densities.windows(2)) {
        let last = sums[sums.len() - 1];
        sums.push(last + 0.5 * (d[0] + d[1]) * (x[1] - x[0]));
    }
    let whole = sums[sums.len() - 1];
    let mut nodes = vec![places[0]];
    for k in 1..cells {
        let target = whole * k as f64 / cells as f64;
        let after = sums.partition_point(|s| *s <= target).min(sums.len() - 1);
        let part = (target - sums[after - 1]) / (sums[after] - sums[after - 1]);
        nodes.push(places[after - 1] + part * (places[after] - places[after - 1]));
    }
    nodes.push(places[places.len() - 1]);
    nodes
}
