//! The steps of a calibration.

use crate::error;
use asperity_core::{Code, Estimate, Fault, PROGRAM};
use std::sync::atomic::{AtomicUsize, Ordering};

use asperity::case::CalibratedName;
use asperity::fingerprint::sha256;
use asperity::message::Warning;
use asperity::result::SCHEMA_VERSION;
use asperity_report::Watch;
use nalgebra::DVector;

use crate::birge::Scatter;
use crate::block::{block, is_narrower};
use crate::bootstrap::{bootstrap, middle};
use crate::fit::Fit;
use crate::identifiability::verdict;
use crate::information::correlations;
use crate::least_squares::minimum;
use crate::parameters::{ASSEMBLY, BEARINGS, ROLLING, TEMPERATURE};
use crate::problem::{Observation, Problem};
use crate::result::{
    Calibration, Evidence, FittedParameter, FittedPoint, Identifiability, NuisanceRow, Verdict,
};
use crate::rig::{Rig, RigCase};
use crate::rig_model::PointLosses;
use crate::rig_table::{RigTable, SIMULATED, Scope};
use crate::summary::{BOOTSTRAPPED, before_the_fit};

/// Number of bootstrap samples.
const SAMPLES: usize = 200;
/// Seed of the bootstrap samples.
const SEED: u64 = 18;
/// Share of a constant's distribution in the interval that is shown, from 5 to 95 %, and in the band of a case file.
const SHOWN: f64 = 0.9;
const WRITTEN: f64 = 0.95;
/// Number of assemblies from which the bootstrap may widen a band: fewer have too few distinct samples.
const FEW_ASSEMBLIES: usize = 5;

/// Fits the parameters of boundary layer and film that are not `held` to the measurements of `table`. The result holds
/// the hash of its `text`. What the points can identify is said before the fit.
///
/// ```text
/// read, check -> contacts of every torque -> layer held? -> outliers -> information -> stages, fit
///   -> residuals within 3 stated errors? -> bands
/// ```
///
/// # Errors
/// When a row has no case, the points identify no parameter that is left, rows are outliers, the model does not explain
/// the measurements within three times their errors or too few are left to confirm that, or the model has no solution.
pub fn calibrate(
    table: RigTable,
    text: &str,
    cases: &[RigCase],
    held: &[CalibratedName],
    watch: &Watch<'_>,
) -> Result<Calibration, Fault> {
    let done = AtomicUsize::new(0);
    let estimated_total = AtomicUsize::new(0);
    let progress = |_: usize| {
        let count = done.fetch_add(1, Ordering::Relaxed) + 1;
        // The total cannot be estimated before the operating points are known.
        match estimated_total.load(Ordering::Relaxed) {
            0 => {}
            total => (watch.progress)(count, total.max(count)),
        }
    };
    let rig = Rig::new(table, cases, held, &progress)?.without_open_layer()?;
    // Response surfaces of three rounds, the derivatives, and the candidates for further measurements.
    let axes = rig.parameters.len() + 1;
    let settings = 1 + 2 * axes + axes * (axes - 1) / 2;
    estimated_total.store(
        (3 * settings + 1 + axes) * rig.operating_points.len() + 36 * (1 + axes),
        Ordering::Relaxed,
    );
    rig.check_freedom()?;
    rig.check_size()?;
    let first = rig.first_surfaces(&progress)?;
    let observations = rig.observations(&rig.table.rows);
    let priors = rig.priors();
    let problem = Problem::new(&first.1, &first.0, &priors, observations.clone());
    rig.check_outliers(&problem)?;
    let identifiability = rig.identifiability(&problem, &progress)?;
    (watch.say)(&before_the_fit(&identifiability));
    let fit = rig.fit(observations, first, &progress)?;
    rig.check_scatter(&fit)?;
    let evaluations = done.load(Ordering::Relaxed);
    let total = estimated_total.load(Ordering::Relaxed).max(evaluations);
    (watch.progress)(total, total);
    report(&rig, &fit, identifiability, text, evaluations)
}

