//! Runs a case with a user-defined law of the friction in the film, and writes its result folder.
//!
//! `cargo run --release -p asperity-report --example own_law -- demo/case.toml results/own-law`

use std::path::{Path, PathBuf};
use std::sync::Arc;

use asperity::core::Checked;
use asperity::tribo_friction::{FilmContact, FilmFriction, FilmTraction, FrictionError};
use asperity_report::Fields;

/// Friction of a hypothetical oil: 2 % of the pressure, and a shear stress of 1 MPa over the whole contact.
#[derive(Debug)]
struct TwoTerms;

impl FilmFriction for TwoTerms {
    fn name(&self) -> &str {
        "two terms"
    }

    fn traction(&self, at: &FilmContact<'_>) -> Result<Checked<FilmTraction>, FrictionError> {
        let width = 2.0 * at.half_width.si();
        let coefficient = 0.02 + 1e6 * width / at.position.load.si();
        Ok(Checked::inside(FilmTraction::from_coefficient(coefficient)))
    }
}

fn main() -> Result<(), Box<dyn std::error::Error>> {
    let mut arguments = std::env::args_os().skip(1).map(PathBuf::from);
    match (arguments.next(), arguments.next()) {
        (Some(case), Some(folder)) => {
            print!("{}", own_law(&case, &folder)?);
            Ok(())
        }
        _ => Err("pass a case file and a result folder".into()),
    }
}

/// Runs `case` with the law and writes its result into `folder`; the summary.
pub fn own_law(case: &Path, folder: &Path) -> Result<String, Box<dyn std::error::Error>> {
    let loaded = asperity::case::load(case, None)?;
    let loaded = loaded.with_laws(|laws| laws.friction = Some(Arc::new(TwoTerms)));
    let outcome = asperity::Run::new(&loaded)
        .interval(true)
        .execute()?
        .into_only()?;
    asperity_report::write_folder(&outcome, folder, &Fields::Page)?;
    Ok(asperity_report::summary(&outcome.result))
}
