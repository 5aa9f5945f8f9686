//! Case of a stage as commented TOML.

use crate::error::RexsError;
use crate::model::{Component, Model};
use crate::set_text;
use crate::stages::{StageKind, stages, teeth};
use crate::writer::{CaseText, Text, source};

/// Names of the trace files of the flanks for the case.
#[derive(Debug, Clone, PartialEq, Eq, Default)]
pub struct Flanks {
    /// Trace of the pinion, or of the sun.
    pub pinion: Option<String>,
    /// Trace of the wheel, or of a planet.
    pub wheel: Option<String>,
}

/// The case of stage `number` (from 1) at load case `load_case` (from 1); `file` is the name of the REXS file.
///
/// # Errors
/// When the stage or load case does not exist, the gears are not cylindrical, or a required attribute is missing or
/// cannot be read.
pub fn case_text(
    model: &Model,
    file: &str,
    number: usize,
    load_case: usize,
    flanks: &Flanks,
) -> Result<CaseText, RexsError> {
    let model = &model.unmarked();
    let stages = stages(model)?;
    let stage = number.checked_sub(1).and_then(|index| stages.get(index));
    let Some(stage) = stage else {
        return Err(RexsError::NoStage {
            wanted: number,
            count: stages.len(),
        });
    };
    let mut case = Text::new(model, file, stage);
    match &stage.kind {
        StageKind::Pair {
            stage: mesh,
            pinion,
            wheel,
            is_ring,
        } => {
            let gears = [pinion, wheel].map(|id| &model.components[id]);
            pair(&mut case, &model.components[mesh], gears, *is_ring)?;
            let temperature = case.operation(stage, load_case, "pinion")?;
            case.lubricant(&model.components[mesh], temperature)?;
            case.material(&[("pinion", gears[0]), ("wheel", gears[1])])?;
            case.surface(&[
                ("pinion", gears[0], flanks.pinion.as_deref()),
                ("wheel", gears[1], flanks.wheel.as_deref()),
            ])?;
        }
        StageKind::Planetary {
            stage: mesh,
            sun,
            planet,
            ring,
            planets,
            ..
        } => {
            let gears = [sun, planet, ring].map(|id| &model.components[id]);
            set_text::gears(&mut case, &model.components[mesh], gears, *planets)?;
            let temperature = case.operation(stage, load_case, "sun")?;
            case.lubricant(&model.components[mesh], temperature)?;
            case.material(&[("sun", gears[0]), ("planet", gears[1]), ("ring", gears[2])])?;
            case.surface(&[
                ("sun", gears[0], flanks.pinion.as_deref()),
                ("planet", gears[1], flanks.wheel.as_deref()),
                ("ring", gears[2], None),
            ])?;
        }
        StageKind::Other { kind } => {
            return Err(RexsError::NotCylindrical {
                stage: number,
                kind: kind.clone(),
            });
        }
    }
    Ok(case.done())
}

fn pair(
    case: &mut Text<'_>,
    mesh: &Component,
    gears: [&Component; 2],
    is_ring: bool,
) -> Result<(), RexsError> {
    let z = [teeth(gears[0])?, teeth(gears[1])?];
    case.line("\n[gears]");
    let sign = if is_ring { "-" } else { "" };
    case.sourced_line(
        &format!("teeth = [{}, {sign}{}]", z[0], z[1]),
        &source(&gears, "number_of_teeth"),
    );
    let shifts = case.geometry(mesh, &gears, &z.map(f64::from))?;
    if !is_ring {
        case.check_distance(mesh, &gears, &z.map(f64::from), shifts.as_deref())?;
    }
    for (name, gear) in ["pinion", "wheel"].into_iter().zip(gears) {
        case.teeth_form(name, gear)?;
    }
    case.end_relief(&gears)
}
