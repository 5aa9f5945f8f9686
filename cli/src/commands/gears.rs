//! `asperity gears`: the gears of the library.

use asperity::gear::{GearPair, GearPairInput, Plane};
use asperity_core::presets::{self, GearPreset};
use asperity_core::quantity::Length;
use asperity_report::wrapped;
use serde_json::{Value, json};

use super::presets::{LETTERS, figures, figures_json, keys, least, refused};
use crate::args::{Common, PresetArgs};
use crate::failure::Failure;
use crate::output::{print_json, print_text};

/// `asperity gears`
pub fn gears(args: &PresetArgs, common: &Common) -> Result<(), Failure> {
    let shown = match &args.name {
        Some(name) => vec![presets::gear(name).map_err(|error| refused(&error))?],
        None => presets::gears().map_err(|error| refused(&error))?,
    };
    if common.json {
        let listed: Result<Vec<Value>, Failure> = shown.iter().map(listed).collect();
        return print_json(&json!({ "gears": listed? }));
    }
    let text = match (&args.name, shown.first()) {
        (Some(_), Some(one)) => whole(one)?,
        _ => table(&shown)?,
    };
    print_text(common, &text)
}

/// Centre distance and transverse contact ratio computed from the numbers.
fn derived(preset: &GearPreset) -> Result<(Length, f64), Failure> {
    let gears = &preset.gears;
    let tip = gears.tip_diameter.as_ref();
    let pair = GearPair::new(&GearPairInput {
        teeth: gears.teeth.value,
        module: gears.module.value,
        module_plane: Plane::Normal,
        helix: gears.helix.value,
        pressure_angle: gears.pressure_angle.value,
        face_width: gears.face_width.value,
        overlap: None,
        profile_shift: Some(gears.profile_shift.value),
        centre_distance: None,
        tip_radius: tip.map(|tip| tip.value.map(|diameter| diameter / 2.0)),
        addendum: 1.0,
    });
    let pair = pair.map_err(|error| Failure::new("E501", format!("{}: {error}", preset.name)))?;
    Ok((pair.centre_distance, pair.path.eps_alpha))
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
        let (distance, _) = derived(preset)?;
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
    Ok(format!(
        "{text}\n{LETTERS}\nasperity gears NAME shows every number; asperity demo --gears NAME writes a\ncase.\n"
    ))
}

fn whole(preset: &GearPreset) -> Result<String, Failure> {
    let (distance, ratio) = derived(preset)?;
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

fn listed(preset: &GearPreset) -> Result<Value, Failure> {
    let (distance, ratio) = derived(preset)?;
    let (figures, sources) = figures_json(&preset.rows())?;
    Ok(json!({
        "name": preset.name,
        "title": preset.title,
        "note": preset.note,
        "preset": preset,
        "figures": figures,
        "centre_distance_mm": distance.si() * 1e3,
        "transverse_contact_ratio": ratio,
        "sources": sources,
    }))
}
