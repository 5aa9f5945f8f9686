//! Oil whose traction is predicted or fitted, with the distribution of its constants in the family.

use super::error as oil_error;
use asperity::case::{Case, FittedName, LoadedCase, OilFile, Source};
use asperity::oil::{
    FilmRheology, GOLD_TEMPERATURE, LIMITING_SHEAR_BAND, LubricantInput, PRESSURE_VISCOSITY_BAND,
    TractionConstants, eyring_stress_band,
};
use asperity_core::Fault;
use asperity_core::numerics::{Z_95, Z_975};
use asperity_core::quantity::{Pressure, Temperature};

/// An oil with a viscosity over temperature and a family.
#[derive(Debug, Clone)]
pub struct OilBase {
    /// Its name, or the title of its case.
    pub name: String,
    /// Viscosity, density and family, as an oil file states them.
    pub lubricant: LubricantInput,
    /// The oil in the film, with the medians of the constants of its family or those that a case states.
    pub rheology: FilmRheology,
    /// Standard deviations of the logarithms of Eyring stress, limiting shear stress over pressure and pressure-viscosity
    /// coefficient.
    pub deviations: [f64; 3],
    /// Temperature of the flanks of its case; `None` for an oil of the library.
    pub case_temperature: Option<Temperature>,
}

/// Constants of an oil whose file states fitted ones.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum ConstantsOf {
    /// The constants of its family, from which a fit starts.
    Family,
    /// The fitted ones.
    File,
}

impl OilBase {
    /// The oil of this name in the library.
    ///
    /// # Errors
    /// When the library has no such oil, or the viscosity is known at one temperature only.
    pub fn of_library(name: &str) -> Result<Self, Fault> {
        let input = LubricantInput {
            oil: Some(name.to_owned()),
            ..LubricantInput::default()
        };
        Self::of_lubricant(name, input)
    }

    /// The oil of an oil file.
    ///
    /// # Errors
    /// As [`of_library`](Self::of_library), or when a constant is outside its domain.
    pub fn of_file(name: &str, file: &OilFile, constants: ConstantsOf) -> Result<Self, Fault> {
        let mut oil = Self::of_lubricant(name, file.lubricant.clone())?;
        if constants == ConstantsOf::File {
            let mut own = *oil.rheology.constants();
            for name in FittedName::ALL {
                file.film_friction.put_into(name, &mut own);
            }
            let shear = oil.rheology.laws().0;
            let rheology = oil
                .rheology
                .with_laws(shear, file.film_friction.pressure_law);
            let rheology = rheology.with_constants(own);
            oil.rheology = rheology.map_err(|source| oil_error::oil(name, source))?;
            oil.deviations = fitted_deviations(file);
        }
        Ok(oil)
    }

    /// The oil of `source`, an oil file or a data sheet, called `name`; `None` of a case.
    ///
    /// # Errors
    /// As [`of_file`](Self::of_file), and when the source cannot be read.
    pub fn of_source(
        name: &str,
        source: &Source,
        constants: ConstantsOf,
    ) -> Result<Option<Self>, Fault> {
        if OilFile::is_one(source) {
            let file = OilFile::of_source(source).map_err(asperity::Error::from)?;
            return Self::of_file(name, &file, constants).map(Some);
        }
        let sheet = OilFile::data_sheet(source).map_err(asperity::Error::from)?;
        sheet
            .map(|sheet| Self::of_lubricant(name, sheet))
            .transpose()
    }

    /// The oil of a data sheet.
    ///
    /// # Errors
    /// As [`of_library`](Self::of_library), or without a base oil.
    pub(crate) fn of_lubricant(name: &str, input: LubricantInput) -> Result<Self, Fault> {
        let oil = |source| oil_error::oil(name, source);
        let lubricant = input.resolve(GOLD_TEMPERATURE).map_err(oil)?;
        if !lubricant.has_viscosity_law() {
            return Err(oil_error::one_viscosity(name));
        }
        let family = lubricant.base_oil();
        let family = family.ok_or_else(|| oil(asperity::oil::LubricantError::no_base_oil()))?;
        let constants = lubricant.traction_constants(family).map_err(oil)?;
        let rheology =
            FilmRheology::from_lubricant(&lubricant, family, constants, GOLD_TEMPERATURE);
        Ok(Self {
            name: name.to_owned(),
            lubricant: input,
            rheology: rheology.map_err(oil)?,
            deviations: deviations(&constants, Some(family)).map_err(oil)?,
            case_temperature: None,
        })
    }

