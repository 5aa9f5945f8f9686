//! Keys of the heat balance of a gear train.

use asperity_core::DomainError;
use asperity_core::quantity::{Power, Temperature, ThermalConductance};
use serde::{Deserialize, Serialize};

/// Heat from the oil through the housing to the ambient air.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
#[serde(deny_unknown_fields)]
pub struct HeatInput {
    /// Temperature of the ambient air.
    pub ambient: Temperature,
    /// Conductance from oil to housing.
    pub oil_to_housing: ThermalConductance,
    /// Conductance from housing to ambient air.
    pub housing_to_ambient: ThermalConductance,
    /// Losses of other parts that heat the oil: seals, bearings, churning; default 0 W.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub other_losses: Option<Power>,
}

impl HeatInput {
    /// Checks the numbers; an error has the name of its key.
    pub(super) fn check(&self) -> Result<(), (&'static str, DomainError)> {
        let of = |key| move |error| (key, error);
        DomainError::positive("conductance", self.oil_to_housing).map_err(of("oil_to_housing"))?;
        DomainError::positive("conductance", self.housing_to_ambient)
            .map_err(of("housing_to_ambient"))?;
        let other = self.other_losses.unwrap_or(Power::from_si(0.0));
        DomainError::non_negative("loss", other).map_err(of("other_losses"))?;
        Ok(())
    }
}
