//! Damage added to a profile: pits and scratches.
//!
//! | symbol | meaning | unit |
//! |---|---|---|
//! | x_c | middle of a pit or scratch | m |
//! | w, d | width and depth of a pit or scratch | m |

use std::f64::consts::PI;

use asperity_core::cite;
use asperity_core::quantity::Length;
use asperity_core::{DomainError, Profile};
use serde::{Deserialize, Serialize};

use super::random::Random;

/// Maximum number of pits or scratches.
const MAX_FEATURES: usize = 1_000_000;

/// Pits at random positions, each with 0.5 to 1.5 times the stated width and depth.
#[derive(Debug, Clone, Copy, PartialEq, Serialize, Deserialize)]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
#[serde(rename_all = "kebab-case", deny_unknown_fields)]
pub struct Pits {
    /// Number of pits.
    pub count: usize,
    /// Mean width.
    pub width: Length,
    /// Mean depth.
    pub depth: Length,
    /// Seed of positions and sizes.
    pub seed: u64,
}

impl Pits {
    /// z(x) − d cos²(π (x − x_c)/w) for |x − x_c| < w/2, for each pit                 [Pit-1]
    ///
    /// # Errors
    /// When width or depth is not positive, or there are more than a million pits.
    ///
    /// ```
    /// use asperity_core::{Profile, quantity::Length};
    /// use asperity_roughness::generate::Pits;
    /// let flat = Profile::new(Length::from_si(1e-6), vec![0.0; 1000])?;
    /// let pits = Pits { count: 1, width: "50 um".parse()?, depth: "10 um".parse()?, seed: 1 };
    /// let damaged = pits.add_to(&flat)?;
    /// let deepest = damaged.heights().iter().cloned().fold(f64::MAX, f64::min);
    /// assert!(deepest < -4e-6 && deepest > -15e-6);
    /// # Ok::<(), Box<dyn std::error::Error>>(())
    /// ```
    pub fn add_to(&self, profile: &Profile) -> Result<Profile, DomainError> {
        cite!("Pit-1");
        add(
            profile,
            self.count,
            self.width,
            self.depth,
            self.seed,
            |u| (PI * u).cos().powi(2),
        )
    }
}

/// Scratches at random positions: V-shaped grooves with raised shoulders.
#[derive(Debug, Clone, Copy, PartialEq, Serialize, Deserialize)]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
#[serde(rename_all = "kebab-case", deny_unknown_fields)]
pub struct Scratches {
    /// Number of scratches.
    pub count: usize,
    /// Mean width including the shoulders.
    pub width: Length,
    /// Mean depth.
    pub depth: Length,
    /// Seed of positions and sizes.
    pub seed: u64,
}

impl Scratches {
    /// z(x) − d (1 − 4|u|) for |u| < 0.4, then linear to zero at |u| = ½, u = (x − x_c)/w   [Scratch-1]
    ///
    /// The shoulders at |u| = 0.4 are 0.6 d above the surface.
    ///
    /// # Errors
    /// When width or depth is not positive, or there are more than a million scratches.
    ///
    /// ```
    /// use asperity_core::{Profile, quantity::Length};
    /// use asperity_roughness::generate::Scratches;
    /// let flat = Profile::new(Length::from_si(0.1e-6), vec![0.0; 1000])?;
    /// let scratches = Scratches { count: 1, width: "20 um".parse()?, depth: "1 um".parse()?, seed: 2 };
    /// let scratched = scratches.add_to(&flat)?;
    /// assert!(scratched.heights().iter().any(|z| *z > 0.2e-6));
    /// # Ok::<(), Box<dyn std::error::Error>>(())
    /// ```
    pub fn add_to(&self, profile: &Profile) -> Result<Profile, DomainError> {
        cite!("Scratch-1");
        const SHOULDER: f64 = 0.4;
        add(
            profile,
            self.count,
            self.width,
            self.depth,
            self.seed,
            |u| {
                let u = u.abs();
                if u < SHOULDER {
                    1.0 - 4.0 * u
                } else {
                    (1.0 - 4.0 * SHOULDER) * (0.5 - u) / (0.5 - SHOULDER)
                }
            },
        )
    }
}

/// Subtracts `shape(u)` times the depth from the profile, −½ < u < ½, at random positions.
fn add(
    profile: &Profile,
    count: usize,
    width: Length,
    depth: Length,
    seed: u64,
    shape: impl Fn(f64) -> f64,
) -> Result<Profile, DomainError> {
    let mean_width = DomainError::positive("width", width)?;
    let mean_depth = DomainError::positive("depth", depth)?;
    DomainError::require(
        count <= MAX_FEATURES,
        "count",
        count as f64,
        "-",
        "must not exceed 1000000",
    )?;
    let dx = profile.spacing().si();
    let mut z = profile.heights().to_vec();
    let mut random = Random::new(seed);
    for _ in 0..count {
        let centre = random.between(0.0, profile.length().si());
        let width = mean_width * random.between(0.5, 1.5);
        let depth = mean_depth * random.between(0.5, 1.5);
        let first = ((centre - 0.5 * width) / dx).ceil().max(0.0) as usize;
        let last = ((centre + 0.5 * width) / dx).floor() as usize;
        for (i, z) in z
            .iter_mut()
            .enumerate()
            .take(last.saturating_add(1))
            .skip(first)
        {
            *z -= depth * shape((i as f64 * dx - centre) / width);
        }
    }
    Profile::new(profile.spacing(), z)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_pit_and_a_scratch_have_their_depth_and_area() {
        let flat = Profile::new(Length::from_si(0.01e-6), vec![0.0; 100_001]).unwrap();
        let (width, depth) = (Length::from_si(60e-6), Length::from_si(2e-6));
        // cos² covers half of width times depth; of a scratch, 0.25 less 0.15 in its shoulders.
        let pit = Pits {
            count: 1,
            width,
            depth,
            seed: 1,
        }
        .add_to(&flat)
        .unwrap();
        let scratch = Scratches {
            count: 1,
            width,
            depth,
            seed: 1,
        }
        .add_to(&flat)
        .unwrap();
        for (damaged, share) in [(pit, 0.5), (scratch, 0.1)] {
            let z = damaged.heights();
            let deepest = -z.iter().copied().fold(f64::INFINITY, f64::min);
            let count = z.iter().filter(|z| **z != 0.0).count();
            let area = -z.iter().sum::<f64>();
            assert!((1e-6..3e-6).contains(&deepest), "{deepest}");
            assert!((3000..9002).contains(&count), "{count}");
            // The sums have a few thousand points.
            assert!(
                (area / (deepest * count as f64) - share).abs() < 1e-3,
                "{share} {area}"
            );
        }
    }
}
