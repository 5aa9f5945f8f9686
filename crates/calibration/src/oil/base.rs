//! Oil whose traction is predicted or fitted, with the distribution of its constants in the family.

use asperity::case::Case;
use asperity::oil::{
    FilmRheology, GOLD_TEMPERATURE, LIMITING_SHEAR_BAND, LubricantInput, PRESSURE_VISCOSITY_BAND,
    TractionConstants, eyring_stress_band,
};
use asperity_core::numerics::Z_95;
use asperity_core::quantity::Pressure;

use super::error::OilError;

/// An oil with a viscosity over temperature and a family.
#[derive(Debug, Clone)]
pub struct OilBase {
    /// Its name, or the title of its case.
    pub name: String,
    /// The oil in the film, with the medians of the constants of its family or those that a case states.
    pub rheology: FilmRheology,
    /// Standard deviations of the logarithms of Eyring stress, limiting shear stress over pressure and pressure-viscosity
    /// coefficient.
    pub deviations: [f64; 3],
}

impl OilBase {
    /// The oil of this name in the library.
    ///
    /// # Errors
    /// When the library has no such oil, or the viscosity is known at one temperature only.
    pub fn of_library(name: &str) -> Result<Self, OilError> {
        let oil = |source| OilError::Oil {
            name: name.to_owned(),
            source,
        };
        let input = LubricantInput {
            oil: Some(name.to_owned()),
            ..LubricantInput::default()
        };
        let lubricant = input.resolve(GOLD_TEMPERATURE).map_err(oil)?;
        if !lubricant.has_viscosity_law() {
            return Err(OilError::OneViscosity {
                name: name.to_owned(),
            });
        }
        let family = lubricant.base_oil();
        let family = family.ok_or_else(|| oil(asperity::oil::LubricantError::NoBaseOil))?;
        let constants = lubricant.traction_constants(family).map_err(oil)?;
        let rheology = FilmRheology::of(&lubricant, family, constants, GOLD_TEMPERATURE);
        Ok(Self {
            name: name.to_owned(),
            rheology: rheology.map_err(oil)?,
            deviations: deviations(&constants, Some(family)).map_err(oil)?,
        })
    }

    /// The oil of a case.
    ///
    /// # Errors
    /// When the viscosity is known at one temperature only, or the film friction has no shear stress.
    pub fn of_case(case: &Case) -> Result<Self, OilError> {
        let name = case.title.clone();
        if !case.lubricant.has_viscosity_law() {
            return Err(OilError::OneViscosity { name });
        }
        let Some(rheology) = case.rheology.clone() else {
            return Err(OilError::NoShearLaw { name });
        };
        let family = case.lubricant.base_oil();
        let deviations = deviations(rheology.constants(), family);
        Ok(Self {
            deviations: deviations.map_err(|source| OilError::Oil {
                name: name.clone(),
                source,
            })?,
            name,
            rheology,
        })
    }

    /// The oil with Eyring stress, limiting shear stress and pressure-viscosity factor of the friction multiplied by the
    /// exponentials of `logs`.
    ///
    /// # Errors
    /// When a constant leaves its domain.
    pub fn shifted(&self, logs: [f64; 3]) -> Result<FilmRheology, OilError> {
        let own = *self.rheology.constants();
        let [stress, limit, factor] = logs.map(f64::exp);
        let constants = TractionConstants {
            eyring_stress: own.eyring_stress * stress,
            limiting_shear: own.limiting_shear * limit,
            pressure_viscosity_factor: own.pressure_viscosity_factor * factor,
            ..own
        };
        let rheology = self.rheology.clone().with_constants(constants);
        rheology.map_err(|source| OilError::Oil {
            name: self.name.clone(),
            source,
        })
    }
}

/// Standard deviations of the logarithms from the 5 % and 95 % quantiles of the family.
fn deviations(
    constants: &TractionConstants,
    family: Option<asperity::oil::BaseOil>,
) -> Result<[f64; 3], asperity::oil::LubricantError> {
    let stress = eyring_stress_band(family, Pressure::si(constants.eyring_stress))?;
    let bands = [stress, LIMITING_SHEAR_BAND, PRESSURE_VISCOSITY_BAND];
    Ok(bands.map(|[low, high]| (high / low).ln() / (2.0 * Z_95)))
}
