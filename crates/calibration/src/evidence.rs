//! Measurements that would narrow the interval of the loss of a case, with the interval that each is expected to leave.

use asperity_core::cancel::checkpoint;
use asperity_core::{Code, Estimate, Fault, PROGRAM, capitalised};
use std::convert::Infallible;
use std::str::FromStr;

use asperity::case::train::Train;
use asperity::core::{did_you_mean, nearest_name};
use asperity::evidence::{Effort, Evidence, ONE_CURVE, PlannedCurves, STANDARD_PLAN};
use asperity::pipeline::{Kept, Progress, less_of_scans};
use asperity::result::loss_band::{Digits, EvidenceRow};
use asperity::result::{ScanComparison, with_interval};
use asperity::train::Outcome;
use asperity::uncertainty::{Measurement, PairedDifference, Quantiles, difference, has_band};
use asperity::{Contacts, LoadedCase, Run};
use asperity_report::chart::{Axis, Drawing, Interval, Tornado};
use asperity_report::{
    Cell, Report, Settings as _, StudyResult, StudySettings, Table, Watch, Work, columns, duration,
    scans, settings, with_scans,
};
use schemars::JsonSchema;
use serde::{Deserialize, Serialize};

use crate::oil::{ConstantsOf, OilBase, OilPlanSettings, stages_of_case};

const TABLE: &str = "evidence.csv";

/// Hours of a measurement as text, `NAME=HOURS`.
#[derive(Debug, Clone, PartialEq, Eq, Deserialize, JsonSchema)]
#[serde(transparent)]
pub struct NamedHours(String);

impl FromStr for NamedHours {
    type Err = Infallible;

    fn from_str(text: &str) -> Result<Self, Self::Err> {
        Ok(Self(text.to_owned()))
    }
}

settings! {
    /// Settings of a table of evidence.
    pub struct EvidenceSettings {
        /// Hours of a measurement by its name in evidence.csv, e.g. traction-plan=3; may be repeated
        [value_name = "NAME=HOURS"] hours: Vec<NamedHours>,
    }
}

impl EvidenceSettings {
    /// The usual hours, changed by those stated.
    fn efforts(&self) -> Result<Vec<Effort>, Fault> {
        let mut efforts = Effort::usual().to_vec();
        for NamedHours(stated) in &self.hours {
            let refused = |why: String| Fault::new(Code::E209, format!("hours {stated}: {why}"));
            let (name, hours) = stated.split_once('=').unwrap_or((stated, ""));
            let name = name.trim();
            let own = efforts.iter_mut().find(|effort| effort.key == name);
            let Some(own) = own else {
                let names = Effort::usual().map(|effort| effort.key.to_owned());
                let meant = did_you_mean(nearest_name(name, &names).as_deref());
                let why = format!("no measurement is called \"{name}\"{meant}");
                let names = names.join(", ");
                let help = format!("Give NAME=HOURS with one of the names {names}.");
                return Err(refused(why).helping(help));
            };
            let hours = hours.trim().parse().ok();
            let hours = hours.filter(|hours| (0.0..1e6).contains(hours));
            own.hours =
                Some(hours.ok_or_else(|| {
                    refused("the hours must be a number from 0 to below 1e6".into())
                })?);
        }
        Ok(efforts)
    }
}

impl StudySettings for EvidenceSettings {
    type Input = Train;
    type Found = EvidenceTable;
    const COMMAND: &'static str = "evidence";
    const ABOUT: &'static str =
        "Measurements that would narrow the interval of the loss most, with their hours";
    const EXAMPLES: &'static [&'static [(&'static str, &'static str)]] =
        &[&[("case", "demo/case.toml"), ("hours", "traction-plan=3")]];
    const METHOD: &'static str = "Each row is the interval that the measurement alone is expected to leave. What the case states or has \
        measured has no row.";
    const STEPS: &'static str = "positions";

    fn work(&self, train: &Train) -> Result<Option<Work>, Fault> {
        self.efforts()?;
        // The run, and changes of the constants of the oil.
        Ok(Some(Work::new(train.cases().cloned().collect(), 2)))
    }

    fn run(&self, train: Train, watch: &Watch<'_>) -> Result<EvidenceTable, Fault> {
        EvidenceTable::new(&train, &self.efforts()?, watch.progress)
    }
}

