//! Values that a Monte Carlo draw or a study changes in a case, in addition to its keys.

use asperity_core::quantity::{Length, PerKelvin, Pressure, PressureViscosity, Temperature};
use asperity_ehl_regime::inlet_flow::Lay;
use asperity_flanks::error::PositionError;
use asperity_flanks::flank_lay::{FlankLay, with_mean};
use asperity_mixed_film::{PatchGap, SpotSpeed};
use asperity_oil::{FilmRheology, LubricantState, PressureLaw, TractionConstants};

use super::constant::UncertainParameter;
use super::oil_at::OilAtTemperature;
use crate::input::law_names::LoadShareName;
use crate::input::model::Model;

/// Values instead of those that a case resolves to. They are passed in addition to its keys, hold at every other temperature, load and
/// key, and are part of its [fingerprint](crate::case::LoadedCase::fingerprint).
///
/// ```
/// use asperity_case::case::{self, UncertainParameter};
/// let case = case::load("../../fixtures/cases/e-drive.toml".as_ref(), None)?;
/// let rough = case.overridden(|over| over.set(UncertainParameter::BoundaryFriction, 0.1))?;
/// let warmer = rough.with_key("operation.bulk_temperature", "120 °C")?;
/// assert_eq!(warmer.case.model.boundary_friction, 0.1);
/// assert_ne!(case.fingerprint(), rough.fingerprint());
/// # Ok::<(), asperity_case::error::Error>(())
/// ```
#[derive(Debug, Clone, PartialEq, Default)]
#[non_exhaustive]
pub struct Overrides {
    /// By [`UncertainParameter`].
    constants: [Option<f64>; UncertainParameter::ALL.len()],
    /// Constants of the film friction as a whole; single ones are set over them.
    pub film_constants: Option<TractionConstants>,
    /// Lay of both flanks.
    pub lay: Option<[Lay; 2]>,
    /// Boundary share β_i of spots that form inside the contact.
    pub inner_boundary: Option<f64>,
    /// Number of offsets of each pair of traces.
    pub offsets: Option<usize>,
    /// Tolerance of the contacts.
    pub tolerance: Option<f64>,
    /// Gap supplied to patches.
    pub patch_gap: PatchGap,
    /// Gupta's thermal factor as printed, also at the loadings at which its steepness is held.
    pub printed_thermal: bool,
    /// Solve every rough contact to its exact sets: slower, and its error is round-off, so that differences of losses can be
    /// taken over small steps.
    pub exact_contacts: bool,
    /// The flanks as measured, also where the case runs them in.
    pub as_measured: bool,
    /// Another model.
    pub alternative: Option<Alternative>,
}

/// A model instead of that of the case.
#[derive(Debug, Clone, Copy, PartialEq)]
#[non_exhaustive]
pub enum Alternative {
    /// Film that a touching spot carries with it.
    SpotSpeed(SpotSpeed),
    /// Factor on the share of the load on asperities.
    AsperityShareTimes(f64),
    /// Law of the load share.
    LoadShare(LoadShareName),
    /// Viscosity over pressure in the film friction.
    FilmPressure(PressureLaw),
}

impl Overrides {
    /// Whether nothing is overridden.
    #[must_use]
    pub(crate) fn are_none(&self) -> bool {
        *self == Self::default()
    }

    /// Sets a constant \[its SI unit\]. The lay is the mean of both flanks; the error of the temperature is added to the bulk temperature.
    pub fn set(&mut self, constant: UncertainParameter, value: f64) {
        self.constants[constant as usize] = Some(value);
    }

    /// The value of a constant, where it is overridden.
    #[must_use]
    pub fn get(&self, constant: UncertainParameter) -> Option<f64> {
        self.constants[constant as usize]
    }

    /// Puts what concerns the model into it; `lays` are the distributions of the lay of both flanks.
    pub(crate) fn put_into(
        &self,
        model: &mut Model,
        lays: [FlankLay; 2],
    ) -> Result<(), PositionError> {
        use UncertainParameter as Constant;
        if let Some(friction) = self.get(Constant::BoundaryFriction) {
            model.boundary_friction = friction;
        }
        if let Some(layer) = self.get(Constant::BoundaryLayer) {
            model.boundary_layer = Length::from_si(layer);
        }
        if let Some(mean) = self.get(Constant::Lay) {
            model.lay = with_mean(lays, mean)?;
        }
        model.lay = self.lay.unwrap_or(model.lay);
        model.inner_boundary = self.inner_boundary.unwrap_or(model.inner_boundary);
        model.offsets = self.offsets.unwrap_or(model.offsets);
        model.tolerance = self.tolerance.unwrap_or(model.tolerance);
        match self.alternative {
            Some(Alternative::LoadShare(law)) => model.load_share = law,
            Some(Alternative::FilmPressure(law)) => model.film_pressure_law = law,
            Some(Alternative::SpotSpeed(_) | Alternative::AsperityShareTimes(_)) | None => {}
        }
        Ok(())
    }

    /// Temperature of film and friction at a bulk temperature.
    pub(crate) fn temperature(&self, bulk: Temperature) -> Temperature {
        match self.get(UncertainParameter::TemperatureError) {
            Some(error) => Temperature::from_si(bulk.si() + error),
            None => bulk,
        }
    }

    /// The oil at the temperature of film and friction, where `nominal` is the oil at the bulk temperature; `is_of_film` where curves
    /// state the friction with α as estimated.
    pub(crate) fn oil(
        &self,
        nominal: &LubricantState,
        at: &OilAtTemperature,
        is_of_film: bool,
    ) -> Result<(LubricantState, Option<FilmRheology>), PositionError> {
        let mut oil = at.state;
        let mut rheology = at.rheology.clone();
        if let Some(own) = &rheology {
            let constants = self.constants_of(own);
            if constants != *own.constants() {
                rheology = Some(own.clone().with_constants(constants)?);
            }
        }
        if let Some(Alternative::FilmPressure(law)) = self.alternative {
            rheology = rheology.map(|own| {
                let shear = own.laws().0;
                own.with_laws(shear, law)
            });
        }
        if let Some(alpha) = self.get(UncertainParameter::PressureViscosity) {
            // The same factor in film thickness and film friction, unless curves state the friction.
            let factor = alpha / nominal.pressure_viscosity.si();
            oil.pressure_viscosity = if *nominal == at.state {
                PressureViscosity::from_si(alpha)
            } else {
                oil.pressure_viscosity * factor
            };
            rheology = rheology.map(|own| {
                if is_of_film {
                    own.with_film_alpha_factor(factor)
                } else {
                    own.with_alpha_factor(factor)
                }
            });
        }
        Ok((oil, rheology))
    }

    fn constants_of(&self, own: &FilmRheology) -> TractionConstants {
        use UncertainParameter as Constant;
        let mut constants = self.film_constants.unwrap_or(*own.constants());
        if let Some(slope) = self.get(Constant::LimitingShear) {
            constants.limiting_shear = slope;
        }
        if let Some(stress) = self.get(Constant::EyringStress) {
            constants.eyring_stress = Pressure::from_si(stress);
        }
        if let Some(fall) = self.get(Constant::LimitingShearTemperature) {
            constants.limiting_shear_fall = PerKelvin::from_si(fall);
        }
        if let Some(factor) = self.get(Constant::PressureViscosityFactor) {
            constants.pressure_viscosity_factor = factor;
        }
        constants
    }
}
