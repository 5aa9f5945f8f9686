//! Residuals of traction curves: measurements and priors of constants and nuisance terms.
//!
//! ```text
//! r = (g μ(θ, h e^δh, k e^δk, r, T + δT) + z − μ_measured)/σ                     [Traction-residual]
//! ```
//!
//! | symbol | meaning | prior standard deviation |
//! |---|---|---|
//! | θ | ln τ₀, ln Λ, b_L, ln f, and ln τ_L0 (0.5) and the logarithm of the power of the limit (0.3), which the points do not determine | of the family |
//! | g | gain of load and force calibration, of each group | 0.02 about 1 |
//! | z | zero of each curve, or of all | 0.0005, 0.0002 with both signs |
//! | δh | logarithm of the film | 0.05 |
//! | δk | logarithm of the conductivity of the specimens | 0.2 |
//! | r | rise of the specimens above the bath per watt | 0.5 K/W about 0.5 K/W, at least 0 |
//! | δT | error of the temperature, of each set temperature | 1 K |
//!
//! Variables are in standard deviations of their priors, from their medians. The gain is known to 2 % of a calibrated
//! machine; a public file of 2.3 hours shows zeros that wander by 0.001 of the friction; one second of readings scatters
//! by less than 1 %, the rest of σ is the error of the law (assumed).

use asperity::mixed_film::LoadShareError;
use asperity::oil::{FilmRheology, PressureLaw, TractionConstants};
use asperity_core::cite;
use asperity_core::quantity::{PerKelvin, Temperature};
use asperity_core::task::try_par_map;
use nalgebra::{DMatrix, DVector};

use super::base::OilBase;
use super::machine::{Machine, Setting};
use super::reading::SetPoint;
use crate::least_squares::Residuals;

/// Number of constants of the oil among the variables.
pub const CONSTANTS: usize = 6;
/// Number of constants that an oil file states: Eyring stress, limiting shear, its temperature coefficient, factor.
pub const STATED: usize = 4;
/// Keys, names and units of the stated constants.
pub(super) const STATED_CONSTANTS: [(&str, &str, &str); STATED] = [
    ("eyring_stress", "Eyring stress", "MPa"),
    ("limiting_shear", "limiting shear stress over pressure", ""),
    (
        "limiting_shear_temperature",
        "fall of the limiting shear stress",
        "1/K",
    ),
    ("pressure_viscosity_factor", "pressure-viscosity factor", ""),
];
/// Index of the limiting shear stress over pressure.
pub const LIMIT: usize = 1;
/// Index of the temperature coefficient b_L, which is not a logarithm.
pub const FALL: usize = 2;
/// Index of the factor f among the constants.
pub const FACTOR: usize = 3;
/// Step of a derivative, in standard deviations of the prior.
const STEP: f64 = 1e-3;
/// Least rise of the specimens \[K/W\].
const LEAST_RISE: f64 = 1e-6;

/// Zeros of the friction.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default, serde::Deserialize, schemars::JsonSchema)]
#[cfg_attr(feature = "clap", derive(clap::ValueEnum))]
#[serde(rename_all = "kebab-case")]
pub enum Zero {
    /// One for each curve.
    #[default]
    Curve,
    /// One for all curves.
    Common,
    /// None.
    None,
}

/// Standard deviations of the priors.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Priors {
    /// Of the constants: ln τ₀, ln Λ, b_L \[1/K\], ln f, ln τ_L0, logarithm of the power of the limit.
    pub constants: [f64; CONSTANTS],
}

impl Priors {
    /// Priors of the family of an oil.
    #[must_use]
    pub const fn family([stress, limit, alpha]: [f64; 3]) -> Self {
        Self {
            constants: [stress, limit, 0.002, alpha, 0.5, 0.3],
        }
    }

    /// Priors of an oil, of its family or wide.
    #[must_use]
    pub const fn new(oil: &OilBase, is_wide: bool) -> Self {
        if is_wide {
            Self::wide()
        } else {
            Self::family(oil.deviations)
        }
    }

    /// Priors that leave the constants to the points.
    #[must_use]
    pub const fn wide() -> Self {
        Self {
            constants: [1.5, 1.0, 0.01, 0.5, 0.5, 0.3],
        }
    }
}

/// Kind of a nuisance term.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum Nuisance {
    /// Gain of the group with this index.
    Gain(usize),
    /// Zero of the curve with this index; `None` of all.
    Zero(Option<usize>),
    /// Logarithm of the film.
    Film,
    /// Logarithm of the conductivity of the specimens.
    Conductivity,
    /// Rise of the specimens.
    Rise,
    /// Temperature of the set temperature with this index.
    Temperature(usize),
}

/// A nuisance term with its prior.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Term {
    /// Its kind.
    pub kind: Nuisance,
    /// Standard deviation of its prior.
    pub deviation: f64,
}

