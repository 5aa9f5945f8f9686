//! Film and friction of touching asperities, each a small lubricated line contact.
//!
//! | symbol | meaning | unit |
//! |---|---|---|
//! | f_k | load of a spot | N/m |
//! | F_k, b_k | load and width of the contact that it is part of | N/m, m |
//! | R_k | radius of the Hertz contact with that load and width | m |
//! | h_k | film thickness of that contact by Moes, at the surface temperature of the whole contact | m |
//! | p_k | mean asperity pressure F_k/b_k | Pa |
//! | τ_k | shear stress of its film | Pa |

use std::f64::consts::PI;

use asperity_core::cite;
use asperity_core::quantity::{Length, Pressure, Speed, Temperature};
use asperity_ehl_regime::FilmGroups;
use asperity_ehl_regime::film_line::moes;
use asperity_oil::{FilmOilState, FilmRheology};
use asperity_tribo_friction::boundary::boundary_share;

use crate::error::LoadShareError;
use crate::spot_tree::{BySpot, Spot};

/// Smallest film thickness used for the shear rate of a spot: a few molecules, where a boundary layer of 10 nm carries
/// 91 % of the load.
const THINNEST: f64 = 1e-9;

/// Relative step of the difference quotients of a spot's friction.
const SLOPE_STEP: f64 = 1e-4;

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
    /// μ_a of the lubricated part; 0 without one.
    pub(crate) fn asperity_coefficient(&self) -> f64 {
        let share = 1.0 - self.boundary_share;
        if share > 0.0 {
            self.lubricated / share
        } else {
            0.0
        }
    }

    /// Friction coefficient (1 − β) μ_a + β μ_b with the coefficient `boundary` of the boundary layer.
    pub(crate) fn total(&self, boundary: f64) -> f64 {
        self.lubricated + self.boundary_share * boundary
    }

    /// Adds `weight` times `other`.
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
    /// R_k = π E* (b_k/2)²/(4 F_k),  β = Σ f_k β_k/Σ f_k,
    /// μ_a = Σ f_k (1 − β_k) τ_k/p_k / Σ f_k (1 − β_k)                          [Spot-friction]
    /// ```
    ///
    /// # Errors
    /// When a spot has no film.
    pub(crate) fn friction(&self, spots: &[Spot]) -> Result<SpotFriction, LoadShareError> {
        self.friction_from(spots, &mut vec![None; spots.len()])
    }

    /// [`friction`](Self::friction), started from the shear stress of each spot at a nearby temperature if it is known.
    /// `stresses` holds the solutions afterwards.
    ///
    /// # Errors
    /// When a spot has no film.
    pub(crate) fn friction_from(
        &self,
        spots: &[Spot],
        stresses: &mut [Option<f64>],
    ) -> Result<SpotFriction, LoadShareError> {
        cite!("Spot-friction");
        let state = self.rheology.state(self.wall)?;
        let (mut total, mut sum) = (0.0, SpotFriction::default());
        for (spot, stress) in spots.iter().zip(stresses) {
            let f = spot.load.si();
            let contact = [spot.joint_load.si(), spot.width.si()];
            sum.add(&self.of_spot(&state, contact, stress)?, f);
            total += f;
        }
        let mut mean = SpotFriction::default();
        if total > 0.0 {
            mean.add(&sum, 1.0 / total);
        }
        Ok(mean)
    }

    /// Whether the film of a spot is thinner than the smallest film thickness used for its shear rate.
    ///
    /// # Errors
    /// When a spot has no film.
    pub(crate) fn limits_shear_rate(&self, spots: &[Spot]) -> Result<bool, LoadShareError> {
        let state = self.rheology.state(self.wall)?;
        for spot in spots {
            let contact = [spot.joint_load.si(), spot.width.si()];
            if self.of_spot(&state, contact, &mut None)?.film < THINNEST {
                return Ok(true);
            }
        }
        Ok(false)
    }

    /// Derivatives of the mean friction coefficient of `spots`, with the coefficient `boundary` of the boundary layer, over
    /// load, joint load and width of each spot \[m/N, m/N, 1/m\].
    ///
    /// ```text
    /// B = Σ f_k e_k/Σ f:  ∂B/∂f_k = (e_k − B)/Σ f,  ∂B/∂F_k = f_k ∂e/∂F/Σ f,  ∂B/∂b_k = f_k ∂e/∂b/Σ f   [Spot-gradient]
    /// ```
    ///
    /// The friction e(F, b) of one spot is smooth; its slopes are central difference quotients.
    ///
    /// # Errors
    /// When a spot has no film.
    pub(crate) fn slopes(
        &self,
        spots: &[Spot],
        boundary: f64,
    ) -> Result<Vec<BySpot>, LoadShareError> {
        cite!("Spot-gradient");
        let state = self.rheology.state(self.wall)?;
        let total: f64 = spots.iter().map(|spot| spot.load.si()).sum();
        let mut stresses = vec![None; spots.len()];
        let mean = self.friction_from(spots, &mut stresses)?.total(boundary);
        let slopes = |(spot, mut stress): (&Spot, Option<f64>)| {
            let mut at = |f: f64, b: f64| -> Result<f64, LoadShareError> {
                let of_spot = self.of_spot(&state, [f, b], &mut stress)?;
                Ok(of_spot.total(boundary))
            };
            let (f, h) = (spot.load.si(), SLOPE_STEP);
            let (joint, b) = (spot.joint_load.si(), spot.width.si());
            let by_joint_load = (at(joint * (1.0 + h), b)? - at(joint * (1.0 - h), b)?) / joint;
            let by_width = (at(joint, b * (1.0 + h))? - at(joint, b * (1.0 - h))?) / b;
            let of_contact = [by_joint_load, by_width].map(|slope| f * slope / (2.0 * h * total));
            let by_load = (at(joint, b)? - mean) / total;
            Ok([by_load, of_contact[0], of_contact[1]])
        };
        spots.iter().zip(stresses).map(slopes).collect()
    }

    /// Friction and film of a contact with load and width `[f, b]`. `stress` holds the shear stress at a nearby state, if
    /// known, and the solution afterwards.
    fn of_spot(
        &self,
        state: &FilmOilState,
        [f, b]: [f64; 2],
        stress: &mut Option<f64>,
    ) -> Result<SpotFriction, LoadShareError> {
        let modulus = 2.0 * self.modulus;
        let material = state.pressure_viscosity.si() * modulus;
        let radius = PI * self.modulus * 0.25 * b * b / (4.0 * f);
        let groups = FilmGroups {
            material,
            speed: state.viscosity.si() * self.entrainment / (modulus * radius),
            load: f / (modulus * radius),
        };
        let film = moes(&groups, Length::from_si(radius))?;
        let beta = boundary_share(film, self.boundary_layer)?.clamp(0.0, 1.0);
        let pressure = f / b;
        let (sliding, thickness) = (Speed::from_si(self.sliding), film.si().max(THINNEST));
        let place = (
            Pressure::from_si(pressure),
            sliding,
            Length::from_si(thickness),
        );
        let sheared_film = self.rheology.shear_stress_from(place, self.wall, *stress)?;
        *stress = Some(sheared_film.value);
        Ok(SpotFriction {
            boundary_share: beta,
            lubricated: (1.0 - beta) * sheared_film.value / pressure,
            film: film.si(),
        })
    }
}
