//! User-defined laws in a case.

use std::sync::Arc;

use asperity_ehl_regime::FilmThicknessLaw;
use asperity_gear::{GearError, LoadDistribution, LoadMap};
use asperity_tribo_friction::{FilmFriction, NamedFriction};

use super::resolve::Case;
use crate::laws::load_share::LoadShare;
use crate::source::defaults::DefaultUsed;
use asperity_mixed_film::FilmAlone;

/// Source of the name of a user-defined law.
const OWN_LAW: &str = "user-defined law";

impl Case {
    /// The case with a user-defined film thickness law.
    #[must_use]
    pub fn with_film_law(mut self, law: Arc<dyn FilmThicknessLaw>) -> Self {
        self.laws.film = Some(law);
        self.list_laws();
        self
    }

    /// The case with a user-defined friction law of the film.
    #[must_use]
    pub fn with_film_friction(mut self, law: Arc<dyn FilmFriction>) -> Self {
        self.laws.friction = Some(law);
        self.list_laws();
        self
    }

    /// The case with a user-defined load distribution over the teeth.
    #[must_use]
    pub fn with_load_distribution(mut self, law: Arc<dyn LoadDistribution>) -> Self {
        self.laws.load_distribution = Some(law);
        self.list_laws();
        self
    }

    /// The case with a user-defined load sharing between film and asperities.
    #[must_use]
    pub fn with_load_share(mut self, law: Arc<dyn LoadShare>) -> Self {
        self.laws.load_share = Some(law);
        self.list_laws();
        self
    }

    /// Names the user-defined laws among the defaults, in place of the laws that they replace.
    pub(crate) fn list_laws(&mut self) {
        let laws = &self.laws;
        let names = [
            ("model.film", laws.film.as_ref().map(|law| law.name())),
            (
                "model.film_friction",
                laws.friction.as_ref().map(|law| law.name()),
            ),
            (
                "model.load_distribution",
                laws.load_distribution.as_ref().map(|law| law.name()),
            ),
            (
                "model.load_share",
                laws.load_share.as_ref().map(|law| law.name()),
            ),
        ];
        for (key, name) in names {
            let Some(name) = name else { continue };
            self.defaults.retain(|row| row.key != key);
            self.defaults.push(DefaultUsed {
                key: key.into(),
                value: name.to_owned(),
                source: Some(OWN_LAW.into()),
            });
        }
    }

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

    /// The friction law of the film in use.
    #[must_use]
    pub fn film_friction(&self) -> Arc<dyn FilmFriction> {
        let own = self.laws.friction.clone();
        own.unwrap_or_else(
            || match (&self.rheology, self.model.film_friction.shear_law()) {
                (Some(rheology), Some(_)) => {
                    Arc::new(FilmAlone::new(rheology, self.model.central_film))
                }
                _ => Arc::new(NamedFriction {
                    law: self.model.film_friction.published().unwrap_or_default(),
                    settings: self.model.friction_settings,
                }),
            },
        )
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

    /// The load sharing between film and asperities in use.
    #[must_use]
    pub fn load_share(&self) -> Arc<dyn LoadShare> {
        let own = self.laws.load_share.clone();
        own.unwrap_or_else(|| Arc::new(self.model.load_share))
    }
}
