//! Running-in: flanks that meet again and again flow less every time, until they are elastic.
//!
//! In a cycle the second flank passes the first at a number of relative shifts. At each the flanks
//! are pressed together, and each loses its share of the plastic displacement. The energy of a
//! cycle decays geometrically once the first few cycles have flattened the highest points:
//! shakedown. The profiles are taken as periodic when they are shifted.
//!
//! | symbol | meaning | unit |
//! |---|---|---|
//! | D | energy dissipated in a cycle per metre of face width | J/m |
//! | w | plastic displacement | m |
//! | Rq | root mean square deviation of a profile from its mean | m |

use asperity_core::quantity::{Length, LineEnergy};
use asperity_core::{DomainError, Profile};
use serde::Serialize;

use crate::boundary::Boundary;
use crate::error::ContactError;
use crate::path::Path;
use crate::plasticity::displaced_profile;
use crate::problem::{ContactProblem, ContactSolution, SolverSettings};
use crate::two_flanks::TwoFlanks;

/// Plan of a running-in: passes, shares of the flow, and when it is over.
#[derive(Debug, Clone, PartialEq)]
pub struct RunningIn {
    /// Shifts of the second flank in points, one pass each in every cycle.
    pub shifts: Vec<usize>,
    /// Shares of the plastic displacement
    /// ([`plastic_shares`](crate::plasticity::plastic_shares)).
    pub shares: [f64; 2],
    /// Energy of a cycle over that of the first below which the flanks have run in.
    pub shakedown: f64,
    /// Most cycles.
    pub max_cycles: usize,
}

/// Record of one cycle.
#[derive(Debug, Clone, PartialEq, Serialize)]
#[non_exhaustive]
pub struct Cycle {
    /// Energy dissipated, all passes together.
    pub dissipated: LineEnergy,
    /// Largest plastic displacement of a pass.
    pub largest_flow: Length,
    /// Number of points that flowed, all passes together.
    pub flowing_points: usize,
    /// Mean share of the points in contact.
    pub contact_fraction: f64,
    /// Rq of the flanks after the cycle.
    pub rq: [Length; 2],
    /// Height of the highest point of the flanks over their mean after the cycle.
    pub peak: [Length; 2],
}

/// Flanks that have run in.
#[derive(Debug, Clone, PartialEq)]
#[non_exhaustive]
pub struct RanIn {
    /// Every cycle, the first first.
    pub cycles: Vec<Cycle>,
    /// The flanks after the last cycle.
    pub flanks: [Profile; 2],
}

impl RunningIn {
    /// `passes` shifts spread evenly over a profile of `points` points, displacement shared evenly, until a cycle
    /// dissipates a millionth of the first.
    ///
    /// # Errors
    /// When there is no pass, or there are more passes than points.
    pub fn evenly(points: usize, passes: usize) -> Result<Self, DomainError> {
        let rule = "must be at least 1 and at most the number of points";
        let is_possible = (1..=points).contains(&passes);
        DomainError::require(is_possible, "number of passes", passes as f64, "-", rule)?;
        let shift = |k| (k as f64 * points as f64 / passes as f64).round() as usize;
        Ok(Self {
            shifts: (0..passes).map(shift).collect(),
            shares: [0.5, 0.5],
            shakedown: 1e-6,
            max_cycles: 100,
        })
    }

