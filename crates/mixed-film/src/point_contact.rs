//! Film and friction of a smooth contact at a point: ball, barrel or disc on a disc.
//!
//! Film by Hamrock and Dowson with the ellipticity (R_y/R_x)^(2/π) and the thermal reduction of Gupta, the film properties at
//! the temperature of the bath; friction by [`point_film`](asperity_tribo_friction::point_film).

use asperity_contact::hertz_point::HertzPoint;
use asperity_core::material::Material;
use asperity_core::quantity::{Force, Length, LineLoad, Pressure, Speed, Temperature};
use asperity_core::{Checked, cite};
use asperity_ehl_regime::film_elliptic::hamrock_dowson_central;
use asperity_ehl_regime::{FilmConditions, ThermalLaw, thermal_loading};
use asperity_oil::FilmRheology;
use asperity_tribo_friction::point_film::solve;
use asperity_tribo_friction::{FilmFrictionSolution, FilmPointContact, FilmSettings};
use serde::Serialize;

use crate::error::LoadShareError;

/// Loaded contact at a point of two moving bodies in an oil bath.
#[derive(Debug, Clone, Copy, PartialEq, Serialize)]
pub struct PointContact {
    /// Load F.
    pub load: Force,
    /// Relative radii R_x along and R_y across the motion.
    pub radii: [Length; 2],
    /// Reduced modulus E*.
    pub modulus: Pressure,
    /// Entrainment speed (u₁ + u₂)/2.
    pub entrainment: Speed,
    /// Slide-to-roll ratio S = (u₁ − u₂)/V_e.
    pub slide_to_roll: f64,
    /// Materials of the two bodies.
    pub bodies: [Material; 2],
    /// Temperature of the bath.
    pub temperature: Temperature,
    /// Rise of the bodies above the bath per heat of friction \[K/W\].
    pub bulk_rise: f64,
}

/// Central film with its thermal reduction.
#[derive(Debug, Clone, Copy, PartialEq, Serialize)]
pub struct PointFilm {
    /// Central film thickness.
    pub thickness: Length,
    /// Thermal reduction in it.
    pub thermal_reduction: f64,
}

impl PointContact {
    /// Hertz contact.
    ///
    /// # Errors
    /// As [`HertzPoint::new`].
    pub fn hertz(&self) -> Result<HertzPoint, LoadShareError> {
        Ok(HertzPoint::new(self.load, self.radii, self.modulus)?)
    }

    /// Surface speeds u₁, u₂ = V_e (1 ± S/2).
    #[must_use]
    pub fn speeds(&self) -> [Speed; 2] {
        [0.5, -0.5].map(|half| self.entrainment * (1.0 + half * self.slide_to_roll))
    }

    /// Central film at the temperature of the bath.
    ///
    /// ```text
    /// h = φ h_c,  k = (R_y/R_x)^(2/π)                                        [Point-film]
    /// ```
    ///
    /// h_c is the central film of Hamrock and Dowson \[P14\], φ Gupta's reduction \[P10\].
    ///
    /// # Errors
    /// When an input is outside its domain.
    pub fn film(
        &self,
        rheology: &FilmRheology,
        max_pressure: Pressure,
    ) -> Result<Checked<PointFilm>, LoadShareError> {
        cite!("Point-film");
        let oil = rheology.state(self.temperature)?;
        let [along, across] = self.radii;
        let conditions = FilmConditions {
            entrainment: self.entrainment,
            radius: along,
            load: LineLoad::from_si(0.0),
            modulus: self.modulus,
            viscosity: oil.viscosity,
            pressure_viscosity: oil.pressure_viscosity,
            contact_length: None,
        };
        let groups = conditions.force_groups(self.load)?;
        let ellipticity = (across / along).powf(2.0 / std::f64::consts::PI);
        let isothermal = hamrock_dowson_central(&groups, along, ellipticity)?;
        let loading = thermal_loading(
            oil.viscosity,
            oil.temperature_coefficient,
            self.entrainment,
            oil.conductivity,
        )?;
        let reduction =
            ThermalLaw::Gupta.reduction(max_pressure, self.modulus, loading, self.slide_to_roll)?;
        let mut outside = isothermal.outside;
        outside.extend(reduction.outside);
        Ok(Checked {
            value: PointFilm {
                thickness: isothermal.value * reduction.value,
                thermal_reduction: reduction.value,
            },
            outside,
        })
    }

    /// Friction of a film of known thickness.
    ///
    /// # Errors
    /// When an input is outside its domain.
    pub fn friction(
        &self,
        rheology: &FilmRheology,
        hertz: &HertzPoint,
        film: Length,
        settings: FilmSettings,
    ) -> Result<Checked<FilmFrictionSolution>, LoadShareError> {
        let contact = FilmPointContact {
            load: self.load,
            half_axes: hertz.half_axes,
            speeds: self.speeds(),
            bodies: self.bodies,
            film,
            temperature: self.temperature,
            bulk_rise: self.bulk_rise,
        };
        Ok(solve(rheology, &contact, settings)?)
    }
}
