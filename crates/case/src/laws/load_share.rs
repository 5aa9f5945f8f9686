//! Sharing of the load between film and asperities as an extension point for user-defined laws.
//!
//! A law sees the mesh position, the film parameters and, where both flanks were measured, the heights
//! of both under the contact. It says what part of the load the film carries, and at which friction
//! coefficients the rest rubs.

use std::fmt::Debug;

use asperity_core::material::Material;
use asperity_core::quantity::Pressure;
use asperity_ehl_regime::LoadShareLaw;
use asperity_tribo_friction::FilmContact;

use crate::error::PositionError;
use crate::formula_film::FormulaFilm;
use asperity_flanks::mesh_position::MeshPosition;
use asperity_flanks::{Roughness, WindowPair};
use asperity_mixed_film::{InletSupply, LoadShareSolution};

/// Film and asperities at one mesh position and one offset: the inputs of a load-sharing law.
#[derive(Debug, Clone, Copy)]
pub struct ShareConditions<'a> {
    /// Motion, load and smooth contact.
    pub position: &'a MeshPosition,
    /// Smooth film.
    pub film: &'a FormulaFilm,
    /// Roughness under the contact.
    pub roughness: &'a Roughness,
    /// Heights of both flanks under the contact and their gap; none when a flank was not measured.
    pub window: Option<&'a WindowPair>,
    /// Λ* with the central film as a mass flow; none when the peaks of the flanks are not known or there are none.
    pub lambda_star: Option<f64>,
    /// Classical film ratio h_min/S.
    pub film_ratio: f64,
    /// Local contact with steels, temperatures and the oil.
    pub contact: &'a FilmContact<'a>,
    /// Pressure at which each flank flows.
    pub flow_pressure: [Pressure; 2],
    /// The rough contact solved for the supply of [`LoadShare::supply`]; `None` if the law requires none, or
    /// a flank was not measured.
    pub solved: Option<&'a LoadShareSolution>,
}

impl ShareConditions<'_> {
    /// Λ*, or the classical film ratio where Λ* is not known.
    #[must_use]
    pub fn deciding_ratio(&self) -> f64 {
        self.lambda_star.unwrap_or(self.film_ratio)
    }

    /// Steel of both flanks.
    #[must_use]
    pub fn materials(&self) -> &[Material; 2] {
        &self.contact.materials
    }
}

/// Load shared by film and asperities, and what the asperities rub with.
#[derive(Debug, Clone, Copy, PartialEq)]
#[non_exhaustive]
pub struct SharedLoad {
    /// Share of the load that the film carries, 0 to 1.
    pub film_share: f64,
    /// Share of the asperities' load that rubs with the boundary coefficient; the rest is lubricated.
    pub boundary_part: f64,
    /// Friction coefficient of the lubricated asperities.
    pub lubricated_coefficient: f64,
    /// Friction coefficient of the film at the temperature that film and asperities make together, of laws
    /// that solve for it.
    pub film_coefficient: Option<f64>,
}

impl SharedLoad {
    /// A film that carries `film_share`; all that the asperities carry rubs with the boundary coefficient.
    #[must_use]
    pub const fn of_film(film_share: f64) -> Self {
        Self {
            film_share,
            boundary_part: 1.0,
            lubricated_coefficient: 0.0,
            film_coefficient: None,
        }
    }

    /// Sets only `boundary_part` of the asperities' load at the boundary coefficient and the
    /// rest at `coefficient`.
    #[must_use]
    pub const fn with_lubricated_asperities(self, boundary_part: f64, coefficient: f64) -> Self {
        Self {
            boundary_part,
            lubricated_coefficient: coefficient,
            ..self
        }
    }

    /// Mean friction coefficient of the asperities: β μ_b + (1 − β) μ_a.
    #[must_use]
    pub fn asperity_coefficient(&self, boundary: f64) -> f64 {
        self.boundary_part * boundary + (1.0 - self.boundary_part) * self.lubricated_coefficient
    }
}

/// Law of the load sharing between film and asperities.
///
/// ```
/// use asperity_case::error::PositionError;
/// use asperity_case::load_share_law::{LoadShare, ShareConditions, SharedLoad};
///
/// /// The film carries half of the load wherever the flanks touch.
/// #[derive(Debug)]
/// struct Half;
///
/// impl LoadShare for Half {
///     fn name(&self) -> &str {
///         "half"
///     }
///
///     fn share(&self, at: &ShareConditions<'_>) -> Result<SharedLoad, PositionError> {
///         let touching = at.deciding_ratio() < 1.0;
///         Ok(SharedLoad::of_film(if touching { 0.5 } else { 1.0 }))
///     }
/// }
///
/// let law: std::sync::Arc<dyn LoadShare> = std::sync::Arc::new(Half);
/// assert_eq!(law.name(), "half");
/// ```
pub trait LoadShare: Debug + Send + Sync {
    /// Name, as results print it.
    fn name(&self) -> &str;

    /// Inlet supply for which the law wants the rough contact solved; none by default.
    fn supply(&self) -> Option<InletSupply> {
        None
    }

    /// Shares at one mesh position and one offset.
    ///
    /// # Errors
    /// When an input is outside the domain of the law.
    fn share(&self, conditions: &ShareConditions<'_>) -> Result<SharedLoad, PositionError>;

    /// Shares at one mesh position, one for each offset of the traces.
    ///
    /// # Errors
    /// As [`share`](Self::share).
    fn shares(&self, conditions: &[ShareConditions<'_>]) -> Result<Vec<SharedLoad>, PositionError> {
        conditions.iter().map(|one| self.share(one)).collect()
    }
}

impl LoadShare for LoadShareLaw {
    fn name(&self) -> &str {
        match self {
            Self::LambdaStar => "lambda-star",
            Self::ZhuHu => "zhu-hu",
        }
    }

    fn share(&self, conditions: &ShareConditions<'_>) -> Result<SharedLoad, PositionError> {
        let share = self.film_share(conditions.deciding_ratio(), conditions.film_ratio)?;
        Ok(SharedLoad::of_film(share))
    }
}