/// Measured point.
#[derive(Debug, Clone, PartialEq)]
pub struct Point {
    /// Machine.
    pub machine: Machine,
    /// Setting.
    pub setting: Setting,
    /// Measured film, which replaces the computed one.
    pub film: Option<asperity_core::quantity::Length>,
    /// Measured friction.
    pub traction: f64,
    /// Its standard deviation.
    pub sigma: f64,
    /// Index of its group.
    pub group: usize,
    /// Index of its curve.
    pub curve: usize,
    /// Index of its set temperature.
    pub temperature: usize,
}

/// The least squares problem of traction curves.
#[derive(Debug, Clone)]
pub struct TractionProblem<'a> {
    /// The oil.
    pub oil: &'a OilBase,
    /// Law of pressure.
    pub law: PressureLaw,
    /// Priors of the constants.
    pub priors: Priors,
    /// Nuisance terms, the variables after the constants.
    pub terms: Vec<Term>,
    /// The points.
    pub points: Vec<Point>,
}

/// Distinct values, in order.
pub fn distinct<T: PartialOrd + Clone>(values: impl Iterator<Item = T>) -> Vec<T> {
    let mut all: Vec<T> = values.collect();
    all.sort_by(|a, b| a.partial_cmp(b).unwrap_or(std::cmp::Ordering::Equal));
    all.dedup_by(|a, b| a == b);
    all
}

impl<'a> TractionProblem<'a> {
    /// The problem of set points, with standard deviations still to be set.
    #[must_use]
    pub fn new(
        oil: &'a OilBase,
        law: PressureLaw,
        priors: Priors,
        zero: Zero,
        set_points: &[SetPoint],
    ) -> Self {
        let readings = || set_points.iter().map(|point| &point.reading);
        let groups = distinct(readings().map(|one| one.group.clone()));
        let temperatures = distinct(readings().map(|one| one.set_temperature_c));
        let curves = distinct(set_points.iter().map(|point| point.curve));
        let index = |all: &[usize], value: usize| all.iter().position(|one| *one == value);
        let point = |at: &SetPoint| {
            let reading = &at.reading;
            Point {
                machine: reading.machine,
                setting: reading.setting,
                film: reading.film,
                traction: reading.traction,
                sigma: reading.sigma.unwrap_or(1.0),
                group: groups
                    .iter()
                    .position(|one| *one == reading.group)
                    .unwrap_or(0),
                curve: index(&curves, at.curve).unwrap_or(0),
                temperature: temperatures
                    .iter()
                    .position(|one| *one == reading.set_temperature_c)
                    .unwrap_or(0),
            }
        };
        let term = |kind, deviation| Term { kind, deviation };
        let mut terms: Vec<Term> = Vec::new();
        terms.extend((0..groups.len()).map(|group| term(Nuisance::Gain(group), 0.02)));
        let one_sign = |curve: usize| {
            let of_curve = set_points.iter().filter(|point| point.curve == curve);
            of_curve.clone().any(|point| !point.has_both_signs)
        };
        match zero {
            Zero::Curve => terms.extend(curves.iter().enumerate().map(|(k, curve)| {
                let deviation = if one_sign(*curve) { 5e-4 } else { 2e-4 };
                term(Nuisance::Zero(Some(k)), deviation)
            })),
            Zero::Common => terms.push(term(Nuisance::Zero(None), 5e-4)),
            Zero::None => {}
        }
        terms.push(term(Nuisance::Film, 0.05));
        terms.push(term(Nuisance::Conductivity, 0.2));
        terms.push(term(Nuisance::Rise, 0.5));
        terms.extend((0..temperatures.len()).map(|k| term(Nuisance::Temperature(k), 1.0)));
        Self {
            oil,
            law,
            priors,
            terms,
            points: set_points.iter().map(point).collect(),
        }
    }

    /// Number of variables.
    #[must_use]
    pub fn variables(&self) -> usize {
        CONSTANTS + self.terms.len()
    }

    /// Deviation of a nuisance term from its median at `x`; 0 for a term that the problem does not have.
    fn value(&self, x: &DVector<f64>, kind: Nuisance) -> f64 {
        let k = self.terms.iter().position(|term| term.kind == kind);
        k.map_or(0.0, |k| self.terms[k].deviation * x[CONSTANTS + k])
    }

    /// The oil at the variables `x`.
    ///
    /// # Errors
    /// When a constant leaves its domain.
    pub fn rheology(&self, x: &DVector<f64>) -> Result<FilmRheology, LoadShareError> {
        let own = *self.oil.rheology.constants();
        let moved = |k: usize| self.priors.constants[k] * x[k];
        let constants = TractionConstants {
            eyring_stress: own.eyring_stress * moved(0).exp(),
            limiting_shear: own.limiting_shear * moved(1).exp(),
            limiting_shear_fall: PerKelvin::from_si(own.limiting_shear_fall.si() + moved(2)),
            pressure_viscosity_factor: own.pressure_viscosity_factor * moved(FACTOR).exp(),
            ambient_limit: own.ambient_limit * moved(4).exp(),
            limit_power: own.limit_power * moved(5).exp(),
            ..own
        };
        let rheology = self.oil.rheology.clone().with_constants(constants)?;
        let shear = rheology.laws().0;
        Ok(rheology.with_laws(shear, self.law))
    }

