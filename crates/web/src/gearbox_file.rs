//! A case from a REXS gearbox file.

use asperity::message::Fault;
use asperity_rexs::{Flanks, Model, StageKind, case_text, stages, train_text};
use serde::Serialize;

use crate::failure::Failure;

/// The case of a gearbox file or of one of its stages, and the stages there are.
#[derive(Debug, Clone, PartialEq, Serialize)]
pub struct GearboxStage {
    /// Number of the stage, from 1; 0 for the whole gearbox.
    pub stage: usize,
    /// Names of all stages in the order of the file.
    pub stages: Vec<String>,
    /// The case as TOML.
    pub case: String,
    /// Contradictions in the file and missing values.
    pub notes: Vec<String>,
}

/// Reads `bytes`, the content of the REXS file `name`, and makes the case of stage `number`; where that is 0, of the whole
/// gearbox if it has several stages, and of the first pair of cylindrical gears if the whole cannot be made. Its flanks are the
/// files of these names.
///
/// # Errors
/// When the file is not REXS, or has no such stage.
pub fn gearbox_stage(
    name: &str,
    bytes: &[u8],
    number: usize,
    [pinion, wheel]: [&str; 2],
) -> Result<GearboxStage, Failure> {
    let refused = |error: Fault| error.about(name);
    let model = Model::read(bytes).map_err(refused)?;
    let all = stages(&model).map_err(refused)?;
    let mut pairs = all
        .iter()
        .filter(|stage| matches!(stage.kind, StageKind::Pair { .. }));
    let file = |name: &str| (!name.is_empty()).then(|| name.to_owned());
    let flanks = Flanks {
        pinion: file(pinion),
        wheel: file(wheel),
    };
    let of_stage = |number: usize| {
        let case = case_text(&model, name, number, 1, &flanks);
        case.map(|case| (number, case))
    };
    let first = pairs.next().map_or(1, |stage| stage.number);
    let made = match number {
        0 if all.len() > 1 => match train_text(&model, name, 1, &flanks) {
            Ok(case) => Ok((0, case)),
            Err(error) => of_stage(first).map(|(number, mut case)| {
                let refusal = format!("the whole gearbox cannot be taken: {error}");
                case.notes.push(refusal);
                (number, case)
            }),
        },
        0 => of_stage(first),
        chosen => of_stage(chosen),
    };
    let (stage, case) = made.map_err(refused)?;
    let named = all.iter().map(|stage| match stage.name.trim() {
        "" => format!("stage {}", stage.number),
        name => format!("stage {}: {name}", stage.number),
    });
    Ok(GearboxStage {
        stage,
        stages: named.collect(),
        case: case.toml,
        notes: case.notes,
    })
}
