//! Oil constants from traction curves: selection, fit by both laws of pressure, decision, refusals and warnings.

use super::error as oil_error;
use asperity_core::{Code, Estimate, EstimateKeys, Fault, PROGRAM, estimate_keys};
use std::fmt::Write as _;

use asperity::case::{DECISIVE, POORLY_EXPLAINED, STEEPEST_FALL, law_error};
use asperity::message::Warning;
use asperity::oil::{LubricantInput, PressureLaw, TractionConstants};
use asperity::result::loss_band::Digits;
use asperity_core::number;
use asperity_core::numerics::{Z_95, Z_975};
use asperity_core::task::try_par_map;
use serde::{Deserialize, Serialize};

use super::base::OilBase;
use super::combination::{Combination, Ranged, combinations};
use super::fit::{LawFit, PointErrors, expected, fit_law};
use super::helpful::{Helpful, helpful};
use super::problem::{CONSTANTS, FACTOR, FALL, Nuisance, Priors, STATED, STATED_CONSTANTS, Zero};
use super::reading::{SetPoint, left_out, set_points};
use super::selection::{Dropped, Judged, judge};
use super::text::Readings;
use crate::block::digits;
use crate::information::correlations;

/// Factor on the linearised standard deviations: bands without it hold nine tenths of what they should (simulated fits).
const LINEARISED: f64 = 1.15;
/// Kelvins outside of the tested temperatures in which the constants hold: of one, and of several.
const AROUND_ONE: f64 = 15.0;
const AROUND: f64 = 20.0;
/// Posterior over prior standard deviation above which a constant is not identified.
const NOT_IDENTIFIED: f64 = 0.8;
/// Fewest points of a fit.
const FEWEST: usize = 6;
/// Least Hertz pressure of a fit \[Pa\].
const LEAST_PRESSURE: f64 = 0.4e9;
/// Squares per point above which no law explains the curves.
const UNEXPLAINED: f64 = 3.0;
/// Squares per point below which the stated errors are too large.
const OVERSTATED: f64 = 0.3;
/// Standard deviations of a nuisance term that are worth a warning, and that no calibrated machine has.
const UNUSUAL: f64 = 2.0;
const IMPOSSIBLE: f64 = 3.0;
/// Prior standard deviations of a constant that are worth a warning.
const UNLIKE_FAMILY: f64 = 2.5;
/// Possible Eyring stress \[MPa\], limiting shear stress over pressure and factor.
const POSSIBLE: [(usize, [f64; 2]); 3] =
    [(0, [1.0, 20.0]), (1, [0.01, 0.12]), (FACTOR, [0.4, 1.6])];

/// Settings of a fit.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct FitSettings {
    /// Whether the priors leave the constants to the points.
    pub is_wide: bool,
    /// Zeros of the friction.
    pub zero: Zero,
    /// Errors of points that state none.
    pub errors: PointErrors,
    /// Whether constants of no known oil are accepted.
    pub is_forced: bool,
}

estimate_keys! { Prior: "prior" "prior_range"; }

/// A constant with its band.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
#[non_exhaustive]
pub struct FittedConstant {
    /// Key.
    pub key: String,
    /// Name in words.
    pub name: String,
    /// Unit of the value.
    pub unit: String,
    /// Value with 5 % and 95 % quantile, as printed.
    #[serde(flatten, with = "Ranged")]
    pub fitted: Estimate,
    /// 2.5 % and 97.5 % quantile, as files state them.
    pub band: [f64; 2],
    /// Value of the family with its 5 % and 95 % quantile.
    #[serde(flatten, with = "Prior")]
    pub prior: Estimate,
    /// Posterior over prior standard deviation, expected before the fit.
    pub expected: f64,
    /// The same after the fit.
    pub posterior: f64,
    /// Whether the points determine it.
    pub is_identified: bool,
    /// Setting at which ten more readings would help most, with the error left; for a constant that is not identified.
    pub would_help: Option<String>,
}

