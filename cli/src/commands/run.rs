//! `asperity run`: runs a case.

use std::path::{Path, PathBuf};
use std::time::Instant;

use asperity::case::planetary::LoadedPlanetary;
use asperity::planetary::{PlanetaryResult, run_planetary};
use asperity::result::RunResult;
use asperity::{Error, Run};
use asperity_report::{self as report, Fields};

use super::bibtex::bibtex;
use super::work::{check_work, check_work_of_set};
use super::{AnyCase, load_any, stem};
use crate::args::{Common, RunArgs};
use crate::failure::Failure;
use crate::output::{Progress, READING, WRITING, print_json, print_text, shown};

/// Counted work of a run.
const POSITIONS: &str = "mesh positions";

/// `asperity run`
pub fn run(args: &RunArgs, common: &Common) -> Result<(), Failure> {
    let begin = Instant::now();
    let fields = fields(args)?;
    let progress = Progress::of(common.quiet, READING);
    let loaded = match load_any(&args.case, &args.set, args.formulation)? {
        AnyCase::Pair(loaded) => loaded,
        AnyCase::Set(set) => return run_set(&set, args, common, &fields, (begin, progress)),
    };
    check_work(&args.work, &loaded, &fields.kept(), 1)?;
    let folder = (!args.no_output).then(|| result_folder(args));
    if let Some(folder) = &folder {
        // Told before the work, not after it.
        report::check_place(folder)?;
    }
    progress.begin(POSITIONS);
    let at = |done, total| progress.at(done, total);
    let outcome = Run::new(&loaded)
        .fields(&fields.kept())
        .band(!args.no_band)
        .progress(&at)
        .execute();
    let outcome = outcome.map_err(|error| failed(&error, args, folder.as_deref()))?;
    if let Some(folder) = &folder {
        progress.begin(WRITING);
        report::write_folder(&outcome, folder, &fields)?;
        if args.load_map {
            report::write_load_points(&outcome, folder)?;
        }
    }
    drop(progress);
    if common.json {
        return print_json(&outcome.result);
    }
    if args.cite {
        return print_text(common, &bibtex(&outcome.result));
    }
    print_text(
        common,
        &text(&outcome.result, args, folder.as_deref(), begin),
    )
}

/// Runs both kinds of meshes of a planetary set.
fn run_set(
    set: &LoadedPlanetary,
    args: &RunArgs,
    common: &Common,
    fields: &Fields,
    (begin, progress): (Instant, Progress),
) -> Result<(), Failure> {
    check_work_of_set(&args.work, set, &fields.kept())?;
    let folder = (!args.no_output).then(|| result_folder(args));
    if let Some(folder) = &folder {
        report::check_planetary_place(folder)?;
    }
    progress.begin(POSITIONS);
    let outcome = run_planetary(set, &fields.kept(), &|done, total| progress.at(done, total));
    let outcome = outcome.map_err(|error| failed(&error, args, folder.as_deref()))?;
    if let Some(folder) = &folder {
        progress.begin(WRITING);
        report::write_planetary(&outcome, folder, fields)?;
    }
    drop(progress);
    if common.json {
        return print_json(&outcome.result);
    }
    let mut text = text_of_set(&outcome.result);
    let seconds = begin.elapsed().as_secs_f64();
    text.push_str(&match &folder {
        Some(folder) => format!("wrote {} in {seconds:.1} s\n", shown(folder)),
        None => format!("in {seconds:.1} s\n"),
    });
    print_text(common, &text)
}

fn text_of_set(result: &PlanetaryResult) -> String {
    let [loss, efficiency] = result.with_bands();
    let mut text = format!(
        "{}\nefficiency (meshes only)  {efficiency} %   loss {loss} W\n  power in {:.2} kW\n\
         {} planets   carrier {:.1} 1/min   power through the meshes {:.2} kW\n\
         {:<16} {:>10} {:>10} {:>12} {:>8} {:>8} {:>9}\n",
        asperity_storage::one_line(&result.title),
        1e-3 * result.power_in_w,
        result.planets,
        result.carrier_rad_per_s * 30.0 / std::f64::consts::PI,
        1e-3 * result.rolling_power_w,
        "mesh",
        "T N m",
        "loss W",
        "efficiency",
        "H_V",
        "mu_eq",
        "p0 MPa",
    );
    for row in &result.meshes {
        let [loss, efficiency, mu] = row.with_digits();
        text.push_str(&format!(
            "{:<16} {:>10.3} {loss:>10} {efficiency:>10} % {:>8.4} {mu:>8} {:>9.0}\n",
            row.mesh, row.torque_nm, row.loss_factor, row.hertz_pressure_mpa,
        ));
    }
    if !result.can_be_equally_spaced {
        text.push_str("equally spaced planets cannot be assembled with these tooth numbers\n");
    }
    text
}

fn text(result: &RunResult, args: &RunArgs, folder: Option<&Path>, begin: Instant) -> String {
    let mut text = match args.notes {
        true => report::summary(result),
        false => report::brief(result),
    };
    if args.models {
        text.push_str(&report::models(result));
    }
    if args.laws {
        text.push_str(&report::published_laws(result));
    }
    if args.explain_defaults {
        text.push_str("defaults used\n");
        for default in &result.defaults {
            let source = default
                .source
                .as_deref()
                .map(|s| format!("  ({s})"))
                .unwrap_or_default();
            text.push_str(&format!("  {} = {}{source}\n", default.key, default.value));
        }
    } else {
        text.push_str(&format!(
            "defaults used: {} (--explain-defaults)\n",
            result.defaults.len()
        ));
    }
    let seconds = begin.elapsed().as_secs_f64();
    match folder {
        Some(folder) => {
            text.push_str(&format!("wrote {} in {seconds:.1} s\n", shown(folder)));
        }
        None => text.push_str(&format!("in {seconds:.1} s\n")),
    }
    text
}

/// The fields to keep, as `all` or as numbers of positions.
fn fields(args: &RunArgs) -> Result<Fields, Failure> {
    let Some(text) = args.fields.as_deref() else {
        return Ok(Fields::Page);
    };
    if text.trim() == "all" {
        return Ok(Fields::All);
    }
    let numbers = text.split(',').map(|number| number.trim().parse());
    match numbers.collect::<Result<Vec<usize>, _>>() {
        Ok(numbers) if !numbers.contains(&0) => Ok(Fields::Positions(numbers)),
        _ => Err(Failure::new(
            "E209",
            format!("--fields {text}: must be all, or numbers of positions, e.g. 1,5"),
        )),
    }
}

/// Error of a run; a contact without solution is saved next to the result folders.
fn failed(error: &Error, args: &RunArgs, folder: Option<&Path>) -> Failure {
    let failure = Failure::about(&args.case, error);
    if let (Some(contact), Some(folder)) = (error.unsolved(), folder) {
        let name = folder.file_name().unwrap_or_default();
        let file = folder
            .with_file_name("failed")
            .join(name)
            .with_extension("csv");
        return match report::write_unsolved(contact, &file) {
            Ok(()) => failure.adding(&format!(
                ". Fields saved in {}; asperity contact --gap solves only the contact",
                file.display()
            )),
            Err(error) => failure.adding(&format!(". Its fields could not be saved: {error}")),
        };
    }
    failure
}

fn result_folder(args: &RunArgs) -> PathBuf {
    args.output
        .clone()
        .unwrap_or_else(|| Path::new("results").join(stem(&args.case)))
}
