//! Mesh positions along the path of contact, with weights for means over a mesh cycle.
//!
//! | symbol | meaning | unit |
//! |---|---|---|
//! | s | distance from T₁ along the line of action | m |
//! | g | any quantity per metre of contact line | |
//! | w | weight of a position | m |
//!
//! The positions are distributed over the segments on which the integrands are smooth. The sliding speed has a kink
//! at C; on a spur pair the load shares jump where another pair enters or leaves, at A + k·p_et and
//! E − k·p_et (B and D when 1 < ε_α < 2).

use std::num::NonZeroUsize;

use asperity_core::cite;
use asperity_core::quantity::Length;
use serde::{Deserialize, Serialize};

use crate::error::GearError;
use crate::pair::GearPair;
use crate::quadrature::{breakpoints, gauss_legendre};

/// Maximum number of positions: more than any mesh requires.
const MAX_POSITIONS: usize = 100_000;

/// Distribution of positions within a segment.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default, Serialize, Deserialize)]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
#[serde(rename_all = "kebab-case", deny_unknown_fields)]
pub enum PositionRule {
    /// Gauss-Legendre points: the most accurate means.
    #[default]
    GaussLegendre,
    /// Midpoints of equal parts: evenly spaced results.
    Midpoint,
}

/// A position on the path of contact.
#[derive(Debug, Clone, Copy, PartialEq, Serialize)]
pub struct MeshPosition {
    /// Distance from T₁ along the line of action.
    pub s: Length,
    /// Profile coordinate ξ in base pitches from A.
    pub xi: f64,
    /// Weight in a mean over the mesh cycle: the length of contact line that the position represents.
    pub weight: Length,
}

impl GearPair {
    /// Positions and weights of the mean over a mesh cycle.
    ///
    /// ```text
    /// ḡ = (b/(cos β_b p_et))·∫_A^E g ds ≈ Σ w_i g(s_i)                            [Mean-1]
    /// ```
    ///
    /// This is the mean over a mesh cycle of the sum of g over all lines of contact. The weights
    /// sum to the mean length of the contact lines.
    ///
    /// # Errors
    /// When `count` is less than the number of segments of the path, or above 100 000.
    ///
    /// ```
    /// use asperity_gear::{GearPair, GearPairInput, PositionRule};
    /// let pair = GearPair::new(&GearPairInput::standard(
    ///     [50, 120], "1.3 mm".parse()?, "30 deg".parse()?, "50 mm".parse()?,
    /// ))?;
    /// let positions = pair.positions(32, PositionRule::GaussLegendre)?;
    /// let total: f64 = positions.iter().map(|position| position.weight.si()).sum();
    /// assert!((total - pair.mean_contact_length().si()).abs() < 1e-15);
    /// # Ok::<(), Box<dyn std::error::Error>>(())
    /// ```
    pub fn positions(
        &self,
        count: usize,
        rule: PositionRule,
    ) -> Result<Vec<MeshPosition>, GearError> {
        cite!("Mean-1");
        let breaks = self.segment_ends();
        let least = breaks.len() - 1;
        if !(least..=MAX_POSITIONS).contains(&count) {
            return Err(GearError::position_count(count, least, MAX_POSITIONS));
        }
        let per_length = self.contact_per_coordinate();
        let mut positions = Vec::with_capacity(count);
        for (ends, share) in breaks.windows(2).zip(distribute(count, &breaks)) {
            let width = ends[1] - ends[0];
            for (node, weight) in nodes(rule, share) {
                let xi = ends[0] + width * node;
                positions.push(MeshPosition {
                    s: self.path.place(xi),
                    xi,
                    weight: per_length * (width * weight),
                });
            }
        }
        Ok(positions)
    }

