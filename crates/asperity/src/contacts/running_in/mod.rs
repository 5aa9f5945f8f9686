//! Running-in of the two flanks of a case, counted in engagements: plastic flow, then mild wear.
//!
//! Contacts press windows of both flanks together at places and mesh positions that fill traces and path evenly. In the plastic
//! stage they carry the whole load, as where a mesh starts, stops or creeps and no film carries. Pressures are limited to the
//! shakedown limit of repeated sliding contact, not to the indentation hardness: asperities that slide past each other a million
//! times flow until they stay elastic. What flows stays off both flanks, shared by the pressures they flow at. Contacts without a
//! common point are solved at once, so that threads change nothing.
//!
//! In the wear stage the asperities carry their share of the load under the film of the case, and the flanks wear by it.
//!
//! | symbol | meaning | unit |
//! |---|---|---|
//! | H | indentation hardness of the softer flank | Pa |
//! | k | its yield stress in shear, H/(3√3) | Pa |
//! | p_s | shakedown limit of the softer flank with boundary friction | Pa |
//!
//! Left out: growth of a surface film, and what changes between flanks at rest.

mod flow;
mod track;
mod wear;

use asperity_contact::plasticity::FLOW_OVER_YIELD;
use asperity_contact::shakedown::shakedown_pressure;
use asperity_core::numerics::mean;
use asperity_core::quantity::Pressure;
use asperity_core::{Profile, cite};
use asperity_roughness::material_ratio::rk_parameters;
use asperity_roughness::section_heights::section_heights;

use crate::contacts::pressed::softer;
use crate::mesh::{Mesh, MeshPosition};
use crate::result::{FlankHeights, RunInStep};
use asperity_case::case::{Case, RunningInPlan};
use asperity_case::error::PositionError;
use asperity_case::flanks::Surfaces;

pub(crate) use flow::RunInFlow;
pub(crate) use track::Track;
pub(crate) use wear::{WearRates, rates};

/// Most doublings of the engagements.
pub(crate) const MAX_STEPS: usize = 13;
/// Change of the Rq of both flanks together by a doubling of the engagements below which the flanks have run in plastically.
const SETTLED: f64 = 0.005;
/// Engagements before which a doubling does not end the plastic stage: fewer sample too little of the flanks.
const LEAST: f64 = 8.0;
/// Pressure of first yield of bearing steel over its hardness: 4.3 of 7 GPa (Morales-Espejel and Brizmer 2011).
const FIRST_YIELD: f64 = 4.3 / 7.0;

/// Flanks that have run in plastically.
#[derive(Debug, Clone)]
pub struct RanIn {
    /// The flanks.
    pub surfaces: Surfaces,
    /// Each doubling of the engagements.
    pub steps: Vec<RunInStep>,
    /// Roughness as measured and run in.
    pub heights: [FlankHeights; 2],
    /// Whether the last doubling changed the Rq of both flanks together by less than 0.5 %.
    pub is_settled: bool,
}

/// Pressures at which asperities flow: the shakedown limit, and the ends of its range.
///
/// ```text
/// 0.614 H,  p_s,  4 k                                                         [Yield-range]
/// ```
///
/// The lower end is the pressure of first yield of bearing steel, 4.3 GPa, over its hardness; the upper end is the limit without friction.
///
/// # Errors
/// When a hardness or the boundary friction is outside its domain.
pub fn limits(case: &Case) -> Result<[Pressure; 3], PositionError> {
    cite!("Yield-range");
    let hardness = softer(case)?;
    let middle = shakedown_pressure(hardness, case.model.boundary_friction)?;
    let highest = hardness * (4.0 / (FLOW_OVER_YIELD * 3.0_f64.sqrt()));
    Ok([hardness * FIRST_YIELD, middle, highest])
}

/// Runs the flanks of a case in plastically, at the torque of `plan`, until a doubling of the engagements changes the Rq of both
/// flanks together by less than 0.5 %, or to its engagements; `done` is called after each doubling with its number.
///
/// # Errors
/// When a flank has no trace or a contact no solution.
pub fn run_in(
    case: &Case,
    measured: &Surfaces,
    plan: &RunningInPlan,
    done: &dyn Fn(usize),
) -> Result<RanIn, PositionError> {
    let [_, limit, _] = limits(case)?;
    let positions = Mesh::at_torque(case, plan.torque)?.positions;
    let tracks = tracks(case, measured, &positions)?;
    let mut flow = RunInFlow::new(case, tracks, limit)?;
    let (steps, is_settled) = plastic(&mut flow, plan.engagements, |steps, _| {
        done(steps.len());
        Ok::<_, Box<PositionError>>(())
    })
    .map_err(|error| *error)?;
    let surfaces = surfaces(measured, flow.tracks())?;
    let heights = [heights_of(measured)?, heights(flow.tracks())?];
    Ok(RanIn {
        surfaces,
        steps,
        heights,
        is_settled,
    })
}

