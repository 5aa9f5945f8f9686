//! Key of the case file for the name of an equation's input.

/// A row: the table of the case file, the name in the equation, the key.
type Row = (&'static str, &'static str, &'static str);

const ROWS: &[Row] = &[
    ("gears", "teeth", "gears.teeth"),
    ("gears", "module", "gears.module"),
    ("gears", "helix angle", "gears.helix"),
    ("gears", "pressure angle", "gears.pressure_angle"),
    ("gears", "face width", "gears.face_width"),
    ("gears", "profile shift", "gears.profile_shift"),
    ("gears", "sum of the profile shifts", "gears.profile_shift"),
    ("gears", "centre distance", "gears.centre_distance"),
    ("gears", "tip radius", "gears.tip_diameter"),
    ("gears", "addendum", "gears.addendum"),
    ("gears", "stiffness factor", "model.stiffness_factor"),
    ("gears", "face coupling", "model.face_coupling"),
    ("gears", "dedendum", "gears.pinion.dedendum"),
    ("gears", "fillet radius", "gears.pinion.fillet_radius"),
    ("gears", "tip chamfer", "gears.pinion.tip_chamfer"),
    ("gears", "pitch deviation", "gears.pitch_deviations"),
    ("gears", "length of the end relief", "gears.end_relief"),
    ("lubricant", "temperature", "operation.temperature"),
    ("lubricant", "density", "lubricant.density"),
    ("lubricant", "density at 15 °C", "lubricant.density"),
    (
        "lubricant",
        "temperature of the density",
        "lubricant.density_temperature",
    ),
    (
        "lubricant",
        "thermal expansion",
        "lubricant.thermal_expansion",
    ),
    (
        "lubricant",
        "thermal conductivity",
        "lubricant.thermal_conductivity",
    ),
    (
        "lubricant",
        "specific heat capacity",
        "lubricant.heat_capacity",
    ),
    (
        "lubricant",
        "pressure-viscosity coefficient",
        "lubricant.pressure_viscosity",
    ),
    (
        "lubricant",
        "temperature coefficient -(d eta/dT)/eta",
        "lubricant.temperature_coefficient",
    ),
    (
        "lubricant",
        "viscosity at 40 °C",
        "lubricant.viscosity.at_40",
    ),
    (
        "lubricant",
        "viscosity at 100 °C",
        "lubricant.viscosity.at_100",
    ),
    ("surface.pinion", "Rq", "surface.pinion.rq"),
    ("surface.pinion", "Ra", "surface.pinion.ra"),
    ("surface.pinion", "Rz", "surface.pinion.rz"),
    ("surface.pinion", "Rpk", "surface.pinion.rpk"),
    (
        "surface.pinion",
        "asperity radius",
        "surface.pinion.asperity_radius",
    ),
    ("surface.wheel", "Rq", "surface.wheel.rq"),
    ("surface.wheel", "Ra", "surface.wheel.ra"),
    ("surface.wheel", "Rz", "surface.wheel.rz"),
    ("surface.wheel", "Rpk", "surface.wheel.rpk"),
    (
        "surface.wheel",
        "asperity radius",
        "surface.wheel.asperity_radius",
    ),
];

/// The key of `table` that `name` means; the table itself if there is none.
pub(super) fn key_of(table: &'static str, name: &str) -> &'static str {
    ROWS.iter()
        .find(|row| row.0 == table && row.1 == name)
        .map_or(table, |row| row.2)
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::case::known_keys::first_unknown;
    use crate::case::schema;

    #[test]
    fn every_key_named_here_is_a_key_of_the_case_file() {
        let keys = ROWS.iter().map(|row| row.2);
        assert_eq!(first_unknown(&schema(), keys), None);
    }
}
