//! Report of a call-out: the limit, how it follows from the number of traces, and the loss by the height of the flanks.

use asperity::result::loss_band::rounded;
use asperity_core::quantity::Power;
use asperity_report::chart::{Axis, Chart, Drawing, Line, Mark, Series, TextureSymbol};
use asperity_report::{Cell, Report, StudyResult, Table, columns};

use super::study::{CallOut, CurvePoint, LimitRow, ParameterRow};

/// Explanation of the numbers.
const NOTE: &str = "A lot is a set of flanks of the recipe of the traces. It meets the loss if the mean over 16 pairs of its \
    flanks is at most the permitted loss, with constants at their medians. Heights, wavelengths and peaks of a flank scatter about the \
    median of its lot, wavelengths and peaks of a lot about the recipe. Nothing is assumed of the height of a lot before its \
    inspection. These are answers of the model, not \
    measurements.";

/// Standard of the symbol with its edition.
const EDITION: &str = "ISO 21920-1:2021";
/// Explanation of the symbol.
const SYMBOL: &str = "The symbol has the form of ISO 21920-1:2021: upper limit, parameter, limit in µm, then the S-filter and the \
    L-filter, each with type (G: Gaussian) and nesting index in mm. The standard has no sign for the mean of several traces, so \
    that is a note. A drawing by ISO 1302:2002 has the filters before the parameter.";

impl StudyResult for CallOut {
    const KIND: &'static str = "call-out";
    const NAME: &'static str = "callout";

    fn report(&self) -> Report<'_> {
        Report::new(&self.title, "call-out")
            .section("Limit")
            .verdict(self.limits.iter().map(limit_line).chain([headline(self)]))
            .text([OF_LOTS])
            .on_page()
            .text([inspection(self)])
            .figures(|| self.limits.iter().map(|row| symbol(self, row)))
            .figures(|| [curve_chart(self)])
            .text([conditions(self)])
            .text([losses(self)])
            .text([precision(self)])
            .text(above(self))
            .on_page()
            .table(table(self))
            .section("By the number of traces")
            .figures(|| [traces_chart(self)])
            .method([NOTE, SYMBOL])
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
        Axis::new("limit over these flanks", ""),
    );
    let chart = Chart::new("traces", &title, "traces.csv", x, y);
    let points = study.by_traces.iter();
    let points = points.map(|row| [row.traces as f64, row.limit_over_recipe]);
    Drawing::Curves(chart.with(Series::through("limit", Line::Dots, points)))
}

/// Loss by the height, with the scatter of the lots.
fn curve_chart(study: &CallOut) -> Drawing {
    let (x, y) = (
        Axis::new("height over the present height of these flanks", ""),
        Axis::new("loss", "W"),
    );
    let title = "Loss by the height of the flanks, shaded 5 to 95 % of the lots before inspection";
    let of =
        |value: fn(&CurvePoint) -> f64| -> Vec<f64> { study.curve.iter().map(value).collect() };
    let heights = of(|point| point.height);
    let points = study.curve.iter();
    let band =
        points.filter_map(|point| Some([point.height, point.loss_p05_w?, point.loss_p95_w?]));
    let band: Vec<[f64; 3]> = band.collect();
    let [of_band, low, high] =
        [0, 1, 2].map(|k| band.iter().map(|row| row[k]).collect::<Vec<f64>>());
    let mut chart = Chart::new("curve", title, "curve.csv", x, y)
        .curve(
            "mean of lots like these flanks",
            Line::Dots,
            &heights,
            &of(|point| point.loss_w),
        )
        .with(Series::band_of(
            0,
            "5 to 95 % of the lots, up to the heights that bound it",
            &of_band,
            &low,
            &high,
        ))
        .level(study.loss_w, "permitted loss");
    chart = chart.marked(&[
        Mark {
            at: study.height_at_limit,
            label: "limit".to_owned(),
        },
        Mark {
            at: 1.0,
            label: "these flanks".to_owned(),
        },
    ]);
    Drawing::Curves(chart)
}

/// The call-out as it stands on a drawing.
fn symbol(study: &CallOut, row: &LimitRow) -> Drawing {
    let filter = |um: f64| format!("G {}", number(um * 1e-3));
    let [filters, only] = match study.wavelengths_um {
        [Some(short), Some(long)] => [
            format!(" {} {}", filter(short), filter(long)),
            String::new(),
        ],
        // A single filter of the line would not say which it is.
        [Some(short), None] => [String::new(), format!("S-filter {}, ", filter(short))],
        [None, Some(long)] => [String::new(), format!("L-filter {}, ", filter(long))],
        [None, None] => Default::default(),
    };
    let traces = match study.traces {
        1 => "one trace".to_owned(),
        count => format!("mean of {count} traces"),
    };
    let note = format!("{only}{traces}, {EDITION}");
    Drawing::Symbol(TextureSymbol {
        id: format!("symbol-{}", row.flank),
        title: format!("{} on the drawing", flank_of(row)),
        source: "limits.csv".to_owned(),
        requirement: format!("U {} {}{filters}", row.parameter, limited(row.limit)),
        note,
    })
}

