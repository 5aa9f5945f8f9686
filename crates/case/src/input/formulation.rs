//! Formulations of the model: what distinguishes one from another, and the names by which a case chooses them.
//!
//! The program has one, `corrected`. A program that has another implements [`Formulation`] and calls [`register`] before it
//! reads its first case:
//!
//! ```
//! use asperity_case::case::{ModelInput, Positions};
//! use asperity_case::formulation::{Formulation, FormulationChoice, register};
//!
//! /// The pitch point stands for the whole path.
//! #[derive(Debug)]
//! struct PitchPoint;
//!
//! impl Formulation for PitchPoint {
//!     fn name(&self) -> &'static str {
//!         "pitch-point"
//!     }
//!
//!     fn about(&self) -> &'static str {
//!         "One contact, at the pitch point"
//!     }
//!
//!     fn positions(&self) -> Positions {
//!         Positions::Single
//!     }
//! }
//!
//! assert!("pitch-point".parse::<FormulationChoice>().is_err());
//! let chosen = register(&PitchPoint);
//! assert_eq!("pitch-point".parse(), Ok(chosen));
//! assert_eq!(chosen.defaults(), ModelInput::default());
//! ```

use std::fmt::{self, Debug};
use std::ops::Deref;
use std::str::FromStr;
use std::sync::{PoisonError, RwLock};

use asperity_efficiency::RollingSurfaces;
use asperity_ehl_regime::{CentralFilm, Regime};
use asperity_tribo_friction::RoughnessReading;
use serde::{Deserialize, Deserializer, Serialize, Serializer};

use super::model::ModelInput;
use super::path_point::Positions;
use super::window_pressures::WindowPressures;
use crate::error::PositionError;

/// A complete choice of models. Each method has a default: the choice of the program.
pub trait Formulation: Debug + Send + Sync {
    /// Value of the key `formulation`.
    fn name(&self) -> &'static str;

    /// Meaning, for help and schema.
    fn about(&self) -> &'static str;

    /// Keys of the model whose defaults differ.
    fn defaults(&self) -> ModelInput {
        ModelInput::default()
    }

    /// Keys that it does not use, whose defaults are not listed.
    fn unused_keys(&self) -> &'static [&'static str] {
        &[]
    }

    /// Keys that it refuses, each with the reason.
    fn refused_keys(&self) -> &'static [(&'static str, &'static str)] {
        &[]
    }

    /// Places of the path that represent the mesh.
    fn positions(&self) -> Positions {
        Positions::AlongPath
    }

    /// Whether a gear without stated tip relief has the usual one.
    fn assumes_relief(&self) -> bool {
        true
    }

    /// Surfaces on which rolling friction is counted.
    fn rolling_surfaces(&self) -> RollingSurfaces {
        RollingSurfaces::Both
    }

    /// Central film that results print, and over which Λ* is taken.
    fn printed_film(&self) -> CentralFilm {
        CentralFilm::Gap
    }

    /// Roughness in Xu's friction law.
    fn xu_roughness(&self) -> RoughnessReading {
        RoughnessReading::Clamped
    }

    /// Whether its loss has an interval.
    fn has_interval(&self) -> bool {
        true
    }

    /// Regime of a window whose film carries `film_share` of the load, with Λ* or, where that is not known, the classical film
    /// ratio `film_ratio`.
    ///
    /// # Errors
    /// When the numbers are outside the domain of the rule.
    fn regime(&self, film_share: f64, film_ratio: f64) -> Result<FilmRegime, PositionError> {
        let _ = film_ratio;
        Ok(FilmRegime {
            regime: Regime::of_film_share(film_share),
            is_full: film_share >= 1.0,
        })
    }

    /// Pressures in a window, if film share and friction follow from them; otherwise these follow from the law of the load share.
    fn pressures(&self) -> Option<&dyn WindowPressures> {
        None
    }
}

/// Regime of a window, and whether its film carries the whole load.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct FilmRegime {
    /// Full film or mixed friction.
    pub regime: Regime,
    /// Whether the film has the friction of a full film.
    pub is_full: bool,
}

/// The formulation of this program.
#[derive(Debug)]
struct Corrected;

impl Formulation for Corrected {
    fn name(&self) -> &'static str {
        "corrected"
    }

    fn about(&self) -> &'static str {
        "Dimensionally and physically consistent"
    }
}

/// Formulations other than `corrected`, in the order in which they were registered.
static REGISTERED: RwLock<Vec<FormulationChoice>> = RwLock::new(Vec::new());

