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
//! | f | pressure-viscosity coefficient of the friction over α, which the film thickness keeps | - |
//! | τ₀ | Eyring stress | Pa |
//! | G_c, n, a | Carreau-Yasuda: critical stress, exponent, sharpness | Pa, -, - |
//!
//! Barus' exponential is far too steep as a viscosity above 0.5 GPa; with a limiting stress it is
//! harmless as traction, and for thin oils it is closer to measured gear losses than Roelands' law with the
//! same α, which gives a third of them. Never use it for film thickness.
//!
//! τ_L0 = 2 MPa is assumed; b_L and f are 0 and 1 unless traction curves of the oil determine them. The blend of τ_E and τ_L is [`limited_stress_by`].

use std::sync::Arc;

use asperity_core::cite;
use asperity_core::numerics::elementary::{arsinh, exp};
use asperity_core::numerics::{Solved, VECTOR_WIDTH, newton_root, vectorised};
use asperity_core::quantity::{
    DynamicViscosity, Length, PerKelvin, Pressure, PressureViscosity, Speed, Temperature,
    ThermalConductivity,
};
use asperity_core::{DomainError, Quantity};
use serde::Serialize;

use crate::viscosity_pressure::{ROELANDS_LOG, ROELANDS_PER_PASCAL, roelands_growth};
use crate::viscosity_table::ViscosityTable;
use crate::{
    BaseOil, CarreauConstants, LARGEST_BARUS_EXPONENT, LIMIT_POWER, Lubricant, LubricantError,
    PressureLaw, ShearLawName, TractionConstants, gold_pressure_viscosity, limited_stress_by,
};

/// Temperature at which Gold's formula gives α, 80 °C.
pub const GOLD_TEMPERATURE: Temperature = Temperature::from_si(353.15);
/// Largest ln(η/η₀) of Roelands' law: beyond it the shear stress is the limit.
const LARGEST_ROELANDS: f64 = 200.0;
/// Mean over the film of the parabolic temperature profile above the walls; its middle has 1/8.
const FILM_MEAN: f64 = 1.0 / 12.0;
/// Relative step at which the Newton iteration of a shear stress ends; the error is its square.
const STRESS_TOLERANCE: f64 = 1e-6;
/// Largest stress that a start is taken to be near to, over the start.
const START_REACH: f64 = 2.0;
/// ln(η γ̇/τ₀) above which arsinh is a logarithm to the last digit.
const STEEP: f64 = 300.0;
/// Points whose stresses are solved at a time.
pub const LANES: usize = 16;
/// Highest stress over the unheated one where the limit does not rise, with its rounding.
const ROUNDED: f64 = 1.0 + 1e-9;
/// Steps after which points that are solved together have converged, or are solved each by itself within its bracket.
const STEPS_TOGETHER: usize = 8;

/// Shear behaviour of one oil: viscosity over temperature, pressure law, shear law, limit.
///
/// Built once for an oil; an evaluation at a temperature, pressure and speed needs no further set-up.
#[derive(Debug, Clone, PartialEq)]
pub struct FilmRheology {
    viscosity: Arc<ViscosityTable>,
    /// ln η₀ at the temperature T_ref of α.
    log_reference: f64,
    /// α at T_ref \[1/Pa\].
    alpha_reference: f64,
    roelands_exponent: f64,
    /// Factor on α in the film thickness only.
    film_factor: f64,
    /// ln τ₀
    log_eyring_stress: f64,
    constants: TractionConstants,
    shear: ShearLawName,
    pressure: PressureLaw,
}

/// The oil in a film at one temperature and ambient pressure.
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

/// A point of a film: what its shear stress depends on besides the temperature of the walls.
#[derive(Debug, Clone, Copy)]
pub struct FilmPoint {
    /// Pressure \[Pa\].
    pressure: f64,
    /// (1 + 5.1e-9 p)^Z − 1; 0 under Barus' law.
    roelands_growth: f64,
    /// ln(V_s/h); −∞ without sliding.
    log_rate: f64,
    /// Rise of the mean film temperature over the walls per stress \[K/Pa\].
    heating: f64,
}