    /// The oil of a case, which may name an oil file.
    ///
    /// # Errors
    /// When the viscosity is known at one temperature only, or the film friction has no shear stress.
    pub fn of_case(case: &LoadedCase, constants: ConstantsOf) -> Result<Self, Fault> {
        let name = case.title.clone();
        if !case.lubricant.has_viscosity_law() {
            return Err(oil_error::one_viscosity(name));
        }
        let Some(mut rheology) = case.at_stated()?.rheology().cloned() else {
            return Err(oil_error::no_shear_law(name));
        };
        let family = case.lubricant.base_oil();
        let refused = |source| oil_error::oil(&name, source);
        let deviations = match (&case.oil_file, constants, family) {
            (Some(file), ConstantsOf::File, _) => fitted_deviations(file),
            (Some(_), ConstantsOf::Family, Some(family)) => {
                let of_family = case.lubricant.traction_constants(family).map_err(refused)?;
                rheology = rheology.with_constants(of_family).map_err(refused)?;
                deviations(rheology.constants(), Some(family)).map_err(refused)?
            }
            _ => deviations(rheology.constants(), family).map_err(refused)?,
        };
        Ok(Self {
            deviations,
            name,
            lubricant: properties(case)?,
            rheology,
            case_temperature: Some(case.stated_temperature),
        })
    }

    /// Warning if its case is more than `far` kelvin outside the tested temperatures \[°C\], in ascending order.
    pub(super) fn outside(&self, tested: &[f64], far: f64) -> Option<String> {
        let at = self.case_temperature?.celsius();
        let (low, high) = (tested.first()?, tested.last()?);
        let outside = (low - at).max(at - high);
        let tested = if low == high {
            format!("{low:.0}")
        } else {
            format!("{low:.0} to {high:.0}")
        };
        (outside > far).then(|| {
            format!("the case has {at:.0} °C, {outside:.0} K outside of the tested {tested} °C")
        })
    }

    /// The oil with Eyring stress, limiting shear stress and pressure-viscosity factor of the friction multiplied by the
    /// exponentials of `logs`.
    ///
    /// # Errors
    /// When a constant leaves its domain.
    pub fn shifted(&self, logs: [f64; 3]) -> Result<FilmRheology, Fault> {
        let own = *self.rheology.constants();
        let [stress, limit, factor] = logs.map(f64::exp);
        let constants = TractionConstants {
            eyring_stress: own.eyring_stress * stress,
            limiting_shear: own.limiting_shear * limit,
            pressure_viscosity_factor: own.pressure_viscosity_factor * factor,
            ..own
        };
        let rheology = self.rheology.clone().with_constants(constants);
        rheology.map_err(|source| oil_error::oil(&self.name, source))
    }
}

/// The oil of a case without the constants of its film friction.
fn properties(case: &Case) -> Result<LubricantInput, Fault> {
    let own = &case.input.lubricant;
    let whole = match &case.oil_file {
        Some(file) => own.completed_by(&file.lubricant),
        None => Ok(own.clone()),
    };
    let whole = whole.map_err(|source| oil_error::oil(&case.title, source))?;
    Ok(LubricantInput {
        oil_file: None,
        pressure_viscosity_factor: None,
        limiting_shear_temperature: None,
        ..whole
    })
}

/// Standard deviations of the logarithms from the bands of an oil file.
fn fitted_deviations(file: &OilFile) -> [f64; 3] {
    [
        FittedName::EyringStress,
        FittedName::LimitingShear,
        FittedName::PressureViscosityFactor,
    ]
    .map(|name| {
        let band = file.film_friction.of(name);
        (band.high / band.low).ln() / (2.0 * Z_975)
    })
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
