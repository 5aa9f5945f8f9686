//! Ground flanks, traced across the grinding lay.
//!
//! Each grit of the wheel cuts a parabolic groove; the surface is the lower envelope of all grooves. Cusps between
//! grooves point upwards, as on real ground steel.
//!
//! | symbol | meaning | unit |
//! |---|---|---|
//! | x_j, d_j | position along the trace and height of the tip of grit j | m |
//! | ρ | radius of the grits | m |

use asperity_core::cite;
use asperity_core::quantity::Length;
use asperity_core::{DomainError, Profile};
use serde::{Deserialize, Serialize};

use super::random::Random;
use super::scaling::{check_points, scaled};

/// Recipe of a ground profile.
#[derive(Debug, Clone, Copy, PartialEq, Serialize, Deserialize)]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
#[serde(rename_all = "kebab-case", deny_unknown_fields)]
pub struct Ground {
    /// Number of points.
    pub points: usize,
    /// Distance between points.
    pub spacing: Length,
    /// Root mean square height, to which the heights are scaled.
    pub rq: Length,
    /// Mean distance between grit tips along the trace.
    pub grit_spacing: Length,
    /// Radius of the grits before scaling.
    pub grit_radius: Length,
    /// Range of tip heights before scaling; tips are uniformly distributed over it.
    pub grit_protrusion: Length,
    /// Seed of positions and heights.
    pub seed: u64,
}

impl Ground {
    /// z(x) = min over j of ( d_j + (x − x_j)²/(2ρ) ), then centred and scaled to Rq    [Ground-1]
    ///
    /// # Errors
    /// When a length is not positive, or the trace has less than one grit or more than ten grits per point.
    ///
    /// ```
    /// use asperity_core::quantity::Length;
    /// use asperity_roughness::generate::Ground;
    /// let recipe = Ground {
    ///     points: 8000, spacing: Length::from_si(0.5e-6), rq: Length::from_si(0.4e-6),
    ///     grit_spacing: Length::from_si(12e-6), grit_radius: Length::from_si(60e-6),
    ///     grit_protrusion: Length::from_si(1e-6), seed: 3,
    /// };
    /// let profile = recipe.generate()?;
    /// let highest = profile.heights().iter().cloned().fold(f64::MIN, f64::max);
    /// assert!(highest > 0.4e-6);
    /// # Ok::<(), asperity_core::DomainError>(())
    /// ```
    pub fn generate(&self) -> Result<Profile, DomainError> {
        cite!("Ground-1");
        const MOST_PER_POINT: f64 = 10.0;
        let n = check_points(self.points)?;
        let dx = DomainError::positive("spacing", self.spacing)?;
        let pitch = DomainError::positive("grit spacing", self.grit_spacing)?;
        let radius = DomainError::positive("grit radius", self.grit_radius)?;
        let protrusion = DomainError::non_negative("grit protrusion", self.grit_protrusion)?;
        let length = n as f64 * dx;
        let grits = (length / pitch).round();
        let sensible = grits >= 1.0 && grits <= MOST_PER_POINT * n as f64;
        DomainError::require(
            sensible,
            "grits on the trace",
            grits,
            "-",
            "must be at least one and at most ten per point",
        )?;
        let mut random = Random::new(self.seed);
        let mut tips: Vec<(f64, f64)> = (0..grits as usize)
            .map(|_| (random.between(0.0, length), random.between(0.0, protrusion)))
            .collect();
        tips.sort_unstable_by(|a, b| a.0.total_cmp(&b.0));
        scaled(self.spacing, envelope(&tips, 0.5 / radius, n, dx), self.rq)
    }
}

/// min over j of (d_j + a (x − x_j)²) at n even points, in linear time: equal parabolas intersect once, so the envelope
/// is an ordered list of tips with the intersections between them (Felzenszwalb and Huttenlocher 2012).
fn envelope(tips: &[(f64, f64)], a: f64, n: usize, dx: f64) -> Vec<f64> {
    let crossing = |left: (f64, f64), right: (f64, f64)| {
        0.5 * (left.0 + right.0) + 0.5 * (right.1 - left.1) / (a * (right.0 - left.0))
    };
    // Tips on the envelope, each with the x at which its parabola begins.
    let mut visible: Vec<((f64, f64), f64)> = Vec::new();
    for &tip in tips {
        let mut from = f64::NEG_INFINITY;
        let mut hidden = false;
        while let Some(&(last, start)) = visible.last() {
            if tip.0 == last.0 {
                if tip.1 >= last.1 {
                    hidden = true;
                    break;
                }
                visible.pop();
                continue;
            }
            from = crossing(last, tip);
            if from > start {
                break;
            }
            visible.pop();
            from = f64::NEG_INFINITY;
        }
        if !hidden {
            visible.push((tip, from));
        }
    }
    let mut current = 0;
    (0..n)
        .map(|i| {
            let x = i as f64 * dx;
            while visible.get(current + 1).is_some_and(|next| next.1 <= x) {
                current += 1;
            }
            let (at, height) = visible[current].0;
            height + a * (x - at).powi(2)
        })
        .collect()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_envelope_is_the_least_of_all_grooves() {
        let mut random = Random::new(5);
        let mut tips: Vec<(f64, f64)> = (0..200)
            .map(|_| (random.between(0.0, 100.0), random.between(0.0, 3.0)))
            .collect();
        tips.push(tips[7]);
        tips.sort_unstable_by(|a, b| a.0.total_cmp(&b.0));
        for (i, fast) in envelope(&tips, 0.3, 500, 0.2).into_iter().enumerate() {
            let x = i as f64 * 0.2;
            let slow = tips
                .iter()
                .map(|(at, d)| d + 0.3 * (x - at).powi(2))
                .fold(f64::MAX, f64::min);
            assert_eq!(fast, slow, "at {x}");
        }
    }
}
