//! Law of the load sharing that a run uses, with its settings.

use std::sync::Arc;

use asperity_core::quantity::Pressure;
use asperity_ehl_regime::LoadShareLaw;
use asperity_ehl_regime::published_shares::masjedi_khonsari;
use asperity_mixed_film::{InletSupply, LoadShareSettings, SpotSpeed};

use super::overrides::Alternative;
use super::resolve::Case;
use crate::error::PositionError;
use crate::input::law_names::LoadShareName;
use crate::laws::load_share::{LoadShare, ShareConditions, SharedLoad};
use crate::recorded_share::RecordedShare;

/// Law of the load sharing between film and asperities. Settings have the default lay: the flanks determine that of a contact.
#[derive(Debug, Clone)]
pub enum ShareLaw {
    /// The solved rough contact whose gap is what a flooded or a starved inlet supplies.
    Solved(LoadShareSettings),
    /// c_f = 1 − (1 − min(Λ*, 1))².
    LambdaStar,
    /// A published law.
    Published(PublishedShare),
    /// Transient reference solutions at a few places of the path, interpolated between.
    Reference,
    /// A user-defined law.
    Own {
        /// The law.
        law: Arc<dyn LoadShare>,
        /// Settings of the rough contact that the law wants solved.
        contact: Option<LoadShareSettings>,
    },
}

/// Published law of the load sharing.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum PublishedShare {
    /// Zhu and Hu's function of the classical film ratio.
    ZhuHu,
    /// Masjedi and Khonsari 2012.
    MasjediKhonsari,
    /// Johnson, Greenwood and Poon: the solved contact with the gap of the smooth film.
    Jgp(LoadShareSettings),
}

impl ShareLaw {
    /// The name, as a case file and results print it.
    #[must_use]
    pub fn name(&self) -> &str {
        match self {
            Self::Solved(_) => "solved",
            Self::LambdaStar => "lambda-star",
            Self::Published(PublishedShare::ZhuHu) => "zhu-hu",
            Self::Published(PublishedShare::MasjediKhonsari) => "masjedi-khonsari",
            Self::Published(PublishedShare::Jgp(_)) => "jgp",
            Self::Reference => "ehl",
            Self::Own { law, .. } => law.name(),
        }
    }

    /// Settings of the rough contact, if the law has it solved.
    #[must_use]
    pub const fn contact(&self) -> Option<&LoadShareSettings> {
        match self {
            Self::Solved(settings) | Self::Published(PublishedShare::Jgp(settings)) => {
                Some(settings)
            }
            Self::Own { contact, .. } => contact.as_ref(),
            Self::LambdaStar | Self::Published(_) | Self::Reference => None,
        }
    }

    /// Shares at one mesh position, one for each offset of the traces; `recorded` by the records there.
    ///
    /// # Errors
    /// When an input is outside the domain of the law.
    pub fn shares(
        &self,
        conditions: &[ShareConditions<'_>],
        recorded: Option<&RecordedShare>,
    ) -> Result<Vec<SharedLoad>, PositionError> {
        match (self, recorded) {
            (Self::Own { law, .. }, _) => law.shares(conditions),
            (Self::Reference, Some(recorded)) => Ok(vec![of_records(recorded); conditions.len()]),
            _ => conditions.iter().map(|one| self.share(one)).collect(),
        }
    }

    /// In light cells whose contact the traces do not resolve, and without records, the share is that of `lambda-star`.
    fn share(&self, at: &ShareConditions<'_>) -> Result<SharedLoad, PositionError> {
        match (self, at.solved) {
            (Self::Solved(_), Some(solved)) => Ok(SharedLoad {
                film_coefficient: Some(solved.film_coefficient),
                ..SharedLoad::of_film(1.0 - solved.asperity_share).with_lubricated_asperities(
                    solved.boundary_of_asperities,
                    solved.asperity_coefficient,
                )
            }),
            (Self::Published(PublishedShare::Jgp(_)), Some(solved)) => {
                Ok(SharedLoad::of_film(1.0 - solved.asperity_share))
            }
            (Self::Published(PublishedShare::MasjediKhonsari), _) => share_by_regression(at),
            (Self::Published(PublishedShare::ZhuHu), _) => LoadShareLaw::ZhuHu.share(at),
            _ => LoadShareLaw::LambdaStar.share(at),
        }
    }
}

fn of_records(recorded: &RecordedShare) -> SharedLoad {
    SharedLoad {
        film_coefficient: recorded.film_coefficient,
        ..SharedLoad::of_film(1.0 - recorded.solid_share.mean)
            .with_lubricated_asperities(recorded.boundary_part, recorded.lubricated_coefficient)
    }
}

fn share_by_regression(at: &ShareConditions<'_>) -> Result<SharedLoad, PositionError> {
    let [pinion, wheel] = at.flow_pressure.map(Pressure::si);
    let film = &at.film.conditions;
    let asperities = masjedi_khonsari(
        &film.line_groups()?,
        at.roughness.combined_rq()?,
        film.radius,
        Pressure::from_si(pinion.min(wheel)),
        film.modulus,
    )?;
    Ok(SharedLoad::of_film(1.0 - asperities.value))
}

impl Case {
    /// The law of the load sharing in use: user-defined, or the one that the case names.
    #[must_use]
    pub fn share_law(&self) -> ShareLaw {
        let Some(law) = &self.laws.load_share else {
            return self.named_share();
        };
        let contact = law.supply().map(|supply| match supply {
            InletSupply::Rough => self.solved_share(),
            supply => LoadShareSettings {
                supply,
                ..self.solved_share()
            },
        });
        ShareLaw::Own {
            law: Arc::clone(law),
            contact,
        }
    }

    /// The law of the load sharing that the case names.
    pub(crate) fn named_share(&self) -> ShareLaw {
        match self.model.load_share {
            LoadShareName::Solved => ShareLaw::Solved(self.solved_share()),
            LoadShareName::LambdaStar => ShareLaw::LambdaStar,
            LoadShareName::ZhuHu => ShareLaw::Published(PublishedShare::ZhuHu),
            LoadShareName::MasjediKhonsari => ShareLaw::Published(PublishedShare::MasjediKhonsari),
            LoadShareName::Jgp => ShareLaw::Published(PublishedShare::Jgp(LoadShareSettings {
                supply: InletSupply::Smooth,
                ..self.solved_share()
            })),
            LoadShareName::Ehl => ShareLaw::Reference,
        }
    }

    /// Settings of the law `solved` in this case, with the default lay.
    #[must_use]
    pub fn solved_share(&self) -> LoadShareSettings {
        let (model, overrides) = (&self.model, &self.overrides);
        let (spot_speed, share_factor) = match overrides.alternative {
            Some(Alternative::SpotSpeed(speed)) => (speed, 1.0),
            Some(Alternative::AsperityShareTimes(factor)) => (SpotSpeed::Carried, factor),
            _ => (SpotSpeed::Carried, 1.0),
        };
        LoadShareSettings {
            boundary_friction: model.boundary_friction,
            boundary_layer: model.boundary_layer,
            film_law: model.film,
            thermal: model.thermal,
            supply: match model.inlet_layer {
                Some(_) => InletSupply::Starved,
                None => InletSupply::Rough,
            },
            spot_speed,
            inner_boundary: model.inner_boundary,
            patch_gap: overrides.patch_gap,
            share_factor,
            ..LoadShareSettings::default()
        }
    }
}
