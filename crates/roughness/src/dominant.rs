//! Sections of a trace that are much higher than the others: a groove, a pit, a step, or the edge of the flank.
//!
//! Parameters over a trace describe a texture that is the same everywhere. Few sections with a feature of their own raise Rz and
//! Rpk of the whole, and the contacts on them are not those of the finish.

use asperity_core::Profile;
use asperity_core::numerics::{extremes, median};
use asperity_core::quantity::Length;

use crate::height_parameters::sections_in;
use crate::warning::{OUTSIDE, Warning};

/// Height of the highest of `sections` over their median that a finish exceeds on less than one trace in a thousand.
///
/// The bound 4.4 + 0.7 ln n lies above the quantile 0.999 of parts of 5000 seeded ground surrogates (`Surrogate`, cut-offs of
/// 0.25 mm and 2.5 µm): 4.7 for three sections, 5.2 for five, 5.8 for ten, 6.0 for twenty and 6.6 for forty. 0.4 to 0.8 of a
/// thousand exceed it. Superfinished surrogates reach 2.4, and plateaus of
/// two self-affine processes have quantiles of 4.3 for three sections and of 3.0 to 3.5 for more.
fn limit(sections: usize) -> f64 {
    const OF_ONE: f64 = 4.4;
    const BY_LOGARITHM: f64 = 0.7;
    OF_ONE + BY_LOGARITHM * (sections as f64).ln()
}

/// Warning about the sections of length `section` of `rough`, the roughness profile that begins `first` points behind the
/// first point of `primary`, if the height Rz of the highest is above [`limit`] times the median of all; `None` if it is not,
/// and for one or two sections, whose median says nothing.
pub(crate) fn dominant(
    primary: &Profile,
    rough: &Profile,
    first: usize,
    section: Length,
) -> Option<Warning> {
    const FEWEST: usize = 3;
    let z = rough.heights();
    let n = sections_in(rough, section).ok()?;
    if n < FEWEST {
        return None;
    }
    let bounds: Vec<usize> = (0..=n).map(|i| i * z.len() / n).collect();
    let ranges = bounds.windows(2).map(|ends| extremes(&z[ends[0]..ends[1]]));
    let ranges: Vec<(f64, f64)> = ranges.collect();
    let height = |(low, high): &(f64, f64)| high - low;
    let heights: Vec<f64> = ranges.iter().map(height).collect();
    let median = median(heights.iter().copied())?;
    let highest = heights.into_iter().fold(0.0, f64::max);
    // Rounding errors of a plane with an offset are no features.
    let (low, high) = extremes(primary.heights());
    let rounding = 1e3 * f64::EPSILON * low.abs().max(high.abs());
    if highest <= limit(n) * median + rounding {
        return None;
    }
    let outside = |range| height(range) > OUTSIDE * median;
    let dominates: Vec<bool> = ranges.iter().map(outside).collect();
    let begin = dominates.iter().position(|is| *is)?;
    let end = n - dominates.iter().rev().position(|is| *is)?;
    let worst = ranges.iter().position(|range| height(range) == highest)?;
    let (low, high) = ranges[worst];
    let extreme = if high > -low { high } else { low };
    let at = z[bounds[worst]..bounds[worst + 1]].iter();
    let at = bounds[worst] + at.clone().position(|z| *z == extreme)?;
    // Longest run of sections between two that dominate, or an end.
    let outer = [0, n + 1].into_iter();
    let edges = dominates.iter().enumerate().filter(|(_, is)| **is);
    let mut edges: Vec<usize> = edges.map(|(i, _)| i + 1).chain(outer).collect();
    edges.sort_unstable();
    let runs = edges.windows(2).map(|ends| ends[0]..ends[1] - 1);
    let sound = runs.max_by_key(|run| run.len())?;
    let x = |point: usize| primary.spacing() * (first + point) as f64;
    let (low, high) = extremes(&primary.heights()[first + bounds[begin]..first + bounds[end]]);
    Some(Warning::SectionsDominate {
        count: dominates.iter().filter(|is| **is).count(),
        sections: n,
        section,
        from: x(bounds[begin]),
        to: x(bounds[end]),
        median: Length::from_si(median),
        highest: Length::from_si(highest),
        at: x(at),
        span: Length::from_si(high - low),
        sound: [
            if sound.start == 0 {
                Length::from_si(0.0)
            } else {
                x(bounds[sound.start])
            },
            if sound.end == n {
                primary.length()
            } else {
                x(bounds[sound.end])
            },
        ],
    })
}
