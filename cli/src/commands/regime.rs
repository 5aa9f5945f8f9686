//! `asperity regime`: film thickness, load share and regime along the path, without friction.

use asperity::case::LoadedCase;
use asperity::pipeline::{RegimeRow, survey};
use asperity::result::Regime;
use asperity_report::columns;
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
    let table = columns! { row in rows;
        number path_fraction "A to E" "" "{:.4}";
        number line_load_n_per_mm "line load" "N/mm" "{:.2}";
        number hertz_pressure_mpa "Hertz pressure" "MPa" "{:.0}";
        number sliding_m_per_s "sliding speed" "m/s" "{:.4}";
        number film_central_um "central film" "µm" "{:.4}";
        number film_minimum_um "minimum film" "µm" "{:.4}";
        number thermal_reduction "thermal reduction" "" "{:.3}";
        number lambda_star "Λ*" "" "{:.3}";
        number film_share "film load" "%" "{:.1}" = 100.0 * row.film_share;
        // No friction is computed here.
        text regime "regime" "" = Regime::of_friction(row.mixed_share, 0.0, 0.0).name();
    };
    table.brief(&["minimum film"]).text("")
}
