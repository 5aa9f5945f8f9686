//! Measurements that would narrow the interval of a loss, with the interval that each is expected to leave.

use asperity_core::Fault;
use asperity_core::cancel::checkpoint;

use crate::contacts::Contacts;
use crate::result::loss_band::EvidenceRow;
use crate::train::Outcome;
use crate::uncertainty::{Expected, Measurement, MeshDraws, Quantiles};
use asperity_case::case::{LoadedCase, ShareLaw};
use asperity_case::error::Error;

/// Standard deviation of the logarithm of a boundary friction measured on a traction machine: its transfer to gears.
const TRANSFER: f64 = 0.10;
/// Standard deviation of a temperature by a thermocouple \[K\] (assumed).
const THERMOCOUPLE: f64 = 1.0;
/// Further traces of each flank.
const MORE_TRACES: usize = 4;
/// Errors of a rig: of a point, and of all together (assumed).
const RIG_ERRORS: [f64; 2] = [0.03, 0.03];
/// Points of a day on a rig.
const RIG_POINTS: [usize; 2] = [1, 7];

/// Name of one traction curve.
pub const ONE_CURVE: &str = "traction-curve";
/// Name of the traction curves of the standard plan.
pub const STANDARD_PLAN: &str = "traction-plan";

/// Traction curves of an oil that can be measured.
#[derive(Debug, Clone)]
pub struct PlannedCurves {
    /// Name of their row, [`ONE_CURVE`] or [`STANDARD_PLAN`].
    pub key: &'static str,
    /// What is measured, in words.
    pub words: &'static str,
    /// Hours that they take.
    pub hours: f64,
    /// What they leave; `None` of curves that do not narrow the loss.
    pub leaves: Option<Measurement>,
}

/// The traction curves that a machine would measure for the oil of a mesh with its contacts, or why there are none.
pub type CurvePlan<'a> =
    dyn Fn(&LoadedCase, &Contacts) -> Result<Vec<PlannedCurves>, Fault> + Sync + 'a;

/// A kind of measurement with the hours that it takes.
#[derive(Debug, Clone, PartialEq)]
pub struct Effort {
    /// Name of its row and of its hours.
    pub key: &'static str,
    /// Hours of work, with preparation; `None` of traction curves, whose plan says them.
    pub hours: Option<f64>,
}

impl Effort {
    /// All measurements with their usual hours (assumed).
    #[must_use]
    pub fn usual() -> [Self; 10] {
        [
            (ONE_CURVE, None),
            (STANDARD_PLAN, None),
            ("stribeck-curve", Some(2.0)),
            ("areal-scan", Some(1.0)),
            ("thermocouple", Some(2.0)),
            ("more-traces", Some(1.0)),
            ("measured-flanks", Some(1.0)),
            ("tip-relief", Some(0.1)),
            ("rig-point", Some(4.0)),
            ("rig-day", Some(8.0)),
        ]
        .map(|(key, hours)| Self { key, hours })
    }
}

/// Rows of a run.
#[derive(Debug, Clone)]
pub struct Evidence {
    /// The row that leaves the narrowest interval first.
    pub rows: Vec<EvidenceRow>,
    /// Why no row is of traction curves.
    pub no_curves: Option<String>,
}

