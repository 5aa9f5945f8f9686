//! Gear pairs that come with the program, with an operating point that fits them.

use serde::{Deserialize, Serialize};

use super::error::PresetError;
use super::figure::{Figure, FigureRow, check};
use super::sources::{PresetSource, sources};
use crate::quantity::{Angle, AngularSpeed, Length, Quantity, Temperature, Torque};

const FILE: &str = "gears.json";

/// A gear pair with an operating point.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct GearPreset {
    /// Name to ask for it by.
    pub name: String,
    /// Description of the gears.
    pub title: String,
    /// Known and unknown properties.
    pub note: String,
    /// The geometry.
    pub gears: GearFigures,
    /// The operating point.
    pub operation: OperationFigures,
    /// An oil of the library.
    pub oil: Figure<String>,
}

/// Geometry of a pair, pinion then wheel, as in a case file.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct GearFigures {
    /// Numbers of teeth.
    pub teeth: Figure<[u32; 2]>,
    /// Normal module.
    pub module: Figure<Length>,
    /// Helix angle.
    pub helix: Figure<Angle>,
    /// Normal pressure angle.
    pub pressure_angle: Figure<Angle>,
    /// Face widths.
    pub face_width: Figure<[Length; 2]>,
    /// Profile shift coefficients.
    pub profile_shift: Figure<[f64; 2]>,
    /// Tip diameters, where they do not follow from an addendum of one module.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub tip_diameter: Option<Figure<[Length; 2]>>,
}

/// An operating point, at the pinion.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct OperationFigures {
    /// Torque of the pinion.
    pub torque: Figure<Torque>,
    /// Speed of the pinion.
    pub speed: Figure<AngularSpeed>,
    /// Bulk temperature of the flanks.
    pub temperature: Figure<Temperature>,
}

pub(super) fn quoted<Q: Quantity>(value: &Q) -> String {
    format!("\"{value}\"")
}

fn both<Q: Quantity>(values: &[Q; 2]) -> String {
    if values[0] == values[1] {
        quoted(&values[0])
    } else {
        format!("[{}, {}]", quoted(&values[0]), quoted(&values[1]))
    }
}

impl GearPreset {
    /// The numbers of the geometry, as a case file has them.
    pub fn gear_rows(&self) -> Vec<FigureRow<'_>> {
        let gears = &self.gears;
        let mut rows = vec![
            gears.teeth.row("gears.teeth", |z| format!("{z:?}")),
            gears.module.row("gears.module", quoted),
            gears.helix.row("gears.helix", quoted),
            gears.pressure_angle.row("gears.pressure_angle", quoted),
            gears.face_width.row("gears.face_width", both),
            (gears.profile_shift).row("gears.profile_shift", |x| format!("{x:?}")),
        ];
        let tip = gears.tip_diameter.as_ref();
        rows.extend(tip.map(|tip| {
            tip.row("gears.tip_diameter", |[a, b]| {
                format!("[{}, {}]", quoted(a), quoted(b))
            })
        }));
        rows
    }

    /// The numbers of the operating point and the oil, as a case file has them.
    pub fn operation_rows(&self) -> Vec<FigureRow<'_>> {
        operation_rows(&self.operation, &self.oil)
    }

    /// Every number.
    pub fn rows(&self) -> Vec<FigureRow<'_>> {
        let mut rows = self.gear_rows();
        rows.extend(self.operation_rows());
        rows
    }
}

/// The numbers of an operating point and an oil, as a case file has them.
pub(super) fn operation_rows<'a>(
    operation: &'a OperationFigures,
    oil: &'a Figure<String>,
) -> Vec<FigureRow<'a>> {
    vec![
        operation.torque.row("operation.torque", quoted),
        operation.speed.row("operation.speed", quoted),
        operation
            .temperature
            .row("operation.bulk_temperature", quoted),
        oil.row("lubricant.oil", |oil| format!("\"{oil}\"")),
    ]
}

/// The gears in `text`, whose numbers all have a source in `sources`.
///
/// # Errors
/// When the text does not describe gears, a number has no certainty, or its source is not in the list.
pub fn read_gears(text: &str, sources: &[PresetSource]) -> Result<Vec<GearPreset>, PresetError> {
    let gears: Vec<GearPreset> = serde_json::from_str(text).map_err(|error| PresetError::File {
        file: FILE,
        reason: error.to_string(),
    })?;
    for gears in &gears {
        check(&gears.name, &gears.rows(), sources)?;
    }
    Ok(gears)
}

/// All gears.
///
/// # Errors
/// When a data file cannot be read; a test reads them.
///
/// ```
/// let gears = asperity_core::presets::gears()?;
/// assert!(gears.iter().any(|gears| gears.name == "fzg-c"));
/// # Ok::<(), asperity_core::presets::PresetError>(())
/// ```
pub fn gears() -> Result<Vec<GearPreset>, PresetError> {
    let text = include_str!("../../data/presets/gears.json");
    read_gears(text, &sources()?)
}

/// The gears of this name, whatever the case of its letters.
///
/// # Errors
/// When no gears have the name.
pub fn gear(name: &str) -> Result<GearPreset, PresetError> {
    let mut gears = gears()?;
    let index = (gears.iter()).position(|one| one.name.eq_ignore_ascii_case(name.trim()));
    index
        .map(|index| gears.swap_remove(index))
        .ok_or_else(|| PresetError::Unknown {
            kind: "gears",
            name: name.to_owned(),
            known: gears.into_iter().map(|gears| gears.name).collect(),
        })
}

/// The gear trains: names of gears without their number, and the gears `name-1`, `name-2` and so on, from input to output.
///
/// # Errors
/// When a data file cannot be read.
///
/// ```
/// let trains = asperity_core::presets::trains()?;
/// let (name, stages) = trains.iter().find(|(name, _)| name == "vw-id3").unwrap();
/// assert_eq!((name.as_str(), stages.len()), ("vw-id3", 2));
/// # Ok::<(), asperity_core::presets::PresetError>(())
/// ```
pub fn trains() -> Result<Vec<(String, Vec<GearPreset>)>, PresetError> {
    let mut trains: Vec<(String, Vec<GearPreset>)> = Vec::new();
    for stage in gears()? {
        let Some((name, number)) = stage.name.rsplit_once('-') else {
            continue;
        };
        let name = name.to_owned();
        match (number, trains.last_mut()) {
            ("1", _) => trains.push((name, vec![stage])),
            (number, Some((last, stages)))
                if *last == name && number == (stages.len() + 1).to_string() =>
            {
                stages.push(stage);
            }
            _ => {}
        }
    }
    trains.retain(|(_, stages)| stages.len() > 1);
    Ok(trains)
}
