//! The constants of a run that are uncertain.

use serde::{Deserialize, Serialize};

use crate::input::calibration::CalibratedName;
use crate::resolved::oil_file::FittedName;

/// An uncertain constant.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Serialize, Deserialize)]
#[serde(rename_all = "kebab-case")]
pub enum UncertainParameter {
    /// Coefficient of boundary friction μ_b.
    BoundaryFriction,
    /// Thickness of the boundary layer h_b \[m\].
    BoundaryLayer,
    /// Lay γ, mean of both flanks.
    Lay,
    /// Limiting shear stress over pressure Λ.
    LimitingShear,
    /// Eyring stress τ₀ \[Pa\].
    EyringStress,
    /// Pressure-viscosity coefficient α at the bulk temperature \[1/Pa\].
    PressureViscosity,
    /// Fall of ln Λ with temperature b_L \[1/K\].
    LimitingShearTemperature,
    /// Ratio f of the pressure-viscosity coefficient of the friction to the coefficient of the film thickness.
    PressureViscosityFactor,
    /// Error of the stated temperature \[K\].
    TemperatureError,
}

impl From<CalibratedName> for UncertainParameter {
    fn from(name: CalibratedName) -> Self {
        match name {
            CalibratedName::BoundaryFriction => Self::BoundaryFriction,
            CalibratedName::BoundaryLayer => Self::BoundaryLayer,
            CalibratedName::LimitingShear => Self::LimitingShear,
            CalibratedName::EyringStress => Self::EyringStress,
        }
    }
}

impl UncertainParameter {
    /// All constants.
    pub const ALL: [Self; 9] = [
        Self::BoundaryFriction,
        Self::BoundaryLayer,
        Self::Lay,
        Self::LimitingShear,
        Self::EyringStress,
        Self::PressureViscosity,
        Self::LimitingShearTemperature,
        Self::PressureViscosityFactor,
        Self::TemperatureError,
    ];

    /// Its name in the table `calibration` of a case.
    #[must_use]
    pub(crate) const fn calibrated_name(self) -> Option<CalibratedName> {
        match self {
            Self::BoundaryFriction => Some(CalibratedName::BoundaryFriction),
            Self::BoundaryLayer => Some(CalibratedName::BoundaryLayer),
            Self::LimitingShear => Some(CalibratedName::LimitingShear),
            Self::EyringStress => Some(CalibratedName::EyringStress),
            _ => None,
        }
    }

    /// Its name in an oil file.
    #[must_use]
    pub const fn fitted_name(self) -> Option<FittedName> {
        match self {
            Self::LimitingShear => Some(FittedName::LimitingShear),
            Self::EyringStress => Some(FittedName::EyringStress),
            Self::LimitingShearTemperature => Some(FittedName::LimitingShearTemperature),
            Self::PressureViscosityFactor => Some(FittedName::PressureViscosityFactor),
            _ => None,
        }
    }

    /// Its name in words.
    #[must_use]
    pub const fn name(self) -> &'static str {
        match self {
            Self::BoundaryFriction => "boundary friction",
            Self::BoundaryLayer => "boundary layer",
            Self::Lay => "lay",
            Self::LimitingShear => "limiting shear",
            Self::EyringStress => "Eyring stress",
            Self::PressureViscosity => "pressure-viscosity",
            Self::LimitingShearTemperature => "fall of the limiting shear",
            Self::PressureViscosityFactor => "pressure-viscosity factor of the friction",
            Self::TemperatureError => "error of the temperature",
        }
    }

    /// Its unit; "-" for a number.
    #[must_use]
    pub const fn unit(self) -> &'static str {
        match self {
            Self::BoundaryLayer => "m",
            Self::EyringStress => "Pa",
            Self::PressureViscosity => "1/Pa",
            Self::LimitingShearTemperature => "1/K",
            Self::TemperatureError => "K",
            _ => "-",
        }
    }

    /// Whether the film and the roughness in it depend on it, and not only their friction.
    #[must_use]
    pub const fn changes_film(self) -> bool {
        matches!(
            self,
            Self::Lay | Self::PressureViscosity | Self::TemperatureError
        )
    }
}

// The number of a constant is its place among all.
const _: () = {
    let mut k = 0;
    while k < UncertainParameter::ALL.len() {
        assert!(UncertainParameter::ALL[k] as usize == k);
        k += 1;
    }
};
