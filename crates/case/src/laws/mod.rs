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
//!         Ok(Checked::inside(FilmTraction::of(coefficient)))
//!     }
//! }
//!
//! let file = Path::new("../../fixtures/cases/e-drive.toml");
//! let mut loaded = asperity_case::case::load(file, None)?;
//! loaded.case = loaded.case.with_film_friction(Arc::new(Limit));
//! assert_eq!(loaded.case.film_friction().name(), "limit");
//! # Ok::<(), asperity_case::error::Error>(())
//! ```

pub mod load_share;

use std::sync::Arc;

use asperity_ehl_regime::FilmThicknessLaw;
use asperity_gear::LoadDistribution;
use asperity_mixed_film::PatchGap;
use asperity_tribo_friction::FilmFriction;

use load_share::LoadShare;

/// Choices that only a program can make: user-defined laws, without which those of the case apply, and exact contacts.
#[derive(Debug, Clone, Default)]
#[non_exhaustive]
pub struct Laws {
    /// Smooth film thickness, in place of `model.film`.
    pub film: Option<Arc<dyn FilmThicknessLaw>>,
    /// Friction in the film, in place of `model.film_friction`.
    pub friction: Option<Arc<dyn FilmFriction>>,
    /// Load over the teeth, in place of `model.load_distribution`.
    pub load_distribution: Option<Arc<dyn LoadDistribution>>,
    /// Film against asperities, in place of `model.load_share`.
    pub load_share: Option<Arc<dyn LoadShare>>,
    /// Solve every rough contact to its exact sets: slower, and its error is round-off, so that differences of losses can be
    /// taken over small steps.
    pub exact_contacts: bool,
    /// Gupta's thermal factor as printed, also at the loadings at which its steepness is held: for the interval of a loss.
    pub printed_thermal: bool,
    /// Gap supplied to patches: for the interval of a loss.
    pub patch_gap: PatchGap,
}

impl Laws {
    /// Whether a law is user-defined.
    pub fn is_any(&self) -> bool {
        self.film.is_some()
            || self.friction.is_some()
            || self.load_distribution.is_some()
            || self.load_share.is_some()
    }
}
