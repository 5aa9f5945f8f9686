//! Oil of a lubricated contact: its state at the inlet, and its laws by name.

use asperity_core::DomainError;
use asperity_core::quantity::{DynamicViscosity, PressureViscosity};
use asperity_oil::{DensityLaw, PressureViscosityLaw, RelativeViscosity, ShearLaw};
use serde::{Deserialize, Serialize};

/// Oil of a lubricated contact at the temperature of its inlet.
///
/// ```
/// use asperity_ehl::Oil;
/// use asperity_oil::{DensityLaw, PressureViscosityLaw, ShearLaw};
/// let oil = Oil {
///     viscosity: "10 mPa s".parse()?,
///     pressure_viscosity: "18 1/GPa".parse()?,
///     viscosity_law: PressureViscosityLaw::Roelands { exponent: 0.6 },
///     density_law: DensityLaw::DowsonHigginson,
///     shear_law: ShearLaw::Eyring { stress: "5 MPa".parse()? },
/// };
/// oil.validate()?;
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
#[derive(Debug, Clone, Copy, PartialEq, Serialize, Deserialize)]
pub struct Oil {
    /// Viscosity η₀ at ambient pressure.
    pub viscosity: DynamicViscosity,
    /// Pressure-viscosity coefficient α; unused by an isoviscous oil.
    pub pressure_viscosity: PressureViscosity,
    /// Law of viscosity against pressure.
    pub viscosity_law: PressureViscosityLaw,
    /// Law of density against pressure.
    pub density_law: DensityLaw,
    /// Law of shear stress against shear rate.
    pub shear_law: ShearLaw,
}

impl Oil {
    /// Checks every constant of the oil.
    ///
    /// # Errors
    /// When a constant is outside its domain.
    pub fn validate(&self) -> Result<(), DomainError> {
        DomainError::positive("viscosity", self.viscosity)?;
        self.viscosity_law.validate(self.pressure_viscosity)?;
        self.shear_law.validate()
    }

    /// Viscosity over the pressure in units of `unit` \[Pa\].
    pub(crate) fn viscosity_over(&self, unit: f64) -> RelativeViscosity {
        self.viscosity_law.relative(self.pressure_viscosity, unit)
    }
}
