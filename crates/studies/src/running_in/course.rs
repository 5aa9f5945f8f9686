//! The course of running-in at one torque: all quantities over engagements, with their intervals.

use asperity::pipeline::{History, HistoryState};
use asperity_core::numerics::interpolate;
use asperity_core::{Estimate, EstimateKeys, estimate_keys};
use serde::Serialize;

use super::clock::Clock;

/// Quantities of a row.
const COUNT: usize = 9;

estimate_keys! {
    PinionRqKeys: "pinion_rq_um" "pinion_rq_quantiles_um";
    WheelRqKeys: "wheel_rq_um" "wheel_rq_quantiles_um";
    PinionRpkKeys: "pinion_rpk_um" "pinion_rpk_quantiles_um";
    WheelRpkKeys: "wheel_rpk_um" "wheel_rpk_quantiles_um";
    PinionRemovedKeys: "pinion_removed_nm" "pinion_removed_quantiles_nm";
    WheelRemovedKeys: "wheel_removed_nm" "wheel_removed_quantiles_nm";
    ShareKeys: "asperity_share" "asperity_share_quantiles";
    RatioKeys: "film_ratio" "film_ratio_quantiles";
    LossKeys: "loss_w" "loss_quantiles_w";
    pub(super) FactorKeys: "factor" "factor_quantiles";
}

/// Flanks after a number of engagements.
#[derive(Debug, Clone, Copy, PartialEq, Serialize)]
#[non_exhaustive]
pub struct CourseRow {
    /// Engagements of a tooth of the pinion.
    pub engagements: f64,
    /// Hours at the speed of the case.
    pub hours: f64,
    /// Rq of the pinion.
    #[serde(flatten, with = "PinionRqKeys")]
    pub pinion_rq_um: Estimate,
    /// Rq of the wheel.
    #[serde(flatten, with = "WheelRqKeys")]
    pub wheel_rq_um: Estimate,
    /// Rpk of the pinion.
    #[serde(flatten, with = "PinionRpkKeys")]
    pub pinion_rpk_um: Estimate,
    /// Rpk of the wheel.
    #[serde(flatten, with = "WheelRpkKeys")]
    pub wheel_rpk_um: Estimate,
    /// Height removed from the pinion, mean over its traces.
    #[serde(flatten, with = "PinionRemovedKeys")]
    pub pinion_removed_nm: Estimate,
    /// Height removed from the wheel.
    #[serde(flatten, with = "WheelRemovedKeys")]
    pub wheel_removed_nm: Estimate,
    /// Share of the load on asperities.
    #[serde(flatten, with = "ShareKeys")]
    pub asperity_share: Estimate,
    /// Minimum film over composite Rq, mean over the path.
    #[serde(flatten, with = "RatioKeys")]
    pub film_ratio: Estimate,
    /// Loss of the mesh: the loss of the fresh flanks, a median where it is drawn, times the ratio of the runs at the medians of the constants.
    #[serde(flatten, with = "LossKeys")]
    pub loss_w: Estimate,
}

/// Running-in at one torque.
#[derive(Debug, Clone, PartialEq, Serialize)]
#[non_exhaustive]
pub struct Course {
    /// Torque at the pinion while the flanks run in \[N m\].
    pub torque_nm: f64,
    /// Engagements at which the plastic stage ended.
    pub plastic_engagements: f64,
    /// Whether a doubling of the engagements changed the Rq of both flanks together by less than 0.5 % there.
    pub is_settled: bool,
    /// Engagements of a tooth of the pinion after which 90 % of the change of Rq, of both flanks together, are done; `None` where nothing
    /// changed.
    pub done_engagements: Option<f64>,
    /// The same in hours at the speed of the case.
    pub done_hours: Option<f64>,
    /// Loss run in over loss fresh.
    #[serde(flatten, with = "FactorKeys")]
    pub factor: Estimate,
    /// Mass removed from pinion and wheel \[mg\].
    pub removed_mg: [f64; 2],
    /// Engagements from which the wear of the model does not reach the history or the upper end of its interval; `None` if it reaches both.
    pub ends_at: Option<f64>,
    /// Flanks over engagements.
    pub rows: Vec<CourseRow>,
}

/// All quantities of a state.
type Values = [f64; COUNT];

/// The histories of one torque at the pressures at which asperities flow, from which rows follow.
pub(super) struct Histories<'a> {
    /// At the shakedown limit.
    pub middle: &'a History,
    /// The same number of engagements of the plastic stage at both ends of the range of the limit.
    pub ends: [&'a History; 2],
    /// Loss of the fresh flanks \[W\] over the loss of the run at the medians.
    pub to_median: f64,
    /// Revolutions of the pinion in an hour.
    pub per_hour: f64,
}

fn values(state: &HistoryState) -> Values {
    let ([rq1, rq2], [rpk1, rpk2]) = (state.heights.rq_um, state.heights.rpk_um);
    let [lost1, lost2] = state.removed.map(|height| 1e9 * height);
    let (share, ratio, loss) = (state.asperity_share, state.film_ratio, state.loss_w);
    [rq1, rq2, rpk1, rpk2, lost1, lost2, share, ratio, loss]
}

/// Values between states over an abscissa.
fn between(points: &[(f64, Values)], at: f64) -> Values {
    std::array::from_fn(|k| {
        let curve: Vec<(f64, f64)> = points.iter().map(|(x, of)| (*x, of[k])).collect();
        interpolate(&curve, at)
    })
}

