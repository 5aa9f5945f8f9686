//! Text of a case: the tables that pairs and planetary sets share.

use crate::error;
use std::fmt::Write as _;

use crate::model::{Component, Model};
use crate::operating_points::OperatingPoint;
use crate::stages::Stage;
use crate::units::Unit;
use crate::unread::unread;
use asperity_core::Fault;

/// Default temperature \[°C\].
const TEMPERATURE: f64 = 60.0;
/// Tolerance of the centre distance \[mm\].
const DISTANCE_TOLERANCE: f64 = 0.01;

/// A case in TOML with notes for its reader.
#[derive(Debug, Clone, PartialEq, Eq, Default)]
#[non_exhaustive]
pub struct CaseText {
    /// The case.
    pub toml: String,
    /// Notes on contradictions in the file and on missing values.
    pub notes: Vec<String>,
    /// Attributes of the file that the case does not use, by component.
    pub not_read: Vec<String>,
}

/// Source of numbers: type and numbers of the components, and the attribute.
pub fn source(components: &[&Component], attribute: &str) -> String {
    let ids: Vec<&str> = components.iter().map(|of| of.id.as_str()).collect();
    format!("{} {}: {attribute}", components[0].kind, ids.join(", "))
}

/// A text of the file without line breaks and other control characters.
fn one_line(text: &str) -> String {
    let shown = |c: char| if c.is_control() { ' ' } else { c };
    text.chars().map(shown).collect()
}

/// A quantity as a case file has it.
pub fn quantity(value: impl std::fmt::Display, unit: &str) -> String {
    format!("\"{value} {unit}\"")
}

/// `"1 mm", "2 mm"`
fn quantities(values: &[f64], unit: &str) -> String {
    let texts = values.iter().map(|value| quantity(value, unit));
    texts.collect::<Vec<String>>().join(", ")
}

/// Text of a case under construction.
pub struct Text<'a> {
    model: &'a Model,
    toml: String,
    notes: Vec<String>,
    /// Table of the mesh under construction in a gear train, with a point at its end.
    pub within: String,
}

impl<'a> Text<'a> {
    /// An empty case of a stage, or of all stages.
    pub fn new(model: &'a Model, file: &str, stage: Option<&Stage>) -> Self {
        let (file, program) = (one_line(file), one_line(&model.program));
        let (what, title) = match stage {
            None => ("All stages".to_owned(), file.clone()),
            Some(Stage { number, name, .. }) => {
                let title = format!("{file}, stage {number}: {}", one_line(name.trim()));
                let title = title.trim_end_matches([':', ' ']).to_owned();
                (format!("Stage {number}"), title)
            }
        };
        let mut toml = format!(
            "# {what} of {file}: REXS {} by {program}.\n# The comment on each number names its attribute.\n",
            model.version
        );
        let _ = writeln!(toml, "title = {}", quoted(&title));
        Self {
            model,
            toml,
            notes: Vec::new(),
            within: String::new(),
        }
    }

    /// Begins the table `name` of the case, or of the mesh under construction.
    pub fn heading(&mut self, name: &str) {
        let heading = format!("\n[{}{name}]", self.within);
        self.line(&heading);
    }

    /// The finished case, which ends with a list of what it does not use.
    pub fn done(mut self) -> CaseText {
        let (count, not_read) = unread(self.model);
        if !not_read.is_empty() {
            self.line("\n# Not read from the file:");
            for line in &not_read {
                self.comment(line);
            }
            self.note(format!(
                "{count} attributes of the file are not read; the end of the case lists them"
            ));
        }
        CaseText {
            toml: self.toml,
            notes: self.notes,
            not_read,
        }
    }

