//! The parts of a gearbox with their numbers checked.

use std::path::Path;
use std::sync::Arc;

use asperity_core::DomainError;
use asperity_core::quantity::{Force, Length, Speed, Temperature, Torque, VolumeFlow};
use asperity_efficiency::EfficiencyError;
use asperity_efficiency::loss_table::LossTable;
use asperity_efficiency::rolling_bearing::{BearingConstants, BearingForm, RollingBearing};
use asperity_efficiency::shaft_seal::seal_torque;

use super::error::CaseError;
use super::files::{Content, LOSS_TABLE, Reader};
use super::gearbox_input::{BearingInput, BearingKind, GearboxInput, JetInput, Shaft};
use super::source::Source;
use crate::loss_table::read;

/// The parts of a gearbox that lose beside the mesh.
#[derive(Debug, Clone, PartialEq)]
pub struct Gearbox {
    /// Temperature of their oil; none for that of the operation.
    pub temperature: Option<Temperature>,
    /// The parts, in the order of the case file.
    pub parts: Vec<Part>,
}

/// A part that loses.
#[derive(Debug, Clone, PartialEq)]
pub struct Part {
    /// Its name.
    pub name: String,
    /// What it is.
    pub kind: PartKind,
}

/// A part by its kind.
#[derive(Debug, Clone, PartialEq)]
pub enum PartKind {
    /// Shaft seal.
    Seal {
        /// Its shaft.
        shaft: Shaft,
        /// Diameter of the shaft.
        diameter: Length,
    },
    /// Rolling bearing.
    Bearing {
        /// Its shaft.
        shaft: Shaft,
        /// Geometry and constants.
        bearing: RollingBearing,
        /// Radial and axial load.
        load: [Force; 2],
        /// Torque at the pinion at which the loads are as stated; none where they are constant.
        at_torque: Option<Torque>,
    },
    /// Oil jet.
    Jet {
        /// Flow.
        flow: VolumeFlow,
        /// Speed at the nozzle.
        speed: Speed,
    },
    /// Loss torque at the pinion over torque, speed and temperature.
    Table(Arc<LossTable>),
}

/// Place of the seals.
const SEALS: &str = "gearbox.seals";
/// Place of the bearings.
const BEARINGS: &str = "gearbox.bearings";
/// Place of the jet.
const JET: &str = "gearbox.jet";

/// The gearbox of a case, with its table read.
pub(super) fn gearbox(
    given: &GearboxInput,
    source: &Source,
    files: &Reader<'_>,
) -> Result<Gearbox, CaseError> {
    let mut parts = Vec::new();
    for (number, seal) in given.seals.iter().enumerate() {
        let name = named(seal.name.as_deref(), "seal", number);
        seal_torque(seal.diameter).map_err(refused(source, SEALS, &name))?;
        let (shaft, diameter) = (seal.shaft, seal.diameter);
        let kind = PartKind::Seal { shaft, diameter };
        parts.push(Part { name, kind });
    }
    for (number, bearing) in given.bearings.iter().enumerate() {
        let name = named(bearing.name.as_deref(), "bearing", number);
        let kind = rolling_bearing(bearing).map_err(refused(source, BEARINGS, &name))?;
        parts.push(Part { name, kind });
    }
    if let Some(JetInput { flow, speed }) = given.jet {
        let name = "oil jet".to_owned();
        let checked = DomainError::positive("flow", flow)
            .and_then(|_| DomainError::non_negative("speed", speed));
        checked.map_err(|error| refused(source, JET, &name)(error.into()))?;
        let kind = PartKind::Jet { flow, speed };
        parts.push(Part { name, kind });
    }
    if let Some(file) = &given.loss_table {
        parts.push(table(file, source, files)?);
    }
    if parts.is_empty() {
        return Err(CaseError::Conflict {
            place: source.place_of_key("gearbox"),
            key: "gearbox",
            rule: "names nothing that loses; give seals, bearings, jet or loss_table, or leave it out",
        });
    }
    Ok(Gearbox {
        temperature: given.temperature,
        parts,
    })
}

