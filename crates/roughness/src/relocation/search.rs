//! The place of the second trace on the first by the correlation of their valleys, over all shifts and stretches.

use asperity_core::cancel::{Cancelled, checkpoint};
use asperity_core::cite;
use asperity_core::numerics::{good_fft_length, real_transforms};
use realfft::num_complex::Complex;

use super::traces::Trace;

/// Least overlap, in lengths of the shorter trace.
const LEAST_OVERLAP: f64 = 0.5;
/// Step of the stretch: at the ends of the trace the match is off by at most this number of spacings.
const STEP: f64 = 1.0;
/// A place is another one at this distance \[m\].
const ELSEWHERE: f64 = 20e-6;
/// A place may match as well as the best if this part of its distance from full correlation is that of the best.
const CLEARLY: f64 = 0.5;
/// Distance from full correlation that resampling leaves.
const RESAMPLED: f64 = 1e-6;

/// A place of the second trace on the first.
#[derive(Debug, Clone, Copy)]
pub(super) struct Match {
    /// Correlation of the valleys.
    pub correlation: f64,
    /// Shift of the middle \[m\].
    pub shift: f64,
    /// Stretch.
    pub stretch: f64,
}

/// Places at which the traces match.
#[derive(Debug)]
pub(super) struct Matches {
    /// The best place and those that may match as well, the best first.
    pub alike: Vec<Match>,
    /// Best correlation elsewhere.
    pub elsewhere: f64,
}

/// ```text
/// ρ(s, e) = corr( min(r_b(s + (1 + e) x), median), min(r_a(x), median) ),  largest over s and |e| within the bound   [Relocation-1]
/// ```
///
/// The correlation over the overlap of each shift, which is at least half of the shorter trace, both without their ends.
pub(super) fn search(
    before: &Trace,
    after: &Trace,
    most_stretch: f64,
) -> Result<Matches, Cancelled> {
    cite!("Relocation-1");
    let dx = before.dx;
    let (first, first_begin) = before.valleys();
    let (second, second_begin) = after.valleys();
    let steps = (most_stretch * after.length() / (2.0 * STEP * dx)).ceil() as i64;
    let mut table = Vec::new();
    for k in -steps..=steps {
        checkpoint()?;
        let stretch = most_stretch * k as f64 / steps.max(1) as f64;
        let stretched = respaced(&second, after.dx * (1.0 + stretch), dx);
        let of_middle =
            first_begin - (1.0 + stretch) * second_begin + 0.5 * stretch * after.length();
        let at = |(k, correlation): (i64, f64)| Match {
            correlation,
            shift: k as f64 * dx + of_middle,
            stretch,
        };
        table.extend(correlations(&first, &stretched).into_iter().map(at));
    }
    Ok(places(&best_stretches(table, dx), dx))
}

/// The best stretch at each shift, which are `dx` apart.
fn best_stretches(mut table: Vec<Match>, dx: f64) -> Vec<Match> {
    let bin = |place: &Match| (place.shift / dx).round() as i64;
    let worst_first = |a: &Match, b: &Match| a.correlation.total_cmp(&b.correlation);
    table.sort_unstable_by(|a, b| bin(a).cmp(&bin(b)).then(worst_first(b, a)));
    table.dedup_by_key(|place| bin(place));
    table
}

/// The best of all shifts, and of each run of shifts that match as well.
fn places(shifts: &[Match], dx: f64) -> Matches {
    let by_correlation = |a: &&Match, b: &&Match| a.correlation.total_cmp(&b.correlation);
    let Some(best) = shifts.iter().max_by(by_correlation).copied() else {
        return Matches {
            alike: Vec::new(),
            elsewhere: 0.0,
        };
    };
    let is_alike =
        |place: &Match| CLEARLY * (1.0 - place.correlation) <= 1.0 - best.correlation + RESAMPLED;
    let runs = shifts.chunk_by(|a, b| is_alike(a) == is_alike(b) && b.shift - a.shift < 2.0 * dx);
    let tops = runs.filter_map(|run| run.iter().max_by(by_correlation).copied());
    let mut alike: Vec<Match> = tops.filter(is_alike).collect();
    alike.sort_by(|a, b| by_correlation(&b, &a));
    let others = shifts.iter();
    let others = others.filter(|place| (place.shift - best.shift).abs() > ELSEWHERE);
    Matches {
        alike,
        elsewhere: others
            .max_by(by_correlation)
            .map_or(0.0, |place| place.correlation),
    }
}

/// Values `from` apart, at a distance of `to` by linear interpolation.
fn respaced(values: &[f64], from: f64, to: f64) -> Vec<f64> {
    let count = ((values.len() - 1) as f64 * from / to).floor() as usize;
    let at = |k: usize| {
        let place = k as f64 * to / from;
        let i = (place.floor() as usize).min(values.len() - 2);
        values[i] + (place - i as f64) * (values[i + 1] - values[i])
    };
    (0..=count).map(at).collect()
}

/// Correlation over the overlap for each shift in points.
fn correlations(first: &[f64], second: &[f64]) -> Vec<(i64, f64)> {
    let [n, m] = [first.len(), second.len()];
    let length = good_fft_length(n + m);
    let (forward, inverse) = real_transforms(length);
    let spectrum = |values: &[f64]| {
        let mut padded = values.to_vec();
        padded.resize(length, 0.0);
        let mut lines = forward.make_output_vec();
        let done = forward.process(&mut padded, &mut lines);
        debug_assert!(done.is_ok(), "buffers are made by the plan");
        lines
    };
    let mut product: Vec<Complex<f64>> = spectrum(first)
        .into_iter()
        .zip(spectrum(second))
        .map(|(a, b)| a * b.conj())
        .collect();
    let mut sums = inverse.make_output_vec();
    let done = inverse.process(&mut product, &mut sums);
    debug_assert!(done.is_ok(), "buffers are made by the plan");
    let [of_first, of_second] = [first, second].map(prefix_sums);
    let least = (LEAST_OVERLAP * n.min(m) as f64) as i64;
    let at = |shift: i64| {
        // Point j of the second trace is on point j + shift of the first.
        let begin = (-shift).max(0);
        let end = (m as i64).min(n as i64 - shift);
        if end - begin < least {
            return None;
        }
        let count = (end - begin) as f64;
        let product = sums[shift.rem_euclid(length as i64) as usize] / length as f64;
        let between = |sums: &[[f64; 2]], from: i64, to: i64| {
            [0, 1].map(|k: usize| sums[to as usize][k] - sums[from as usize][k])
        };
        let a = between(&of_first, begin + shift, end + shift);
        let b = between(&of_second, begin, end);
        let variance = |[sum, square]: [f64; 2]| square - sum * sum / count;
        let scale = (variance(a) * variance(b)).sqrt();
        (scale > 0.0).then(|| (shift, (product - a[0] * b[0] / count) / scale))
    };
    (least - m as i64..=n as i64 - least)
        .filter_map(at)
        .collect()
}

/// Sums of the values and of their squares before each point.
fn prefix_sums(values: &[f64]) -> Vec<[f64; 2]> {
    let mut sums = vec![[0.0; 2]];
    let mut total = [0.0; 2];
    for z in values {
        total = [total[0] + z, total[1] + z * z];
        sums.push(total);
    }
    sums
}
