//! `asperity cycle`: energy lost over a cycle, from a map.

use std::path::Path;

use asperity::case::VehicleInput;
use asperity::profile_io::read::read_table;
use asperity_core::number;
use asperity_core::{Code, Fault};
use asperity_studies::cycle::{self, Cycle, CycleError, CycleResult};
use asperity_studies::map::{self, Map};

use super::{keys, study};
use crate::args::{Common, CycleArgs};
use crate::failure::Failure;

/// Largest size of a cycle or a loss table in bytes.
pub const LARGEST_TABLE: u64 = 100_000_000;

/// `asperity cycle`
pub fn cycle(args: &CycleArgs, common: &Common) -> Result<(), Failure> {
    let mut map = read_map(&args.map)?;
    for (key, value) in keys(&args.set) {
        let set = map.input.set(&key, &value);
        set.map_err(|error| Failure::of(&error))?;
    }
    let temperature = temperature(args, &map)?;
    let trace = read_cycle(
        &args.trace,
        args.columns.as_deref(),
        map.input.vehicle.as_ref(),
    )?;
    let name = stem(&args.trace);
    let energies = cycle::evaluate(&map, temperature, (&trace, &name), args.allow_outside);
    let energies = energies.map_err(|error| refused(args, error))?;
    let target = || {
        let (map, title) = (stem(&args.map), &energies.title);
        study::folder::<CycleResult>(args.output.as_deref(), map.as_ref(), &name, title)
    };
    let folder = (!args.no_output).then(target).transpose()?;
    if let Some(folder) = &folder {
        study::write(&energies, &map, folder)?;
    }
    study::print(&energies, &map, folder.as_deref(), None, common)
}

fn refused(args: &CycleArgs, error: Fault) -> Failure {
    let (map, cycle) = (args.map.display(), args.trace.display());
    let both = format!("{cycle} on {map}");
    match error.code() {
        Code::E314 => error.about(both).helping("Compute the map up to these torques and speeds, or pass --allow-outside: the ratio of loss to torque is then constant beyond its edge."),
        Code::E402 => error.about(map).helping("Compute the map again with axes on which the case has results."),
        _ => error.about(both),
    }
    .into()
}

/// Reads the map in a folder.
pub fn read_map(folder: &Path) -> Result<Map, Failure> {
    let advice = "Name the folder that asperity map wrote, e.g. results/case-map.";
    let map = map::read(folder);
    Ok(map.map_err(|error| error.helping(advice))?)
}

/// Reads the text of a table in a file.
pub fn table_in(file: &Path) -> Result<String, Failure> {
    Ok(read_table(file, LARGEST_TABLE)?)
}

/// Reads the cycle in a file, whose columns may have other names.
pub fn read_cycle(
    file: &Path,
    names: Option<&[String]>,
    vehicle: Option<&VehicleInput>,
) -> Result<Cycle, Failure> {
    let name = file.display();
    let text = table_in(file)?;
    cycle::named_cycle(&text, names, vehicle).map_err(|error| {
        let advice = match &error {
            CycleError::Impossible(error) => return Failure::of(error),
            CycleError::Columns { .. } | CycleError::Twice(..) => {
                "Write these names above the rows, or pass them in the order of the columns: --columns time_s,-,speed_km_h, where - leaves a column out."
            }
            _ => {
                "A cycle is a table with time_s and torque_nm, speed_rpm at the pinion, or speed_km_h with [vehicle] in the case; --columns names its columns."
            }
        };
        Failure::new(error.code(), format!("{name}: {error}")).advising(advice)
    })
}

fn temperature(args: &CycleArgs, map: &Map) -> Result<usize, Failure> {
    let nodes = &map.axes.temperature_c;
    let Some(celsius) = args.temperature else {
        return Ok(0);
    };
    let at = nodes.iter().position(|node| *node == celsius);
    at.ok_or_else(|| {
        let known: Vec<String> = nodes.iter().map(|node| number(*node)).collect();
        let known = known.join(", ");
        Failure::new(
            Code::E209,
            format!("--temperature {}: the map has {known} °C", number(celsius)),
        )
    })
}

fn stem(path: &Path) -> String {
    path.file_stem()
        .unwrap_or_default()
        .to_string_lossy()
        .into_owned()
}