/// A nuisance term.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
#[non_exhaustive]
pub struct NuisanceTerm {
    /// Meaning in words.
    pub text: String,
    /// Value in standard deviations of its prior.
    pub deviations: f64,
}

/// A point of the fit.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
#[non_exhaustive]
pub struct TractionPointRow {
    /// File.
    pub file: String,
    /// Line of its first reading.
    pub line: usize,
    /// Curve, from 1.
    pub curve: usize,
    /// Load \[N\].
    pub load_n: f64,
    /// Mean speed \[m/s\].
    pub mean_speed_m_s: f64,
    /// Slide-to-roll ratio \[%\].
    pub slide_roll_percent: f64,
    /// Temperature \[°C\].
    pub temperature_c: f64,
    /// Number of readings.
    pub readings: usize,
    /// Largest Hertz pressure \[GPa\].
    pub pressure_gpa: f64,
    /// Film over roughness.
    pub film_ratio: f64,
    /// Measured friction.
    pub traction: f64,
    /// Whether its film is measured.
    pub has_measured_film: bool,
    /// Fitted friction with gain and zero; `None` if the point is dropped.
    pub fitted: Option<f64>,
    /// Residual in standard deviations.
    pub residual_sigma: Option<f64>,
    /// Rule that drops it.
    pub dropped: Option<Dropped>,
}

/// The fit by the other law of pressure.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
#[non_exhaustive]
pub struct OtherLaw {
    /// The law.
    pub pressure_law: PressureLaw,
    /// Squares of the points over their number.
    pub squares_per_point: f64,
    /// The constants.
    pub constants: Vec<FittedConstant>,
    /// Correlations of the constants.
    pub correlations: Vec<Vec<f64>>,
}

/// Oil constants from traction curves.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
#[non_exhaustive]
pub struct OilFit {
    /// Program and version.
    pub program: String,
    /// Title.
    pub title: String,
    /// Viscosity, density and family of the oil.
    pub lubricant: LubricantInput,
    /// Files with their SHA-256.
    pub sources: Vec<[String; 2]>,
    /// Law of pressure of the fit.
    pub pressure_law: PressureLaw,
    /// Whether the points decide it.
    pub is_law_decided: bool,
    /// Whether they decide it without the prior of the factor.
    pub is_law_decided_by_points: bool,
    /// Sum of squares of this law and of the other one.
    pub total_squared: [f64; 2],
    /// Squares of the points over their number.
    pub squares_per_point: f64,
    /// Standard deviation of the error of the law that a use of the constants adds.
    pub law_error: f64,
    /// Readings, set points and points of the fit.
    pub counts: [usize; 3],
    /// Set temperatures \[°C\] of the points of the fit.
    pub temperatures_c: Vec<f64>,
    /// Largest Hertz pressure \[GPa\] of the fit.
    pub pressure_max_gpa: f64,
    /// The constants.
    pub constants: Vec<FittedConstant>,
    /// Correlations of the constants.
    pub correlations: Vec<Vec<f64>>,
    /// Constants that the points determine only in combination.
    pub combinations: Vec<Combination>,
    /// The other law.
    pub other_law: OtherLaw,
    /// Nuisance terms, largest first.
    pub nuisance: Vec<NuisanceTerm>,
    /// Fitted and dropped points.
    pub points: Vec<TractionPointRow>,
    /// Reasons against the constants, for the oil file and the runs with it.
    #[serde(default, skip_serializing_if = "Vec::is_empty")]
    pub doubts: Vec<String>,
    /// Warnings.
    pub warnings: Vec<Warning>,
}

impl OilFit {
    /// Title of the result for an oil.
    pub(super) fn title_of(oil: &OilBase) -> String {
        format!("Oil constants of {}", oil.name)
    }

