//! Surrogates: profiles for a flank of which only the finish and roughness values are known.
//!
//! The values leave the shape of the texture open, so it differs from surrogate to surrogate. Ranges of the shape are
//! assumed: ground and superfinished gear flanks measured with a stylus lie within them.
//!
//! | symbol | meaning | unit |
//! |---|---|---|
//! | z_g, z_b | grooves of the grits and self-affine background, each of unit Rq | - |
//! | r | ratio of their Rq, 0.5 to 3 | - |
//! | k, n | number of the surrogate from 0, and of all | - |
//! | u_d(k) | place of surrogate k in the range of dimension d of the shape, 0 to 1 | - |
//! | ρ_d(k) | rank of k in an order drawn for d, in which the first is in the middle | - |

use asperity_core::cite;
use asperity_core::quantity::Length;
use asperity_core::{DomainError, Profile};

use super::ground::Ground;
use super::random::Random;
use super::self_affine::SelfAffine;
use crate::error::RoughnessError;
use crate::form::Form;
use crate::gaussian_filter::Ends;
use crate::height_parameters::Mode;
use crate::parameters::Parameters;
use crate::preparation::{Preparation, prepare};

/// A machined finish with a recipe.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
#[non_exhaustive]
pub enum Finish {
    /// Grooves of grits on a self-affine background.
    Ground,
    /// A self-affine texture: the grooves are polished away.
    Superfinished,
}

impl Finish {
    /// Its name.
    #[must_use]
    pub const fn name(self) -> &'static str {
        match self {
            Self::Ground => "ground",
            Self::Superfinished => "superfinished",
        }
    }
}

/// Recipe of a surrogate.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Surrogate {
    /// Finish of the flank.
    pub finish: Finish,
    /// Number from 0, and count of all surrogates; together they fix the shape.
    pub number: [usize; 2],
    /// Flank of the pair, which has the shape of the other one and heights of its own.
    pub body: usize,
    /// Length after filtering.
    pub length: Length,
    /// Distance between points.
    pub spacing: Length,
    /// Cut-off λs of the stated values; if it is not known, each number has one of its own.
    pub lambda_s: Option<Length>,
    /// Cut-off λc of the stated values; `None` for no filter.
    pub lambda_c: Option<Length>,
}

/// Range of the cut-off λs of values without one, from a fine to a coarse stylus.
pub const LAMBDA_S: [Length; 2] = [Length::from_si(2.5e-6), Length::from_si(25e-6)];

/// First seed; other profiles of the project have small ones.
const FIRST_SEED: u64 = 0x5EED_0000;

impl Surrogate {
    /// Filtered profile and its parameters, with heights of no particular size: they are to be scaled.
    ///
    /// ```text
    /// z = r z_g + z_b (ground),  z = z_b (superfinished)                         [Surrogate-1]
    /// ```
    ///
    /// # Errors
    /// When a length is not positive, the number is not below the count, or the profile cannot be filtered.
    ///
    /// ```
    /// use asperity_core::quantity::Length;
    /// use asperity_roughness::generate::{Finish, Surrogate};
    /// let recipe = Surrogate {
    ///     finish: Finish::Ground, number: [0, 12], body: 0, length: Length::from_si(3e-3), spacing: Length::from_si(0.5e-6),
    ///     lambda_s: None, lambda_c: Some(Length::from_si(0.25e-3)),
    /// };
    /// let (profile, parameters) = recipe.generate()?;
    /// assert!((profile.length().si() - 3e-3).abs() < 1e-6);
    /// let ratio = parameters.heights.rz.si() / parameters.heights.ra.si();
    /// assert!(ratio > 4.0 && ratio < 9.0);
    /// # Ok::<(), asperity_roughness::RoughnessError>(())
    /// ```
    pub fn generate(&self) -> Result<(Profile, Parameters), RoughnessError> {
        cite!("Surrogate-1");
        const UNIT: Length = Length::from_si(1e-6);
        let [number, count] = self.number;
        let rule = "must be below the number of all";
        DomainError::require(
            number < count,
            "number of the surrogate",
            number as f64,
            "-",
            rule,
        )?;
        let [dx, lambda_s] = [self.spacing, self.lambda_s()];
        let dropped = self.lambda_c.unwrap_or_default();
        let points = (((self.length + dropped) / dx).round() as usize).saturating_add(1);
        let seed = FIRST_SEED + 4 * self.number[0] as u64 + 2 * self.body as u64;
        let background = SelfAffine {
            points,
            spacing: dx,
            rq: UNIT,
            hurst: self.between(3, 0.6, 0.9),
            roll_off: Length::from_si(self.on_logarithm(2, 30e-6, 150e-6)),
            // Shorter waves are the part of the filter.
            short_cut: Length::from_si((0.5 * lambda_s.si()).max(2.0 * dx.si())),
            seed,
        };
        let mut heights = background.generate()?.into_heights();
        if self.finish == Finish::Ground {
            let grooves = Ground {
                points,
                spacing: dx,
                rq: UNIT * self.on_logarithm(1, 0.5, 3.0),
                grit_spacing: Length::from_si(self.on_logarithm(0, 6e-6, 20e-6)),
                grit_radius: Length::from_si(60e-6),
                grit_protrusion: Length::from_si(0.5e-6),
                seed: seed + 1,
            };
            let grooves = grooves.generate()?;
            (heights.iter_mut().zip(grooves.heights())).for_each(|(z, groove)| *z += groove);
        }
        let filters = Preparation {
            form: Form::Mean,
            lambda_s: Some(Length::from_si(lambda_s.si().max(dx.si()))),
            lambda_c: self.lambda_c,
            ends: Ends::Cut,
        };
        let profile = prepare(&Profile::new(dx, heights)?, &filters)?.profile;
        let section = self.lambda_c.unwrap_or_else(|| profile.length() / 5.0);
        let parameters = Parameters::from_profile(&profile, Mode::Iso4287, section)?;
        Ok((profile, parameters))
    }

    /// The stated cut-off λs, or the cut-off of this number.
    #[must_use]
    pub fn lambda_s(&self) -> Length {
        let [low, high] = LAMBDA_S.map(Length::si);
        let drawn = || Length::from_si(self.on_logarithm(4, low, high));
        self.lambda_s.unwrap_or_else(drawn)
    }

    /// u_d(k) = (ρ_d(k) + ½)/n                                                    [Surrogate-2]
    ///
    /// A Latin hypercube: few surrogates fill the range of every dimension evenly, and the first is in the middle of all.
    fn place(&self, dimension: u64) -> f64 {
        cite!("Surrogate-2");
        let [number, count] = self.number;
        let mut random = Random::new(FIRST_SEED + dimension);
        let keys: Vec<f64> = (0..count).map(|_| random.uniform()).collect();
        let rank = |k: usize| keys.iter().filter(|key| Some(*key) < keys.get(k)).count();
        let middle = count / 2;
        let rank = match (number, rank(number)) {
            (0, _) => middle,
            (_, own) if own == middle => rank(0),
            (_, own) => own,
        };
        (rank as f64 + 0.5) / count as f64
    }

    fn between(&self, dimension: u64, low: f64, high: f64) -> f64 {
        low + (high - low) * self.place(dimension)
    }

    fn on_logarithm(&self, dimension: u64, low: f64, high: f64) -> f64 {
        low * (high / low).powf(self.place(dimension))
    }
}
