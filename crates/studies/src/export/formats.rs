//! Export formats, and the files of a map in a format.

use std::path::PathBuf;

use asperity_core::Fault;
use schemars::JsonSchema;
use serde::{Deserialize, Serialize};
use serde_json::json;

use super::error;
use super::field::Field;
use super::given::{ExportGiven, With};
use super::names::degrees;
use super::{efficiency, fmu, lossy_gear, mat5, modelica, tables};
use crate::map::Map;

/// Function that makes a file of a format.
enum FormatWriter {
    /// One file, which holds every temperature; `None` where the map has nothing for it.
    Whole(fn(&ExportGiven<'_>) -> Result<Option<Vec<u8>>, Fault>),
    /// A file for each temperature.
    Each(fn(&Field, &With<'_>) -> Result<Vec<u8>, Fault>),
}

/// Facts about a format.
struct ExportRow {
    format: Format,
    holds: &'static str,
    files: &'static [(&'static str, FormatWriter)],
}

/// Place of the name of a finish in the pattern of a file.
const NAME: &str = "NAME";

/// Rows `Format "content" { "pattern of a file" function that makes it, ... }`.
macro_rules! exports {
    ($($name:ident $holds:literal { $($file:literal $kind:ident($write:expr)),+ })+) => {
        /// Export format.
        #[derive(
            Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Deserialize, Serialize, JsonSchema,
        )]
        #[cfg_attr(feature = "clap", derive(clap::ValueEnum))]
        #[serde(rename_all = "kebab-case")]
        pub enum Format {
            $(#[doc = $holds] $name),+
        }

        impl Format {
            /// Every format.
            pub const ALL: &[Self] = &[$(Self::$name),+];
        }

        const ROWS: &[ExportRow] = &[$(ExportRow {
            format: Format::$name,
            holds: $holds,
            files: &[$(($file, FormatWriter::$kind($write))),+],
        }),+];
    };
}

exports! {
    Csv "Table with a row per node: mesh, added and whole loss torque; of a gear train also one with a row per node and mesh" {
        "NAME.csv" Whole(tables::csv),
        "NAME_meshes.csv" Whole(tables::meshes_csv)
    }
    Wide "Table of the loss torque in N m, torque in N m down and speed in 1/min across" {
        "NAME_loss_torque_nm.csv" Each(tables::wide)
    }
    Vecto "VECTO transmission loss map; an error without torques of both signs, or where the loss rises faster than the torque" {
        "NAME.vtlm" Each(tables::vecto)
    }
    Modelica "Table lossTorque of CombiTable2Ds of the Modelica Standard Library: u1 torque in N m, u2 speed in rad/s" {
        "NAME.txt" Each(modelica::text)
    }
    LossyGear "Matrix lossTable of LossyGear of the Modelica Standard Library, fitted at each speed; with the residual of the fit" {
        "NAME_lossy_gear.mat" Each(lossy_gear::bytes)
    }
    Matlab "MATLAB, Simulink, Octave, scipy: arrays over torque, speed and temperature in a MAT-file of level 5" {
        "NAME.mat" Whole(mat5::of_fields)
    }
    Fmu "FMI 2.0 model exchange and co-simulation: sources and, if cc is available, the library of this machine" {
        "NAME.fmu" Whole(fmu::archive)
    }
    Fastsim "FASTSim transmission of a vehicle: one efficiency, weighted by the cycle" {
        "NAME_fastsim.yaml" Each(efficiency::fastsim)
    }
}

impl Format {
    /// Content of the files of this format, in words.
    #[must_use]
    pub fn holds(self) -> &'static str {
        self.row().holds
    }

    /// Patterns of the names of the files, with `NAME` for the finish and, of several temperatures in a format that holds
    /// one, the temperature.
    pub fn files(self) -> impl Iterator<Item = &'static str> {
        self.row().files.iter().map(|(pattern, _)| *pattern)
    }

    fn row(self) -> &'static ExportRow {
        let index = ROWS.iter().position(|row| row.format == self);
        &ROWS[index.unwrap_or_default()]
    }

    /// An error of the files in this format.
    fn refused(self, error: Fault) -> Fault {
        let name = json!(self);
        let about = error
            .about(name.as_str().unwrap_or_default())
            .about("export");
        if about.remedy().is_empty() {
            about.helping(
                "The map itself can be computed without exports; a format may need other axes.",
            )
        } else {
            about
        }
    }
}

/// File to write.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct ExportFile {
    /// Name, relative to the folder of the exports.
    pub name: PathBuf,
    /// Content.
    pub bytes: Vec<u8>,
}

/// Files of `map` in one format: one per finish and, if the format holds only one temperature, one per temperature.
///
/// # Errors
/// When a point has no result, the format cannot hold the map, or two finishes would have files of one name.
pub fn export(map: &Map, format: Format, with: With<'_>) -> Result<Vec<ExportFile>, Fault> {
    let names = map.finishes.iter().map(|finish| finish.name.as_str());
    let names: Vec<&str> = names.collect();
    check(&names, format, with.cycle.is_some())?;
    files_of(map, format, with).map_err(|error| format.refused(error))
}

fn files_of(map: &Map, format: Format, with: With<'_>) -> Result<Vec<ExportFile>, Fault> {
    let mut files = Vec::new();
    for (index, finish) in map.finishes.iter().enumerate() {
        let fields = &Field::all(map, index, with.added)?[..];
        let name = file_name(&finish.name);
        let mut push = |pattern: &str, name: &str, bytes| {
            let name = PathBuf::from(pattern.replace(NAME, name));
            files.push(ExportFile { name, bytes });
        };
        for (pattern, writer) in format.row().files {
            match writer {
                FormatWriter::Whole(write) => {
                    let given = ExportGiven {
                        fields,
                        finish,
                        with,
                    };
                    if let Some(bytes) = write(&given)? {
                        push(pattern, &name, bytes);
                    }
                }
                FormatWriter::Each(write) => {
                    for field in fields {
                        let name = match fields.len() {
                            1 => name.clone(),
                            _ => format!("{name}_{}", degrees(field.temperature_c)),
                        };
                        push(pattern, &name, write(field, &with)?);
                    }
                }
            }
        }
    }
    Ok(files)
}

/// Checks that each of `finishes` has files of its own in a format, and that a format of one number has a cycle.
///
/// # Errors
/// When two of them would have files of one name, or the cycle is missing.
pub fn check(finishes: &[&str], format: Format, has_cycle: bool) -> Result<(), Fault> {
    let names = check_names(finishes, format);
    let checked = names.and_then(|()| {
        if format == Format::Fastsim && !has_cycle {
            Err(error::no_cycle("fastsim"))
        } else {
            Ok(())
        }
    });
    checked.map_err(|error| format.refused(error))
}

fn check_names(finishes: &[&str], format: Format) -> Result<(), Fault> {
    let mut taken: Vec<(String, &str)> = Vec::new();
    for finish in finishes {
        for pattern in format.files() {
            // Some file systems take capitals for small letters.
            let name = pattern.replace(NAME, &file_name(finish)).to_lowercase();
            if let Some((_, other)) = taken.iter().find(|(taken, _)| *taken == name) {
                let finishes = [*other, *finish];
                return Err(error::same_file(finishes, &name));
            }
            taken.push((name, finish));
        }
    }
    Ok(())
}

/// A name that is valid in all file systems and programs.
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
