//! Torque, speed and temperature of a stage in every load case.

use std::collections::{BTreeMap, VecDeque};

use crate::model::{Component, LoadCase, Model};
use crate::shafts::shaft_of;
use crate::stages::{Stage, StageKind, stages, teeth};
use crate::units::Unit;
use asperity_core::Fault;

/// An operating point of the pinion or the sun of a stage.
#[derive(Debug, Clone, PartialEq, Default)]
#[non_exhaustive]
pub struct OperatingPoint {
    /// Number of the load case; `None` for values of the components themselves.
    pub load_case: Option<String>,
    /// Share of the time \[%\].
    pub share: Option<f64>,
    /// Absolute torque \[N m\] of a gearbox without losses, and its source in the file.
    pub torque: Option<(f64, String)>,
    /// Absolute speed \[1/min\], and its source in the file.
    pub speed: Option<(f64, String)>,
    /// Oil temperature \[°C\], and its source in the file.
    pub temperature: Option<(f64, String)>,
}

/// The operating points of a stage: one per load case, or a single one from the components.
///
/// A file states speed and torque at some shafts; the gear ratios transfer them to the stage. A torque is transferred
/// only if a single shaft has one, because with several the power may be split.
///
/// # Errors
/// When a number or a unit cannot be read.
pub fn operating_points(model: &Model, stage: &Stage) -> Result<Vec<OperatingPoint>, Fault> {
    let (gear, mesh) = match &stage.kind {
        StageKind::Pair { pinion, stage, .. } => (pinion, stage),
        StageKind::Planetary { sun, stage, .. } => (sun, stage),
        StageKind::Other { .. } => return Ok(Vec::new()),
    };
    operating_points_of(model, gear, mesh)
}

/// The operating points of `gear` in `mesh`, a `cylindrical_stage`.
pub fn operating_points_of(
    model: &Model,
    gear: &str,
    mesh: &str,
) -> Result<Vec<OperatingPoint>, Fault> {
    let without_loads = LoadCase::default();
    let cases = match model.load_cases.as_slice() {
        [] => std::slice::from_ref(&without_loads),
        cases => cases,
    };
    cases
        .iter()
        .map(|case| Point { model, case }.of(gear, mesh))
        .collect()
}

struct Point<'a> {
    model: &'a Model,
    case: &'a LoadCase,
}

