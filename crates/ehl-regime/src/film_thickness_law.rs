//! Film thickness law as an extension point: the laws of this crate and user-defined laws.
//!
//! Every [`FilmLaw`] of a case file implements [`FilmThicknessLaw`]; a user-defined law is a type with three functions.

use std::fmt::Debug;
use std::sync::Arc;

use asperity_core::Checked;

use crate::dimensionless::FilmConditions;
use crate::error::RegimeError;
use crate::film_law::{FilmLaw, FilmThickness};

/// Law of the smooth isothermal film thickness of a line contact.
///
/// ```
/// use asperity_core::Checked;
/// use asperity_ehl_regime::{FilmConditions, FilmThickness, FilmThicknessLaw, RegimeError};
///
/// /// h_c = h_m = 2.45 η₀ u R/w, the rigid isoviscous film of Martin.
/// #[derive(Debug)]
/// struct Martin;
///
/// impl FilmThicknessLaw for Martin {
///     fn name(&self) -> &str {
///         "martin"
///     }
///
///     fn film(&self, at: &FilmConditions) -> Result<Checked<FilmThickness>, RegimeError> {
///         let speed = 2.0 * at.entrainment.si();
///         let film = at.radius * (2.45 * at.viscosity.si() * speed / at.load.si());
///         Ok(Checked::inside(FilmThickness { central: film, minimum: film }))
///     }
///
///     fn speed_exponent(&self) -> f64 {
///         1.0
///     }
/// }
///
/// let film = Martin.film(&FilmConditions {
///     entrainment: "5 m/s".parse()?, radius: "10 mm".parse()?, load: "1 N/mm".parse()?,
///     modulus: "115 GPa".parse()?, viscosity: "10 mPa s".parse()?,
///     pressure_viscosity: "0 1/GPa".parse()?, contact_length: None,
/// })?;
/// assert!((film.value.central.si() - 2.45e-6).abs() < 1e-12);
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
pub trait FilmThicknessLaw: Debug + Send + Sync {
    /// Name, as results print it.
    fn name(&self) -> &str;

    /// Smooth isothermal film at one mesh position, with every input that left the fitted range.
    ///
    /// # Errors
    /// When an input is outside the domain of the law.
    fn film(&self, position: &FilmConditions) -> Result<Checked<FilmThickness>, RegimeError>;

    /// Exponent X of the speed group U in the central film, which Λ* needs.
    fn speed_exponent(&self) -> f64;
}

impl FilmThicknessLaw for FilmLaw {
    fn name(&self) -> &str {
        FilmLaw::name(*self)
    }

    fn film(&self, position: &FilmConditions) -> Result<Checked<FilmThickness>, RegimeError> {
        FilmLaw::film(*self, position)
    }

    fn speed_exponent(&self) -> f64 {
        FilmLaw::speed_exponent(*self)
    }
}

impl From<FilmLaw> for Arc<dyn FilmThicknessLaw> {
    fn from(law: FilmLaw) -> Self {
        Arc::new(law)
    }
}