/// Makes `formulation` a value of the key `formulation`, and returns it as a case chooses it. Of several with one name the first
/// one stays.
pub fn register(formulation: &'static dyn Formulation) -> FormulationChoice {
    let choice = FormulationChoice(formulation);
    let mut others = REGISTERED.write().unwrap_or_else(PoisonError::into_inner);
    let mut known = std::iter::once(FormulationChoice::default()).chain(others.iter().copied());
    match known.find(|known| *known == choice) {
        Some(known) => known,
        None => {
            others.push(choice);
            choice
        }
    }
}

/// The formulations that a case can choose, `corrected` first.
#[must_use]
pub fn registered() -> Vec<FormulationChoice> {
    let others = REGISTERED.read().unwrap_or_else(PoisonError::into_inner);
    let first = std::iter::once(FormulationChoice::default());
    first.chain(others.iter().copied()).collect()
}

/// A registered formulation, as a case chooses it by its name.
#[derive(Clone, Copy)]
pub struct FormulationChoice(&'static dyn Formulation);

impl Default for FormulationChoice {
    fn default() -> Self {
        Self(&Corrected)
    }
}

impl Deref for FormulationChoice {
    type Target = dyn Formulation;

    fn deref(&self) -> &Self::Target {
        self.0
    }
}

impl PartialEq for FormulationChoice {
    fn eq(&self, other: &Self) -> bool {
        self.name() == other.name()
    }
}

impl Eq for FormulationChoice {}

impl Debug for FormulationChoice {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(self.name())
    }
}

/// A name that no registered formulation has.
#[derive(Debug, Clone, PartialEq, Eq, thiserror::Error)]
#[error(
    "unknown variant `{name}`, expected {}{}",
    one_of(known),
    unregistered(known)
)]
pub struct UnknownFormulation {
    name: String,
    known: Vec<&'static str>,
}

fn one_of(known: &[&str]) -> String {
    let quoted: Vec<String> = known.iter().map(|name| format!("`{name}`")).collect();
    quoted.join(" or ")
}

/// Advice for a program that has no formulation but `corrected`.
fn unregistered(known: &[&str]) -> &'static str {
    match known {
        [_] => {
            "; that of the 2022 paper is in the crate asperity-paper-2022, whose function `register` a program calls before it reads a case"
        }
        _ => "",
    }
}

impl FromStr for FormulationChoice {
    type Err = UnknownFormulation;

    fn from_str(name: &str) -> Result<Self, Self::Err> {
        let known = registered();
        let found = known.iter().find(|known| known.name() == name);
        found.copied().ok_or_else(|| UnknownFormulation {
            name: name.to_owned(),
            known: known.iter().map(|known| known.name()).collect(),
        })
    }
}

impl Serialize for FormulationChoice {
    fn serialize<S: Serializer>(&self, serializer: S) -> Result<S::Ok, S::Error> {
        serializer.serialize_str(self.name())
    }
}

impl<'de> Deserialize<'de> for FormulationChoice {
    fn deserialize<D: Deserializer<'de>>(deserializer: D) -> Result<Self, D::Error> {
        let name = String::deserialize(deserializer)?;
        name.parse().map_err(serde::de::Error::custom)
    }
}

#[cfg(feature = "schema")]
impl schemars::JsonSchema for FormulationChoice {
    fn schema_name() -> std::borrow::Cow<'static, str> {
        "Formulation".into()
    }

    fn json_schema(_: &mut schemars::SchemaGenerator) -> schemars::Schema {
        let one = |choice: FormulationChoice| serde_json::json!({ "description": choice.about(), "type": "string", "const": choice.name() });
        let choices: Vec<_> = registered().into_iter().map(one).collect();
        schemars::json_schema!({ "description": "Formulation of the 2022 model.", "oneOf": choices })
    }
}

#[cfg(feature = "clap")]
impl clap::builder::ValueParserFactory for FormulationChoice {
    type Parser = clap::builder::MapValueParser<
        clap::builder::PossibleValuesParser,
        fn(String) -> FormulationChoice,
    >;

    fn value_parser() -> Self::Parser {
        use clap::builder::{PossibleValue, PossibleValuesParser, TypedValueParser};
        let one =
            |choice: FormulationChoice| PossibleValue::new(choice.name()).help(choice.about());
        // It lets through the names of what is registered.
        let names = PossibleValuesParser::new(registered().into_iter().map(one));
        names.map((|name| name.parse().unwrap_or_default()) as fn(String) -> Self)
    }
}