fn report(
    rig: &Rig,
    fit: &Fit,
    identifiability: Identifiability,
    text: &str,
    evaluations: usize,
) -> Result<Calibration, Fault> {
    let samples = samples(rig, fit);
    let parameters = rig.fitted(fit, &identifiability, &samples)?;
    let n = rig.parameters.len();
    let between = correlations(&fit.covariance.view((0, 0), (n, n)).into_owned());
    let between: Vec<Vec<f64>> = (0..n)
        .map(|i| (0..n).map(|j| between[(i, j)]).collect())
        .collect();
    let problem = fit.problem();
    let residuals = problem.of_measurements(&fit.minimum.x);
    let scatter = fit.scatter();
    let held_out = rig.held_out(fit)?;
    let (largest, in_sigma) = surface_error(rig, fit)?;
    let table = &rig.table;
    let origin = if table.is_simulated {
        format!("{SIMULATED} losses of ")
    } else {
        String::new()
    };
    let assemblies = table.assemblies();
    let source = format!(
        "{origin}{}, {} points, {} {}, Birge ratio {:.2}",
        table.name,
        table.rows.len(),
        assemblies.len(),
        if assemblies.len() == 1 {
            "assembly"
        } else {
            "assemblies"
        },
        scatter.ratio()
    );
    let warnings = warnings(rig, fit, &residuals);
    let calibrated = calibrated(rig, fit, &parameters)?;
    Ok(Calibration {
        schema_version: SCHEMA_VERSION,
        program: PROGRAM.to_owned(),
        title: rig.title.clone(),
        table: table.name.clone(),
        sha256: sha256(text.as_bytes()),
        is_simulated: table.is_simulated,
        assemblies,
        identifiability,
        stages: fit.stages.clone(),
        block: block(&source, table.is_simulated, &parameters, &between),
        parameters,
        correlations: between,
        nuisance: nuisance(rig, fit),
        chi_squared: scatter.chi_squared,
        freedom: scatter.freedom,
        birge_ratio: scatter.ratio(),
        held_out,
        evidence: Evidence {
            rounds: fit.rounds,
            evaluations,
            largest_surface_error: largest,
            largest_surface_error_sigma: in_sigma,
            bootstrap_samples: samples.len(),
        },
        points: points(rig, &problem, fit, &residuals, &calibrated),
        warnings,
    })
}

/// Parameters of the fits to resampled assemblies; empty for a single assembly.
fn samples(rig: &Rig, fit: &Fit) -> Vec<Vec<f64>> {
    let problem = fit.problem();
    if problem.assemblies < 2 {
        return Vec::new();
    }
    let n = rig.parameters.len();
    bootstrap(problem.assemblies, SAMPLES, SEED, |sample| {
        // An assembly drawn twice counts as two assemblies with separate scales.
        let drawn = sample.iter().enumerate().flat_map(|(number, group)| {
            let of_group = problem
                .observations
                .iter()
                .filter(move |observation| observation.assembly == *group);
            of_group.map(move |observation| Observation {
                assembly: number,
                ..*observation
            })
        });
        let part = problem.with(drawn.collect());
        let mut start = fit.minimum.x.clone();
        for (number, group) in sample.iter().enumerate() {
            start[part.scale(number)] = fit.minimum.x[problem.scale(*group)];
        }
        let all: Vec<usize> = (0..part.variables()).collect();
        let minimum = minimum(&part, &start, &all).ok()?;
        Some(minimum.x.iter().take(n).copied().collect())
    })
}

impl Rig {
    /// Rejects tables without the rows that confirm their stated errors.
    ///
    /// # Errors
    /// When there are fewer than three rows more than parameters.
    pub(crate) fn check_freedom(&self) -> Result<(), Fault> {
        let [rows, parameters] = [self.table.rows.len(), self.parameters.len()];
        if rows < parameters + Scatter::LEAST_FREEDOM {
            Err(error::few_rows(&self.table.name, rows, parameters))
        } else {
            Ok(())
        }
    }

