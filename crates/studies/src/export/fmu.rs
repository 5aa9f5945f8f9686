//! Functional mock-up unit: table in C, description and, if a compiler is available, a library for this machine.

use std::fmt::Write as _;
use std::io::{Cursor, Write as _};
use std::process::Command;

use asperity_storage::whole_file;
use sha2::{Digest, Sha256};
use zip::ZipWriter;
use zip::write::SimpleFileOptions;

use super::error::ExportError;
use super::field::Field;

const MODEL: &str = "AsperityLoss";
const CODE: &str = include_str!("fmu.c");

/// Self-contained C source of the unit.
///
/// # Errors
/// When the map has only one torque or one speed.
pub fn c_source(field: &Field) -> Result<String, ExportError> {
    field.check_size("the FMU")?;
    let added = field
        .added_nm
        .clone()
        .unwrap_or_else(|| vec![0.0; field.mesh_nm.len()]);
    let head = field.head().replace("*/", "* /");
    let scope = field.scope.replace("*/", "* /");
    let mut text = format!(
        "/* {head}; scope: {scope} */\n#define GUID \"{}\"\n#define NT {}\n#define NW {}\n",
        guid(field),
        field.torque_nm.len(),
        field.speed_rpm.len()
    );
    let tables = [
        ("T", &field.torque_nm),
        ("W", &field.omega()),
        ("MESH", &field.mesh_nm),
        ("ADDED", &added),
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

/// The unit: description, source and, if `cc` is available, a library for this machine.
pub(super) fn archive(field: &Field) -> Result<Vec<u8>, ExportError> {
    let source = c_source(field)?;
    let library = library(&source);
    let mut zip = ZipWriter::new(Cursor::new(Vec::new()));
    let options = SimpleFileOptions::default();
    zip.start_file("modelDescription.xml", options)?;
    zip.write_all(description(field, library.is_some()).as_bytes())?;
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

/// Compiles the source; `None` without a compiler or for a platform without a path in the unit.
fn library(source: &str) -> Option<Library> {
    let (folder, ending) = match (std::env::consts::OS, std::env::consts::ARCH) {
        ("linux", "x86_64") => ("linux64", "so"),
        ("macos", "x86_64") => ("darwin64", "dylib"),
        _ => return None,
    };
    let place = tempfile::tempdir().ok()?;
    let (code, made) = (place.path().join("loss.c"), place.path().join("loss"));
    std::fs::write(&code, source).ok()?;
    let done = Command::new("cc")
        .args(["-O2", "-shared", "-fPIC", "-fvisibility=hidden", "-w", "-o"])
        .args([&made, &code])
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
fn guid(field: &Field) -> String {
    let mut sum = Sha256::new();
    sum.update(CODE.as_bytes());
    let none = Vec::new();
    let added = field.added_nm.as_ref().unwrap_or(&none);
    for values in [&field.torque_nm, &field.speed_rpm, &field.mesh_nm, added] {
        sum.update(values.len().to_le_bytes());
        for value in values {
            sum.update(value.to_le_bytes());
        }
    }
    let hex: String = sum
        .finalize()
        .iter()
        .map(|byte| format!("{byte:02x}"))
        .collect();
    format!("{{{}}}", &hex[..32])
}

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
        "1 outside of the map, where the ratio of loss to torque is that of its edge, or for NaN",
    ),
    ("mesh_loss_torque", "N.m", "part of the mesh"),
    (
        "added_loss_torque",
        "N.m",
        "part that was added to the mesh",
    ),
];

fn description(field: &Field, has_library: bool) -> String {
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
    let inputs = [
        (
            "tau",
            "N.m",
            "torque of the input shaft; negative: the output drives",
        ),
        ("omega", "rad/s", "speed of the input shaft"),
    ];
    for (reference, (name, unit, meaning)) in inputs.iter().enumerate() {
        let _ = writeln!(
            variables,
            "    <ScalarVariable name=\"{name}\" valueReference=\"{reference}\" causality=\"input\" variability=\"continuous\" description=\"{meaning}\"><Real unit=\"{unit}\" start=\"0\"/></ScalarVariable>"
        );
    }
    let mut unknowns = String::new();
    for (index, (name, unit, meaning)) in OUTPUTS.iter().enumerate() {
        let _ = writeln!(
            variables,
            "    <ScalarVariable name=\"{name}\" valueReference=\"{}\" causality=\"output\" variability=\"continuous\" initial=\"calculated\" description=\"{meaning}\"><Real unit=\"{unit}\"/></ScalarVariable>",
            index + 2
        );
        let _ = write!(
            unknowns,
            "<Unknown index=\"{}\" dependencies=\"1 2\"/>",
            index + 3
        );
    }
    format!(
        "<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n\
         <fmiModelDescription fmiVersion=\"2.0\" modelName=\"{MODEL}\" guid=\"{}\" description=\"{}; scope: {}{note}\" generationTool=\"asperity {}\" numberOfEventIndicators=\"0\">\n\
         \x20 <ModelExchange modelIdentifier=\"{MODEL}\" needsExecutionTool=\"false\">{sources}</ModelExchange>\n\
         \x20 <CoSimulation modelIdentifier=\"{MODEL}\" canHandleVariableCommunicationStepSize=\"true\" needsExecutionTool=\"false\">{sources}</CoSimulation>\n\
         \x20 <UnitDefinitions><Unit name=\"N.m\"><BaseUnit kg=\"1\" m=\"2\" s=\"-2\"/></Unit><Unit name=\"rad/s\"><BaseUnit s=\"-1\" rad=\"1\"/></Unit><Unit name=\"W\"><BaseUnit kg=\"1\" m=\"2\" s=\"-3\"/></Unit><Unit name=\"1\"><BaseUnit/></Unit></UnitDefinitions>\n\
         \x20 <ModelVariables>\n{variables}  </ModelVariables>\n\
         \x20 <ModelStructure><Outputs>{unknowns}</Outputs><InitialUnknowns>{unknowns}</InitialUnknowns></ModelStructure>\n\
         </fmiModelDescription>\n",
        guid(field),
        escaped(&field.head()),
        escaped(&field.scope),
        env!("CARGO_PKG_VERSION")
    )
}
