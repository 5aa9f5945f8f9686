//! Shear stress of an oil under pressure, temperature and shear rate.
//!
//! | symbol | meaning | unit |
//! |---|---|---|
//! | η₀(T), α(T) | viscosity at ambient pressure, pressure-viscosity coefficient | Pa s, 1/Pa |
//! | η(p, T) | viscosity in the film | Pa s |
//! | γ̇ | shear rate V_s/h | 1/s |
//! | τ_E | stress without a limit | Pa |
//! | τ_L | limiting shear stress | Pa |
//! | Λ, b_L, τ_L0 | its slope over pressure at 90 °C, its fall over temperature, its value at p = 0 | -, 1/K, Pa |
//! | τ₀ | Eyring stress | Pa |
//! | G_c, n, a | Carreau-Yasuda: critical stress, exponent, sharpness | Pa, -, - |
//!
//! Barus' exponential is far too steep as a viscosity above 0.5 GPa; with a limiting stress it is
//! harmless as traction, and for thin oils it is closer to measured gear losses than Roelands' law with the
//! same α, which gives a third of them. Never use it for film thickness.
//!
//! The blend of τ_E and τ_L with the power 4 and τ_L0 = 2 MPa are judgement; b_L is not known and 0.

use asperity_core::cite;
use asperity_core::numerics::{Solved, newton_root};
use asperity_core::quantity::{
    DynamicViscosity, Length, PerKelvin, Pressure, PressureViscosity, Speed, Temperature,
    ThermalConductivity,
};
use asperity_core::{DomainError, Quantity};
use asperity_oil::{Lubricant, gold_pressure_viscosity};
use schemars::JsonSchema;
use serde::{Deserialize, Serialize};

use super::oil_family::OilFamily;
use super::traction_constants::{CarreauConstants, TractionConstants};
use super::viscosity_table::ViscosityTable;
use crate::error::FrictionError;

/// Temperature at which the families' Λ holds, 90 °C \[K\].
const LIMIT_TEMPERATURE: f64 = 363.15;
/// Temperature at which Gold's formula gives α, 80 °C.
const GOLD_TEMPERATURE: Temperature = Temperature::from_si(353.15);
/// Largest exponent α p of Barus' law: beyond it the limiting stress rules by far.
const LARGEST_EXPONENT: f64 = 40.0;
/// Roelands' constants 1/p_r \[1/Pa\] and −ln η_r (Roelands 1966).
const ROELANDS: (f64, f64) = (5.1e-9, 9.67);
/// Largest ln(η/η₀) of Roelands' law that is evaluated: beyond it the limiting stress rules by far.
const LARGEST_ROELANDS: f64 = 200.0;
/// Mean over the film of the parabolic temperature profile above the walls; its middle has 1/8.
const FILM_MEAN: f64 = 1.0 / 12.0;
/// Relative step at which the Newton iteration of a shear stress ends; the error is its square.
const STRESS_TOLERANCE: f64 = 1e-8;
/// Above this ln(η γ̇/τ₀) the hyperbolic sine is its exponential to 3e-11 of the stress.
const STEEP: f64 = 12.0;

/// Law of shear stress against shear rate, below the limiting stress.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash, Default, Serialize, Deserialize, JsonSchema)]
#[serde(rename_all = "kebab-case", deny_unknown_fields)]
#[non_exhaustive]
pub enum ShearLaw {
    /// τ_E = τ₀ arsinh(η γ̇/τ₀).
    #[default]
    Eyring,
    /// τ_E = η γ̇ (1 + (η γ̇/G_c)^a)^((n − 1)/a).
    Carreau,
    /// τ_E = η γ̇.
    Newton,
}

/// Law of viscosity against pressure in the film.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash, Default, Serialize, Deserialize, JsonSchema)]
#[serde(rename_all = "kebab-case", deny_unknown_fields)]
#[non_exhaustive]
pub enum PressureLaw {
    /// η = η₀ exp(min(α p, 40)).
    #[default]
    Barus,
    /// Roelands, with the exponent that gives α at ambient pressure.
    Roelands,
}

