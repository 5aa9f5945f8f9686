//! Open pores on a finished flank of sintered steel: a model, not a measurement.
//!
//! Open pores are discs at random positions on the surface, which may overlap; the trace crosses them at random
//! offsets. Each is a bowl with a given ratio of depth to diameter. The volume fraction of pores in a body equals the
//! area fraction on its sections (principle of Delesse, 1847) and the length fraction on lines in them: the mean
//! fraction along the trace is the porosity.
//!
//! | symbol | meaning | unit |
//! |---|---|---|
//! | P | mean fraction of the trace in pores | - |
//! | D, c | diameter of a pore, chord along which the trace crosses it | m |
//! | n | number of pores crossed per length | 1/m |

use asperity_core::cite;
use asperity_core::quantity::Length;
use asperity_core::{DomainError, Profile};
use serde::{Deserialize, Serialize};

use super::random::Random;

/// Smallest and largest diameter divided by the mean; diameters are uniformly distributed between them.
const SPREAD: [f64; 2] = [0.5, 1.5];
/// Mean chord of the pores on a line divided by the mean diameter: π/4·⟨D²⟩/⟨D⟩² of this distribution.
const MEAN_CHORD: f64 = std::f64::consts::FRAC_PI_4 * (13.0 / 12.0);
/// Maximum porosity of the model.
const MAX_POROSITY: f64 = 0.5;
/// Maximum number of pores on a trace.
const MAX_PORES: f64 = 1e6;

/// Open pores at random positions, with 0.5 to 1.5 times the mean diameter.
#[derive(Debug, Clone, Copy, PartialEq, Serialize, Deserialize)]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
#[serde(rename_all = "kebab-case", deny_unknown_fields)]
pub struct Pores {
    /// Porosity of the flank: mean fraction of the trace in pores.
    pub porosity: f64,
    /// Mean diameter of the pores on the surface.
    pub diameter: Length,
    /// Ratio of depth to diameter of a pore.
    pub depth_ratio: f64,
    /// Seed of positions and sizes.
    pub seed: u64,
}

