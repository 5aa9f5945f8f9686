//! Page, tables and summary of a plan of traction measurements.

use std::fmt::Write as _;
use std::path::Path;

use asperity::case::law_error;
use asperity_core::Fault;
use asperity_report::chart::{Axis, Chart, Drawing, Line, Series};
use asperity_report::html::{figure, page};
use asperity_report::{StudyResult, tables, wrapped, write_bytes};
use maud::{Markup, html};
use serde::Serialize;

use super::plan::{ExpectedError, OilPlan, PlannedCurve, PlannedPoint, Stage, WHOLE};
use super::problem::STATED_CONSTANTS;
use crate::rig_table::SIMULATED;

const TO_FILL_IN: &str = "plan.csv";
const SIMULATED_TABLE: &str = "simulated.csv";
const ERRORS: &str = "expected_errors.csv";

/// Row of the table to fill in.
#[derive(Serialize)]
struct Row {
    load_n: f64,
    mean_speed_m_s: f64,
    slide_roll_percent: f64,
    temperature_c: f64,
    traction: Option<f64>,
    set_temperature_c: f64,
    expected_traction: f64,
    film_ratio: f64,
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
    type Context<'a> = ();

    fn summary(&self, (): ()) -> String {
        let mut text = String::new();
        // Writing into a string cannot fail.
        let _ = writeln!(
            text,
            "{:<16} {:>14} {:>6} {:>12}  slide-to-roll ratio, both signs",
            WHOLE, "speed", "h/Rq", "pressure"
        );
        for curve in &self.curves {
            let line = format!(
                "{:>5.0} °C {:>5.0} N {:>10} m/s {:>6.1} {:>8.2} GPa  {}",
                curve.temperature_c,
                curve.load_n,
                curve.mean_speed_m_s,
                curve.film_ratio,
                curve.pressure_gpa,
                slides(curve)
            );
            let _ = writeln!(text, "{line}");
        }
        text.push('\n');
        let heads = HEADS.map(|head| format!("{head:>9}"));
        let _ = writeln!(
            text,
            "{:<28} {:>6} {:>5}{}{}",
            "expected standard deviation",
            "points",
            "min",
            heads.concat(),
            self.case.as_ref().map_or("", |_| "     loss")
        );
        for stage in &self.stages {
            let cells = cells(stage).map(|cell| format!("{cell:>9}"));
            let _ = writeln!(
                text,
                "{:<38} {:>6} {:>5.0}{}",
                stage.name,
                stage.points,
                stage.minutes,
                cells.collect::<String>()
            );
        }
        for line in [SYMBOLS.to_owned()].into_iter().chain(notes(self)) {
            text.push_str(&wrapped(&line, "  "));
            text.push('\n');
        }
        let _ = writeln!(text, "\n{}:", choice(self));
        for point in &self.chosen {
            let _ = writeln!(
                text,
                "{:>5.0} °C {:>5.0} N {:>10} m/s {:>6} %",
                point.temperature_c, point.load_n, point.mean_speed_m_s, point.slide_roll_percent
            );
        }
        if self.is_simulated() {
            let _ = writeln!(
                text,
                "{SIMULATED_TABLE} holds {SIMULATED} readings of the minimal plan"
            );
        }
        text
    }

    fn page(&self, (): ()) -> String {
        let sections = [
            ("Expected errors", errors(self)),
            ("Minimal plan", curves(self)),
            (choice(self), chosen(self)),
        ];
        let subtitle = format!("{} · traction plan", self.program);
        page(&self.title, &subtitle, &sections)
    }

    fn write_tables(&self, (): (), folder: &Path) -> Result<(), Fault> {
        tables::write(&folder.join(TO_FILL_IN), self.rows(|_| None))?;
        if self.is_simulated() {
            let file = folder.join(SIMULATED_TABLE);
            let mut bytes =
                format!("# {SIMULATED} by {}: not measured\n", self.program).into_bytes();
            bytes.extend(tables::text(
                &file,
                self.rows(|point| point.simulated_traction),
            )?);
            write_bytes(&file, &bytes)?;
        }
        let rows = self.stages.iter().flat_map(error_rows);
        tables::write(&folder.join(ERRORS), rows)
    }
}

impl OilPlan {
    /// Whether it holds simulated readings.
    fn is_simulated(&self) -> bool {
        let mut points = self.points.iter();
        points.any(|point| point.simulated_traction.is_some())
    }