    /// Rejects a fit that does not explain the measurements within three times their stated errors.
    ///
    /// # Errors
    /// Names the five rows with the largest residuals.
    pub(crate) fn check_scatter(&self, fit: &Fit) -> Result<(), Fault> {
        /// Rows named.
        const NAMED: usize = 5;
        let ratio = fit.scatter().ratio();
        if ratio <= Scatter::LARGEST_RATIO {
            return Ok(());
        }
        let residuals = fit.problem().of_measurements(&fit.minimum.x);
        let lines = self.table.rows.iter().map(|row| row.line);
        let mut largest: Vec<(usize, f64)> = lines.zip(residuals).collect();
        largest.sort_by(|a, b| b.1.abs().total_cmp(&a.1.abs()));
        largest.truncate(NAMED);
        Err(error::unexplained(&self.table.name, ratio, &largest))
    }

    /// The parameters of a fit with their bands; `samples` are the bootstrap estimates.
    ///
    /// # Errors
    /// When a fit of a profile likelihood does not converge.
    pub fn fitted(
        &self,
        fit: &Fit,
        identifiability: &Identifiability,
        samples: &[Vec<f64>],
    ) -> Result<Vec<FittedParameter>, Fault> {
        let assemblies = self.table.assemblies().len();
        let widening = fit.scatter().widening();
        let one = |k: usize| -> Result<FittedParameter, Fault> {
            let parameter = &self.parameters[k];
            let value = |logarithm: f64| parameter.default.value * logarithm.exp();
            let of_samples: Vec<f64> = samples.iter().map(|sample| value(sample[k])).collect();
            let of_both = |ends: [f64; 2], bootstrap: Option<[f64; 2]>| match bootstrap {
                Some([low, high]) if assemblies >= FEW_ASSEMBLIES => {
                    [ends[0].min(low), ends[1].max(high)]
                }
                _ => ends,
            };
            let profile = fit.band(k, WRITTEN)?;
            let band = of_both(profile.ends.map(value), middle(&of_samples, WRITTEN));
            let bootstrap = middle(&of_samples, SHOWN);
            let profile_range = fit.band(k, SHOWN)?.ends.map(value);
            let fitted = Estimate::new(value(fit.minimum.x[k]), of_both(profile_range, bootstrap));
            Ok(FittedParameter {
                key: parameter.name.key().to_owned(),
                name: parameter.words().to_owned(),
                fitted,
                band,
                profile_range,
                is_open: profile.is_open,
                profile: profile
                    .curve
                    .iter()
                    .map(|[at, rise]| [value(*at), *rise])
                    .collect(),
                bootstrap,
                default: parameter.default,
                deviation: fit.deviation(k),
                verdict: match verdict(
                    identifiability.parameters[k]
                        .deviation
                        .map(|by_points| widening * by_points),
                    parameter.prior,
                ) {
                    Verdict::Identified if !is_narrower(fitted, parameter.default) => {
                        Verdict::Partly
                    }
                    by_deviation => by_deviation,
                },
            })
        };
        (0..self.parameters.len()).map(one).collect()
    }
}

/// Largest difference between the response surfaces and the model at the fit, in logarithms and in standard deviations.
fn surface_error(rig: &Rig, fit: &Fit) -> Result<(f64, f64), Fault> {
    let n = rig.parameters.len();
    let mut setting: Vec<f64> = fit.minimum.x.iter().take(n).copied().collect();
    setting.push(TEMPERATURE * fit.minimum.x[n]);
    let u = fit.region.normalised(&setting);
    let exact = rig.model.evaluate(&[setting], &|_| {})?;
    let (mut largest, mut in_sigma) = (0.0_f64, 0.0_f64);
    for observation in &fit.observations {
        let parts = &exact[observation.point][0];
        let surfaces = &fit.surfaces[observation.point];
        let loss = surfaces.sliding.at(&u).0.exp() + surfaces.rolling.at(&u).0.exp();
        let error = (loss / (parts.sliding_w + parts.rolling_w)).ln().abs();
        largest = largest.max(error);
        in_sigma = in_sigma.max(error / observation.sigma);
    }
    Ok((largest, in_sigma))
}

