//! The trace on the trace before it, with what was removed and what moved.

use asperity_core::cancel::checkpoint;
use asperity_core::numerics::{Z_95, deviation, mean};
use asperity_core::quantity::Length;
use asperity_core::{Code, DomainError, Estimate, Fault, Profile, cite};

use crate::error::RoughnessError;
use crate::form::Form;
use crate::gaussian_filter::{Ends, mean_line};
use crate::generate::Random;

use super::fit::{BOW, HEIGHT, MIDDLE, RelocationFit, STRETCH, TILT};
use super::noise::Noise;
use super::placed::placed;
use super::rise::{self, MOVED};
use super::search::search;
use super::traces::{Trace, height_at, noise_cutoff};

/// Standard deviation of the height over the gain of the valleys: where some rose, others that were matched may have risen as well.
const RISEN: f64 = 1.0;
/// Height below which traces on each other differ by the rounding of their match \[m\].
const LEAST_CHANGE: f64 = 1e-11;
/// Sets of made noise that show the gain of noise.
pub(super) const SETS: usize = 40;

/// Bounds of a relocation, and what may differ between the traces.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Bounds {
    /// Largest shift, to either side.
    pub shift: Length,
    /// Largest stretch, to either side.
    pub stretch: f64,
    /// Form by which the second trace may differ: [`Form::Level`], a height and a tilt, or [`Form::Poly2`], a parabola as well.
    pub form: Form,
}

impl Default for Bounds {
    fn default() -> Self {
        Self {
            shift: Length::from_si(0.5e-3),
            stretch: 0.003,
            form: Form::Level,
        }
    }
}

impl Bounds {
    /// Checks the bounds, and returns the largest shift \[m\].
    ///
    /// # Errors
    /// When the shift is negative, the stretch is not from 0 to 0.05, or the form is neither a line nor a parabola.
    pub fn check(&self) -> Result<f64, Fault> {
        if !matches!(self.form, Form::Level | Form::Poly2) {
            let message = "form: between two traces, level (height and tilt) or poly2 (a parabola as well) can have changed";
            return Err(Fault::new(Code::E205, message));
        }
        let rule = "must be from 0 to 0.05";
        let is_valid = (0.0..=0.05).contains(&self.stretch);
        DomainError::require(is_valid, "max_stretch", self.stretch, "-", rule)?;
        Ok(DomainError::non_negative("max_shift", self.shift)?)
    }
}

/// A trace on the trace of the same place before it. All intervals are from 5 to 95 %.
#[derive(Debug, Clone, PartialEq)]
#[non_exhaustive]
pub struct Relocation {
    /// Distance of the first points at which the middle of the second trace lies on its place of the first; the stretch is about
    /// the middle.
    pub shift: Estimate<Length>,
    /// Relative stretch of the second trace.
    pub stretch: Estimate,
    /// Height to add to the second trace in its middle.
    pub height: Estimate<Length>,
    /// Slope to add to the second trace.
    pub tilt: Estimate,
    /// Height to add to the second trace at the ends of its whole length, as a parabola; `None` with [`Form::Level`].
    pub bow: Option<Estimate<Length>>,
    /// Correlation of the valleys.
    pub correlation: f64,
    /// Best correlation of the valleys at another place.
    pub elsewhere: f64,
    /// Share of the points in the valleys that were matched.
    pub matched: f64,
    /// Standard deviation of the difference of both traces in the valleys.
    pub noise: Length,
    /// Noise cut-off of both traces.
    pub noise_cutoff: Length,
    /// Distance of the first point of the overlap from the first point of the first trace.
    pub start: Length,
    /// First trace over the overlap.
    pub before: Profile,
    /// Second trace over the overlap, in the frame of the first.
    pub after: Profile,
    /// Mean height lost over the overlap: what was removed.
    pub removed: Estimate<Length>,
    /// Height lost where the trace is lower after the test, as mean over the overlap.
    pub lost: Estimate<Length>,
    /// Height gained where it is higher, as mean over the overlap: the material that moved.
    pub gained: Estimate<Length>,
    /// Noise of the difference of both traces.
    pub(super) differences: Noise,
}

