//! Cells of the path, each represented by one contact, because a contact solution at every point of a load map would be
//! too costly.
//!
//! | symbol | meaning | unit |
//! |---|---|---|
//! | K | number of cells | - |
//! | ξ̄, f̄ | representative coordinate and load of a cell | -, N/m |
//! | dP | f V_s dl, the weight | W |
//!
//! The sliding power of a cell is the coefficient of friction times the cell's share of f |V_s|; this is exact for
//! constant friction. For μ ~ f^0.2 V_s^−0.1 the error of the loss is 1.5e-3 with K = 16, and 3.8e-3 at a tenth of the
//! torque with relief. With the arithmetic mean of f it would be two to three times larger.

use asperity_core::numerics::{interpolate_between, range};
use asperity_core::quantity::{Force, Length, LineLoad};
use asperity_core::{DomainError, cite};
use serde::Serialize;

use super::map::{LoadMap, LoadModel, LoadSample, NARROW_OVERLAP};
use crate::error::GearError;
use crate::positions::distribute;
use crate::quadrature::breakpoints;

/// Maximum number of cells.
const MAX_CELLS: usize = 10_000;

/// Strips of the face for the face load factor, `[Width-1]`.
const FACE_STRIPS: usize = 16;

/// Phases for the mean load of a helical pair at a position.
const DISPLAY_PHASES: u32 = 16;

/// A cell of the path with its representative contact.
#[derive(Debug, Clone, Copy, PartialEq, Serialize)]
pub struct LoadCell {
    /// First profile coordinate.
    pub from: f64,
    /// Last profile coordinate.
    pub to: f64,
    /// Representative coordinate ξ̄ of the cell.
    pub xi: f64,
    /// Distance of ξ̄ from T₁.
    pub s: Length,
    /// Representative load f̄ of the cell, the weighted geometric mean.
    pub load: LineLoad,
    /// Contribution to H_V: the sliding power of the cell divided by μ and the input power.
    pub loss_factor: f64,
    /// Share of H_V.
    pub sliding_share: f64,
    /// Loaded length of contact line, the weight of rolling losses.
    pub contact_length: Length,
    /// Mean normal force.
    pub force: Force,
    /// Index of the cell along the path.
    pub number: usize,
    /// Index of the zone of the face; 0 if the face is not divided.
    pub zone: usize,
}

#[derive(Debug, Clone, Copy, Default)]
struct CellSums {
    power: f64,
    xi: f64,
    log: f64,
    length: f64,
    force: f64,
}

impl CellSums {
    /// Adds the fraction `share` of a sample.
    fn add(&mut self, sample: &LoadSample, power: f64, share: f64) {
        let (load, weight, power) = (sample.load.si(), share * sample.weight.si(), share * power);
        if load <= 0.0 {
            return;
        }
        self.power += power;
        self.xi += power * sample.xi;
        self.log += power * load.ln();
        self.length += weight;
        self.force += weight * load;
    }
}

/// Zones of the face.
struct Zones<'a> {
    edges: &'a [Length],
    width: Length,
    /// Whether every point of the map represents the whole face.
    is_single_row: bool,
}

impl<'a> Zones<'a> {
    fn new(edges: &'a [Length], width: Length, is_single_row: bool) -> Result<Self, GearError> {
        let rule = "must lie within the face, in ascending order";
        let mut before = 0.0;
        for edge in edges {
            let y = edge.si();
            let is_between = before < y && y < width.si();
            DomainError::require(is_between, "edge of a zone of the face", y, "m", rule)?;
            before = y;
        }
        Ok(Self {
            edges,
            width,
            is_single_row,
        })
    }

    fn count(&self) -> usize {
        self.edges.len() + 1
    }

    /// Zones that a point at `y` represents, each with its share.
    fn shares(&self, y: Length) -> impl Iterator<Item = (usize, f64)> + '_ {
        let own = self.edges.partition_point(|edge| *edge <= y);
        (0..self.count()).filter_map(move |zone| {
            if self.is_single_row {
                let from = zone.checked_sub(1).and_then(|below| self.edges.get(below));
                let to = self.edges.get(zone).copied().unwrap_or(self.width);
                Some((zone, (to - from.copied().unwrap_or_default()) / self.width))
            } else {
                (zone == own).then_some((zone, 1.0))
            }
        })
    }
}

