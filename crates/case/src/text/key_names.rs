//! Keys of the case file for the names of the inputs of equations.

use std::borrow::Cow;

use super::case_file::schema_with;
use super::known_keys::first_unknown;
use super::plain_words::plain;

/// A row: the table of the case file, the name in the equation, the key. A name that equals its key except for blanks has no
/// row.
type Name = (&'static str, &'static str, &'static str);

#[rustfmt::skip]
const NAMES: &[Name] = &[
    ("gears", "helix angle", "gears.helix"),
    ("gears", "sum of the profile shifts", "gears.profile_shift"),
    ("gears", "tip radius", "gears.tip_diameter"),
    ("gears", "stiffness factor", "model.stiffness_factor"),
    ("gears", "face coupling", "model.face_coupling"),
    ("gears", "dedendum", "gears.pinion.dedendum"),
    ("gears", "fillet radius", "gears.pinion.fillet_radius"),
    ("gears", "tip chamfer of the pinion", "gears.pinion.tip_chamfer"),
    ("gears", "tip chamfer of the wheel", "gears.wheel.tip_chamfer"),
    ("gears", "pitch deviation", "gears.pitch_deviations"),
    ("gears", "length of the end relief", "gears.end_relief"),
    ("lubricant", "temperature", "operation.bulk_temperature"),
    ("lubricant", "density at 15 °C", "lubricant.density"),
    ("lubricant", "temperature of the density", "lubricant.density_temperature"),
    ("lubricant", "specific heat capacity", "lubricant.heat_capacity"),
    ("lubricant", "pressure-viscosity coefficient", "lubricant.pressure_viscosity"),
    ("lubricant", "pressure-viscosity factor", "lubricant.pressure_viscosity_factor"),
    ("lubricant", "fall of the limiting shear", "lubricant.limiting_shear_temperature"),
    ("lubricant", "temperature coefficient -(d eta/dT)/eta", "lubricant.temperature_coefficient"),
    ("lubricant", "viscosity at 40 °C", "lubricant.viscosity.at_40"),
    ("lubricant", "viscosity at 100 °C", "lubricant.viscosity.at_100"),
];

/// The key of `table` with this name in an equation; the table itself if there is none.
pub(crate) fn key_of(table: &'static str, name: &str) -> Cow<'static, str> {
    let row = NAMES.iter().find(|row| row.0 == table && row.1 == name);
    if let Some((_, _, key)) = row {
        return (*key).into();
    }
    let key = format!("{table}.{}", name.replace(' ', "_"));
    match first_unknown(schema_with(false), std::iter::once(key.as_str())) {
        None => key.into(),
        Some(_) => table.into(),
    }
}

/// The message about a key that is missing in `table`.
pub(crate) fn missing_key(table: &str, key: &str) -> String {
    let message = format!("missing field `{key}`");
    plain(schema_with(false), Some(table), &message)
}
