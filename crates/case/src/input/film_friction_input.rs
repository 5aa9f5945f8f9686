//! Friction law of the film as a case states it: its name, or a table with the setting of the law.

use std::path::{Path, PathBuf};
use std::sync::LazyLock;

use asperity_core::DomainError;
use asperity_oil::ShearLawName;
use asperity_tribo_friction::{FrictionLaw, FrictionSettings};
use serde::de::{self, Error as _, IgnoredAny, MapAccess, Visitor};
use serde::{Deserialize, Deserializer, Serialize};

use super::ranges::of_law;
use super::rows::{Judge, KeyPath, OPEN, RangedKey};

/// Friction in the film, with the setting of its law.
#[derive(Debug, Clone, PartialEq, Serialize)]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
#[serde(untagged)]
pub enum FilmFrictionInput {
    /// A shear law: friction of the film alone, below the limiting shear stress, with its heat.
    Film(ShearLawName),
    /// A published law.
    Published(FrictionLaw),
    /// A law with its setting.
    Set(FrictionSetting),
}

/// Setting of a friction law.
#[derive(Debug, Clone, PartialEq, Serialize)]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
#[serde(rename_all = "kebab-case", deny_unknown_fields)]
pub enum FrictionSetting {
    /// One friction coefficient everywhere.
    Constant(f64),
    /// Lubricant factor X_L of ISO/TR 14179-2; 1 for mineral oil.
    #[serde(rename = "iso-14179-2")]
    Iso14179Part2(f64),
    /// Coefficients of Xu's law from an own calibration: a JSON file, relative to the case file.
    Xu(PathBuf),
}

impl From<FrictionLaw> for FilmFrictionInput {
    fn from(law: FrictionLaw) -> Self {
        Self::Published(law)
    }
}

impl FilmFrictionInput {
    /// The shear law of the film; `None` for a published law.
    #[must_use]
    pub const fn shear_law(&self) -> Option<ShearLawName> {
        match self {
            Self::Film(law) => Some(*law),
            Self::Published(_) | Self::Set(_) => None,
        }
    }

    /// The published law; `None` for a shear law of the film.
    #[must_use]
    pub const fn published(&self) -> Option<FrictionLaw> {
        match self {
            Self::Film(_) => None,
            Self::Published(law) => Some(*law),
            Self::Set(FrictionSetting::Constant(_)) => Some(FrictionLaw::Constant),
            Self::Set(FrictionSetting::Iso14179Part2(_)) => Some(FrictionLaw::Iso14179Part2),
            Self::Set(FrictionSetting::Xu(_)) => Some(FrictionLaw::Xu),
        }
    }

    /// The file with coefficients of Xu's law.
    #[must_use]
    pub fn xu_coefficients(&self) -> Option<&Path> {
        match self {
            Self::Set(FrictionSetting::Xu(file)) => Some(file),
            _ => None,
        }
    }

    /// Lubricant factor X_L of ISO/TR 14179-2.
    #[must_use]
    pub const fn lubricant_factor(&self) -> f64 {
        match self {
            Self::Set(FrictionSetting::Iso14179Part2(factor)) => *factor,
            _ => 1.0,
        }
    }

    /// Settings of the published laws.
    pub(crate) fn settings(&self) -> FrictionSettings {
        FrictionSettings {
            constant: match self {
                Self::Set(FrictionSetting::Constant(coefficient)) => Some(*coefficient),
                _ => None,
            },
            ..FrictionSettings::default()
        }
    }

    pub(crate) fn check(&self) -> Result<(), DomainError> {
        let (called, number, is_one, rule) = match self {
            Self::Set(FrictionSetting::Constant(mu)) => {
                let is_one = (0.0..=2.0).contains(mu);
                ("constant friction", *mu, is_one, "must be 0 to 2")
            }
            Self::Set(FrictionSetting::Iso14179Part2(x)) => {
                let is_one = *x > 0.0 && *x <= 10.0;
                let rule = "must be positive and at most 10";
                ("lubricant factor", *x, is_one, rule)
            }
            Self::Set(FrictionSetting::Xu(_)) | Self::Film(_) | Self::Published(_) => return Ok(()),
        };
        DomainError::require(is_one, called, number, "-", rule).map(|_| ())
    }
}

impl RangedKey for FilmFrictionInput {
    fn visit(stated: Option<&Self>, at: KeyPath<'_>, judge: Judge<'_>) {
        let [mut constant, mut factor] = [None; 2];
        match stated {
            Some(Self::Set(FrictionSetting::Constant(mu))) => constant = Some(*mu),
            Some(Self::Set(FrictionSetting::Iso14179Part2(x))) => factor = Some(*x),
            _ => {}
        }
        let (usual, of_factor) = ([0.002, 0.2], [0.3, 2.0]);
        judge(
            at.below("constant"),
            &of_law("", usual, OPEN),
            constant.as_slice(),
        );
        judge(
            at.below("iso-14179-2"),
            &of_law("", of_factor, OPEN),
            factor.as_slice(),
        );
    }
}

impl<'de> Deserialize<'de> for FilmFrictionInput {
    fn deserialize<D: Deserializer<'de>>(deserializer: D) -> Result<Self, D::Error> {
        deserializer.deserialize_any(FilmFrictionVisitor)
    }
}

struct FilmFrictionVisitor;

impl<'de> Visitor<'de> for FilmFrictionVisitor {
    type Value = FilmFrictionInput;

    fn expecting(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        write!(
            f,
            "the name of a friction law, or a table like {{ constant = 0.05 }}"
        )
    }

    fn visit_str<E: de::Error>(self, name: &str) -> Result<FilmFrictionInput, E> {
        static NAMES: LazyLock<Vec<&str>> = LazyLock::new(|| {
            let film = ShearLawName::ALL.iter().map(|law| law.name());
            let published = FrictionLaw::ALL.iter().map(|law| law.name());
            film.chain(published).collect()
        });
        if let Some(law) = ShearLawName::ALL.iter().find(|law| law.name() == name) {
            return Ok(FilmFrictionInput::Film(*law));
        }
        let published = FrictionLaw::ALL.iter().find(|law| law.name() == name);
        let published = published.ok_or_else(|| E::unknown_variant(name, &NAMES))?;
        Ok(FilmFrictionInput::Published(*published))
    }

    fn visit_map<A: MapAccess<'de>>(self, mut map: A) -> Result<FilmFrictionInput, A::Error> {
        const LAWS: &[&str] = &["constant", "iso-14179-2", "xu"];
        let Some(law) = map.next_key::<String>()? else {
            return Err(A::Error::invalid_length(0, &self));
        };
        let set = match law.as_str() {
            "constant" => FrictionSetting::Constant(map.next_value()?),
            "iso-14179-2" => FrictionSetting::Iso14179Part2(map.next_value()?),
            "xu" => FrictionSetting::Xu(map.next_value()?),
            other => return Err(A::Error::unknown_variant(other, LAWS)),
        };
        match map.next_key::<IgnoredAny>()? {
            Some(_) => Err(A::Error::custom("takes the setting of one law only")),
            None => Ok(FilmFrictionInput::Set(set)),
        }
    }
}
