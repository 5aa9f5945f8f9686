//! Load over the flanks: along the path and over the face.

use asperity::result::LoadRow;
use asperity::result::RunResult;

use crate::chart::{Axis, Chart, Contour, Drawing, Line, Mark};
use crate::page_tables::PageTables;

/// Line load along the path, of the map and of its cells.
pub(super) fn along_the_path(result: &RunResult, axis: Axis, points: &[Mark]) -> Drawing {
    let rows = &result.load.path;
    let s: Vec<f64> = rows.iter().map(|row| row.s_mm).collect();
    let of = |value: fn(&LoadRow) -> f64| -> Vec<f64> { rows.iter().map(value).collect() };
    let (cells, loads): (Vec<f64>, Vec<f64>) = (result.path.iter())
        .map(|row| (row.s_mm, row.line_load_n_per_mm))
        .unzip();
    let mut chart = Chart::new(
        "load",
        "Load per length of contact line",
        "load.csv",
        axis,
        Axis::new("line load", "N/mm").from_zero(),
    )
    .marked(points)
    .curve(
        "mean over the face",
        Line::Solid,
        &s,
        &of(|row| row.mean_n_per_mm),
    );
    if rows
        .iter()
        .any(|row| row.highest_n_per_mm > 1.01 * row.lowest_n_per_mm)
    {
        chart = chart
            .curve("highest", Line::Dashed, &s, &of(|row| row.highest_n_per_mm))
            .curve("lowest", Line::Dashed, &s, &of(|row| row.lowest_n_per_mm));
    }
    Drawing::Curves(chart.curve("contacts evaluated", Line::Scatter, &cells, &loads))
}

/// Load over path and face; `None` without a load map.
pub(super) fn map(tables: &PageTables, axis: Axis) -> Option<Drawing> {
    let rows = &tables.load_map;
    let top = rows.first()?.y_mm;
    let stride = rows.iter().take_while(|row| row.y_mm == top).count();
    let columns: Vec<f64> = rows[..stride].iter().map(|row| row.s_mm).collect();
    let mut across: Vec<f64> = rows.chunks(stride).map(|strip| strip[0].y_mm).collect();
    let mut values: Vec<f64> = rows.iter().map(|row| row.load_n_per_mm).collect();
    // A load that is constant over the face is drawn over the full face.
    if across.len() == 1 {
        let middle = across[0];
        across = vec![0.0, 2.0 * middle];
        values = values.repeat(2);
    }
    Some(Drawing::Contour(Contour {
        id: "load-map".to_owned(),
        title: "Load over the flank, from A to E and across the face".to_owned(),
        source: tables.source("load_map.csv"),
        x: axis,
        y: Axis::new("across the face", "mm"),
        value: "line load [N/mm]".to_owned(),
        columns,
        rows: across,
        values,
        height: 250.0,
        ..Contour::default()
    }))
}