/// Loss with the middle rows of scans instead of all rows that are taken.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
#[non_exhaustive]
pub struct MiddleRows {
    /// Rows that are taken, in words.
    pub taken: String,
    /// Loss by the middle rows with its interval.
    pub loss: Quantiles,
    /// Loss by all rows minus this loss.
    pub difference: PairedDifference,
}

impl MiddleRows {
    /// The change by all rows, in words.
    fn line(&self) -> String {
        let loss = Digits::of_interval(self.loss.drawn.ends()).interval(self.loss.drawn);
        let difference = scans::difference(self.difference.watts);
        format!(
            "By the middle row of each scan alone the loss would be {loss} W. {} change it by {difference} W; in brackets 5 to 95 %.",
            capitalised(&self.taken)
        )
    }

    /// The loss by the middle rows of the scans of `outcome`; `None` if it has no rows of scans, or no interval.
    ///
    /// # Errors
    /// When the case has no result.
    fn from_outcome(outcome: &Outcome) -> Result<Option<Self>, asperity::Error> {
        let (Some(mesh), Some(drawn)) = (outcome.settled.only(), &outcome.drawn) else {
            return Ok(None);
        };
        let scans = less_of_scans(mesh).filter(|scans| !scans.are_patches);
        let (Some(scans), [drawn]) = (scans, &drawn[..]) else {
            return Ok(None);
        };
        let case = scans.case?;
        let single = Run::new(&case).pictures(Kept::Nothing).interval(true);
        let single = single.execute()?;
        let drawn_of_single = single.drawn.as_ref().and_then(|drawn| drawn.first());
        let [one, all] = [&single, outcome].map(|run| run.meshes[0].result.uncertainty.as_ref());
        let both = drawn_of_single.zip(one).zip(all);
        Ok(both.map(|((of_single, one), all)| Self {
            taken: scans.taken,
            loss: Quantiles::from_draws(&of_single.draws_w()),
            difference: difference((&case, of_single, one), (mesh, drawn, all)),
        }))
    }
}

/// Intervals of the loss of a case that measurements are expected to leave.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
#[non_exhaustive]
pub struct EvidenceTable {
    /// Program and version.
    pub program: String,
    /// Title of the case.
    pub title: String,
    /// Operating point, and numbers of positions and offsets, in words; empty for a train of several meshes.
    #[serde(default, skip_serializing_if = "String::is_empty")]
    pub conditions: String,
    /// Power into the meshes \[W\].
    pub power_in_w: f64,
    /// Loss with its interval as known.
    pub loss: Quantiles,
    /// Reason why no row is of traction curves, if none can be planned.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub no_curves: Option<String>,
    /// Whether the temperature is drawn.
    pub is_temperature_drawn: bool,
    /// Comparison of patches of the scans with rows of them.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub scans: Option<ScanComparison>,
    /// Reason for which patches of the scans are not compared with rows of them, if it was tried.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub no_scans: Option<String>,
    /// Loss by only the middle rows of the scans, if rows of them are taken.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub middle_rows: Option<MiddleRows>,
    /// Reason for which the loss by the middle rows is not known, if rows are taken and it is not.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub no_middle_rows: Option<String>,
    /// Measurements, the one that leaves the narrowest interval first.
    pub rows: Vec<EvidenceRow>,
}

