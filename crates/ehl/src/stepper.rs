//! Time steps of a rough contact: second-order backward differences, advected starts, halved steps.
//!
//! Every step is one nonlinear problem of [`newton`](crate::newton) with the storage of oil. A step that does not
//! converge is repeated at half its length, and the length recovers by doubling. The roughness in the contact moves
//! with the oil at the mean speed, so a start whose rough part is shifted by the step is close to the solution.
//!
//! | symbol | meaning |
//! |---|---|
//! | T | time in half-widths travelled at the mean speed |
//! | S | slide-to-roll ratio; the surfaces travel 1 + S/2 and 1 − S/2 half-widths per T |
//! | ω | ratio of a step to the one before |

use asperity_core::cancel::checkpoint;
use asperity_core::cite;
use asperity_core::quantity::Length;

use crate::dimensionless::Scales;
use crate::error::EhlError;
use crate::fluid::Fluid;
use crate::grid::FilmGrid;
use crate::linear::FourierSystem;
use crate::moving_profile::MovingProfile;
use crate::newton::{Ceiling, Limits, Newton, NewtonProblem, NodeState, Solution, Unknowns};
use crate::reynolds::Storage;
use crate::steady::{EvenGridSolution, parabola};

/// Shortest step: this part of the longest. A step that still fails is an error.
const SMALLEST_PART: usize = 64;
/// Range of x/a in which the start of a step is advected: inlet and contact, before the film ruptures.
const ADVECTED: (f64, f64) = (-2.0, 1.0);

/// Boundary film, ceiling and step of a rough contact.
#[derive(Clone, Copy)]
pub(crate) struct StepSettings {
    pub(crate) contact_film: f64,
    pub(crate) ceiling: Option<Ceiling>,
    /// Longest step over the cell.
    pub(crate) courant: f64,
    /// Travel over which periodic surfaces rise from smooth.
    pub(crate) ramp: f64,
    pub(crate) limits: Limits,
}

/// Surface on its way through the window.
struct Surface {
    profile: MovingProfile,
    /// Half-widths travelled per T.
    speed: f64,
    start: f64,
}

/// State of a contact at one time, with the solver of its next step.
pub(crate) struct Stepper {
    pub(crate) grid: FilmGrid,
    pub(crate) scales: Scales,
    fluid: Fluid,
    system: FourierSystem,
    newton: Newton,
    surfaces: [Surface; 2],
    settings: StepSettings,
    smooth_gap: Vec<f64>,
    smooth_pressure: Vec<f64>,
    gap: Vec<f64>,
    past: Vec<f64>,
    /// Oil at the last two times.
    mass: Vec<f64>,
    mass_before: Option<Vec<f64>>,
    longest: f64,
    step: f64,
    last_step: f64,
    pub(crate) time: f64,
    pub(crate) now: Solution,
    pub(crate) steps_cut: usize,
}

impl Stepper {
    /// The contact at T = 0, `smooth`, with two surfaces.
    pub(crate) fn new(
        smooth: EvenGridSolution,
        scales: Scales,
        fluid: Fluid,
        profiles: [MovingProfile; 2],
        settings: StepSettings,
    ) -> Self {
        let EvenGridSolution {
            grid,
            mut system,
            newton,
            solution,
            ..
        } = smooth;
        system.prepare_transient();
        let a = scales.half_width.si();
        let inlet = grid.x[0] * a;
        let half_slip = 0.5 * scales.slide_to_roll;
        let [first, second] = profiles;
        let surface = |profile: MovingProfile, speed: f64| Surface {
            start: profile.start(inlet),
            profile,
            speed,
        };
        let longest = settings.courant * grid.spacing[0];
        Self {
            surfaces: [
                surface(first, 1.0 + half_slip),
                surface(second, 1.0 - half_slip),
            ],
            smooth_gap: parabola(&grid),
            smooth_pressure: solution.unknowns.pressure.clone(),
            gap: vec![0.0; grid.nodes()],
            past: vec![0.0; grid.nodes()],
            mass: solution.mass.clone(),
            mass_before: None,
            longest,
            step: longest,
            last_step: longest,
            time: 0.0,
            now: solution,
            steps_cut: 0,
            grid,
            scales,
            fluid,
            system,
            newton,
            settings,
        }
    }

    /// Advances one step, halving it until Newton's method converges; returns its length.
    ///
    /// # Errors
    /// When the smallest step does not converge.
    pub(crate) fn advance(&mut self) -> Result<f64, EhlError> {
        loop {
            let step = self.step;
            match self.attempt(step) {
                Ok(solution) => {
                    self.mass_before =
                        Some(std::mem::replace(&mut self.mass, solution.mass.clone()));
                    self.now = solution;
                    self.time += step;
                    self.last_step = step;
                    self.step = (2.0 * step).min(self.longest);
                    return Ok(step);
                }
                Err(change) => {
                    checkpoint()?;
                    self.step *= 0.5;
                    self.steps_cut += 1;
                    if self.step * (SMALLEST_PART as f64) < 0.99 * self.longest {
                        return Err(EhlError::step_failed(self.time, SMALLEST_PART, change));
                    }
                }
            }
        }
    }