/// Shear behaviour of one oil: viscosity over temperature, pressure law, shear law, limit.
///
/// Made once for an oil; every temperature, pressure and speed then costs no set-up.
#[derive(Debug, Clone, PartialEq)]
pub struct FilmRheology {
    viscosity: ViscosityTable,
    /// ln η₀ at the temperature of α.
    log_reference: f64,
    alpha_reference: f64,
    roelands_exponent: f64,
    /// ln τ₀
    log_eyring_stress: f64,
    constants: TractionConstants,
    shear: ShearLaw,
    pressure: PressureLaw,
}

/// The oil at one temperature and ambient pressure, as the film sees it.
#[derive(Debug, Clone, Copy, PartialEq, Serialize)]
pub struct FilmOilState {
    /// Viscosity η₀.
    pub viscosity: DynamicViscosity,
    /// Pressure-viscosity coefficient α.
    pub pressure_viscosity: PressureViscosity,
    /// Temperature coefficient β_T = −(dη/dT)/η.
    pub temperature_coefficient: PerKelvin,
    /// Thermal conductivity k at ambient pressure.
    pub conductivity: ThermalConductivity,
}

/// Properties of a place in the film that depend on its pressure alone.
#[derive(Debug, Clone, Copy)]
pub(super) struct PressurePoint {
    /// Pressure \[Pa\].
    pub(super) pressure: f64,
    /// (1 + 5.1e-9 p)^Z − 1
    roelands_growth: f64,
    /// Thermal conductivity k(p) \[W/(m K)\].
    pub(super) conductivity: f64,
}

impl FilmRheology {
    /// The rheology of a lubricant of this family, with α by Gold's formula at 80 °C.
    ///
    /// # Errors
    /// When the family's data does not read, or the lubricant has no viscosity between −60 °C and 500 °C.
    ///
    /// ```
    /// use asperity_oil::{BaseOil, LubricantInput};
    /// use asperity_tribo_friction::{FilmRheology, OilFamily};
    /// let oil = LubricantInput {
    ///     oil: Some("m100".into()), base_oil: Some(BaseOil::Mineral), ..LubricantInput::default()
    /// }.resolve("90 °C".parse()?)?;
    /// let rheology = FilmRheology::new(&oil, OilFamily::Mineral)?;
    /// let state = rheology.state("90 °C".parse()?)?;
    /// assert!((state.pressure_viscosity.si() - 14.25e-9).abs() < 0.05e-9);
    /// # Ok::<(), Box<dyn std::error::Error>>(())
    /// ```
    pub fn new(lubricant: &Lubricant, family: OilFamily) -> Result<Self, FrictionError> {
        let nu = lubricant.at(GOLD_TEMPERATURE)?.value.kinematic_viscosity;
        // At 80 °C thin oils lie below what the formula was fitted to; film friction was calibrated so.
        let alpha = gold_pressure_viscosity(family.into(), nu)?.value;
        let constants = TractionConstants::of(family)?;
        Self::with_alpha(lubricant, constants, alpha, GOLD_TEMPERATURE)
    }

    /// The rheology of a lubricant with α known at one temperature.
    ///
    /// α follows the viscosity over temperature with Gold's exponent.
    ///
    /// # Errors
    /// When a constant is outside its domain, or the lubricant has no viscosity.
    pub fn with_alpha(
        lubricant: &Lubricant,
        constants: TractionConstants,
        alpha: PressureViscosity,
        alpha_temperature: Temperature,
    ) -> Result<Self, FrictionError> {
        constants.validate()?;
        let alpha_reference = DomainError::positive("pressure-viscosity", alpha)?;
        let t = DomainError::positive("temperature of alpha", alpha_temperature)?;
        let viscosity = ViscosityTable::of(lubricant)?;
        let [log_reference, _] = viscosity.at(t);
        let rule = "must be above 6.31e-5 Pa s for Roelands' law";
        let log = DomainError::require(
            log_reference + ROELANDS.1 > 0.0,
            "viscosity",
            log_reference.exp(),
            "Pa s",
            rule,
        )
        .map(|_| log_reference + ROELANDS.1)?;
        Ok(Self {
            viscosity,
            log_reference,
            alpha_reference,
            roelands_exponent: alpha_reference / (ROELANDS.0 * log),
            log_eyring_stress: constants.eyring_stress.si().ln(),
            constants,
            shear: ShearLaw::default(),
            pressure: PressureLaw::default(),
        })
    }