impl EvidenceTable {
    /// The table of a gear train or of a pair of gears, with the hours of `efforts`.
    ///
    /// # Errors
    /// When the case has no loss or no interval.
    pub fn new(train: &Train, efforts: &[Effort], progress: Progress<'_>) -> Result<Self, Fault> {
        let none = || {
            let message = "the loss of this case has no interval: formulation = \"paper\" and a solved full film are computed \
                           without one";
            Fault::new(Code::E205, message)
        };
        if !train.meshes().all(|mesh| has_band(&mesh.case)) {
            return Err(none());
        }
        let named = |source: asperity::Error| Fault::from(source).about(&train.title);
        let run = Run::new(train).pictures(Kept::Highest).interval(true);
        let outcome = run.progress(progress).execute().map_err(named)?;
        let evidence = Evidence::from_outcome(&outcome, efforts, &standard_plan).map_err(named)?;
        let (Some(loss), Some(Evidence { rows, no_curves })) =
            (outcome.whole.loss_distribution, evidence)
        else {
            return Err(none());
        };
        let (middle_rows, no_middle_rows) = match MiddleRows::from_outcome(&outcome) {
            Ok(rows) => (rows, None),
            Err(error) => (None, Some(error.to_string())),
        };
        // A cancelled run is not one without a result.
        checkpoint().map_err(|stopped| named(stopped.into()))?;
        let mut meshes = outcome.meshes;
        let only = meshes.pop().filter(|_| meshes.is_empty());
        let (scans, no_scans) = only.map_or((None, None), |only| {
            (only.result.scans, only.result.no_scans)
        });
        let operation =
            |mesh: &LoadedCase| mesh.case.input.operation.temperature_deviation.is_some();
        Ok(Self {
            program: PROGRAM.to_owned(),
            title: train.title.clone(),
            conditions: train
                .only()
                .map_or(String::new(), |mesh| mesh.case.conditions()),
            power_in_w: outcome.whole.meshes_power_in_w(),
            loss,
            no_curves,
            is_temperature_drawn: train.meshes().any(|mesh| operation(&mesh.case)),
            scans,
            no_scans,
            middle_rows,
            no_middle_rows,
            rows,
        })
    }

    /// Width of the interval of ln loss that traction curves of the standard plan leave, over its present width; `None` if the loss has
    /// no interval.
    ///
    /// # Errors
    /// When the case has no loss.
    pub(crate) fn of_standard_plan(
        case: LoadedCase,
        progress: Progress<'_>,
    ) -> Result<Option<f64>, Fault> {
        if !has_band(&case) {
            return Ok(None);
        }
        let table = Self::new(&case.into(), &Effort::usual(), progress)?;
        let of_plan = table.rows.iter().find(|row| row.key == STANDARD_PLAN);
        // Curves that do not narrow the interval have no row.
        Ok(match table.no_curves {
            None => Some(of_plan.map_or(1.0, |row| row.width)),
            Some(_) => None,
        })
    }
}

/// The traction curves of the standard plan, for [`Run::evidence`].
///
/// # Errors
/// When the oil has no constants to measure, or the case no loss.
pub fn standard_plan(case: &LoadedCase, contacts: &Contacts) -> Result<Vec<PlannedCurves>, Fault> {
    let oil = OilBase::of_case(case, ConstantsOf::Family)?;
    let settings = OilPlanSettings::usual()?.plan()?;
    let (stages, slope) = stages_of_case(&oil, (case, contacts), &settings)?;
    let rows = [
        (ONE_CURVE, "one traction curve of the oil"),
        (
            STANDARD_PLAN,
            "traction curves of the oil, the standard plan",
        ),
    ];
    let curves = rows.into_iter().zip(stages).map(|((key, words), stage)| {
        let leaves = |deviation| Measurement::FilmFriction { deviation, slope };
        PlannedCurves {
            key,
            words,
            hours: stage.minutes / 60.0,
            leaves: stage.loss_deviation.map(leaves),
        }
    });
    Ok(curves.collect())
}

impl EvidenceTable {
    /// Meaning of the numbers, and quantities without a line.
    fn notes(&self) -> Vec<String> {
        let mut notes = vec![MEANING.to_owned()];
        if !self.is_temperature_drawn {
            notes.push(NOT_DRAWN.to_owned());
        }
        let curves = self.no_curves.as_ref();
        notes.extend(curves.map(|why| format!("Traction curves have no line: {why}.")));
        notes.extend(self.no_scans.as_deref().map(scans::without));
        let rows = self.no_middle_rows.as_ref();
        notes.extend(
            rows.map(|why| {
                format!("The loss by the middle rows of the scans is not known: {why}.")
            }),
        );
        notes
    }

    /// The present median with an interval and a unit.
    fn loss_text(&self, interval: [f64; 2], unit: &str) -> String {
        let loss = Estimate::new(self.loss.drawn.value, interval);
        let [loss, _] = with_interval(loss, self.power_in_w, [unit, ""]);
        loss
    }