impl Relocation {
    /// Both traces as they were measured, at the points of the first over the overlap, the second in the frame of the first. They are
    /// the traces that [`relocate`] had.
    ///
    /// # Errors
    /// When no point of the first trace lies in the overlap.
    pub fn as_measured(
        &self,
        before: &Profile,
        after: &Profile,
    ) -> Result<[Profile; 2], DomainError> {
        let [dx, spacing] = [before, after].map(|trace| trace.spacing().si());
        let half = 0.5 * after.length().si();
        let start = self.start.si();
        let first = (start / dx).ceil() as usize;
        let last = ((start + self.before.length().si()) / dx).floor() as usize;
        let points = first..(last + 1).min(before.len());
        let on_first = |i: usize| {
            let from_middle =
                (i as f64 * dx - half - self.shift.value.si()) / (1.0 + self.stretch.value);
            let z = height_at(after.heights(), (from_middle + half) / spacing);
            let bow = self.bow.map_or(0.0, |bow| bow.value.si());
            z + self.height.value.si()
                + self.tilt.value * from_middle
                + bow * (from_middle / half).powi(2)
        };
        let after: Vec<f64> = points.clone().map(on_first).collect();
        let before = before.heights().get(points).unwrap_or_default().to_vec();
        let mut pairs = before.iter().zip(&after);
        let after = if pairs.all(|(a, b)| (a - b).abs() < LEAST_CHANGE) {
            before.clone()
        } else {
            after
        };
        let both = [before, after].map(|heights| Profile::new(Length::from_si(dx), heights));
        let [before, after] = both;
        Ok([before?, after?])
    }
}

/// Relocates the trace `after` on the trace `before`.
///
/// # Errors
/// When a trace is too short for the filters, the traces are not of the same place, or they match at several places alike. All places
/// are compared at which half of the shorter trace overlaps; the bound of the shift excludes places, and makes none certain.
///
/// ```
/// use asperity_core::{Profile, quantity::Length};
/// use asperity_roughness::generate::{SelfAffine, truncated};
/// use asperity_roughness::relocation::{Bounds, relocate};
/// let texture = SelfAffine {
///     points: 4096, spacing: Length::from_si(0.5e-6), rq: Length::from_si(0.3e-6), hurst: 0.8,
///     roll_off: Length::from_si(50e-6), short_cut: Length::from_si(5e-6), seed: 7,
/// }.generate()?;
/// let worn = truncated(&texture, 0.1)?.0;
/// let [before, after] = [texture.slice(0..3600), worn.slice(200..3800)].map(Option::unwrap);
/// let found = relocate(&before, &after, Bounds::default())?;
/// assert!((found.shift.value.si() - 100e-6).abs() < 0.1e-6);
/// assert!(found.removed.low.si() > 0.0);
/// let [first, second] = found.as_measured(&before, &after)?;
/// let higher = first.heights().iter().zip(second.heights()).map(|(a, b)| (b - a).max(0.0));
/// assert!(higher.fold(0.0, f64::max) < 2e-9);
/// # Ok::<(), asperity_core::Fault>(())
/// ```
pub fn relocate(before: &Profile, after: &Profile, bounds: Bounds) -> Result<Relocation, Fault> {
    let shift = bounds.check()?;
    let cutoff = noise_cutoff(before, after);
    let [first, second] = [Trace::new(before, cutoff)?, Trace::new(after, cutoff)?];
    let found = search(&first, &second, bounds.stretch).map_err(RoughnessError::from)?;
    let (fit, correlation) = placed([&first, &second], &found, shift, bounds.form)?;
    relocation(&fit, &first, &second, correlation, found.elsewhere, cutoff)
}