impl FilmPoint {
    /// A film at ambient pressure without sliding.
    pub const REST: Self = Self {
        pressure: 0.0,
        roelands_growth: 0.0,
        log_rate: f64::NEG_INFINITY,
        heating: 0.0,
    };

    /// Pressure \[Pa\].
    #[must_use]
    pub fn pressure(&self) -> f64 {
        self.pressure
    }

    /// Rise of the mean film temperature over the walls per stress \[K/Pa\].
    #[must_use]
    pub fn heating(&self) -> f64 {
        self.heating
    }

    /// The same point at the temperature of the walls.
    #[must_use]
    pub fn isothermal(self) -> Self {
        self.with_heating(0.0)
    }

    /// The same point with another rise of the film temperature per stress \[K/Pa\].
    #[must_use]
    pub fn with_heating(self, heating: f64) -> Self {
        Self { heating, ..self }
    }
}

/// A point of a film with its stress, which is solved together with those of others.
#[derive(Debug, Clone, Copy)]
pub struct ShearedPoint {
    /// The point.
    pub point: FilmPoint,
    /// A guess of the stress, such as that at a temperature nearby \[Pa\].
    pub start: Option<f64>,
    /// The stress \[Pa\] and its slope over the temperature of the walls \[Pa/K\], once solved.
    pub stress: [f64; 2],
}

impl FilmRheology {
    /// The rheology of a lubricant on this base oil, with α by Gold's formula at 80 °C.
    ///
    /// # Errors
    /// When the data of the base oil cannot be read, or the lubricant has no viscosity between −60 °C and 500 °C.
    ///
    /// ```
    /// use asperity_oil::{BaseOil, FilmRheology, LubricantInput};
    /// let oil = LubricantInput {
    ///     oil: Some("m100".into()), base_oil: Some(BaseOil::Mineral), ..LubricantInput::default()
    /// }.resolve("90 °C".parse()?)?;
    /// let rheology = FilmRheology::new(&oil, BaseOil::Mineral)?;
    /// let state = rheology.state("90 °C".parse()?)?;
    /// assert!((state.pressure_viscosity.si() - 14.25e-9).abs() < 0.05e-9);
    /// # Ok::<(), Box<dyn std::error::Error>>(())
    /// ```
    pub fn new(lubricant: &Lubricant, base_oil: BaseOil) -> Result<Self, LubricantError> {
        let nu = lubricant.at(GOLD_TEMPERATURE)?.value.kinematic_viscosity;
        // At 80 °C thin oils lie below the fitted range of the formula; film friction was calibrated with these values.
        let alpha = gold_pressure_viscosity(base_oil, nu)?.value;
        let constants = TractionConstants::from_family(base_oil)?;
        Self::with_alpha(lubricant, constants, alpha, GOLD_TEMPERATURE)
    }

    /// The rheology of a lubricant with these constants, with α as the lubricant gives it, at `alpha_temperature`, or by
    /// Gold's formula.
    ///
    /// # Errors
    /// As [`new`](Self::new) and [`with_alpha`](Self::with_alpha).
    pub fn from_lubricant(
        lubricant: &Lubricant,
        base_oil: BaseOil,
        constants: TractionConstants,
        alpha_temperature: Temperature,
    ) -> Result<Self, LubricantError> {
        match lubricant.given_pressure_viscosity() {
            Some(alpha) => Self::with_alpha(lubricant, constants, alpha, alpha_temperature),
            None => Self::new(lubricant, base_oil)?.with_constants(constants),
        }
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
    ) -> Result<Self, LubricantError> {
        constants.validate()?;
        let alpha_reference = DomainError::positive("pressure-viscosity", alpha)?;
        let t = DomainError::positive("temperature of alpha", alpha_temperature)?;
        let viscosity = ViscosityTable::from_lubricant(lubricant)?;
        let [log_reference, _] = viscosity.at(t);
        let log = log_reference + ROELANDS_LOG;
        DomainError::require(
            log > 0.0,
            "viscosity",
            log_reference.exp(),
            "Pa s",
            "must be above 6.31e-5 Pa s for Roelands' law",
        )?;
        Ok(Self {
            viscosity,
            log_reference,
            alpha_reference,
            roelands_exponent: alpha_reference / (ROELANDS_PER_PASCAL * log),
            film_factor: 1.0,
            log_eyring_stress: constants.eyring_stress.si().ln(),
            constants,
            shear: ShearLawName::default(),
            pressure: PressureLaw::default(),
        })
    }