    /// The quickest measurement that narrows the interval nearly as much as any, and the one that narrows it more, in words.
    fn best(&self) -> Vec<String> {
        /// Largest difference of widths that are nearly the same.
        const NEARLY: f64 = 0.03;
        let left = |row: &EvidenceRow| {
            let interval = self.loss_text(row.interval(), " W");
            format!(
                "{}. It is expected to leave {interval} after {}.",
                row.measurement,
                duration(60.0 * row.hours)
            )
        };
        let Some(narrowest) = self.rows.first() else {
            return Vec::new();
        };
        let alike = self.rows.iter();
        let alike = alike.filter(|row| row.width <= narrowest.width + NEARLY);
        let quickest = alike.min_by(|a, b| a.hours.total_cmp(&b.hours));
        let quickest = quickest.unwrap_or(narrowest);
        let best = format!("Measure first: {}", left(quickest));
        // Named if it narrows more as printed.
        let printed = |row: &EvidenceRow| self.loss_text(row.interval(), "");
        let more = printed(narrowest) != printed(quickest);
        let more = more.then(|| format!("Slightly narrower: {}", left(narrowest)));
        [best].into_iter().chain(more).collect()
    }

    /// The interval that each measurement leaves, below the present one.
    fn chart(&self) -> Option<Drawing> {
        let now = Interval {
            name: "as known".to_owned(),
            ends: self.loss.drawn.ends(),
            middle: None,
            text: self.loss_text(self.loss.drawn.ends(), " W"),
        };
        let left = self.rows.iter().map(|row| Interval {
            name: row.measurement.clone(),
            ends: row.interval(),
            middle: None,
            text: duration(60.0 * row.hours),
        });
        (!self.rows.is_empty()).then(|| {
            Drawing::Tornado(Tornado {
                id: "evidence".to_owned(),
                title: "Interval of the loss, 5 to 95 %, that each measurement alone is expected to leave"
                    .to_owned(),
                source: TABLE.to_owned(),
                axis: Axis::new("loss", "W"),
                middle: Some(self.loss.drawn.value),
                intervals: [now].into_iter().chain(left).collect(),
            })
        })
    }

    /// The measurements.
    fn table(&self) -> Table {
        columns! { row in &self.rows;
            head measurement "measurement" "";
            number hours "duration" "" = Cell::number(row.hours, |hours| duration(60.0 * hours));
            percent width "remaining width" "%" "{:.0}";
            shown loss "loss" "W" = self.loss_text(row.interval(), "");
        }
    }
}

/// Meaning of the numbers.
const MEANING: &str = "Each line: the interval that the measurement alone is expected to leave, about the present median. In brackets: the 5 and 95 % quantiles of the loss. Remaining width: the width of this interval over its present width, both of ln loss. A measurement also moves the median. Traction curves do not narrow the film thickness and the error of its law.";
/// Commands that plan a measurement.
const PLANS: &str = "These measurements narrow the interval of the loss of this case. Constants for other points and gears need more points: asperity design plans them on a rig, asperity oil plan on a traction machine.";
/// Meaning of the hours.
const HOURS: &str = "Measured first: the quickest of those that leave at most 3 % of the present width more than the narrowest. Durations are usual ones, of measuring and its preparation on existing parts; of traction curves they are computed, as by asperity oil plan. Making a second set of gears is not included.";
/// A quantity without a line.
const NOT_DRAWN: &str = "The temperature is taken as exact and has no line: the case states no operation.temperature_deviation.";

impl StudyResult for EvidenceTable {
    const KIND: &'static str = "evidence";
    const NAME: &'static str = "evidence";

    fn report(&self) -> Report<'_> {
        let loss = self.loss_text(self.loss.drawn.ends(), " W");
        let report = Report::new(&self.title, "evidence")
            .section("Measurements that narrow the interval")
            .verdict([format!("Loss {loss}.")])
            .verdict(self.best())
            .figures(|| self.chart())
            .text([PLANS])
            .at(&self.conditions)
            .table(self.table().of_file(TABLE))
            .method([HOURS])
            .method(self.notes())
            .rows(TABLE, || &self.rows);
        let report = match &self.scans {
            Some(scans) => with_scans(report.section(scans::SECTION), scans),
            None => report,
        };
        match &self.middle_rows {
            Some(rows) => report.section(scans::SECTION).text([rows.line()]),
            None => report,
        }
    }
}
