//! `asperity demo`: a worked case to start from.

use std::path::Path;

use asperity_fixtures::TextFile;
use serde_json::json;

use crate::args::Common;
use crate::failure::Failure;
use crate::output::{print_json, print_text};

/// `asperity demo`
pub fn demo(folder: &Path, common: &Common) -> Result<(), Failure> {
    let name = folder.display();
    if folder.exists() {
        return Err(Failure::new(
            "E401",
            format!("{name}: exists already; name another folder, as asperity demo my-first-case"),
        ));
    }
    let files = asperity_fixtures::demo::files()
        .map_err(|error| Failure::new("E501", format!("the demo cannot be made: {error}")))?;
    write(&files, folder)
        .map_err(|error| Failure::new("E401", format!("{name}: cannot be written: {error}")))?;
    if common.json {
        let names: Vec<&str> = files.iter().map(|file| file.name).collect();
        return print_json(&json!({ "folder": folder, "files": names }));
    }
    print_text(
        common,
        &format!(
            "wrote {name}: case.toml, two pairs of flanks (synthetic) and a README\n\
             next: asperity run {name}/case.toml\n"
        ),
    )
}

/// Writes beside the place and renames, so that an interruption leaves no half folder.
fn write(files: &[TextFile], folder: &Path) -> std::io::Result<()> {
    let parent = match folder.parent() {
        Some(parent) if !parent.as_os_str().is_empty() => parent,
        _ => Path::new("."),
    };
    std::fs::create_dir_all(parent)?;
    let draft = asperity_report::draft_folder(parent)?;
    let made = draft.path().join("demo");
    std::fs::create_dir(&made)?;
    for file in files {
        std::fs::write(made.join(file.name), &file.content)?;
    }
    std::fs::rename(&made, folder)
}
