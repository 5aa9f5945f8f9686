//! Export formats, and the files of a map in a format.

use std::path::{Path, PathBuf};

use asperity_core::Fault;
use asperity_core::message::Warning;
use schemars::JsonSchema;
use serde::{Deserialize, Serialize};
use serde_json::json;

use super::added::AddedLoss;
use super::error;
use super::field::Field;
use super::names::degrees;
use super::{advisor, fitted, fmu, mat4, modelica, tables};
use crate::cycle::Cycle;
use crate::map::Map;

/// Export format.
#[derive(
    Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Deserialize, Serialize, JsonSchema,
)]
#[cfg_attr(feature = "clap", derive(clap::ValueEnum))]
#[serde(rename_all = "kebab-case")]
pub enum Format {
    /// Long table with the parts of the loss
    Csv,
    /// VECTO transmission loss map, .vtlm
    Vecto,
    /// Modelica CombiTable2Ds, .txt
    Modelica,
    /// MATLAB, Octave, scipy, Modelica: MAT-file level 4
    Matlab,
    /// FMI 2.0 model exchange and co-simulation, sources and, if cc is available, the library of this machine
    Fmu,
    /// CO2MPAS gear box efficiency parameters, fitted
    Co2mpas,
    /// fastsim transmission efficiency, one number
    Fastsim,
    /// ADVISOR transmission map, output side, .m
    Advisor,
}

impl Format {
    /// An error of the files in this format.
    fn refused(self, error: Fault) -> Fault {
        let name = json!(self);
        let about = error
            .about(name.as_str().unwrap_or_default())
            .about("export");
        match about.remedy().is_empty() {
            true => about.helping(
                "The map itself can be computed without exports; a format may need other axes.",
            ),
            false => about,
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

/// Additional data of the exports of a map.
#[derive(Debug, Clone, Copy, Default)]
pub struct With<'a> {
    /// Loss torque in addition to the mesh.
    pub added: Option<&'a AddedLoss>,
    /// Cycle that weights the formats with a single number.
    pub cycle: Option<&'a Cycle>,
    /// Folder or file next to which a library is compiled, in a draft; `None` for the folder of temporary files.
    pub beside: Option<&'a Path>,
}

impl With<'_> {
    /// Doubts about the tables.
    #[must_use]
    pub fn warnings(&self) -> Vec<Warning> {
        let of_cycle = self.cycle.iter().flat_map(|cycle| &cycle.warnings);
        let of_losses = self.added.iter().filter_map(|added| added.warning.as_ref());
        of_cycle.chain(of_losses).cloned().collect()
    }
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
        let fields = Field::all(map, index, with.added)?;
        let name = file_name(&finish.name);
        match format {
            Format::Matlab => files.push(file(&name, "mat", mat4::bytes(&fields))),
            Format::Csv => {
                files.push(file(&name, "csv", tables::csv(&fields, finish)?));
                if !finish.meshes.is_empty() {
                    let meshes = tables::meshes_csv(&fields)?;
                    files.push(file(&format!("{name}_meshes"), "csv", meshes));
                }
            }
            Format::Fmu => files.push(file(&name, "fmu", fmu::archive(&fields, with.beside)?)),
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

/// Checks that each of `finishes` has files of its own in a format, and that a format of one number has a cycle.
///
/// # Errors
/// When two of them would have files of one name, or the cycle is missing.
pub fn check(finishes: &[&str], format: Format, has_cycle: bool) -> Result<(), Fault> {
    let names = check_names(finishes, format);
    let checked = names.and_then(|()| match format == Format::Fastsim && !has_cycle {
        true => Err(error::no_cycle("fastsim")),
        false => Ok(()),
    });
    checked.map_err(|error| format.refused(error))
}

fn check_names(finishes: &[&str], format: Format) -> Result<(), Fault> {
    let mut taken: Vec<(String, &str)> = Vec::new();
    for finish in finishes {
        let name = file_name(finish);
        let names = match format {
            Format::Csv => vec![format!("{name}_meshes"), name],
            Format::Advisor => vec![advisor_name(&name)],
            _ => vec![name],
        };
        for name in names {
            // Some file systems take capitals for small letters.
            let name = name.to_lowercase();
            if let Some((_, other)) = taken.iter().find(|(taken, _)| *taken == name) {
                let finishes = [*other, *finish];
                return Err(error::same_file(finishes, &name));
            }
            taken.push((name, finish));
        }
    }
    Ok(())
}

/// The file of a format that holds one temperature.
fn of_field(
    field: &Field,
    format: Format,
    name: &str,
    with: With<'_>,
) -> Result<ExportFile, Fault> {
    Ok(match format {
        Format::Vecto => file(name, "vtlm", tables::vecto(field)?.into_bytes()),
        Format::Modelica => file(name, "txt", modelica::text(field)?.into_bytes()),
        Format::Fastsim => {
            let cycle = with.cycle.ok_or_else(|| error::no_cycle("fastsim"))?;
            let bytes = fitted::fastsim(field, cycle)?;
            file(&format!("{name}_fastsim"), "json", bytes)
        }
        _ => {
            let text = advisor::text(field)?;
            file(
                &format!("TX_{}", advisor_name(name)),
                "m",
                text.into_bytes(),
            )
        }
    })
}

fn file(name: &str, ending: &str, bytes: Vec<u8>) -> ExportFile {
    ExportFile {
        name: PathBuf::from(format!("{name}.{ending}")),
        bytes,
    }
}

/// A name that is valid in MATLAB.
fn advisor_name(name: &str) -> String {
    name.replace(['-', '.'], "_")
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
