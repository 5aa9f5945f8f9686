//! `asperity regime`: film thickness, load share and regime along the path, without friction.

use asperity::case::LoadedCase;
use asperity::pipeline::{RegimeRow, survey};
use asperity::result::Regime;
use serde_json::json;

use super::{load_train, of_meshes};
use crate::args::{CaseArgs, Common};
use crate::failure::Failure;
use crate::output::print;

/// `asperity regime`
pub fn regime(args: &CaseArgs, common: &Common) -> Result<(), Failure> {
    let rows =
        |loaded: &LoadedCase| survey(loaded).map_err(|error| Failure::about(&args.case, &error));
    let train = load_train(&args.case, &args.set, args.formulation)?;
    let of_mesh = |case: &LoadedCase| Ok((case.case.title.clone(), rows(case)?));
    let found = train.cases().map(of_mesh);
    let found = found.collect::<Result<Vec<_>, Failure>>()?;
    let is_only = train.only().is_some();
    let value = |(title, rows): &(String, Vec<RegimeRow>)| match is_only {
        true => json!(rows),
        false => json!({ "title": title, "rows": rows }),
    };
    let text = |(title, rows): &(String, Vec<RegimeRow>)| match is_only {
        true => table(rows),
        false => format!("{}\n{}", asperity_storage::one_line(title), table(rows)),
    };
    print(
        common,
        || of_meshes(&train, &found.iter().map(value).collect::<Vec<_>>()),
        || found.iter().map(text).collect::<Vec<_>>().join("\n"),
    )
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
