//! Tip edge contact: contact outside the path of contact, because loaded teeth touch early and separate late.
//!
//! Own derivation: gear 2 is rotated back from A, and the distance of its tip edge from the involute of gear 1 is
//! measured along the base circle. At E gears 1 and 2 are exchanged.
//!
//! | symbol | meaning | unit |
//! |---|---|---|
//! | u | distance outside the path, along the line of action | m |
//! | g | separation of edge and flank, along the transverse line of action | m |
//! | P, θ_P, r_P | the edge and its polar coordinates around O₁ | |
//!
//! Limits: external pairs.

use asperity_core::cite;
use asperity_core::quantity::Length;

use crate::error::GearError;
use crate::pair::GearPair;

/// Search range for tip edge contact beyond the ends of the path, in base pitches: under common loads it is within a
/// tenth.
pub(crate) const REACH: f64 = 0.2;

/// An end of the path of contact.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum PathEnd {
    /// A, where the tip of gear 2 enters.
    A,
    /// E, where the tip of gear 1 leaves.
    E,
}

/// The tip edges of a pair.
#[derive(Debug, Clone, Copy)]
pub(crate) struct TipGaps {
    edges: [TipEdge; 2],
    cos_base_helix: f64,
}

impl TipGaps {
    pub(crate) fn new(pair: &GearPair) -> Result<Self, GearError> {
        if pair.internal {
            return Err(GearError::edge_contact_of_ring());
        }
        cite!("Edge-1");
        Ok(Self {
            edges: [
                TipEdge::new(pair, PathEnd::A),
                TipEdge::new(pair, PathEnd::E),
            ],
            cos_base_helix: pair.base_helix.si().cos(),
        })
    }

    /// Separation normal to the flank at ξ; zero on the path.
    pub(crate) fn at(&self, pair: &GearPair, xi: f64) -> f64 {
        let pitch = pair.path.base_pitch.si();
        let beyond = xi - pair.path.eps_alpha;
        let [a, e] = &self.edges;
        if xi < 0.0 {
            a.gap(-xi * pitch) * self.cos_base_helix
        } else if beyond > 0.0 {
            e.gap(beyond * pitch) * self.cos_base_helix
        } else {
            0.0
        }
    }
}

/// A tip edge and its mating flank.
#[derive(Debug, Clone, Copy)]
struct TipEdge {
    distance: f64,
    flank_base: f64,
    edge_base: f64,
    edge_radius: f64,
    /// Polar angle of the edge about its own axis at the end of the path.
    start: f64,
    /// Polar angle of the start of the involute at the end of the path.
    involute_start: f64,
}

impl TipEdge {
    fn new(pair: &GearPair, end: PathEnd) -> Self {
        let [rb1, rb2] = pair.base_radius.map(Length::si);
        let [ra1, ra2] = pair.tip_radius.map(Length::si);
        let path = &pair.path;
        let (flank_base, edge_base, edge_radius, roll) = match end {
            PathEnd::A => (rb1, rb2, ra2, path.a.si()),
            PathEnd::E => (rb2, rb1, ra1, (path.t1t2 - path.e).si()),
        };
        let tangent = -pair.working_pressure_angle.si();
        let (sin, cos) = tangent.sin_cos();
        let a = pair.centre_distance.si();
        let (x, y) = (flank_base * cos - roll * sin, flank_base * sin + roll * cos);
        let t = roll / flank_base;
        Self {
            distance: a,
            flank_base,
            edge_base,
            edge_radius,
            start: y.atan2(x - a),
            involute_start: tangent + t,
        }
    }

    /// g = r_b1·(θ_P + inv(arccos(r_b1/r_P)) − θ_b)                              [Edge-1]
    fn gap(&self, beyond: f64) -> f64 {
        let turned = self.start + beyond / self.edge_base;
        let (sin, cos) = turned.sin_cos();
        let (x, y) = (
            self.distance + self.edge_radius * cos,
            self.edge_radius * sin,
        );
        let radius = x.hypot(y);
        let pressure = (self.flank_base / radius).min(1.0).acos();
        let flank = self.involute_start - beyond / self.flank_base;
        self.flank_base * (y.atan2(x) + pressure.tan() - pressure - flank)
    }
}

impl GearPair {
    /// Separation of a tip edge from the mating flank, along the transverse line of action, at the distance `beyond`
    /// outside an end of the path of contact.
    ///
    /// # Errors
    /// For a ring.
    ///
    /// ```
    /// use asperity_gear::{GearPair, GearPairInput, edge_contact::PathEnd};
    /// let pair = GearPair::new(&GearPairInput::standard(
    ///     [23, 68], "1.8 mm".parse()?, "23.4 deg".parse()?, "32 mm".parse()?,
    /// ))?;
    /// let gap = pair.tip_gap(PathEnd::A, "0.2 mm".parse()?)?;
    /// assert!(gap.si() > 1e-6 && gap.si() < 10e-6);
    /// # Ok::<(), Box<dyn std::error::Error>>(())
    /// ```
    pub fn tip_gap(&self, end: PathEnd, beyond: Length) -> Result<Length, GearError> {
        let gaps = TipGaps::new(self)?;
        let [a, e] = gaps.edges;
        let edge = if end == PathEnd::A { a } else { e };
        Ok(Length::from_si(edge.gap(beyond.si())))
    }
}
