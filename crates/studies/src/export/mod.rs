//! Maps in the formats of vehicle simulation and of tables.
//!
//! Every file says what loses: the mesh alone, or the mesh and what a table of the user's adds. Signs: torque of the
//! input shaft, which is the pinion's; negative where the output drives. Loss torque is that of the input shaft and
//! never negative. Loss depends on the torque with its sign and on the speed without.
//!
//! | format | to |
//! |---|---|
//! | [`Format::Csv`] | anything: a row per node, mesh and added loss apart |
//! | [`Format::Vecto`] | VECTO, `.vtlm` |
//! | [`Format::Modelica`] | `CombiTable2Ds` of the Modelica Standard Library, text |
//! | [`Format::Matlab`] | MATLAB, Octave, scipy, Modelica: MAT-file level 4 |
//! | [`Format::Fmu`] | FMI 2.0, model exchange and co-simulation |
//! | [`Format::Co2mpas`] | three parameters of a gear box, fitted, with what is left of the fit |
//! | [`Format::Fastsim`] | one efficiency, weighted by a cycle |
//! | [`Format::Advisor`] | efficiency over speed and torque of the output shaft, `.m` |

mod added;
mod advisor;
mod field;
mod fitted;
mod fmu;
mod mat4;
mod modelica;
mod tables;

use std::path::PathBuf;

use crate::cycle::Cycle;
use crate::map::Map;

pub use added::{AddedLoss, AddedLossError};
pub use field::Field;
pub use fitted::{GearBoxFit, gear_box_fit};
pub use fmu::c_source;
pub use mat4::{Mat4, Matrix};

/// A format.
#[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord)]
pub enum Format {
    /// Long table.
    Csv,
    /// VECTO transmission loss map.
    Vecto,
    /// Modelica table as text.
    Modelica,
    /// MAT-file level 4.
    Matlab,
    /// Functional mock-up unit.
    Fmu,
    /// CO2MPAS gear box parameters.
    Co2mpas,
    /// fastsim efficiency.
    Fastsim,
    /// ADVISOR transmission.
    Advisor,
}

/// A file to be written.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct ExportFile {
    /// Name, relative to the folder of the exports.
    pub name: PathBuf,
    /// Content.
    pub bytes: Vec<u8>,
}

/// Why a map cannot be written in a format.
#[derive(Debug, thiserror::Error)]
#[non_exhaustive]
pub enum ExportError {
    /// A point has no result.
    #[error("finish {finish}: points of the map have no result, so nothing is exported")]
    Holes {
        /// Name of the finish.
        finish: String,
    },
    /// The format needs torques of both signs.
    #[error("{format} needs torques of both signs, from beyond the smallest to beyond the largest")]
    OneSign {
        /// The format.
        format: &'static str,
    },
    /// The format needs more than one node along both axes.
    #[error("{format} needs at least two torques and two speeds")]
    TooSmall {
        /// The format.
        format: &'static str,
    },
    /// The loss torque rises faster than the torque.
    #[error(
        "{format} cannot hold this map: near {torque_nm} N m and {speed_rpm} 1/min the loss torque rises faster than the torque"
    )]
    Slope {
        /// The format.
        format: &'static str,
        /// Torque \[N m\].
        torque_nm: f64,
        /// Speed \[1/min\].
        speed_rpm: f64,
    },
    /// The format weighs by a cycle.
    #[error("{format} takes one number, weighted by a cycle, and no cycle was given")]
    NoCycle {
        /// The format.
        format: &'static str,
    },
    /// The added loss does not fit.
    #[error(transparent)]
    Added(#[from] AddedLossError),
    /// A value that cannot be written.
    #[error("cannot be written: {0}")]
    Json(#[from] serde_json::Error),
    /// An archive that cannot be made.
    #[error("cannot be written: {0}")]
    Zip(#[from] zip::result::ZipError),
    /// The system refused.
    #[error("cannot be written: {0}")]
    Io(#[from] std::io::Error),
}

/// What goes with a map into its exports.
#[derive(Debug, Clone, Copy, Default)]
pub struct With<'a> {
    /// Loss torque beside that of the mesh.
    pub added: Option<&'a AddedLoss>,
    /// The cycle that weighs the formats of one number.
    pub cycle: Option<&'a Cycle>,
}

/// The files of `map` in one format: of every finish and, where the format holds but one, of every temperature.
///
/// # Errors
/// When a point has no result, or the format cannot hold the map.
pub fn export(map: &Map, format: Format, with: With<'_>) -> Result<Vec<ExportFile>, ExportError> {
    let mut files = Vec::new();
    for (index, finish) in map.finishes.iter().enumerate() {
        let fields = Field::all(map, index, with.added)?;
        let name = file_name(&finish.name);
        match format {
            Format::Matlab => files.push(file(&name, "mat", mat4::bytes(&fields))),
            Format::Csv => files.push(file(&name, "csv", tables::csv(&fields, finish)?)),
            Format::Co2mpas => files.push(file(
                &format!("{name}_co2mpas"),
                "json",
                fitted::co2mpas(&fields)?,
            )),
            _ => {
                for field in &fields {
                    let name = match fields.len() {
                        1 => name.clone(),
                        _ => format!("{name}_{}", degrees(field.temperature_c)),
                    };
                    files.push(of_field(field, format, &name, with)?);
                }
            }
        }
    }
    Ok(files)
}

fn of_field(
    field: &Field,
    format: Format,
    name: &str,
    with: With<'_>,
) -> Result<ExportFile, ExportError> {
    Ok(match format {
        Format::Vecto => file(name, "vtlm", tables::vecto(field)?.into_bytes()),
        Format::Modelica => file(name, "txt", modelica::text(field)?.into_bytes()),
        Format::Advisor => {
            let text = advisor::text(field)?;
            file(
                &format!("TX_{}", name.replace(['-', '.'], "_")),
                "m",
                text.into_bytes(),
            )
        }
        Format::Fastsim => {
            let cycle = with
                .cycle
                .ok_or(ExportError::NoCycle { format: "fastsim" })?;
            let bytes = fitted::fastsim(field, cycle)?;
            file(&format!("{name}_fastsim"), "json", bytes)
        }
        _ => file(name, "fmu", fmu::archive(field)?),
    })
}

fn file(name: &str, ending: &str, bytes: Vec<u8>) -> ExportFile {
    ExportFile {
        name: PathBuf::from(format!("{name}.{ending}")),
        bytes,
    }
}

/// A name that every file system and every program takes.
fn file_name(name: &str) -> String {
    let is_plain = |c: char| c.is_ascii_alphanumeric() || c == '-' || c == '_';
    let plain: String = name
        .chars()
        .map(|c| if is_plain(c) { c } else { '_' })
        .collect();
    if plain.is_empty() {
        "map".to_owned()
    } else {
        plain
    }
}

/// "60c", "m30c", "62p5c".
fn degrees(temperature_c: f64) -> String {
    let size = format!("{}", temperature_c.abs()).replace('.', "p");
    let sign = if temperature_c < 0.0 { "m" } else { "" };
    format!("{sign}{size}c")
}
