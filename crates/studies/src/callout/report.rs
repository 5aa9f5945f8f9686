//! Report of a call-out: the limit, how it follows from the number of traces, and the loss by the height of the flanks.

use asperity::result::loss_band::rounded;
use asperity_core::quantity::Power;
use asperity_report::chart::{Axis, Chart, Drawing, Line, Series};
use asperity_report::{Cell, Report, StudyResult, Table, columns};

use super::error::watts;
use super::study::{CallOut, LimitRow, ParameterRow};

/// Explanation of the numbers.
const NOTE: &str = "A lot is a set of flanks of the recipe of the traces; it meets the loss if the mean over 16 pairs of its \
    flanks, constants at their medians, is at most the stated loss. Heights, wavelengths and peaks of a flank scatter about the \
    median of its lot, wavelengths and peaks of a lot about the recipe. Nothing is assumed of the height of a lot before its \
    inspection. Running-in and the uncertainty of the constants are not in it. These are answers of the model, not \
    measurements.";

impl StudyResult for CallOut {
    const KIND: &'static str = "call-out";
    const NAME: &'static str = "callout";

    fn report(&self) -> Report<'_> {
        Report::new(&self.title, "call-out")
            .section("Limit")
            .text([headline(self)])
            .verdict(self.limits.iter().map(limit_line))
            .figures(|| [curve_chart(self)])
            .text([inspection(self), losses(self)])
            .table(table(self))
            .section("By the number of traces")
            .figures(|| [traces_chart(self)])
            .method([NOTE])
            .rows("limits.csv", || &self.limits)
            .rows("parameters.csv", || &self.parameters)
            .rows("traces.csv", || &self.by_traces)
            .rows("curve.csv", || &self.curve)
    }
}

fn traces_chart(study: &CallOut) -> Drawing {
    let title = format!("Limit of the mean {}", study.parameter.symbol());
    let (x, y) = (
        Axis::new("inspected traces", "").log(),
        Axis::new("limit over recipe", ""),
    );
    let chart = Chart::new("traces", &title, "traces.csv", x, y);
    let points = study.by_traces.iter();
    let points = points.map(|row| [row.traces as f64, row.limit_over_recipe]);
    Drawing::Curves(chart.with(Series::through("limit", Line::Dots, points)))
}

fn curve_chart(study: &CallOut) -> Drawing {
    let (x, y) = (
        Axis::new("height of the flanks over the recipe", ""),
        Axis::new("mean loss of lots of the recipe", "W"),
    );
    let title = "Loss by the height of the flanks";
    let points = study.curve.iter().map(|point| [point.height, point.loss_w]);
    let chart = Chart::new("curve", title, "curve.csv", x, y)
        .with(Series::through("loss", Line::Dots, points))
        .level(study.loss_w, "stated loss");
    Drawing::Curves(chart)
}

fn headline(study: &CallOut) -> String {
    format!(
        "{} in {:.0} % of the lots at the limit; scatter {:.0} %.",
        Power::from_si(study.loss_w),
        100.0 * study.confidence,
        100.0 * study.scatter
    )
}

/// Relative scatter of the height of a lot about a limit by inspection, which leaves the digits of the limit.
const SCATTER: f64 = 0.08;

/// Limit of a flank.
fn limit_line(row: &LimitRow) -> String {
    let unit = match row.unit {
        "" => "",
        _ => " µm",
    };
    let flank = match row.flank {
        "both" => "Both flanks".to_owned(),
        "pinion" => "Pinion".to_owned(),
        _ => "Wheel".to_owned(),
    };
    let text = |value: f64| rounded(value, SCATTER * value);
    format!(
        "{flank}: mean {} at most {}{unit} (the recipe has {}{unit}).",
        row.parameter,
        text(row.limit),
        text(row.recipe)
    )
}

/// Traces and wavelengths.
fn inspection(study: &CallOut) -> String {
    let of_each = match study.limits.len() {
        1 => "",
        _ => " of each gear",
    };
    let plural = if study.traces == 1 { "" } else { "s" };
    let um = |value: f64| {
        let text = rounded(value, 0.05 * value);
        let digits = match text.contains('.') {
            true => text.trim_end_matches('0').trim_end_matches('.'),
            false => &text,
        };
        format!("{digits} µm")
    };
    let band = match study.wavelengths_um {
        [Some(short), Some(long)] => format!("wavelengths {} to {}", um(short), um(long)),
        [None, Some(long)] => format!("wavelengths up to {}", um(long)),
        [Some(short), None] => format!("wavelengths from {}", um(short)),
        [None, None] => "all wavelengths of the traces".to_owned(),
    };
    format!(
        "Inspect {} trace{plural}{of_each}, each on another flank; {band}.",
        study.traces
    )
}

/// Losses at the limit, of the recipe and of smooth flanks.
fn losses(study: &CallOut) -> String {
    format!(
        "Mean loss: {} at the limit, {} with the recipe, {} with smooth flanks.",
        watts(study.mean_loss_w),
        watts(study.recipe_loss_w),
        watts(study.smooth_loss_w)
    )
}

/// The limit by every parameter, with the standard deviations of ln(limit) and of single traces about their flank.
fn table(study: &CallOut) -> Table {
    let error = |row: &ParameterRow| row.deviation / (study.lots as f64).sqrt();
    let table = columns! { row in &study.parameters;
        head parameter "parameter" "";
        number traces "traces" "";
        number limit_over_recipe "limit over recipe" "" = Cell::from(rounded(row.limit_over_recipe, 1.4 * error(row)));
        percent deviation "standard deviation of the limit" "%" "{:.0}";
        percent of_traces "standard deviation of single traces" "%" "{:.0}";
    };
    table.of_file("parameters.csv")
}