    /// Runs the flanks in, under their load and with their pressure limit.
    ///
    /// # Errors
    /// When there is no shift or no pressure limit, the shares are negative or do not sum to one,
    /// the flanks do not match or a contact is not solved, or the last cycle still dissipates too much.
    ///
    /// ```
    /// use asperity_contact::{SolverSettings, running_in::RunningIn, two_flanks::TwoFlanks};
    /// use asperity_core::Profile;
    /// let wavy: Vec<f64> = (0..400).map(|i| 3e-7 * (0.21 * f64::from(i)).sin()).collect();
    /// let (rough, smooth) = (Profile::new("1 um".parse()?, wavy)?, Profile::new("1 um".parse()?, vec![0.0; 400])?);
    /// let flanks = TwoFlanks {
    ///     first: &rough, second: &smooth, radius: "3 mm".parse()?, load: "100 N/mm".parse()?,
    ///     modulus: "115.4 GPa".parse()?, pressure_limit: Some("2 GPa".parse()?),
    /// };
    /// let ran_in = RunningIn::evenly(400, 4)?.run(&flanks, &SolverSettings::default())?;
    /// assert!(ran_in.cycles[1].dissipated < ran_in.cycles[0].dissipated);
    /// # Ok::<(), Box<dyn std::error::Error>>(())
    /// ```
    pub fn run(
        &self,
        flanks: &TwoFlanks,
        settings: &SolverSettings,
    ) -> Result<RanIn, ContactError> {
        self.run_watched(flanks, settings, |_, _| {})
    }

    /// Runs the flanks in as [`run`](Self::run); `watch` sees every cycle and the flanks after it, to
    /// follow quantities that this crate does not know, such as the reduced peak height Rpk.
    ///
    /// # Errors
    /// As [`run`](Self::run).
    ///
    /// ```
    /// use asperity_contact::{SolverSettings, running_in::RunningIn, two_flanks::TwoFlanks};
    /// use asperity_core::Profile;
    /// let wavy: Vec<f64> = (0..400).map(|i| 3e-7 * (0.21 * f64::from(i)).sin()).collect();
    /// let (rough, smooth) = (Profile::new("1 um".parse()?, wavy)?, Profile::new("1 um".parse()?, vec![0.0; 400])?);
    /// let flanks = TwoFlanks {
    ///     first: &rough, second: &smooth, radius: "3 mm".parse()?, load: "100 N/mm".parse()?,
    ///     modulus: "115.4 GPa".parse()?, pressure_limit: Some("2 GPa".parse()?),
    /// };
    /// let mean = |heights: &[f64]| heights.iter().sum::<f64>() / heights.len() as f64;
    /// let mut levels = vec![mean(rough.heights())];
    /// RunningIn::evenly(400, 4)?.run_watched(&flanks, &SolverSettings::default(), |_, [first, _]| {
    ///     levels.push(mean(first.heights()));
    /// })?;
    /// assert!(levels.windows(2).all(|cycle| cycle[1] <= cycle[0]));
    /// # Ok::<(), Box<dyn std::error::Error>>(())
    /// ```
    pub fn run_watched(
        &self,
        flanks: &TwoFlanks,
        settings: &SolverSettings,
        mut watch: impl FnMut(&Cycle, &[Profile; 2]),
    ) -> Result<RanIn, ContactError> {
        self.validate(flanks)?;
        let mut flanks_now = [flanks.first.clone(), flanks.second.clone()];
        let mut starts: Vec<Option<Vec<f64>>> = vec![None; self.shifts.len()];
        let mut path = Path::new(flanks.first.len(), Boundary::FreeEnds, *settings)?;
        let mut cycles: Vec<Cycle> = vec![];
        let mut left = f64::INFINITY;
        while left > self.shakedown {
            if cycles.len() == self.max_cycles {
                return Err(ContactError::NotRunIn {
                    cycles: self.max_cycles,
                    left,
                    shakedown: self.shakedown,
                });
            }
            let mut passes = vec![];
            for (&shift, start) in self.shifts.iter().zip(&mut starts) {
                let solution = pass(&flanks_now, flanks, shift, start.as_deref(), &mut path)?;
                let flow = &solution.plastic_displacement;
                let second = turned(flow, flow.len() - shift % flow.len());
                let [first_share, second_share] = self.shares;
                flanks_now = [
                    worn(&flanks_now[0], flow, first_share)?,
                    worn(&flanks_now[1], &second, second_share)?,
                ];
                passes.push(Pass::of(&solution));
                *start = Some(solution.pressure);
            }
            let cycle = Cycle::of(&passes, &flanks_now);
            let first = cycles.first().unwrap_or(&cycle).dissipated.si();
            left = if first > 0.0 {
                cycle.dissipated.si() / first
            } else {
                0.0
            };
            watch(&cycle, &flanks_now);
            cycles.push(cycle);
        }
        Ok(RanIn {
            cycles,
            flanks: flanks_now,
        })
    }

