//! The order of a calibration.

use std::sync::atomic::{AtomicUsize, Ordering};

use asperity::case::CalibratedName;
use asperity::message::Warning;
use nalgebra::{DMatrix, DVector};
use sha2::{Digest, Sha256};

use crate::block::block;
use crate::bootstrap::{bootstrap, middle_95};
use crate::error::CalibrationError;
use crate::fit::Fit;
use crate::information::correlations;
use crate::least_squares::minimum;
use crate::parameters::{ASSEMBLY, BEARINGS, ROLLING, TEMPERATURE};
use crate::problem::{Observation, Problem};
use crate::result::{
    Calibration, Evidence, FittedParameter, FittedPoint, Identifiability, NuisanceRow,
    SCHEMA_VERSION, Verdict,
};
use crate::rig::{Rig, RigCase};
use crate::rig_table::{RigTable, Scope};

/// Told on the way.
pub struct Watch<'a> {
    /// Evaluations made, and a guess of how many there will be.
    pub progress: &'a (dyn Fn(usize, usize) + Sync),
    /// What the points can find, before the fit.
    pub before_the_fit: &'a dyn Fn(&Identifiability),
}

impl Watch<'_> {
    /// Tells nobody.
    pub const SILENT: Watch<'static> = Watch {
        progress: &|_, _| {},
        before_the_fit: &|_| {},
    };
}

/// Samples of the bootstrap.
const SAMPLES: usize = 200;
/// Seed of its samples.
const SEED: u64 = 18;
/// Assemblies from which on a bootstrap may widen a band: of fewer there are too few different samples.
const FEW_ASSEMBLIES: usize = 5;

/// Calibrates the parameters of boundary layer and film that are not `held` on the measurements of `table`, whose
/// content `text` is signed for the record.
///
/// ```text
/// read, check -> contacts of every torque -> share refused? -> outliers -> information -> stages, fit -> bands
/// ```
///
/// # Errors
/// When the table and the cases do not go together, the points cannot find the share, rows are outliers, or the model
/// has no solution.
pub fn calibrate(
    table: RigTable,
    text: &str,
    cases: &[RigCase],
    held: &[CalibratedName],
    watch: &Watch<'_>,
) -> Result<Calibration, CalibrationError> {
    let done = AtomicUsize::new(0);
    let guess = AtomicUsize::new(0);
    let told = |_: usize| {
        let count = done.fetch_add(1, Ordering::Relaxed) + 1;
        // Before the points are known there is nothing to guess from.
        match guess.load(Ordering::Relaxed) {
            0 => {}
            guess => (watch.progress)(count, guess.max(count)),
        }
    };
    let rig = Rig::new(table, cases, held, &told)?;
    // Surfaces of two to three rounds, and the further points of the information.
    let axes = rig.parameters.len() + 1;
    let settings = 1 + 2 * axes + axes * (axes - 1) / 2;
    guess.store(
        3 * settings * rig.wanted.len() + 36 * (1 + axes),
        Ordering::Relaxed,
    );
    rig.check_share()?;
    rig.check_size()?;
    let first = rig.first_surfaces(&told)?;
    let observations = rig.observations(&rig.table.rows);
    let priors = rig.priors();
    let problem = Problem::new(&first.1, &first.0, &priors, observations.clone());
    rig.check_outliers(&problem)?;
    let found = rig.identifiability(&problem, &told)?;
    (watch.before_the_fit)(&found);
    let fit = rig.fit(observations, first, &told)?;
    let evaluations = done.load(Ordering::Relaxed);
    report(&rig, &fit, found, text, evaluations)
}