impl Point<'_> {
    fn of(&self, gear: &str, mesh: &str) -> Result<OperatingPoint, Fault> {
        let turns = match shaft_of(self.model, gear) {
            Some(shaft) => turns(self.model, shaft)?,
            None => BTreeMap::new(),
        };
        let mut share = None;
        for unit in self.model.of_kind("gear_unit") {
            // The second name is that of versions before 1.3.
            for attribute in ["operating_time_fraction", "load_duration_fraction"] {
                if share.is_none() {
                    share = self.number(unit, attribute, Unit::Percent)?;
                }
            }
        }
        Ok(OperatingPoint {
            load_case: (!self.case.id.is_empty()).then(|| self.case.id.clone()),
            share: share.map(|(value, _)| value),
            torque: self.torque(gear, mesh, &turns)?,
            speed: self.speed(&turns)?,
            temperature: self.temperature(mesh)?,
        })
    }

    /// An attribute of the load case, or else of the component itself, with its source.
    fn number(
        &self,
        component: &Component,
        attribute: &'static str,
        unit: Unit,
    ) -> Result<Option<(f64, String)>, Fault> {
        if let Some(in_case) = self.case.components.get(&component.id)
            && let Some(value) = in_case.number(attribute, unit)?
        {
            let place = format!("{} {}: {attribute}", component.kind, component.id);
            return Ok(Some((
                value,
                format!("load case {}, {place}", self.case.id),
            )));
        }
        let place = format!("{} {}: {attribute}", component.kind, component.id);
        Ok(component
            .number(attribute, unit)?
            .map(|value| (value, place)))
    }

    fn speed(&self, turns: &BTreeMap<String, f64>) -> Result<Option<(f64, String)>, Fault> {
        let mut pinion_speed: Option<(f64, String)> = None;
        for shaft in self.model.of_kind("shaft") {
            let known = self.number(shaft, "rotational_speed", Unit::PerMinute)?;
            if let (Some((speed, from)), Some(ratio)) = (known, turns.get(&shaft.id))
                && speed != 0.0
                // The gear's shaft has precedence.
                && (pinion_speed.is_none() || *ratio == 1.0)
            {
                let from = if speed < 0.0 {
                    format!("{from}, negative there; a case has no direction of rotation")
                } else {
                    from
                };
                pinion_speed = Some(((speed / ratio).abs(), through(from, *ratio)));
            }
        }
        Ok(pinion_speed)
    }
    fn torque(
        &self,
        gear: &str,
        mesh: &str,
        turns: &BTreeMap<String, f64>,
    ) -> Result<Option<(f64, String)>, Fault> {
        for relation in self.model.related("stage_gear_data") {
            let is_ours =
                relation.role("gear") == Some(gear) && relation.role("stage") == Some(mesh);
            let data = relation.role("stage_gear_data");
            if let Some(data) = data.filter(|_| is_ours)
                && let Some(data) = self.model.components.get(data)
                && let Some((torque, from)) = self.number(data, "torque", Unit::NewtonMetre)?
            {
                return Ok(Some((torque.abs(), signed(from, torque))));
            }
        }
        let mut known = Vec::new();
        for load in self.model.of_kind("external_load") {
            let torque = self.number(load, "torque_around_u_axis", Unit::NewtonMetre)?;
            if let Some((torque, from)) = torque.filter(|(torque, _)| *torque != 0.0)
                && let Some(ratio) = shaft_of(self.model, &load.id).and_then(|of| turns.get(of))
            {
                let from = signed(through(from, *ratio), torque);
                known.push(((torque * ratio).abs(), from));
            }
        }
        Ok((known.len() == 1).then(|| known.swap_remove(0)))
    }

    fn temperature(&self, mesh: &str) -> Result<Option<(f64, String)>, Fault> {
        let meshes = self.model.components.get(mesh);
        for component in meshes
            .into_iter()
            .chain(self.model.of_kind("gear_casing"))
            .chain(self.model.of_kind("gear_unit"))
        {
            let temperature = self.number(component, "temperature_lubricant", Unit::Celsius)?;
            if temperature.is_some() {
                return Ok(temperature);
            }
        }
        Ok(None)
    }
}

/// The source of a torque, with a note where its sign is left out: files count it about the axis of a shaft, a case positive
/// where the pinion drives.
fn signed(from: String, torque: f64) -> String {
    if torque < 0.0 {
        format!("{from}, negative there; state it negative if the wheel drives")
    } else {
        from
    }
}

fn through(from: String, ratio: f64) -> String {
    if ratio == 1.0 {
        from
    } else {
        format!("{from}, through the ratios of the stages")
    }
}

/// Revolutions of every connected shaft per revolution of `first`.
fn turns(model: &Model, first: &str) -> Result<BTreeMap<String, f64>, Fault> {
    let mut links: Vec<[(String, f64); 2]> = Vec::new();
    for stage in stages(model)? {
        if let StageKind::Pair { pinion, wheel, .. } = &stage.kind {
            let gears = [pinion, wheel].map(|id| &model.components[id]);
            let ends = gears.map(|gear| shaft_of(model, &gear.id));
            if let [Some(a), Some(b)] = ends {
                links.push([
                    (a.to_owned(), f64::from(teeth(gears[0])?)),
                    (b.to_owned(), f64::from(teeth(gears[1])?)),
                ]);
            }
        }
    }
    let mut turns = BTreeMap::from([(first.to_owned(), 1.0)]);
    let mut next = VecDeque::from([first.to_owned()]);
    while let Some(shaft) = next.pop_front() {
        let own = turns[&shaft];
        for [a, b] in &links {
            for (here, there) in [(a, b), (b, a)] {
                if here.0 == shaft && !turns.contains_key(&there.0) {
                    turns.insert(there.0.clone(), own * here.1 / there.1);
                    next.push_back(there.0.clone());
                }
            }
        }
    }
    Ok(turns)
}
