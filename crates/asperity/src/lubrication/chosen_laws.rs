//! Laws that one run uses, looked up once.

use std::sync::Arc;

use asperity_ehl_regime::FilmThicknessLaw;
use asperity_tribo_friction::FilmFriction;

use asperity_case::case::{OperatingCase, ShareLaw};

/// Every law of a run.
#[derive(Debug, Clone)]
pub(crate) struct ChosenLaws {
    pub film: Arc<dyn FilmThicknessLaw>,
    pub friction: Arc<dyn FilmFriction>,
    pub load_share: ShareLaw,
}

impl ChosenLaws {
    /// The laws of `case`.
    pub(crate) fn from_case(case: &OperatingCase) -> Self {
        Self {
            film: case.film_law(),
            friction: case.film_friction(),
            load_share: case.share_law(),
        }
    }
}
