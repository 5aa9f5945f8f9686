//! Keys of the bulk temperature that follows from oil and loss.

use asperity_core::quantity::ThermalConductance;
use serde::{Deserialize, Serialize};

use super::rows::table;

table! {
    /// Bulk temperature from the loss: by conductances, or `{ law = "iso", lubrication = "jet" }`.
    #[derive(Copy)]
    BulkInput;

    /// Law of the rise over the oil: `network` takes conductances, `iso` (unconfirmed) how the oil is supplied.
    law: BulkLaw;
    /// How the oil reaches the mesh, with `iso`.
    #[serde(skip_serializing_if = "Option::is_none")]
    lubrication: Option<Lubrication>;
    /// Conductance from the pinion to the oil, with `network`.
    #[serde(skip_serializing_if = "Option::is_none")]
    pinion_to_oil: Option<ThermalConductance> = "W/K" usual [0.05, 5000.0] possible [1e-4, 1e6];
    /// Conductance from the wheel to the oil, with `network`.
    #[serde(skip_serializing_if = "Option::is_none")]
    wheel_to_oil: Option<ThermalConductance> = "W/K" usual [0.05, 5000.0] possible [1e-4, 1e6];
    /// Conductance from gear to gear, with `network`; default 0 W/K.
    #[serde(skip_serializing_if = "Option::is_none")]
    between: Option<ThermalConductance> = "W/K" usual [0.01, 500.0] possible [1e-4, 1e6];
}

/// Law of the rise of the bulk temperature over the oil.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Serialize, Deserialize)]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
#[serde(rename_all = "kebab-case")]
pub enum BulkLaw {
    /// Oster's rise, as in ISO/TR 15144-1; unconfirmed, as no accessible source has its constants.
    Iso,
    /// Two gears with conductances to the oil and between them.
    Network,
}

/// How the oil reaches the mesh.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Serialize, Deserialize)]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
#[serde(rename_all = "kebab-case")]
pub enum Lubrication {
    /// Oil jets only.
    Jet,
    /// Gears that dip into the oil.
    Dip,
    /// Jets in addition to a sump into which the gears dip.
    JetAndDip,
    /// Gears submerged in oil.
    Submerged,
}

impl Lubrication {
    /// Factor X_S of the lubrication (ISO/TR 15144-1, unconfirmed).
    #[must_use]
    pub const fn factor(self) -> f64 {
        match self {
            Self::Jet => 1.2,
            Self::Dip | Self::JetAndDip => 1.0,
            Self::Submerged => 0.2,
        }
    }
}
