//! Temperatures along the path of contact: oil, flanks, and the flash in the contact above them.

use asperity::result::{PositionRow, RunResult};

use super::along::SOURCE;
use crate::chart::{Axis, Chart, Drawing, Line, Mark, Series};

/// Bulk temperature that film and friction were taken at \[°C\].
pub(super) fn bulk(result: &RunResult) -> f64 {
    match &result.bulk {
        Some(found) => found.bulk_c,
        None => result.inputs.operation.temperature.celsius(),
    }
}

/// Temperatures that are the same along the path, with their names.
fn constant(result: &RunResult) -> Vec<(String, f64)> {
    let Some(found) = &result.bulk else {
        let given = bulk(result);
        return vec![(format!("flanks, as given {given:.0} °C"), given)];
    };
    let oil = (format!("oil {:.0} °C", found.oil_c), found.oil_c);
    match found.gears_c {
        Some([pinion, wheel]) => vec![
            (format!("bulk of the pinion {pinion:.0} °C"), pinion),
            (format!("bulk of the wheel {wheel:.0} °C"), wheel),
            oil,
        ],
        None => vec![
            (
                format!("bulk of the flanks {:.0} °C", found.bulk_c),
                found.bulk_c,
            ),
            oil,
        ],
    }
}

/// The chart. Blok's flash temperature is that of both flanks, so that one contact temperature is drawn.
pub(super) fn along_the_path(result: &RunResult, axis: Axis, marks: &[Mark]) -> Drawing {
    let rows = &result.path;
    let s: Vec<f64> = rows.iter().map(|row| row.s_mm).collect();
    let bulk = bulk(result);
    let above = |flash: fn(&PositionRow) -> Option<f64>| -> Vec<f64> {
        let of = |row| flash(row).map_or(f64::NAN, |flash| bulk + flash);
        rows.iter().map(of).collect()
    };
    let is_one = rows.len() < 2;
    let line = |kind: Line| if is_one { Line::Scatter } else { kind };
    let mut chart = Chart::new(
        "temperatures",
        "Temperatures: the contact by its largest flash, flanks and oil",
        SOURCE,
        axis,
        Axis::new("temperature", "°C"),
    )
    .marked(marks);
    let mean = above(|row| Some(row.flash_k));
    let name = match result.summary.offsets {
        1 => "contact",
        _ => "contact, mean of the offsets",
    };
    chart = chart.with(Series::new(name, line(Line::Solid), &s, &mean));
    let largest = above(|row| row.flash_max_k);
    if result.summary.offsets > 1 && largest.iter().any(|value| value.is_finite()) {
        chart = chart.with(Series::new(
            "contact, hottest offset",
            line(Line::Dashed),
            &s,
            &largest,
        ));
    }
    let path = &result.gears.path;
    let ends = [path.a, path.e].map(|end| 1e3 * end.si());
    for (name, value) in constant(result) {
        chart = chart.with(Series::new(&name, Line::Dashed, &ends, &[value; 2]));
    }
    Drawing::Curves(chart)
}
