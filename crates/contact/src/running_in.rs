//! Running-in: repeated contact of two flanks with less plastic flow in every cycle, until the contact
//! is elastic.
//!
//! In a cycle the second flank passes the first at a number of relative shifts. At each shift the flanks
//! are pressed together, and each profile is lowered by its share of the plastic displacement. After the
//! first few cycles, which flatten the highest points, the energy per cycle decays geometrically:
//! shakedown. Shifted profiles are treated as periodic.
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

/// Settings of a running-in: shifts, shares of the plastic displacement, and end of the cycles.
#[derive(Debug, Clone, PartialEq)]
pub struct RunningIn {
    /// Shifts of the second flank in points; every cycle has one pass per shift.
    pub shifts: Vec<usize>,
    /// Shares of the plastic displacement
    /// ([`plastic_shares`](crate::plasticity::plastic_shares)).
    pub shares: [f64; 2],
    /// Dissipated energy of a cycle, relative to the first cycle, at which the running-in ends.
    pub shakedown: f64,
    /// Largest number of cycles.
    pub max_cycles: usize,
}

/// Results of one cycle.
#[derive(Debug, Clone, PartialEq, Serialize)]
#[non_exhaustive]
pub struct Cycle {
    /// Energy dissipated in all passes.
    pub dissipated: LineEnergy,
    /// Largest plastic displacement in a pass.
    pub largest_flow: Length,
    /// Number of points that flowed, summed over the passes.
    pub flowing_points: usize,
    /// Mean share of the points in contact.
    pub contact_fraction: f64,
    /// Rq of the flanks after the cycle.
    pub rq: [Length; 2],
    /// Height of the highest point of the flanks over their mean after the cycle.
    pub peak: [Length; 2],
}

/// Result of a running-in.
#[derive(Debug, Clone, PartialEq)]
#[non_exhaustive]
pub struct RanIn {
    /// All cycles in order.
    pub cycles: Vec<Cycle>,
    /// The flanks after the last cycle.
    pub flanks: [Profile; 2],
}

impl RunningIn {
    /// Settings with `passes` evenly spaced shifts over a profile of `points` points and equal shares,
    /// until a cycle dissipates a millionth of the first.
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

    /// Runs the flanks in under their load and pressure limit.
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

    /// Runs the flanks in as [`run`](Self::run) and calls `watch` with every cycle and the flanks after
    /// it, for example to record the reduced peak height Rpk.
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
        let mut profiles = [flanks.first.clone(), flanks.second.clone()];
        let mut starts: Vec<Option<Vec<f64>>> = vec![None; self.shifts.len()];
        let mut path = Path::new(flanks.first.len(), Boundary::FreeEnds, *settings)?;
        let mut cycles: Vec<Cycle> = vec![];
        // Dissipated energy of the last cycle relative to the first.
        let mut energy_ratio = f64::INFINITY;
        while energy_ratio > self.shakedown {
            if cycles.len() == self.max_cycles {
                return Err(ContactError::not_run_in(
                    self.max_cycles,
                    energy_ratio,
                    self.shakedown,
                ));
            }
            let mut passes = vec![];
            for (&shift, start) in self.shifts.iter().zip(&mut starts) {
                let solution =
                    press_shifted(&profiles, flanks, shift, start.as_deref(), &mut path)?;
                let flow = &solution.plastic_displacement;
                let second_flow = rotated(flow, flow.len() - shift % flow.len());
                let [first_share, second_share] = self.shares;
                profiles = [
                    lowered(&profiles[0], flow, first_share)?,
                    lowered(&profiles[1], &second_flow, second_share)?,
                ];
                passes.push(Pass::from_solution(&solution));
                // The same shift has nearly the same pressure in the next cycle.
                *start = Some(solution.pressure);
            }
            let cycle = Cycle::new(&passes, &profiles);
            let first = cycles.first().unwrap_or(&cycle).dissipated.si();
            energy_ratio = if first > 0.0 {
                cycle.dissipated.si() / first
            } else {
                0.0
            };
            watch(&cycle, &profiles);
            cycles.push(cycle);
        }
        Ok(RanIn {
            cycles,
            flanks: profiles,
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
        let valid = one >= 0.0 && other >= 0.0 && (one + other - 1.0).abs() < SHARE_ROUND_OFF;
        DomainError::require(valid, "share of the first flank", one, "-", rule)?;
        let rule = "must lie between zero and one";
        let valid = self.shakedown > 0.0 && self.shakedown < 1.0;
        DomainError::require(valid, "shakedown", self.shakedown, "-", rule)?;
        if flanks.pressure_limit.is_none() {
            return Err(ContactError::limit_needed("running-in"));
        }
        Ok(())
    }
}

/// Round-off of the sum of two shares.
const SHARE_ROUND_OFF: f64 = 1e-12;

/// Presses the present profiles together at a shift of the second.
fn press_shifted(
    profiles: &[Profile; 2],
    flanks: &TwoFlanks,
    shift: usize,
    start: Option<&[f64]>,
    path: &mut Path,
) -> Result<ContactSolution, ContactError> {
    let [first, second] = profiles;
    let second = Profile::new(second.spacing(), rotated(second.heights(), shift))?;
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

/// The values rotated by `shift` points towards the end.
fn rotated(values: &[f64], shift: usize) -> Vec<f64> {
    let mut rotated = values.to_vec();
    rotated.rotate_right(shift % values.len());
    rotated
}

/// The profile lowered by its share of the plastic displacement.
fn lowered(flank: &Profile, flow: &[f64], share: f64) -> Result<Profile, DomainError> {
    Profile::new(
        flank.spacing(),
        displaced_profile(flank.heights(), flow, share),
    )
}

/// Results of one pass.
struct Pass {
    dissipated: f64,
    largest_flow: f64,
    flowing_points: usize,
    contact_fraction: f64,
}

impl Pass {
    fn from_solution(solution: &ContactSolution) -> Self {
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
    fn new(passes: &[Pass], flanks: &[Profile; 2]) -> Self {
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
