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
use super::files::{Content, Reader};
use super::gearbox_input::{BearingInput, BearingKind, GearboxInput, JetInput, Shaft};
use super::section::Section;
use super::source::Source;
use crate::loss_table::read;

/// The parts of a gearbox with losses, in addition to the mesh.
#[derive(Debug, Clone, PartialEq)]
pub struct Gearbox {
    /// Temperature of their oil; `None` for the temperature of the operation.
    pub temperature: Option<Temperature>,
    /// The parts, in the order of the case file.
    pub parts: Vec<Part>,
}

/// A part with a loss.
#[derive(Debug, Clone, PartialEq)]
pub struct Part {
    /// Name.
    pub name: String,
    /// Kind, with its numbers.
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
        /// Torque at the pinion at which the loads are as stated; `None` if they are constant.
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

/// The gearbox of a case, with its table read.
pub(super) fn gearbox(
    stated: &GearboxInput,
    source: &Source,
    files: &Reader<'_>,
) -> Result<Gearbox, CaseError> {
    let GearboxInput {
        temperature,
        loss_table,
        seals,
        bearings,
        jet,
    } = stated;
    let section = Section::of(source, "gearbox");
    let mut parts = Vec::new();
    for (number, seal) in seals.iter().enumerate() {
        let name = named(seal.name.as_deref(), "seal", number);
        seal_torque(seal.diameter).map_err(refused(section, "seals", &name))?;
        let (shaft, diameter) = (seal.shaft, seal.diameter);
        let kind = PartKind::Seal { shaft, diameter };
        parts.push(Part { name, kind });
    }
    for (number, bearing) in bearings.iter().enumerate() {
        let name = named(bearing.name.as_deref(), "bearing", number);
        let kind = loaded_bearing(bearing).map_err(refused(section, "bearings", &name))?;
        parts.push(Part { name, kind });
    }
    if let Some(JetInput { flow, speed }) = *jet {
        let name = "oil jet".to_owned();
        check_jet(flow, speed).map_err(refused(section, "jet", &name))?;
        let kind = PartKind::Jet { flow, speed };
        parts.push(Part { name, kind });
    }
    if let Some(file) = loss_table {
        let (name, table) = table(file, (section, "loss_table"), files)?;
        let kind = PartKind::Table(table);
        parts.push(Part { name, kind });
    }
    if parts.is_empty() {
        let rule =
            "names nothing that loses; give seals, bearings, jet or loss_table, or leave it out";
        return Err(section.conflict_of_key("", rule));
    }
    Ok(Gearbox {
        temperature: *temperature,
        parts,
    })
}

pub(super) fn named(stated: Option<&str>, kind: &str, number: usize) -> String {
    stated.map_or_else(|| format!("{kind} {}", number + 1), str::to_owned)
}

pub(super) fn refused<'a>(
    section: Section<'a>,
    key: &'a str,
    part: &'a str,
) -> impl Fn(EfficiencyError) -> CaseError + use<'a> {
    move |error| CaseError::gearbox_part(section.place(key), section.key(key), part, error)
}

/// A bearing of a pair of gears with its stated load.
fn loaded_bearing(stated: &BearingInput) -> Result<PartKind, EfficiencyError> {
    let &BearingInput {
        shaft,
        at,
        locating,
        planet_mass,
        per_planet,
        radial,
        axial,
        at_torque,
        ..
    } = stated;
    let rule = "is of a gear train, where the load of a bearing follows from the teeth";
    let of_train = [
        at.map(|_| "at"),
        locating.map(|_| "locating"),
        planet_mass.map(|_| "planet_mass"),
        per_planet.map(|_| "per_planet"),
    ];
    for name in of_train.into_iter().flatten() {
        DomainError::require(false, name, f64::NAN, "-", rule)?;
    }
    let radial = radial.unwrap_or(Force::from_si(f64::NAN));
    let axial = axial.unwrap_or(Force::from_si(0.0));
    DomainError::positive("radial", radial)?;
    DomainError::non_negative("axial", axial)?;
    if let Some(torque) = at_torque {
        let (value, rule) = (torque.si(), "must be finite and not zero");
        let holds = value.is_finite() && value != 0.0;
        DomainError::require(holds, "at_torque", value, "N m", rule)?;
    }
    Ok(PartKind::Bearing {
        shaft,
        bearing: rolling_bearing(stated)?,
        load: [radial, axial],
        at_torque,
    })
}

/// A rolling bearing with the constants that its kind needs.
pub(super) fn rolling_bearing<S>(
    stated: &BearingInput<S>,
) -> Result<RollingBearing, EfficiencyError> {
    let &BearingInput {
        name: _,
        shaft: _,
        kind,
        bore,
        outside_diameter,
        at: _,
        locating: _,
        planet_mass: _,
        per_planet: _,
        radial: _,
        axial: _,
        at_torque: _,
        static_rating,
        axial_factor,
        r1,
        r2,
        s1,
        s2,
        k_z,
        k_rs,
        mu_bl,
        mu_ehl,
    } = stated;
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
    let rating = static_rating.map(Force::si);
    let form = match kind {
        BearingKind::DeepGrooveBall => {
            unused("axial_factor", axial_factor, "-")?;
            let rating = needed("static_rating", rating, "N")?;
            BearingForm::DeepGrooveBall {
                static_rating: Force::from_si(rating),
            }
        }
        BearingKind::CylindricalRoller => {
            unused("axial_factor", axial_factor, "-")?;
            unused("static_rating", rating, "N")?;
            unused("r2", r2, "-")?;
            BearingForm::CylindricalRoller
        }
        BearingKind::TaperedRoller => {
            unused("static_rating", rating, "N")?;
            BearingForm::TaperedRoller {
                axial_factor: needed("axial_factor", axial_factor, "-")?,
            }
        }
    };
    let r2 = match kind {
        BearingKind::CylindricalRoller => 0.0,
        _ => needed("r2", r2, "-")?,
    };
    let bearing = RollingBearing {
        form,
        bore,
        outside_diameter,
        constants: BearingConstants {
            r1,
            r2,
            s1,
            s2,
            k_z,
            k_rs,
            mu_bl,
            mu_ehl,
        },
    };
    bearing.check()?;
    Ok(bearing)
}

/// Name and content of the table `file`, which is stated at `key`.
pub(super) fn table(
    file: &Path,
    (section, key): (Section<'_>, &str),
    files: &Reader<'_>,
) -> Result<(String, Arc<LossTable>), CaseError> {
    let name = file
        .file_name()
        .unwrap_or(file.as_os_str())
        .to_string_lossy();
    let bytes = match files.open(file, section.source, section.key(key).into_owned())? {
        (Content::Bytes(bytes), _) => bytes,
        (Content::Heights(_), _) => {
            return Err(section.value(key, "names a trace, not a table of losses"));
        }
    };
    let table = read(&name, &String::from_utf8_lossy(&bytes))
        .map_err(|error| CaseError::loss_table(section.place(key), &section.key(key), error))?;
    Ok((name.into_owned(), Arc::new(table)))
}

/// Checks the numbers of a jet.
pub(super) fn check_jet(flow: VolumeFlow, speed: Speed) -> Result<(), EfficiencyError> {
    DomainError::positive("flow", flow)?;
    DomainError::non_negative("speed", speed)?;
    Ok(())
}
