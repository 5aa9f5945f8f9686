//! User-defined laws in a case.

use std::sync::Arc;

use asperity_ehl_regime::FilmThicknessLaw;
use asperity_gear::{GearError, LoadDistribution, LoadMap};

use super::resolve::Case;
use crate::laws::OWN_LAW;
use crate::source::defaults::DefaultUsed;

impl Case {
    /// The rows of the user-defined laws among the defaults.
    pub(crate) fn own_laws(&self) -> impl Iterator<Item = &DefaultUsed> {
        let rows = self.defaults.iter();
        rows.filter(|row| row.source.as_deref() == Some(OWN_LAW))
    }

    /// The film thickness law in use: user-defined, or the one that the case names.
    #[must_use]
    pub fn film_law(&self) -> Arc<dyn FilmThicknessLaw> {
        let own = self.laws.film.clone();
        own.unwrap_or_else(|| self.model.film.into())
    }

    /// The distribution of the load over the teeth in use.
    #[must_use]
    pub fn load_distribution(&self) -> Arc<dyn LoadDistribution> {
        let own = self.laws.load_distribution.clone();
        own.unwrap_or_else(|| self.model.load_distribution.clone().into())
    }

    /// The load over the flanks by the law in use.
    ///
    /// # Errors
    /// When the law does not hold for these gears, or puts no load on the teeth.
    pub fn load_map(&self) -> Result<LoadMap, GearError> {
        self.load_inputs().load_map()
    }
}
