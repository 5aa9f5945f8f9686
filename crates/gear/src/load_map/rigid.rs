//! Load over the lines of contact according to a law without deflections.
//!
//! | symbol | meaning | unit |
//! |---|---|---|
//! | v(ξ) | weight of the law | - |
//! | l(φ) | length of the contact lines at the phase φ | m |
//! | I(φ) | ∫ v dl over the lines of contact | m |

use std::num::NonZeroUsize;

use asperity_core::cite;

use super::law::LoadLaw;
use super::phases::strip_pieces;
use crate::error::GearError;
use crate::load_sharing::{LoadSharing, Weights};
use crate::pair::GearPair;
use crate::quadrature::gauss_legendre;

/// Integration points in a piece of a line of contact.
const ORDER: NonZeroUsize = NonZeroUsize::MIN.saturating_add(3);

/// Maximum length of a piece, in base pitches.
const LONGEST_PIECE: f64 = 0.125;

/// A law without deflections.
#[derive(Debug, Clone)]
pub(crate) struct RigidLaw {
    sharing: LoadSharing,
    /// Whether the load is evaluated at the mean length of the lines.
    mean_length: bool,
}

/// A point of a line of contact.
#[derive(Debug, Clone, Copy)]
pub(crate) struct LinePoint {
    pub(crate) tooth: i64,
    pub(crate) xi: f64,
    pub(crate) across: f64,
    /// Length of line that the point represents.
    pub(crate) length: f64,
    /// f.
    pub(crate) load: f64,
}

impl RigidLaw {
    pub(crate) fn new(law: &LoadLaw, pair: &GearPair) -> Result<Self, GearError> {
        let rigid = Self {
            sharing: law.sharing(),
            mean_length: matches!(law, LoadLaw::MeanLength),
        };
        pair.weights(&rigid.sharing)?;
        Ok(rigid)
    }

    /// Coordinates of the kinks of v.
    pub(crate) fn knots(&self, pair: &GearPair) -> Result<Vec<f64>, GearError> {
        Ok(pair.weights(&self.sharing)?.knots())
    }

    /// f = F_bn v(ξ)/I(φ), I = (b/(ε_β cos β_b))·Σ ∫ v dξ over the strips in contact, so that
    /// v = 1 gives F_bn/l(φ); a spur pair has F_bn R(ξ)/b                        [Load-map-2]
    ///
    /// The law mean-length has f of `[Load-1]` and `[Load-2]` at every phase.
    pub(crate) fn points(
        &self,
        pair: &GearPair,
        force: f64,
        phase: f64,
        marks: &[f64],
    ) -> Result<Vec<LinePoint>, GearError> {
        cite!("Load-map-2");
        let weights = pair.weights(&self.sharing)?;
        let mut points = lines(pair, phase, marks);
        if self.mean_length {
            for point in &mut points {
                point.load = force * pair.unit_line_load(&weights, point.xi);
            }
        } else {
            distribute_force(&mut points, &weights, force);
        }
        Ok(points)
    }
}

fn distribute_force(points: &mut [LinePoint], weights: &Weights<'_>, force: f64) {
    let mut all = 0.0;
    for point in points.iter_mut() {
        point.load = weights.at(point.xi);
        all += point.load * point.length;
    }
    for point in points {
        point.load *= force / all;
    }
}

/// Points on the lines of contact, without loads.
pub(crate) fn lines(pair: &GearPair, phase: f64, marks: &[f64]) -> Vec<LinePoint> {
    let eps_alpha = pair.path.eps_alpha;
    let per_face = pair.contact_per_coordinate().si();
    let mut points = Vec::new();
    if pair.is_spur() {
        let mut xi = phase;
        while xi < eps_alpha {
            points.push(LinePoint {
                tooth: (xi - phase).round() as i64,
                xi,
                across: 0.5,
                length: per_face,
                load: 0.0,
            });
            xi += 1.0;
        }
        return points;
    }
    let rule = gauss_legendre(ORDER);
    let eps_beta = pair.path.eps_beta;
    for (tooth, from, to) in pair.numbered_strips(phase) {
        for (low, high) in strip_pieces(from, to, marks, LONGEST_PIECE) {
            points.extend(rule.iter().map(|&(node, weight)| {
                let xi = low + (high - low) * node;
                LinePoint {
                    tooth,
                    xi,
                    across: (xi - phase - tooth as f64) / eps_beta,
                    length: per_face * weight * (high - low) / eps_beta,
                    load: 0.0,
                }
            }));
        }
    }
    points
}
