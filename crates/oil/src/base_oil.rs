//! Families of base oils, and the constants that no data sheet states.
//!
//! | symbol | field | unit |
//! |---|---|---|
//! | Λ | `limiting_shear`, limiting shear stress over pressure at 90 °C | - |
//! | τ₀ | `eyring_stress` | Pa |
//! | k | `conductivity` at ambient pressure | W/(m K) |
//! | c₁, c₂ | `conductivity_rise`, `conductivity_bend` in k(p) = k (1 + c₁ p/(1 + c₂ p)) | 1/GPa |
//!
//! The numbers are data (`data/oil_families.json`), each with its range if one is known, its source and its
//! confidence ([`Mark`]). Effects of additives are not included.

use std::collections::BTreeMap;
use std::sync::OnceLock;

use asperity_core::quantity::PerKelvin;
use serde::{Deserialize, Serialize};

use crate::LubricantError;

const DATA: &str = include_str!("../data/oil_families.json");

/// Class of base oil.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash, Serialize, Deserialize)]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
#[serde(rename_all = "kebab-case")]
pub enum BaseOil {
    /// Paraffinic mineral oil.
    #[serde(alias = "Mineral", alias = "mineral oil")]
    Mineral,
    /// Naphthenic mineral oil: constants of paraffinic oil, which underrate its α.
    #[serde(alias = "Naphthenic")]
    Naphthenic,
    /// Hydrocracked oil of API group III, automatic transmission fluid (assumed between its neighbours).
    #[serde(alias = "Group III", alias = "group III")]
    GroupIii,
    /// Polyalphaolefin, e-fluids on that base.
    #[serde(alias = "PAO", alias = "polyalphaolefin")]
    Pao,
    /// Ester.
    #[serde(alias = "Ester")]
    Ester,
    /// Polyalkylene glycol.
    #[serde(alias = "Polyglycol", alias = "PAG", alias = "pag")]
    Polyglycol,
}

/// A constant of film or boundary layer, serialised as its name with its unit.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash, Serialize, Deserialize)]
#[serde(rename_all = "snake_case")]
#[non_exhaustive]
pub enum FilmConstantName {
    /// Limiting shear stress over pressure.
    LimitingShear,
    /// Eyring stress.
    #[serde(rename = "eyring_stress_pa")]
    EyringStress,
    /// Fall of the limiting shear stress with temperature.
    #[serde(rename = "limiting_shear_temperature_per_k")]
    LimitingShearTemperature,
    /// Factor on the pressure-viscosity coefficient in the friction.
    PressureViscosityFactor,
    /// Thermal conductivity.
    #[serde(rename = "conductivity_w_per_m_k")]
    Conductivity,
    /// Rise of the conductivity with pressure.
    #[serde(rename = "conductivity_rise_per_gpa")]
    ConductivityRise,
    /// Bend of this rise.
    #[serde(rename = "conductivity_bend_per_gpa")]
    ConductivityBend,
    /// Factor of Gold's law.
    #[serde(rename = "gold_factor_per_gpa")]
    GoldFactor,
    /// Exponent of Gold's law.
    GoldExponent,
    /// Boundary friction.
    BoundaryFriction,
    /// Thickness of the boundary layer.
    #[serde(rename = "boundary_layer_m")]
    BoundaryLayer,
    /// Share of the elastic energy lost by hysteresis.
    Hysteresis,
}

/// Confidence in a number.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash, Serialize, Deserialize)]
#[serde(rename_all = "kebab-case")]
pub enum Mark {
    /// Read in its source.
    Seen,
    /// Fitted here to measurements of its source.
    Calibrated,
    /// Assumed by this project.
    Judged,
}

/// A number with its range, its source and its confidence.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct MarkedValue {
    /// The default.
    pub value: f64,
    /// Lower end of the range, if known.
    pub low: Option<f64>,
    /// Upper end of the range, if known.
    pub high: Option<f64>,
    /// Confidence.
    pub mark: Mark,
    /// Key of the source.
    pub source: String,
}

/// Constants of a base oil for film friction.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct BaseOilData {
    /// Name of the base oil in a case file.
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
struct DataFile {
    sources: BTreeMap<String, String>,
    families: Vec<BaseOilData>,
}

impl BaseOil {
    /// Every base oil, in the order of the data file.
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

