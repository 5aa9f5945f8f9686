//! Division of the lines of contact at a phase into cells of the face width.

use super::coupled::{ContactLine, CoupledCell, LEAST_COVER};
use crate::edge_contact::TipGaps;
use crate::pair::GearPair;
use crate::pair_compliance::PairCompliance;
use crate::relief::Separation;

/// Data for filling the cells.
#[derive(Debug, Clone)]
pub(crate) struct LoadGrid {
    pub(crate) compliance: PairCompliance,
    pub(crate) separation: Separation,
    /// Gaps of the tip edges outside the path; `None` without tip edge contact.
    pub(crate) edges: Option<TipGaps>,
    /// Cells across the face.
    pub(crate) cells: usize,
    /// Mean load f₀.
    pub(crate) mean_load: f64,
}

impl LoadGrid {
    /// Length beyond each end of the path in which tip edges may be in contact, in base pitches.
    pub(crate) fn reach(&self) -> f64 {
        self.edges
            .as_ref()
            .map_or(0.0, |_| crate::edge_contact::REACH)
    }

    /// Fills the contact lines at a phase: a tooth is in contact where φ + j + ε_β y/b is on the path.
    pub(crate) fn rows(
        &self,
        pair: &GearPair,
        phase: f64,
        pitch: usize,
        rows: &mut Vec<ContactLine>,
    ) {
        let (eps_alpha, eps_beta) = (pair.path.eps_alpha, pair.path.eps_beta);
        let (low, high) = (-self.reach(), eps_alpha + self.reach());
        let first = (low - eps_beta - phase).floor() as i64;
        let last = (high - phase).ceil() as i64;
        let mut used = 0;
        for tooth in first..=last {
            let front = phase + tooth as f64;
            let Some(span) = span(pair, front, low, high) else {
                continue;
            };
            if used == rows.len() {
                rows.push(ContactLine::default());
            }
            if let Some(row) = rows.get_mut(used) {
                row.tooth = tooth;
                self.fill(pair, row, front, span, pitch);
                used += 1;
            }
        }
        rows.truncate(used);
    }

    fn fill(
        &self,
        pair: &GearPair,
        row: &mut ContactLine,
        front: f64,
        [from, to]: [f64; 2],
        pitch: usize,
    ) {
        let count = self.cells as f64;
        let first = ((from * count).floor() as usize).min(self.cells - 1);
        let end = ((to * count).ceil() as usize).clamp(first + 1, self.cells);
        row.cells.clear();
        row.idle = [first, self.cells - end];
        for k in first..end {
            let low = (k as f64 / count).max(from);
            let high = ((k + 1) as f64 / count).min(to);
            let cover = (high - low) * count;
            if cover <= LEAST_COVER {
                // Rounding error at an end of the line.
                let side = usize::from(k > first);
                row.idle[side] += 1;
                continue;
            }
            let across = 0.5 * (low + high);
            let xi = if pair.is_spur() {
                front
            } else {
                front + pair.path.eps_beta * across
            };
            row.cells
                .push(self.cell(pair, xi, across, cover, row.tooth - pitch as i64));
        }
    }

    fn cell(&self, pair: &GearPair, xi: f64, across: f64, cover: f64, tooth: i64) -> CoupledCell {
        let mut separation = self.separation.at(xi, across, tooth);
        if let Some(edges) = &self.edges {
            separation += edges.at(pair, xi);
        }
        CoupledCell {
            xi,
            across,
            cover,
            separation,
            root_bending: self.compliance.bending(xi).sqrt(),
            flattening: self.compliance.flattening(pair, xi, self.mean_load),
            ..CoupledCell::default()
        }
    }
}

/// Contact interval y/b of the face for a tooth at the coordinate `front` on the front face.
fn span(pair: &GearPair, front: f64, low: f64, high: f64) -> Option<[f64; 2]> {
    if pair.is_spur() {
        return (low <= front && front < high).then_some([0.0, 1.0]);
    }
    let eps_beta = pair.path.eps_beta;
    let (from, to) = (front.max(low), (front + eps_beta).min(high));
    (to - from > LEAST_COVER).then(|| {
        let across = |xi: f64| ((xi - front) / eps_beta).clamp(0.0, 1.0);
        [across(from), across(to)]
    })
}