    /// The same oil with another shear law and pressure law.
    #[must_use]
    pub fn with_laws(self, shear: ShearLaw, pressure: PressureLaw) -> Self {
        Self {
            shear,
            pressure,
            ..self
        }
    }

    /// The same oil with other traction constants.
    ///
    /// # Errors
    /// When a constant is outside its domain.
    pub fn with_constants(self, constants: TractionConstants) -> Result<Self, FrictionError> {
        constants.validate()?;
        Ok(Self {
            log_eyring_stress: constants.eyring_stress.si().ln(),
            constants,
            ..self
        })
    }

    /// Traction constants in use.
    #[must_use]
    pub fn constants(&self) -> &TractionConstants {
        &self.constants
    }

    /// Shear law and pressure law in use.
    #[must_use]
    pub fn laws(&self) -> (ShearLaw, PressureLaw) {
        (self.shear, self.pressure)
    }

    /// Temperatures between which the viscosity is known; beyond, ln η₀ is carried on as a line.
    #[must_use]
    pub fn temperature_range(&self) -> [Temperature; 2] {
        self.viscosity.ends().map(Temperature::from_si)
    }

    /// Viscosity, α, β_T and conductivity at ambient pressure.
    ///
    /// ```text
    /// α(T) = α_ref (η₀(T)/η₀(T_ref))^t                                     [Alpha-T]
    /// ```
    ///
    /// # Errors
    /// When the temperature is outside [`temperature_range`](Self::temperature_range).
    pub fn state(&self, temperature: Temperature) -> Result<FilmOilState, FrictionError> {
        cite!("Alpha-T");
        let t = DomainError::positive("temperature", temperature)?;
        let [low, high] = self.viscosity.ends();
        let rule = "is outside the temperatures where the viscosity law of the oil holds";
        DomainError::require((low..=high).contains(&t), "temperature", t, "K", rule)?;
        Ok(self.state_at(t))
    }

    pub(crate) fn state_at(&self, temperature: f64) -> FilmOilState {
        let [log, slope] = self.viscosity.at(temperature);
        FilmOilState {
            viscosity: DynamicViscosity::from_si(log.exp()),
            pressure_viscosity: PressureViscosity::from_si(self.alpha(log)),
            temperature_coefficient: PerKelvin::from_si(-slope),
            conductivity: self.constants.conductivity,
        }
    }

    fn alpha(&self, log_viscosity: f64) -> f64 {
        let t = self.constants.gold_exponent;
        self.alpha_reference * (t * (log_viscosity - self.log_reference)).exp()
    }

    /// k(p) = k (1 + c₁ p/(1 + c₂ p)), p in GPa                            `[Larsson-Andersson]`
    pub(super) fn point(&self, pressure: f64) -> PressurePoint {
        let c = &self.constants;
        let giga = pressure * 1e-9;
        let rise = c.conductivity_rise * giga / (1.0 + c.conductivity_bend * giga);
        let growth = match self.pressure {
            PressureLaw::Barus => 0.0,
            PressureLaw::Roelands => {
                (self.roelands_exponent * (ROELANDS.0 * pressure).ln_1p()).exp_m1()
            }
        };
        PressurePoint {
            pressure,
            roelands_growth: growth,
            conductivity: c.conductivity.si() * (1.0 + rise),
        }
    }

    /// ln η(p, T) and its slope over temperature.
    fn log_viscosity(&self, point: &PressurePoint, temperature: f64) -> [f64; 2] {
        let [log, slope] = self.viscosity.at(temperature);
        match self.pressure {
            PressureLaw::Barus => {
                let exponent = self.alpha(log) * point.pressure;
                if exponent < LARGEST_EXPONENT {
                    let t = self.constants.gold_exponent;
                    [log + exponent, slope * (1.0 + t * exponent)]
                } else {
                    [log + LARGEST_EXPONENT, slope]
                }
            }
            PressureLaw::Roelands => {
                let rise = (log + ROELANDS.1) * point.roelands_growth;
                if rise < LARGEST_ROELANDS {
                    [log + rise, slope * (1.0 + point.roelands_growth)]
                } else {
                    [log + LARGEST_ROELANDS, slope]
                }
            }
        }
    }

