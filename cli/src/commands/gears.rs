//! `asperity gears`: the gears of the library.

use asperity_core::presets::{GearPreset, planetary_sets, trains};
use asperity_core::quantity::Length;
use asperity_report::library::{gears_named, listed_gears, pair_of, unlisted};
use asperity_report::wrapped;

use super::presets::{LETTERS, figures, keys, least, print_listed};
use crate::args::{Common, PresetArgs};
use crate::failure::Failure;

/// `asperity gears`
pub fn gears(args: &PresetArgs, common: &Common) -> Result<(), Failure> {
    let shown = gears_named(args.name.as_deref())?;
    print_listed(common, ("gears", &shown), listed_gears, || {
        match (&args.name, shown.first()) {
            (Some(_), Some(one)) => whole(one),
            _ => table(&shown),
        }
    })
}

fn table(gears: &[GearPreset]) -> Result<String, Failure> {
    let mut text = format!(
        "{:16} {:>7} {:>8} {:>6} {:>9} {:>8} {:>8}  {}\n",
        "name", "teeth", "m_n mm", "beta", "b mm", "a mm", "least", "sources"
    );
    let mm = |length: Length| length.si() * 1e3;
    for preset in gears {
        let numbers = &preset.gears;
        let [z1, z2] = numbers.teeth.value;
        let [b1, b2] = numbers.face_width.value.map(mm);
        let (distance, _) = pair_of(preset)?;
        let rows = preset.rows();
        let line = format!(
            "{:16} {:>7} {:>8} {:>6} {:>9} {:>8.2} {:>8}  {}",
            preset.name,
            format!("{z1}/{z2}"),
            mm(numbers.module.value),
            format!("{:.1}°", numbers.helix.value.si().to_degrees()),
            if b1 == b2 {
                format!("{b1}")
            } else {
                format!("{b1}/{b2}")
            },
            mm(distance),
            least(&preset.gear_rows()),
            keys(&rows)
        );
        text.push_str(&wrapped(&line, "      "));
        text.push('\n');
    }
    text.push_str(&wrapped(
        "least: the lowest certainty of the geometry. The centre distance follows from the profile shifts.",
        "",
    ));
    let trains = trains().map_err(unlisted)?.into_iter();
    let trains: Vec<String> = trains.map(|(name, _)| name).collect();
    let sets = planetary_sets().map_err(unlisted)?.into_iter();
    let sets: Vec<String> = sets.map(|set| set.name).collect();
    let more = format!(
        "asperity gears NAME shows every number; asperity demo --gears NAME writes a case, also of the trains {} and of the \
         planetary set {}.",
        trains.join(", "),
        sets.join(", ")
    );
    Ok(format!("{text}\n{LETTERS}\n{}\n", wrapped(&more, "")))
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