impl LoadMap {
    /// ξ̄ = ∫ ξ dP/∫ dP, ln f̄ = ∫ ln f dP/∫ dP over each of K cells, dP = f |V_s| dl   [Cell-1]
    ///
    /// The cells span the loaded part of the path. The pitch point is an edge of a cell, and on spur pairs and pairs of
    /// little overlap so are the changes of the number of pairs in contact. Cells without sliding power are omitted.
    ///
    /// # Errors
    /// When `count` is less than the number of segments of the path, or above 10 000.
    pub fn cells(&self, count: usize) -> Result<Vec<LoadCell>, GearError> {
        self.cells_in_zones(count, &[])
    }

    /// Cells for each zone of the face, zone by zone within a cell. `edges` are the positions y between the zones, in
    /// ascending order and within the face.
    ///
    /// A point of the map belongs to the zone of its y. A point that represents the whole face of a spur pair is
    /// divided between the zones by their widths.
    ///
    /// # Errors
    /// As [`cells`](Self::cells), and when the edges are not within the face or not in ascending order.
    pub fn cells_in_zones(
        &self,
        count: usize,
        edges: &[Length],
    ) -> Result<Vec<LoadCell>, GearError> {
        cite!("Cell-1");
        let zones = Zones::new(edges, self.pair.face_width, self.is_single_row())?;
        let breaks = self.cell_breaks();
        let least = breaks.len() - 1;
        if !(least..=MAX_CELLS).contains(&count) {
            return Err(GearError::position_count(count, least, MAX_CELLS));
        }
        let edges = self.cell_edges(count, &breaks);
        let each = zones.count();
        let mut sums = vec![CellSums::default(); (edges.len() - 1) * each];
        for sample in &self.samples {
            let above = edges.partition_point(|edge| *edge <= sample.xi);
            let cell = above.clamp(1, edges.len() - 1) - 1;
            let power = self.sliding_weight(sample);
            for (zone, share) in zones.shares(sample.y) {
                sums[cell * each + zone].add(sample, power, share);
            }
        }
        let total = self.loss_factor * self.torque;
        let cells = sums.iter().enumerate();
        let cells = cells.map(|(k, sums)| ([k / each, k % each], sums, &edges[k / each..]));
        Ok(cells
            .filter(|(_, sums, _)| sums.power > 0.0)
            .map(|([number, zone], sums, ends)| {
                let (xi, log) = (sums.xi / sums.power, sums.log / sums.power);
                LoadCell {
                    from: ends[0],
                    to: ends[1],
                    xi,
                    s: self.pair.path.place(xi),
                    load: LineLoad::from_si(log.exp()),
                    loss_factor: sums.power / self.torque,
                    sliding_share: sums.power / total,
                    contact_length: Length::from_si(sums.length),
                    force: Force::from_si(sums.force),
                    number,
                    zone,
                }
            })
            .collect())
    }

    /// Whether one point represents the whole face.
    fn is_single_row(&self) -> bool {
        match &self.model {
            LoadModel::Elastic(grid, _) => grid.cells == 1,
            LoadModel::Rigid(_) | LoadModel::Table(_) => self.pair.is_spur(),
        }
    }

    /// Ends of the loaded path, the pitch point, and the changes of the number of pairs in contact.
    fn cell_breaks(&self) -> Vec<f64> {
        let loaded = || self.samples.iter().filter(|sample| sample.load.si() > 0.0);
        let [mut low, mut high] = range(loaded().map(|at| at.xi));
        // The outermost samples lie inside the ends of a fully loaded path.
        let eps_alpha = self.pair.path.eps_alpha;
        let slack = 1.0 / 16.0;
        if low > 0.0 && low < slack {
            low = 0.0;
        }
        if high < eps_alpha && high > eps_alpha - slack {
            high = eps_alpha;
        }
        let mut inner = self.pair.segment_ends();
        inner.push(self.pair.path.eps_2);
        // With little overlap the load changes almost as abruptly as on a spur pair.
        if self.pair.path.eps_beta < NARROW_OVERLAP {
            inner.extend(self.pair.changes_of_contact());
        }
        breakpoints(low, high, inner)
    }

