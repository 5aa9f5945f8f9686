//! Names of the laws of friction and load share in a case file.

use asperity_tribo_friction::FrictionLaw;

use asperity_oil::ShearLawName;
use serde::{Deserialize, Serialize};

/// Friction in the film.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash, Default, Serialize, Deserialize)]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
#[serde(rename_all = "kebab-case", deny_unknown_fields)]
#[non_exhaustive]
pub enum FilmFrictionLaw {
    /// Film alone: Eyring below the limiting shear stress, with its heat.
    #[default]
    Eyring,
    /// Film alone: Carreau below the limiting shear stress, with its heat.
    Carreau,
    /// Film alone: Newton below the limiting shear stress, with its heat.
    Newton,
    /// Xu 2005: regression of thermal mixed-EHL solutions.
    Xu,
    /// Benedict and Kelley 1961: roller tests.
    BenedictKelley,
    /// ISO/TR 14179-1: one coefficient for the mesh.
    #[serde(rename = "iso-14179-1")]
    Iso14179Part1,
    /// ISO/TR 14179-2 (Schlenk 1994): one coefficient for the mesh.
    #[serde(rename = "iso-14179-2")]
    Iso14179Part2,
    /// Matsumoto and Morikawa 2014: load sharing by maximum heights.
    Matsumoto,
    /// Doleschel 2002: load sharing by the film ratio.
    Doleschel,
    /// Arana 2019: Eyring fits of three base oils.
    EyringArana,
    /// A stated constant.
    Constant,
}

impl FilmFrictionLaw {
    /// The shear law of the film; `None` for a published law.
    #[must_use]
    pub const fn shear_law(self) -> Option<ShearLawName> {
        match self {
            Self::Eyring => Some(ShearLawName::Eyring),
            Self::Carreau => Some(ShearLawName::Carreau),
            Self::Newton => Some(ShearLawName::Newton),
            _ => None,
        }
    }

    /// The published law; `None` for a shear law of the film.
    #[must_use]
    pub const fn published(self) -> Option<FrictionLaw> {
        match self {
            Self::Eyring | Self::Carreau | Self::Newton => None,
            Self::Xu => Some(FrictionLaw::Xu),
            Self::BenedictKelley => Some(FrictionLaw::BenedictKelley),
            Self::Iso14179Part1 => Some(FrictionLaw::Iso14179Part1),
            Self::Iso14179Part2 => Some(FrictionLaw::Iso14179Part2),
            Self::Matsumoto => Some(FrictionLaw::Matsumoto),
            Self::Doleschel => Some(FrictionLaw::Doleschel),
            Self::EyringArana => Some(FrictionLaw::Eyring),
            Self::Constant => Some(FrictionLaw::Constant),
        }
    }
}

/// Law of the load sharing between film and asperities.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash, Default, Serialize, Deserialize)]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
#[serde(rename_all = "kebab-case", deny_unknown_fields)]
#[non_exhaustive]
pub enum LoadShareName {
    /// The solved rough contact whose gap is what the inlet supplies.
    #[default]
    Solved,
    /// c_f = 1 − (1 − min(Λ*, 1))².
    LambdaStar,
    /// Zhu and Hu's function of the classical film ratio.
    ZhuHu,
    /// Masjedi and Khonsari 2012.
    MasjediKhonsari,
    /// Johnson, Greenwood and Poon: the solved contact with the gap of the smooth film.
    Jgp,
    /// Records of transient mixed lubrication at a few places of the path, interpolated between.
    Ehl,
}

/// Source of a film that carries the whole load.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash, Default, Serialize, Deserialize)]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
#[serde(rename_all = "kebab-case", deny_unknown_fields)]
#[non_exhaustive]
pub enum FullFilmName {
    /// Film formula, Hertz pressure and the law of film friction.
    #[default]
    Formulas,
    /// The steady elastohydrodynamic solution of smooth flanks.
    Ehl,
    /// Means over transient solutions with both traces.
    EhlTransient,
}

impl FullFilmName {
    /// The name in a case file.
    #[must_use]
    pub const fn name(self) -> &'static str {
        match self {
            Self::Formulas => "formulas",
            Self::Ehl => "ehl",
            Self::EhlTransient => "ehl-transient",
        }
    }
}
