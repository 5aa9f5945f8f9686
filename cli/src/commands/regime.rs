//! `asperity regime`: film thickness, load share and regime along the path, without friction.

use asperity::case::LoadedCase;
use asperity::case::train::LoadedMesh;
use asperity::pipeline::{RegimeRow, survey};
use asperity::result::Regime;
use serde_json::json;

use super::{AnyCase, load_any};
use crate::args::{CaseArgs, Common};
use crate::failure::Failure;
use crate::output::print;

/// `asperity regime`
pub fn regime(args: &CaseArgs, common: &Common) -> Result<(), Failure> {
    let rows =
        |loaded: &LoadedCase| survey(loaded).map_err(|error| Failure::about(&args.case, &error));
    match load_any(&args.case, &args.set, args.formulation)? {
        AnyCase::Pair(pair) => {
            let rows = rows(&pair)?;
            print(common, || &rows, || table(&rows))
        }
        AnyCase::Train(train) => {
            let of_mesh = |mesh: &LoadedMesh| Ok((mesh.case.case.title.clone(), rows(&mesh.case)?));
            let of_meshes = train
                .meshes()
                .map(of_mesh)
                .collect::<Result<Vec<_>, Failure>>()?;
            let meshes = || of_meshes.iter();
            let values = || meshes().map(|(title, rows)| json!({ "title": title, "rows": rows }));
            let tables = meshes().map(|(title, rows)| {
                format!("{}\n{}", asperity_storage::one_line(title), table(rows))
            });
            print(
                common,
                || json!({ "title": train.title, "meshes": values().collect::<Vec<_>>() }),
                || tables.collect::<Vec<_>>().join("\n"),
            )
        }
    }
}

fn table(rows: &[RegimeRow]) -> String {
    let mut text = format!(
        "{:>8} {:>9} {:>7} {:>9} {:>9} {:>9} {:>7} {:>8} {:>7}  regime\n",
        "A-E", "f N/mm", "p0 MPa", "Vs m/s", "hc um", "hm um", "phi", "Lambda*", "film %"
    );
    for row in rows {
        let lambda = row
            .lambda_star
            .map_or("-".to_owned(), |value| format!("{value:.3}"));
        // No friction is computed here.
        let regime = Regime::of_friction(row.mixed_share, 0.0, 0.0);
        text.push_str(&format!(
            "{:>8.4} {:>9.2} {:>7.0} {:>9.4} {:>9.4} {:>9.4} {:>7.3} {lambda:>8} {:>7.1}  {}\n",
            row.path_fraction,
            row.line_load_n_per_mm,
            row.hertz_pressure_mpa,
            row.sliding_m_per_s,
            row.film_central_um,
            row.film_minimum_um,
            row.thermal_reduction,
            100.0 * row.film_share,
            regime.name(),
        ));
    }
    text
}
