//! Output of a merged study: `sweep.csv`, `sweep.json`, `effects.csv`, `sweep.html` and summary.

use std::path::Path;

use asperity::message::explain;
use asperity_core::Fault;
use asperity_report::{StudyResult, tables, write_bytes};
use asperity_storage::one_line;
use serde::Serialize;

use super::merged::Merged;
use super::page;
use super::words::table;

impl StudyResult for Merged {
    const KIND: &'static str = "sweep";
    const NAME: &'static str = "sweep";
    type Context<'a> = ();

    fn summary(&self, (): ()) -> String {
        summary(self)
    }

    fn page(&self, (): ()) -> String {
        page::render(self)
    }

    fn write_tables(&self, (): (), folder: &Path) -> Result<(), Fault> {
        write_bytes(&folder.join("sweep.csv"), &self.table)?;
        effects_table(self, &folder.join("effects.csv"))
    }
}

fn summary(merged: &Merged) -> String {
    let mut text = format!(
        "{}\n{} cases, {} without a result\n",
        one_line(&merged.title),
        merged.cases,
        merged.failed
    );
    for (code, count) in &merged.outside {
        let title = explain(code).map_or("", |entry| entry.title);
        text.push_str(&format!("{code} in {count} cases: {title}\n"));
    }
    text.push_str(&table(merged).without(&["input"]).text(""));
    text.push_str(&format!("SHA-256 {}\n", merged.sha256));
    text
}

fn effects_table(merged: &Merged, file: &Path) -> Result<(), Fault> {
    #[derive(Serialize)]
    struct EffectColumns<'a> {
        output: &'a str,
        input: &'a str,
        low: Option<f64>,
        high: Option<f64>,
        difference: Option<f64>,
        difference_p05: Option<f64>,
        difference_p95: Option<f64>,
        correlation: Option<f64>,
        first: Option<f64>,
        first_low: Option<f64>,
        first_high: Option<f64>,
        total: Option<f64>,
        total_low: Option<f64>,
        total_high: Option<f64>,
    }
    let rows = merged.effects.iter().map(|row| EffectColumns {
        output: &row.output,
        input: &row.input,
        low: row.effect.map(|effect| effect.low),
        high: row.effect.map(|effect| effect.high),
        difference: row.effect.map(|effect| effect.difference),
        difference_p05: row.effect.map(|effect| effect.quantiles[0]),
        difference_p95: row.effect.map(|effect| effect.quantiles[1]),
        correlation: row.effect.map(|effect| effect.correlation),
        first: row.indices.map(|indices| indices.first),
        first_low: row.indices.map(|indices| indices.first_interval[0]),
        first_high: row.indices.map(|indices| indices.first_interval[1]),
        total: row.indices.map(|indices| indices.total),
        total_low: row.indices.map(|indices| indices.total_interval[0]),
        total_high: row.indices.map(|indices| indices.total_interval[1]),
    });
    tables::write(file, rows)
}
