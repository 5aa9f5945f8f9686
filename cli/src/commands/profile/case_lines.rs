//! The lines of a case that read and prepare a file as the options did.

use std::path::Path;

use asperity_core::quantity::Length;
use asperity_core::remedy::Setting;
use asperity_profile_io::read::Columns;
use asperity_roughness::form::Form;
use serde_json::json;

use super::plan::form;
use crate::args::{FormArg, ProfileInfoArgs};

/// Rows of a surface that are taken as traces: with as many of the other flank, all 64 pairs that a run computes.
const USUAL_ROWS: usize = 8;

/// The table `surface` for the file and the options, with the cut-off λc of the evaluation; zero means unfiltered. The flank is
/// the pinion's unless the name of the file says that it is the wheel's. `rows` is the number of rows of a surface that
/// is not a scan, of which none was chosen.
pub(super) fn case_lines(
    file: &Path,
    args: &ProfileInfoArgs,
    lambda_c: Option<Length>,
    rows: Option<usize>,
) -> String {
    let (reading, preparing) = (&args.reading, &args.preparing);
    let text = |value: Option<String>| value.map(|value| json!(value).to_string());
    fn named<T: std::fmt::Display>(value: &Option<T>) -> Option<String> {
        value.as_ref().map(ToString::to_string)
    }
    let columns = |columns: Columns| match columns.x {
        Some(x) => format!("{{ x = {x}, z = {} }}", columns.z),
        None => format!("{{ z = {} }}", columns.z),
    };
    let options = [
        (Setting::XUnit, text(named(&reading.x_unit))),
        (Setting::ZUnit, text(named(&reading.z_unit))),
        (Setting::Spacing, text(named(&reading.dx))),
        (Setting::RowSpacing, text(named(&reading.dy))),
        (Setting::Columns, reading.columns.map(columns)),
        (Setting::Decimal, text(named(&reading.decimal))),
        (Setting::Separator, text(named(&reading.separator))),
        (Setting::Encoding, text(named(&reading.encoding))),
        (Setting::Gaps, text(named(&reading.gaps))),
        (Setting::Row, named(&reading.row)),
        (Setting::Line, text(named(&reading.line))),
        (
            Setting::Key("rows"),
            rows.map(|rows| rows.min(USUAL_ROWS).to_string()),
        ),
        (Setting::Abscissa, text(named(&reading.abscissa))),
        (Setting::Uneven, text(named(&reading.uneven))),
        (Setting::Range, text(named(&reading.range))),
        (Setting::Invert, named(&reading.invert)),
    ];
    let stated = options
        .into_iter()
        .filter_map(|(setting, value)| Some(format!(", {} = {}", setting.key(), value?)));
    let name = json!(file.display().to_string());
    let last = file.file_name().unwrap_or_default().to_string_lossy();
    let flank = if last.to_lowercase().contains("wheel") {
        "wheel"
    } else {
        "pinion"
    };
    let (form, is_unfiltered) = (form(preparing), preparing.as_is || preparing.level);
    let mut lines = format!(
        "  in a case:\n    [surface]\n    {flank} = {{ file = {name}{} }}\n",
        stated.collect::<String>()
    );
    if form != Form::default() && preparing.form != Some(FormArg::Involute) {
        lines += &format!("    {} = {}\n", Setting::Form.key(), json!(form));
    }
    if let Some(ends) = preparing.ends {
        lines += &format!("    ends = {}\n", json!(ends));
    }
    let lambda_s = preparing
        .lambda_s
        .or(is_unfiltered.then_some(Length::from_si(0.0)));
    let cutoffs = [
        (Setting::Cutoff, lambda_c),
        (Setting::NoiseCutoff, lambda_s),
    ];
    for (setting, length) in cutoffs {
        if let Some(length) = length {
            lines += &format!("    {} = \"{length}\"\n", setting.key());
        }
    }
    if let Some(outliers) = preparing.outliers {
        lines += &format!("    {} = {outliers}\n", Setting::Outliers.key());
    }
    lines
}