    fn validate(&self, flanks: &TwoFlanks) -> Result<(), ContactError> {
        let passes = self.shifts.len() as f64;
        DomainError::require(
            passes > 0.0,
            "number of shifts",
            passes,
            "-",
            "must be at least 1",
        )?;
        let [one, other] = self.shares;
        let rule = "must not be negative, and the two must sum to one";
        let sensible = one >= 0.0 && other >= 0.0 && (one + other - 1.0).abs() < SHARES;
        DomainError::require(sensible, "share of the first flank", one, "-", rule)?;
        let rule = "must lie between zero and one";
        let sensible = self.shakedown > 0.0 && self.shakedown < 1.0;
        DomainError::require(sensible, "shakedown", self.shakedown, "-", rule)?;
        if flanks.pressure_limit.is_none() {
            return Err(ContactError::LimitNeeded {
                purpose: "running-in",
            });
        }
        Ok(())
    }
}

/// Round-off of the sum of two shares.
const SHARES: f64 = 1e-12;

/// One contact at a shift.
fn pass(
    now: &[Profile; 2],
    flanks: &TwoFlanks,
    shift: usize,
    start: Option<&[f64]>,
    path: &mut Path,
) -> Result<ContactSolution, ContactError> {
    let [first, second] = now;
    let second = Profile::new(second.spacing(), turned(second.heights(), shift))?;
    let pair = TwoFlanks {
        first,
        second: &second,
        ..*flanks
    };
    let gap = pair.gap()?;
    path.step(&ContactProblem {
        start,
        ..pair.problem(&gap)?
    })
}

/// The values moved on by so many points, those from the end to the front.
fn turned(values: &[f64], points: usize) -> Vec<f64> {
    let mut turned = values.to_vec();
    turned.rotate_right(points % values.len());
    turned
}

fn worn(flank: &Profile, flow: &[f64], share: f64) -> Result<Profile, DomainError> {
    Profile::new(
        flank.spacing(),
        displaced_profile(flank.heights(), flow, share),
    )
}

/// Record of one pass.
struct Pass {
    dissipated: f64,
    largest_flow: f64,
    flowing_points: usize,
    contact_fraction: f64,
}

impl Pass {
    fn of(solution: &ContactSolution) -> Self {
        let flow = &solution.plastic_displacement;
        Self {
            dissipated: solution.dissipated.si(),
            largest_flow: flow.iter().copied().fold(0.0, f64::max),
            flowing_points: flow.iter().filter(|&&w| w > 0.0).count(),
            contact_fraction: solution.contact_fraction,
        }
    }
}

impl Cycle {
    fn of(passes: &[Pass], flanks: &[Profile; 2]) -> Self {
        let shape = flanks.each_ref().map(|flank| rq_and_peak(flank.heights()));
        let fractions: f64 = passes.iter().map(|pass| pass.contact_fraction).sum();
        let largest = passes.iter().map(|pass| pass.largest_flow);
        Self {
            dissipated: LineEnergy::from_si(passes.iter().map(|pass| pass.dissipated).sum()),
            largest_flow: Length::from_si(largest.fold(0.0, f64::max)),
            flowing_points: passes.iter().map(|pass| pass.flowing_points).sum(),
            contact_fraction: fractions / passes.len() as f64,
            rq: shape.map(|[rq, _]| rq),
            peak: shape.map(|[_, peak]| peak),
        }
    }
}

fn rq_and_peak(heights: &[f64]) -> [Length; 2] {
    let n = heights.len() as f64;
    let mean = heights.iter().sum::<f64>() / n;
    let power = heights.iter().map(|z| (z - mean).powi(2)).sum::<f64>() / n;
    let peak = heights.iter().fold(f64::NEG_INFINITY, |m, &z| m.max(z));
    [Length::from_si(power.sqrt()), Length::from_si(peak - mean)]
}