fn report(
    rig: &Rig,
    fit: &Fit,
    identifiability: Identifiability,
    text: &str,
    evaluations: usize,
) -> Result<Calibration, CalibrationError> {
    let samples = samples(rig, fit);
    let parameters = rig.fitted(fit, &identifiability, &samples)?;
    let n = rig.parameters.len();
    let between = correlations(&fit.covariance.view((0, 0), (n, n)).into_owned());
    let between: Vec<Vec<f64>> = (0..n)
        .map(|i| (0..n).map(|j| between[(i, j)]).collect())
        .collect();
    let problem = fit.problem();
    let residuals = problem.of_measurements(&fit.minimum.x);
    let chi_squared: f64 = residuals.iter().map(|r| r * r).sum();
    let freedom = freedom(&problem, fit);
    let held_out = rig.held_out(fit)?;
    let (largest, in_sigma) = surface_error(rig, fit)?;
    let table = &rig.table;
    let origin = match table.is_simulated {
        true => "SIMULATED losses of ",
        false => "",
    };
    let assemblies = table.assemblies();
    let source = format!(
        "{origin}{}, {} points, {} {}",
        table.name,
        table.rows.len(),
        assemblies.len(),
        if assemblies.len() == 1 {
            "assembly"
        } else {
            "assemblies"
        }
    );
    let warnings = warnings(rig, fit, [chi_squared, freedom], &residuals);
    Ok(Calibration {
        schema_version: SCHEMA_VERSION,
        program: format!("asperity {}", env!("CARGO_PKG_VERSION")),
        title: rig.title.clone(),
        table: table.name.clone(),
        sha256: Sha256::digest(text.as_bytes())
            .iter()
            .map(|byte| format!("{byte:02x}"))
            .collect(),
        is_simulated: table.is_simulated,
        assemblies,
        identifiability,
        stages: fit.stages.clone(),
        block: block(&source, &parameters, &between),
        parameters,
        correlations: between,
        nuisance: nuisance(rig, fit),
        chi_squared,
        freedom,
        held_out,
        evidence: Evidence {
            rounds: fit.rounds,
            evaluations,
            largest_surface_error: largest,
            largest_surface_error_sigma: in_sigma,
            bootstrap_samples: samples.len(),
        },
        points: points(rig, &problem, fit, &residuals),
        warnings,
    })
}

/// Parameters of fits to assemblies drawn anew; none of a single assembly.
fn samples(rig: &Rig, fit: &Fit) -> Vec<Vec<f64>> {
    let problem = fit.problem();
    if problem.assemblies < 2 {
        return Vec::new();
    }
    let n = rig.parameters.len();
    bootstrap(problem.assemblies, SAMPLES, SEED, |sample| {
        // An assembly drawn twice is two assemblies, each with a scale of its own.
        let drawn = sample.iter().enumerate().flat_map(|(number, group)| {
            let of_group = problem
                .observations
                .iter()
                .filter(move |seen| seen.assembly == *group);
            of_group.map(move |seen| Observation {
                assembly: number,
                ..*seen
            })
        });
        let mut part = problem.with(drawn.collect());
        part.assemblies = problem.assemblies;
        let mut start = fit.minimum.x.clone();
        for (number, group) in sample.iter().enumerate() {
            start[part.scale(number)] = fit.minimum.x[problem.scale(*group)];
        }
        let all: Vec<usize> = (0..part.variables()).collect();
        let found = minimum(&part, &start, &all).ok()?;
        Some(found.x.iter().take(n).copied().collect())
    })
}

impl Rig {
    /// The parameters of a fit with their bands; `samples` are those of a bootstrap.
    ///
    /// # Errors
    /// When a fit of a profile does not converge.
    pub fn fitted(
        &self,
        fit: &Fit,
        identifiability: &Identifiability,
        samples: &[Vec<f64>],
    ) -> Result<Vec<FittedParameter>, CalibrationError> {
        let assemblies = self.table.assemblies().len();
        let one = |k: usize| -> Result<FittedParameter, CalibrationError> {
            let parameter = &self.parameters[k];
            let value = |logarithm: f64| parameter.centre * logarithm.exp();
            let profile = fit.band(k)?;
            let of_samples: Vec<f64> = samples.iter().map(|sample| value(sample[k])).collect();
            let bootstrap = middle_95(&of_samples);
            let profile_band = profile.ends.map(value);
            let band = match bootstrap {
                Some([low, high]) if assemblies >= FEW_ASSEMBLIES => {
                    [profile_band[0].min(low), profile_band[1].max(high)]
                }
                _ => profile_band,
            };
            Ok(FittedParameter {
                key: parameter.name.key().to_owned(),
                name: parameter.words().to_owned(),
                value: value(fit.minimum.x[k]),
                band,
                profile_band,
                is_open: profile.is_open,
                profile: profile
                    .curve
                    .iter()
                    .map(|[at, rise]| [value(*at), *rise])
                    .collect(),
                bootstrap,
                default: parameter.centre,
                default_range: parameter.range,
                deviation: fit.deviation(k),
                verdict: identifiability
                    .parameters
                    .get(k)
                    .map_or(Verdict::Found, |found| found.verdict),
            })
        };
        (0..self.parameters.len()).map(one).collect()
    }
}

