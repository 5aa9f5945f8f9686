//! Output of a sensitivity study: `sensitivity.json`, table, page and summary.

use std::path::Path;

use asperity_core::{Code, Fault};
use asperity_report::StudyResult;
use asperity_report::tables::write as write_table;
use serde::Serialize;

use super::page;
use super::study::Sensitivity;
use super::summary::summary;

impl StudyResult for Sensitivity {
    const KIND: &'static str = "sensitivity study";
    const NAME: &'static str = "sensitivity";
    type Context<'a> = ();

    fn summary(&self, (): ()) -> String {
        summary(self)
    }

    fn page(&self, (): ()) -> String {
        page::render(self)
    }

    fn write_tables(&self, (): (), folder: &Path) -> Result<(), Fault> {
        write_table(&folder.join("sensitivity.csv"), rows(self))
    }
}

#[derive(Serialize)]
struct ChangeRow<'a> {
    group: &'a str,
    change: &'a str,
    to: &'a str,
    difference_w: Option<f64>,
    change_percent: Option<f64>,
    difference_p05_w: Option<f64>,
    difference_p95_w: Option<f64>,
    film_w: Option<f64>,
    lubricated_asperity_w: Option<f64>,
    boundary_w: Option<f64>,
    rolling_w: Option<f64>,
    code: Option<Code>,
}

fn rows(study: &Sensitivity) -> impl Iterator<Item = ChangeRow<'_>> {
    study.rows.iter().map(|row| {
        let effect = row.effect.as_ref();
        ChangeRow {
            group: row.group,
            change: &row.what,
            to: &row.to,
            difference_w: effect.map(|effect| effect.difference_w),
            change_percent: effect.map(|effect| 100.0 * effect.change),
            difference_p05_w: effect.and_then(|effect| Some(effect.sampling_quantiles_w?[0])),
            difference_p95_w: effect.and_then(|effect| Some(effect.sampling_quantiles_w?[1])),
            film_w: effect.map(|effect| effect.film_w),
            lubricated_asperity_w: effect.map(|effect| effect.lubricated_asperity_w),
            boundary_w: effect.map(|effect| effect.boundary_w),
            rolling_w: effect.map(|effect| effect.rolling_w),
            code: row.refused.as_ref().map(|refused| refused.code),
        }
    })
}