    /// The model of the file.
    pub fn model(&self) -> &'a Model {
        self.model
    }

    /// Appends a comment, on one line.
    pub fn comment(&mut self, text: &str) {
        let text = one_line(text);
        self.line(&format!("# {text}"));
    }

    /// Appends a line.
    pub fn line(&mut self, text: &str) {
        self.toml.push_str(text);
        self.toml.push('\n');
    }

    /// Appends a line with its source as a comment.
    pub fn sourced_line(&mut self, text: &str, from: &str) {
        self.line(&format!("{text}  # {from}"));
    }

    /// A line for `key` with the value of an attribute of `components`.
    pub fn entry(&mut self, key: &str, value: &str, components: &[&Component], attribute: &str) {
        self.sourced_line(&format!("{key} = {value}"), &source(components, attribute));
    }

    /// Adds a note for the reader of the case.
    pub fn note(&mut self, text: impl Into<String>) {
        let text = text.into();
        if !self.notes.contains(&text) {
            self.notes.push(text);
        }
    }

    /// A required attribute of all `components`.
    fn all(
        &self,
        components: &[&Component],
        attribute: &'static str,
        unit: Unit,
    ) -> Result<Vec<f64>, Fault> {
        components
            .iter()
            .map(|component| component.required(attribute, unit))
            .collect()
    }

    /// Flank component of a gear: the left one if both are stated.
    pub fn flank(&self, gear: &Component) -> Option<&'a Component> {
        self.flank_on(gear, ["left", "right"])
    }

    /// The right flank of a gear if both are stated.
    pub fn other_flank(&self, gear: &Component) -> Option<&'a Component> {
        self.flank_on(gear, ["right", "left"])
    }

    fn flank_on(&self, gear: &Component, sides: [&str; 2]) -> Option<&'a Component> {
        let relation = self
            .model
            .related("flank")
            .find(|relation| relation.role("gear") == Some(&gear.id))?;
        let side = sides.iter().find_map(|side| relation.role(side))?;
        self.model.components.get(side)
    }

    /// Values of an attribute of the flanks of `gears`, and those flanks that state it.
    pub fn on_flanks(
        &self,
        gears: &[&Component],
        attribute: &'static str,
        unit: Unit,
    ) -> Result<(Vec<f64>, Vec<&'a Component>), Fault> {
        let (mut values, mut flanks) = (Vec::new(), Vec::new());
        for flank in gears.iter().filter_map(|gear| self.flank(gear)) {
            if let Some(value) = flank.number(attribute, unit)? {
                values.push(value);
                flanks.push(flank);
            }
        }
        Ok((values, flanks))
    }

    /// Writes the keys common to pairs and planetary sets; returns the profile shifts if the file has all of them.
    pub fn geometry(
        &mut self,
        mesh: &Component,
        gears: &[&Component],
        z: &[f64],
    ) -> Result<Option<Vec<f64>>, Fault> {
        self.shared_geometry(gears)?;
        let widths = self.all(gears, "face_width", Unit::Millimetre)?;
        let widths = format!("[{}]", quantities(&widths, "mm"));
        self.entry("face_width", &widths, gears, "face_width");
        let shifts = self.shifts(gears)?;
        self.centre_distance(mesh, shifts.is_some())?;
        let has_tips = self.tips(gears, z)?;
        if !has_tips {
            self.addendum(gears)?;
        }
        if shifts.is_none() && !has_tips {
            self.zero_shifts(mesh, gears, z)?;
        }
        Ok(shifts)
    }

    /// Writes module, helix angle and pressure angle, which must be equal for all gears of a stage.
    fn shared_geometry(&mut self, gears: &[&Component]) -> Result<(), Fault> {
        let modules = self.all(gears, "normal_module", Unit::Millimetre)?;
        self.agree(gears, "normal_module", &modules)?;
        let module = quantity(modules[0], "mm");
        self.entry("module", &module, gears, "normal_module");
        let helix = self.all(gears, "helix_angle_reference_diameter", Unit::Degree)?;
        let sizes: Vec<f64> = helix.iter().map(|angle| angle.abs()).collect();
        self.agree(gears, "helix_angle_reference_diameter", &sizes)?;
        if sizes[0] > 0.0 {
            let from = source(gears, "helix_angle_reference_diameter");
            self.sourced_line(
                &format!("helix = \"{} deg\"", sizes[0]),
                &format!("{from}, without sign"),
            );
        }
        const ANGLE: &str = "normal_pressure_angle";
        let (angles, flanks) = self.on_flanks(gears, ANGLE, Unit::Degree)?;
        if let Some(angle) = angles.first() {
            self.agree(gears, ANGLE, &angles)?;
            let angle = quantity(angle, "deg");
            self.entry("pressure_angle", &angle, &flanks[..1], ANGLE);
        } else {
            self.line("# pressure_angle: not in the file, 20 deg by default");
            self.note("the file has no normal_pressure_angle: 20 deg");
        }
        Ok(())
    }

    fn agree(
        &self,
        gears: &[&Component],
        attribute: &'static str,
        values: &[f64],
    ) -> Result<(), Fault> {
        const SAME: f64 = 1e-6;
        for (gear, value) in gears.iter().zip(values).skip(1) {
            if (value - values[0]).abs() > SAME * values[0].abs().max(1.0) {
                return Err(gear.refused(attribute, "which differs from its mating gear"));
            }
        }
        Ok(())
    }

    /// Writes the profile shift coefficients if every gear has one.
    fn shifts(&mut self, gears: &[&Component]) -> Result<Option<Vec<f64>>, Fault> {
        const SHIFT: &str = "addendum_modification_coefficient";
        let (shifts, flanks) = self.on_flanks(gears, SHIFT, Unit::None)?;
        if shifts.len() < gears.len() {
            self.note("not every gear has an addendum_modification_coefficient");
            return Ok(None);
        }
        let texts: Vec<String> = shifts.iter().map(|x| rounded(*x)).collect();
        let texts = format!("[{}]", texts.join(", "));
        self.entry("profile_shift", &texts, &flanks, SHIFT);
        Ok(Some(shifts))
    }

    /// Writes the centre distance, which is required if the profile shifts are unknown.
    fn centre_distance(&mut self, mesh: &Component, shifts: bool) -> Result<(), Fault> {
        let distance = mesh.number("center_distance", Unit::Millimetre)?;
        match distance {
            // The shifts have precedence because the distance is often rounded.
            Some(distance) if shifts => {
                self.line(&format!(
                    "# centre_distance = \"{distance} mm\"  # {}, follows from the shifts",
                    source(&[mesh], "center_distance")
                ));
            }
            Some(distance) => {
                let distance = quantity(distance, "mm");
                self.entry("centre_distance", &distance, &[mesh], "center_distance");
            }
            None if shifts => {}
            None => {
                return Err(error::missing(&mesh.label(), "center_distance"));
            }
        }
        Ok(())
    }

    /// Adds a note if the centre distance disagrees with the profile shifts.
    pub fn check_distance(
        &mut self,
        mesh: &Component,
        gears: &[&Component],
        z: &[f64],
        shifts: Option<&[f64]>,
    ) -> Result<(), Fault> {
        let stated = mesh.number("center_distance", Unit::Millimetre)?;
        let (Some(stated), Some(shifts)) = (stated, shifts) else {
            return Ok(());
        };
        let module = gears[0].required("normal_module", Unit::Millimetre)?;
        let helix = gears[0].required("helix_angle_reference_diameter", Unit::Degree)?;
        let flank = self.flank(gears[0]);
        let angle = flank.map_or(Ok(None), |flank| {
            flank.number("normal_pressure_angle", Unit::Degree)
        })?;
        let distance = working_distance(
            z.iter().sum(),
            shifts.iter().sum(),
            module,
            helix.to_radians(),
            angle.unwrap_or(20.0).to_radians(),
        );
        if distance.is_none_or(|distance| (distance - stated).abs() > DISTANCE_TOLERANCE) {
            let ours = distance.map_or("none".into(), |distance| format!("{distance:.4} mm"));
            self.note(format!(
                "{}: center_distance is {stated} mm, the profile shifts give {ours}; the shifts are used",
                mesh.label()
            ));
        }
        Ok(())
    }

    /// Writes the tip diameters if every gear has a plausible one.
    fn tips(&mut self, gears: &[&Component], z: &[f64]) -> Result<bool, Fault> {
        let mut tips = Vec::new();
        for (gear, z) in gears.iter().zip(z) {
            let Some(tip) = gear.number("tip_diameter", Unit::Millimetre)? else {
                continue;
            };
            let module = gear.required("normal_module", Unit::Millimetre)?;
            let helix = gear.required("helix_angle_reference_diameter", Unit::Degree)?;
            let reference = z * module / helix.to_radians().cos();
            let tip = tip.abs();
            let is_ring = gear.kind == "ring_gear";
            // A positive shift shortens the teeth of a ring, a negative one those of an external gear.
            let allowance = 2.0 * module;
            let fits = if is_ring {
                (reference - 4.0 * module..reference + allowance).contains(&tip)
            } else {
                (reference - allowance..reference + 6.0 * module).contains(&tip)
            };
            if fits {
                tips.push(tip);
            } else {
                self.note(format!(
                    "{}: tip_diameter {tip} mm on a reference diameter of {reference:.3} mm is ignored",
                    gear.label()
                ));
            }
        }
        if tips.len() == gears.len() {
            let tips = format!("[{}]", quantities(&tips, "mm"));
            self.entry("tip_diameter", &tips, gears, "tip_diameter");
        } else {
            self.line("# tip_diameter: not in the file for every gear, from the addendum");
            self.note(
                "not every gear has a plausible tip_diameter: it follows from the addendum, 1 module by default",
            );
        }
        Ok(tips.len() == gears.len())
    }

    /// Writes profile shifts of zero for a stage with a ring at its reference centre distance, if the file has neither
    /// shifts nor tip diameters. A case of an external pair divides the sum of its centre distance itself.
    fn zero_shifts(
        &mut self,
        mesh: &Component,
        gears: &[&Component],
        z: &[f64],
    ) -> Result<(), Fault> {
        if gears.iter().all(|gear| gear.kind != "ring_gear") {
            return Ok(());
        }
        let distance = mesh.required("center_distance", Unit::Millimetre)?;
        let module = gears[0].required("normal_module", Unit::Millimetre)?;
        let helix = gears[0].required("helix_angle_reference_diameter", Unit::Degree)?;
        let scale = 0.5 * module / helix.to_radians().cos();
        let last = z.len() - 1;
        let ring_offset = (scale * (z[last] - z[last - 1]) - distance).abs();
        let sun_offset = match z {
            [sun, planet, _] => (scale * (sun + planet) - distance).abs(),
            _ => 0.0,
        };
        if ring_offset.max(sun_offset) >= DISTANCE_TOLERANCE {
            self.note(
                "the profile shifts do not follow from the centre distance: write profile_shift",
            );
            return Ok(());
        }
        self.sourced_line(
            &format!("profile_shift = [{}]", vec!["0"; z.len()].join(", ")),
            "default: the centre distance is the reference centre distance",
        );
        self.note("the profile shifts are zero by the centre distance");
        Ok(())
    }

    /// Writes root, tip chamfer and modifications of a gear.
    pub fn teeth_form(&mut self, name: &str, gear: &Component) -> Result<(), Fault> {
        self.tool(name, gear)?;
        self.chamfer(name, gear)?;
        self.modifications(name, gear)
    }

    fn chamfer(&mut self, name: &str, gear: &Component) -> Result<(), Fault> {
        if let Some(flank) = self.flank(gear)
            && let Some(chamfer) = flank.number("tooth_tip_chamfer", Unit::Millimetre)?
            && chamfer > 0.0
        {
            let key = format!("{name}.tip_chamfer");
            self.entry(
                &key,
                &quantity(chamfer, "mm"),
                &[flank],
                "tooth_tip_chamfer",
            );
        }
        Ok(())
    }

    /// Writes the operating point of a load case, and the others as comments; returns the stated temperature of the
    /// oil \[°C\].
    pub fn operation(
        &mut self,
        points: &[OperatingPoint],
        wanted: usize,
        first: &str,
    ) -> Result<Option<f64>, Fault> {
        let point = wanted.checked_sub(1).and_then(|index| points.get(index));
        let Some(point) = point else {
            return Err(error::no_load_case(wanted, points.len()));
        };
        self.heading("operation");
        for other in points.iter().filter(|other| *other != point) {
            self.line(&format!("# {}", summary(other)));
        }
        let quantities = [
            ("torque", "N m", &point.torque),
            ("speed", "1/min", &point.speed),
        ];
        for (key, unit, stated) in quantities {
            if let Some((value, from)) = stated {
                self.sourced_line(
                    &format!("{key} = \"{} {unit}\"", rounded(*value)),
                    &format!("{first}; {from}"),
                );
            } else {
                self.line(&format!(
                    "# {key} = \"... {unit}\"  # of the {first}: not in the file"
                ));
                self.note(format!(
                    "the file has no {key} of the {first}: write operation.{key}"
                ));
            }
        }
        if let Some((value, from)) = &point.temperature {
            self.sourced_line(&format!("bulk_temperature = \"{value} °C\""), from);
            self.note(format!(
                "the flanks are taken at the oil's {value} °C; for the temperature that the loss heats them to, state it as operation.oil_temperature with operation.bulk"
            ));
        } else {
            self.sourced_line(
                &format!("bulk_temperature = \"{TEMPERATURE} °C\""),
                "default: the file has no temperature_lubricant",
            );
            self.note(format!(
                "the file has no temperature of the oil: {TEMPERATURE} °C"
            ));
        }
        Ok(point.temperature.as_ref().map(|(value, _)| *value))
    }

    /// Writes the steel of the gears, which have these names in the case.
    pub fn material(&mut self, gears: &[(&str, &Component)]) -> Result<(), Fault> {
        let mut lines = Vec::new();
        for (name, gear) in gears {
            let Some(steel) = self.model.referenced(gear, "material").next() else {
                continue;
            };
            let properties = [
                ("elastic_modulus", "young", Unit::Megapascal, " MPa"),
                ("poisson_ratio", "poisson", Unit::None, ""),
                ("density", "density", Unit::KilogramPerCubicMetre, " kg/m3"),
            ];
            for (attribute, key, unit, written) in properties {
                if let Some(value) = steel.number(attribute, unit)? {
                    let value = rounded(value);
                    let value = match written {
                        "" => value,
                        unit => format!("\"{value}{unit}\""),
                    };
                    let from = source(&[steel], attribute);
                    lines.push((format!("{name}.{key} = {value}"), from));
                }
            }
            let hardness = steel.number("surface_hardness_vickers", Unit::Vickers)?;
            if let Some(hardness) = hardness.filter(|hardness| *hardness > 0.0) {
                // Vickers hardness is a pressure in kgf/mm².
                let pressure = rounded(hardness * 9.806_65);
                let from = source(&[steel], "surface_hardness_vickers");
                lines.push((
                    format!("{name}.flow_pressure = \"{pressure} MPa\""),
                    format!("{from}, {hardness} HV"),
                ));
            }
        }
        if !lines.is_empty() {
            self.heading("material");
        }
        for (text, from) in lines {
            self.sourced_line(&text, &from);
        }
        Ok(())
    }

    /// Writes the flanks of the gears, which have these names in the case: trace files or roughness values. Returns
    /// whether a flank has neither.
    pub fn surface(&mut self, gears: &[(&str, &Component, Option<&str>)]) -> Result<bool, Fault> {
        let mut is_missing = false;
        let mut lines = Vec::new();
        for (name, gear, file) in gears {
            if let Some(file) = file {
                lines.push(format!("{name}.file = {}", quoted(file)));
                continue;
            }
            let values = roughness(gear)?;
            for (key, value, from) in &values {
                lines.push(format!("{name}.{key} = \"{value} um\"  # {from}"));
            }
            is_missing |= values.is_empty() && name != &"ring";
        }
        // The flanks of a gear train that are not in the file are stated once for all meshes.
        if !lines.is_empty() || self.within.is_empty() {
            self.heading("surface");
        }
        for line in lines {
            self.line(&line);
        }
        Ok(is_missing)
    }

    /// Asks for the traces of the flanks of two gears with these names.
    pub fn ask_for_traces(&mut self, [first, second]: [&str; 2]) {
        self.line("# The measured flanks, which are not in the file:");
        self.line(&format!("# {first}.file = \"{first}.csv\""));
        self.line(&format!("# {second}.file = \"{second}.csv\""));
        self.note(format!(
            "the file has no measured flank: write surface.{first}.file and surface.{second}.file"
        ));
    }
}

