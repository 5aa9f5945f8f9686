//! Film and friction of touching asperities, each a small lubricated line contact.
//!
//! | symbol | meaning | unit |
//! |---|---|---|
//! | f_k, b_k | load and width of a spot | N/m, m |
//! | R_k | radius of the Hertz contact with that load and width | m |
//! | h_k | Moes' film of it, at the surface temperature of the whole contact | m |
//! | p_k | mean asperity pressure f_k/b_k | Pa |
//! | τ_k | shear stress of the film there | Pa |

use std::f64::consts::PI;

use asperity_core::cite;
use asperity_core::quantity::{Length, Pressure, Speed, Temperature};
use asperity_ehl_regime::FilmGroups;
use asperity_ehl_regime::film_line::moes;
use asperity_oil::FilmRheology;
use asperity_tribo_friction::boundary::boundary_share;

use crate::error::LoadShareError;
use crate::rough_contact::Spot;

/// Thinnest film that the shear rate of a spot is taken of.
const THINNEST: f64 = 1e-9;

/// Data common to all spots of a contact.
#[derive(Debug, Clone, Copy)]
pub(crate) struct SpotConditions<'a> {
    pub(crate) rheology: &'a FilmRheology,
    pub(crate) wall: Temperature,
    pub(crate) modulus: f64,
    /// Speed that carries oil into a spot.
    pub(crate) entrainment: f64,
    pub(crate) sliding: f64,
    pub(crate) boundary_layer: Length,
}

/// Friction of all spots of a contact, as means over their load.
#[derive(Debug, Clone, Copy, Default, PartialEq)]
pub(crate) struct SpotFriction {
    /// Share β on the boundary layer.
    pub(crate) boundary_share: f64,
    /// (1 − β) μ_a.
    pub(crate) lubricated: f64,
    /// Film h_a.
    pub(crate) film: f64,
}

impl SpotFriction {
    /// μ_a of the lubricated part; 0 where there is none.
    pub(crate) fn asperity_coefficient(&self) -> f64 {
        let share = 1.0 - self.boundary_share;
        if share > 0.0 {
            self.lubricated / share
        } else {
            0.0
        }
    }

    /// This and another by their weights.
    pub(crate) fn add(&mut self, other: &Self, weight: f64) {
        self.boundary_share += weight * other.boundary_share;
        self.lubricated += weight * other.lubricated;
        self.film += weight * other.film;
    }
}

impl SpotConditions<'_> {
    /// Boundary share, friction and film of touching spots.
    ///
    /// ```text
    /// R_k = π E* (b_k/2)²/(4 f_k),  β = Σ f_k β_k/Σ f_k,
    /// μ_a = Σ f_k (1 − β_k) τ_k/p_k / Σ f_k (1 − β_k)                          [Spot-friction]
    /// ```
    ///
    /// # Errors
    /// When a spot has no film.
    pub(crate) fn friction(&self, spots: &[Spot]) -> Result<SpotFriction, LoadShareError> {
        cite!("Spot-friction");
        let state = self.rheology.state(self.wall)?;
        let modulus = 2.0 * self.modulus;
        let material = state.pressure_viscosity.si() * modulus;
        let (mut total, mut sum) = (0.0, SpotFriction::default());
        for spot in spots {
            let (f, b) = (spot.load.si(), spot.width.si());
            let radius = PI * self.modulus * 0.25 * b * b / (4.0 * f);
            let groups = FilmGroups {
                material,
                speed: state.viscosity.si() * self.entrainment / (modulus * radius),
                load: f / (modulus * radius),
            };
            let film = moes(&groups, Length::from_si(radius))?;
            let beta = boundary_share(film, self.boundary_layer)?.clamp(0.0, 1.0);
            let pressure = f / b;
            let stress = self.rheology.shear_stress(
                Pressure::from_si(pressure),
                self.wall,
                Speed::from_si(self.sliding),
                Length::from_si(film.si().max(THINNEST)),
            )?;
            let friction = SpotFriction {
                boundary_share: beta,
                lubricated: (1.0 - beta) * stress.value / pressure,
                film: film.si(),
            };
            sum.add(&friction, f);
            total += f;
        }
        let mut mean = SpotFriction::default();
        if total > 0.0 {
            mean.add(&sum, 1.0 / total);
        }
        Ok(mean)
    }
}
