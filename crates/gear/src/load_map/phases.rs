//! Mesh phases at which a load map is solved, with their weights.

use std::num::NonZeroUsize;

use crate::pair::GearPair;
use crate::quadrature::{breakpoints, gauss_legendre};

/// Gauss points in a piece.
const ORDER: NonZeroUsize = NonZeroUsize::MIN.saturating_add(1);

/// Maximum length of a piece between breakpoints.
const LONGEST_PIECE: f64 = 1.0 / 16.0;

/// Maximum length of a piece for a map with one cell across the face, whose phases cost little, or with little overlap.
const LONGEST_FINE_PIECE: f64 = 1.0 / 64.0;

/// A phase of the mesh cycle.
#[derive(Debug, Clone, Copy)]
pub(crate) struct MeshPhase {
    pub(crate) phase: f64,
    pub(crate) weight: f64,
    /// Pitch number within a cycle of several pitches.
    pub(crate) pitch: usize,
}

/// Two Gauss points in each piece between the phases at which a line of contact starts, ends or passes one of the
/// coordinates `marks`.
pub(crate) fn phases(pair: &GearPair, marks: &[f64], fine: bool, pitches: usize) -> Vec<MeshPhase> {
    let longest = if fine {
        LONGEST_FINE_PIECE
    } else {
        LONGEST_PIECE
    };
    let breaks = pair.phase_breakpoints(marks.iter().copied());
    let rule = gauss_legendre(ORDER);
    let mut all = Vec::new();
    for pitch in 0..pitches {
        for (from, to) in pieces(&breaks, longest) {
            all.extend(rule.iter().map(|&(node, weight)| MeshPhase {
                phase: from + (to - from) * node,
                weight: weight * (to - from) / pitches as f64,
                pitch,
            }));
        }
    }
    all
}

/// The segments between `breaks`, divided into equal pieces not longer than `longest`.
pub(crate) fn pieces(breaks: &[f64], longest: f64) -> Vec<(f64, f64)> {
    let cut = |from: f64, to: f64| {
        let count = ((to - from) / longest - 1e-9).ceil().max(1.0) as usize;
        let step = (to - from) / count as f64;
        (0..count).map(move |k| (from + step * k as f64, from + step * (k + 1) as f64))
    };
    (breaks.windows(2))
        .flat_map(|ends| cut(ends[0], ends[1]))
        .collect()
}

/// Pieces of a strip of the path, with breakpoints at `marks`.
pub(crate) fn strip_pieces(from: f64, to: f64, marks: &[f64], longest: f64) -> Vec<(f64, f64)> {
    pieces(&breakpoints(from, to, marks.iter().copied()), longest)
}
