//! `asperity list gears`: the gears of the library.

use std::fmt::Display;

use asperity_core::presets::{GearPreset, planetary_sets, trains};
use asperity_core::quantity::Length;
use asperity_report::library::{gears_named, listed_gears, pair_of, unlisted};
use asperity_report::{columns, wrapped};

use super::presets::{LETTERS, figures, least, print_listed};
use crate::args::Common;
use crate::failure::Failure;

/// `asperity list gears`
pub fn gears(name: Option<&str>, common: &Common) -> Result<(), Failure> {
    let shown = gears_named(name)?;
    print_listed(common, "gears", &shown, listed_gears, || {
        match (name, shown.first()) {
            (Some(_), Some(one)) => whole(one),
            _ => table(&shown),
        }
    })
}

fn table(gears: &[GearPreset]) -> Result<String, Failure> {
    let mm = |length: Length| length.si() * 1e3;
    let distances = gears.iter().map(|preset| Ok(mm(pair_of(preset)?.0)));
    let distances = distances.collect::<Result<Vec<f64>, Failure>>()?;
    let table = columns! { (preset, distance) in gears.iter().zip(distances);
        head name "name" "" = &preset.name;
        number teeth "teeth" "" = pair(preset.gears.teeth.value);
        number module "module" "mm" = mm(preset.gears.module.value);
        number helix "helix angle" "°" "{:.1}" = preset.gears.helix.value.si().to_degrees();
        number width "face width" "mm" = match preset.gears.face_width.value.map(mm) {
            [one, other] if one == other => one.to_string(),
            both => pair(both),
        };
        number distance "centre distance" "mm" "{:.2}" = distance;
        text least "least" "" = least(&preset.gear_rows());
    };
    let mut text = table.text("");
    text.push_str(&wrapped(
        "least: the lowest certainty of the geometry. The centre distance follows from the profile shifts.",
        "",
    ));
    let trains = trains().map_err(unlisted)?.into_iter();
    let trains: Vec<String> = trains.map(|(name, _)| name).collect();
    let sets = planetary_sets().map_err(unlisted)?.into_iter();
    let sets: Vec<String> = sets.map(|set| set.name).collect();
    let more = format!(
        "asperity list gears NAME shows every number; asperity demo --gears NAME writes a case, also of the trains {} and of the \
         planetary set {}.",
        trains.join(", "),
        sets.join(", ")
    );
    Ok(format!("{text}\n{LETTERS}\n{}\n", wrapped(&more, "")))
}

fn pair<T: Display>([first, second]: [T; 2]) -> String {
    format!("{first}/{second}")
}

fn whole(preset: &GearPreset) -> Result<String, Failure> {
    let (distance, ratio) = pair_of(preset)?;
    let head = wrapped(
        &format!("{}: {}. {}", preset.name, preset.title, preset.note),
        "  ",
    );
    let figures = figures(&preset.rows())?;
    Ok(format!(
        "{head}\n  centre distance {:.3} mm, transverse contact ratio {ratio:.3} (both follow)\n{figures}\
         asperity demo --gears {} writes a case with these gears.\n",
        distance.si() * 1e3,
        preset.name
    ))
}