fn relocation(
    fit: &RelocationFit,
    first: &Trace,
    second: &Trace,
    correlation: f64,
    elsewhere: f64,
    noise_cutoff: Length,
) -> Result<Relocation, Fault> {
    let place = fit.place;
    let half = fit.half;
    let within = |value: f64, deviation: f64| {
        let reach = Z_95 * deviation;
        Estimate::new(value, [value - reach, value + reach])
    };
    let length = |value: f64, deviation: f64| within(value, deviation).map(Length::from_si);
    let stretch = place.stretch / half;
    let spacing = Length::from_si(second.dx * (1.0 + stretch));
    let after = fit.before.iter().zip(&fit.lost).map(|(z, lost)| z - lost);
    let n = fit.lost.len();
    let part = 1.0 / n as f64;
    let (gain, of_gain) = gained(&fit.lost, &fit.noise, spacing)?;
    let of_choice = fit.choice().hypot(fit.uneven);
    // The higher of two measures of one rise.
    let risen = rise::square(fit, spacing)?
        .sqrt()
        .max(RISEN * gain.max(0.0));
    let of_valleys = risen.hypot(of_choice);
    let of_height = fit.deviation_of_place(HEIGHT).hypot(of_valleys);
    let removed = fit.lost.iter().sum::<f64>() * part;
    let of_removed = fit.noise.variance(&fit.influence(&vec![part; n])).sqrt();
    let of_removed = of_removed.hypot(of_valleys);
    Ok(Relocation {
        shift: length(place.middle - half, fit.deviation_of_place(MIDDLE)),
        stretch: within(stretch, fit.deviation_of_place(STRETCH) / half),
        height: length(place.height + first.middle - second.middle, of_height),
        tilt: within(place.tilt / half, fit.deviation_of_place(TILT) / half),
        bow: (fit.has_bow()).then(|| length(place.bow, fit.deviation_of_place(BOW))),
        correlation,
        elsewhere,
        matched: fit.matched(),
        noise: Length::from_si(fit.noise.deviation()),
        noise_cutoff,
        differences: fit.noise.clone(),
        start: Length::from_si(place.middle + (half + place.stretch) * fit.along[0]),
        before: Profile::new(spacing, fit.before.clone())?,
        after: Profile::new(spacing, after.collect())?,
        removed: length(removed, of_removed),
        lost: length(removed + gain, of_removed.hypot(of_gain)),
        gained: length(gain, of_gain.hypot(of_choice)),
    })
}

/// Mean gain of height where the trace is higher, beyond noise, and its standard deviation \[m\].
///
/// ```text
/// g = ⟨max(−w̄, 0)⟩ − 2 n₋/n ⟨max(−n̄, 0)⟩                                                    [Relocation-4]
/// ```
///
/// w̄ is the lost height and n̄ the noise, both smoothed; n₋ of n points are higher. Noise makes half of the points higher that
/// neither lost nor gained.
fn gained(lost: &[f64], noise: &Noise, spacing: Length) -> Result<(f64, f64), RoughnessError> {
    cite!("Relocation-4");
    let cutoff = Length::from_si(MOVED.max(2.0 * spacing.si()));
    // Mean gain, and share of the points that are higher.
    let higher = |lost: &[f64]| -> Result<[f64; 2], RoughnessError> {
        checkpoint()?;
        let smooth = mean_line(&Profile::new(spacing, lost.to_vec())?, cutoff, Ends::Reg0)?;
        let negative = smooth.iter().filter(|w| **w < 0.0);
        let sums = negative.fold([0.0; 2], |[sum, count], w| [sum - w, count + 1.0]);
        Ok(sums.map(|sum| sum / lost.len() as f64))
    };
    let mut random = Random::new(1);
    let made = (0..SETS).map(|_| Ok(higher(&noise.made(lost.len(), &mut random))?[0]));
    let made = made.collect::<Result<Vec<f64>, RoughnessError>>()?;
    let [gain, share] = higher(lost)?;
    let expected = 2.0 * share * mean(made.iter().copied());
    Ok((gain - expected, deviation(&made).unwrap_or(0.0)))
}
