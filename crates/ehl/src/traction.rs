//! Traction of a smooth steady film: isothermal and thermal, with and without a limiting stress.
//!
//! | symbol | meaning | unit |
//! |---|---|---|
//! | τ, γ | shear stress, shear rate (u₁ − u₂)/h | Pa, 1/s |
//! | T_b, T_s, T | bulk temperature, surface temperature, mean temperature of the film | K |
//! | q | heat τ·(u₁ − u₂) per area | W/m² |
//! | k_f | thermal conductivity of the oil | W/(m K) |
//! | ρ, c, k | density, heat capacity, conductivity of both bodies | |
//!
//! The film temperature adds the mean of a heat source even across the film; the surfaces share the
//! heat of a moving band (Jaeger), both at one temperature.

use std::f64::consts::PI;

use asperity_core::material::Material;
use asperity_core::quantity::{PerKelvin, Pressure, Temperature, ThermalConductivity};
use asperity_core::{DomainError, cite};
use asperity_oil::{HeatedViscosity, RelativeViscosity, ShearLaw};
use serde::Serialize;

use crate::dimensionless::LineContact;
use crate::error::EhlError;
use crate::oil::Oil;
use crate::steady::SteadyFilm;

/// Largest number of iterations of the temperatures.
const ITERATIONS: usize = 400;
/// Change of the shear stress at which they end \[Pa\]: about 1e-5 of a typical stress.
const TOLERANCE: f64 = 1e2;
/// Share of the new value in an iteration: more stress heats the film, which lowers the stress, so full steps alternate
/// around the solution.
const DAMPING: f64 = 0.3;
/// Pressure below which a place carries no traction \[Pa\].
const LEAST_PRESSURE: f64 = 1e3;
/// Largest ln(η/η₀) that is evaluated: the exponential stays finite, and the shear stress is the limit by far.
const LARGEST_LOG: f64 = 120.0;

/// Heat of the film and the bodies.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Heat {
    /// Bulk temperature, at which the oil's viscosity holds.
    pub bulk: Temperature,
    /// −(dη/dT)/η at the bulk temperature and ambient pressure.
    pub temperature_coefficient: PerKelvin,
    /// Thermal conductivity of the oil.
    pub oil_conductivity: ThermalConductivity,
    /// Material of both bodies.
    pub material: Material,
}

/// Inputs of the traction besides the film.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct TractionLaw {
    /// Shear law.
    pub shear: ShearLaw,
    /// Limiting stress over pressure.
    pub limit: Option<f64>,
    /// Heat; isothermal without.
    pub heat: Option<Heat>,
}

/// Traction of a film.
#[derive(Debug, Clone, Copy, PartialEq, Serialize)]
pub struct Traction {
    /// Friction coefficient.
    pub coefficient: f64,
    /// Largest shear stress.
    pub max_stress: Pressure,
    /// Largest rise of the film temperature \[K\].
    pub film_rise: f64,
    /// Largest rise of the surface temperature \[K\].
    pub surface_rise: f64,
    /// Rise of the film temperature, weighted by the pressure \[K\].
    pub mean_film_rise: f64,
    /// Iterations of the temperatures.
    pub iterations: usize,
}

/// Traction of the smooth film `film` of `contact` under its sliding.
///
/// # Errors
/// When an input is outside its domain or the temperatures do not settle.
pub fn traction(
    contact: &LineContact,
    oil: &Oil,
    film: &SteadyFilm,
    law: &TractionLaw,
) -> Result<Traction, EhlError> {
    let sheared = Oil {
        shear_law: law.shear,
        ..*oil
    };
    let scales = contact.scales(&sheared)?;
    let limit = law.limit.unwrap_or(f64::INFINITY);
    DomainError::require(
        limit > 0.0,
        "limiting stress over pressure",
        limit,
        "-",
        "must be positive",
    )?;
    let state = State::new(oil, &scales, film, law.shear, limit);
    match &law.heat {
        None => {
            let stress = state.stresses(|p, _| state.viscosity.log(p)[0]);
            Ok(state.summary(contact, &stress, None, 0))
        }
        Some(heat) => state.thermal(contact, heat),
    }
}

/// Film, pressure and law in SI units.
struct State {
    dx: f64,
    pressure: Vec<f64>,
    film: Vec<f64>,
    viscosity: RelativeViscosity,
    ambient: f64,
    sliding: f64,
    shear: ShearLaw,
    limit: f64,
}

/// Temperature rises of film and surfaces.
struct Rises {
    film: Vec<f64>,
    surface: Vec<f64>,
}

impl State {
    fn new(
        oil: &Oil,
        scales: &crate::dimensionless::Scales,
        film: &SteadyFilm,
        shear: ShearLaw,
        limit: f64,
    ) -> Self {
        let p_0 = scales.max_pressure.si();
        Self {
            dx: (film.x[1] - film.x[0]) * scales.half_width.si(),
            pressure: film.pressure.iter().map(|p| p * p_0).collect(),
            film: film.film.iter().map(|h| h * scales.film).collect(),
            viscosity: oil.viscosity_over(1.0),
            ambient: oil.viscosity.si(),
            sliding: scales.sliding.abs(),
            shear,
            limit,
        }
    }

