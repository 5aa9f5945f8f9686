//! Running-in of the two flanks of a case, for film and friction of run-in flanks.
//!
//! In a cycle every place of the pinion's trace passes under a contact `COVERAGE` times on the mean. Each pass
//! takes a mesh position and a place of either trace, and presses the windows together under the whole load, as
//! where a mesh starts, stops or creeps and no film carries; what flows stays off both flanks, shared by the
//! pressures they flow at. The places follow irrational steps, so that every pass has another pair of windows, as
//! hunting teeth have. Passes follow one another, so that threads change nothing.
//!
//! Whole loads without a film are the most that running-in takes off at this torque. With the film of operation in
//! between, where a quarter of the load of the e-drive case is on asperities, as many passes took off half of that.
//!
//! | symbol | meaning | unit |
//! |---|---|---|
//! | z₁, z₂ | prepared heights of pinion and wheel | m |
//! | w | plastic displacement of a pass | m |
//! | s₁, s₂ | its shares | - |
//!
//! Left out: wear, tribofilms, and that a pinion's tooth meets oftener than a wheel's.

use asperity_core::Profile;
use asperity_core::cite;
use asperity_core::quantity::Length;
use asperity_roughness::material_ratio::rk_parameters;
use asperity_roughness::section_heights::section_heights;

use super::displacements::flow_shares;
use super::rough_window::without_film;
use crate::case::Case;
use crate::error::PositionError;
use crate::flanks::{LEAST_POINTS_PER_HALF_WIDTH, Surfaces, Texture};
use crate::mesh::MeshPosition;
use crate::result::{FlankHeights, RunInCycle};

/// Times that a place of the pinion's trace passes under a contact in a cycle.
const COVERAGE: f64 = 4.0;
/// Most cycles.
pub(crate) const MAX_CYCLES: usize = 12;
/// Plastic work of a cycle, relative to the first cycle, below which the flanks have run in.
const SHAKEDOWN: f64 = 0.05;
/// Steps of mesh position, pinion and wheel from pass to pass as parts of the whole: powers of the inverse of the
/// real root of x⁴ = x + 1, which fill three dimensions evenly.
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
    let positions = places(case, measured, positions)?;
    let mut running = Running {
        case,
        passes: passes(measured, &positions)?,
        positions,
        shares: flow_shares(case)?,
        surfaces: measured.clone(),
        passed: 0,
    };
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
        true => Err(PositionError::NoProfile),
        false => Ok(places),
    }
}

/// Passes of a cycle at `places`.
fn passes(measured: &Surfaces, places: &[&MeshPosition]) -> Result<usize, PositionError> {
    let length = traces(measured)?[0].length().si();
    let widths: f64 = places.iter().map(|s| 2.0 * s.hertz.half_width.si()).sum();
    let passes = COVERAGE * length * places.len() as f64 / widths;
    Ok((passes.ceil() as usize).max(1))
}

/// State of a running-in.
struct Running<'a> {
    case: &'a Case,
    positions: Vec<&'a MeshPosition>,
    /// Shares of the plastic displacement.
    shares: [f64; 2],
    surfaces: Surfaces,
    /// Passes of a cycle.
    passes: usize,
    /// Passes made.
    passed: usize,
}

impl Running<'_> {
    /// One cycle: the flanks lose what flows in each pass.
    ///
    /// ```text
    /// zᵢ ← zᵢ − sᵢ w under the contact of each pass, until the work of a cycle is 5 % of the first's     [Run-in]
    /// ```
    fn cycle(&mut self, number: usize) -> Result<RunInCycle, PositionError> {
        cite!("Run-in");
        let profiles = traces(&self.surfaces)?;
        let spacing = profiles[0].spacing();
        let mut heights = profiles.map(|profile| profile.heights().to_vec());
        let mut work = 0.0;
        for _ in 0..self.passes {
            let [place, along, across] = STEPS.map(|step| (self.passed as f64 * step).fract());
            self.passed += 1;
            let position = self.positions[(place * self.positions.len() as f64) as usize];
            let points = window_points(self.case, position, spacing);
            let start = |k: usize, part: f64| {
                let free = heights[k].len() - points;
                (part * free as f64).round() as usize
            };
            let starts = [start(0, along), start(1, across)];
            let composite: Vec<f64> = (0..points)
                .map(|i| heights[0][starts[0] + i] + heights[1][starts[1] + i])
                .collect();
            let contact = without_film(self.case, position, &composite, spacing)?;
            work += contact.dissipated.si();
            let flow = &contact.solution.plastic_displacement;
            for (k, height) in heights.iter_mut().enumerate() {
                let under = &mut height[starts[k]..starts[k] + points];
                for (z, w) in under.iter_mut().zip(flow) {
                    *z -= self.shares[k] * w;
                }
            }
        }
        let [first, second] = heights;
        self.surfaces = self.surfaces.with_traces([
            Profile::new(spacing, first)?,
            Profile::new(spacing, second)?,
        ]);
        let passes = self.passes as f64;
        Ok(RunInCycle {
            cycle: number,
            passes: self.passes,
            plastic_work_j_per_m: work / passes,
            rq_um: heights_of(&self.surfaces)?.rq_um,
        })
    }
}

/// Points of the window at a position.
fn window_points(case: &Case, position: &MeshPosition, spacing: Length) -> usize {
    2 * (case.model.window * (position.hertz.half_width / spacing)).ceil() as usize + 1
}

fn traces(surfaces: &Surfaces) -> Result<[&Profile; 2], PositionError> {
    match surfaces.textures() {
        [Texture::Trace(pinion), Texture::Trace(wheel)] => Ok([pinion, wheel]),
        _ => Err(PositionError::NoProfile),
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