    /// Rows of the minimal plan, both signs of each point, with friction.
    fn rows(&self, traction: fn(&PlannedPoint) -> Option<f64>) -> impl Iterator<Item = Row> {
        let signs = move |point: &PlannedPoint| {
            let point = *point;
            [1.0, -1.0].map(|sign| Row {
                load_n: point.load_n,
                mean_speed_m_s: point.mean_speed_m_s,
                slide_roll_percent: sign * point.slide_roll_percent,
                temperature_c: point.temperature_c,
                traction: traction(&point).map(|friction| sign * friction),
                set_temperature_c: point.temperature_c,
                expected_traction: sign * point.expected_traction,
                film_ratio: point.film_ratio,
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

/// Meaning of the heads.
const SYMBOLS: &str = "tau_0: Eyring stress; Lambda: limiting shear stress over pressure at 90 °C, b_L: its fall with temperature; f: pressure-viscosity coefficient in friction over the one in the film.";
/// Heads of the columns of the constants.
const HEADS: [&str; 4] = ["tau_0", "Lambda", "b_L 1/K", "f"];

/// Errors of a stage in the order of the heads, then of the loss.
fn cells(stage: &Stage) -> impl Iterator<Item = String> {
    let percent = |deviation: f64| format!("{:.1} %", 100.0 * deviation);
    let cell = move |one: &ExpectedError| match one.key.as_str() {
        "limiting_shear_temperature" => format!("{:.4}", one.deviation),
        _ => percent(one.deviation),
    };
    let constants: Vec<String> = stage.constants.iter().map(cell).collect();
    constants
        .into_iter()
        .chain(stage.loss_deviation.map(percent))
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
    texts.collect::<Vec<String>>().join(" ") + " %"
}

fn choice(plan: &OilPlan) -> &'static str {
    match plan.case {
        Some(_) => "Chosen points, which narrow the loss of the case most",
        None => "Chosen points, which narrow all constants most",
    }
}

fn notes(plan: &OilPlan) -> Vec<String> {
    let mut notes = vec![format!(
        "One curve: 100 °C, 30 N, 2 m/s. Three curves: the same at 40, 80 and 120 °C. The small ball has a diameter of 9.5 mm, 75 N and 3 m/s. Points with a film below three times the roughness of {:.0} nm are left out. A curve with both signs takes 4 min, heating 15 min.",
        plan.roughness_nm
    )];
    if let Some(case) = &plan.case {
        notes.push(format!(
            "Loss: standard deviation of the loss of {case} by these constants only; the error of the law adds {:.0} %.",
            100.0 * law_error(0.0)
        ));
    }
    notes
}

fn errors(plan: &OilPlan) -> Markup {
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
    html! {
        div.charts { (figure(&Drawing::Curves(chart))) }
        div.scroll { table {
            thead { tr { th { "expected standard deviation" } th.number { "points" } th.number { "min" }
                @for (_, name, unit) in STATED_CONSTANTS { th.number { (name) @if !unit.is_empty() && unit != "MPa" { " [" (unit) "]" } } }
                @if plan.case.is_some() { th.number { "loss of the case" } } } }
            tbody { @for stage in &plan.stages { tr {
                th scope="row" { (stage.name) } td.number { (stage.points) } td.number { (format!("{:.0}", stage.minutes)) }
                @for cell in cells(stage) { td.number { (cell) } }
            } } }
        } }
        @for note in notes(plan) { p { (note) } }
    }
}

fn curves(plan: &OilPlan) -> Markup {
    html! {
        div.scroll { table {
            thead { tr { th.number { "temperature" } th.number { "load" } th.number { "speed" } th.number { "Hertz pressure" } th.number { "film over roughness" } th { "slide-to-roll ratios, both signs" } } }
            tbody { @for curve in &plan.curves { tr {
                td.number { (format!("{:.0} °C", curve.temperature_c)) } td.number { (format!("{:.0} N", curve.load_n)) }
                td.number { (curve.mean_speed_m_s) " m/s" } td.number { (format!("{:.2} GPa", curve.pressure_gpa)) }
                td.number { (format!("{:.1}", curve.film_ratio)) } td { (slides(curve)) }
            } } }
        } }
        p { code { (TO_FILL_IN) } " is the table to fill in, with the friction expected before any test." }
    }
}

fn chosen(plan: &OilPlan) -> Markup {
    html! { div.scroll { table {
        thead { tr { th.number { "temperature" } th.number { "load" } th.number { "speed" } th.number { "slide-to-roll ratio" } th.number { "expected friction" } th.number { "film over roughness" } } }
        tbody { @for point in &plan.chosen { tr {
            td.number { (format!("{:.0} °C", point.temperature_c)) } td.number { (format!("{:.0} N", point.load_n)) }
            td.number { (point.mean_speed_m_s) " m/s" } td.number { (point.slide_roll_percent) " %" }
            td.number { (format!("{:.4}", point.expected_traction)) } td.number { (format!("{:.1}", point.film_ratio)) }
        } } }
    } } }
}