    /// The same oil with another shear law and pressure law.
    #[must_use]
    pub fn with_laws(self, shear: ShearLawName, pressure: PressureLaw) -> Self {
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
    pub fn with_constants(self, constants: TractionConstants) -> Result<Self, LubricantError> {
        constants.validate()?;
        Ok(Self {
            log_eyring_stress: constants.eyring_stress.si().ln(),
            constants,
            ..self
        })
    }

    /// The same oil with `factor` times the pressure-viscosity coefficient.
    #[must_use]
    pub fn with_alpha_factor(self, factor: f64) -> Self {
        Self {
            alpha_reference: self.alpha_reference * factor,
            roelands_exponent: self.roelands_exponent * factor,
            ..self
        }
    }

    /// The same oil with `factor` times the pressure-viscosity coefficient in the film thickness only, as film friction is
    /// known by its own.
    #[must_use]
    pub fn with_film_alpha_factor(self, factor: f64) -> Self {
        Self {
            film_factor: self.film_factor * factor,
            ..self
        }
    }

    /// Factor on the pressure-viscosity coefficient in the film thickness only.
    #[must_use]
    pub fn film_alpha_factor(&self) -> f64 {
        self.film_factor
    }

    /// The pressure-viscosity coefficient over that of `other`, each at its own reference temperature.
    #[must_use]
    pub fn alpha_over(&self, other: &Self) -> f64 {
        self.alpha_reference / other.alpha_reference
    }

    /// Traction constants in use.
    #[must_use]
    pub fn constants(&self) -> &TractionConstants {
        &self.constants
    }

    /// Shear law and pressure law in use.
    #[must_use]
    pub fn laws(&self) -> (ShearLawName, PressureLaw) {
        (self.shear, self.pressure)
    }

    /// Temperatures between which the viscosity is known; beyond them ln η₀ continues as a line.
    #[must_use]
    pub fn temperature_range(&self) -> [Temperature; 2] {
        self.viscosity.ends().map(Temperature::from_si)
    }

    /// Viscosity, α of the film thickness, β_T and conductivity at ambient pressure.
    ///
    /// ```text
    /// α(T) = α_ref (η₀(T)/η₀(T_ref))^t                                     [Alpha-T]
    /// ```
    ///
    /// # Errors
    /// When the temperature is outside [`temperature_range`](Self::temperature_range).
    pub fn state(&self, temperature: Temperature) -> Result<FilmOilState, LubricantError> {
        cite!("Alpha-T");
        let t = DomainError::positive("temperature", temperature)?;
        let [low, high] = self.viscosity.ends();
        let rule = "is outside the temperatures where the viscosity law of the oil holds";
        DomainError::require((low..=high).contains(&t), "temperature", t, "K", rule)?;
        let [log, slope] = self.viscosity.at(t);
        Ok(FilmOilState {
            viscosity: DynamicViscosity::from_si(log.exp()),
            pressure_viscosity: PressureViscosity::from_si(self.film_factor * self.alpha(log)),
            temperature_coefficient: PerKelvin::from_si(-slope),
            conductivity: self.constants.conductivity,
        })
    }

    #[inline(always)]
    fn alpha(&self, log_viscosity: f64) -> f64 {
        let t = self.constants.gold_exponent;
        self.alpha_reference * exp(t * (log_viscosity - self.log_reference))
    }

    /// The point of a film at a pressure \[Pa\], a sliding speed \[m/s\] and a film thickness \[m\].
    ///
    /// The mean temperature of the film rises above the walls by τ V_s h/(12 k(p)):
    ///
    /// ```text
    /// k(p) = k (1 + c₁ p/(1 + c₂ p)), p in GPa                            [Larsson-Andersson]
    /// ```
    #[must_use]
    pub fn film_point(&self, pressure: f64, sliding: f64, film: f64) -> FilmPoint {
        FilmPoint {
            pressure,
            roelands_growth: match self.pressure {
                PressureLaw::Barus => 0.0,
                PressureLaw::Roelands => {
                    let factor = self.constants.pressure_viscosity_factor;
                    roelands_growth(self.roelands_exponent * factor, pressure)
                }
            },
            log_rate: (sliding / film).ln(),
            heating: FILM_MEAN * sliding * film / self.conductivity(pressure),
        }
    }

    /// Conductivity of the film k(p) \[W/(m K)\] at a pressure \[Pa\], according to \[Larsson-Andersson\].
    #[must_use]
    pub fn conductivity(&self, pressure: f64) -> f64 {
        let c = &self.constants;
        let giga = pressure * 1e-9;
        let rise = c.conductivity_rise * giga / (1.0 + c.conductivity_bend * giga);
        c.conductivity.si() * (1.0 + rise)
    }

    /// ln η(p, T) under Barus' law with f times the pressure-viscosity coefficient, and its slope over temperature, from ln η₀ and its slope.
    ///
    /// ```text
    /// η = η₀(T) exp(f α(T) p)
    /// ```
    ///
    /// α(T) falls with η₀(T) by Gold's formula; f α p is held below its largest.
    #[inline(always)]
    fn barus(&self, [log, slope]: [f64; 2], pressure: f64) -> [f64; 2] {
        let t = self.constants.gold_exponent;
        let exponent = self.constants.pressure_viscosity_factor * self.alpha(log) * pressure;
        let is_held = exponent >= LARGEST_BARUS_EXPONENT;
        let steepness = if is_held { 1.0 } else { 1.0 + t * exponent };
        let held = exponent.min(LARGEST_BARUS_EXPONENT);
        [log + held, slope * steepness]
    }

    /// The same under Roelands' law, by the growth of its exponent.
    #[inline(always)]
    fn roelands([log, slope]: [f64; 2], growth: f64) -> [f64; 2] {
        let rise = (log + ROELANDS_LOG) * growth;
        let is_held = rise >= LARGEST_ROELANDS;
        let steepness = if is_held { 1.0 } else { 1.0 + growth };
        [log + rise.min(LARGEST_ROELANDS), slope * steepness]
    }

    /// Eyring's τ_E and its slope over temperature, from ln(η γ̇) and its slope.
    ///
    /// ```text
    /// τ_E = τ₀ arsinh(η γ̇/τ₀)
    /// ```
    #[inline(always)]
    fn eyring(&self, newton: f64, slope: f64) -> [f64; 2] {
        let tau_0 = self.constants.eyring_stress.si();
        let ratio = newton - self.log_eyring_stress;
        // Beyond it the hyperbolic sine is its exponential, whose square would overflow.
        let held = ratio.min(STEEP);
        let x = exp(held);
        let root = (1.0 + x * x).sqrt();
        [
            tau_0 * (arsinh(x, root) + (ratio - held)),
            tau_0 * slope * x / root,
        ]
    }

    /// τ_E and its slope over temperature, from logarithms: η under pressure overflows before its logarithm does.
    fn unlimited(&self, [log, slope]: [f64; 2], log_rate: f64) -> [f64; 2] {
        let newton = log + log_rate;
        match self.shear {
            ShearLawName::Newton => {
                let stress = newton.exp();
                [stress, stress * slope]
            }
            ShearLawName::Eyring => self.eyring(newton, slope),
            ShearLawName::Carreau => {
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

    /// τ and dτ/dT at a mean temperature of the film.
    ///
    /// τ = τ_E (1 + (τ_E/τ_L)^m)^(−1/m)                                     `[Limiting-shear]`
    fn stress(&self, point: &FilmPoint, temperature: f64) -> [f64; 2] {
        let at_ambient = self.viscosity.at(temperature);
        let log = match self.pressure {
            PressureLaw::Barus => self.barus(at_ambient, point.pressure),
            PressureLaw::Roelands => Self::roelands(at_ambient, point.roelands_growth),
        };
        let free = self.unlimited(log, point.log_rate);
        let limit = self.limit(point.pressure, temperature);
        limited_stress_by(self.constants.limit_power, free, limit)
    }

    /// The limiting stress and its slope over temperature.
    ///
    /// ```text
    /// τ_L = τ_L0 + Λ exp(−b_L (T − 363.15)) p
    /// ```
    #[inline(always)]
    fn limit(&self, pressure: f64, temperature: f64) -> [f64; 2] {
        let c = &self.constants;
        let proportional = c.limiting_shear_near(temperature) * pressure;
        let fall = c.limiting_shear_fall.si();
        [c.ambient_limit.si() + proportional, -fall * proportional]
    }

    /// τ_L at a mean temperature of the film \[Pa\].
    #[must_use]
    pub fn limiting_stress(&self, point: &FilmPoint, temperature: f64) -> f64 {
        self.limit(point.pressure, temperature)[0]
    }

    /// Shear stress of a film with its own heat, between walls of a given temperature.
    ///
    /// ```text
    /// τ = Law(p, T_s + (1/12) τ V_s h/k(p), V_s/h)                            [Film-heat]
    /// ```
    ///
    /// The law falls with temperature, or rises by less than the heat that it takes, so there is one root.
    ///
    /// # Errors
    /// When pressure, film or temperature is not positive, the sliding speed not finite.
    ///
    /// ```
    /// # use asperity_oil::{BaseOil, FilmRheology, LubricantInput};
    /// # let oil = LubricantInput {
    /// #     oil: Some("m100".into()), base_oil: Some(BaseOil::Mineral), ..LubricantInput::default()
    /// # }.resolve("90 °C".parse()?)?;
    /// let rheology = FilmRheology::new(&oil, BaseOil::Mineral)?;
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
    ) -> Result<Solved, LubricantError> {
        self.shear_stress_from(pressure, sliding, film, wall_temperature, None)
    }

    /// [`shear_stress`](Self::shear_stress) at a pressure, a sliding speed and a film thickness, with a guess of it as in
    /// [`heated_stress`](Self::heated_stress).
    ///
    /// # Errors
    /// As [`shear_stress`](Self::shear_stress).
    pub fn shear_stress_from(
        &self,
        pressure: Pressure,
        sliding: Speed,
        film: Length,
        wall_temperature: Temperature,
        start: Option<f64>,
    ) -> Result<Solved, LubricantError> {
        cite!("Limiting-shear");
        cite!("Larsson-Andersson");
        let p = DomainError::positive("pressure", pressure)?;
        let t = DomainError::positive("temperature of the walls", wall_temperature)?;
        let v = DomainError::finite(Speed::NAME, sliding)?.abs();
        let h = DomainError::positive("film", film)?;
        Ok(self.heated_stress(&self.film_point(p, v, h), t, start)?.0)
    }

    /// τ with its own heat between walls at a temperature \[K\], and its slope over this temperature.
    ///
    /// `start` is a guess of τ, such as the stress at a temperature nearby.
    ///
    /// # Errors
    /// When the iteration does not converge, which no finite input causes.
    pub fn heated_stress(
        &self,
        point: &FilmPoint,
        wall_temperature: f64,
        start: Option<f64>,
    ) -> Result<(Solved, f64), LubricantError> {
        if point.log_rate == f64::NEG_INFINITY {
            let rest = Solved {
                value: 0.0,
                residual: 0.0,
                iterations: 0,
            };
            return Ok((rest, 0.0));
        }
        if point.heating == 0.0 {
            let [value, slope] = self.stress(point, wall_temperature);
            let isothermal = Solved {
                value,
                residual: 0.0,
                iterations: 1,
            };
            return Ok((isothermal, slope));
        }
        cite!("Film-heat");
        let mut slope = 0.0;
        let mut root = |highest: f64, start: f64| {
            let excess = |tau: f64| {
                let at = wall_temperature + point.heating * tau;
                let [law, falls] = self.stress(point, at);
                slope = falls;
                (tau - law, 1.0 - point.heating * falls)
            };
            newton_root(excess, [0.0, highest], start, STRESS_TOLERANCE)
        };
        let near = start.filter(|tau| *tau > 0.0);
        let near = near.and_then(|tau| root(START_REACH * tau, tau).ok());
        let solved = near.map_or_else(
            || {
                let cold = self.stress(point, wall_temperature);
                let highest = self.highest_over_cold() * cold[0];
                // One Newton step from the unheated stress.
                root(highest, cold[0] / (1.0 - point.heating * cold[1]))
            },
            Ok,
        );
        let solved = solved.map_err(LubricantError::heated_stress)?;
        Ok((solved, slope / (1.0 - point.heating * slope)))
    }

    /// Highest stress over the unheated one: where the limit rises with the temperature, the stress may rise above that, even if it
    /// falls at first.
    fn highest_over_cold(&self) -> f64 {
        if self.constants.limiting_shear_fall.si() < 0.0 {
            2.0
        } else {
            ROUNDED
        }
    }

    /// [`heated_stress`](Self::heated_stress) of up to [`LANES`] points with their starts, and the slopes: in lanes of one vector where
    /// the law is Eyring's, otherwise each by itself.
    ///
    /// # Errors
    /// As [`heated_stress`](Self::heated_stress).
    fn heated_stresses(
        &self,
        points: impl Iterator<Item = (FilmPoint, Option<f64>)>,
        wall_temperature: f64,
    ) -> Result<[[f64; 2]; LANES], LubricantError> {
        let mut lanes = RheologyLanes::default();
        let mut each = [(FilmPoint::REST, None); LANES];
        let mut count = 0;
        for (place, point) in each.iter_mut().zip(points) {
            *place = point;
            count += 1;
        }
        let is_sheared = |(point, _): &(FilmPoint, Option<f64>)| {
            point.log_rate > f64::NEG_INFINITY && point.heating > 0.0
        };
        if self.shear == ShearLawName::Eyring && count > 0 && each[..count].iter().all(is_sheared) {
            cite!("Film-heat");
            lanes.count = count.next_multiple_of(VECTOR_WIDTH);
            for k in 0..lanes.count {
                // The first point fills the lanes that are left.
                let (point, start) = each[if k < count { k } else { 0 }];
                lanes.pressure[k] = point.pressure;
                lanes.growth[k] = point.roelands_growth;
                lanes.log_rate[k] = point.log_rate;
                lanes.heating[k] = point.heating;
                lanes.start[k] = start.unwrap_or(0.0);
            }
            let found = self.together(&lanes, wall_temperature).or_else(|| {
                // A start was too far off.
                lanes.start = [0.0; LANES];
                self.together(&lanes, wall_temperature)
            });
            if let Some(found) = found {
                return Ok(found);
            }
        }
        let mut found = [[0.0; 2]; LANES];
        for (found, (point, start)) in found.iter_mut().zip(&each[..count]) {
            let (stress, slope) = self.heated_stress(point, wall_temperature, *start)?;
            *found = [stress.value, slope];
        }
        Ok(found)
    }

    /// Solves the stresses of `points` between walls at a temperature \[K\] with their own heat, [`LANES`] at a time.
    ///
    /// # Errors
    /// As [`heated_stress`](Self::heated_stress).
    pub fn shear<'a>(
        &self,
        points: impl Iterator<Item = &'a mut ShearedPoint>,
        wall_temperature: f64,
    ) -> Result<(), LubricantError> {
        let mut points = points.fuse();
        loop {
            let mut together: [Option<&mut ShearedPoint>; LANES] =
                std::array::from_fn(|_| points.next());
            if together[0].is_none() {
                return Ok(());
            }
            let of_each = together.iter().flatten().map(|at| (at.point, at.start));
            let found = self.heated_stresses(of_each, wall_temperature)?;
            for (at, stress) in together.iter_mut().flatten().zip(found) {
                at.stress = stress;
            }
        }
    }

    /// Stresses and slopes of all lanes; `None` where one leaves its bracket, which bisection would not.
    fn together(&self, lanes: &RheologyLanes, wall: f64) -> Option<[[f64; 2]; LANES]> {
        vectorised(
            #[inline(always)]
            || match self.pressure {
                PressureLaw::Barus => {
                    let log = |at_ambient, pressure, _| self.barus(at_ambient, pressure);
                    self.newton(lanes, wall, log)
                }
                PressureLaw::Roelands => {
                    let log = |at_ambient, _, growth| Self::roelands(at_ambient, growth);
                    self.newton(lanes, wall, log)
                }
            },
        )
    }

    /// Newton's method until the last lane has converged.
    ///
    /// The loops go to a number that the compiler does not know: loops of a known few passes are unrolled before they can be
    /// compiled to vectors.
    #[inline(always)]
    fn newton(
        &self,
        lanes: &RheologyLanes,
        wall: f64,
        log: impl Fn([f64; 2], f64, f64) -> [f64; 2] + Copy,
    ) -> Option<[[f64; 2]; LANES]> {
        let count = lanes.count.min(LANES);
        let mut tau = lanes.start;
        let mut highest = [0.0; LANES];
        for k in 0..count {
            highest[k] = START_REACH * tau[k];
        }
        if lanes.start[..count].iter().any(|start| *start <= 0.0) {
            // One Newton step from the unheated stress.
            let most = self.highest_over_cold();
            let (cold, slope) = self.stresses(lanes, &[wall; LANES], log);
            for k in 0..count {
                let is_new = lanes.start[k] <= 0.0;
                let first = cold[k] / (1.0 - lanes.heating[k] * slope[k]);
                tau[k] = if is_new { first } else { tau[k] };
                highest[k] = if is_new { most * cold[k] } else { highest[k] };
            }
        }
        for _ in 0..STEPS_TOGETHER {
            let mut temperature = [0.0; LANES];
            for k in 0..count {
                temperature[k] = wall + lanes.heating[k] * tau[k];
            }
            let (law, falls) = self.stresses(lanes, &temperature, log);
            let (mut is_outside, mut is_far) = (0_u64, 0_u64);
            let mut slope = [0.0; LANES];
            for k in 0..count {
                let steepness = 1.0 - lanes.heating[k] * falls[k];
                let step = (tau[k] - law[k]) / steepness;
                let next = tau[k] - step;
                is_outside |= u64::from(!(next > 0.0 && next <= highest[k]));
                is_far |= u64::from(step.abs() > STRESS_TOLERANCE * next);
                tau[k] = next;
                slope[k] = falls[k] / steepness;
            }
            if is_outside != 0 {
                return None;
            }
            if is_far == 0 {
                return Some(std::array::from_fn(|k| [tau[k], slope[k]]));
            }
        }
        None
    }

    /// τ and dτ/dT of all lanes, of Eyring's law. Only the table of η₀ is read lane by lane.
    #[inline(always)]
    fn stresses(
        &self,
        lanes: &RheologyLanes,
        temperature: &[f64; LANES],
        log_viscosity: impl Fn([f64; 2], f64, f64) -> [f64; 2] + Copy,
    ) -> ([f64; LANES], [f64; LANES]) {
        match self.constants.limit_power {
            // A constant power is compiled without a logarithm.
            LIMIT_POWER => self.limited_by(LIMIT_POWER, lanes, temperature, log_viscosity),
            power => self.limited_by(power, lanes, temperature, log_viscosity),
        }
    }

    /// [`stresses`](Self::stresses) with a power of the limit.
    #[inline(always)]
    fn limited_by(
        &self,
        power: f64,
        lanes: &RheologyLanes,
        temperature: &[f64; LANES],
        log_viscosity: impl Fn([f64; 2], f64, f64) -> [f64; 2],
    ) -> ([f64; LANES], [f64; LANES]) {
        let count = lanes.count.min(LANES);
        let (mut log, mut slope) = ([0.0; LANES], [0.0; LANES]);
        for k in 0..count {
            [log[k], slope[k]] = self.viscosity.at(temperature[k]);
        }
        let (mut stress, mut by_temperature) = ([0.0; LANES], [0.0; LANES]);
        for k in 0..count {
            let at_ambient = [log[k], slope[k]];
            let [log, slope] = log_viscosity(at_ambient, lanes.pressure[k], lanes.growth[k]);
            let free = self.eyring(log + lanes.log_rate[k], slope);
            let limit = self.limit(lanes.pressure[k], temperature[k]);
            [stress[k], by_temperature[k]] = limited_stress_by(power, free, limit);
        }
        (stress, by_temperature)
    }
}

/// Points that are sheared together, a quantity an array.
#[derive(Default)]
struct RheologyLanes {
    /// Lanes in use.
    count: usize,
    pressure: [f64; LANES],
    growth: [f64; LANES],
    log_rate: [f64; LANES],
    heating: [f64; LANES],
    /// 0 where none is known.
    start: [f64; LANES],
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_limit_that_rises_with_temperature_has_a_heated_stress() {
        let oil = crate::LubricantInput {
            oil: Some("e-fluid-70w75w".to_owned()),
            ..crate::LubricantInput::default()
        };
        let oil = oil.resolve(GOLD_TEMPERATURE).unwrap();
        let rheology = FilmRheology::new(&oil, BaseOil::Pao).unwrap();
        for fall in [-0.016, -0.003, -6e-4, -1e-5] {
            let constants = TractionConstants {
                limiting_shear_fall: PerKelvin::from_si(fall),
                ..*rheology.constants()
            };
            let rising = rheology.clone().with_constants(constants).unwrap();
            for k in 1..40_000 {
                let part = |digit: f64| (f64::from(k) * digit).fract();
                let (film, sliding) = (
                    2e-9 * 100f64.powf(part(0.618_034)),
                    0.1 + 12.0 * part(0.569_84),
                );
                let warm = 330.0 + 170.0 * part(0.754_878);
                let point = rising.film_point(5e9 * part(0.819_173), sliding, film);
                let (found, _) = rising.heated_stress(&point, warm, None).unwrap();
                let at = warm + point.heating() * found.value;
                let [law, _] = rising.stress(&point, at);
                assert!((found.value / law - 1.0).abs() < 1e-9, "{fall} {k}");
            }
        }
    }

    #[test]
    fn points_sheared_together_have_the_stresses_of_each() {
        let oil = crate::LubricantInput {
            oil: Some("m100".to_owned()),
            ..crate::LubricantInput::default()
        };
        let oil = oil.resolve(GOLD_TEMPERATURE).unwrap();
        let oil = FilmRheology::new(&oil, BaseOil::Mineral).unwrap();
        let of = |fall: f64, power: f64| TractionConstants {
            limiting_shear_fall: PerKelvin::from_si(fall),
            limit_power: power,
            ..*oil.constants()
        };
        let default = oil.constants().limit_power;
        for (constants, shear, pressure) in [
            (of(0.0, default), ShearLawName::Eyring, PressureLaw::Barus),
            (
                of(2e-3, default),
                ShearLawName::Eyring,
                PressureLaw::Roelands,
            ),
            (of(-2e-3, default), ShearLawName::Eyring, PressureLaw::Barus),
            (of(0.0, 2.5), ShearLawName::Eyring, PressureLaw::Barus),
            (
                of(0.0, default),
                ShearLawName::Carreau,
                PressureLaw::Roelands,
            ),
        ] {
            let oil = oil.clone().with_constants(constants).unwrap();
            let oil = oil.with_laws(shear, pressure);
            for k in 0..4000 {
                let part = |digit: f64, i: usize| (f64::from(k) * digit + 0.37 * i as f64).fract();
                let wall = 330.0 + 120.0 * part(0.754_878, 0);
                let points: Vec<_> = (0..1 + k as usize % LANES)
                    .map(|i| {
                        let film = 1e-9 * 1000f64.powf(part(0.618_034, i));
                        let sliding = if k % 50 == 7 {
                            0.0
                        } else {
                            12.0 * part(0.569_84, i)
                        };
                        let point = oil.film_point(4e9 * part(0.819_173, i), sliding, film);
                        let (alone, _) = oil.heated_stress(&point, wall, None).unwrap();
                        // A near start, a far one, or none.
                        let start = match (k as usize + i) % 3 {
                            0 => None,
                            1 => Some(1.01 * alone.value),
                            _ => Some(0.3 * alone.value),
                        };
                        (point, start)
                    })
                    .collect();
                let found = oil.heated_stresses(points.iter().copied(), wall).unwrap();
                for ((point, start), [stress, slope]) in points.iter().zip(found) {
                    let (alone, of_alone) = oil.heated_stress(point, wall, *start).unwrap();
                    let near =
                        |a: f64, b: f64, tolerance: f64| (a - b).abs() <= tolerance * b.abs();
                    assert!(
                        near(stress, alone.value, 1e-11),
                        "{shear:?} {k}: {stress} {alone:?}"
                    );
                    assert!(
                        near(slope, of_alone, 1e-4),
                        "{shear:?} {k}: {slope} {of_alone}"
                    );
                }
            }
        }
    }
}
