//! Running-in of the two flanks of a case, for film and friction of run-in flanks.
//!
//! Every window of the pinion's trace is pressed onto every window of the wheel's in a cycle, as hunting teeth do, under the
//! whole load, as where a mesh starts, stops or creeps and no film carries. Pressures are limited to the shakedown limit of
//! repeated sliding contact, not to the indentation hardness: asperities that slide past each other a million times flow
//! until they stay elastic. What flows stays off both flanks, shared by the pressures they flow at. Windows lie a contact width
//! apart and shift from cycle to cycle. Passes of a round share no window, so that threads change nothing.
//!
//! Whole loads without a film are the most that running-in takes off at this torque.
//!
//! | symbol | meaning | unit |
//! |---|---|---|
//! | z₁, z₂ | prepared heights of pinion and wheel | m |
//! | w | plastic displacement of a pass | m |
//! | s₁, s₂ | its shares | - |
//! | p_s | shakedown limit of the softer flank with boundary friction | Pa |
//!
//! Left out: wear, tribofilms, and that a pinion's tooth meets oftener than a wheel's.

use asperity_contact::shakedown::shakedown_pressure;
use asperity_contact::{
    Boundary, ContactProblem, ContactSolution, Control, Solver, SolverSettings,
};
use asperity_core::Profile;
use asperity_core::cite;
use asperity_core::quantity::{Length, Pressure};
use asperity_roughness::material_ratio::rk_parameters;
use asperity_roughness::section_heights::section_heights;

use rayon::prelude::*;

use super::displacements::flow_shares;
use super::pressed::softer;
use crate::mesh::MeshPosition;
use crate::result::{FlankHeights, RunInCycle};
use asperity_case::case::Case;
use asperity_case::error::PositionError;
use asperity_case::flanks::{LEAST_POINTS_PER_HALF_WIDTH, Surfaces, Texture};

/// Most cycles.
pub(crate) const MAX_CYCLES: usize = 12;
/// Plastic work of a cycle, relative to the first cycle, below which the flanks have run in.
const SHAKEDOWN: f64 = 0.05;
/// Tolerance of the contacts: a tighter one changes Rq by less than 1e-4.
const TOLERANCE: f64 = 1e-5;
/// Steps of mesh position from pass to pass, and of the windows of pinion and wheel from cycle to cycle, as parts of the
/// whole: powers of the inverse of the real root of x⁴ = x + 1, which fill three dimensions evenly.
const STEPS: [f64; 3] = [
    0.819_172_513_396_164_4,
    0.671_043_606_703_789_3,
    0.549_700_477_901_970_3,
];

/// Flanks that have run in.
pub struct RanIn {
    /// The flanks.
    pub surfaces: Surfaces,
    /// Every cycle of the running-in.
    pub cycles: Vec<RunInCycle>,
    /// Roughness as measured and run in.
    pub heights: [FlankHeights; 2],
}

/// Runs the flanks of a case in, over its mesh positions; `done` is called after each cycle with its number.
///
/// # Errors
/// When a flank has no trace or a contact no solution.
pub fn run_in(
    case: &Case,
    measured: &Surfaces,
    positions: &[MeshPosition],
    done: &dyn Fn(usize),
) -> Result<RanIn, PositionError> {
    let mut running = Running::of(case, measured, places(case, measured, positions)?)?;
    let before = heights_of(measured)?;
    let mut cycles: Vec<RunInCycle> = Vec::new();
    while cycles.len() < MAX_CYCLES {
        let cycle = running.cycle(cycles.len() + 1)?;
        cycles.push(cycle);
        done(cycles.len());
        let first = cycles[0].plastic_work_j_per_m;
        if cycle.plastic_work_j_per_m <= SHAKEDOWN * first {
            break;
        }
    }
    let after = heights_of(&running.surfaces)?;
    Ok(RanIn {
        surfaces: running.surfaces,
        cycles,
        heights: [before, after],
    })
}

