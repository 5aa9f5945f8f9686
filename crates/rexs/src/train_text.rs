//! Case of a whole gearbox as commented TOML: a gear train of all its stages.

use crate::error;
use std::collections::BTreeMap;

use crate::case_text::{Flanks, mesh_gears, mesh_tables};
use crate::model::Model;
use crate::operating_points::{OperatingPoint, operating_points_of};
use crate::shafts::{carrier_shaft, is_held, joined, shaft_of};
use crate::stages::{Stage, StageKind, stages};
use crate::writer::{CaseText, Text, quoted};
use asperity_core::Fault;

/// Shaft of a stage: its number if the file has one, its name in the case, and the gear on it.
struct StageShaft<'a> {
    id: Option<&'a str>,
    name: String,
    gear: Option<&'a str>,
}

/// The case of all stages at load case `load_case` (from 1); `file` is the name of the REXS file.
///
/// # Errors
/// When the load case does not exist, a stage is not of cylindrical gears, or a required attribute is missing or cannot
/// be read.
pub fn train_text(
    model: &Model,
    file: &str,
    load_case: usize,
    flanks: &Flanks,
) -> Result<CaseText, Fault> {
    let model = &model.unmarked();
    let stages = stages(model)?;
    let Some(first) = stages.first() else {
        return Err(error::no_stage(1, 0));
    };
    let mut case = Text::new(model, file, None);
    let shafts: Vec<Vec<StageShaft<'_>>> = stages
        .iter()
        .map(|stage| stage_shafts(model, stage))
        .collect::<Result<_, _>>()?;
    let ends = ends(&shafts);
    let (input, points) = input(model, &stages, &shafts, &ends, load_case)?;
    write_ends(&mut case, &ends, input);
    let mut is_missing = false;
    for (stage, on) in stages.iter().zip(&shafts) {
        let table = format!("mesh.stage-{}", stage.number);
        case.within = String::new();
        case.heading(&table);
        if !stage.name.trim().is_empty() {
            case.comment(stage.name.trim());
        }
        let names: Vec<String> = on.iter().map(|shaft| quoted(&shaft.name)).collect();
        let ids: Vec<&str> = on.iter().filter_map(|shaft| shaft.id).collect();
        let from = if ids.is_empty() {
            "the file has no shafts".to_owned()
        } else {
            format!("shaft {}", ids.join(", "))
        };
        case.sourced_line(&format!("shafts = [{}]", names.join(", ")), &from);
        case.within = format!("{table}.");
        is_missing |= mesh_tables(&mut case, stage, flanks)?;
    }
    case.within = String::new();
    let temperature = case.operation(&points, load_case, "input shaft")?;
    let (_, mesh) = mesh_gears(first)?;
    case.lubricant(&model.components[mesh], temperature)?;
    if is_missing {
        case.heading("surface");
        case.comment("Flanks of all gears of which the file has no roughness: their finish and Ra, or traces.");
        case.line("# finish = \"ground\"");
        case.line("# pinion.ra = \"0.4 um\"");
        case.note(
            "the file has no roughness of some flanks: state surface.finish and surface.pinion.ra, which hold for all of \
             them, or name their traces",
        );
    }
    Ok(case.done())
}

/// Shafts of pinion and wheel, or of sun, carrier and a ring that is not held.
fn stage_shafts<'a>(model: &'a Model, stage: &'a Stage) -> Result<Vec<StageShaft<'a>>, Fault> {
    let groups = joined(model);
    let shaft = |id: Option<&'a str>, gear: Option<&'a str>, unnamed: String| {
        let id = id.map(|id| groups.get(id).copied().unwrap_or(id));
        let name = id
            .and_then(|id| model.components.get(id))
            .map(|shaft| shaft.name.trim());
        let name = name.filter(|name| !name.is_empty()).map(str::to_owned);
        StageShaft {
            name: name
                .or(id.map(|id| format!("shaft {id}")))
                .unwrap_or(unnamed),
            id,
            gear,
        }
    };
    let of_gear = |gear: &'a str| {
        shaft(
            shaft_of(model, gear),
            Some(gear),
            format!("shaft of gear {gear}"),
        )
    };
    match &stage.kind {
        StageKind::Pair { pinion, wheel, .. } => Ok(vec![of_gear(pinion), of_gear(wheel)]),
        StageKind::Planetary { set, sun, ring, .. } => {
            let carrier = carrier_shaft(model, set);
            let carrier = shaft(carrier, None, format!("carrier of stage {}", stage.number));
            let mut on = vec![of_gear(sun), carrier];
            if shaft_of(model, ring).is_some_and(|shaft| !is_held(model, shaft)) {
                on.push(of_gear(ring));
            }
            Ok(on)
        }
        StageKind::Other { kind } => Err(error::not_cylindrical(stage.number, kind)),
    }
}

/// An end of the train: a shaft of a single stage.
struct End<'a> {
    name: &'a str,
    stage: usize,
    gear: Option<&'a str>,
}

fn ends<'a>(shafts: &'a [Vec<StageShaft<'a>>]) -> Vec<End<'a>> {
    let mut count: BTreeMap<&str, usize> = BTreeMap::new();
    for shaft in shafts.iter().flatten() {
        *count.entry(&shaft.name).or_default() += 1;
    }
    let of_stage = |(stage, on): (usize, &'a Vec<StageShaft<'a>>)| {
        on.iter().map(move |shaft| End {
            name: &shaft.name,
            stage,
            gear: shaft.gear,
        })
    };
    let all = shafts.iter().enumerate().flat_map(of_stage);
    let ends: Vec<End<'_>> = all.filter(|end| count[end.name] == 1).collect();
    ends
}

/// The end with the highest speed among those whose torque and speed the file states, and its operating points.
fn input(
    model: &Model,
    stages: &[Stage],
    shafts: &[Vec<StageShaft<'_>>],
    ends: &[End<'_>],
    load_case: usize,
) -> Result<(usize, Vec<OperatingPoint>), Fault> {
    let mut best: Option<(usize, Vec<OperatingPoint>, (bool, f64))> = None;
    for (number, end) in ends.iter().enumerate() {
        let Some(gear) = end.gear else {
            continue;
        };
        let (_, mesh) = mesh_gears(&stages[end.stage])?;
        let points = operating_points_of(model, gear, mesh)?;
        let point = load_case.checked_sub(1).and_then(|index| points.get(index));
        let rank = point.map_or((false, 0.0), |point| {
            let speed = point.speed.as_ref().map_or(0.0, |(speed, _)| *speed);
            (point.torque.is_some() && speed > 0.0, speed)
        });
        if best.as_ref().is_none_or(|(_, _, before)| rank > *before) {
            best = Some((number, points, rank));
        }
    }
    let (number, points, _) = best.ok_or(error::no_stage(1, shafts.len()))?;
    Ok((number, points))
}

/// Writes input and output shaft.
fn write_ends(case: &mut Text<'_>, ends: &[End<'_>], input: usize) {
    case.heading("train");
    let name = quoted(ends[input].name);
    case.sourced_line(
        &format!("input = {name}"),
        "the fastest shaft end with torque and speed",
    );
    let others = ends.iter().enumerate();
    let others = others.filter(|(number, _)| *number != input);
    let others: Vec<String> = others.map(|(_, end)| quoted(end.name)).collect();
    if let [output] = &others[..] {
        case.line(&format!("output = {output}"));
        return;
    }
    for end in others {
        case.line(&format!("# output = {end}"));
    }
    case.note(
        "the train has several other ends: write train.output, and leave out stages that run idle",
    );
}
