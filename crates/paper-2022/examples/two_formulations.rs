//! The reference case of the paper in both formulations: efficiency and equivalent friction coefficient.

use std::path::Path;

use asperity::Run;
use asperity::formulation::FormulationChoice;

fn main() -> Result<(), Box<dyn std::error::Error>> {
    let file = Path::new("fixtures/cases/table2.toml");
    for formulation in [
        FormulationChoice::default(),
        asperity_paper_2022::register(),
    ] {
        let loaded = asperity::case::load(file, Some(formulation))?;
        let summary = Run::new(&loaded).execute()?.into_only()?.result.summary;
        println!(
            "{}: {} positions, efficiency {:.2} %, friction coefficient {:.4}",
            formulation.name(),
            summary.positions,
            100.0 * summary.efficiency,
            summary.mu_equivalent
        );
    }
    Ok(())
}
