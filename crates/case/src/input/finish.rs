//! Names of the finishes of a flank in a case file.

use asperity_roughness::generate::Finish;
use serde::{Deserialize, Serialize};

/// Finish of a flank.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Serialize, Deserialize)]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
#[serde(rename_all = "kebab-case")]
#[non_exhaustive]
pub enum FinishName {
    /// Ground.
    Ground,
    /// Superfinished: isotropic, without grooves.
    Superfinished,
    /// Honed.
    Honed,
    /// Hobbed.
    Hobbed,
    /// Shaved.
    Shaved,
    /// Skived.
    Skived,
    /// Lapped.
    Lapped,
    /// Shot-peened.
    ShotPeened,
}

impl FinishName {
    /// The name in a case file.
    #[must_use]
    pub const fn name(self) -> &'static str {
        match self {
            Self::Ground => Finish::Ground.name(),
            Self::Superfinished => Finish::Superfinished.name(),
            Self::Honed => "honed",
            Self::Hobbed => "hobbed",
            Self::Shaved => "shaved",
            Self::Skived => "skived",
            Self::Lapped => "lapped",
            Self::ShotPeened => "shot-peened",
        }
    }

    /// The recipe of its surrogates; `None` if there is none yet.
    pub(crate) const fn recipe(self) -> Option<Finish> {
        match self {
            Self::Ground => Some(Finish::Ground),
            Self::Superfinished => Some(Finish::Superfinished),
            _ => None,
        }
    }
}
