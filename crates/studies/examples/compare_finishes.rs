//! Compares a ground with a superfinished pair of flanks on one case.
//!
//! `cargo run --release -p asperity-studies --example compare_finishes`

use std::path::Path;

use asperity_report::StudyResult;
use asperity_studies::compare::{Finish, compare};

fn main() -> Result<(), Box<dyn std::error::Error>> {
    let cases = Path::new(env!("CARGO_MANIFEST_DIR")).join("../../fixtures/cases");
    let mut finishes = Vec::new();
    for (name, file) in [
        ("ground", "e-drive.toml"),
        ("superfinished", "e-drive-superfinished.toml"),
    ] {
        let case = asperity::case::load_with(&cases.join(file), &|input| {
            input.model.positions = Some(8);
            input.model.offsets = Some(4);
        })?;
        finishes.push(Finish {
            name: name.to_owned(),
            case,
        });
    }
    print!("{}", compare(&finishes, &|_, _| {})?.summary());
    Ok(())
}
