//! A history of running-in: the plastic stage, then wear in packages, with film and loss on the flanks of each.

use asperity_core::quantity::Pressure;

use super::stages::{OnFlanks, on_flanks};
use crate::contacts::running_in::{
    Flow, Track, WearRates, heights, plastic, rates, removed, surfaces, tracks,
};
use crate::mesh::Mesh;
use crate::result::{FlankHeights, RunInStep};
use asperity_case::case::{OperatingCase, RunningInPlan};
use asperity_case::error::Error;
use asperity_case::flanks::Surfaces;

/// Most packages of wear.
const MAX_PACKAGES: usize = 40;
/// Change of Rq at which a package ends.
const PACKAGE: f64 = 0.02;
/// First package over the whole wear, where Rq changes less; each further one doubles what is worn.
const FIRST: f64 = 2e-3;

/// Settings of a history of running-in.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct HistorySettings {
    /// Torque while the flanks run in, and engagements at which the plastic stage ends if it does not settle before.
    pub plan: RunningInPlan,
    /// Pressure at which asperities flow, one of [`limits`](crate::contacts::running_in::limits).
    pub limit: Pressure,
    /// Wear coefficient times engagements at which the history ends \[1/Pa\]; 0 ends it with the plastic stage.
    pub worn: f64,
    /// Rq of pinion or wheel, 0 or 1, over that of the flank as measured, at which the history ends before.
    pub least: Option<(usize, f64)>,
}

/// Flanks at a point of their history.
#[derive(Debug, Clone)]
#[non_exhaustive]
pub struct HistoryState {
    /// Engagements of a tooth of the pinion in the plastic stage.
    pub engagements: f64,
    /// Wear coefficient times engagements of the pinion in the wear stage \[1/Pa\].
    pub worn: f64,
    /// The flanks.
    pub surfaces: Surfaces,
    /// Their roughness.
    pub heights: FlankHeights,
    /// Height removed from pinion and wheel, mean over the traces \[m\].
    pub removed: [f64; 2],
    /// Loss at the torque of the case with every constant at its median \[W\].
    pub loss_w: f64,
    /// Share of the load on asperities at the torque of the case, mean over mesh time.
    pub asperity_share: f64,
    /// Minimum film over composite Rq at the torque of the case, mean over the path.
    pub film_ratio: f64,
}

/// A history of running-in.
#[derive(Debug, Clone)]
#[non_exhaustive]
pub struct History {
    /// Flanks as measured, at doublings of the plastic stage, and after each package of wear.
    pub states: Vec<HistoryState>,
    /// Each doubling of the engagements in the plastic stage.
    pub steps: Vec<RunInStep>,
    /// Whether the plastic stage settled.
    pub is_settled: bool,
}

/// Case and meshes of a history.
struct Course<'a> {
    case: &'a OperatingCase,
    /// Mesh at the torque of the case.
    mesh: &'a Mesh,
    /// Mesh at the torque of the running-in, if it is another.
    running: Option<&'a Mesh>,
}

