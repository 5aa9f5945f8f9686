//! Tables of the load over the flanks.

use asperity::gear::{LoadMap, LoadSample};
use serde::{Deserialize, Serialize};

/// Number of strips along the path in the table of the chart.
const STRIPS_ALONG: usize = 48;
/// Number of strips across the face for a load that varies over the face.
const STRIPS_ACROSS: usize = 32;

/// Row of `load_map.csv`: mean load in a cell of the flank, path by face.
#[derive(Debug, Clone, Copy, PartialEq, Serialize, Deserialize)]
pub struct LoadMapRow {
    /// Distance along the line of action from T1 \[mm\].
    pub s_mm: f64,
    /// Position across the face \[mm\].
    pub y_mm: f64,
    /// Mean load per length of contact line \[N/mm\].
    pub load_n_per_mm: f64,
}

/// Row of `map.csv`: a point of a line of contact with its load.
#[derive(Debug, Clone, Copy, PartialEq, Serialize)]
pub struct LoadPointRow {
    /// Mesh phase of its contact.
    pub phase: f64,
    /// Profile coordinate in base pitches from A.
    pub xi: f64,
    /// Distance along the line of action from T1 \[mm\].
    pub s_mm: f64,
    /// Position across the face \[mm\].
    pub y_mm: f64,
    /// Load per length of contact line \[N/mm\].
    pub load_n_per_mm: f64,
    /// Length of contact line that the point represents in a mean over the mesh cycle \[mm\].
    pub weight_mm: f64,
}

/// Rows of `map.csv`: all points of the load map.
pub fn load_points(map: &LoadMap) -> impl Iterator<Item = LoadPointRow> + '_ {
    let path = map.gears().path();
    map.samples().iter().map(|sample| LoadPointRow {
        phase: sample.phase,
        xi: sample.xi,
        s_mm: path.place(sample.xi).si() * 1e3,
        y_mm: sample.y.si() * 1e3,
        load_n_per_mm: sample.load.si() * 1e-3,
        weight_mm: sample.weight.si() * 1e3,
    })
}

/// Rows of `load_map.csv`: along the path, by strips of the face. A cell without a point has the load of its neighbour
/// along the path.
pub fn load_map(map: &LoadMap) -> Vec<LoadMapRow> {
    let width = map.gears().face_width.si();
    let first = map.samples().first().map_or(0.0, |sample| sample.y.si());
    let is_flat = map.samples().iter().all(|sample| sample.y.si() == first);
    let across = if is_flat { 1 } else { STRIPS_ACROSS };
    let path = map.gears().path();
    let strip =
        |place: f64, count: usize| ((place * count as f64).max(0.0) as usize).min(count - 1);
    let mut sums = vec![[0.0; 2]; across * STRIPS_ALONG];
    let mut add = |sample: &LoadSample| {
        let row = strip(sample.y.si() / width, across);
        let column = strip(sample.xi / path.eps_alpha, STRIPS_ALONG);
        let cell = &mut sums[row * STRIPS_ALONG + column];
        cell[0] += sample.weight.si() * sample.load.si();
        cell[1] += sample.weight.si();
    };
    map.samples().iter().for_each(&mut add);
    let mut rows = Vec::with_capacity(sums.len());
    for (index, cells) in sums.chunks(STRIPS_ALONG).enumerate() {
        let mut before = cells
            .iter()
            .find(|cell| cell[1] > 0.0)
            .map_or(0.0, |cell| cell[0] / cell[1]);
        for (column, [force, length]) in cells.iter().enumerate() {
            if *length > 0.0 {
                before = force / length;
            }
            let along = (column as f64 + 0.5) / STRIPS_ALONG as f64;
            let s = path.a + (path.e - path.a) * along;
            rows.push(LoadMapRow {
                s_mm: s.si() * 1e3,
                y_mm: width * (index as f64 + 0.5) / across as f64 * 1e3,
                load_n_per_mm: before * 1e-3,
            });
        }
    }
    rows
}
