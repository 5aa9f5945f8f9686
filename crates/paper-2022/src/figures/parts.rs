//! Fig. 12: losses in contact and after contact, four parts each. The paper draws pies; its deformations are far smaller
//! than a line of a pie, so these are bars with their values.
//!
//! In contact the deformation of eq. 19 is elastic and plastic, after contact only plastic; sliding and rolling
//! are the same in both. Eq. 19 counts a patch of one cell by one cell once per revolution; a third panel has the
//! deformation after contact over the face width in every engagement of a tooth, b z₁/a of the printed value.

use std::path::Path;

use asperity::result::Summary;
use asperity_core::Fault;
use asperity_report::chart::{Axis, Bar, BarChart, Drawing};
use asperity_report::tables::write;
use serde::Serialize;

use super::figure::PaperFigure;

const TABLE: &str = "fig12_losses.csv";

/// Part of both panels.
#[derive(Debug, Clone, Copy, PartialEq, Serialize)]
struct PartRow {
    part: &'static str,
    in_contact_w: f64,
    in_contact_percent: f64,
    after_contact_w: f64,
    after_contact_percent: f64,
    every_engagement_w: f64,
    every_engagement_percent: f64,
}

/// The panels; `engagements` is the number of cells across the face times the engagements in a revolution.
pub(super) fn figures(
    summary: &Summary,
    engagements: f64,
    folder: &Path,
) -> Result<Vec<PaperFigure>, Fault> {
    let (within, after) = (summary.deformation_in_contact_w, summary.deformation_w);
    let (sliding, rolling) = (summary.sliding_w, summary.rolling_w);
    let parts = [
        (
            "deformation, pinion",
            [within[0], after[0], engagements * after[0]],
        ),
        (
            "deformation, wheel",
            [within[1], after[1], engagements * after[1]],
        ),
        ("sliding", [sliding; 3]),
        ("rolling", [rolling; 3]),
    ];
    let whole = [0, 1, 2].map(|panel: usize| parts.iter().map(|part| part.1[panel]).sum::<f64>());
    let percent = |power: f64, whole: f64| {
        if whole > 0.0 {
            100.0 * power / whole
        } else {
            0.0
        }
    };
    let rows = parts.map(|(part, [first, second, third])| PartRow {
        part,
        in_contact_w: first,
        in_contact_percent: percent(first, whole[0]),
        after_contact_w: second,
        after_contact_percent: percent(second, whole[1]),
        every_engagement_w: third,
        every_engagement_percent: percent(third, whole[2]),
    });
    write(&folder.join(TABLE), rows)?;
    let bars = |name, title: &str, of: fn(&PartRow) -> [f64; 2]| PaperFigure {
        name,
        drawing: Drawing::Bars(BarChart {
            id: name.to_owned(),
            title: title.to_owned(),
            source: TABLE.to_owned(),
            axis: Axis::new("loss", "W"),
            bars: rows.iter().map(|row| bar(row.part, of(row))).collect(),
        }),
    };
    Ok(vec![
        bars("fig12a_in_contact", "Fig. 12a: losses in contact", |row| {
            [row.in_contact_w, row.in_contact_percent]
        }),
        bars(
            "fig12b_after_contact",
            "Fig. 12b: losses after contact",
            |row| [row.after_contact_w, row.after_contact_percent],
        ),
        bars(
            "fig12c_every_engagement",
            "Fig. 12c: losses after contact, deformation over the face in every engagement",
            |row| [row.every_engagement_w, row.every_engagement_percent],
        ),
    ])
}

fn bar(name: &str, [value, percent]: [f64; 2]) -> Bar {
    let text = if percent >= 0.01 {
        format!("{value:.1} W, {percent:.1} %")
    } else {
        format!("{value:.1e} W, {percent:.0e} %")
    };
    Bar {
        name: name.to_owned(),
        value: Some(value),
        spread: None,
        text,
    }
}
