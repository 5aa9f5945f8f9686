//! `asperity case from-rexs`: a case from a REXS gearbox file.

use std::fmt::Write as _;
use std::path::{Path, PathBuf};

use asperity_core::{Code, Fault};
use asperity_rexs::{
    CaseText, Flanks, Model, OperatingPoint, Stage, StageKind, case_text, contents, lubricants,
    operating_points, stages, teeth_of, train_text,
};
use asperity_storage::{one_line, whole_file};
use serde_json::json;

use crate::args::{Common, FromRexsArgs};
use crate::failure::Failure;
use crate::output::{besides_file, note, print_json, print_text, save, shown};

/// Largest size of a gearbox file in bytes.
const LARGEST: u64 = 100_000_000;

/// `asperity case from-rexs`
pub fn from_rexs(args: &FromRexsArgs, common: &Common) -> Result<(), Failure> {
    let path = &args.file;
    let bytes = whole_file(path, LARGEST)
        .map_err(|error| Fault::from_cause(Code::E103, error).about(path.display()))?;
    let wrong = |error: Fault| error.about(path.display());
    let model = Model::read(&bytes).map_err(wrong)?;
    if args.stage.is_none() && args.output.is_none() && !args.all {
        return if common.json {
            print_json(&contents(&model).map_err(wrong)?)
        } else {
            print_text(common, &listed(&model).map_err(wrong)?)
        };
    }
    let output = args.output.as_deref().unwrap_or(Path::new("-"));
    let flank = |file: &Option<PathBuf>| file.as_deref().map(|file| named_from(output, file));
    let flanks = Flanks {
        pinion: flank(&args.pinion),
        wheel: flank(&args.wheel),
    };
    let file = path.file_name().unwrap_or_default().to_string_lossy();
    let number = (!args.all).then(|| args.stage.unwrap_or(1));
    let case = match number {
        None => train_text(&model, &file, args.load_case, &flanks),
        Some(number) => case_text(&model, &file, number, args.load_case, &flanks),
    };
    let case = case.map_err(wrong)?;
    if common.json && args.output.is_none() {
        return print_json(&json!({
            "case": case.toml, "notes": case.notes, "not_read": case.not_read,
        }));
    }
    written(&case, output, number, common)
}

fn written(
    case: &CaseText,
    output: &Path,
    number: Option<usize>,
    common: &Common,
) -> Result<(), Failure> {
    let quiet = besides_file(output, common)?;
    save(output, case.toml.as_bytes())?;
    if !common.quiet {
        for text in &case.notes {
            note(&one_line(text));
        }
    }
    let name = shown(output);
    if common.json {
        return print_json(&json!({ "file": output, "stage": number, "notes": case.notes }));
    }
    let what = number.map_or("all stages".to_owned(), |number| format!("stage {number}"));
    print_text(
        &quiet,
        &format!("wrote {name}: {what}\nnext: asperity check {name}\n"),
    )
}

/// Name of a flank in the case `output`: relative in the same folder, otherwise its path.
fn named_from(output: &Path, flank: &Path) -> String {
    let beside = output
        .parent()
        .is_none_or(|folder| folder.as_os_str().is_empty());
    let name = if beside {
        flank.to_owned()
    } else {
        std::path::absolute(flank).unwrap_or_else(|_| flank.to_owned())
    };
    name.to_string_lossy().into_owned()
}

/// Stages, lubricants and operating points of a file as text.
fn listed(model: &Model) -> Result<String, Fault> {
    let mut text = format!(
        "REXS {} by {}\n",
        one_line(&model.version),
        one_line(&model.program)
    );
    let stages = stages(model)?;
    for stage in &stages {
        let kind = described(stage, &teeth_of(model, stage)?);
        let _ = writeln!(text, "stage {}: {}", stage.number, one_line(&kind));
        for point in operating_points(model, stage)? {
            let _ = writeln!(text, "  {}", one_line(&point_text(&point)));
        }
    }
    if stages.is_empty() {
        text.push_str("no stage of gears\n");
    }
    for oil in lubricants(model) {
        let at = |key: &str| one_line(oil.attributes.get(key).map_or("?", |value| &value.text));
        let _ = writeln!(
            text,
            "lubricant {}: {} / {} mm2/s at 40 / 100 °C",
            one_line(&oil.name),
            at("viscosity_at_40_degree_celsius"),
            at("viscosity_at_100_degree_celsius")
        );
    }
    if lubricants(model).next().is_none() {
        text.push_str("no lubricant\n");
    }
    Ok(text)
}

fn described(stage: &Stage, teeth: &[u32]) -> String {
    let teeth: Vec<String> = teeth.iter().map(u32::to_string).collect();
    let teeth = teeth.join("/");
    let kind = match &stage.kind {
        StageKind::Pair { is_ring: false, .. } => format!("{teeth} teeth"),
        StageKind::Pair { .. } => format!("{teeth} teeth, the wheel a ring"),
        StageKind::Planetary { planets, .. } => {
            format!("planetary set of {teeth} teeth, {planets} planets")
        }
        StageKind::Other { kind } => format!("{kind}, not modelled"),
        _ => String::new(),
    };
    match stage.name.trim() {
        "" => kind,
        name => format!("{name}, {kind}"),
    }
}

fn point_text(point: &OperatingPoint) -> String {
    let name = match &point.load_case {
        Some(id) => format!("load case {id}"),
        None => "operating point".to_owned(),
    };
    let values = [
        (point.share, "% of the time"),
        (point.torque.as_ref().map(|value| value.0), "N m"),
        (point.speed.as_ref().map(|value| value.0), "1/min"),
        (point.temperature.as_ref().map(|value| value.0), "°C"),
    ];
    let values: Vec<String> = values
        .iter()
        .filter_map(|(value, unit)| {
            value.map(|value| format!("{} {unit}", (1e5 * value).round() / 1e5))
        })
        .collect();
    if values.is_empty() {
        format!("{name}: nothing known")
    } else {
        format!("{name}: {}", values.join(", "))
    }
}
