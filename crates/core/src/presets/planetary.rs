//! Planetary sets that come with the program, with an operating point that fits them.

use serde::{Deserialize, Serialize};

use super::error::PresetError;
use super::figure::{Figure, FigureRow, check};
use super::gears::{OperationFigures, operation_rows, quoted};
use super::sources::{PresetSource, sources};
use crate::quantity::{Angle, Length};

const FILE: &str = "planetary.json";

/// A planetary set with an operating point of its sun.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct PlanetaryPreset {
    /// Name to ask for it by.
    pub name: String,
    /// Description of the set.
    pub title: String,
    /// Known and unknown properties.
    pub note: String,
    /// Numbers of teeth of sun, planet and ring, the last negative.
    pub teeth: Figure<[i32; 3]>,
    /// Number of planets.
    pub planets: Figure<u32>,
    /// Normal module.
    pub module: Figure<Length>,
    /// Normal pressure angle.
    pub pressure_angle: Figure<Angle>,
    /// Face widths.
    pub face_width: Figure<[Length; 3]>,
    /// Profile shift coefficients.
    pub profile_shift: Figure<[f64; 3]>,
    /// The operating point, of the sun.
    pub operation: OperationFigures,
    /// An oil of the library.
    pub oil: Figure<String>,
}

impl PlanetaryPreset {
    /// The numbers of the geometry, as a case file has them.
    pub fn gear_rows(&self) -> Vec<FigureRow<'_>> {
        vec![
            self.teeth.row("planetary.teeth", |z| format!("{z:?}")),
            self.planets.row("planetary.planets", u32::to_string),
            self.module.row("planetary.module", quoted),
            self.pressure_angle.row("planetary.pressure_angle", quoted),
            self.face_width.row("planetary.face_width", |widths| {
                format!("[{}]", widths.each_ref().map(quoted).join(", "))
            }),
            self.profile_shift
                .row("planetary.profile_shift", |x| format!("{x:?}")),
        ]
    }

    /// The numbers of the operating point and the oil, as a case file has them.
    pub fn operation_rows(&self) -> Vec<FigureRow<'_>> {
        operation_rows(&self.operation, &self.oil)
    }
}

/// All planetary sets.
///
/// # Errors
/// When a data file cannot be read; a test reads them.
///
/// ```
/// let sets = asperity_core::presets::planetary_sets()?;
/// assert_eq!(sets[0].teeth.value, [17, 22, -61]);
/// # Ok::<(), asperity_core::presets::PresetError>(())
/// ```
pub fn planetary_sets() -> Result<Vec<PlanetaryPreset>, PresetError> {
    let text = include_str!("../../data/presets/planetary.json");
    let sets: Vec<PlanetaryPreset> =
        serde_json::from_str(text).map_err(|error| PresetError::File {
            file: FILE,
            reason: error.to_string(),
        })?;
    let sources: Vec<PresetSource> = sources()?;
    for set in &sets {
        let mut rows = set.gear_rows();
        rows.extend(set.operation_rows());
        check(&set.name, &rows, &sources)?;
    }
    Ok(sets)
}
