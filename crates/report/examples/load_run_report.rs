//! Reads a case, runs it, writes its result folder, reads the result back and draws its page again.
//!
//! `cargo run -p asperity-report --example load_run_report -- fixtures/cases/e-drive.toml results/e-drive`

use std::path::{Path, PathBuf};

use asperity_report::Fields;

fn main() -> Result<(), Box<dyn std::error::Error>> {
    let mut arguments = std::env::args_os().skip(1).map(PathBuf::from);
    let shipped =
        || Path::new(env!("CARGO_MANIFEST_DIR")).join("../../fixtures/cases/e-drive.toml");
    let case = arguments.next().unwrap_or_else(shipped);
    let folder = arguments
        .next()
        .unwrap_or_else(|| std::env::temp_dir().join("asperity-load-run-report"));
    load_run_report(&case, &folder)
}

/// Runs `case` and writes its result into `folder`.
pub fn load_run_report(case: &Path, folder: &Path) -> Result<(), Box<dyn std::error::Error>> {
    let loaded = asperity::case::load(case, None)?;
    let outcome = asperity::Run::new(&loaded).execute()?.into_only()?;
    print!("{}", asperity_report::summary(&outcome.result));

    asperity_report::write_folder(&outcome, folder, &Fields::Page)?;
    let (_, result) = asperity_report::read_result(folder)?;
    assert_eq!(result, outcome.result);
    let page = asperity_report::redraw(folder, None)?;
    println!("wrote {}", page.display());
    Ok(())
}
