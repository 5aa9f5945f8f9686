//! How the bulk temperature of the flanks comes about: given, or from the oil and the loss.

use asperity_core::DomainError;
use asperity_core::quantity::ThermalConductance;
use asperity_efficiency::bulk_temperature::Network;
use serde::{Deserialize, Serialize};

use super::bulk_input::{BulkInput, BulkLaw, Lubrication};
use super::domain::domain;
use super::error::CaseError;
use super::input::{CaseInput, Formulation};
use super::law_names::{FullFilmName, LoadShareName};
use super::model::Model;
use super::source::Source;

/// Law of the bulk temperature with its numbers.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum BulkModel {
    /// Oster's rise.
    Iso(Lubrication),
    /// Conductances.
    Network(Network),
}

/// The bulk temperature of a run, found from its loss.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
#[non_exhaustive]
pub struct BulkReport {
    /// Law of the rise: `iso` with the lubrication, as in `iso, jet`, or `network`.
    pub law: String,
    /// Temperature of the oil \[°C\].
    pub oil_c: f64,
    /// Bulk temperature that film and friction were taken at \[°C\].
    pub bulk_c: f64,
    /// Bulk temperatures of pinion and wheel \[°C\], where the law tells them apart; `bulk_c` is their mean.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub gears_c: Option<[f64; 2]>,
    /// Share of the frictional heat that goes into the pinion, where the law asks.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub pinion_heat_share: Option<f64>,
    /// How far the next step would move it \[K\].
    pub residual_k: f64,
    /// Steps taken.
    pub steps: usize,
    /// A hotter temperature that keeps itself up too \[°C\].
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub hotter_c: Option<f64>,
    /// Start from which no temperature that keeps itself up was found \[°C\]: friction heats the flanks further, or
    /// leaves the range of its laws.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub runs_away_from_c: Option<f64>,
}

/// The bulk temperature of a case that states the temperature of its oil, and the case as stated.
#[derive(Debug, Clone, PartialEq)]
pub struct FoundBulk {
    /// The case as stated, with the temperature of the oil.
    pub stated: Box<CaseInput>,
    /// The temperature.
    pub report: BulkReport,
}

/// The law that a case asks for.
pub(super) fn bulk_model(
    given: Option<&BulkInput>,
    formulation: Formulation,
    model: &Model,
    source: &Source,
) -> Result<Option<BulkModel>, CaseError> {
    let Some(given) = given else {
        return Ok(None);
    };
    let conflict = |key: &'static str, rule| CaseError::Conflict {
        place: source.place_of_key(key),
        key,
        rule,
    };
    if formulation != Formulation::Corrected {
        return Err(conflict(
            "operation.bulk",
            "belongs to the corrected formulation; leave one of the two out",
        ));
    }
    if model.load_share == LoadShareName::Ehl || model.full_film != FullFilmName::Formulas {
        return Err(conflict(
            "operation.bulk",
            "runs the mesh some twenty times, which ehl solutions make too long; find the temperature with load_share = \"solved\" and give it as operation.temperature",
        ));
    }
    let is_given = [given.pinion_to_oil, given.wheel_to_oil, given.between].map(|g| g.is_some());
    match given.law {
        BulkLaw::Iso if is_given != [false; 3] => Err(conflict(
            "operation.bulk",
            "takes conductances with law = \"network\" only",
        )),
        BulkLaw::Iso => {
            let rule = "is missing: \"jet\", \"dip\", \"jet-and-dip\" or \"submerged\"";
            let lubrication = given.lubrication;
            let of = lubrication.ok_or_else(|| conflict("operation.bulk.lubrication", rule))?;
            Ok(Some(BulkModel::Iso(of)))
        }
        BulkLaw::Network if given.lubrication.is_some() => Err(conflict(
            "operation.bulk.lubrication",
            "is used with law = \"iso\" only",
        )),
        BulkLaw::Network => {
            let rule = "is missing, as \"12 W/K\"";
            let to_oil = |key, found: Option<ThermalConductance>| -> Result<_, CaseError> {
                let found = found.ok_or_else(|| conflict(key, rule))?;
                DomainError::positive("conductance", found).map_err(domain(source, key))?;
                Ok(found)
            };
            let between = given.between.unwrap_or(ThermalConductance::from_si(0.0));
            DomainError::non_negative("conductance", between)
                .map_err(domain(source, "operation.bulk.between"))?;
            Ok(Some(BulkModel::Network(Network {
                to_oil: [
                    to_oil("operation.bulk.pinion_to_oil", given.pinion_to_oil)?,
                    to_oil("operation.bulk.wheel_to_oil", given.wheel_to_oil)?,
                ],
                between,
            })))
        }
    }
}