    fn cell_edges(&self, count: usize, breaks: &[f64]) -> Vec<f64> {
        let (low, high) = (breaks[0], breaks[breaks.len() - 1]);
        let pitch_point = self.pair.path.eps_2;
        let middle = breaks.iter().position(|edge| *edge == pitch_point);
        let shares = match middle {
            Some(at) if at > 0 && at < breaks.len() - 1 => {
                let wanted = count as f64 * (pitch_point - low) / (high - low);
                let above = breaks.len() - 1 - at;
                let below = (wanted.round() as usize).clamp(at, count - above);
                let mut shares = distribute(below, &breaks[..=at]);
                shares.extend(distribute(count - below, &breaks[at..]));
                shares
            }
            _ => distribute(count, breaks),
        };
        let mut edges = vec![low];
        for (ends, share) in breaks.windows(2).zip(shares) {
            edges.extend(
                (1..share).map(|k| ends[0] + (ends[1] - ends[0]) * k as f64 / share as f64),
            );
            edges.push(ends[1]);
        }
        edges
    }

    /// Line load at a position of the path, averaged over the face and interpolated linearly along the contact lines,
    /// for display; zero if relief separates the flanks.
    ///
    /// # Errors
    /// When s is not on the path A to E.
    pub fn mean_line_load(&self, s: Length) -> Result<LineLoad, GearError> {
        let xi = self.pair.path.coordinate_on_path(s)?;
        let eps_beta = self.pair.path.eps_beta;
        if self.pair.is_spur() {
            let points = self.points_at(xi.rem_euclid(1.0))?;
            let here = || points.iter().filter(|point| (point.xi - xi).abs() < 1e-6);
            let length: f64 = here().map(|point| point.length).sum();
            let force: f64 = here().map(|point| point.length * point.load).sum();
            // At E the pair has left contact; use the limit from inside the path.
            return if length > 0.0 {
                Ok(LineLoad::from_si(force / length))
            } else {
                self.mean_line_load(self.pair.path.place(xi - 1e-9))
            };
        }
        let mut sum = 0.0;
        for k in 0..DISPLAY_PHASES {
            let across = (f64::from(k) + 0.5) / f64::from(DISPLAY_PHASES);
            let front = xi - eps_beta * across;
            let (tooth, phase) = (front.floor() as i64, front.rem_euclid(1.0));
            let points = self.points_at(phase)?;
            let line = points.iter().filter(|point| point.tooth == tooth);
            sum += between_neighbours(xi, line.map(|point| (point.xi, point.load)));
        }
        Ok(LineLoad::from_si(sum / f64::from(DISPLAY_PHASES)))
    }

    /// K_Hβ = largest over mean load per width of the face, in 16 strips           [Width-1]
    ///
    /// 1 for a spur pair with constant load over the face.
    pub fn face_load_factor(&self) -> f64 {
        cite!("Width-1");
        if self.is_single_row() {
            return 1.0;
        }
        let mut strips = [0.0; FACE_STRIPS];
        for sample in &self.samples {
            let across = sample.y / self.pair.face_width * FACE_STRIPS as f64;
            let strip = (across.max(0.0) as usize).min(FACE_STRIPS - 1);
            strips[strip] += sample.weight.si() * sample.load.si();
        }
        let mean = strips.iter().sum::<f64>() / FACE_STRIPS as f64;
        strips.iter().copied().fold(0.0, f64::max) / mean
    }
}

/// Linear interpolation at `position` between the neighbours among unordered `points` (position, value), constant
/// beyond the outermost; zero without points.
fn between_neighbours(position: f64, points: impl Iterator<Item = (f64, f64)>) -> f64 {
    let (mut below, mut above) = (None::<(f64, f64)>, None::<(f64, f64)>);
    for point in points {
        match point.0 <= position {
            true if below.is_none_or(|at| at.0 <= point.0) => below = Some(point),
            false if above.is_none_or(|at| at.0 > point.0) => above = Some(point),
            _ => {}
        }
    }
    interpolate_between(below, above, position)
}

#[cfg(test)]
mod tests {
    use super::between_neighbours;

    #[test]
    fn a_place_between_two_points_has_a_load_between_theirs() {
        let at =
            |place| between_neighbours(place, [(2.0, 5.0), (0.0, 1.0), (1.0, 4.0)].into_iter());
        let found = [-1.0, 0.0, 0.5, 1.0, 1.75, 2.0, 3.0].map(at);
        assert_eq!(found, [1.0, 1.0, 2.5, 4.0, 4.75, 5.0, 5.0]);
        assert_eq!(between_neighbours(0.0, std::iter::empty()), 0.0);
    }
}
