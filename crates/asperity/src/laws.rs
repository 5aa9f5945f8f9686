//! Laws of a user's own in place of those that the case file names.

use std::sync::Arc;

use asperity_ehl_regime::FilmThicknessLaw;
use asperity_gear::LoadDistribution;
use asperity_tribo_friction::FilmFriction;

use crate::load_share_law::LoadShare;

/// Laws of a user's own; where there is none, the case's own choice holds.
#[derive(Debug, Clone, Default)]
#[non_exhaustive]
pub struct Laws {
    /// Smooth film thickness, in place of `model.film`.
    pub film: Option<Arc<dyn FilmThicknessLaw>>,
    /// Friction in the film, in place of `model.friction`.
    pub friction: Option<Arc<dyn FilmFriction>>,
    /// Load over the teeth, in place of `model.load_sharing`.
    pub load_distribution: Option<Arc<dyn LoadDistribution>>,
    /// Film against asperities, in place of `model.load_share`.
    pub load_share: Option<Arc<dyn LoadShare>>,
}
