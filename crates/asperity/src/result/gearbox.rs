//! Losses of the gearbox in addition to the mesh, as its user states them.
//!
//! The mesh is computed with the whole torque of the case, and all losses count against the power in: what bearings and
//! seals take before the mesh is not taken off its torque. No band belongs to these parts.

use asperity_core::OutOfRange;
use asperity_core::quantity::{AngularSpeed, Force, Power, Speed, Temperature, Torque, VolumeFlow};
use asperity_efficiency::loss_table::LossTable;
use asperity_efficiency::oil_jet::jet_power;
use asperity_efficiency::output_torque::{MeshOperation, power_flow};
use asperity_efficiency::shaft_seal::seal_torque;
use serde::{Deserialize, Serialize};

use crate::result::Uncertainty;
use asperity_case::case::{Case, OperationInput, Part, PartKind, Shaft};
use asperity_case::error::PositionError;

/// Scope of a result.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default, Serialize, Deserialize)]
#[serde(rename_all = "kebab-case")]
pub enum Scope {
    /// The mesh only: no bearings, seals, churning.
    #[default]
    Mesh,
    /// The mesh and the parts of the gearbox that the user states.
    Gearbox,
}

/// Loss and efficiency of the gearbox: of the mesh by the model, of all else as the user states it.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
#[non_exhaustive]
pub struct GearboxReport {
    /// η = 1 − (mesh and parts)/power in.
    pub efficiency: f64,
    /// Losses of mesh and parts together \[W\].
    pub loss_w: f64,
    /// Losses of the parts \[W\], from the user's input, without an uncertainty.
    pub parts_w: f64,
    /// Power into the gearbox \[W\].
    pub power_in_w: f64,
    /// Temperature of the oil at the parts \[°C\].
    pub temperature_c: f64,
    /// The parts, in the order of the case file.
    pub parts: Vec<GearboxPart>,
}

impl GearboxReport {
    /// 5 % and 95 % quantiles of the loss \[W\]: the quantiles of the mesh plus the parts.
    #[must_use]
    pub fn quantiles_w(&self, of_mesh: &Uncertainty) -> [f64; 2] {
        of_mesh.loss.quantiles_w.map(|loss| loss + self.parts_w)
    }
}

/// Loss of a part of the gearbox.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
#[non_exhaustive]
pub struct GearboxPart {
    /// Its name.
    pub name: String,
    /// `seal`, `bearing`, `jet` or `table`.
    pub kind: String,
    /// Law that its loss follows.
    pub law: String,
    /// Loss \[W\].
    pub loss_w: f64,
    /// Torque \[N m\]: of a seal and a bearing at its own shaft, else at the pinion.
    pub torque_nm: f64,
    /// Inputs outside the range of their law.
    #[serde(default, skip_serializing_if = "Vec::is_empty")]
    pub outside: Vec<String>,
}

/// Torque and speed of the pinion, and temperature of the operation.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct OperatingPoint {
    /// Torque at the pinion, negative when the wheel drives.
    pub torque: Torque,
    /// Speed of the pinion.
    pub speed: AngularSpeed,
    /// Temperature of the operation, used for the oil unless the gearbox states its own.
    pub temperature: Temperature,
}

/// The losses of the parts of the gearbox of `case` at an operating point; none where it has no gearbox.
///
/// # Errors
/// When a table does not reach the point, or the oil has no state there.
///
/// ```
/// use asperity::case;
/// use asperity::result::gearbox::{OperatingPoint, parts};
/// let file = std::path::Path::new("../../fixtures/cases/e-drive.toml");
/// let case = case::load_with(file, &|input| {
///     let seal = r#"[{ shaft = "pinion", diameter = "40 mm" }]"#;
///     let _ = input.set("gearbox.seals", seal);
/// })?;
/// let found = parts(&case.case, &OperatingPoint {
///     torque: "145 N m".parse()?, speed: "3000 1/min".parse()?, temperature: "90 °C".parse()?,
/// })?;
/// assert!((found[0].loss_w - 36.912).abs() < 1e-9);
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
pub fn parts(case: &Case, at: &OperatingPoint) -> Result<Vec<GearboxPart>, PositionError> {
    let Some(gearbox) = &case.gearbox else {
        return Ok(Vec::new());
    };
    let at = OperatingPoint {
        temperature: gearbox.temperature.unwrap_or(at.temperature),
        ..*at
    };
    let found = gearbox.parts.iter().map(|part| {
        loss_of(part, case, &at).map_err(|source| PositionError::GearboxPart {
            part: part.name.clone(),
            source: Box::new(source),
        })
    });
    found.collect()
}

/// The gearbox of a case whose mesh loses `mesh`.
pub(crate) fn report(case: &Case, mesh: Power) -> Result<Option<GearboxReport>, PositionError> {
    let Some(gearbox) = &case.gearbox else {
        return Ok(None);
    };
    let at = operating_point(case);
    let parts = parts_of_case(case)?;
    let parts_w: f64 = parts.iter().map(|part| part.loss_w).sum();
    let loss = mesh + Power::from_si(parts_w);
    let operation = MeshOperation {
        pinion_torque: case.torque,
        pinion_speed: case.speed,
        teeth: case.gears.teeth,
    };
    let flow = power_flow(&operation, loss)?;
    Ok(Some(GearboxReport {
        efficiency: flow.efficiency,
        loss_w: loss.si(),
        parts_w,
        power_in_w: flow.input_power.si(),
        temperature_c: gearbox.temperature.unwrap_or(at.temperature).celsius(),
        parts,
    }))
}

