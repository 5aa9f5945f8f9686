//! Machine that measures traction in a contact at a point.
//!
//! The specimens are of through-hardened bearing steel, whose conductivity is 21 W/(m K) and not the 46 of handbooks
//! (Reddyhoff, Schmidt and Spikes, Tribology Letters 67 (2019) 22). They warm above the bath by half a kelvin per watt of
//! friction (assumed).

use std::num::NonZeroUsize;

use asperity::contact::hertz_point::HertzPoint;
use asperity::mixed_film::{LoadShareError, PointContact};
use asperity::oil::FilmRheology;
use asperity::tribo_friction::{FilmFrictionSolution, FilmSettings};
use asperity_core::DomainError;
use asperity_core::material::Material;
use asperity_core::quantity::{
    Density, Force, Length, Pressure, SpecificHeat, Speed, Temperature, ThermalConductivity,
};
use serde::Serialize;

/// Through-hardened bearing steel.
const STEEL: Material = Material {
    young: Pressure::from_si(210e9),
    poisson: 0.3,
    elastic_limit: Pressure::from_si(1.5e9),
    density: Density::from_si(7830.0),
    conductivity: ThermalConductivity::from_si(21.0),
    heat_capacity: SpecificHeat::from_si(465.0),
};
/// Rise of the specimens above the bath per heat of friction \[K/W\].
const BULK_RISE: f64 = 0.5;
/// Gauss-Legendre nodes over the pressure: the error of the friction is below 1e-4 of it.
const NODES: usize = 12;

/// Machine with a contact at a point.
#[derive(Debug, Clone, Copy, PartialEq, Serialize)]
pub struct Machine {
    /// Relative radii along and across the motion.
    pub radii: [Length; 2],
    /// Material of both specimens.
    pub material: Material,
    /// Rise of the specimens above the bath per heat of friction \[K/W\].
    pub bulk_rise: f64,
    /// Root mean square roughness of both specimens together.
    pub roughness: Length,
}

/// Setting of a machine.
#[derive(Debug, Clone, Copy, PartialEq, Serialize)]
pub struct Setting {
    /// Load.
    pub load: Force,
    /// Mean speed of the surfaces.
    pub mean_speed: Speed,
    /// Slide-to-roll ratio (u₁ − u₂)/V_e.
    pub slide_to_roll: f64,
    /// Temperature of the oil bath.
    pub temperature: Temperature,
}

/// Film and friction at a setting.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct PredictedFriction {
    /// Hertz contact.
    pub hertz: HertzPoint,
    /// Central film.
    pub film: Length,
    /// Friction with its temperatures.
    pub friction: FilmFrictionSolution,
}

impl Machine {
    /// A steel ball on a second ball, or on a flat disc, with the roughness of both together.
    ///
    /// # Errors
    /// When a length is not positive.
    pub fn ball_on_disc(
        ball: Length,
        second: Option<Length>,
        roughness: Length,
    ) -> Result<Self, DomainError> {
        let ball = DomainError::positive("ball radius", ball)?;
        let curvature = match second {
            Some(second) => 1.0 / DomainError::positive("radius of the second body", second)?,
            None => 0.0,
        };
        DomainError::positive("roughness of the specimens", roughness)?;
        Ok(Self {
            radii: [Length::from_si(1.0 / (1.0 / ball + curvature)); 2],
            material: STEEL,
            bulk_rise: BULK_RISE,
            roughness,
        })
    }

    /// Reduced modulus E* of both specimens.
    fn modulus(&self) -> Pressure {
        let Material { young, poisson, .. } = self.material;
        young * (0.5 / (1.0 - poisson * poisson))
    }

    /// The load that causes a largest Hertz pressure p₀: F = (p₀/p₁)³ · 1 N, where p₁ is the pressure of 1 N, because all
    /// lengths of the contact grow with F^(1/3).
    ///
    /// # Errors
    /// When the radii or the modulus of the machine are not positive.
    pub(crate) fn load_at(&self, max_pressure: Pressure) -> Result<Force, LoadShareError> {
        let of_one = HertzPoint::new(Force::from_si(1.0), self.radii, self.modulus())?;
        Ok(Force::from_si((max_pressure / of_one.max_pressure).powi(3)))
    }

    /// The contact at a setting.
    #[must_use]
    pub fn contact(&self, at: &Setting) -> PointContact {
        PointContact {
            load: at.load,
            radii: self.radii,
            modulus: self.modulus(),
            entrainment: at.mean_speed,
            slide_to_roll: at.slide_to_roll,
            bodies: [self.material; 2],
            temperature: at.temperature,
            bulk_rise: self.bulk_rise,
        }
    }

    /// Hertz contact and central film at a setting: `factor` times the computed film, or times the film `measured`.
    ///
    /// # Errors
    /// When an input is outside its domain.
    pub fn film(
        &self,
        rheology: &FilmRheology,
        at: &Setting,
        measured: Option<Length>,
        factor: f64,
    ) -> Result<(HertzPoint, Length), LoadShareError> {
        let contact = self.contact(at);
        let hertz = contact.hertz()?;
        let film = match measured {
            Some(film) => film,
            None => contact.film(rheology, hertz.max_pressure)?.value.thickness,
        };
        Ok((hertz, film * factor))
    }

    /// Film and friction at a setting.
    ///
    /// # Errors
    /// When an input is outside its domain.
    pub fn predict(
        &self,
        rheology: &FilmRheology,
        at: &Setting,
    ) -> Result<PredictedFriction, LoadShareError> {
        self.predict_with(rheology, at, None, 1.0)
    }

    /// Film and friction at a setting, with the film of [`Machine::film`].
    ///
    /// # Errors
    /// When an input is outside its domain.
    pub(crate) fn predict_with(
        &self,
        rheology: &FilmRheology,
        at: &Setting,
        measured: Option<Length>,
        factor: f64,
    ) -> Result<PredictedFriction, LoadShareError> {
        let (hertz, film) = self.film(rheology, at, measured, factor)?;
        let settings = FilmSettings {
            nodes: NonZeroUsize::MIN.saturating_add(NODES - 1),
            ..FilmSettings::default()
        };
        let contact = self.contact(at);
        let friction = contact.friction(rheology, &hertz, film, settings)?.value;
        Ok(PredictedFriction {
            hertz,
            film,
            friction,
        })
    }
}
