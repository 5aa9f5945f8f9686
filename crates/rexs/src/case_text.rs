//! Case of a stage as commented TOML.

use crate::error;
use crate::model::{Component, Model};
use crate::operating_points::operating_points_of;
use crate::set_text;
use crate::stages::{Stage, StageKind, stages, teeth};
use crate::writer::{CaseText, Text};
use asperity_core::Fault;

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
) -> Result<CaseText, Fault> {
    let model = &model.unmarked();
    let stages = stages(model)?;
    let stage = number.checked_sub(1).and_then(|index| stages.get(index));
    let Some(stage) = stage else {
        return Err(error::no_stage(number, stages.len()));
    };
    let mut case = Text::new(model, file, Some(stage));
    let (gear, mesh) = mesh_gears(stage)?;
    gears(&mut case, stage)?;
    let points = operating_points_of(model, gear, mesh)?;
    let names = names(stage);
    let temperature = case.operation(&points, load_case, names[0])?;
    case.lubricant(&model.components[mesh], temperature)?;
    if flanks_and_steel(&mut case, stage, flanks)? {
        case.ask_for_traces([names[0], names[1]]);
    }
    Ok(case.done())
}

/// The gear that the operating point of a stage is of, pinion or sun, and the `cylindrical_stage` of its mesh.
pub fn mesh_gears(stage: &Stage) -> Result<(&str, &str), Fault> {
    match &stage.kind {
        StageKind::Pair { pinion, stage, .. } => Ok((pinion, stage)),
        StageKind::Planetary { sun, stage, .. } => Ok((sun, stage)),
        StageKind::Other { kind } => Err(error::not_cylindrical(stage.number, kind)),
    }
}

/// Names of the gears of a stage in a case.
fn names(stage: &Stage) -> &'static [&'static str] {
    match stage.kind {
        StageKind::Planetary { .. } => &["sun", "planet", "ring"],
        _ => &["pinion", "wheel"],
    }
}

/// Writes gears, steel and flanks of a stage, and returns whether a flank has neither trace nor roughness.
pub fn mesh_tables(case: &mut Text<'_>, stage: &Stage, flanks: &Flanks) -> Result<bool, Fault> {
    gears(case, stage)?;
    flanks_and_steel(case, stage, flanks)
}

fn flanks_and_steel(case: &mut Text<'_>, stage: &Stage, flanks: &Flanks) -> Result<bool, Fault> {
    let model = case.model();
    let names = names(stage).iter().copied();
    let named: Vec<(&str, &Component)> = (names.zip(stage.gears()))
        .map(|(name, id)| (name, &model.components[id]))
        .collect();
    case.material(&named)?;
    let files = [flanks.pinion.as_deref(), flanks.wheel.as_deref(), None];
    let with_files = named.iter().zip(files);
    let with_files: Vec<_> = with_files
        .map(|((name, gear), file)| (*name, *gear, file))
        .collect();
    case.surface(&with_files)
}

fn gears(case: &mut Text<'_>, stage: &Stage) -> Result<(), Fault> {
    let model = case.model();
    let component = |id: &String| &model.components[id];
    match &stage.kind {
        StageKind::Pair {
            stage: mesh,
            pinion,
            wheel,
            is_ring,
        } => pair(
            case,
            component(mesh),
            [pinion, wheel].map(component),
            *is_ring,
        ),
        StageKind::Planetary {
            stage: mesh,
            sun,
            planet,
            ring,
            planets,
            ..
        } => {
            let gears = [sun, planet, ring].map(component);
            set_text::gears(case, component(mesh), gears, *planets)
        }
        StageKind::Other { .. } => mesh_gears(stage).map(|_| ()),
    }
}

fn pair(
    case: &mut Text<'_>,
    mesh: &Component,
    gears: [&Component; 2],
    is_ring: bool,
) -> Result<(), Fault> {
    let z = [teeth(gears[0])?, teeth(gears[1])?];
    case.heading("gears");
    let sign = if is_ring { "-" } else { "" };
    let teeth = format!("[{}, {sign}{}]", z[0], z[1]);
    case.entry("teeth", &teeth, &gears, "number_of_teeth");
    let shifts = case.geometry(mesh, &gears, &z.map(f64::from))?;
    if !is_ring {
        case.check_distance(mesh, &gears, &z.map(f64::from), shifts.as_deref())?;
    }
    for (name, gear) in ["pinion", "wheel"].into_iter().zip(gears) {
        case.teeth_form(name, gear)?;
    }
    case.end_relief(&gears)
}