/// The parts at the operating point of the case.
pub(crate) fn parts_of_case(case: &Case) -> Result<Vec<GearboxPart>, PositionError> {
    parts(case, &operating_point(case))
}

fn operating_point(case: &Case) -> OperatingPoint {
    OperatingPoint {
        torque: case.torque,
        speed: case.speed,
        temperature: oil_temperature(case),
    }
}

/// Temperature of the oil at the parts of a gearbox that states none.
pub(crate) fn oil_temperature(case: &Case) -> Temperature {
    // What was found from the loss of the mesh is the temperature of its flanks.
    let stated = case
        .found_bulk
        .as_ref()
        .map(|found| &found.stated.operation);
    let of_oil = stated.and_then(OperationInput::stated_temperature);
    of_oil.unwrap_or(case.temperature)
}

impl GearboxPart {
    /// A part by its kind and law, with the torque at its shaft and the speed of the shaft.
    pub(crate) fn new(
        name: &str,
        (kind, law): (&str, &str),
        (torque, speed): (Torque, AngularSpeed),
        outside: &[OutOfRange],
    ) -> Self {
        Self {
            name: name.to_owned(),
            kind: kind.to_owned(),
            law: law.to_owned(),
            loss_w: torque.si() * speed.si(),
            torque_nm: torque.si(),
            outside: outside.iter().map(ToString::to_string).collect(),
        }
    }
}

fn loss_of(part: &Part, case: &Case, at: &OperatingPoint) -> Result<GearboxPart, PositionError> {
    let of_shaft = |shaft: Shaft| match shaft {
        Shaft::Pinion => at.speed,
        Shaft::Wheel => at.speed / case.gears.ratio.abs(),
    };
    let oil = || Ok::<_, PositionError>(case.lubricant.at(at.temperature)?.value);
    let (kind, law, torque, speed, outside): (_, &str, _, _, Vec<OutOfRange>) = match &part.kind {
        PartKind::Seal { shaft, diameter } => {
            let torque = seal_torque(*diameter)?;
            (
                "seal",
                "ISO/TR 14179-2, as quoted",
                torque,
                of_shaft(*shaft),
                Vec::new(),
            )
        }
        PartKind::Bearing {
            shaft,
            bearing,
            load,
            at_torque,
        } => {
            let growth = at_torque.map_or(1.0, |stated| (at.torque / stated).abs());
            let load = load.map(|force| Force::from_si(force.si() * growth));
            let speed = of_shaft(*shaft);
            let found = bearing.torque(load, speed, oil()?.kinematic_viscosity)?;
            (
                "bearing",
                "SKF's form",
                found.value.total(),
                speed,
                found.outside,
            )
        }
        PartKind::Jet { flow, speed } => {
            let torque = jet_torque(case, (*flow, *speed), at)?;
            ("jet", JET_LAW, torque, at.speed, Vec::new())
        }
        PartKind::Table(table) => (
            "table",
            TABLE_LAW,
            table_torque(table, at)?,
            at.speed,
            Vec::new(),
        ),
    };
    Ok(GearboxPart::new(
        &part.name,
        (kind, law),
        (torque, speed),
        &outside,
    ))
}

/// Law of the loss of an oil jet.
pub(crate) const JET_LAW: &str = "Ariura, as quoted";
/// Law of the loss of a table.
pub(crate) const TABLE_LAW: &str = "the user's table";

/// Torque of an oil jet onto the gears of `case` at its pinion with the speed `at`.
pub(crate) fn jet_torque(
    case: &Case,
    (flow, speed): (VolumeFlow, Speed),
    at: &OperatingPoint,
) -> Result<Torque, PositionError> {
    let oil = case.lubricant.at(at.temperature)?.value;
    let radius = case.gears.working_pitch_radius[0].si().abs();
    let pitch = Speed::from_si(at.speed.si() * radius);
    let power = jet_power(oil.density, flow, pitch, speed)?;
    Ok(Torque::from_si(power.si() / at.speed.si()))
}

/// Loss torque of a table.
pub(crate) fn table_torque(
    table: &LossTable,
    at: &OperatingPoint,
) -> Result<Torque, PositionError> {
    let rpm = at.speed.si() * 30.0 / std::f64::consts::PI;
    let celsius = at.temperature.celsius();
    // Nodes written in 1/min and °C are met although both are kept in SI.
    let torque = table.loss_torque(at.torque.si(), rounded(rpm), rounded(celsius))?;
    Ok(Torque::from_si(torque))
}

/// A number without the last bits that a change of its unit leaves.
fn rounded(value: f64) -> f64 {
    const DIGITS: f64 = 1e9;
    (value * DIGITS).round() / DIGITS
}
