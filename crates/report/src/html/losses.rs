//! Stacked losses along the path of contact, with the band of their sum.

use asperity::result::{PositionRow, RunResult};

use super::along::{SOURCE, along, points};
use crate::chart::{Axis, Chart, Drawing, Line, Series};

/// Height of the box: the chart is on the first screen.
const HEIGHT: f64 = 180.0;
/// Watts of a kilowatt.
const KILO: f64 = 1e-3;

/// Loss per metre of contact line of a row \[W/m\].
type Loss = fn(&PositionRow) -> f64;

/// Parts from the bottom up.
const PARTS: [(&str, Loss); 4] = [
    ("film", |row| row.film_w_per_m),
    ("boundary layer", |row| row.boundary_w_per_m),
    ("lubricated asperities", |row| {
        row.lubricated_asperity_w_per_m
    }),
    ("rolling", |row| row.rolling_w_per_m),
];

/// Stacked local losses of sliding and rolling; dots for a single position.
pub(super) fn along_the_path(result: &RunResult) -> Drawing {
    let rows = &result.path;
    let s: Vec<f64> = rows.iter().map(|row| row.s_mm).collect();
    let of = |value: &dyn Fn(&PositionRow) -> f64| -> Vec<f64> {
        rows.iter().map(|row| KILO * value(row)).collect()
    };
    let band = result.path_loss_quantiles();
    let title = match band {
        Some(_) => "Loss per length of contact line, with its interval",
        None => "Loss per length of contact line",
    };
    let y = Axis::new("loss", "kW/m").from_zero();
    let mut chart = Chart::new("local-loss", title, SOURCE, along(), y).marked(&points(result));
    chart.height = HEIGHT;
    if rows.len() < 2 {
        for (name, part) in PARTS {
            chart = chart.curve(name, Line::Scatter, &s, &of(&part));
        }
        return Drawing::Curves(chart.curve(
            "all",
            Line::Scatter,
            &s,
            &of(&PositionRow::loss_w_per_m),
        ));
    }
    let mut low = vec![0.0; rows.len()];
    for (name, part) in PARTS {
        let high: Vec<f64> = low
            .iter()
            .zip(of(&part))
            .map(|(low, own)| low + own)
            .collect();
        chart = chart.with(Series::area(name, &s, &low, &high));
        low = high;
    }
    if let Some(band) = band {
        let [low, high] = [0, 1].map(|end| {
            let ends = band.iter().map(|both| KILO * both[end]);
            ends.collect::<Vec<f64>>()
        });
        chart = chart.with(Series::band("5 to 95 %", &s, &low, &high));
    }
    Drawing::Curves(chart.curve("all", Line::Ink, &s, &of(&PositionRow::loss_w_per_m)))
}
