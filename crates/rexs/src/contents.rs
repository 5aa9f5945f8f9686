//! Contents of a gearbox file as JSON.

use asperity_core::Fault;
use serde_json::{Value, json};

use crate::model::{Component, Model};
use crate::operating_points::operating_points;
use crate::stages::{Stage, StageKind, stages, teeth};

/// Version and program of a file, its stages with the operating points of the pinion or sun, and the names of its
/// lubricants.
///
/// # Errors
/// When a number or a unit cannot be read.
pub fn contents(model: &Model) -> Result<Value, Fault> {
    let rows = stages(model)?
        .iter()
        .map(|stage| row(model, stage))
        .collect::<Result<Vec<_>, _>>()?;
    let oils: Vec<&str> = lubricants(model).map(|oil| oil.name.as_str()).collect();
    Ok(json!({
        "version": model.version, "program": model.program, "stages": rows, "lubricants": oils,
    }))
}

/// The lubricants of a file.
pub fn lubricants(model: &Model) -> impl Iterator<Item = &Component> {
    let every = model.components.values();
    every.filter(|component| component.kind == "lubricant")
}

/// Numbers of teeth of the gears of a stage.
///
/// # Errors
/// When a number cannot be read.
pub fn teeth_of(model: &Model, stage: &Stage) -> Result<Vec<u32>, Fault> {
    let gears = stage.gears().into_iter();
    gears
        .filter_map(|id| model.components.get(id))
        .map(teeth)
        .collect()
}

fn row(model: &Model, stage: &Stage) -> Result<Value, Fault> {
    let kind = match &stage.kind {
        StageKind::Pair { is_ring: false, .. } => "pair",
        StageKind::Pair { .. } => "ring pair",
        StageKind::Planetary { .. } => "planetary",
        StageKind::Other { kind } => kind,
    };
    let value = |number: &Option<(f64, String)>| number.as_ref().map(|value| value.0);
    let points: Vec<Value> = operating_points(model, stage)?
        .iter()
        .map(|point| {
            json!({
                "load_case": point.load_case,
                "share_percent": point.share,
                "torque_nm": value(&point.torque),
                "speed_rpm": value(&point.speed),
                "temperature_c": value(&point.temperature),
            })
        })
        .collect();
    Ok(json!({
        "stage": stage.number, "name": stage.name, "kind": kind, "teeth": teeth_of(model, stage)?,
        "operating_points": points,
    }))
}
