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

fn whole(row: &PositionRow) -> f64 {
    PARTS.iter().map(|(_, of)| of(row)).sum()
}

/// Stacked local losses of sliding and rolling; dots for a single position.
pub(super) fn along_the_path(result: &RunResult) -> Drawing {
    let rows = &result.path;
    let s: Vec<f64> = rows.iter().map(|row| row.s_mm).collect();
    let of = |value: &dyn Fn(&PositionRow) -> f64| -> Vec<f64> {
        rows.iter().map(|row| KILO * value(row)).collect()
    };
    let band = band(result);
    let title = match band {
        Some(_) => "Loss per length of contact line, with its band",
        None => "Loss per length of contact line",
    };
    let y = Axis::new("loss", "kW/m").from_zero();
    let mut chart = Chart::new("local-loss", title, SOURCE, along(), y).marked(&points(result));
    chart.height = HEIGHT;
    if rows.len() < 2 {
        for (name, part) in PARTS {
            chart = chart.with(Series::new(name, Line::Scatter, &s, &of(&part)));
        }
        return Drawing::Curves(chart.with(Series::new("all", Line::Scatter, &s, &of(&whole))));
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
    if let Some([low, high]) = band {
        chart = chart.with(Series::band("5 to 95 %", &s, &low, &high));
    }
    Drawing::Curves(chart.with(Series::new("all", Line::Ink, &s, &of(&whole))))
}

/// 5 % and 95 % quantiles of the total local loss along the path \[kW/m\]: sliding as drawn, rolling of the run.
fn band(result: &RunResult) -> Option<[Vec<f64>; 2]> {
    let quantiles = &result.uncertainty.as_ref()?.path_sliding_w_per_m;
    if quantiles.len() != result.path.len() {
        return None;
    }
    let end = |k: usize| {
        let pairs = result.path.iter().zip(quantiles);
        pairs
            .map(|(row, ends)| KILO * (ends[k] + row.rolling_w_per_m))
            .collect()
    };
    Some([end(0), end(1)])
}