    /// Friction of the film at each point, before gain and zero.
    fn film_friction(&self, x: &DVector<f64>) -> Result<Vec<f64>, LoadShareError> {
        cite!("Traction-residual");
        let rheology = self.rheology(x)?;
        let film = self.value(x, Nuisance::Film).exp();
        let conductivity = self.value(x, Nuisance::Conductivity).exp();
        let rise = self.value(x, Nuisance::Rise);
        let of = |point: &Point| {
            let mut machine = point.machine;
            machine.material.conductivity = machine.material.conductivity * conductivity;
            machine.bulk_rise = (machine.bulk_rise + rise).max(LEAST_RISE);
            let warmer = self.value(x, Nuisance::Temperature(point.temperature));
            let setting = Setting {
                temperature: Temperature::from_si(point.setting.temperature.si() + warmer),
                ..point.setting
            };
            let found = machine.predict_with(&rheology, &setting, point.film, film)?;
            Ok(found.friction.coefficient)
        };
        try_par_map(&self.points, of)
    }

    /// Measured friction expected at each point.
    ///
    /// # Errors
    /// When a constant leaves its domain.
    pub fn predicted(&self, x: &DVector<f64>) -> Result<Vec<f64>, LoadShareError> {
        let film = self.film_friction(x)?;
        let measured = |(point, film): (&Point, f64)| self.measured(x, point, film);
        Ok(self.points.iter().zip(film).map(measured).collect())
    }

    /// Friction with gain and zero.
    fn measured(&self, x: &DVector<f64>, point: &Point, film: f64) -> f64 {
        let zero =
            self.value(x, Nuisance::Zero(Some(point.curve))) + self.value(x, Nuisance::Zero(None));
        (1.0 + self.value(x, Nuisance::Gain(point.group))) * film + zero
    }

    fn residuals_and_slopes(
        &self,
        x: &DVector<f64>,
    ) -> Result<(DVector<f64>, DMatrix<f64>), LoadShareError> {
        let (points, variables) = (self.points.len(), self.variables());
        let film = self.film_friction(x)?;
        let mut residuals = DVector::zeros(points + variables);
        let mut slopes = DMatrix::zeros(points + variables, variables);
        for (k, point) in self.points.iter().enumerate() {
            residuals[k] = (self.measured(x, point, film[k]) - point.traction) / point.sigma;
        }
        for k in 0..variables {
            residuals[points + k] = x[k];
            slopes[(points + k, k)] = 1.0;
        }
        let gain = |point: &Point| 1.0 + self.value(x, Nuisance::Gain(point.group));
        let by_film = |moved: &[f64], k: usize| {
            let point = &self.points[k];
            gain(point) * (moved[k] - film[k]) / (STEP * point.sigma)
        };
        let stepped = |columns: &[usize]| {
            let mut moved = x.clone();
            for column in columns {
                moved[*column] += STEP;
            }
            self.film_friction(&moved)
        };
        let mut of_temperature = Vec::new();
        let mut of_film: Vec<usize> = (0..CONSTANTS).collect();
        for (k, term) in self.terms.iter().enumerate() {
            let column = CONSTANTS + k;
            for (row, point) in self.points.iter().enumerate() {
                let slope = match term.kind {
                    Nuisance::Gain(group) if group == point.group => film[row],
                    Nuisance::Zero(curve) if curve.is_none_or(|one| one == point.curve) => 1.0,
                    _ => continue,
                };
                slopes[(row, column)] = slope * term.deviation / point.sigma;
            }
            match term.kind {
                Nuisance::Temperature(number) => of_temperature.push((number, column)),
                Nuisance::Film | Nuisance::Conductivity | Nuisance::Rise => of_film.push(column),
                Nuisance::Gain(_) | Nuisance::Zero(_) => {}
            }
        }
        for column in of_film {
            let moved = stepped(&[column])?;
            for row in 0..points {
                slopes[(row, column)] = by_film(&moved, row);
            }
        }
        // A point has one temperature: all are moved at once.
        let columns: Vec<usize> = of_temperature.iter().map(|(_, column)| *column).collect();
        let moved = stepped(&columns)?;
        for (row, point) in self.points.iter().enumerate() {
            let column = of_temperature
                .iter()
                .find(|(number, _)| *number == point.temperature);
            if let Some((_, column)) = column {
                slopes[(row, *column)] = by_film(&moved, row);
            }
        }
        Ok((residuals, slopes))
    }
}

impl Residuals for TractionProblem<'_> {
    fn at(&self, x: &DVector<f64>) -> (DVector<f64>, DMatrix<f64>) {
        self.residuals_and_slopes(x).unwrap_or_else(|_| {
            // Outside of the domain of the constants: the step is refused.
            let (rows, columns) = (self.points.len() + self.variables(), self.variables());
            (
                DVector::from_element(rows, f64::MAX.sqrt() / rows as f64),
                DMatrix::identity(rows, columns),
            )
        })
    }
}