    /// Fits the constants of `oil` to readings.
    ///
    /// # Errors
    /// When too few points are kept or their pressure is too low, no law explains them, or the constants are those of no
    /// oil.
    pub fn new(oil: &OilBase, readings: Readings, settings: FitSettings) -> Result<Self, Fault> {
        let Readings { all, sources, .. } = readings;
        let points = set_points(&all);
        let judged = try_par_map(&points, |point| judge(oil, point))?;
        let both = || points.iter().zip(&judged);
        let kept: Vec<SetPoint> = both()
            .filter(|(_, judged)| judged.dropped.is_none())
            .map(|(point, _)| point.clone())
            .collect();
        refuse_points(&points, &judged, kept.len())?;
        let priors = Priors::new(oil, settings.is_wide);
        let FitSettings { zero, errors, .. } = settings;
        let before = expected(oil, priors, zero, errors, &kept)?;
        let laws = [PressureLaw::Barus, PressureLaw::Roelands];
        let mut fits = try_par_map(laws, |law| fit_law(oil, law, priors, zero, errors, &kept))?;
        fits.sort_by(|a, b| a.total_squared.total_cmp(&b.total_squared));
        let [best, other] = [&fits[0], &fits[1]];
        let further = helpful(oil, priors, zero, errors, &kept)?;
        let fitted = constants(best, &before, &further);
        let by_other = constants(other, &before, &further);
        let values: Vec<f64> = fitted.iter().map(|one| one.fitted.value).collect();
        let found = Self {
            program: PROGRAM.to_owned(),
            title: Self::title_of(oil),
            lubricant: oil.lubricant.clone(),
            sources,
            pressure_law: best.problem.law,
            // A law by which the oil has constants of no known oil explains nothing.
            is_law_decided: other.total_squared - best.total_squared >= DECISIVE
                || (impossible(&by_other).is_some() && !settings.is_forced),
            is_law_decided_by_points: other.without_factor_prior() - best.without_factor_prior()
                >= DECISIVE,
            total_squared: [best.total_squared, other.total_squared],
            squares_per_point: best.squares_per_point(),
            law_error: law_error(best.squares_per_point()),
            counts: [all.len(), points.len(), kept.len()],
            temperatures_c: super::problem::distinct(
                kept.iter().map(|point| point.reading.set_temperature_c),
            ),
            pressure_max_gpa: both()
                .filter(|(_, judged)| judged.dropped.is_none())
                .fold(0.0, |most: f64, (_, judged)| {
                    most.max(1e-9 * judged.max_pressure)
                }),
            constants: fitted,
            correlations: stated_correlations(best),
            combinations: combinations(best, &values, LINEARISED),
            other_law: OtherLaw {
                pressure_law: other.problem.law,
                squares_per_point: other.squares_per_point(),
                constants: by_other,
                correlations: stated_correlations(other),
            },
            nuisance: nuisance(best),
            points: rows(&points, &judged, best),
            doubts: Vec::new(),
            warnings: Vec::new(),
        };
        found.refuse(&fits, settings.is_forced)?;
        let doubts = found.doubts_of(best);
        let mut warnings = readings.warnings;
        warnings.extend(found.warnings_of(best, &doubts, left_out(&all)));
        Ok(Self {
            doubts,
            warnings,
            ..found
        })
    }

    /// The fitted point that lies furthest from the fit, in words.
    pub(super) fn largest_deviation(&self) -> Option<String> {
        let fitted = self
            .points
            .iter()
            .filter_map(|row| Some((row, row.fitted?, row.residual_sigma?.abs())));
        let (row, fitted, _) = fitted.max_by(|a, b| a.2.total_cmp(&b.2))?;
        Some(format!(
            "Furthest from the fit: {}:{} ({:.0} °C, {:.2} GPa), measured {:.4}, fitted {fitted:.4}.",
            row.file, row.line, row.temperature_c, row.pressure_gpa, row.traction
        ))
    }

