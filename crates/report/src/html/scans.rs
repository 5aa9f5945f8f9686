//! Scans of the flanks: patches against rows, or the loss of each row.

use asperity::result::RunResult;
use maud::{Markup, html};

use super::page::figure;
use crate::scans::{NOTE, drawings, losses, rows_chart, rows_line, rows_of, rows_table, without};

/// The section of a run; empty without scans.
pub(super) fn section(result: &RunResult) -> Markup {
    html! {
        @if let Some(scans) = &result.scans {
            h3 { "Patches of the scans against their rows" }
            (losses(scans))
            div.charts { @for drawing in &drawings(scans) { (figure(drawing)) } }
            p.note { (NOTE) }
        } @else if let Some(why) = &result.no_scans {
            p { (without(why)) }
        } @else if let Some((rows, sampling)) = rows_of(result) {
            h3 { "Loss of each row, taken as a line" }
            p { (rows_line(&rows, sampling)) }
            (rows_table(&rows, sampling))
            @if let Some(chart) = rows_chart(&rows, sampling.mean_w) { div.charts { (figure(&chart)) } }
        }
    }
}
