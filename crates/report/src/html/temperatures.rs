//! Temperatures along the path of contact: oil, flanks, and contact temperature with the flash.

use asperity::result::{PositionRow, RunResult};

use super::along::SOURCE;
use crate::chart::{Axis, Chart, Drawing, Line, Mark};

/// Bulk temperature of film and friction \[°C\].
pub(super) fn bulk(result: &RunResult) -> f64 {
    match &result.bulk {
        Some(bulk) => bulk.bulk_c,
        None => {
            let stated = result.inputs.operation.stated_temperature();
            stated.unwrap_or_default().celsius()
        }
    }
}

/// Names and values of the temperatures that are constant along the path.
fn constant(result: &RunResult) -> Vec<(String, f64)> {
    let Some(bulk) = &result.bulk else {
        let bulk_c = bulk(result);
        return vec![(format!("flanks, as given {bulk_c:.0} °C"), bulk_c)];
    };
    let oil = (format!("oil {:.0} °C", bulk.oil_c), bulk.oil_c);
    match bulk.gears_c {
        Some([pinion, wheel]) => vec![
            (format!("bulk of the pinion {pinion:.0} °C"), pinion),
            (format!("bulk of the wheel {wheel:.0} °C"), wheel),
            oil,
        ],
        None => vec![
            (
                format!("bulk of the flanks {:.0} °C", bulk.bulk_c),
                bulk.bulk_c,
            ),
            oil,
        ],
    }
}

/// The chart. Blok's flash temperature is the same for both flanks, so one contact temperature is drawn.
pub(super) fn along_the_path(result: &RunResult, axis: Axis, marks: &[Mark]) -> Drawing {
    let rows = &result.path;
    let s: Vec<f64> = rows.iter().map(|row| row.s_mm).collect();
    let bulk = bulk(result);
    let above = |flash: fn(&PositionRow) -> Option<f64>| -> Vec<f64> {
        let of = |row| flash(row).map_or(f64::NAN, |flash| bulk + flash);
        rows.iter().map(of).collect()
    };
    let mut chart = Chart::new(
        "temperatures",
        "Temperatures of contact, flanks and oil",
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
    chart = chart.curve(name, Line::Solid, &s, &mean);
    let largest = above(|row| Some(row.flash_max_k));
    if result.summary.offsets > 1 && largest.iter().any(|value| value.is_finite()) {
        chart = chart.curve("contact, hottest offset", Line::Dashed, &s, &largest);
    }
    let path = &result.gears.path;
    let ends = [path.a, path.e].map(|end| 1e3 * end.si());
    for (name, value) in constant(result) {
        chart = chart.curve(&name, Line::Dashed, &ends, &[value; 2]);
    }
    Drawing::Curves(chart)
}
