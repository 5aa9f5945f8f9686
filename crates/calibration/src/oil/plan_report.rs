//! Report of a plan of traction measurements.

use std::path::Path;

use asperity::case::law_error;
use asperity_core::Fault;
use asperity_report::chart::{Axis, Chart, Drawing, Line, Series};
use asperity_report::{
    Cell, Column, Kind, Report, StudyResult, Table, columns, duration, tables, write_bytes,
};
use serde::Serialize;

use super::plan::{OilPlan, PlannedCurve, PlannedPoint, Stage, WHOLE};
use super::problem::{FALL, STATED_CONSTANTS};
use crate::rig_table::SIMULATED;

const TO_FILL_IN: &str = "plan.csv";
const SIMULATED_TABLE: &str = "simulated.csv";
const ERRORS: &str = "expected_errors.csv";

/// Row of the table to fill in.
#[derive(Serialize)]
struct PlanRow {
    load_n: f64,
    mean_speed_m_s: f64,
    slide_roll_percent: f64,
    temperature_c: f64,
    traction: Option<f64>,
    set_temperature_c: f64,
    expected_traction: f64,
    film_ratio: f64,
    /// Mark of a simulated reading.
    #[serde(skip_serializing_if = "Option::is_none")]
    simulated: Option<bool>,
}

/// Row of the table of expected errors.
#[derive(Serialize)]
struct ErrorRow<'a> {
    stage: &'a str,
    points: usize,
    minutes: f64,
    key: &'a str,
    standard_deviation: f64,
}

impl StudyResult for OilPlan {
    const KIND: &'static str = "traction plan";
    const NAME: &'static str = "oil_plan";

    fn report(&self) -> Report<'_> {
        let simulated =
            format!("{SIMULATED_TABLE} contains {SIMULATED} readings of the standard plan.");
        let choice = choice(self);
        let report = Report::new(&self.title, "traction plan")
            .section("Expected errors")
            .verdict(verdict(self))
            .verdict([format!("{choice}.")])
            .text(more_of_standard(self))
            .text([WHEN])
            .figures(|| [errors(self)])
            .table(stages(self))
            .text(notes(self))
            .section("Standard plan")
            .heading(WHOLE)
            .in_terminal()
            .table(curves(self))
            .text([TO_FILL_IN_TEXT])
            .on_page()
            .section(&choice)
            .heading(choice)
            .in_terminal()
            .table(chosen(self))
            .text(self.is_simulated().then_some(simulated))
            .rows(TO_FILL_IN, || self.rows(|_| None))
            .rows(ERRORS, || self.stages.iter().flat_map(error_rows));
        if self.is_simulated() {
            report.file(|folder| self.write_simulated(&folder.join(SIMULATED_TABLE)))
        } else {
            report
        }
    }
}

/// Use of a plan, next to the command that compares all measurements.
const WHEN: &str = "Traction curves serve all gears with this oil. For the loss of one case, run asperity evidence first: it compares \
    them with other measurements.";
/// Purpose of the table to fill in.
const TO_FILL_IN_TEXT: &str =
    "plan.csv is the table to fill in, with the friction expected before any test.";

impl OilPlan {
    /// Whether it holds simulated readings.
    fn is_simulated(&self) -> bool {
        let mut points = self.points.iter();
        points.any(|point| point.simulated_traction.is_some())
    }

    /// Writes simulated readings of the standard plan.
    fn write_simulated(&self, file: &Path) -> Result<(), Fault> {
        let mut bytes = format!("# {SIMULATED} by {}: not measured\n", self.program).into_bytes();
        bytes.extend(tables::text(
            file,
            self.rows(|point| point.simulated_traction),
        )?);
        write_bytes(file, &bytes)
    }

    /// Rows of the standard plan, both signs of each point, with friction.
    fn rows(&self, traction: fn(&PlannedPoint) -> Option<f64>) -> impl Iterator<Item = PlanRow> {
        let signs = move |point: &PlannedPoint| {
            let point = *point;
            [1.0, -1.0].map(|sign| PlanRow {
                load_n: point.load_n,
                mean_speed_m_s: point.mean_speed_m_s,
                slide_roll_percent: sign * point.slide_roll_percent,
                temperature_c: point.temperature_c,
                traction: traction(&point).map(|friction| sign * friction),
                set_temperature_c: point.temperature_c,
                expected_traction: sign * point.expected_traction,
                film_ratio: point.film_ratio,
                simulated: traction(&point).map(|_| true),
            })
        };
        self.points.iter().flat_map(signs)
    }
}

