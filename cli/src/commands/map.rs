//! `asperity map`: losses over torque, speed and temperature.

use std::path::{Path, PathBuf};
use std::time::Instant;

use asperity::case::train::Train;
use asperity::pipeline::KeptFields;
use asperity_core::{Code, Fault};
use asperity_studies::compare::Finish;
use asperity_studies::cycle::CyclePoint;
use asperity_studies::export::{self, AddedLoss, Format, With};
use asperity_studies::map::{self, Map, MapExtras, MapSettings};

use super::cycle::{read_cycle, table_in};
use super::finish::{self, check_names};
use super::study::of_option;
use super::work::check_work;
use super::{load_train, result_name, stem, study};
use crate::args::{Common, MapArgs};
use crate::failure::Failure;
use crate::output::{Progress, READING, WRITING};

/// `asperity map`
pub fn map(args: &MapArgs, common: &Common) -> Result<(), Failure> {
    let begin = Instant::now();
    check_names(&args.finishes)?;
    let progress = Progress::of(common.quiet, READING);
    let finishes = finishes(args)?;
    let Some(first) = finishes.first() else {
        return Err(Failure::new(Code::E501, "a map without a finish"));
    };
    let names: Vec<&str> = finishes.iter().map(|finish| finish.name.as_str()).collect();
    for format in &args.export {
        export::check_names(&names, *format).map_err(|error| not_exported(*format, error))?;
    }
    let settings = &args.settings;
    let axes = settings
        .axes(&first.case)
        .map_err(of_option::<MapSettings>)?;
    let cycle = match &args.cycle {
        Some(file) => Some(read_cycle(file, None, first.case.input.vehicle.as_ref())?),
        None => None,
    };
    if args.export.contains(&Format::Fastsim) && cycle.is_none() {
        let message = "--export fastsim writes one number, weighted by a cycle; pass --cycle";
        return Err(Failure::new(Code::E205, message));
    }
    let visited: Vec<[f64; 2]> = cycle
        .iter()
        .flat_map(|cycle| &cycle.points)
        .map(CyclePoint::forwards)
        .collect();
    let (name, title) = (result_name(&args.case), &first.case.title);
    let folder = study::folder::<Map>(args.output.as_deref(), &name, "map", title)?;
    let added = args.add_loss.as_deref().map(added_loss).transpose()?;
    let torques = match first.case.shafting.passes_losses {
        true => 2 * axes.torque_nm.len(),
        false => axes.torque_nm.len().div_ceil(2),
    };
    let torques = torques * finishes.len();
    check_work(
        &args.work,
        first.case.cases(),
        &KeptFields::Highest,
        torques,
    )?;
    progress.begin("points");
    let watch = |done, total| progress.at(done, total);
    let mut map = map::map(&finishes, &axes, settings.band, &watch)
        .map_err(|error| Failure::about(&args.case, &error))?;
    if let Some(code) = map.refused() {
        let message = "no point of the map has a loss";
        let advice = "Run the case at one of its points: asperity run names the cause.";
        return Err(Failure::new(code, message).advising(advice));
    }
    progress.begin(WRITING);
    let with = With {
        added: added.as_ref(),
        cycle: cycle.as_ref(),
        beside: Some(&folder),
    };
    let exports = exports(args, &map, with)?;
    map.table_warnings = with.warnings();
    let extras = MapExtras {
        visited: &visited,
        exports: &exports,
    };
    study::write(&map, extras, &folder)?;
    drop(progress);
    study::print(&map, extras, Some(&folder), Some(begin), common)
}

/// Files of all requested formats.
fn exports(args: &MapArgs, map: &Map, with: With<'_>) -> Result<Vec<(PathBuf, Vec<u8>)>, Failure> {
    let mut files = Vec::new();
    for format in &args.export {
        let exported = export::export(map, *format, with);
        let exported = exported.map_err(|error| not_exported(*format, error))?;
        files.extend(exported.into_iter().map(|file| (file.name, file.bytes)));
    }
    Ok(files)
}

fn not_exported(format: Format, error: Fault) -> Fault {
    error
        .about(format!("--export {}", name_of_value(format)))
        .helping("The map itself can be computed without --export; a format may need other axes.")
}

fn added_loss(file: &Path) -> Result<AddedLoss, Failure> {
    let text = table_in(file)?;
    let short = file.file_name().unwrap_or_default().to_string_lossy();
    let added = AddedLoss::read(&short, &text);
    Ok(added.map_err(|error| {
        let message = format!("--add-loss {error}");
        Fault::new(error.code(), message).helping(error.help())
    })?)
}

/// Name of a format on the command line.
fn name_of_value(format: Format) -> String {
    let value = clap::ValueEnum::to_possible_value(&format);
    value.map_or_else(String::new, |value| value.get_name().to_owned())
}

/// The case with the traces of each finish, or with its own traces.
fn finishes(args: &MapArgs) -> Result<Vec<Finish<Train>>, Failure> {
    if !args.finishes.is_empty() {
        return finish::finishes(&args.case, &args.set, &args.finishes, &|_| {});
    }
    let case = load_train(&args.case, &args.set, None)?;
    let name = stem(&args.case).to_string_lossy().into_owned();
    Ok(vec![Finish { name, case }])
}