/// The history of the flanks of a case at its bulk temperature; `each` is called after each state.
///
/// # Errors
/// When a flank has no trace, or a contact or a film no solution.
pub fn history(
    case: &OperatingCase,
    settings: &HistorySettings,
    each: &dyn Fn(&HistoryState),
) -> Result<History, Error> {
    let mesh = Mesh::of(case).map_err(Box::new)?;
    let RunningInPlan {
        torque,
        engagements,
    } = settings.plan;
    let running = (torque != case.torque).then(|| Mesh::at_torque(case, torque));
    let running = running.transpose().map_err(Box::new)?;
    let course = Course {
        case,
        mesh: &mesh,
        running: running.as_ref(),
    };
    let positions = &running.as_ref().unwrap_or(&mesh).positions;
    let found = tracks(case, &case.surfaces, positions).map_err(Box::new)?;
    let (fresh, _) = course.state(&found, (0.0, 0.0))?;
    each(&fresh);
    let measured = fresh.heights.rq_um;
    let mut states = vec![fresh];
    let mut flow = Flow::new(case, found, settings.limit).map_err(Box::new)?;
    let (steps, is_settled) = plastic(&mut flow, engagements, |steps, tracks| {
        // Every third doubling: the loss falls little in one.
        if settings.worn > 0.0 && steps.len() % 3 == 1 {
            let at = steps.last().map_or(0.0, |step| step.engagements);
            let (state, _) = course.state(tracks, (at, 0.0))?;
            each(&state);
            states.push(state);
        }
        Ok::<_, Error>(())
    })?;
    let engagements = steps.last().map_or(0.0, |step| step.engagements);
    states.retain(|state| state.engagements != engagements);
    let mut tracks = flow.into_tracks();
    let mut made = vec![0; tracks.len()];
    let mut worn = 0.0;
    for _ in 0..=MAX_PACKAGES {
        let (state, film) = course.state(&tracks, (engagements, worn))?;
        each(&state);
        let rq = state.heights.rq_um;
        states.push(state);
        let is_reached = |(body, ratio): (usize, f64)| rq[body] <= ratio * measured[body];
        let is_still = film.shares.iter().all(|share| *share == 0.0);
        if worn >= settings.worn || is_still || settings.least.is_some_and(is_reached) {
            break;
        }
        let wish = worn.max(FIRST * settings.worn).min(settings.worn - worn);
        let mut all = Vec::with_capacity(tracks.len());
        for (track, made) in tracks.iter().zip(&mut made) {
            let shares = track.positions.iter().map(|at| film.shares[at.number - 1]);
            let shares: Vec<f64> = shares.collect();
            let (rates, count) =
                rates((case, settings.limit), track, &shares, *made).map_err(Box::new)?;
            *made += count;
            all.push(rates);
        }
        worn += package(&mut tracks, &all, (wish, rq)).map_err(Box::new)?;
    }
    Ok(History {
        states,
        steps,
        is_settled,
    })
}

/// Wears a package of `wish`, or less where Rq changes by more than 2 %; returns what was worn.
fn package(
    tracks: &mut [Track<'_>],
    all: &[WearRates],
    (wish, before): (f64, [f64; 2]),
) -> Result<f64, asperity_case::error::PositionError> {
    let mut wear = |factor: f64| -> Result<f64, asperity_case::error::PositionError> {
        for (track, rates) in tracks.iter_mut().zip(all) {
            for (body, fields) in rates.iter().enumerate() {
                track.lower_all(body, fields, factor);
            }
        }
        let after = heights(tracks)?.rq_um;
        let changes = before.iter().zip(after).map(|(a, b)| (b / a - 1.0).abs());
        Ok(changes.fold(0.0, f64::max))
    };
    let change = wear(wish)?;
    if change <= PACKAGE {
        return Ok(wish);
    }
    let less = wish * PACKAGE / change;
    wear(less - wish)?;
    Ok(less)
}

impl Course<'_> {
    /// The flanks of the tracks with film and loss; the film while they run in.
    fn state(
        &self,
        tracks: &[Track<'_>],
        (engagements, worn): (f64, f64),
    ) -> Result<(HistoryState, OnFlanks), Error> {
        let surfaces = surfaces(&self.case.surfaces, tracks).map_err(Box::new)?;
        let of_case = on_flanks(self.case, &surfaces, self.mesh)?;
        let state = HistoryState {
            engagements,
            worn,
            heights: heights(tracks).map_err(Box::new)?,
            removed: [0, 1].map(|body| removed(tracks, body)),
            loss_w: of_case.summary.loss_w,
            asperity_share: of_case.summary.asperity_share,
            film_ratio: of_case.film_ratio,
            surfaces,
        };
        let film = match self.running {
            Some(mesh) => on_flanks(self.case, &state.surfaces, mesh)?,
            None => of_case,
        };
        Ok((state, film))
    }
}
