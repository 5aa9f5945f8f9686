//! `asperity new`: ten questions, whose answers become a commented case.

use std::fmt::Write as _;
use std::io::{BufRead, Write};
use std::path::Path;

use asperity::case::CaseInput;
use asperity::oil::library;
use asperity_core::Code;
use asperity_core::quantity::{Angle, AngularSpeed, Length, Temperature, Torque};
use serde_json::json;

use crate::args::Common;
use crate::failure::Failure;
use crate::output::{besides_file, is_standard_output, print, save_new, shown};

/// A question: its text, what an empty answer means, and the lines of the case for an answer.
struct Question {
    text: &'static str,
    /// Answer instead of an empty one; `None` if the question has to be answered.
    default: Option<&'static str>,
    lines: fn(&str) -> Result<String, String>,
}

/// The questions in the order of the tables of a case; a table begins before its first question.
const QUESTIONS: [(&str, Question); 10] = [
    (
        "\n[gears]\n",
        Question {
            text: "Numbers of teeth z of pinion and wheel, e.g. 23 68",
            default: None,
            lines: teeth,
        },
    ),
    (
        "",
        Question {
            text: "Normal module m_n, e.g. 1.8 mm",
            default: None,
            lines: |answer| quantity::<Length>(answer, "mm", "module", "normal module m_n"),
        },
    ),
    (
        "",
        Question {
            text: "Common face width b, e.g. 32 mm",
            default: None,
            lines: |answer| quantity::<Length>(answer, "mm", "face_width", "face width b"),
        },
    ),
    (
        "",
        Question {
            text: "Helix angle beta",
            default: Some("0 deg"),
            lines: |answer| quantity::<Angle>(answer, "deg", "helix", "helix angle beta"),
        },
    ),
    (
        "",
        Question {
            text: "Centre distance a (empty: the one of gears without profile shift)",
            default: Some(""),
            lines: distance,
        },
    ),
    (
        "\n[operation]\n",
        Question {
            text: "Torque T at the pinion, e.g. 145 N m",
            default: None,
            lines: |answer| quantity::<Torque>(answer, "N m", "torque", "at the pinion"),
        },
    ),
    (
        "",
        Question {
            text: "Speed n of the pinion, e.g. 9000 1/min",
            default: None,
            lines: |answer| quantity::<AngularSpeed>(answer, "1/min", "speed", "of the pinion"),
        },
    ),
    (
        "",
        Question {
            text: "Temperature of the flanks, or oil, its temperature and jet, dip or submerged, e.g. oil 80 °C dip",
            default: Some("90 °C"),
            lines: temperature,
        },
    ),
    (
        "\n[lubricant]\n",
        Question {
            text: "Oil: a name of asperity list oils, or ISO VG grade and viscosity index, e.g. VG 100 95",
            default: Some("m100"),
            lines: oil,
        },
    ),
    (
        "\n[surface]\n",
        Question {
            text: "Flanks: the traces of pinion and wheel, or Ra of both, e.g. pinion.csv, wheel.csv or 0.4 um",
            default: None,
            lines: flanks,
        },
    ),
];

/// `asperity new`
pub fn new_case(output: &Path, common: &Common) -> Result<(), Failure> {
    let quiet = besides_file(output, common)?;
    if !is_standard_output(output) && output.exists() {
        let text = format!("{}: exists already; name another file", shown(output));
        return Err(Failure::new(Code::E401, text));
    }
    let mut input = std::io::stdin().lock();
    let mut case =
        "# A case written by asperity new. docs/CASE_FILE.md lists all keys.\n".to_owned();
    for (number, (table, question)) in QUESTIONS.iter().enumerate() {
        case += table;
        case += &asked(number + 1, question, &mut input)?;
    }
    case.parse::<CaseInput>()
        .map_err(|error| Failure::new(Code::E204, error.to_string()))?;
    if is_standard_output(output) {
        return crate::output::save(output, case.as_bytes());
    }
    save_new(output, case.as_bytes())?;
    let name = shown(output);
    print(
        &quiet,
        || json!({ "file": output }),
        || format!("wrote {name}\nnext: asperity check {name}\n"),
    )
}

/// The lines of a question: asked again until its answer can be read.
fn asked(number: usize, question: &Question, input: &mut impl BufRead) -> Result<String, Failure> {
    /// Longest line of an answer in bytes.
    const LONGEST: u64 = 10_000;
    let default = match question.default {
        None | Some("") => String::new(),
        Some(default) => format!(" [{default}]"),
    };
    loop {
        // Without a terminal nobody reads the questions.
        let mut terminal = std::io::stderr();
        let _ = write!(terminal, "{number}/10 {}{default}: ", question.text);
        let _ = terminal.flush();
        let mut line = String::new();
        let read = std::io::Read::take(&mut *input, LONGEST).read_line(&mut line);
        let is_end = matches!(read, Ok(0) | Err(_));
        let answer = match (line.trim(), question.default) {
            ("", Some(default)) => default,
            (answer, _) => answer,
        };
        if answer.is_empty() && question.default.is_none() && is_end {
            let text = format!("no answer to question {number}: {}", question.text);
            return Err(Failure::new(Code::E204, text));
        }
        match (question.lines)(answer) {
            Ok(lines) => return Ok(lines),
            Err(why) if is_end => return Err(Failure::new(Code::E204, why)),
            Err(why) => {
                let _ = writeln!(terminal, "  {}", asperity_storage::printable(&why));
            }
        }
    }
}

