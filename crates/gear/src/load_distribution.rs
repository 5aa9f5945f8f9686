//! Distribution of the load over the teeth as an extension point: the laws of this crate and any law of
//! a user's own.
//!
//! Every [`LoadSharing`] of a case file is one. A law gives the load per length of contact line at a
//! place on the path of contact; its loss factors follow from that unless it knows them better.

use std::fmt::Debug;
use std::sync::Arc;

use asperity_core::quantity::{AngularSpeed, Length, LineLoad, Torque};

use crate::error::GearError;
use crate::load_sharing::LoadSharing;
use crate::loss_factor::LossFactors;
use crate::pair::GearPair;
use crate::positions::PositionRule;

/// Positions along the path at which the loss factor of a law of one's own is integrated.
const LOSS_FACTOR_POSITIONS: usize = 256;

/// Law of the load along the contact lines.
///
/// ```
/// use asperity_core::quantity::{Length, LineLoad, Torque};
/// use asperity_gear::{GearError, GearPair, GearPairInput, LoadDistribution, LoadSharing};
///
/// /// The equal sharing of a spur pair, with a tenth of it taken off by tip relief at both ends.
/// #[derive(Debug)]
/// struct Relieved;
///
/// impl LoadDistribution for Relieved {
///     fn name(&self) -> &str {
///         "relieved"
///     }
///
///     fn line_load(&self, pair: &GearPair, s: Length, torque: Torque) -> Result<LineLoad, GearError> {
///         let path = pair.path();
///         let place = (s - path.a) / (path.e - path.a);
///         let share = if (0.1..=0.9).contains(&place) { 1.0 } else { 0.9 };
///         Ok(pair.line_load(s, torque, &LoadSharing::Uniform)? * share)
///     }
/// }
///
/// let pair = GearPair::new(&GearPairInput::standard(
///     [50, 120], "1.3 mm".parse()?, "0 deg".parse()?, "50 mm".parse()?,
/// ))?;
/// let relieved = Relieved.loss_factors(&pair)?.local;
/// assert!(relieved < pair.loss_factors(&LoadSharing::Uniform)?.local);
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
pub trait LoadDistribution: Debug + Send + Sync {
    /// Name, as results print it.
    fn name(&self) -> &str;

    /// Load per length of contact line at the place `s` on the path of contact, for the torque at gear 1.
    ///
    /// # Errors
    /// When s is not on the path or the law does not hold for this pair.
    fn line_load(&self, pair: &GearPair, s: Length, torque: Torque) -> Result<LineLoad, GearError>;

    /// Loss factors with this load; `local` is integrated over [`Self::line_load`] at a torque of 1 N m,
    /// which is right where the load is proportional to the torque.
    ///
    /// # Errors
    /// As [`Self::line_load`].
    fn loss_factors(&self, pair: &GearPair) -> Result<LossFactors, GearError> {
        let (torque, speed) = (Torque::from_si(1.0), AngularSpeed::from_si(1.0));
        let mut local = 0.0;
        for place in pair.positions(LOSS_FACTOR_POSITIONS, PositionRule::default())? {
            let load = self.line_load(pair, place.s, torque)?.si();
            let sliding = pair.kinematics(place.s, speed)?.sliding.si().abs();
            local += place.weight.si() * load * sliding / (torque.si() * speed.si());
        }
        Ok(LossFactors {
            ohlendorf: pair.ohlendorf_loss_factor(),
            local,
            local_phase_averaged: local,
        })
    }
}

impl LoadDistribution for LoadSharing {
    fn name(&self) -> &str {
        LoadSharing::name(self)
    }

    fn line_load(&self, pair: &GearPair, s: Length, torque: Torque) -> Result<LineLoad, GearError> {
        pair.line_load(s, torque, self)
    }

    fn loss_factors(&self, pair: &GearPair) -> Result<LossFactors, GearError> {
        pair.loss_factors(self)
    }
}

impl From<LoadSharing> for Arc<dyn LoadDistribution> {
    fn from(law: LoadSharing) -> Self {
        Arc::new(law)
    }
}
