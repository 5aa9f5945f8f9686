//! `asperity ehl`: mixed elastohydrodynamic contact of a case at one position.

mod laws;
mod page;
mod rough;
mod smooth;

use asperity::Run;
use asperity::ehl::RecordSettings;
use asperity::ehl::traction::Heat;
use asperity::lubrication::shares;
use asperity::reference_solution::{Inlet, ReferenceContact, ReferenceSettings};
use asperity_core::Fault;
use asperity_report::Report;

use super::{load_case, on_the_path};
use crate::args::{Common, EhlArgs};
use crate::failure::Failure;
use crate::output::{besides_file, print_report, save};

/// `asperity ehl`
pub fn ehl(args: &EhlArgs, common: &Common) -> Result<(), Failure> {
    let common = &match &args.output {
        Some(output) => besides_file(output, common)?,
        None => common.clone(),
    };
    let path = &args.case;
    let loaded = load_case(path, &args.set, None)?;
    let loaded = Run::new(&loaded).operating_case();
    let loaded = loaded.map_err(|error| Failure::about(path, &error))?;
    let position = on_the_path(&loaded, args.position)?.unwrap_or(loaded.case.paper.position);
    let settings = ReferenceSettings {
        record: record_settings(args),
        eyring_stress: args.eyring_stress,
        with_heat: true,
        beginning: 0,
        shortest_wave: args.shortest_wave,
        inlet: Inlet::ByLoad,
    };
    let about = |error| Fault::from(error).about(path.display());
    let contact = ReferenceContact::new(&loaded, position, &settings).map_err(about)?;
    let title = format!(
        "{}, at {:.1} % of the path",
        loaded.case.title,
        100.0 * position
    );
    if args.smooth {
        let heat = Heat {
            bulk: loaded.temperature(),
            temperature_coefficient: loaded.oil().temperature_coefficient,
            oil_conductivity: loaded.oil().thermal_conductivity,
            material: loaded.case.materials[0],
        };
        let friction = contact.record.friction;
        let film = smooth::solve(title, &contact.rough, friction, heat, args.cells)?;
        report(args, || film.page(&contact.rough))?;
        return print_result(args, common, &film.json(), film.report(), &|| film.points());
    }
    let record = rough::solve(title, &contact, args, common)?;
    report(args, || record.page(&contact.rough))?;
    let comparison = if args.compare {
        Some(shares(&loaded, &contact, &record.solved.value).map_err(about)?)
    } else {
        None
    };
    let comparison = comparison.as_ref();
    let (json, report) = (record.json(comparison), record.report(comparison));
    print_result(args, common, &json, report, &|| record.points())
}

fn record_settings(args: &EhlArgs) -> RecordSettings {
    RecordSettings {
        cells: args.cells,
        start: args.start,
        length: args.half_widths,
        solid_film: args.solid_film,
        contact_film: args.contact_film,
        history: true,
        frame_interval: frame_interval(args),
        ..RecordSettings::default()
    }
}

/// Travel between frames: small for the animation of a page, large for a table of points.
fn frame_interval(args: &EhlArgs) -> Option<f64> {
    const OF_PAGE: f64 = 0.1;
    const OF_POINTS: f64 = 5.0;
    let default = match (&args.report, &args.output) {
        (Some(_), None) => OF_PAGE,
        (_, Some(_)) => OF_POINTS,
        (None, None) => return None,
    };
    Some(args.every.unwrap_or(default))
}

/// Writes the page if requested.
fn report(args: &EhlArgs, page: impl FnOnce() -> Result<String, Failure>) -> Result<(), Failure> {
    match &args.report {
        Some(file) => save(file, page()?.as_bytes()),
        None => Ok(()),
    }
}

/// Writes the points if requested, and prints the result.
fn print_result(
    args: &EhlArgs,
    common: &Common,
    json: &serde_json::Value,
    report: Report<'_>,
    points: &dyn Fn() -> String,
) -> Result<(), Failure> {
    if let Some(output) = &args.output {
        save(output, points().as_bytes())?;
    }
    print_report(common, || json, || report, None)
}