/// Attributes of the roughness of a flank in versions 1.2 to 2.0, with their keys of a case. Where no Ra of the flank is
/// stated, that at the cut-off of AGMA 925 is used.
const ROUGHNESS: [(&str, &[&str]); 3] = [
    (
        "ra",
        &[
            "arithmetic_mean_roughness_flank_iso_4287_1997",
            "arithmetic_average_roughness_flank",
            "arithmentic_mean_roughness_at_filter_cutoff_of_wavelength_agma_925_2003",
            "arithmentic_mean_roughness_at_filter_cutoff_of_wavelength_agma_925_a03",
        ],
    ),
    (
        "rz",
        &[
            "mean_peak_to_valley_roughness_flank_iso_4287_1997",
            "averaged_peak_to_valley_height_flank",
        ],
    ),
    (
        "rq",
        &[
            "root_mean_square_roughness_at_filter_cutoff_of_wavelength_agma_925_2003",
            "root_mean_square_roughness_at_filter_cutoff_of_wavelength_agma_925_a03",
        ],
    ),
];

/// Roughness values of a gear, with the keys of a case.
fn roughness(gear: &Component) -> Result<Vec<(&'static str, f64, String)>, Fault> {
    let mut values = Vec::new();
    for (key, attributes) in ROUGHNESS {
        let stated = gear.first_of(attributes, Unit::Micrometre)?;
        if let Some((value, from)) = stated.filter(|(value, _)| *value > 0.0) {
            values.push((key, value, source(&[gear], from)));
        }
    }
    Ok(values)
}

