//! Keys of the heat balance of a gear train.

use asperity_core::DomainError;
use asperity_core::quantity::{Power, Temperature, ThermalConductance};

use super::rows::table;

table! {
    /// Heat from the oil through the housing to the ambient air.
    HeatInput;

    /// Temperature of the ambient air.
    ambient: Temperature = "°C" usual [-50.0, 70.0] possible [-100.0, 150.0];
    /// Conductance from oil to housing.
    oil_to_housing: ThermalConductance = "W/K" usual [0.5, 20_000.0] possible [0.001, 1e6];
    /// Conductance from housing to ambient air.
    housing_to_ambient: ThermalConductance = "W/K" usual [0.2, 5000.0] possible [0.001, 1e6];
    /// Losses of other parts that heat the oil: seals, bearings, churning; default 0 W.
    #[serde(skip_serializing_if = "Option::is_none")]
    other_losses: Option<Power> = "W" usual [0.1, 1e6] possible [1e-6, 1e9];
}

impl HeatInput {
    /// Checks the numbers; an error has the name of its key.
    pub(crate) fn check(&self) -> Result<(), (&'static str, DomainError)> {
        let of = |key| move |error| (key, error);
        DomainError::positive("conductance", self.oil_to_housing).map_err(of("oil_to_housing"))?;
        DomainError::positive("conductance", self.housing_to_ambient)
            .map_err(of("housing_to_ambient"))?;
        let other = self.other_losses.unwrap_or(Power::from_si(0.0));
        DomainError::non_negative("loss", other).map_err(of("other_losses"))?;
        Ok(())
    }
}
