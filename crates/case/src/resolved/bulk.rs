//! Law of the bulk temperature: stated, or from the oil and the loss.

use asperity_core::DomainError;
use asperity_core::quantity::ThermalConductance;
use asperity_efficiency::bulk_temperature::Network;
use serde::{Deserialize, Serialize};

use crate::input::bulk_input::{BulkInput, BulkLaw, Lubrication};
use crate::input::law_names::{FullFilmName, LoadShareName};
use crate::input::model::Model;
use crate::source::case_error::CaseError;
use crate::source::section::{Section, in_train};
use crate::source::source_text::Source;

/// Law of the bulk temperature with its numbers.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum BulkModel {
    /// Oster's rise.
    Iso(Lubrication),
    /// Conductances.
    Network(Network),
}

/// The bulk temperature of a run that follows from its loss.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
pub struct BulkReport {
    /// Law of the rise: `iso` with the lubrication, as in `iso, unconfirmed, jet`, or `network`.
    pub law: String,
    /// Temperature of the oil \[°C\].
    pub oil_c: f64,
    /// Bulk temperature at which film and friction are computed \[°C\].
    pub bulk_c: f64,
    /// Bulk temperatures of pinion and wheel \[°C\], if the law distinguishes them; `bulk_c` is their mean.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub gears_c: Option<[f64; 2]>,
    /// Share of the frictional heat that goes into the pinion, if the law needs it.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub pinion_heat_share: Option<f64>,
    /// Change of the temperature in a further step \[K\].
    pub residual_k: f64,
    /// Number of steps.
    pub steps: usize,
    /// A second, hotter equilibrium temperature \[°C\].
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub hotter_c: Option<f64>,
    /// Start from which no equilibrium is reached \[°C\]: friction heats the flanks further, or leaves the range of its
    /// laws.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub runs_away_from_c: Option<f64>,
}

/// The law of the bulk temperature, if the case states one. A message about the law of a single mesh has its key in the gear
/// train.
pub(crate) fn bulk_model(
    stated: Option<&BulkInput>,
    model: &Model,
    source: &Source,
) -> Result<Option<BulkModel>, CaseError> {
    checked(stated, model, source).map_err(|error| in_train(source, error))
}

fn checked(
    stated: Option<&BulkInput>,
    model: &Model,
    source: &Source,
) -> Result<Option<BulkModel>, CaseError> {
    let Some(&BulkInput {
        law,
        lubrication,
        pinion_to_oil,
        wheel_to_oil,
        between,
    }) = stated
    else {
        return Ok(None);
    };
    let section = Section::new(source, "operation.bulk");
    if model.load_share == LoadShareName::Ehl || model.full_film != FullFilmName::Formulas {
        let rule = "runs the mesh some twenty times, which ehl solutions make too long; find the temperature with load_share = \"solved\" and state it as operation.bulk_temperature";
        return Err(section.conflict_of_key("", rule));
    }
    let has_conductances = [pinion_to_oil, wheel_to_oil, between]
        .iter()
        .any(Option::is_some);
    match law {
        BulkLaw::Iso if has_conductances => {
            let rule = "takes conductances with law = \"network\" only";
            Err(section.conflict_of_key("", rule))
        }
        BulkLaw::Iso => {
            let rule = "is missing: \"jet\", \"dip\", \"jet-and-dip\" or \"submerged\"";
            let missing = || section.conflict_of_key("lubrication", rule);
            Ok(Some(BulkModel::Iso(lubrication.ok_or_else(missing)?)))
        }
        BulkLaw::Network if lubrication.is_some() => {
            let rule = "is used with law = \"iso\" only";
            Err(section.conflict_of_key("lubrication", rule))
        }
        BulkLaw::Network => {
            let to_oil = |name, conductance: Option<ThermalConductance>| -> Result<_, CaseError> {
                let missing = || section.conflict_of_key(name, "is missing, as \"12 W/K\"");
                let conductance = conductance.ok_or_else(missing)?;
                DomainError::positive("conductance", conductance).map_err(section.domain(name))?;
                Ok(conductance)
            };
            let between = between.unwrap_or(ThermalConductance::from_si(0.0));
            DomainError::non_negative("conductance", between).map_err(section.domain("between"))?;
            Ok(Some(BulkModel::Network(Network {
                to_oil: [
                    to_oil("pinion_to_oil", pinion_to_oil)?,
                    to_oil("wheel_to_oil", wheel_to_oil)?,
                ],
                between,
            })))
        }
    }
}
