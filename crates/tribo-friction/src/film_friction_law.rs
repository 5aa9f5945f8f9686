//! Friction law of the film as an extension point: the laws of this crate and user-defined laws.
//!
//! A law gets the whole local contact ([`FilmContact`]): a regression reads `position`, a law that
//! integrates shear stress over the contact reads speeds, moduli, temperatures, steels and the oil at
//! any temperature as well.

use std::fmt::Debug;

use asperity_core::Checked;
use asperity_core::material::Material;
use asperity_core::quantity::{Length, Pressure, Speed, Temperature};
use asperity_oil::{Lubricant, LubricantState};

use crate::conditions::FrictionConditions;
use crate::error::FrictionError;
use crate::friction_law::{FrictionLaw, FrictionSettings};

/// Local contact at one mesh position: the inputs of a film friction law.
#[derive(Debug, Clone, Copy)]
pub struct FilmContact<'a> {
    /// Load, radius, speeds, film thickness with thermal reduction, and roughness of the pair.
    pub position: FrictionConditions,
    /// Surface speeds u₁ and u₂.
    pub surface_speeds: [Speed; 2],
    /// Reduced modulus E*.
    pub modulus: Pressure,
    /// Hertz half-width a.
    pub half_width: Length,
    /// Share of the load that the film carries, at whose pressure a law of film friction shears it; 1 with
    /// `film_pressure = "hertz"`.
    pub film_share: f64,
    /// Steel of both bodies, with conductivity, density and specific heat.
    pub materials: [Material; 2],
    /// Bulk temperature of the flanks and of the oil at the inlet.
    pub bulk_temperature: Temperature,
    /// Oil at the temperature that `position` was made for: bulk, or bulk and flash with feedback.
    pub oil: LubricantState,
    /// Oil at any temperature.
    pub lubricant: &'a Lubricant,
}

/// Friction in the film.
#[derive(Debug, Clone, Copy, PartialEq)]
#[non_exhaustive]
pub struct FilmTraction {
    /// Friction coefficient of the film.
    pub coefficient: f64,
    /// Mean temperature rise of the surfaces \[K\], of laws that compute it.
    pub surface_rise: Option<f64>,
    /// Largest mean temperature rise across the film above the surfaces \[K\], of laws that compute it.
    pub film_rise: Option<f64>,
}

impl FilmTraction {
    /// A coefficient of a law that computes no temperatures.
    #[must_use]
    pub const fn from_coefficient(coefficient: f64) -> Self {
        Self {
            coefficient,
            surface_rise: None,
            film_rise: None,
        }
    }

    /// Adds the temperature rises \[K\] of surfaces and film.
    #[must_use]
    pub const fn with_rises(self, surface: f64, film: f64) -> Self {
        Self {
            surface_rise: Some(surface),
            film_rise: Some(film),
            ..self
        }
    }
}

/// Law of the friction coefficient in the film.
///
/// ```
/// use asperity_core::Checked;
/// use asperity_tribo_friction::{FilmContact, FilmFriction, FilmTraction, FrictionError};
///
/// /// A limiting shear stress of 4 % of the pressure everywhere.
/// #[derive(Debug)]
/// struct Limit;
///
/// impl FilmFriction for Limit {
///     fn name(&self) -> &str {
///         "limit"
///     }
///
///     fn traction(&self, _: &FilmContact<'_>) -> Result<Checked<FilmTraction>, FrictionError> {
///         Ok(Checked::inside(FilmTraction::from_coefficient(0.04)))
///     }
/// }
///
/// let law: &dyn FilmFriction = &Limit;
/// assert_eq!(law.name(), "limit");
/// ```
pub trait FilmFriction: Debug + Send + Sync {
    /// Name, as results print it.
    fn name(&self) -> &str;

    /// Friction at one contact, with every input that left the fitted range.
    ///
    /// # Errors
    /// When an input is outside the domain of the law.
    fn traction(&self, contact: &FilmContact<'_>) -> Result<Checked<FilmTraction>, FrictionError>;

    /// Friction at several contacts of one mesh position, one for each offset of the traces.
    ///
    /// # Errors
    /// As [`traction`](Self::traction).
    fn tractions(
        &self,
        contacts: &[FilmContact<'_>],
    ) -> Result<Vec<Checked<FilmTraction>>, FrictionError> {
        contacts.iter().map(|one| self.traction(one)).collect()
    }
}

/// Law of a case file with what it leaves to choose.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct NamedFriction {
    /// The law.
    pub law: FrictionLaw,
    /// Choices it leaves open.
    pub settings: FrictionSettings,
}

impl FilmFriction for NamedFriction {
    fn name(&self) -> &str {
        self.law.name()
    }

    fn traction(&self, contact: &FilmContact<'_>) -> Result<Checked<FilmTraction>, FrictionError> {
        let coefficient = self.law.coefficient(&self.settings, &contact.position)?;
        Ok(coefficient.map(FilmTraction::from_coefficient))
    }
}
