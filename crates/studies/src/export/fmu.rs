//! Functional mock-up unit: table in C, description and, if a compiler is available, a library for this machine.

use std::fmt::Write as _;
use std::io::{Cursor, Write as _};
use std::path::Path;
use std::process::Command;

use asperity_core::{Fault, PROGRAM};
use asperity_storage::{Draft, sha256, whole_file};
use zip::ZipWriter;
use zip::result::ZipResult;
use zip::write::SimpleFileOptions;

use super::error;
use super::field::Field;
use super::given::ExportGiven;

const MODEL: &str = "AsperityLoss";
const CODE: &str = include_str!("fmu.c");

/// Self-contained C source of the unit of a map, from its fields by temperature.
///
/// # Errors
/// When the map has only one torque or one speed, or no temperature.
pub fn c_source(fields: &[Field]) -> Result<String, Fault> {
    let first = first(fields)?;
    let values = |of: &dyn Fn(&Field) -> Vec<f64>| fields.iter().flat_map(of).collect::<Vec<f64>>();
    let parts = (0..first.parts.len()).flat_map(|k| values(&|field| field.parts[k].1.clone()));
    let mut parts: Vec<f64> = parts.collect();
    if parts.is_empty() {
        // C has no empty tables.
        parts.push(0.0);
    }
    let head = Field::head_of(fields).replace("*/", "* /");
    let scope = first.scope.replace("*/", "* /");
    let mut text = format!(
        "/* {head}; scope: {scope} */\n#define GUID \"{}\"\n#define NC {}\n#define NT {}\n#define NW {}\n#define NP {}\n",
        guid(fields),
        fields.len(),
        first.torque_nm.len(),
        first.speed_rpm.len(),
        first.parts.len()
    );
    let added = |field: &Field| {
        let none = || vec![0.0; field.mesh_nm.len()];
        field.added_nm.clone().unwrap_or_else(none)
    };
    let tables = [
        (
            "C",
            fields.iter().map(|field| field.temperature_c).collect(),
        ),
        ("T", first.torque_nm.clone()),
        ("W", first.omega()),
        ("MESH", values(&|field| field.mesh_nm.clone())),
        ("ADDED", values(&added)),
        ("PARTS", parts),
    ];
    for (name, values) in tables {
        let values: Vec<String> = values.iter().map(|value| format!("{value:?}")).collect();
        // Writing into a string cannot fail.
        let _ = writeln!(
            text,
            "static const double {name}[] = {{{}}};",
            values.join(",\n")
        );
    }
    text.push_str(CODE);
    Ok(text)
}

fn first(fields: &[Field]) -> Result<&Field, Fault> {
    const FORMAT: &str = "the FMU";
    let first = fields.first().ok_or_else(|| error::too_small(FORMAT))?;
    first.check_size(FORMAT)?;
    Ok(first)
}

/// The unit: description, source and, if `cc` is available, a library for this machine.
pub(super) fn archive(given: &ExportGiven<'_>) -> Result<Option<Vec<u8>>, Fault> {
    let source = c_source(given.fields)?;
    let library = library(&source, given.with.beside);
    let description = description(given.fields, library.is_some())?;
    let zipped = zipped(&description, &source, library);
    zipped.map(Some).map_err(error::unwritten)
}

fn zipped(description: &str, source: &str, library: Option<Library>) -> ZipResult<Vec<u8>> {
    let mut zip = ZipWriter::new(Cursor::new(Vec::new()));
    let options = SimpleFileOptions::default();
    zip.start_file("modelDescription.xml", options)?;
    zip.write_all(description.as_bytes())?;
    zip.start_file("sources/loss.c", options)?;
    zip.write_all(source.as_bytes())?;
    if let Some(Library {
        folder,
        name,
        bytes,
    }) = library
    {
        zip.start_file(format!("binaries/{folder}/{name}"), options)?;
        zip.write_all(&bytes)?;
    }
    Ok(zip.finish()?.into_inner())
}

/// Largest size of a library in bytes.
const LARGEST: u64 = 100_000_000;

/// Library for one platform, with its path in the unit.
struct Library {
    folder: &'static str,
    name: String,
    bytes: Vec<u8>,
}

/// Compiles the source in a draft next to `beside`; `None` without a compiler or for a platform without a path in the unit.
fn library(source: &str, beside: Option<&Path>) -> Option<Library> {
    let (folder, ending) = match (std::env::consts::OS, std::env::consts::ARCH) {
        ("linux", "x86_64") => ("linux64", "so"),
        ("macos", "x86_64") => ("darwin64", "dylib"),
        _ => return None,
    };
    // The next process removes the draft of a killed one.
    let draft = beside.and_then(|beside| Draft::beside(beside).ok());
    let elsewhere = || Draft::beside(&std::env::temp_dir().join(MODEL)).ok();
    let place = draft.or_else(elsewhere)?;
    let folder_of_draft = place.made();
    std::fs::create_dir(&folder_of_draft).ok()?;
    let [code, made] = ["loss.c", "loss"].map(|name| folder_of_draft.join(name));
    std::fs::write(&code, source).ok()?;
    let done = Command::new("cc")
        .args(["-O2", "-shared", "-fPIC", "-fvisibility=hidden", "-w", "-o"])
        .args([&made, &code])
        // The compiler has temporary files, too.
        .env("TMPDIR", &folder_of_draft)
        .output()
        .ok()?;
    done.status.success().then_some(())?;
    Some(Library {
        folder,
        name: format!("{MODEL}.{ending}"),
        bytes: whole_file(&made, LARGEST).ok()?,
    })
}

