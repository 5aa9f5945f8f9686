//! The dimensionless groups of elastohydrodynamics.
//!
//! | symbol | meaning | unit |
//! |---|---|---|
//! | G | material group α E′ | - |
//! | U | speed group η₀ V_e/(E′ R) | - |
//! | W | load group w/(E′ R), or F/(E′ R²) for a total force F | - |
//! | α | pressure-viscosity coefficient | 1/Pa |
//! | η₀ | viscosity at the inlet temperature and ambient pressure | Pa s |
//! | V_e | mean surface speed (u₁ + u₂)/2 | m/s |
//! | R | relative radius of curvature in the direction of motion | m |
//! | w | load per length of contact line | N/m |
//! | E′ | 2 E*, twice the reduced modulus | Pa |
//!
//! Definitions as in D. Dowson and G. R. Higginson (1977). Moes' numbers with the sum of the
//! surface speeds are formed from these in [`film_line::moes`](crate::film_line::moes).

use asperity_core::quantity::{
    DynamicViscosity, Force, Length, LineLoad, Pressure, PressureViscosity, Speed,
};
use asperity_core::{DomainError, cite};
use serde::Serialize;

use crate::error::RegimeError;

/// One mesh position: the inputs of a film law.
#[derive(Debug, Clone, Copy, PartialEq, Serialize)]
pub struct FilmConditions {
    /// Mean surface speed V_e = (u₁ + u₂)/2.
    pub entrainment: Speed,
    /// Relative radius of curvature R.
    pub radius: Length,
    /// Load per length of contact line w.
    pub load: LineLoad,
    /// Reduced modulus E* (E′ = 2 E* is formed inside).
    pub modulus: Pressure,
    /// Viscosity η₀ at the inlet temperature and ambient pressure.
    pub viscosity: DynamicViscosity,
    /// Pressure-viscosity coefficient α.
    pub pressure_viscosity: PressureViscosity,
    /// Length l that makes the line load a force, F = w l; only the reading W = F/(E′R²) of
    /// [`FilmLaw::HamrockDowson`](crate::FilmLaw::HamrockDowson) needs it.
    pub contact_length: Option<Length>,
}

/// The groups G, U, W.
#[derive(Debug, Clone, Copy, PartialEq, Serialize)]
pub struct FilmGroups {
    /// Material group G = α E′.
    pub material: f64,
    /// Speed group U = η₀ V_e/(E′ R).
    pub speed: f64,
    /// Load group W.
    pub load: f64,
}

impl FilmConditions {
    /// The groups of a line contact.
    ///
    /// ```text
    /// G = α E′,  U = η₀ V_e/(E′ R),  W = w/(E′ R),  E′ = 2 E*                [Film-groups]
    /// ```
    ///
    /// # Errors
    /// When a quantity is not finite and positive.
    ///
    /// ```
    /// use asperity_ehl_regime::FilmConditions;
    /// let groups = FilmConditions {
    ///     entrainment: "2 m/s".parse()?, radius: "10 mm".parse()?, load: "100 N/mm".parse()?,
    ///     modulus: "100 GPa".parse()?, viscosity: "100 mPa s".parse()?,
    ///     pressure_viscosity: "20 1/GPa".parse()?, contact_length: None,
    /// }.line_groups()?;
    /// assert!((groups.material - 4000.0).abs() < 1e-9);
    /// assert!((groups.speed - 1e-10).abs() < 1e-22);
    /// assert!((groups.load - 5e-5).abs() < 1e-17);
    /// # Ok::<(), Box<dyn std::error::Error>>(())
    /// ```
    pub fn line_groups(&self) -> Result<FilmGroups, RegimeError> {
        cite!("Film-groups");
        let (modulus, radius) = self.scales()?;
        let load = DomainError::positive("line load", self.load)?;
        self.with_load_group(load / (modulus * radius))
    }

    /// The groups with W = F/(E′ R²) for a total force F.
    ///
    /// # Errors
    /// When a quantity is not finite and positive.
    pub fn force_groups(&self, force: Force) -> Result<FilmGroups, RegimeError> {
        cite!("Film-groups");
        let (modulus, radius) = self.scales()?;
        let force = DomainError::positive("force", force)?;
        self.with_load_group(force / (modulus * radius * radius))
    }

    /// E′ and R.
    fn scales(&self) -> Result<(f64, f64), DomainError> {
        Ok((
            2.0 * DomainError::positive("reduced modulus", self.modulus)?,
            DomainError::positive("radius", self.radius)?,
        ))
    }

    fn with_load_group(&self, load: f64) -> Result<FilmGroups, RegimeError> {
        let (modulus, radius) = self.scales()?;
        let alpha = DomainError::positive("pressure-viscosity", self.pressure_viscosity)?;
        let viscosity = DomainError::positive("viscosity", self.viscosity)?;
        let entrainment = DomainError::positive("entrainment speed", self.entrainment)?;
        Ok(FilmGroups {
            material: alpha * modulus,
            speed: viscosity * entrainment / (modulus * radius),
            load,
        })
    }
}