/// The plastic stage, with `each` called after each doubling; whether it settled.
pub(crate) fn plastic<E: From<Box<PositionError>>>(
    flow: &mut RunInFlow<'_>,
    engagements: Option<f64>,
    mut each: impl FnMut(&[RunInStep], &[Track<'_>]) -> Result<(), E>,
) -> Result<(Vec<RunInStep>, bool), E> {
    let mut steps: Vec<RunInStep> = Vec::new();
    let mut next: f64 = 1.0;
    loop {
        let until = engagements.map_or(next, |stated| next.min(stated));
        let plastic_work_j_per_m = flow.advance(until).map_err(Box::new)?;
        let step = RunInStep {
            engagements: until,
            plastic_work_j_per_m,
            removed_nm: [0, 1].map(|body| 1e9 * removed(flow.tracks(), body)),
            heights: heights(flow.tracks()).map_err(Box::new)?,
        };
        let both = |of: &RunInStep| of.heights.rq_um[0].hypot(of.heights.rq_um[1]);
        let is_settled = steps.last().is_some_and(|last| {
            let change = both(&step) / both(last) - 1.0;
            until >= LEAST && until == 2.0 * last.engagements && change.abs() < SETTLED
        });
        let is_still = plastic_work_j_per_m == 0.0 && until >= LEAST;
        steps.push(step);
        each(&steps, flow.tracks())?;
        if is_settled || is_still {
            return Ok((steps, true));
        }
        if engagements == Some(until) || steps.len() == MAX_STEPS {
            return Ok((steps, false));
        }
        next *= 2.0;
    }
}

/// Whether the flanks of a case can run in.
///
/// # Errors
/// When a flank has no trace, or the traces resolve and hold no contact.
pub(crate) fn check(
    case: &Case,
    measured: &Surfaces,
    plan: &RunningInPlan,
) -> Result<(), PositionError> {
    let positions = Mesh::at_torque(case, plan.torque)?.positions;
    tracks(case, measured, &positions).map(|_| ())
}

/// The tracks of all zones of the face.
pub(crate) fn tracks<'a>(
    case: &Case,
    measured: &Surfaces,
    positions: &'a [MeshPosition],
) -> Result<Vec<Track<'a>>, PositionError> {
    let zones = 0..measured.zones();
    let found = zones.map(|zone| Track::new(case, measured, zone, positions));
    let found = found.collect::<Result<Vec<_>, _>>()?;
    // A zone without contacts keeps its traces.
    if found.iter().all(Option::is_some) {
        Ok(found.into_iter().flatten().collect())
    } else {
        Err(PositionError::no_profile())
    }
}

/// The flanks with the traces of the tracks.
pub(crate) fn surfaces(
    measured: &Surfaces,
    tracks: &[Track<'_>],
) -> Result<Surfaces, PositionError> {
    measured.with_traces_of_teeth(|teeth: [usize; 2], zone| {
        let profile = |body: usize| {
            let heights = tracks[zone].heights_of(body, teeth[body]);
            Profile::new(tracks[zone].spacing, heights)
        };
        Ok([profile(0)?, profile(1)?])
    })
}

/// Height removed from a flank, mean over all zones and teeth \[m\].
pub(crate) fn removed(tracks: &[Track<'_>], body: usize) -> f64 {
    mean(tracks.iter().map(|track| track.removed(body)))
}

/// Roughness of the tracks, mean over all zones and teeth.
pub(crate) fn heights(tracks: &[Track<'_>]) -> Result<FlankHeights, PositionError> {
    of_traces([0, 1].map(|body| {
        let traces = tracks.iter().flat_map(move |track| track.heights(body));
        traces.collect::<Vec<_>>()
    }))
}

/// Roughness of flanks, mean over all pairs in all zones.
fn heights_of(surfaces: &Surfaces) -> Result<FlankHeights, PositionError> {
    let each = surfaces.each().map(Surfaces::traces);
    let each = each.collect::<Result<Vec<_>, _>>()?;
    of_traces([0, 1].map(|body: usize| {
        each.iter()
            .map(|both| both[body].heights().to_vec())
            .collect()
    }))
}

fn of_traces(traces: [Vec<Vec<f64>>; 2]) -> Result<FlankHeights, PositionError> {
    let of = |traces: &[Vec<f64>]| -> Result<[f64; 2], PositionError> {
        let each = traces.iter().map(|z| {
            let rq = section_heights(z)?.rq.si();
            Ok::<_, PositionError>([1e6 * rq, 1e6 * rk_parameters(z)?.rpk.si()])
        });
        let each = each.collect::<Result<Vec<_>, _>>()?;
        Ok([0, 1].map(|k: usize| mean(each.iter().map(|both| both[k]))))
    };
    let [pinion, wheel] = [of(&traces[0])?, of(&traces[1])?];
    Ok(FlankHeights {
        rq_um: [pinion[0], wheel[0]],
        rpk_um: [pinion[1], wheel[1]],
    })
}