/// Measurements less what the variables took from them: the trace of the influence of the measurements.
fn freedom(problem: &Problem<'_>, fit: &Fit) -> f64 {
    let count = problem.observations.len();
    let slopes: DMatrix<f64> = problem.slopes(&fit.minimum.x).rows(0, count).into_owned();
    let taken = (&slopes * &fit.covariance).component_mul(&slopes).sum();
    count as f64 - taken
}

/// Largest difference of the surfaces from the model at the fit: in logarithms, and in standard deviations.
fn surface_error(rig: &Rig, fit: &Fit) -> Result<(f64, f64), CalibrationError> {
    let n = rig.parameters.len();
    let mut setting: Vec<f64> = fit.minimum.x.iter().take(n).copied().collect();
    setting.push(TEMPERATURE * fit.minimum.x[n]);
    let u = fit.region.place(&setting);
    let exact = rig.model.evaluate(&[setting], &|_| {})?;
    let (mut largest, mut in_sigma) = (0.0_f64, 0.0_f64);
    for seen in &fit.observations {
        let parts = &exact[seen.point][0];
        let surfaces = &fit.surfaces[seen.point];
        let loss = surfaces.sliding.at(&u).0.exp() + surfaces.rolling.at(&u).0.exp();
        let error = (loss / (parts.sliding_w + parts.rolling_w)).ln().abs();
        largest = largest.max(error);
        in_sigma = in_sigma.max(error / seen.sigma);
    }
    Ok((largest, in_sigma))
}

fn nuisance(rig: &Rig, fit: &Fit) -> Vec<NuisanceRow> {
    let problem = fit.problem();
    let n = rig.parameters.len();
    let x = &fit.minimum.x;
    let row = |name: String, k: usize, [offset, unit_prior]: [f64; 2], unit: &str| NuisanceRow {
        name,
        value: offset + unit_prior * x[k],
        deviation: unit_prior * fit.deviation(k),
        prior: unit_prior,
        unit: unit.to_owned(),
    };
    let mut rows = vec![
        row(
            "oil temperature, offset".to_owned(),
            n,
            [0.0, TEMPERATURE],
            "K",
        ),
        row(
            "rolling loss, change".to_owned(),
            n + 1,
            [0.0, 100.0 * ROLLING],
            "%",
        ),
        row(
            "loss torque without load".to_owned(),
            n + 2,
            [0.0, problem.no_load],
            "N m",
        ),
    ];
    if rig
        .table
        .rows
        .iter()
        .any(|row| row.includes == Scope::MeshAndBearings)
    {
        rows.push(row(
            "loss torque of the bearings over the torque".to_owned(),
            n + 3,
            BEARINGS,
            "",
        ));
    }
    for (number, name) in rig.table.assemblies().iter().enumerate() {
        let scale = problem.scale(number);
        rows.push(row(
            format!("scale of assembly {name}"),
            scale,
            [0.0, 100.0 * ASSEMBLY],
            "%",
        ));
    }
    rows
}

