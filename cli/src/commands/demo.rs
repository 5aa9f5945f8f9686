//! `asperity demo`: a worked case to start from.

use std::path::Path;

use crate::args::Common;
use crate::failure::Failure;
use crate::output::print_text;

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
    std::fs::create_dir_all(folder).map_err(|error| refused(folder, &error))?;
    for file in files {
        let path = folder.join(file.name);
        std::fs::write(&path, file.content).map_err(|error| refused(&path, &error))?;
    }
    if common.quiet {
        return Ok(());
    }
    print_text(&format!(
        "wrote {name}: case.toml, two pairs of flanks (synthetic) and a README\n\
         next: asperity run {name}/case.toml\n"
    ))
}

fn refused(path: &Path, error: &std::io::Error) -> Failure {
    Failure::new(
        "E401",
        format!("{}: cannot be written: {error}", path.display()),
    )
}