/// Rows of a stage.
fn error_rows(stage: &Stage) -> impl Iterator<Item = ErrorRow<'_>> {
    let row = |key, standard_deviation| ErrorRow {
        stage: &stage.name,
        points: stage.points,
        minutes: stage.minutes,
        key,
        standard_deviation,
    };
    let constants = stage.constants.iter();
    let constants = constants.map(move |one| row(one.key.as_str(), one.deviation));
    constants.chain(stage.loss_deviation.map(|loss| row("loss", loss)))
}

/// Errors of the constants and of the loss that each stage is expected to leave.
fn stages(plan: &OilPlan) -> Table {
    let table = columns! { stage in &plan.stages;
        head name "expected standard deviation" "";
        number points "points" "";
        number minutes "duration" "" = Cell::number(stage.minutes, duration);
    };
    let constants = STATED_CONSTANTS
        .iter()
        .enumerate()
        .map(|(k, (_, name, _))| {
            let deviations = plan.stages.iter().map(|stage| stage.constants.get(k));
            let deviations = deviations.map(|one| one.map(|one| one.deviation));
            if k == FALL {
                Column::new(
                    Kind::Number,
                    name,
                    "1/K",
                    deviations.map(|one| Cell::number(one, |one| format!("{one:.4}"))),
                )
            } else {
                percent(name, deviations)
            }
        });
    let losses = plan.stages.iter().map(|stage| stage.loss_deviation);
    let loss = plan.case.as_ref().map(|_| percent("loss", losses));
    table.with(constants).with(loss)
}

/// Column of standard deviations of logarithms.
fn percent(name: &str, deviations: impl Iterator<Item = Option<f64>>) -> Column {
    let cells = deviations.map(|one| Cell::number(one, |one| format!("{:.1}", 100.0 * one)));
    Column::new(Kind::Number, name, "%", cells)
}

/// Slide-to-roll ratios of a curve, or why it has none.
fn slides(curve: &PlannedCurve) -> String {
    let rules = curve.dropped.iter().map(ToString::to_string);
    let rules = rules.collect::<Vec<String>>().join(", ");
    match (&curve.slides_percent[..], rules.is_empty()) {
        ([], _) => format!("left out: {rules}"),
        (all, true) => joined(all),
        (all, false) => format!("{} (others: {rules})", joined(all)),
    }
}

fn joined(percents: &[f64]) -> String {
    let texts = percents.iter().map(ToString::to_string);
    texts.collect::<Vec<String>>().join(" ")
}

/// What the standard plan leaves of the error of the Eyring stress and of the loss; `None` if it is not among the stages.
fn verdict(plan: &OilPlan) -> Option<String> {
    let before = plan.stages.first()?;
    let of_plan = plan.stages.iter().find(|stage| stage.name == WHOLE)?;
    let errors =
        |of: fn(&Stage) -> Option<f64>| Some([of(before)?, of(of_plan)?].map(|one| 100.0 * one));
    let takes = format!(
        "The standard plan takes {}. It narrows",
        duration(of_plan.minutes)
    );
    if let Some([from, to]) = errors(|stage| stage.loss_deviation) {
        let with_law = to.hypot(100.0 * law_error(0.0));
        let whole = plan.remaining_width.map_or(String::new(), whole_interval);
        return Some(format!(
            "{whole}{takes} the standard deviation of the loss by these constants from {from:.1} to {to:.1} %. With the error of the law, \
             {with_law:.1} % remain."
        ));
    }
    let [from, to] = errors(|stage| Some(stage.constants.first()?.deviation))?;
    Some(format!(
        "{takes} the standard deviation of the {} from {from:.1} to {to:.1} %.",
        STATED_CONSTANTS[0].1
    ))
}

/// The width that the standard plan leaves of the whole interval of the loss.
fn whole_interval(width: f64) -> String {
    /// Remaining width from which a measurement is of little help (assumed).
    const LITTLE: f64 = 0.9;
    let keeps = format!(
        "the whole interval keeps {:.0} % of its width",
        100.0 * width
    );
    if width > LITTLE {
        format!("Traction curves help the loss of this case little: {keeps}. ")
    } else {
        format!("With traction curves {keeps}. ")
    }
}

