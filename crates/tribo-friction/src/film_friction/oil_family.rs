//! Families of oils: the constants of film friction that no data sheet states.
//!
//! | symbol | field | unit |
//! |---|---|---|
//! | Λ | `limiting_shear`, limiting shear stress over pressure at 90 °C | - |
//! | τ₀ | `eyring_stress` | Pa |
//! | k | `conductivity` at ambient pressure | W/(m K) |
//! | c₁, c₂ | `conductivity_rise`, `conductivity_bend` in k(p) = k (1 + c₁ p/(1 + c₂ p)) | 1/GPa |
//!
//! The numbers are data (`data/oil_families.json`), each with its band where one is known, its source and
//! how sure it is ([`Mark`]). Gold's constants for α are those of the base oil in `asperity-core`. The families are those of the base oil; additives are not in them.

use std::sync::OnceLock;

use asperity_oil::BaseOil;
use schemars::JsonSchema;
use serde::{Deserialize, Serialize};

use crate::error::FrictionError;

const DATA: &str = include_str!("../../data/oil_families.json");

/// Confidence in a number.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash, Serialize, Deserialize)]
#[serde(rename_all = "kebab-case")]
pub enum Mark {
    /// Read in its source.
    Seen,
    /// Fitted here to measurements of its source.
    Calibrated,
    /// From memory; the text of the source was not reached.
    Memory,
    /// Judgement of this project.
    Judged,
}

/// A number with its band, its source and how sure it is.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct MarkedValue {
    /// The default.
    pub value: f64,
    /// Lower end of the band, where one is known.
    #[serde(default)]
    pub low: Option<f64>,
    /// Upper end of the band, where one is known.
    #[serde(default)]
    pub high: Option<f64>,
    /// Confidence.
    pub mark: Mark,
    /// Key of the source.
    pub source: String,
}

/// Constants of one family of oils.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct OilFamilyData {
    /// Name of the family in a case file.
    pub name: String,
    /// Limiting shear stress over pressure Λ.
    pub limiting_shear: MarkedValue,
    /// Eyring stress τ₀ \[Pa\].
    pub eyring_stress: MarkedValue,
    /// Thermal conductivity k at ambient pressure \[W/(m K)\].
    pub conductivity: MarkedValue,
    /// Coefficient c₁ of the conductivity over pressure \[1/GPa\].
    pub conductivity_rise: MarkedValue,
    /// Coefficient c₂ of the conductivity over pressure \[1/GPa\].
    pub conductivity_bend: MarkedValue,
}

#[derive(Debug, Deserialize)]
#[serde(deny_unknown_fields)]
struct File {
    sources: std::collections::BTreeMap<String, String>,
    families: Vec<OilFamilyData>,
}

/// Family of the base oil.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash, Serialize, Deserialize, JsonSchema)]
#[serde(rename_all = "kebab-case", deny_unknown_fields)]
#[non_exhaustive]
pub enum OilFamily {
    /// Paraffinic mineral oil.
    Mineral,
    /// Naphthenic mineral oil.
    Naphthenic,
    /// Hydrocracked oil of API group III, automatic transmission fluid.
    GroupIii,
    /// Polyalphaolefin, e-fluids on that base.
    Pao,
    /// Ester.
    Ester,
    /// Polyalkylene glycol.
    Polyglycol,
}

impl From<BaseOil> for OilFamily {
    fn from(base: BaseOil) -> Self {
        match base {
            BaseOil::Mineral => Self::Mineral,
            BaseOil::Naphthenic => Self::Naphthenic,
            BaseOil::GroupIii => Self::GroupIii,
            BaseOil::Pao => Self::Pao,
            BaseOil::Ester => Self::Ester,
            BaseOil::Polyglycol => Self::Polyglycol,
        }
    }
}

impl From<OilFamily> for BaseOil {
    fn from(family: OilFamily) -> Self {
        match family {
            OilFamily::Mineral => Self::Mineral,
            OilFamily::Naphthenic => Self::Naphthenic,
            OilFamily::GroupIii => Self::GroupIii,
            OilFamily::Pao => Self::Pao,
            OilFamily::Ester => Self::Ester,
            OilFamily::Polyglycol => Self::Polyglycol,
        }
    }
}

impl OilFamily {
    /// Every family, in the order of the data file.
    pub const ALL: [Self; 6] = [
        Self::Mineral,
        Self::Naphthenic,
        Self::GroupIii,
        Self::Pao,
        Self::Ester,
        Self::Polyglycol,
    ];

