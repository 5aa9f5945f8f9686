//! Teeth that the traces of both flanks were measured on, and the zones of the face that each represents.

use asperity_core::quantity::Length;

/// Largest number of pairs of teeth that are all computed.
const MOST_PAIRS: usize = 64;
/// Least number of teeth of each flank that are paired if there are more pairs.
const LEAST_TEETH: usize = 8;

/// Tooth of a trace, and its place across the face.
#[derive(Debug, Clone, Copy, PartialEq, Default)]
pub struct TraceSite {
    /// Index of the tooth, from 0 in the order of the list.
    pub tooth: usize,
    /// Number of the tooth as stated.
    pub number: Option<u32>,
    /// Place across the face.
    pub y: Option<Length>,
    /// Its row, of several rows of one scan.
    pub row: Option<ScanRow>,
}

/// A row of a scan.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct ScanRow {
    /// Its number from 1.
    pub number: usize,
    /// Distance from the first row, if the distance of the rows is known.
    pub along_lead: Option<Length>,
}

/// Number of teeth of `traces`.
#[must_use]
pub fn teeth(traces: &[TraceSite]) -> usize {
    let above = traces.iter().map(|trace| trace.tooth + 1);
    above.max().unwrap_or(0)
}

/// Number of teeth of each flank that are paired: all up to 64 pairs, otherwise at least eight of a flank that has them and as
/// many as make 64 pairs.
#[must_use]
pub fn paired(teeth: [usize; 2]) -> [usize; 2] {
    if teeth[0] * teeth[1] <= MOST_PAIRS {
        teeth
    } else {
        [0, 1].map(|body: usize| {
            let of_others = MOST_PAIRS / teeth[1 - body].max(1);
            teeth[body].min(of_others.max(LEAST_TEETH))
        })
    }
}

/// Places y/b between the zones of the face; within a zone the nearest trace of each tooth is the same.
#[must_use]
pub fn zones(flanks: [&[TraceSite]; 2], width: Length) -> Vec<f64> {
    /// Edges that are nearer to each other count as one.
    const SAME: f64 = 1e-9;
    let mut edges: Vec<f64> = Vec::new();
    for traces in flanks {
        for tooth in 0..teeth(traces) {
            let mut places: Vec<f64> = of_tooth(traces, tooth)
                .filter_map(|(_, trace)| Some(trace.y? / width))
                .collect();
            places.sort_by(f64::total_cmp);
            edges.extend(places.windows(2).map(|ends| 0.5 * (ends[0] + ends[1])));
        }
    }
    edges.sort_by(f64::total_cmp);
    edges.dedup_by(|a, b| (*a - *b).abs() < SAME);
    edges
}

/// Index of the trace of `tooth` that lies nearest to `across`, a place y/b.
pub(crate) fn nearest(
    traces: &[TraceSite],
    tooth: usize,
    across: f64,
    width: Length,
) -> Option<usize> {
    let away = |trace: &TraceSite| trace.y.map_or(0.0, |y| (y / width - across).abs());
    of_tooth(traces, tooth)
        .min_by(|a, b| away(a.1).total_cmp(&away(b.1)))
        .map(|(index, _)| index)
}

fn of_tooth(traces: &[TraceSite], tooth: usize) -> impl Iterator<Item = (usize, &TraceSite)> {
    let all = traces.iter().enumerate();
    all.filter(move |(_, trace)| trace.tooth == tooth)
}