    /// τ_E and its slope over temperature.
    fn unlimited(&self, log_viscosity: [f64; 2], log_rate: f64) -> [f64; 2] {
        let [log, slope] = log_viscosity;
        let newton = log + log_rate;
        match self.shear {
            ShearLaw::Newton => {
                let stress = newton.exp();
                [stress, stress * slope]
            }
            ShearLaw::Eyring => {
                let tau_0 = self.constants.eyring_stress.si();
                let ratio = newton - self.log_eyring_stress;
                if ratio > STEEP {
                    return [tau_0 * (ratio + std::f64::consts::LN_2), tau_0 * slope];
                }
                let x = ratio.exp();
                let root = (1.0 + x * x).sqrt();
                [tau_0 * arsinh(x, root), tau_0 * slope * x / root]
            }
            ShearLaw::Carreau => {
                let CarreauConstants {
                    critical_stress,
                    exponent: n,
                    sharpness: a,
                } = self.constants.carreau;
                let q = (a * (newton - critical_stress.si().ln())).exp();
                // Beyond the range of the exponential the law is a power of the rate.
                let thin = if q.is_finite() {
                    q.ln_1p()
                } else {
                    a * (newton - critical_stress.si().ln())
                };
                let stress = (newton + (n - 1.0) / a * thin).exp();
                let steepness = 1.0 + (n - 1.0) * (1.0 - 1.0 / (1.0 + q));
                [stress, stress * steepness * slope]
            }
        }
    }

    /// τ and dτ/dT at one place; the shear rate by its logarithm.
    pub(super) fn stress(
        &self,
        point: &PressurePoint,
        temperature: f64,
        log_rate: f64,
    ) -> [f64; 2] {
        let [free, free_slope] = self.unlimited(self.log_viscosity(point, temperature), log_rate);
        let [limit, limit_slope] = self.limit(point, temperature);
        blend(free, free_slope, limit, limit_slope)
    }

    /// τ_L = τ_L0 + Λ exp(−b_L (T − 363.15)) p, and its slope over temperature.
    fn limit(&self, point: &PressurePoint, temperature: f64) -> [f64; 2] {
        let c = &self.constants;
        let fall = c.limiting_shear_fall.si();
        let mut proportional = c.limiting_shear * point.pressure;
        if fall > 0.0 {
            proportional *= (-fall * (temperature - LIMIT_TEMPERATURE)).exp();
        }
        [c.ambient_limit.si() + proportional, -fall * proportional]
    }

    /// τ_L at a place \[Pa\].
    pub(super) fn limiting_stress(&self, point: &PressurePoint, temperature: f64) -> f64 {
        self.limit(point, temperature)[0]
    }

    /// Shear stress at a place of the film whose walls have a given temperature, with the film's own
    /// heat.
    ///
    /// ```text
    /// τ = Law(p, T_s + (1/12) τ V_s h/k(p), V_s/h)                            [Film-heat]
    /// ```
    ///
    /// The law falls with temperature, so that there is one root.
    ///
    /// # Errors
    /// When pressure, film or temperature is not positive, the sliding speed not finite.
    ///
    /// ```
    /// # use asperity_oil::{BaseOil, LubricantInput};
    /// # use asperity_tribo_friction::{FilmRheology, OilFamily};
    /// # let oil = LubricantInput {
    /// #     oil: Some("m100".into()), base_oil: Some(BaseOil::Mineral), ..LubricantInput::default()
    /// # }.resolve("90 °C".parse()?)?;
    /// let rheology = FilmRheology::new(&oil, OilFamily::Mineral)?;
    /// let stress = rheology.shear_stress("1 GPa".parse()?, "90 °C".parse()?, "2 m/s".parse()?, "200 nm".parse()?)?;
    /// // Close to the limit of 2 MPa + 0.047 GPa.
    /// assert!(stress.value > 40e6 && stress.value < 49e6);
    /// # Ok::<(), Box<dyn std::error::Error>>(())
    /// ```
    pub fn shear_stress(
        &self,
        pressure: Pressure,
        wall_temperature: Temperature,
        sliding: Speed,
        film: Length,
    ) -> Result<Solved, FrictionError> {
        cite!("Limiting-shear");
        cite!("Larsson-Andersson");
        let p = DomainError::positive("pressure", pressure)?;
        let t = DomainError::positive("temperature of the walls", wall_temperature)?;
        let v = DomainError::finite(Speed::NAME, sliding)?.abs();
        let h = DomainError::positive("film", film)?;
        let point = self.point(p);
        let place = FilmPlace::new(&point, v, h);
        Ok(self.heated_stress(&point, &place, t, None)?.0)
    }

