//! The gears of a planetary set, as commented TOML.

use crate::model::Component;
use crate::stages::teeth;
use crate::writer::{Text, source};
use asperity_core::Fault;

/// Writes the table `[planetary]` of sun, planet and ring.
pub fn gears(
    case: &mut Text<'_>,
    mesh: &Component,
    gears: [&Component; 3],
    planets: usize,
) -> Result<(), Fault> {
    let z = [teeth(gears[0])?, teeth(gears[1])?, teeth(gears[2])?];
    case.heading("planetary");
    case.sourced_line(
        &format!("teeth = [{}, {}, -{}]", z[0], z[1], z[2]),
        &format!("sun, planet, ring {}", source(&gears, "number_of_teeth")),
    );
    case.sourced_line(
        &format!("planets = {planets}"),
        "gears that mesh with the ring",
    );
    case.geometry(mesh, &gears, &z.map(f64::from))?;
    for (name, gear) in ["sun", "planet", "ring"].into_iter().zip(gears) {
        case.teeth_form(name, gear)?;
    }
    if !case.within.is_empty() {
        // The shafts of the train tell which of them turns.
        return Ok(());
    }
    case.note(
        "the ring is assumed to be fixed and the sun to be driven: write planetary.ring_speed if the ring turns",
    );
    Ok(())
}