/// The mesh positions whose contacts the traces resolve and cover.
///
/// # Errors
/// When a flank has no trace, or there is no such position.
pub(crate) fn places<'a>(
    case: &Case,
    measured: &Surfaces,
    positions: &'a [MeshPosition],
) -> Result<Vec<&'a MeshPosition>, PositionError> {
    let [pinion, wheel] = traces(measured)?;
    let spacing = pinion.spacing();
    let fine = |position: &&MeshPosition| {
        position.hertz.half_width / spacing >= LEAST_POINTS_PER_HALF_WIDTH
            && window_points(case, position, spacing) <= pinion.len().min(wheel.len())
    };
    let places: Vec<&MeshPosition> = positions.iter().filter(fine).collect();
    match places.is_empty() {
        true => Err(PositionError::no_profile()),
        false => Ok(places),
    }
}

/// State of a running-in.
struct Running<'a> {
    case: &'a Case,
    positions: Vec<&'a MeshPosition>,
    /// Shares of the plastic displacement.
    shares: [f64; 2],
    /// Shakedown limit.
    limit: Pressure,
    surfaces: Surfaces,
    /// Points of a window.
    points: usize,
    /// Windows side by side on the traces of pinion and wheel.
    windows: [usize; 2],
    /// A solver for each pass of a round.
    solvers: Vec<Solver>,
    /// Passes made.
    passed: usize,
}

/// A contact of two windows.
struct Pass<'a> {
    position: &'a MeshPosition,
    /// First points of the windows of pinion and wheel.
    starts: [usize; 2],
}

impl<'a> Running<'a> {
    fn of(
        case: &'a Case,
        measured: &Surfaces,
        positions: Vec<&'a MeshPosition>,
    ) -> Result<Self, PositionError> {
        let [pinion, wheel] = traces(measured)?;
        let spacing = pinion.spacing();
        let sizes = positions.iter().map(|at| window_points(case, at, spacing));
        let points = sizes.max().unwrap_or_default();
        let widths: f64 = positions
            .iter()
            .map(|at| 2.0 * at.hertz.half_width.si())
            .sum();
        let width = widths / positions.len() as f64;
        let windows = [pinion, wheel].map(|trace| {
            let free = (trace.len() - points) as f64 * spacing.si();
            (free / width).ceil().max(1.0) as usize
        });
        let solvers =
            (0..windows[0].min(windows[1])).map(|_| Solver::new(points, Boundary::FreeEnds));
        Ok(Self {
            case,
            positions,
            shares: flow_shares(&case.materials, case.flow_pressure)?,
            limit: shakedown_pressure(softer(case)?, case.model.boundary_friction)?,
            surfaces: measured.clone(),
            points,
            windows,
            solvers: solvers.collect::<Result<_, _>>()?,
            passed: 0,
        })
    }

    /// One cycle: the flanks lose what flows in each pass.
    ///
    /// ```text
    /// zᵢ ← zᵢ − sᵢ w under each contact, p ≤ p_s, until the work of a cycle is 5 % of the first's     [Run-in]
    /// ```
    fn cycle(&mut self, number: usize) -> Result<RunInCycle, PositionError> {
        cite!("Run-in");
        let profiles = traces(&self.surfaces)?;
        let spacing = profiles[0].spacing();
        let mut heights = profiles.map(|profile| profile.heights().to_vec());
        let before = self.passed;
        let mut work = 0.0;
        for round in 0..self.windows[0].max(self.windows[1]) {
            let passes = self.round(number, round, &heights);
            self.passed += passes.len();
            let solvers = self.solvers.par_iter_mut();
            let solve = |(solver, pass): (&mut Solver, &Pass<'_>)| {
                press(solver, self.case, self.limit, pass, &heights, spacing)
            };
            let contacts: Vec<Result<_, PositionError>> = solvers.zip(&passes).map(solve).collect();
            for (pass, contact) in passes.iter().zip(contacts) {
                let contact = contact?;
                work += contact.dissipated.si();
                for (k, height) in heights.iter_mut().enumerate() {
                    let under = &mut height[pass.starts[k]..pass.starts[k] + self.points];
                    for (z, w) in under.iter_mut().zip(&contact.plastic_displacement) {
                        *z -= self.shares[k] * w;
                    }
                }
            }
        }
        let [first, second] = heights;
        self.surfaces = self.surfaces.with_traces([
            Profile::new(spacing, first)?,
            Profile::new(spacing, second)?,
        ]);
        let passes = self.passed - before;
        Ok(RunInCycle {
            cycle: number,
            passes,
            plastic_work_j_per_m: work / passes as f64,
            rq_um: heights_of(&self.surfaces)?.rq_um,
        })
    }