/// What the standard plan leaves of the error of the Eyring stress against the chosen points, in words; `None` if not less.
fn more_of_standard(plan: &OilPlan) -> Option<String> {
    let whole = plan.stages.iter().find(|stage| stage.name == WHOLE)?;
    let of = |stage: &Stage| Some(100.0 * stage.constants.first()?.deviation);
    let [standard, chosen] = [of(whole)?, of(plan.stages.last()?)?];
    (standard < chosen).then(|| {
        format!(
            "The standard plan determines the constants better for other cases: {} to {standard:.1} %, by the chosen points to {chosen:.1} %.",
            STATED_CONSTANTS[0].1
        )
    })
}

/// The chosen points with their duration and the error that they leave.
fn choice(plan: &OilPlan) -> String {
    let Some(chosen) = plan.stages.last() else {
        return String::new();
    };
    let first = chosen.constants.first();
    let of_constant = first.map(|one| (STATED_CONSTANTS[0].1, one.deviation));
    let of_loss = chosen.loss_deviation.map(|loss| ("loss of the case", loss));
    let left = of_loss
        .or(of_constant)
        .map(|(name, deviation)| format!(": {name} to {:.1} %", 100.0 * deviation));
    format!(
        "{}, {}{}",
        chosen.name,
        duration(chosen.minutes),
        left.unwrap_or_default()
    )
}

fn notes(plan: &OilPlan) -> Vec<String> {
    let mut notes = vec![format!(
        "One curve: 100 °C, 30 N, 2 m/s. Three curves: the same at 40, 80 and 120 °C. The small ball has a diameter of 9.5 mm, 75 N and 3 m/s. Points with a film below three times the roughness of {:.0} nm are left out. A curve with both signs takes 4 min, heating 15 min.",
        plan.roughness_nm
    )];
    let best = match plan.case {
        Some(_) => "the loss of the case",
        None => "all constants",
    };
    notes.push(format!(
        "The chosen points narrow {best} most for their number. The expected errors assume the constants of the family, and points \
        as good as their stated standard deviation."
    ));
    if let Some(case) = &plan.case {
        notes.push(format!(
            "Loss: standard deviation of the loss of {case} by these constants only. The error of the law, {:.0} %, is not in it.",
            100.0 * law_error(0.0)
        ));
    }
    notes
}

fn errors(plan: &OilPlan) -> Drawing {
    let measured = plan.stages.split_last().map_or(&[][..], |(_, rest)| rest);
    let mut chart = Chart::new(
        "errors",
        "Error of the constants that is left",
        ERRORS,
        Axis::new("duration of the measurement", "min").from_zero(),
        Axis::new("standard deviation over the one before any test", "%").from_zero(),
    );
    for (k, (_, name, _)) in STATED_CONSTANTS.iter().enumerate() {
        let points = measured.iter().filter_map(|stage| {
            let one = stage.constants.get(k)?;
            Some([stage.minutes, 100.0 * one.share])
        });
        chart = chart.with(Series::through(name, Line::Dots, points));
    }
    let before = measured.first().and_then(|stage| stage.loss_deviation);
    if let Some(before) = before {
        let points = measured
            .iter()
            .filter_map(|stage| Some([stage.minutes, 100.0 * stage.loss_deviation? / before]));
        chart = chart.with(Series::through("loss of the case", Line::Ink, points));
    }
    Drawing::Curves(chart)
}

/// Curves of the standard plan.
fn curves(plan: &OilPlan) -> Table {
    let table = columns! { curve in &plan.curves;
        number temperature_c "temperature" "°C" "{:.0}";
        number load_n "load" "N" "{:.0}";
        number mean_speed_m_s "speed" "m/s" = curve.mean_speed_m_s;
        number pressure_gpa "Hertz pressure" "GPa" "{:.2}";
        number film_ratio "film over roughness" "" "{:.1}";
        text slides_percent "slide-to-roll ratios, both signs" "%" = slides(curve);
    };
    table.in_file("curves.csv")
}

fn chosen(plan: &OilPlan) -> Table {
    let table = columns! { point in &plan.chosen;
        number temperature_c "temperature" "°C" "{:.0}";
        number load_n "load" "N" "{:.0}";
        number mean_speed_m_s "speed" "m/s" = point.mean_speed_m_s;
        number slide_roll_percent "slide-to-roll ratio" "%" = point.slide_roll_percent;
        number expected_traction "expected friction" "" "{:.4}";
        number film_ratio "film over roughness" "" "{:.1}";
    };
    table.in_file("chosen.csv")
}