fn named(given: Option<&str>, kind: &str, number: usize) -> String {
    given.map_or_else(|| format!("{kind} {}", number + 1), str::to_owned)
}

fn refused<'a>(
    source: &'a Source,
    key: &'static str,
    part: &'a str,
) -> impl Fn(EfficiencyError) -> CaseError + use<'a> {
    move |error| CaseError::GearboxPart {
        place: source.place_of(key),
        key,
        part: part.to_owned(),
        source: error,
    }
}

fn rolling_bearing(given: &BearingInput) -> Result<PartKind, EfficiencyError> {
    let axial = given.axial.unwrap_or(Force::from_si(0.0));
    DomainError::positive("radial", given.radial)?;
    DomainError::non_negative("axial", axial)?;
    let positive = "is needed here, and must be greater than zero";
    let needed = |name, value: Option<f64>, unit| {
        let value = value.unwrap_or(f64::NAN);
        DomainError::require(value > 0.0, name, value, unit, positive)
    };
    let unused = |name, value: Option<f64>, unit| match value {
        None => Ok(0.0),
        Some(value) => {
            DomainError::require(false, name, value, unit, "is of another kind of bearing")
        }
    };
    let rating = given.static_rating.map(Force::si);
    let form = match given.kind {
        BearingKind::DeepGrooveBall => {
            unused("axial_factor", given.axial_factor, "-")?;
            let rating = needed("static_rating", rating, "N")?;
            BearingForm::DeepGrooveBall {
                static_rating: Force::from_si(rating),
            }
        }
        BearingKind::CylindricalRoller => {
            unused("axial_factor", given.axial_factor, "-")?;
            unused("static_rating", rating, "N")?;
            unused("r2", given.r2, "-")?;
            BearingForm::CylindricalRoller
        }
        BearingKind::TaperedRoller => {
            unused("static_rating", rating, "N")?;
            BearingForm::TaperedRoller {
                axial_factor: needed("axial_factor", given.axial_factor, "-")?,
            }
        }
    };
    let r2 = match given.kind {
        BearingKind::CylindricalRoller => 0.0,
        _ => needed("r2", given.r2, "-")?,
    };
    if let Some(torque) = given.at_torque {
        let (value, rule) = (torque.si(), "must be finite and not zero");
        let holds = value.is_finite() && value != 0.0;
        DomainError::require(holds, "at_torque", value, "N m", rule)?;
    }
    let bearing = RollingBearing {
        form,
        bore: given.bore,
        outside_diameter: given.outside_diameter,
        constants: BearingConstants {
            r1: given.r1,
            r2,
            s1: given.s1,
            s2: given.s2,
            k_z: given.k_z,
            k_rs: given.k_rs,
            mu_bl: given.mu_bl,
            mu_ehl: given.mu_ehl,
        },
    };
    bearing.check()?;
    Ok(PartKind::Bearing {
        shaft: given.shaft,
        bearing,
        load: [given.radial, axial],
        at_torque: given.at_torque,
    })
}

fn table(file: &Path, source: &Source, files: &Reader<'_>) -> Result<Part, CaseError> {
    let key = LOSS_TABLE;
    let name = file
        .file_name()
        .unwrap_or(file.as_os_str())
        .to_string_lossy();
    let bytes = match files.open(file, source, key)? {
        (Content::Bytes(bytes), _) => bytes,
        (Content::Heights(_), _) => {
            return Err(CaseError::Value {
                place: source.place_of(key),
                key: Some(key.to_owned()),
                message: "names a trace, not a table of losses".to_owned(),
            });
        }
    };
    let table =
        read(&name, &String::from_utf8_lossy(&bytes)).map_err(|error| CaseError::LossTable {
            place: source.place_of(key),
            key,
            source: error,
        })?;
    Ok(Part {
        name: name.into_owned(),
        kind: PartKind::Table(Arc::new(table)),
    })
}
