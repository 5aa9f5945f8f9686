//! A case at a known temperature of its flanks, with the oil there.

use std::ops::Deref;
use std::sync::Arc;

use asperity_core::OutOfRange;
use asperity_core::provenance::Provenance;
use asperity_core::quantity::Temperature;
use asperity_flanks::surfaces::Surfaces;
use asperity_mixed_film::FilmAlone;
use asperity_oil::{FilmRheology, LubricantState};
use asperity_tribo_friction::{FilmFriction, NamedFriction};

use super::loaded_case::LoadedCase;
use crate::error::Error;
use crate::input::case_input::CaseInput;
use crate::resolved::bulk::BulkReport;
use crate::resolved::constant::UncertainParameter;
use crate::resolved::oil_at::OilAtTemperature;
use crate::resolved::overrides::Overrides;
use asperity_core::message::Warning;

/// A case at a bulk temperature, stated or found: the only type with a state of the oil.
///
/// ```
/// use asperity_case::case;
/// let case = case::load("../../fixtures/cases/e-drive.toml".as_ref(), None)?;
/// let stated = case.at_stated()?;
/// let warmer = case.at("120 °C".parse().unwrap())?;
/// assert!(warmer.oil().dynamic_viscosity < stated.oil().dynamic_viscosity);
/// # Ok::<(), asperity_case::error::Error>(())
/// ```
#[derive(Debug, Clone)]
pub struct OperatingCase {
    loaded: LoadedCase,
    bulk: Temperature,
    report: Option<BulkReport>,
    /// The oil at the bulk temperature, without overrides.
    nominal: Arc<OilAtTemperature>,
    temperature: Temperature,
    oil: LubricantState,
    rheology: Option<FilmRheology>,
    oil_notes: Vec<OutOfRange>,
}

impl Deref for OperatingCase {
    type Target = LoadedCase;

    fn deref(&self) -> &LoadedCase {
        &self.loaded
    }
}

impl LoadedCase {
    /// The case with its flanks at a bulk temperature.
    ///
    /// # Errors
    /// When the oil does not flow there, or a law of it does not hold.
    pub fn at(&self, bulk: Temperature) -> Result<OperatingCase, Error> {
        OperatingCase::new(self.clone(), bulk, None, self.oil_at(bulk)?)
    }

    /// The case at a bulk temperature that was found from its loss by the equations `used`.
    ///
    /// # Errors
    /// As [`at`](Self::at).
    pub fn at_found(
        &self,
        bulk: Temperature,
        report: BulkReport,
        used: &Provenance,
    ) -> Result<OperatingCase, Error> {
        let loaded = self.with_provenance(used);
        OperatingCase::new(loaded, bulk, Some(report), self.oil_at(bulk)?)
    }

    /// The case at the temperature that it states, also where this is the temperature of the oil.
    ///
    /// # Errors
    /// As [`at`](Self::at).
    pub fn at_stated(&self) -> Result<OperatingCase, Error> {
        self.at(self.case.stated_temperature)
    }
}

impl OperatingCase {
    fn new(
        loaded: LoadedCase,
        bulk: Temperature,
        report: Option<BulkReport>,
        nominal: Arc<OilAtTemperature>,
    ) -> Result<Self, Error> {
        let overrides = &loaded.case.overrides;
        let temperature = overrides.temperature(bulk);
        let at = if temperature == bulk {
            Arc::clone(&nominal)
        } else {
            loaded.oil_at(temperature)?
        };
        let of_curves = UncertainParameter::PressureViscosityFactor.measured(&loaded.case);
        let found = overrides.oil(&nominal.state, &at, of_curves.is_some());
        let (oil, rheology) = found.map_err(Box::new)?;
        Ok(Self {
            oil_notes: at.notes.clone(),
            loaded,
            bulk,
            report,
            nominal,
            temperature,
            oil,
            rheology,
        })
    }

    /// The case without its temperature.
    #[must_use]
    pub const fn loaded(&self) -> &LoadedCase {
        &self.loaded
    }

    /// Bulk temperature of the flanks, at which film and friction are computed.
    #[must_use]
    pub const fn temperature(&self) -> Temperature {
        self.temperature
    }

    /// How the bulk temperature was found; `None` where the case states it.
    #[must_use]
    pub const fn bulk_report(&self) -> Option<&BulkReport> {
        self.report.as_ref()
    }

    /// The oil.
    #[must_use]
    pub const fn oil(&self) -> &LubricantState {
        &self.oil
    }

    /// The oil in the film, if film friction or load share use it.
    #[must_use]
    pub const fn rheology(&self) -> Option<&FilmRheology> {
        self.rheology.as_ref()
    }

    /// Properties of the oil outside the range of their laws.
    #[must_use]
    pub fn oil_notes(&self) -> &[OutOfRange] {
        &self.oil_notes
    }

    /// Warnings about keys and files, and about the oil at this temperature instead of the one that the case states.
    #[must_use]
    pub fn warnings_here(&self) -> Vec<Warning> {
        self.loaded.warnings_at(&self.oil, self.temperature)
    }

    /// The friction law of the film in use.
    #[must_use]
    pub fn film_friction(&self) -> Arc<dyn FilmFriction> {
        let (laws, model) = (&self.case.laws, &self.case.model);
        if let Some(own) = &laws.friction {
            return Arc::clone(own);
        }
        match (&self.rheology, model.film_friction.shear_law()) {
            (Some(rheology), Some(_)) => Arc::new(FilmAlone::new(rheology)),
            _ => Arc::new(NamedFriction {
                law: model.film_friction.published().unwrap_or_default(),
                settings: model.friction_settings,
            }),
        }
    }

    /// The case with other overrides at the same bulk temperature.
    ///
    /// # Errors
    /// When a value is outside its domain.
    pub fn overridden(&self, change: impl FnOnce(&mut Overrides)) -> Result<Self, Error> {
        let (report, nominal) = (self.report.clone(), Arc::clone(&self.nominal));
        Self::new(self.loaded.overridden(change)?, self.bulk, report, nominal)
    }

    /// The case with other keys at the same bulk temperature.
    ///
    /// # Errors
    /// When the changed case cannot be run.
    pub fn with_keys(&self, change: impl FnOnce(&mut CaseInput)) -> Result<Self, Error> {
        let loaded = self.loaded.with(change)?;
        let nominal = loaded.oil_at(self.bulk)?;
        Self::new(loaded, self.bulk, self.report.clone(), nominal)
    }

    /// The case on other flanks at the same bulk temperature.
    #[must_use]
    pub fn with_surfaces(&self, surfaces: Surfaces) -> Self {
        Self {
            loaded: self.loaded.with_surfaces(surfaces),
            ..self.clone()
        }
    }

    /// The case on its first pair of traces, as [`LoadedCase::first_pair`].
    #[must_use]
    pub fn first_pair(&self) -> Self {
        Self {
            loaded: self.loaded.first_pair(),
            ..self.clone()
        }
    }
}