    /// The name in a case file.
    #[must_use]
    pub const fn name(self) -> &'static str {
        match self {
            Self::Mineral => "mineral",
            Self::Naphthenic => "naphthenic",
            Self::GroupIii => "group-iii",
            Self::Pao => "pao",
            Self::Ester => "ester",
            Self::Polyglycol => "polyglycol",
        }
    }

    /// The constants of the family.
    ///
    /// # Errors
    /// When the data file does not read or lacks the family; a test reads them all.
    ///
    /// ```
    /// use asperity_tribo_friction::OilFamily;
    /// let pao = OilFamily::Pao.data()?;
    /// assert_eq!((pao.limiting_shear.value, pao.limiting_shear.low), (0.035, Some(0.030)));
    /// # Ok::<(), asperity_tribo_friction::FrictionError>(())
    /// ```
    pub fn data(self) -> Result<&'static OilFamilyData, FrictionError> {
        let lost = |reason: String| FrictionError::OilFamilies { reason };
        let file = file().as_ref().map_err(|reason| lost(reason.clone()))?;
        file.families
            .iter()
            .find(|family| family.name == self.name())
            .ok_or_else(|| lost(format!("no family {}", self.name())))
    }
}

impl OilFamily {
    /// Every constant of the family by the name that output gives it, Gold's of the base oil among them.
    ///
    /// # Errors
    /// As [`data`](Self::data).
    ///
    /// ```
    /// use asperity_tribo_friction::{OilFamily, film_friction::Mark};
    /// let constants = OilFamily::Ester.constants()?;
    /// assert!(constants.iter().any(|(name, value)| *name == "limiting_shear" && value.mark == Mark::Judged));
    /// # Ok::<(), asperity_tribo_friction::FrictionError>(())
    /// ```
    pub fn constants(self) -> Result<Vec<(&'static str, MarkedValue)>, FrictionError> {
        let data = self.data()?;
        let [factor, exponent] = BaseOil::from(self).gold_constants();
        // No constants of Group III were found; they are judged between those of mineral oil and PAO.
        let (mark, source) = match self {
            Self::GroupIii => (Mark::Judged, "own"),
            _ => (Mark::Memory, "gold_2001"),
        };
        let gold = |value: f64| MarkedValue {
            value,
            low: None,
            high: None,
            mark,
            source: source.to_owned(),
        };
        Ok(vec![
            ("limiting_shear", data.limiting_shear.clone()),
            ("eyring_stress_pa", data.eyring_stress.clone()),
            ("conductivity_w_per_m_k", data.conductivity.clone()),
            ("conductivity_rise_per_gpa", data.conductivity_rise.clone()),
            ("conductivity_bend_per_gpa", data.conductivity_bend.clone()),
            ("gold_factor_per_gpa", gold(factor)),
            ("gold_exponent", gold(exponent)),
        ])
    }
}

/// Text of the source with this key.
///
/// ```
/// use asperity_tribo_friction::film_friction::family_source;
/// assert!(family_source("arana_2019").is_some_and(|text| text.contains("Arana")));
/// ```
#[must_use]
pub fn family_source(key: &str) -> Option<&'static str> {
    let file = file().as_ref().ok()?;
    file.sources.get(key).map(String::as_str)
}

fn file() -> &'static Result<File, String> {
    static FILE: OnceLock<Result<File, String>> = OnceLock::new();
    FILE.get_or_init(|| serde_json::from_str(DATA).map_err(|error| error.to_string()))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn every_number_lies_in_its_band_and_names_a_source() {
        for family in OilFamily::ALL {
            let data = family.data().unwrap();
            for number in [
                &data.limiting_shear,
                &data.eyring_stress,
                &data.conductivity,
                &data.conductivity_rise,
                &data.conductivity_bend,
            ] {
                assert!(number.value > 0.0);
                assert!(number.low.is_none_or(|low| low < number.value));
                assert!(number.high.is_none_or(|high| high > number.value));
                assert!(family_source(&number.source).is_some(), "{}", number.source);
            }
            for (name, constant) in family.constants().unwrap() {
                assert!(family_source(&constant.source).is_some(), "{name}");
            }
            assert!(data.limiting_shear.low.is_some() && data.limiting_shear.high.is_some());
        }
        assert_eq!(
            file().as_ref().unwrap().families.len(),
            OilFamily::ALL.len()
        );
    }
}