    /// A single position that represents the whole path.
    ///
    /// # Errors
    /// When s is not on the path A to E.
    ///
    /// ```
    /// use asperity_gear::{GearPair, GearPairInput};
    /// let pair = GearPair::new(&GearPairInput::standard(
    ///     [50, 120], "1.3 mm".parse()?, "30 deg".parse()?, "50 mm".parse()?,
    /// ))?;
    /// let position = pair.single_position(pair.path().c)?;
    /// assert_eq!(position.weight, pair.mean_contact_length());
    /// # Ok::<(), Box<dyn std::error::Error>>(())
    /// ```
    pub fn single_position(&self, s: Length) -> Result<MeshPosition, GearError> {
        Ok(MeshPosition {
            s,
            xi: self.path.coordinate_on_path(s)?,
            weight: self.mean_contact_length(),
        })
    }

    /// Mean over a mesh cycle of g summed over all lines of contact, `[Mean-1]`. g is per metre of contact line.
    ///
    /// # Errors
    /// As [`GearPair::positions`].
    ///
    /// ```
    /// use asperity_gear::{GearPair, GearPairInput};
    /// let pair = GearPair::new(&GearPairInput::standard(
    ///     [50, 120], "1.3 mm".parse()?, "30 deg".parse()?, "50 mm".parse()?,
    /// ))?;
    /// let length = pair.mean_over_mesh(32, |_| 1.0)?;
    /// assert!((length - pair.mean_contact_length().si()).abs() < 1e-15);
    /// # Ok::<(), Box<dyn std::error::Error>>(())
    /// ```
    pub fn mean_over_mesh(
        &self,
        count: usize,
        mut g: impl FnMut(&MeshPosition) -> f64,
    ) -> Result<f64, GearError> {
        let positions = self.positions(count, PositionRule::GaussLegendre)?;
        Ok(positions
            .iter()
            .map(|position| position.weight.si() * g(position))
            .sum())
    }

    /// b/cos β_b: contact line per base pitch of path, averaged over a mesh cycle.
    pub(crate) fn contact_per_coordinate(&self) -> Length {
        self.face_width / self.base_helix.si().cos()
    }

    /// Ends of the segments on which the integrands are smooth, as coordinates ξ from 0 to ε_α.
    pub(crate) fn segment_ends(&self) -> Vec<f64> {
        let eps_alpha = self.path.eps_alpha;
        let mut inner = vec![self.path.eps_2];
        if self.is_spur() {
            inner.extend(self.changes_of_contact());
        }
        breakpoints(0.0, eps_alpha, inner)
    }

    /// Coordinates at which another pair of teeth enters or leaves contact in a transverse section.
    pub(crate) fn changes_of_contact(&self) -> impl Iterator<Item = f64> + use<> {
        let eps_alpha = self.path.eps_alpha;
        let changes = 1..=eps_alpha.floor() as u32;
        changes.flat_map(move |k| [f64::from(k), eps_alpha - f64::from(k)])
    }
}

/// `count` points distributed over the segments in proportion to their widths, at least one each.
pub(crate) fn distribute(count: usize, breaks: &[f64]) -> Vec<usize> {
    let widths: Vec<f64> = breaks.windows(2).map(|ends| ends[1] - ends[0]).collect();
    let mut shares = vec![1; widths.len()];
    for _ in widths.len()..count {
        // In reverse order, because `max_by` returns the last maximum: of equally coarse segments the first is refined.
        let coarsest = (0..widths.len()).rev().max_by(|&i, &j| {
            let (i, j) = (widths[i] / shares[i] as f64, widths[j] / shares[j] as f64);
            i.total_cmp(&j)
        });
        if let Some(segment) = coarsest {
            shares[segment] += 1;
        }
    }
    shares
}

/// Nodes and weights on 0..1.
fn nodes(rule: PositionRule, count: usize) -> Vec<(f64, f64)> {
    match rule {
        PositionRule::GaussLegendre => {
            NonZeroUsize::new(count).map_or_else(Vec::new, gauss_legendre)
        }
        PositionRule::Midpoint => (0..count)
            .map(|k| ((k as f64 + 0.5) / count as f64, 1.0 / count as f64))
            .collect(),
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn places_are_spread_by_width_and_every_segment_has_one() {
        assert_eq!(distribute(10, &[0.0, 1.0, 2.0, 2.001]), [5, 4, 1]);
        assert_eq!(distribute(3, &[0.0, 1.0, 2.0, 2.001]), [1, 1, 1]);
    }
}