    /// Shear stress at every node, where ln(η/η₀) is `log` of the pressure and the node.
    fn stresses(&self, log: impl Fn(f64, usize) -> f64) -> Vec<f64> {
        (0..self.pressure.len())
            .map(|i| {
                let p = self.pressure[i];
                if p <= LEAST_PRESSURE {
                    return 0.0;
                }
                let eta = self.ambient * log(p, i).min(LARGEST_LOG).exp();
                let rate = self.sliding / self.film[i];
                self.shear.stress(eta, rate).min(self.limit * p)
            })
            .collect()
    }

    /// Fixed point of stress and temperatures.
    fn thermal(&self, contact: &LineContact, heat: &Heat) -> Result<Traction, EhlError> {
        let viscosity =
            HeatedViscosity::new(self.viscosity, heat.bulk, heat.temperature_coefficient)?;
        let k_f = DomainError::positive("conductivity of the oil", heat.oil_conductivity)?;
        let flash = Flash::new(contact, heat, self.dx, self.pressure.len())?;
        let n = self.pressure.len();
        let mut rises = Rises {
            film: vec![0.0; n],
            surface: vec![0.0; n],
        };
        let stresses = |film_rise: &[f64]| self.stresses(|p, i| viscosity.log(p, film_rise[i]));
        let mut stress = stresses(&rises.film);
        let mut change = f64::INFINITY;
        for iteration in 1..=ITERATIONS {
            let sources: Vec<f64> = stress.iter().map(|t| t * self.sliding).collect();
            rises.surface = flash.rise(&sources);
            for (i, source) in sources.iter().enumerate() {
                let new = rises.surface[i] + source * self.film[i] / (12.0 * k_f);
                let target = if self.pressure[i] > LEAST_PRESSURE {
                    new
                } else {
                    0.0
                };
                rises.film[i] += DAMPING * (target - rises.film[i]);
            }
            let target = stresses(&rises.film);
            change = 0.0;
            for (t, new) in stress.iter_mut().zip(target) {
                change = f64::max(change, (new - *t).abs());
                *t += DAMPING * (new - *t);
            }
            if change < TOLERANCE {
                return Ok(self.summary(contact, &stress, Some(&rises), iteration));
            }
        }
        Err(EhlError::temperatures_unsettled(
            ITERATIONS,
            Pressure::from_si(change),
        ))
    }

    fn summary(
        &self,
        contact: &LineContact,
        stress: &[f64],
        rises: Option<&Rises>,
        iterations: usize,
    ) -> Traction {
        let largest = |values: &[f64]| values.iter().copied().fold(0.0, f64::max);
        let force: f64 = stress.iter().sum::<f64>() * self.dx;
        let weighted = |rise: &[f64]| {
            let sum: f64 = rise.iter().zip(&self.pressure).map(|(t, p)| t * p).sum();
            sum / self.pressure.iter().sum::<f64>()
        };
        Traction {
            coefficient: force / contact.load.si(),
            max_stress: Pressure::from_si(largest(stress)),
            film_rise: rises.map_or(0.0, |r| largest(&r.film)),
            surface_rise: rises.map_or(0.0, |r| largest(&r.surface)),
            mean_film_rise: rises.map_or(0.0, |r| weighted(&r.film)),
            iterations,
        }
    }
}

/// Temperature of the surfaces under a moving distribution of heat.
struct Flash {
    /// Rise at a distance behind a cell of unit heat.
    kernel: Vec<f64>,
}

impl Flash {
    /// ΔT(x) = ∫ q(x′)/√(x − x′) dx′/(√(π·ρ·c·k)·(√u₁ + √u₂)), constant heat in each cell  `[Flash-film]`
    fn new(contact: &LineContact, heat: &Heat, dx: f64, count: usize) -> Result<Self, EhlError> {
        cite!("Flash-film");
        let material = &heat.material;
        let rho = DomainError::positive("density of the bodies", material.density)?;
        let c = DomainError::positive("heat capacity of the bodies", material.heat_capacity)?;
        let k = DomainError::positive("conductivity of the bodies", material.conductivity)?;
        let roots: f64 = [contact.speed_1, contact.speed_2]
            .iter()
            .map(|u| u.si().abs().sqrt())
            .sum();
        let effusivity = (PI * rho * c * k).sqrt() * roots;
        let kernel = (0..count)
            .map(|i| 2.0 * (((i + 1) as f64 * dx).sqrt() - (i as f64 * dx).sqrt()) / effusivity)
            .collect();
        Ok(Self { kernel })
    }

    fn rise(&self, sources: &[f64]) -> Vec<f64> {
        (0..sources.len())
            .map(|i| (0..=i).map(|j| sources[j] * self.kernel[i - j]).sum())
            .collect()
    }
}