    /// The passes of a round: every window of the trace with fewer of them with another window of the other trace.
    fn round(&self, cycle: usize, round: usize, heights: &[Vec<f64>; 2]) -> Vec<Pass<'a>> {
        let [_, shift_pinion, shift_wheel] = STEPS.map(|step| (cycle as f64 * step).fract());
        let start = |k: usize, window: usize, shift: f64| {
            let free = (heights[k].len() - self.points) as f64;
            ((window as f64 + shift) / self.windows[k] as f64 * free) as usize
        };
        let pass = |i: usize| {
            let place = ((self.passed + i) as f64 * STEPS[0]).fract();
            let position = self.positions[(place * self.positions.len() as f64) as usize];
            let other = i + round;
            let [pinion, wheel] = match self.windows[0] <= self.windows[1] {
                true => [i, other % self.windows[1]],
                false => [other % self.windows[0], i],
            };
            Pass {
                position,
                starts: [start(0, pinion, shift_pinion), start(1, wheel, shift_wheel)],
            }
        };
        (0..self.solvers.len()).map(pass).collect()
    }
}

/// The contact of two windows under the whole load of a position, without a film.
fn press(
    solver: &mut Solver,
    case: &Case,
    limit: Pressure,
    pass: &Pass<'_>,
    heights: &[Vec<f64>; 2],
    spacing: Length,
) -> Result<ContactSolution, PositionError> {
    let line = pass.position.line_contact(case.modulus, case.materials);
    let points = solver.shape().points;
    let reach = 0.5 * (points as f64 - 1.0);
    let gap: Vec<f64> = (0..points)
        .map(|i| {
            let x = (i as f64 - reach) * spacing.si();
            let [pinion, wheel] = [0, 1].map(|k: usize| heights[k][pass.starts[k] + i]);
            x * x / (2.0 * line.radius.si()) - pinion - wheel
        })
        .collect();
    let problem = ContactProblem {
        gap: &gap,
        spacing,
        modulus: case.modulus,
        boundary: Boundary::FreeEnds,
        control: Control::Load(line.load),
        lead: None,
        prescribed_pressure: None,
        pressure_limit: Some(limit),
        start: None,
    };
    let settings = SolverSettings {
        tolerance: TOLERANCE.max(case.model.tolerance),
        ..SolverSettings::default()
    };
    Ok(solver.solve(&problem, &settings)?)
}

/// Points of the window at a position.
fn window_points(case: &Case, position: &MeshPosition, spacing: Length) -> usize {
    2 * (case.model.window * (position.hertz.half_width / spacing)).ceil() as usize + 1
}

fn traces(surfaces: &Surfaces) -> Result<[&Profile; 2], PositionError> {
    match surfaces.textures() {
        [Texture::Trace(pinion), Texture::Trace(wheel)] => Ok([pinion, wheel]),
        _ => Err(PositionError::no_profile()),
    }
}

fn heights_of(surfaces: &Surfaces) -> Result<FlankHeights, PositionError> {
    let [pinion, wheel] = traces(surfaces)?.map(Profile::heights);
    let rq = |z: &[f64]| Ok::<_, PositionError>(section_heights(z)?.rq.si() * 1e6);
    let rpk = |z: &[f64]| Ok::<_, PositionError>(rk_parameters(z)?.rpk.si() * 1e6);
    Ok(FlankHeights {
        rq_um: [rq(pinion)?, rq(wheel)?],
        rpk_um: [rpk(pinion)?, rpk(wheel)?],
    })
}
