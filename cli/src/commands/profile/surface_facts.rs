//! Facts that were read from a surface file, with its areal parameters.

use std::path::Path;

use asperity::flanks::sheets::LEAST_ROWS;
use asperity_core::by_size;
use asperity_core::quantity::Length;
use asperity_profile_io::read::{Format, Surface};
use asperity_report::Report;
use asperity_report::profile_json::{height, um};
use asperity_roughness::areal::{ArealParameters, parameters};
use asperity_roughness::lay::{RowLay, lay_of_rows};
use serde_json::json;

use super::case_lines::case_lines;
use super::evaluated::{Note, opened_surface};
use super::file_facts::rounded;
use super::plan::PreparationPlan;
use crate::args::{Common, ProfileInfoArgs};
use crate::failure::Failure;
use crate::output::print_report;

/// Prints facts and parameters of the surface in a file, from which no trace was chosen; `failure` says how to choose one.
///
/// Returns whether there is something to print: traces of a file need not be a surface.
pub(super) fn print(
    file: &Path,
    args: &ProfileInfoArgs,
    common: &Common,
    failure: &Failure,
) -> Result<bool, Failure> {
    let Ok(surface) = opened_surface(file, &args.reading) else {
        return Ok(false);
    };
    let areal = evaluated(&surface);
    let lay = measured_lay(&surface, &PreparationPlan::from_args(&args.preparing)?);
    let spacing = |spacing: Option<Length>| {
        spacing.map_or("unknown".to_owned(), |length| rounded(length).to_string())
    };
    let read = format!(
        "{}, {} rows of {} points, dx {}, dy {}; {} points are missing",
        surface.format,
        surface.rows,
        surface.columns,
        spacing(surface.dx),
        spacing(surface.dy),
        surface.z.len() - surface.measured()
    );
    let areal_lines = match &areal {
        Ok(areal) => written(areal).to_vec(),
        Err(reason) => vec![format!("no areal parameters: {reason}")],
    };
    let lay_line = match &lay {
        Ok(lay) => {
            let [low, high] = lay.range;
            let bound = if lay.is_bound {
                ", longer ridges than half of the surface"
            } else {
                ""
            };
            format!(
                "lay of traces along the rows {:.3} ({low:.3} to {high:.3}{bound}), which a case takes from the file",
                lay.gamma
            )
        }
        Err(reason) => format!("lay of traces along the rows unknown: {reason}"),
    };
    // A case takes a scan whole: its lay decides between its rows and patches. Of few rows, or without both spacings, it takes rows.
    let is_scan = surface.dx.is_some() && surface.dy.is_some() && surface.rows >= LEAST_ROWS;
    let rows = (args.reading.line.is_none() && !is_scan).then_some(surface.rows);
    let json = || {
        let mut facts = json!({
            "file": surface.name,
            "format": surface.format,
            "columns": surface.columns,
            "rows": surface.rows,
            "dx_um": surface.dx.map(um),
            "dy_um": surface.dy.map(um),
            "missing": surface.z.len() - surface.measured(),
            "areal": areal.as_ref().ok(),
            "lay": lay.as_ref().ok(),
            "warnings": surface.warnings,
        });
        facts["error"] = failure.json()["error"].clone();
        facts
    };
    let report = || {
        Report::new(&surface.name, "")
            .verdict([read])
            .text(areal_lines)
            .text([lay_line])
            .warning(surface.warnings.iter().map(|warning| {
                let note = Note::Read(warning);
                format!("{} {note}", note.code())
            }))
            .code(case_lines(file, args, args.preparing.lambda_c, rows))
    };
    print_report(common, json, report, None).map(|()| true)
}

/// The spacings of points and rows, or the options that state the unknown ones.
pub(super) fn spacings(surface: &Surface) -> Result<[Length; 2], String> {
    if let (Some(dx), Some(dy)) = (surface.dx, surface.dy) {
        return Ok([dx, dy]);
    }
    if surface.format == Format::PointText {
        return Err("no unit of the positions was found in the file, pass --x-unit".to_owned());
    }
    let unknown = [("points", "--dx", surface.dx), ("rows", "--dy", surface.dy)];
    let unknown = unknown.iter().filter(|(.., known)| known.is_none());
    let [of, options] = [0, 1].map(|part| {
        let words = unknown.clone().map(|(of, option, _)| [*of, *option][part]);
        words.collect::<Vec<_>>().join(" and ")
    });
    Err(format!(
        "no spacing of {of} was found in the file, pass {options}"
    ))
}

/// The areal parameters, or why there are none.
fn evaluated(surface: &Surface) -> Result<ArealParameters, String> {
    parameters(&surface.z, surface.columns, spacings(surface)?).map_err(|error| error.to_string())
}

/// The lay of traces along the rows, prepared by the options, or why it is not known.
fn measured_lay(surface: &Surface, plan: &PreparationPlan) -> Result<RowLay, String> {
    match lay_of_rows(
        &surface.z,
        surface.columns,
        spacings(surface)?,
        &plan.recipe,
        plan.filter,
    ) {
        Ok(Ok(lay)) => Ok(lay),
        Ok(Err(unknown)) => Err(unknown.to_string()),
        Err(error) => Err(error.to_string()),
    }
}

/// Height parameters and slopes on one line.
pub(super) fn areal_line(areal: &ArealParameters) -> String {
    let shape = |value: Option<f64>| value.map_or("none".to_owned(), |v| format!("{v:.3}"));
    format!(
        "Sa {} Sq {} Sp {} Sv {} Sz {} um, Ssk {} Sku {}, Sdq {}, Sdr {} %",
        height(areal.sa),
        height(areal.sq),
        height(areal.sp),
        height(areal.sv),
        height(areal.sz),
        shape(areal.ssk),
        shape(areal.sku),
        by_size(areal.sdq, 4),
        by_size(100.0 * areal.sdr, 3)
    )
}

/// The standard, the parameters, and the texture.
fn written(areal: &ArealParameters) -> [String; 3] {
    let standard = "ISO 25178-2, over the least-squares plane, without filters:".to_owned();
    [standard, areal_line(areal), texture_line(areal)]
}

fn texture_line(areal: &ArealParameters) -> String {
    let Some(texture) = &areal.texture else {
        return "no Sal, Str, Std: the surface is flat or has too many points".to_owned();
    };
    let sal = texture
        .sal
        .map_or("none".to_owned(), |length| rounded(length).to_string());
    let ratio = match (texture.str, texture.str_at_most) {
        (Some(ratio), _) => format!("{ratio:.3}"),
        (None, Some(most)) => {
            format!("below {most:.3} (correlated over the whole surface along the lay)")
        }
        (None, None) => "none".to_owned(),
    };
    format!(
        "Sal {sal}, Str {ratio}, Std {:.1} deg, across the lay",
        texture.std_degrees
    )
}