    /// Solves at time T + step; the error is the last change of the pressure.
    fn attempt(&mut self, step: f64) -> Result<Solution, f64> {
        self.set_gap(self.time + step);
        let rate = self.set_past(step);
        // The start only affects the number of iterations, not the solution.
        let start = self.advected(step);
        let problem = NewtonProblem {
            grid: &self.grid,
            fluid: &self.fluid,
            gap: &self.gap,
            contact_film: self.settings.contact_film,
            storage: Some(Storage {
                rate,
                past: &self.past,
            }),
            ceiling: self.settings.ceiling,
        };
        self.newton
            .solve(&problem, &mut self.system, start, &self.settings.limits)
            .map_err(|effort| effort.change)
    }

    /// Gap of the rigid rough surfaces.
    ///
    /// X²/2 − (R/a²)·[z₁(x − (1 + S/2)·T·a) + z₂(x − (1 − S/2)·T·a)]       `[EHL-film]`
    fn set_gap(&mut self, time: f64) {
        cite!("EHL-film");
        let a = self.scales.half_width.si();
        let risen = (time / self.settings.ramp).min(1.0);
        self.gap.copy_from_slice(&self.smooth_gap);
        for surface in self.surfaces.iter().filter(|s| !s.profile.is_smooth()) {
            // A single profile enters the window from its tapered end; a periodic one fills it at once and rises in
            // height instead.
            let factor = if surface.profile.length().is_some() {
                1.0
            } else {
                risen
            };
            let scale = factor / self.scales.film;
            for (gap, x) in self.gap.iter_mut().zip(&self.grid.x) {
                let s = surface.start + a * (x - surface.speed * time);
                *gap -= scale * surface.profile.height(s);
            }
        }
    }

    /// Time derivative of the oil by variable backward differences; Euler in the first step.
    ///
    /// ```text
    /// dm/dT = [(1 + 2ω)·m − (1 + ω)²·m₁ + ω²·m₂]/((1 + ω)·ΔT)                        [BDF2]
    /// ```
    fn set_past(&mut self, step: f64) -> f64 {
        cite!("BDF2");
        let Some(before) = &self.mass_before else {
            for (past, m) in self.past.iter_mut().zip(&self.mass) {
                *past = -m / step;
            }
            return 1.0 / step;
        };
        let omega = step / self.last_step;
        let last = -(1.0 + omega) / step;
        let first = omega * omega / ((1.0 + omega) * step);
        for ((past, m_1), m_2) in self.past.iter_mut().zip(&self.mass).zip(before) {
            *past = last * m_1 + first * m_2;
        }
        (1.0 + 2.0 * omega) / ((1.0 + omega) * step)
    }

    /// Start of a step: the rough part of the pressure and the states, shifted at the mean speed.
    fn advected(&self, step: f64) -> Unknowns {
        let known = &self.now.unknowns;
        let mut start = known.clone();
        if self.mass_before.is_none() {
            return start;
        }
        let nodes = self.grid.nodes();
        let shift = step / self.grid.spacing[0];
        let carried = |values: &[f64], i: usize| {
            let place = (i as f64 - shift).max(0.0);
            let k = (place as usize).min(nodes - 2);
            let part = place - k as f64;
            values[k] * (1.0 - part) + values[k + 1] * part
        };
        let smooth = &self.smooth_pressure;
        for i in 1..nodes - 1 {
            if self.grid.x[i] <= ADVECTED.0 || self.grid.x[i] >= ADVECTED.1 {
                continue;
            }
            let from = (i as f64 - shift).round().max(0.0) as usize;
            let state = known.state[from];
            start.state[i] = state;
            start.flow[i] = known.flow[from];
            if state == NodeState::Cavitated {
                start.pressure[i] = 0.0;
                start.void[i] = known.void[from];
            } else {
                let rough = carried(&known.pressure, i) + smooth[i] - carried(smooth, i);
                start.pressure[i] = match (start.flow[i], self.settings.ceiling) {
                    (Some(_), Some(ceiling)) => ceiling.pressure,
                    _ => rough.max(0.0),
                };
                start.void[i] = 0.0;
            }
        }
        start
    }

    /// Travel until every surface fills the window with its full heights.
    pub(crate) fn filled_after(&self) -> f64 {
        let window = self.grid.x[self.grid.nodes() - 1] - self.grid.x[0];
        let taper = |surface: &Surface| surface.profile.taper() / self.scales.half_width.si();
        self.surfaces
            .iter()
            .filter(|surface| surface.profile.length().is_some())
            .map(|surface| (window + taper(surface)) / surface.speed)
            .fold(0.0, f64::max)
    }

    /// Checks that no single pass ends before T = `end`.
    pub(crate) fn check_lengths(&self, end: f64) -> Result<(), EhlError> {
        let a = self.scales.half_width.si();
        for (surface, number) in self.surfaces.iter().zip([1, 2]) {
            let Some(length) = surface.profile.length().map(Length::si) else {
                continue;
            };
            let needed = end * surface.speed * a + surface.profile.taper();
            if surface.speed <= 0.0 || needed > length {
                let needed = if surface.speed > 0.0 {
                    needed
                } else {
                    f64::INFINITY
                };
                return Err(EhlError::profile_too_short(number, length, needed));
            }
        }
        Ok(())
    }
}
