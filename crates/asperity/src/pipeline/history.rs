//! A history of running-in: the plastic stage, then wear in packages, with film and loss on the flanks of each.

use asperity_core::quantity::Pressure;

use super::stages::on_flanks;
use crate::contacts::running_in::{
    RunInFlow, Track, WearRates, heights, plastic, rates, removed, surfaces, tracks,
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
/// Least change of Rq in the first package, unless it is the whole wear: the film on flanks that have changed less is the same.
const LITTLE: f64 = 2e-4;
/// First package over the whole wear, if Rq changes by more than that; each further one doubles what is worn.
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
    /// Flanks as measured, at every third doubling of the plastic stage, at its end, and after each package of wear; without wear at
    /// the end only.
    pub states: Vec<HistoryState>,
    /// Each doubling of the engagements in the plastic stage.
    pub steps: Vec<RunInStep>,
    /// Whether the plastic stage settled.
    pub is_settled: bool,
}

/// Case and meshes of a history.
struct HistoryCourse<'a> {
    each: &'a dyn Fn(&HistoryState),
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
    let mesh = Mesh::new(case).map_err(Box::new)?;
    let RunningInPlan {
        torque,
        engagements,
    } = settings.plan;
    let running = (torque != case.torque).then(|| Mesh::at_torque(case, torque));
    let running = running.transpose().map_err(Box::new)?;
    let course = HistoryCourse {
        each,
        case,
        mesh: &mesh,
        running: running.as_ref(),
    };
    let positions = &running.as_ref().unwrap_or(&mesh).positions;
    let found = tracks(case, &case.surfaces, positions).map_err(Box::new)?;
    let measured = heights(&found).map_err(Box::new)?.rq_um;
    let mut states = Vec::new();
    let is_worn = settings.worn > 0.0;
    if is_worn {
        states.push(course.state(&found, [0.0; 2])?);
    }
    let mut flow = RunInFlow::new(case, found, settings.limit).map_err(Box::new)?;
    let (steps, is_settled) = plastic(&mut flow, engagements, |steps, tracks| {
        // Every third doubling: the loss falls little in one.
        if is_worn && steps.len() % 3 == 1 {
            let at = steps.last().map_or(0.0, |step| step.engagements);
            states.push(course.state(tracks, [at, 0.0])?);
        }
        Ok::<_, Error>(())
    })?;
    let engagements = steps.last().map_or(0.0, |step| step.engagements);
    let mut tracks = flow.into_tracks();
    let mut made = vec![0; tracks.len()];
    let mut worn = 0.0;
    for _ in 0..=MAX_PACKAGES {
        let at = [engagements, worn];
        if states
            .last()
            .is_none_or(|(last, _)| [last.engagements, last.worn] != at)
        {
            states.push(course.state(&tracks, at)?);
        }
        let Some((state, shares)) = states.last() else {
            break;
        };
        let rq = state.heights.rq_um;
        let is_reached = |(body, ratio): (usize, f64)| rq[body] <= ratio * measured[body];
        if worn >= settings.worn || settings.least.is_some_and(is_reached) {
            break;
        }
        let of_running = course
            .running
            .map(|mesh| on_flanks(case, &state.surfaces, mesh));
        let of_running = of_running.transpose()?.map(|film| film.shares);
        let shares = of_running.as_ref().unwrap_or(shares);
        if shares.iter().all(|share| *share == 0.0) {
            break;
        }
        let wish = worn.max(FIRST * settings.worn).min(settings.worn - worn);
        let most = if worn == 0.0 { settings.worn } else { wish };
        let mut all = Vec::with_capacity(tracks.len());
        for (track, made) in tracks.iter().zip(&mut made) {
            let of_track = track.positions.iter().map(|at| shares[at.number - 1]);
            let shares: Vec<f64> = of_track.collect();
            let (rates, count) =
                rates(case, settings.limit, track, &shares, *made).map_err(Box::new)?;
            *made += count;
            all.push(rates);
        }
        worn += package(&mut tracks, &all, wish, most, rq).map_err(Box::new)?;
    }
    Ok(History {
        states: states.into_iter().map(|(state, _)| state).collect(),
        steps,
        is_settled,
    })
}

/// Wears a package of `wish`, less where Rq changes by more than 2 %, more, up to `most`, where it hardly changes; returns what was
/// worn.
fn package(
    tracks: &mut [Track<'_>],
    all: &[WearRates],
    wish: f64,
    most: f64,
    before: [f64; 2],
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
    let other = if change > PACKAGE {
        wish * PACKAGE / change
    } else {
        (wish * LITTLE / change).clamp(wish, most)
    };
    if other != wish {
        wear(other - wish)?;
    }
    Ok(other)
}

impl HistoryCourse<'_> {
    /// The flanks of the tracks with film and loss, and the asperity share at each mesh position, at the torque of the case.
    fn state(
        &self,
        tracks: &[Track<'_>],
        [engagements, worn]: [f64; 2],
    ) -> Result<(HistoryState, Vec<f64>), Error> {
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
        (self.each)(&state);
        Ok((state, of_case.shares))
    }
}