/// A number without zeros at its end.
fn number(value: f64) -> String {
    let text = rounded(value, 0.05 * value);
    if text.contains('.') {
        text.trim_end_matches('0').trim_end_matches('.').to_owned()
    } else {
        text
    }
}

/// The loss that the limit permits.
fn headline(study: &CallOut) -> String {
    format!(
        "Of the lots whose mean is at the limit, {:.0} % lose at most {}. Every constant is at its median, and no flank is run in.",
        100.0 * study.confidence,
        match &study.change {
            None => Power::from_si(study.loss_w).to_string(),
            Some(change) => format!(
                "{} ({change} than flanks like these)",
                power(study, study.loss_w)
            ),
        }
    )
}

fn conditions(study: &CallOut) -> String {
    format!(
        "At {}. The heights of a lot scatter by {:.0} %.",
        study.conditions,
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
    format!(
        "{}: mean {} at most {}{unit} (flanks like these have {}{unit}).",
        flank_of(row),
        row.parameter,
        limited(row.limit),
        limited(row.recipe)
    )
}

/// A value of the parameter with the digits that the scatter leaves.
fn limited(value: f64) -> String {
    rounded(value, SCATTER * value)
}

/// Name of the flank of a limit.
fn flank_of(row: &LimitRow) -> &'static str {
    match row.flank {
        "both" => "Both flanks",
        "pinion" => "Pinion",
        _ => "Wheel",
    }
}

/// Flanks to inspect, and the wavelengths of their traces.
fn inspection(study: &CallOut) -> String {
    let of = match study.limits.len() {
        1 => "of a lot, of pinions or wheels",
        _ => "of each gear of a lot",
    };
    let [plural, decisive] = match study.traces {
        1 => ["", "Its value"],
        _ => ["s", "The mean of the traces"],
    };
    let um = |value: f64| format!("{} µm", number(value));
    let band = match study.wavelengths_um {
        [Some(short), Some(long)] => format!("wavelengths {} to {}", um(short), um(long)),
        [None, Some(long)] => format!("wavelengths up to {}", um(long)),
        [Some(short), None] => format!("wavelengths from {}", um(short)),
        [None, None] => "all wavelengths of the traces".to_owned(),
    };
    format!(
        "Inspect {} flank{plural} {of}, with one trace on each, {band}. {decisive} decides.",
        study.traces
    )
}

/// Error of the limits by the number of lots.
fn precision(study: &CallOut) -> String {
    let error = |row: &LimitRow| row.standard_error / row.limit;
    let largest = study.limits.iter().map(error).fold(0.0, f64::max);
    format!(
        "The {} simulated lots leave a standard error of {:.0} % in the limit.",
        study.lots,
        100.0 * largest
    )
}

/// Losses at the limit, of the recipe and of smooth flanks.
fn losses(study: &CallOut) -> String {
    format!(
        "Mean loss of lots: {} at the limit, {} with flanks like these, {} with smooth flanks. The two traces of the case are one \
        sample of such flanks; their own loss differs.",
        power(study, study.mean_loss_w),
        power(study, study.recipe_loss_w),
        power(study, study.smooth_loss_w)
    )
}

/// Uncertainty that the share of the lots leaves out.
const OF_LOTS: &str = "This share of the lots does not contain the uncertainty of the model. The command asperity run states its interval.";

/// Upper end of the band at the limit, if it is above the permitted loss.
fn above(study: &CallOut) -> Option<String> {
    let height = study.height_at_limit;
    let ends: Vec<[f64; 2]> = study
        .curve
        .iter()
        .filter_map(|point| Some([point.height, point.loss_p95_w?]))
        .collect();
    let mut pairs = ends.iter().zip(ends.iter().skip(1));
    let (below, above) = pairs.find(|(below, above)| (below[0]..=above[0]).contains(&height))?;
    let part = (height - below[0]) / (above[0] - below[0]);
    let high = below[1] + part * (above[1] - below[1]);
    (high > study.loss_w).then(|| {
        format!(
            "The shaded band at the limit ends above the permitted loss: before inspection 5 % of the lots of this height lose more than {}.",
            power(study, high)
        )
    })
}

/// A loss with the digits that the scatter leaves of the largest one.
fn power(study: &CallOut, loss_w: f64) -> String {
    let largest = study.recipe_loss_w.max(study.loss_w);
    format!("{} W", rounded(loss_w, SCATTER * largest))
}

/// The limit by every parameter, with the standard deviations of ln(limit) and of single traces about their flank.
fn table(study: &CallOut) -> Table {
    let error = |row: &ParameterRow| row.deviation / (study.lots as f64).sqrt();
    let table = columns! { row in &study.parameters;
        head parameter "parameter" "";
        number traces "traces" "";
        number limit_over_recipe "limit over these flanks" "" = Cell::from(rounded(row.limit_over_recipe, 1.4 * error(row)));
        percent deviation "standard deviation of the limit" "%" "{:.0}";
        percent of_traces "standard deviation of single traces" "%" "{:.0}";
    };
    table.of_file("parameters.csv")
}
