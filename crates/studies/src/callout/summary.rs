//! Summary of a call-out for the terminal.

use asperity::result::loss_band::rounded;
use asperity_report::{Table, columns, wrapped};
use asperity_storage::one_line;

use super::error::watts;
use super::study::{CallOut, LimitRow, ParameterRow};

/// Explanation of the numbers.
pub(super) const NOTE: &str = "A lot is a set of flanks of the recipe of the traces; it meets the loss if the mean over 16 pairs of its \
    flanks, constants at their medians, is at most the stated loss. Heights, wavelengths and peaks of a flank scatter about the \
    median of its lot, wavelengths and peaks of a lot about the recipe. Nothing is assumed of the height of a lot before its \
    inspection. Running-in and the uncertainty of the constants are not in it. These are answers of the model, not \
    measurements.";

/// Summary of the study for the terminal.
pub(super) fn summary(study: &CallOut) -> String {
    let mut text = format!("{}\n{}\n", one_line(&study.title), headline(study));
    for limit in &study.limits {
        text.push_str(&format!("{}\n", limit_line(limit)));
    }
    text.push_str(&format!("{}\n", inspection(study)));
    text.push_str(&format!("{}\n\n", losses(study)));
    text.push_str(&table(study).text(""));
    text.push_str(&format!("{}\n", wrapped(NOTE, "")));
    text
}

pub(super) fn headline(study: &CallOut) -> String {
    format!(
        "{} in {:.0} % of the lots at the limit; scatter {:.0} %",
        asperity_core::quantity::Power::from_si(study.loss_w),
        100.0 * study.confidence,
        100.0 * study.scatter
    )
}

/// Limit of a flank with the digits that the simulated lots leave.
pub(super) fn limit_line(row: &LimitRow) -> String {
    let unit = match row.unit {
        "" => String::new(),
        unit => format!(" {unit}"),
    };
    let flank = match row.flank {
        "both" => "both flanks".to_owned(),
        flank => flank.to_owned(),
    };
    // The periodic profiles of a recipe leave a percent.
    let recipe = rounded(row.recipe, 0.01 * row.recipe);
    format!(
        "{flank}: mean {} at most {}{unit} (the recipe has {recipe}{unit})",
        row.parameter,
        rounded(row.limit, row.standard_error),
    )
}

/// Traces and wavelengths.
pub(super) fn inspection(study: &CallOut) -> String {
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
        format!("{digits} um")
    };
    let band = match study.wavelengths_um {
        [Some(short), Some(long)] => format!("wavelengths {} to {}", um(short), um(long)),
        [None, Some(long)] => format!("wavelengths up to {}", um(long)),
        [Some(short), None] => format!("wavelengths from {}", um(short)),
        [None, None] => "all wavelengths of the traces".to_owned(),
    };
    format!(
        "inspect {} trace{plural}{of_each}, each on another flank; {band}",
        study.traces
    )
}

/// Losses at the limit, of the recipe and of smooth flanks.
pub(super) fn losses(study: &CallOut) -> String {
    format!(
        "mean loss: {} at the limit, {} with the recipe, {} with smooth flanks",
        watts(study.mean_loss_w),
        watts(study.recipe_loss_w),
        watts(study.smooth_loss_w)
    )
}

/// The limit by every parameter, with the standard deviations of ln(limit) and of single traces about their flank.
pub(super) fn table(study: &CallOut) -> Table {
    let error = |row: &ParameterRow| row.deviation / (study.lots as f64).sqrt();
    columns! { row in &study.parameters;
        head parameter "parameter" "";
        number traces "traces" "";
        number limit "limit over recipe" "" = rounded(row.limit_over_recipe, 1.4 * error(row));
        number deviation "standard deviation of the limit" "%" "{:.0}" = 100.0 * row.deviation;
        number of_traces "standard deviation of single traces" "%" "{:.0}" = 100.0 * row.of_traces;
    }
}
