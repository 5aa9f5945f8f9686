//! Names of the laws of load share and full film in a case file.

use serde::{Deserialize, Serialize};

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
    /// Transient reference solutions at a few places of the path, interpolated between.
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