fn points(rig: &Rig, problem: &Problem<'_>, fit: &Fit, residuals: &[f64]) -> Vec<FittedPoint> {
    let rows = rig
        .table
        .rows
        .iter()
        .zip(&problem.observations)
        .zip(residuals);
    let point = |((row, seen), residual): ((&crate::rig_table::RigRow, &Observation), &f64)| {
        let nominal = &rig.nominal[seen.point];
        FittedPoint {
            line: row.line,
            assembly: row.assembly.clone(),
            torque_nm: row.torque_nm,
            speed_rpm: row.speed_rpm,
            temperature_c: row.temperature_c,
            measured_w: row.loss_w,
            sigma_w: row.sigma_w,
            fitted_w: problem.predicted(&fit.minimum.x, seen).0.exp(),
            residual_sigma: *residual,
            lambda_star: nominal.lambda_star,
            boundary_share: nominal.boundary_share,
        }
    };
    rows.map(point).collect()
}

/// Share of a normal distribution's chi square that few fits exceed: mean and three standard deviations.
const WIDE: f64 = 3.0;

fn warnings(
    rig: &Rig,
    fit: &Fit,
    [chi_squared, freedom]: [f64; 2],
    residuals: &[f64],
) -> Vec<Warning> {
    let mut found = Vec::new();
    if !fit.is_settled {
        let text = "the optimum lies far outside the usual ranges of the parameters and was not reached; check case, scope and units";
        found.push(Warning::new("W419", text));
    }
    let ratio = chi_squared / freedom;
    if freedom > 0.0 && ratio > 1.0 + WIDE * (2.0 / freedom).sqrt() {
        let factor = ratio.sqrt();
        found.push(Warning::new(
            "W419",
            format!("the points scatter {factor:.1} times as much about the fit as their sigma says; the bands are too narrow by about that"),
        ));
    }
    if let Some(drift) = drift(rig, residuals) {
        found.push(Warning::new(
            "W419",
            format!("the residuals drift with the order of measurement (correlation {drift:+.2})"),
        ));
    }
    if rig.has_gearbox {
        let text = "the gearbox of the case is left aside: the column includes tells what the measured losses hold";
        found.push(Warning::new("W431", text));
    }
    let assemblies = rig.table.assemblies().len();
    if assemblies < 3 {
        found.push(Warning::new(
            "W420",
            format!(
                "{assemblies} {}: the scatter of assemblies is taken from the prior, {:.0} %, and a bootstrap of so few says little",
                if assemblies == 1 { "assembly" } else { "assemblies" },
                100.0 * ASSEMBLY
            ),
        ));
    }
    let mut states: Vec<&str> = rig
        .table
        .rows
        .iter()
        .filter_map(|row| row.flank_state.as_deref())
        .collect();
    states.sort_unstable();
    states.dedup();
    if states.len() > 1 {
        found.push(Warning::new(
            "W420",
            format!(
                "flanks of several states in one fit ({}); the traces are those of one",
                states.join(", ")
            ),
        ));
    }
    found
}

/// Correlation of the residuals with the order of measurement, where it is no accident.
fn drift(rig: &Rig, residuals: &[f64]) -> Option<f64> {
    /// Standard errors of a correlation that few series without a drift reach.
    const LEAST: f64 = 3.0;
    let rows = rig.table.rows.iter().zip(residuals);
    let pairs: Vec<(f64, f64)> = rows
        .filter_map(|(row, residual)| Some((row.order?, *residual)))
        .collect();
    let count = pairs.len() as f64;
    if pairs.len() < 5 {
        return None;
    }
    let mean = |of: fn(&(f64, f64)) -> f64| pairs.iter().map(of).sum::<f64>() / count;
    let (a, b) = (mean(|p| p.0), mean(|p| p.1));
    let sums = pairs
        .iter()
        .fold(DVector::<f64>::zeros(3), |mut sums, (x, y)| {
            sums[0] += (x - a) * (x - a);
            sums[1] += (x - a) * (y - b);
            sums[2] += (y - b) * (y - b);
            sums
        });
    let correlation = sums[1] / (sums[0] * sums[2]).sqrt();
    (correlation.abs() * count.sqrt() > LEAST).then_some(correlation)
}