impl Evidence {
    /// The rows of a run with the hours of `efforts`; `None` without draws.
    ///
    /// Each row is the interval of the draws with the quantity of the measurement known in all meshes as well as the
    /// measurement leaves it ([`Expected`]). Quantities that the case states or has measured have no row.
    ///
    /// # Errors
    /// When the work is cancelled.
    pub fn from_outcome(
        outcome: &Outcome,
        efforts: &[Effort],
        plan: &CurvePlan<'_>,
    ) -> Result<Option<Self>, Error> {
        let (Some(drawn), Some(loss)) = (&outcome.drawn, outcome.whole.loss_distribution) else {
            return Ok(None);
        };
        let (mut no_curves, mut planned) = (None, Vec::new());
        let mut of_meshes = Vec::new();
        for (case, contacts) in outcome.settled.cases().zip(&outcome.contacts) {
            let mut measurements = of_case(case);
            match curves(case, contacts, plan) {
                Ok(curves) => {
                    let narrowing = curves
                        .iter()
                        .filter_map(|of| Some((of.key, of.words.to_owned(), of.leaves?)));
                    measurements.extend(narrowing);
                    planned = curves;
                }
                Err(why) => no_curves = Some(why),
            }
            of_meshes.push(measurements);
        }
        // A cancelled plan is not one that has no curves.
        checkpoint()?;
        let flanks = outcome.settled.first_with_flanks();
        let with_counts = drawn.iter().zip(outcome.settled.counts()).zip(flanks);
        let drawn: Vec<MeshDraws<'_>> = with_counts
            .map(|((predictive, count), flanks)| (predictive, count, flanks))
            .collect();
        let expected = Expected::new(&drawn);
        let row = |effort: &Effort| {
            let is_known = |known: &&Known| known.0 == effort.key;
            let of_mesh = |known: &Vec<Known>| Some(known.iter().find(is_known)?.2);
            let words = of_meshes.iter().flatten().find(is_known)?.1.clone();
            let measurements: Vec<Option<Measurement>> = of_meshes.iter().map(of_mesh).collect();
            let left = narrowed(&expected, loss, &measurements)?;
            let planned = || planned.iter().find(|curves| curves.key == effort.key);
            let hours = effort.hours.or_else(|| Some(planned()?.hours))?;
            Some(EvidenceRow::new(effort.key, words, hours, loss, left))
        };
        let mut rows: Vec<EvidenceRow> = efforts.iter().filter_map(row).collect();
        rows.sort_by(|a, b| a.width.total_cmp(&b.width));
        Ok(Some(Self { rows, no_curves }))
    }
}

/// The curves of a mesh, or why there are none.
fn curves(
    case: &LoadedCase,
    contacts: &Contacts,
    plan: &CurvePlan<'_>,
) -> Result<Vec<PlannedCurves>, String> {
    if matches!(case.case.share_law(), ShareLaw::Reference) {
        let why = "other constants of the film need other reference solutions";
        return Err(why.to_owned());
    }
    plan(case, contacts).map_err(|error| error.to_string())
}

/// The interval that a measurement is expected to leave, if it is narrower.
fn narrowed(
    expected: &Expected<'_>,
    now: Quantiles,
    measurements: &[Option<Measurement>],
) -> Option<Quantiles> {
    /// Least gain that is worth a row.
    const LEAST: f64 = 0.995;
    let found = expected.after(measurements)?;
    (found.sd_ln < LEAST * now.sd_ln).then_some(found)
}

/// A measurement: its key, its words, and what it leaves.
type Known = (&'static str, String, Measurement);

/// Measurements of flanks, gears and losses.
fn of_case(case: &LoadedCase) -> Vec<Known> {
    let teeth = case.surfaces.several_teeth().unwrap_or([1, 1]);
    let traces = teeth[0].min(teeth[1]);
    let times = (traces + MORE_TRACES) as f64 / traces as f64;
    let mut found = vec![
        (
            "stribeck-curve",
            "boundary friction from a Stribeck curve".to_owned(),
            Measurement::BoundaryFriction {
                deviation: TRANSFER,
            },
        ),
        (
            "thermocouple",
            "temperature by a thermocouple".to_owned(),
            Measurement::Temperature {
                deviation: THERMOCOUPLE,
            },
        ),
        (
            "areal-scan",
            "lay of both flanks from areal scans".to_owned(),
            Measurement::Lay,
        ),
        (
            "more-traces",
            format!("traces of {MORE_TRACES} more teeth of each gear"),
            Measurement::Traces { times },
        ),
        (
            "measured-flanks",
            "traces of the flanks instead of roughness values".to_owned(),
            Measurement::MeasuredFlanks,
        ),
        (
            "tip-relief",
            "tip relief from the drawing".to_owned(),
            Measurement::TipRelief,
        ),
    ];
    for (key, points) in ["rig-point", "rig-day"].into_iter().zip(RIG_POINTS) {
        let [point, common] = RIG_ERRORS;
        let words = match points {
            1 => "loss of a second set of these gears on a rig, 1 point".to_owned(),
            many => format!("losses of a second set of these gears on a rig, {many} points"),
        };
        let deviation = common.hypot(point / (points as f64).sqrt());
        found.push((key, words, Measurement::Losses { deviation }));
    }
    found
}
