//! User-defined laws that replace those of the case file.
//!
//! ```
//! use std::{path::Path, sync::Arc};
//!
//! use asperity_core::Checked;
//! use asperity_tribo_friction::{FilmContact, FilmFriction, FilmTraction, FrictionError};
//!
//! /// Limiting shear stress: 3 % of the pressure, and 1 MPa over the whole contact.
//! #[derive(Debug)]
//! struct Limit;
//!
//! impl FilmFriction for Limit {
//!     fn name(&self) -> &str {
//!         "limit"
//!     }
//!
//!     fn traction(&self, at: &FilmContact<'_>) -> Result<Checked<FilmTraction>, FrictionError> {
//!         let width = 2.0 * at.half_width.si();
//!         let coefficient = 0.03 + 1e6 * width / at.position.load.si();
//!         Ok(Checked::inside(FilmTraction::from_coefficient(coefficient)))
//!     }
//! }
//!
//! let file = Path::new("../../fixtures/cases/e-drive.toml");
//! let loaded = asperity_case::case::load(file, None)?;
//! let loaded = loaded.with_laws(|laws| laws.friction = Some(Arc::new(Limit)));
//! assert_eq!(loaded.at_stated()?.film_friction().name(), "limit");
//! # Ok::<(), asperity_case::error::Error>(())
//! ```

pub mod load_share;

use std::sync::Arc;

use asperity_ehl_regime::FilmThicknessLaw;
use asperity_gear::LoadDistribution;
use asperity_tribo_friction::FilmFriction;

use crate::source::defaults::DefaultUsed;
use load_share::LoadShare;

/// Source of the name of a user-defined law.
pub(crate) const OWN_LAW: &str = "user-defined law";

/// User-defined laws, which only a program can state; without one the law of the case applies.
#[derive(Debug, Clone, Default)]
#[non_exhaustive]
pub struct Laws {
    /// Smooth film thickness, instead of `model.film`.
    pub film: Option<Arc<dyn FilmThicknessLaw>>,
    /// Friction in the film, instead of `model.film_friction`.
    pub friction: Option<Arc<dyn FilmFriction>>,
    /// Load over the teeth, instead of `model.load_distribution`.
    pub load_distribution: Option<Arc<dyn LoadDistribution>>,
    /// Film against asperities, instead of `model.load_share`.
    pub load_share: Option<Arc<dyn LoadShare>>,
}

impl Laws {
    /// Names of the user-defined laws by the keys whose laws they replace.
    pub(crate) fn rows(&self) -> impl Iterator<Item = DefaultUsed> {
        let names = [
            ("model.film", self.film.as_ref().map(|law| law.name())),
            (
                "model.film_friction",
                self.friction.as_ref().map(|law| law.name()),
            ),
            (
                "model.load_distribution",
                self.load_distribution.as_ref().map(|law| law.name()),
            ),
            (
                "model.load_share",
                self.load_share.as_ref().map(|law| law.name()),
            ),
        ];
        names.into_iter().filter_map(|(key, name)| {
            Some(DefaultUsed {
                key: key.into(),
                value: name?.to_owned(),
                source: Some(OWN_LAW.into()),
            })
        })
    }

    /// Whether a law is user-defined.
    pub fn is_any(&self) -> bool {
        self.film.is_some()
            || self.friction.is_some()
            || self.load_distribution.is_some()
            || self.load_share.is_some()
    }
}
