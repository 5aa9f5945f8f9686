//! Reads a case, runs it, writes its result folder, reads the result back and draws its page anew.
//!
//! `cargo run -p asperity-report --example load_run_report -- fixtures/cases/e-drive.toml results/e-drive`

use std::path::PathBuf;

fn main() -> Result<(), Box<dyn std::error::Error>> {
    let mut arguments = std::env::args_os().skip(1).map(PathBuf::from);
    let case = arguments
        .next()
        .unwrap_or_else(|| "fixtures/cases/e-drive.toml".into());
    let folder = arguments
        .next()
        .unwrap_or_else(|| std::env::temp_dir().join("asperity-load-run-report"));

    let loaded = asperity::case::load(&case, None)?;
    let outcome = asperity::run(&loaded, &|_, _| {})?;
    print!("{}", asperity_report::summary(&outcome.result));

    asperity_report::write_folder(&outcome, &folder)?;
    let (_, result) = asperity_report::read_result(&folder)?;
    assert_eq!(result, outcome.result);
    let page = asperity_report::redraw(&folder, None)?;
    println!("wrote {}", page.display());
    Ok(())
}