    /// τ with its own heat, and dτ/dT_s.
    pub(super) fn heated_stress(
        &self,
        point: &PressurePoint,
        place: &FilmPlace,
        wall_temperature: f64,
        start: Option<f64>,
    ) -> Result<(Solved, f64), FrictionError> {
        if place.log_rate == f64::NEG_INFINITY {
            let rest = Solved {
                value: 0.0,
                residual: 0.0,
                iterations: 0,
            };
            return Ok((rest, 0.0));
        }
        let cold = self.stress(point, wall_temperature, place.log_rate);
        let mut slope = cold[1];
        if place.heating == 0.0 {
            let isothermal = Solved {
                value: cold[0],
                residual: 0.0,
                iterations: 1,
            };
            return Ok((isothermal, slope));
        }
        cite!("Film-heat");
        let start = start.filter(|tau| *tau < cold[0]).unwrap_or_else(|| {
            // One Newton step from the unheated stress.
            cold[0] / (1.0 - place.heating * cold[1])
        });
        let solved = newton_root(
            |tau| {
                let at = wall_temperature + place.heating * tau;
                let [law, falls] = self.stress(point, at, place.log_rate);
                slope = falls;
                (tau - law, 1.0 - place.heating * falls)
            },
            [0.0, cold[0]],
            start,
            STRESS_TOLERANCE,
        )
        .map_err(|source| FrictionError::NoRoot {
            quantity: "shear stress of the heated film",
            source,
        })?;
        Ok((solved, slope / (1.0 - place.heating * slope)))
    }
}

/// Shear rate and self-heating of a place in the film.
#[derive(Debug, Clone, Copy)]
pub(super) struct FilmPlace {
    /// ln(V_s/h); −∞ without sliding.
    log_rate: f64,
    /// Rise of the mean film temperature over the walls per stress \[K/Pa\].
    pub(super) heating: f64,
}

impl FilmPlace {
    pub(super) fn new(point: &PressurePoint, sliding: f64, film: f64) -> Self {
        Self {
            log_rate: (sliding / film).ln(),
            heating: FILM_MEAN * sliding * film / point.conductivity,
        }
    }

    /// The same place held at the temperature of the walls.
    pub(super) fn isothermal(self) -> Self {
        Self {
            heating: 0.0,
            ..self
        }
    }
}

/// arsinh x of an x from 0 to 10¹⁰⁰, from `root` = √(1 + x²): to the last digits, at a third of the cost of the standard
/// library's, which guards against overflow.
fn arsinh(x: f64, root: f64) -> f64 {
    match x > 0.5 {
        true => (x + root).ln(),
        false => (x + x * x / (1.0 + root)).ln_1p(),
    }
}

/// τ = τ_E (1 + (τ_E/τ_L)⁴)^(−1/4)                                          `[Limiting-shear]`
///
/// with its slope over temperature; free of overflow on both sides.
fn blend(free: f64, free_slope: f64, limit: f64, limit_slope: f64) -> [f64; 2] {
    if limit <= 0.0 {
        return [0.0, 0.0];
    }
    let r = free / limit;
    if r < 1.0 {
        let r4 = (r * r) * (r * r);
        let root = (1.0 + r4).sqrt().sqrt();
        let share = 1.0 / (root * (1.0 + r4));
        [free / root, share * (free_slope + r4 * r * limit_slope)]
    } else {
        let s = limit / free;
        let s4 = (s * s) * (s * s);
        let root = (1.0 + s4).sqrt().sqrt();
        let share = 1.0 / (root * (1.0 + s4));
        [limit / root, share * (limit_slope + s4 * s * free_slope)]
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_inverse_hyperbolic_sine_is_that_of_the_standard_library_to_the_last_digits() {
        for k in -1200..=520 {
            let x = 10_f64.powf(0.01 * f64::from(k));
            let found = arsinh(x, (1.0 + x * x).sqrt());
            assert!((found / x.asinh() - 1.0).abs() < 6e-16, "{x}");
        }
        assert_eq!(arsinh(0.0, 1.0), 0.0);
    }
}