/// Loss of the mesh at every operating point with the constants of the block \[W\].
fn calibrated(rig: &Rig, fit: &Fit, parameters: &[FittedParameter]) -> Result<Vec<f64>, Fault> {
    let of_block = |(one, x): (&FittedParameter, &f64)| match one.verdict {
        Verdict::NotIdentified => 0.0,
        _ => *x,
    };
    let mut setting: Vec<f64> = parameters
        .iter()
        .zip(fit.minimum.x.iter())
        .map(of_block)
        .collect();
    setting.push(0.0);
    let losses = rig.model.evaluate(&[setting], &|_| {})?;
    let of_mesh = |of: &Vec<PointLosses>| of[0].sliding_w + of[0].rolling_w;
    Ok(losses.iter().map(of_mesh).collect())
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

fn points(
    rig: &Rig,
    problem: &Problem<'_>,
    fit: &Fit,
    residuals: &[f64],
    calibrated: &[f64],
) -> Vec<FittedPoint> {
    let rows = rig
        .table
        .rows
        .iter()
        .zip(&problem.observations)
        .zip(residuals);
    let point =
        |((row, observation), residual): ((&crate::rig_table::RigRow, &Observation), &f64)| {
            let nominal = &rig.nominal[observation.point];
            FittedPoint {
                line: row.line,
                assembly: row.assembly.clone(),
                torque_nm: row.torque_nm,
                speed_rpm: row.speed_rpm,
                temperature_c: row.temperature_c,
                measured_w: row.loss_w,
                sigma_w: row.sigma_w,
                fitted_w: problem.predicted(&fit.minimum.x, observation).0.exp(),
                default_w: nominal.sliding_w + nominal.rolling_w,
                calibrated_w: calibrated[observation.point],
                residual_sigma: *residual,
                lambda_star: nominal.lambda_star,
                boundary_share: nominal.boundary_share,
            }
        };
    rows.map(point).collect()
}

fn warnings(rig: &Rig, fit: &Fit, residuals: &[f64]) -> Vec<Warning> {
    let mut warnings = rig.table.warnings.clone();
    if !fit.is_settled {
        let text = "the optimum lies far outside the usual ranges of the parameters and was not reached; check case, scope and units";
        warnings.push(Warning::new(Code::W419, text));
    }
    if let Some(drift) = drift(rig, residuals) {
        warnings.push(Warning::new(
            Code::W419,
            format!("the residuals drift with the order of measurement (correlation {drift:+.2})"),
        ));
    }
    if rig.has_gearbox {
        let text = "the gearbox of the case is ignored: the column includes states the scope of the measured losses";
        warnings.push(Warning::new(Code::W431, text));
    }
    let assemblies = rig.table.assemblies().len();
    if assemblies < BOOTSTRAPPED {
        warnings.push(Warning::new(
            Code::W420,
            format!(
                "{assemblies} {} are too few for a bootstrap; the scatter between assemblies is taken from its prior, {:.0} %",
                if assemblies == 1 { "assembly" } else { "assemblies" },
                100.0 * ASSEMBLY
            ),
        ));
    }
    let repeated = rig.table.repeated();
    if repeated > 0 {
        let text = format!(
            "{repeated} of {} rows repeat an earlier row in every cell and count as measurements of their own; leave copies out, and number measurements that were repeated in the column run",
            rig.table.rows.len()
        );
        warnings.push(Warning::new(Code::W420, text));
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
        warnings.push(Warning::new(
            Code::W420,
            format!(
                "several flank states in one fit ({}), but the traces are of one state",
                states.join(", ")
            ),
        ));
    }
    warnings
}

/// Correlation of the residuals with the order of measurement, if it is significant.
fn drift(rig: &Rig, residuals: &[f64]) -> Option<f64> {
    /// Standard errors above which a correlation is significant.
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
