//! `asperity demo`: a worked case to start from.

use std::path::Path;

use asperity_core::{Code, Fault};
use asperity_fixtures::TextFile;
use asperity_fixtures::worked::{Worked, WorkedError, WorkedGears};
use asperity_report::library::unlisted;
use asperity_report::wrapped;
use asperity_storage::new_folder_of;
use serde_json::json;

use crate::args::Common;
use crate::failure::Failure;
use crate::output::{print_json, print_text, shown};

/// `asperity demo`
pub fn demo(folder: Option<&Path>, worked: Worked<'_>, common: &Common) -> Result<(), Failure> {
    let folder = folder.unwrap_or(Path::new(worked.folder()));
    refuse_existing(folder)?;
    let files = worked.files().map_err(|error| match error {
        WorkedError::Gears(error) => unlisted(error),
        error => Fault::internal(error),
    })?;
    let option = match worked {
        Worked::Paper => " --formulation paper",
        _ => "",
    };
    let what = match worked {
        Worked::Drive => {
            "case.toml, two pairs of flanks and two cycles (synthetic), a README".to_owned()
        }
        Worked::Paper => "case.toml and a damaged flank (synthetic)".to_owned(),
        Worked::Gears(name) => {
            let gears = WorkedGears::named(name).map_err(unlisted)?;
            format!(
                "{}, two pairs of flanks (synthetic), a README; case.toml states the source of every number",
                gears.title()
            )
        }
    };
    finish(&files, folder, &what, option, common)
}

fn refuse_existing(folder: &Path) -> Result<(), Failure> {
    if folder.exists() {
        Err(Failure::new(
            Code::E401,
            format!(
                "{}: exists already; name another folder, e.g. asperity demo my-first-case",
                folder.display()
            ),
        ))
    } else {
        Ok(())
    }
}

/// Writes the files and reports them.
fn finish(
    files: &[TextFile],
    folder: &Path,
    what: &str,
    option: &str,
    common: &Common,
) -> Result<(), Failure> {
    let texts = files.iter().map(|file| (file.name, file.content.as_str()));
    new_folder_of(folder, texts).map_err(|error| Failure::new(Code::E401, error.to_string()))?;
    if common.json {
        let names: Vec<&str> = files.iter().map(|file| file.name).collect();
        return print_json(&json!({ "folder": folder, "files": names }));
    }
    let name = shown(folder);
    let wrote = wrapped(&format!("wrote {name}: {what}"), "  ");
    print_text(
        common,
        &format!("{wrote}\nnext: asperity run {name}/case.toml{option}\n"),
    )
}