impl Histories<'_> {
    /// Engagements at the end of the plastic stage.
    pub fn plastic(&self) -> f64 {
        let last = self.middle.steps.last();
        last.map_or(0.0, |step| step.engagements)
    }

    /// States of the wear stage over the wear.
    pub fn worn(&self) -> impl Iterator<Item = &HistoryState> {
        let plastic = self.plastic();
        let states = self.middle.states.iter();
        states.filter(move |state| state.engagements == plastic)
    }

    /// States of the plastic stage over ln(1 + N).
    fn flowed(&self) -> Vec<(f64, Values)> {
        let states = self.middle.states.iter().filter(|state| state.worn == 0.0);
        let mut points: Vec<(f64, Values)> = states
            .map(|state| (state.engagements.ln_1p(), values(state)))
            .collect();
        // Roughness and height removed are known at each doubling.
        let at_states = points.clone();
        for step in &self.middle.steps {
            let x = step.engagements.ln_1p();
            let ([rq1, rq2], [rpk1, rpk2]) = (step.heights.rq_um, step.heights.rpk_um);
            let known = [rq1, rq2, rpk1, rpk2, step.removed_nm[0], step.removed_nm[1]];
            let mut of = between(&at_states, x);
            of[..known.len()].copy_from_slice(&known);
            match points.iter().position(|(at, _)| *at >= x) {
                Some(k) if points[k].0 == x => points[k].1 = of,
                Some(k) => points.insert(k, (x, of)),
                None => points.push((x, of)),
            }
        }
        points
    }

    /// The row after a number of engagements.
    pub fn row(&self, engagements: f64, clock: &Clock) -> CourseRow {
        let flowed = self.flowed();
        let plastic = self.plastic();
        let fresh = flowed[0].1;
        let at = between(&flowed, engagements.min(plastic).ln_1p());
        let end = between(&flowed, plastic.ln_1p());
        let worn: Vec<(f64, Values)> = self.worn().map(|of| (of.worn, values(of))).collect();
        let wear = clock.worn(engagements);
        let changed = |wear: f64| -> Values {
            let of = between(&worn, wear);
            std::array::from_fn(|k| at[k] + of[k] - end[k])
        };
        let [middle, low, high] = [wear.value, wear.low, wear.high].map(changed);
        // What another limit changes grows with the part of the flow that is done, by the Rq of both flanks.
        let both = |of: &Values| of[0].hypot(of[1]);
        let done = |of: &Values| both(&fresh) - both(of);
        let of_limits = self.ends.map(|ends| {
            let until = ends
                .steps
                .last()
                .map_or(plastic, |step| step.engagements)
                .ln_1p();
            let own = between(&flowed, until);
            let part = match done(&own) {
                whole if whole > 0.0 => (done(&at) / whole).max(0.0),
                _ => (engagements.ln_1p() / until).min(1.0),
            };
            let other = ends.states.last().map_or(own, values);
            (0..COUNT)
                .map(|k| part * (other[k] - own[k]))
                .collect::<Vec<f64>>()
        });
        let estimate = |k: usize| {
            let by_wear = [low[k], high[k]].map(|v| v - middle[k]);
            let by_limit = of_limits.each_ref().map(|of| of[k]);
            let least = |of: [f64; 2]| of[0].min(of[1]).min(0.0);
            let most = |of: [f64; 2]| of[0].max(of[1]).max(0.0);
            let below = least(by_wear).hypot(least(by_limit));
            let above = most(by_wear).hypot(most(by_limit));
            Estimate::new(middle[k], [middle[k] - below, middle[k] + above])
        };
        // Between the traces of a test Rq of their flank is known without the wear of the model.
        let rq = |body: usize| match clock {
            Clock::Test(of) if of.flank == body && engagements > plastic => {
                of.ratio(engagements).map(|ratio| ratio * fresh[body])
            }
            _ => estimate(body),
        };
        CourseRow {
            engagements,
            hours: engagements / self.per_hour,
            pinion_rq_um: rq(0),
            wheel_rq_um: rq(1),
            pinion_rpk_um: estimate(2),
            wheel_rpk_um: estimate(3),
            pinion_removed_nm: estimate(4),
            wheel_removed_nm: estimate(5),
            asperity_share: estimate(6),
            film_ratio: estimate(7),
            loss_w: estimate(8).map(|loss| self.to_median * loss),
        }
    }
}

/// Engagements after which 90 % of the change of Rq of both flanks together are done.
pub(super) fn done(rows: &[CourseRow]) -> Option<f64> {
    /// Part of the change.
    const DONE: f64 = 0.9;
    /// Part of Rq below which nothing changed.
    const NOTHING: f64 = 1e-4;
    let both = |row: &CourseRow| row.pinion_rq_um.value.hypot(row.wheel_rq_um.value);
    let (first, last) = (rows.first()?, rows.last()?);
    let change = both(first) - both(last);
    if change < NOTHING * both(first) {
        return None;
    }
    let wanted = both(first) - DONE * change;
    let pair = rows.windows(2).find(|pair| both(&pair[1]) <= wanted)?;
    let [x0, x1] = [0, 1].map(|k: usize| pair[k].engagements.ln_1p());
    let [y0, y1] = [both(&pair[0]), both(&pair[1])];
    let part = match y0 - y1 {
        fall if fall > 0.0 => (y0 - wanted) / fall,
        _ => 0.0,
    };
    Some((x0 + part * (x1 - x0)).exp_m1())
}