impl Pores {
    /// n = −ln(1 − P)/⟨c⟩, ⟨c⟩ = π/4·⟨D²⟩/⟨D⟩; z(x) − d·(1 − (2(x − x_c)/c)²) in a pore        [Pore-1]
    ///
    /// In overlapping pores the greater depth applies. The chord at the offset t·D/2 from the middle is c = D √(1 −
    /// t²), its depth d = r·D·(1 − t²).
    ///
    /// # Errors
    /// When the porosity is negative or not below one half, the diameter not positive, the depth ratio outside 0 to 1
    /// (a stylus cannot trace such steep walls), or there are more than a million pores.
    ///
    /// ```
    /// use asperity_core::{Profile, quantity::Length};
    /// use asperity_roughness::generate::Pores;
    /// let flat = Profile::new(Length::from_si(0.5e-6), vec![0.0; 200_000])?;
    /// let pores = Pores { porosity: 0.1, diameter: "20 um".parse()?, depth_ratio: 0.25, seed: 1 };
    /// let porous = pores.add_to(&flat)?;
    /// let open = porous.heights().iter().filter(|z| **z < 0.0).count() as f64 / 200_000.0;
    /// assert!((open - 0.1).abs() < 0.02);
    /// # Ok::<(), Box<dyn std::error::Error>>(())
    /// ```
    pub fn add_to(&self, profile: &Profile) -> Result<Profile, DomainError> {
        cite!("Pore-1");
        let porosity = DomainError::require(
            (0.0..MAX_POROSITY).contains(&self.porosity),
            "porosity",
            self.porosity,
            "-",
            "must not be negative, and below 0.5",
        )?;
        let mean = DomainError::positive("diameter", self.diameter)?;
        let ratio = DomainError::require(
            (0.0..=1.0).contains(&self.depth_ratio),
            "depth ratio",
            self.depth_ratio,
            "-",
            "must lie from 0 to 1",
        )?;
        if porosity == 0.0 {
            return Ok(profile.clone());
        }
        let rate = -(-porosity).ln_1p() / (MEAN_CHORD * mean);
        // Pores centred beyond an end of the trace extend into it.
        let reach = 0.5 * SPREAD[1] * mean;
        let length = profile.length().si();
        DomainError::require(
            rate * (length + 2.0 * reach) <= MAX_PORES,
            "pores on the trace",
            rate * (length + 2.0 * reach),
            "-",
            "must not exceed 1000000",
        )?;
        let dx = profile.spacing().si();
        let mut depth = vec![0.0_f64; profile.len()];
        let mut random = Random::new(self.seed);
        let end = length + reach;
        let mut middle = -reach;
        loop {
            middle += -(-random.uniform()).ln_1p() / rate;
            if middle > end {
                break;
            }
            // The probability that a line crosses a disc is proportional to its diameter.
            let [low, high] = SPREAD.map(|edge| edge * edge);
            let diameter = mean * random.between(low, high).sqrt();
            let inner = 1.0 - random.uniform().powi(2);
            let half = 0.5 * diameter * inner.sqrt();
            let deepest = ratio * diameter * inner;
            let first = ((middle - half) / dx).ceil().max(0.0) as usize;
            let last = ((middle + half) / dx).floor();
            if last < 0.0 {
                continue;
            }
            let count = (last as usize).saturating_add(1);
            for (i, depth) in depth.iter_mut().enumerate().take(count).skip(first) {
                let along = (i as f64 * dx - middle) / half;
                *depth = depth.max(deepest * (1.0 - along * along));
            }
        }
        let heights = profile.heights().iter().zip(depth).map(|(z, d)| z - d);
        Profile::new(profile.spacing(), heights.collect())
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn open(porosity: f64, seed: u64) -> f64 {
        let flat = Profile::new(Length::from_si(0.5e-6), vec![0.0; 40_001]).unwrap();
        let pores = Pores {
            porosity,
            diameter: Length::from_si(20e-6),
            depth_ratio: 0.25,
            seed,
        };
        let porous = pores.add_to(&flat).unwrap();
        let z = porous.heights();
        assert!(z.iter().all(|z| (-7.5e-6..=0.0).contains(z)));
        z.iter().filter(|z| **z < 0.0).count() as f64 / z.len() as f64
    }

    #[test]
    fn the_share_of_the_trace_that_is_pore_is_the_porosity_in_the_mean() {
        const TRACES: u64 = 60;
        for porosity in [0.02, 0.1, 0.25] {
            let found: Vec<f64> = (1..=TRACES).map(|seed| open(porosity, seed)).collect();
            let mean = found.iter().sum::<f64>() / TRACES as f64;
            let variance = found.iter().map(|one| (one - mean).powi(2)).sum::<f64>();
            let error = (variance / (TRACES * (TRACES - 1)) as f64).sqrt();
            // Four standard errors of the mean of the seeds; the shares differ from trace to trace.
            assert!(
                (mean - porosity).abs() < 4.0 * error,
                "{porosity}: {mean} {error}"
            );
            assert!(error < 0.05 * porosity, "{porosity}: {error}");
        }
    }

    #[test]
    fn the_seed_makes_the_pores_and_no_porosity_makes_none() {
        assert_eq!(open(0.1, 7), open(0.1, 7));
        assert_ne!(open(0.1, 7), open(0.1, 8));
        assert_eq!(open(0.0, 1), 0.0);
        assert_eq!(open(-0.0, 1), 0.0);
    }

    #[test]
    fn impossible_pores_are_refused() {
        let flat = Profile::new(Length::from_si(1e-6), vec![0.0; 1000]).unwrap();
        let good = Pores {
            porosity: 0.1,
            diameter: Length::from_si(20e-6),
            depth_ratio: 0.25,
            seed: 1,
        };
        assert!(good.add_to(&flat).is_ok());
        for porosity in [-0.1, 0.5, f64::NAN] {
            assert!(Pores { porosity, ..good }.add_to(&flat).is_err());
        }
        for diameter in [0.0, f64::NAN, 1e-12] {
            let diameter = Length::from_si(diameter);
            assert!(Pores { diameter, ..good }.add_to(&flat).is_err());
        }
        for depth_ratio in [-0.1, 1.1, f64::NAN] {
            assert!(
                Pores {
                    depth_ratio,
                    ..good
                }
                .add_to(&flat)
                .is_err()
            );
        }
    }
}