    /// The points with the largest residuals.
    fn worst_points(&self, count: usize) -> String {
        let mut worst: Vec<&TractionPointRow> = self.points.iter().collect();
        let size = |row: &TractionPointRow| row.residual_sigma.map_or(0.0, f64::abs);
        worst.sort_by(|a, b| size(b).total_cmp(&size(a)));
        let worst = worst.iter().take(count).map(|row| {
            let residual = row.residual_sigma.unwrap_or(0.0);
            let slide = (100.0 * row.slide_roll_percent).round() / 100.0;
            format!(
                "{}:{} ({:.0} °C, {:.2} GPa, {slide} %) by {residual:+.1} sigma",
                row.file, row.line, row.temperature_c, row.pressure_gpa
            )
        });
        worst.collect::<Vec<String>>().join(", ")
    }

    fn refuse(&self, fits: &[LawFit<'_>], is_forced: bool) -> Result<(), Fault> {
        if fits.iter().all(|fit| fit.squares_per_point() > UNEXPLAINED) {
            return Err(oil_error::unexplained(
                self.squares_per_point,
                self.worst_points(5),
            ));
        }
        if let Some(term) = self
            .nuisance
            .iter()
            .find(|term| term.deviations.abs() > IMPOSSIBLE)
        {
            return Err(oil_error::nuisance(
                &term.text,
                term.deviations,
                self.worst_points(5),
            ));
        }
        let fall = self.constants.get(FALL);
        let is_steep = |end: &f64| end.abs() > STEEPEST_FALL;
        if let Some(fall) = fall.filter(|fall| fall.band.iter().any(is_steep)) {
            return Err(oil_error::too_steep(fall.band));
        }
        match impossible(&self.constants) {
            Some((constant, [low, high])) if !is_forced => Err(oil_error::no_oil(
                &constant.name,
                constant.fitted.value,
                &constant.unit,
                low,
                high,
            )),
            _ => Ok(()),
        }
    }

    /// What speaks against the constants: a machine far out of calibration, an oil far from its family, a constant of no known
    /// oil.
    fn doubts_of(&self, best: &LawFit<'_>) -> Vec<String> {
        let is_unusual = |term: &&NuisanceTerm| term.deviations.abs() > UNUSUAL;
        let unusual = self.nuisance.iter().filter(is_unusual);
        let mut texts: Vec<String> = unusual
            .map(|term| format!("{}: {:.1} standard deviations", term.text, term.deviations))
            .collect();
        if let Some((constant, [low, high])) = impossible(&self.constants) {
            let FittedConstant {
                name, fitted, unit, ..
            } = constant;
            let (value, low, high) = (digits(fitted.value), number(low), number(high));
            texts.push(format!(
                "{name} = {value} {unit}: that of no known oil, {low} to {high}"
            ));
        }
        let family = Priors::new(best.problem.oil, false);
        for k in [0, FACTOR] {
            let shift = best.x[k] * best.problem.priors.constants[k];
            let deviations = shift / family.constants[k];
            if deviations.abs() > UNLIKE_FAMILY {
                texts.push(format!(
                    "{} lies {deviations:+.1} standard deviations from the family of the base oil",
                    self.constants[k].name
                ));
            }
        }
        texts
    }

    fn warnings_of(
        &self,
        best: &LawFit<'_>,
        doubts: &[String],
        left_out: Option<String>,
    ) -> Vec<Warning> {
        let mut texts = doubts.to_vec();
        texts.extend(left_out);
        let far = match self.temperatures_c[..] {
            [only] => {
                texts.push(format!(
                    "one temperature: the constants hold within {AROUND_ONE} K of {only:.0} °C"
                ));
                AROUND_ONE
            }
            _ => AROUND,
        };
        texts.extend(best.problem.oil.outside(&self.temperatures_c, far));
        let [_, points, kept] = self.counts;
        if 2 * kept < points {
            texts.push(format!("{} of {points} points are dropped", points - kept));
        }
        if self.squares_per_point < OVERSTATED {
            texts.push(format!(
                "the residuals are {:.1} times the stated errors: the errors are too large",
                self.squares_per_point.sqrt()
            ));
        }
        if self.squares_per_point > POORLY_EXPLAINED {
            texts.push(format!(
                "the residuals are {:.1} times the stated errors: the error of the law is {:.0} %",
                self.squares_per_point.sqrt(),
                100.0 * self.law_error
            ));
        }
        if !self.is_law_decided {
            let other = self.other_law.pressure_law.name();
            texts.push(format!(
                "the points do not decide the law of pressure: the oil file holds the constants by {other} as well"
            ));
        } else if !self.is_law_decided_by_points {
            let text = "the points alone do not decide the law of pressure: the stated or estimated pressure-viscosity coefficient does, and must be right to 10 %";
            texts.push(text.to_owned());
        }
        texts.extend(self.combinations.iter().map(Combination::sentence));
        texts
            .into_iter()
            .map(|text| Warning::new(Code::W441, text))
            .collect()
    }
}

/// The first constant that no known oil has, with its possible range.
fn impossible(constants: &[FittedConstant]) -> Option<(&FittedConstant, [f64; 2])> {
    let all = POSSIBLE
        .into_iter()
        .map(|(k, range)| (&constants[k], range));
    let mut outside = all.filter(|(one, [low, high])| !(*low..=*high).contains(&one.fitted.value));
    outside.next()
}

fn refuse_points(points: &[SetPoint], judged: &[Judged], kept: usize) -> Result<(), Fault> {
    if kept < FEWEST {
        let counted = Dropped::ALL.into_iter().filter_map(|rule| {
            let count = judged
                .iter()
                .filter(|one| one.dropped == Some(rule))
                .count();
            (count > 0).then(|| format!("{count}: {rule}"))
        });
        let dropped = counted.collect::<Vec<String>>().join("; ");
        return Err(oil_error::few_points(
            kept,
            points.len(),
            if dropped.is_empty() {
                dropped
            } else {
                format!(" ({dropped})")
            },
        ));
    }
    let kept = judged.iter().filter(|one| one.dropped.is_none());
    let most = kept.fold(0.0, |most: f64, one| most.max(one.max_pressure));
    if most < LEAST_PRESSURE {
        Err(oil_error::low_pressure(1e-9 * most))
    } else {
        Ok(())
    }
}

/// Values of the stated constants in the units of an oil file.
fn values(of: &TractionConstants) -> [f64; STATED] {
    [
        1e-6 * of.eyring_stress.si(),
        of.limiting_shear,
        of.limiting_shear_fall.si(),
        of.pressure_viscosity_factor,
    ]
}

fn constants(
    fit: &LawFit<'_>,
    before: &[f64; CONSTANTS],
    further: &[Option<Helpful>; STATED],
) -> Vec<FittedConstant> {
    let priors = values(fit.problem.oil.rheology.constants());
    let rows = STATED_CONSTANTS
        .iter()
        .enumerate()
        .map(|(k, (key, name, unit))| {
            let sd = fit.problem.priors.constants[k];
            let (shift, posterior) = (sd * fit.x[k], fit.deviation(k));
            let is_logarithm = k != FALL;
            let is_identified = posterior <= NOT_IDENTIFIED;
            let at = |shift: f64| {
                if is_logarithm {
                    priors[k] * shift.exp()
                } else {
                    priors[k] + shift
                }
            };
            let quantiles = |z: f64, middle: f64, sd: f64| [-z, z].map(|z| at(middle + z * sd));
            let widened = LINEARISED * sd * posterior;
            FittedConstant {
                key: (*key).to_owned(),
                name: (*name).to_owned(),
                unit: (*unit).to_owned(),
                fitted: Estimate::new(at(shift), quantiles(Z_95, shift, widened)),
                band: quantiles(Z_975, shift, widened),
                prior: Estimate::new(priors[k], quantiles(Z_95, 0.0, sd)),
                expected: before[k],
                posterior,
                is_identified,
                would_help: further[k].filter(|_| !is_identified).map(words),
            }
        });
    rows.collect()
}

/// A further setting in words.
fn words(further: Helpful) -> String {
    let at = &further.setting;
    format!(
        "{} N, {} m/s, {} %, {:.0} °C: {:.0} % of the error left",
        at.load.si(),
        at.mean_speed.si(),
        100.0 * at.slide_to_roll,
        at.temperature.celsius(),
        100.0 * further.posterior
    )
}

fn stated_correlations(fit: &LawFit<'_>) -> Vec<Vec<f64>> {
    let all = correlations(&fit.covariance);
    (0..STATED)
        .map(|i| (0..STATED).map(|j| all[(i, j)]).collect())
        .collect()
}

fn nuisance(fit: &LawFit<'_>) -> Vec<NuisanceTerm> {
    let readings = &fit.problem;
    let temperature = |k: usize| {
        let of = readings.points.iter().find(|point| point.temperature == k);
        of.map_or(0.0, |point| point.setting.temperature.celsius())
    };
    let terms = readings.terms.iter().enumerate().map(|(k, term)| {
        let deviations = fit.x[CONSTANTS + k];
        let value = deviations * term.deviation;
        let percent = 100.0 * value.abs();
        let side = |more: &'static str, less: &'static str| if value > 0.0 { more } else { less };
        let mut text = String::new();
        // Writing into a string cannot fail.
        let _ = match term.kind {
            Nuisance::Gain(group) => write!(
                text,
                "the machine{} would have to read the friction {percent:.1} % {}",
                match group {
                    0 => String::new(),
                    group => format!(" (group {})", group + 1),
                },
                side("high", "low")
            ),
            Nuisance::Zero(curve) => write!(
                text,
                "the zero of {} would have to be {} of the friction",
                curve.map_or("all curves".to_owned(), |curve| format!(
                    "curve {}",
                    curve + 1
                )),
                Digits::of_decimals(4).signed(value)
            ),
            Nuisance::Film => write!(
                text,
                "the film would have to be {percent:.1} % {} than computed",
                side("thicker", "thinner")
            ),
            Nuisance::Conductivity => write!(
                text,
                "the specimens would have to conduct {percent:.0} % {}",
                side("better", "worse")
            ),
            Nuisance::Rise => write!(
                text,
                "the specimens would have to warm by {:.2} K per watt",
                (readings.points[0].machine.bulk_rise + value).max(0.0)
            ),
            Nuisance::Temperature(k) => write!(
                text,
                "your temperature sensor would have to read {:.1} K {} at {:.0} °C",
                value.abs(),
                side("low", "high"),
                temperature(k)
            ),
        };
        NuisanceTerm { text, deviations }
    });
    let mut terms: Vec<NuisanceTerm> = terms.collect();
    terms.sort_by(|a, b| b.deviations.abs().total_cmp(&a.deviations.abs()));
    terms
}

fn rows(points: &[SetPoint], judged: &[Judged], fit: &LawFit<'_>) -> Vec<TractionPointRow> {
    let mut kept = 0..;
    let row = |(point, judged): (&SetPoint, &Judged)| {
        let reading = &point.reading;
        let number = judged.dropped.is_none().then(|| kept.next()).flatten();
        let fitted = number.map(|k| fit.fitted[k]);
        let sigma = number.map(|k| fit.problem.points[k].sigma);
        let residual = fitted
            .zip(sigma)
            .map(|(fitted, sigma)| (reading.traction - fitted) / sigma);
        TractionPointRow {
            file: reading.file.clone(),
            line: reading.line,
            curve: point.curve + 1,
            load_n: reading.setting.load.si(),
            mean_speed_m_s: reading.setting.mean_speed.si(),
            slide_roll_percent: 100.0 * reading.setting.slide_to_roll,
            temperature_c: reading.setting.temperature.celsius(),
            readings: point.readings,
            pressure_gpa: 1e-9 * judged.max_pressure,
            film_ratio: judged.film_ratio,
            traction: reading.traction,
            has_measured_film: reading.film.is_some(),
            fitted,
            residual_sigma: residual,
            dropped: judged.dropped,
        }
    };
    points.iter().zip(judged).map(row).collect()
}