/// A number with a unit, in `unit` if it has none.
fn quantity<T: std::str::FromStr<Err: std::fmt::Display>>(
    answer: &str,
    unit: &str,
    key: &str,
    what: &str,
) -> Result<String, String> {
    let text = match answer.parse::<f64>() {
        Ok(_) => format!("{answer} {unit}"),
        Err(_) => answer.to_owned(),
    };
    text.parse::<T>().map_err(|error| error.to_string())?;
    Ok(format!("{key} = {} # {what}\n", json!(text)))
}

fn teeth(answer: &str) -> Result<String, String> {
    let numbers: Vec<i32> = answer
        .split(|c: char| c.is_whitespace() || ",;/".contains(c))
        .filter(|part| !part.is_empty())
        .map(str::parse)
        .collect::<Result<_, _>>()
        .map_err(|_| format!("{answer:?}: write two whole numbers, e.g. 23 68"))?;
    match numbers.as_slice() {
        [pinion, wheel] => Ok(format!(
            "teeth = [{pinion}, {wheel}] # z; a ring gear has a negative number\n"
        )),
        _ => Err(format!("{answer:?}: write two numbers, e.g. 23 68")),
    }
}

/// The bulk temperature, or the temperature of the oil with its lubrication.
fn temperature(answer: &str) -> Result<String, String> {
    let Some(oil) = answer.strip_prefix("oil ").map(str::trim) else {
        let what = "of the flanks; or oil_temperature with bulk";
        return quantity::<Temperature>(answer, "°C", "bulk_temperature", what);
    };
    let kind = ["jet", "dip", "submerged"]
        .into_iter()
        .find_map(|kind| Some((oil.strip_suffix(kind)?.trim(), kind)));
    let (value, kind) =
        kind.ok_or_else(|| format!("{answer:?}: add jet, dip or submerged, e.g. oil 80 °C dip"))?;
    let line = quantity::<Temperature>(value, "°C", "oil_temperature", "of the oil")?;
    Ok(format!(
        "{line}bulk = {{ law = \"iso\", lubrication = \"{kind}\" }} # the loss heats the flanks above the oil\n"
    ))
}

fn distance(answer: &str) -> Result<String, String> {
    const SHIFTS: &str = "# profile_shift = [0.1, -0.1] # x of pinion and wheel on the drawing\n# tip_diameter = [\"45 mm\", \"126 mm\"] # d_a\n";
    const RELIEF: &str = "# pinion.tip_relief = { amount = \"10 um\", length = \"3 mm\" }\n\
        # wheel.tip_relief = { amount = \"10 um\", length = \"3 mm\" }\n";
    if answer.is_empty() {
        return Ok(format!("{SHIFTS}{RELIEF}"));
    }
    let line = quantity::<Length>(answer, "mm", "centre_distance", "working centre distance a")?;
    Ok(format!("{line}{SHIFTS}{RELIEF}"))
}

fn oil(answer: &str) -> Result<String, String> {
    if !answer.to_lowercase().contains("vg") {
        let oils = library().map_err(|error| error.to_string())?;
        let names: Vec<&str> = oils.iter().map(|oil| oil.name.as_str()).collect();
        if !names.iter().any(|name| name.eq_ignore_ascii_case(answer)) {
            let known = names.join(", ");
            return Err(format!(
                "{answer:?}: write one of {known}, or e.g. VG 100 95"
            ));
        }
        return Ok(format!("oil = {}\n", json!(answer)));
    }
    let numbers: Vec<f64> = answer
        .split(|c: char| !c.is_ascii_digit() && c != '.')
        .filter_map(|part| part.parse().ok())
        .collect();
    let [grade, index] = numbers.as_slice() else {
        return Err(format!(
            "{answer:?}: a grade states the viscosity at 40 °C only; write its viscosity index too, e.g. VG 100 95"
        ));
    };
    Ok(format!(
        "viscosity = {{ grade = {grade}, viscosity_index = {index} }} # ISO VG {grade}\n\
         density = \"880 kg/m3\" # at 15 °C: assumed, write that of the data sheet\n\
         assume_base_oil = \"mineral\" # or base_oil, if it is known\n"
    ))
}

fn flanks(answer: &str) -> Result<String, String> {
    let is_value = answer.starts_with(|c: char| c.is_ascii_digit() || c == '.')
        && (answer.parse::<f64>().is_ok() || answer.parse::<Length>().is_ok());
    if answer.is_empty() {
        return Err("write the name of a file, or Ra".to_owned());
    }
    if !is_value {
        let (pinion, wheel) = match answer.split_once(',') {
            Some((pinion, wheel)) => (pinion.trim(), Some(wheel.trim())),
            None => (answer, None),
        };
        let mut lines = format!("pinion = {{ file = {} }}\n", json!(pinion));
        lines += &match wheel {
            Some(wheel) => format!(
                "wheel = {{ file = {}, mirrored = true }} # if both were traced from root to tip\n",
                json!(wheel)
            ),
            None => "# wheel = { file = \"wheel.csv\", mirrored = true } # without it the pinion's trace, mirrored\n".to_owned(),
        };
        return Ok(lines);
    }
    let mut lines = "# Without a trace, surrogate flanks with this Ra are generated.\n".to_owned();
    for gear in ["pinion", "wheel"] {
        let _ = write!(
            lines,
            "{}",
            quantity::<Length>(answer, "um", &format!("{gear}.ra"), "Ra")?
        );
    }
    Ok(lines)
}
