//! `asperity regime`: film thickness, load share and regime along the path, without friction.

use asperity::case::LoadedCase;
use asperity::pipeline::{RegimeRow, survey};
use asperity::result::Regime;
use asperity_core::by_size;
use asperity_report::{Cell, Report, Table, columns};
use serde_json::json;

use super::{load_train, mesh_of, of_meshes};
use crate::args::{CaseArgs, Common};
use crate::failure::Failure;
use crate::output::print_report;

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
    let report = || {
        let report = Report::new(&train.title, "");
        let report = found.iter().fold(report, |report, (title, rows)| {
            let of = if is_only {
                ""
            } else {
                mesh_of(&train.title, title)
            };
            report.verdict(verdict(of, rows))
        });
        found.iter().fold(report, |report, (title, rows)| {
            let report = match is_only {
                true => report,
                false => report.heading(title),
            };
            report.table(table(rows))
        })
    };
    print_report(
        common,
        || of_meshes(&train, &found.iter().map(value).collect::<Vec<_>>()),
        report,
        None,
    )
}

/// The regime along the path of the mesh `of`, with the share of the load on the film and the thinnest film.
fn verdict(of: &str, rows: &[RegimeRow]) -> Option<String> {
    let count = |regime: Regime| rows.iter().filter(|row| regime_of(row) == regime).count();
    let (full, all) = (count(Regime::FullFilm), rows.len());
    let regime = match full {
        0 => format!("mixed film at all {all} positions"),
        _ if full == all => format!("full film at all {all} positions"),
        _ => format!("full film at {full} of {all} positions, mixed at the others"),
    };
    let thinnest = rows
        .iter()
        .min_by(|a, b| a.film_central_um.total_cmp(&b.film_central_um))?;
    let shares = || rows.iter().map(|row| 100.0 * row.film_share);
    let (low, high) = (
        shares().fold(f64::MAX, f64::min),
        shares().fold(0.0, f64::max),
    );
    let mesh = if of.is_empty() {
        String::new()
    } else {
        format!("{of}: ")
    };
    Some(format!(
        "{mesh}{regime}; the film carries {low:.0} to {high:.0} % of the load and is thinnest, {:.3} µm, at {:.2} of the path from A to E.",
        thinnest.film_central_um, thinnest.path_fraction
    ))
}

/// The regime of a position. No friction is computed here.
fn regime_of(row: &RegimeRow) -> Regime {
    Regime::of_friction(row.mixed_share, 0.0, 0.0)
}

fn table(rows: &[RegimeRow]) -> Table {
    let table = columns! { row in rows;
        number path_fraction "A to E" "" "{:.4}";
        number line_load_n_per_mm "line load" "N/mm" "{:.2}";
        number hertz_pressure_mpa "Hertz pressure" "MPa" "{:.0}";
        number sliding_m_per_s "sliding speed" "m/s" "{:.4}";
        number film_central_um "central film" "µm" = Cell::number(row.film_central_um, |um| by_size(um, 4));
        number film_minimum_um "minimum film" "µm" = Cell::number(row.film_minimum_um, |um| by_size(um, 4));
        number thermal_reduction "thermal reduction" "" "{:.3}";
        number lambda_star "Λ*" "" "{:.3}";
        number film_share "film load" "%" "{:.1}" = 100.0 * row.film_share;
        text regime "regime" "" = regime_of(row).name();
    };
    table.brief(&["minimum film"])
}