    /// Gold's s \[1/GPa\] and t of α = s ν^t (Fernandes and others 2013, α at 0.2 GPa).
    ///
    /// ```
    /// use asperity_oil::BaseOil;
    /// assert_eq!(BaseOil::Pao.gold_constants(), [7.382, 0.1335]);
    /// ```
    #[must_use]
    pub const fn gold_constants(self) -> [f64; 2] {
        match self {
            Self::Mineral | Self::Naphthenic => [9.904, 0.1390],
            Self::GroupIii => [8.5, 0.1360],
            Self::Pao => [7.382, 0.1335],
            Self::Ester => [6.605, 0.1360],
            Self::Polyglycol => [5.489, 0.1485],
        }
    }

    /// Thermal expansion relative to the density at 15 °C (Fernandes and others 2013).
    #[must_use]
    pub const fn thermal_expansion(self) -> PerKelvin {
        PerKelvin::from_si(match self {
            Self::Mineral | Self::Naphthenic | Self::GroupIii => 5.8e-4,
            Self::Pao => 5.5e-4,
            Self::Ester => 8.1e-4,
            Self::Polyglycol => 7.1e-4,
        })
    }

    /// The constants for film friction.
    ///
    /// # Errors
    /// When the data file cannot be read or lacks the base oil; a test reads them all.
    ///
    /// ```
    /// use asperity_oil::BaseOil;
    /// let pao = BaseOil::Pao.data()?;
    /// assert_eq!((pao.limiting_shear.value, pao.limiting_shear.low), (0.035, Some(0.030)));
    /// # Ok::<(), asperity_oil::LubricantError>(())
    /// ```
    pub fn data(self) -> Result<&'static BaseOilData, LubricantError> {
        let unreadable = |reason: String| LubricantError::base_oils(reason);
        let file = data_file()
            .as_ref()
            .map_err(|reason| unreadable(reason.clone()))?;
        file.families
            .iter()
            .find(|family| family.name == self.name())
            .ok_or_else(|| unreadable(format!("no family {}", self.name())))
    }

    /// Every constant by its name in a result, including Gold's.
    ///
    /// # Errors
    /// As [`data`](Self::data).
    ///
    /// ```
    /// use asperity_oil::{BaseOil, FilmConstantName, Mark};
    /// let constants = BaseOil::Ester.constants()?;
    /// let judged = (FilmConstantName::LimitingShear, Mark::Judged);
    /// assert!(constants.iter().any(|(name, value)| (*name, value.mark) == judged));
    /// # Ok::<(), asperity_oil::LubricantError>(())
    /// ```
    pub fn constants(self) -> Result<Vec<(FilmConstantName, MarkedValue)>, LubricantError> {
        use FilmConstantName as Name;
        let data = self.data()?;
        let [factor, exponent] = self.gold_constants();
        // No source states constants of group III; they are judged between those of mineral oil and PAO.
        let (mark, source) = match self {
            Self::GroupIii => (Mark::Judged, "own"),
            _ => (Mark::Seen, "gold_2001"),
        };
        let gold = |value: f64| MarkedValue {
            value,
            low: None,
            high: None,
            mark,
            source: source.to_owned(),
        };
        Ok(vec![
            (Name::LimitingShear, data.limiting_shear.clone()),
            (Name::EyringStress, data.eyring_stress.clone()),
            (Name::Conductivity, data.conductivity.clone()),
            (Name::ConductivityRise, data.conductivity_rise.clone()),
            (Name::ConductivityBend, data.conductivity_bend.clone()),
            (Name::GoldFactor, gold(factor)),
            (Name::GoldExponent, gold(exponent)),
        ])
    }
}

/// Text of the source of a [`MarkedValue`] by its key.
///
/// ```
/// use asperity_oil::base_oil_source;
/// assert!(base_oil_source("arana_2019").is_some_and(|text| text.contains("Arana")));
/// ```
#[must_use]
pub fn base_oil_source(key: &str) -> Option<&'static str> {
    let file = data_file().as_ref().ok()?;
    file.sources.get(key).map(String::as_str)
}

fn data_file() -> &'static Result<DataFile, String> {
    static FILE: OnceLock<Result<DataFile, String>> = OnceLock::new();
    FILE.get_or_init(|| serde_json::from_str(DATA).map_err(|error| error.to_string()))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn every_number_lies_in_its_range_and_names_a_source() {
        for family in BaseOil::ALL {
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
                assert!(
                    base_oil_source(&number.source).is_some(),
                    "{}",
                    number.source
                );
            }
            for (name, constant) in family.constants().unwrap() {
                assert!(base_oil_source(&constant.source).is_some(), "{name:?}");
            }
            assert!(data.limiting_shear.low.is_some() && data.limiting_shear.high.is_some());
        }
        assert_eq!(
            data_file().as_ref().unwrap().families.len(),
            BaseOil::ALL.len()
        );
    }
}