/// Identifier computed from the content, so that a description matches only its source.
fn guid(fields: &[Field]) -> String {
    let mut bytes = CODE.as_bytes().to_vec();
    let none = Vec::new();
    for field in fields {
        let added = field.added_nm.as_ref().unwrap_or(&none);
        let parts = field.parts.iter().map(|(_, values)| values);
        let tables = [
            &vec![field.temperature_c],
            &field.torque_nm,
            &field.speed_rpm,
            &field.mesh_nm,
            added,
        ];
        for values in tables.into_iter().chain(parts) {
            bytes.extend(values.len().to_le_bytes());
            bytes.extend(values.iter().flat_map(|value| value.to_le_bytes()));
        }
    }
    format!("{{{}}}", &sha256(&bytes)[..32])
}

/// Value reference of the temperature, an input of maps of several; the parts of the meshes follow it.
const TEMPERATURE: usize = 7;
/// Name, unit and meaning of the outputs, in the order of their value references from 2.
const OUTPUTS: [(&str, &str, &str); 5] = [
    (
        "loss_torque",
        "N.m",
        "loss torque at the input shaft, never negative",
    ),
    ("loss_power", "W", "loss power"),
    (
        "outside",
        "1",
        "1 outside of the map, where the ratio of loss to torque and the temperature are those of its edge, or for NaN",
    ),
    ("mesh_loss_torque", "N.m", "part of all meshes"),
    (
        "added_loss_torque",
        "N.m",
        "part that was added to the mesh",
    ),
];

fn description(fields: &[Field], has_library: bool) -> Result<String, Fault> {
    let field = first(fields)?;
    let escaped = |text: &str| {
        let safe = text.replace('&', "&amp;").replace('<', "&lt;");
        safe.replace('>', "&gt;").replace('"', "&quot;")
    };
    let note = if has_library {
        ""
    } else {
        "; source only, to be compiled"
    };
    let sources = "<SourceFiles><File name=\"loss.c\"/></SourceFiles>";
    let mut variables = String::new();
    let temperatures = fields.iter().map(|field| field.temperature_c.to_string());
    let temperatures = format!(
        "temperature; the map has {} degC, with linear interpolation between them",
        temperatures.collect::<Vec<_>>().join(", ")
    );
    let mut inputs = vec![
        (
            0,
            "tau",
            "N.m",
            "torque of the input shaft; negative: the output drives",
            0.0,
        ),
        (1, "omega", "rad/s", "speed of the input shaft", 0.0),
    ];
    if fields.len() > 1 {
        inputs.push((
            TEMPERATURE,
            "temperature",
            "degC",
            &temperatures,
            field.temperature_c,
        ));
    }
    for (reference, name, unit, meaning, start) in &inputs {
        let _ = writeln!(
            variables,
            "    <ScalarVariable name=\"{name}\" valueReference=\"{reference}\" causality=\"input\" variability=\"continuous\" description=\"{meaning}\"><Real unit=\"{unit}\" start=\"{start}\"/></ScalarVariable>"
        );
    }
    let dependencies = (1..=inputs.len()).map(|k| k.to_string());
    let dependencies = dependencies.collect::<Vec<_>>().join(" ");
    let mut unknowns = String::new();
    let common = OUTPUTS
        .iter()
        .enumerate()
        .map(|(k, (name, unit, meaning))| {
            (k + 2, (*name).to_owned(), *unit, (*meaning).to_owned())
        });
    let parts = field.parts.iter().enumerate().map(|(k, (name, _))| {
        let output = format!("mesh_{}_loss_torque", k + 1);
        let meaning = format!("part of {} at the input shaft", escaped(name));
        (TEMPERATURE + 1 + k, output, "N.m", meaning)
    });
    for (index, (reference, name, unit, meaning)) in common.chain(parts).enumerate() {
        let _ = writeln!(
            variables,
            "    <ScalarVariable name=\"{name}\" valueReference=\"{reference}\" causality=\"output\" variability=\"continuous\" initial=\"calculated\" description=\"{meaning}\"><Real unit=\"{unit}\"/></ScalarVariable>",
        );
        let _ = write!(
            unknowns,
            "<Unknown index=\"{}\" dependencies=\"{dependencies}\"/>",
            index + 1 + inputs.len()
        );
    }
    Ok(format!(
        "<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n\
         <fmiModelDescription fmiVersion=\"2.0\" modelName=\"{MODEL}\" guid=\"{}\" description=\"{}; scope: {}{note}\" generationTool=\"{PROGRAM}\" numberOfEventIndicators=\"0\">\n\
         \x20 <ModelExchange modelIdentifier=\"{MODEL}\" needsExecutionTool=\"false\">{sources}</ModelExchange>\n\
         \x20 <CoSimulation modelIdentifier=\"{MODEL}\" canHandleVariableCommunicationStepSize=\"true\" needsExecutionTool=\"false\">{sources}</CoSimulation>\n\
         \x20 <UnitDefinitions><Unit name=\"N.m\"><BaseUnit kg=\"1\" m=\"2\" s=\"-2\"/></Unit><Unit name=\"rad/s\"><BaseUnit s=\"-1\" rad=\"1\"/></Unit><Unit name=\"W\"><BaseUnit kg=\"1\" m=\"2\" s=\"-3\"/></Unit><Unit name=\"1\"><BaseUnit/></Unit><Unit name=\"degC\"><BaseUnit K=\"1\" offset=\"273.15\"/></Unit></UnitDefinitions>\n\
         \x20 <ModelVariables>\n{variables}  </ModelVariables>\n\
         \x20 <ModelStructure><Outputs>{unknowns}</Outputs><InitialUnknowns>{unknowns}</InitialUnknowns></ModelStructure>\n\
         </fmiModelDescription>\n",
        guid(fields),
        escaped(&Field::head_of(fields)),
        escaped(&field.scope)
    ))
}