/// Working centre distance \[mm\] of an external pair; `None` if the profile shifts are too small.
fn working_distance(
    teeth: f64,
    shift: f64,
    module: f64,
    helix: f64,
    pressure_angle: f64,
) -> Option<f64> {
    let transverse = (pressure_angle.tan() / helix.cos()).atan();
    let involute = |angle: f64| angle.tan() - angle;
    let wanted = involute(transverse) + 2.0 * shift * pressure_angle.tan() / teeth;
    if wanted <= 0.0 {
        return None;
    }
    // The involute function increases with the angle: bisection to the last digit.
    let (mut low, mut high) = (0.0_f64, 1.4_f64);
    for _ in 0..60 {
        let middle = 0.5 * (low + high);
        if involute(middle) < wanted {
            low = middle;
        } else {
            high = middle;
        }
    }
    let reference = 0.5 * module * teeth / helix.cos();
    Some(reference * transverse.cos() / low.cos())
}

fn summary(point: &OperatingPoint) -> String {
    let mut text = format!("load case {}", point.load_case.as_deref().unwrap_or("none"));
    if let Some(share) = point.share {
        let _ = write!(text, " ({share} %)");
    }
    let values = [
        ("torque", &point.torque, "N m"),
        ("speed", &point.speed, "1/min"),
        ("temperature", &point.temperature, "°C"),
    ];
    for (name, value, unit) in values {
        if let Some((value, _)) = value {
            let _ = write!(text, ", {name} {} {unit}", rounded(*value));
        }
    }
    text
}

/// A converted number without its rounding errors.
pub fn rounded(value: f64) -> String {
    let text = format!("{value:.9e}");
    text.parse::<f64>().map_or(text, |value| value.to_string())
}

/// A basic string of TOML.
pub fn quoted(text: &str) -> String {
    let mut out = String::from("\"");
    for c in text.chars() {
        match c {
            '"' | '\\' => {
                out.push('\\');
                out.push(c);
            }
            c if c.is_control() => {
                let _ = write!(out, "\\u{:04X}", u32::from(c));
            }
            c => out.push(c),
        }
    }
    out.push('"');
    out
}
