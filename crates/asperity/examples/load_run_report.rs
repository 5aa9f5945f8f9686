//! A case file with its traces, run, and its result reported as JSON.
//!
//! ```text
//! cargo run -p asperity --example load_run_report
//! ```

use std::path::Path;

use asperity::case::load;

pub fn main() -> Result<(), Box<dyn std::error::Error>> {
    let root = Path::new(env!("CARGO_MANIFEST_DIR")).join("../..");
    let case = load(&root.join("fixtures/cases/e-drive.toml"), None)?;
    let result = asperity::run(&case, &|done, of| eprint!("\r{done}/{of}"))?.result;
    eprintln!();
    let file = std::env::temp_dir().join(format!("asperity-{}.json", std::process::id()));
    std::fs::write(&file, serde_json::to_string_pretty(&result)?)?;
    let summary = &result.summary;
    println!(
        "efficiency {:.4} %, {:.0} W lost",
        100.0 * summary.efficiency,
        summary.loss_w
    );
    for warning in &result.warnings {
        println!("  {warning}");
    }
    println!("{} bytes of result", std::fs::metadata(&file)?.len());
    std::fs::remove_file(&file)?;
    Ok(())
}
