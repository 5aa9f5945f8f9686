//! The headline of a result: loss, efficiency, parts, lubrication and the largest contributions to the interval.

use asperity::result::{RunResult, Summary};
use serde::Serialize;

use crate::printed::{PrintedLoss, gearbox_with_interval, of_mesh, stated, watts};
use crate::summary::regime;

/// Largest contributions to the interval that the headline names.
const LARGEST_PARTS: usize = 3;

/// A part of the headline: a value, or rows of names and values.
#[derive(Debug, Clone, PartialEq, Eq, Default, Serialize)]
pub struct Tile {
    /// Its name.
    pub name: String,
    /// Its value with unit; empty if it has rows.
    pub value: String,
    /// Names and values.
    pub rows: Vec<[String; 2]>,
    /// Explanation of the value; may be empty.
    pub note: String,
    /// Its subject.
    #[serde(skip)]
    pub kind: TileKind,
}

/// Subject of a part of the headline.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
pub enum TileKind {
    /// Loss of the mesh, or of all meshes.
    Loss,
    /// Largest contributions to the interval of the loss.
    Sources,
    /// All others.
    #[default]
    Other,
}

impl Tile {
    /// A name with its value.
    pub(crate) fn new([name, value]: [String; 2]) -> Self {
        Self {
            name,
            value,
            ..Self::default()
        }
    }

    /// Names with values under a name.
    pub(crate) fn rows(name: &str, rows: Vec<[String; 2]>) -> Self {
        Self {
            name: name.to_owned(),
            rows,
            ..Self::default()
        }
    }
}

/// The headline of `result`, the loss first.
#[must_use]
pub fn tiles(result: &RunResult) -> Vec<Tile> {
    let s = &result.summary;
    let printed = PrintedLoss::new(s, result.uncertainty.as_ref());
    let [loss, efficiency] = of_mesh(result);
    let interval = match &result.uncertainty {
        Some(_) => "median, in brackets 5 to 95 %",
        None => "",
    };
    let tile = |name: &str, value, note: String| Tile {
        note,
        ..Tile::new([name.to_owned(), value])
    };
    let mut tiles = vec![
        Tile {
            kind: TileKind::Loss,
            ..tile("loss of the mesh", loss, interval.to_owned())
        },
        tile(
            "efficiency of the mesh",
            efficiency,
            format!("of {} into the mesh", watts(s.power_in_w)),
        ),
    ];
    if let Some(gearbox) = &result.gearbox {
        let efficiency = match &result.uncertainty {
            Some(uncertainty) => gearbox_with_interval(gearbox, uncertainty)[1].clone(),
            None => format!("{:.4} %", 100.0 * gearbox.efficiency),
        };
        let note = format!("with {} of other losses", stated(gearbox.parts_w));
        tiles.push(tile("efficiency of the gearbox", efficiency, note));
    }
    tiles.push(parts(printed));
    tiles.push(lubrication(s));
    tiles.extend(contributions(result));
    tiles
}

/// The parts of the loss, as printed they add up to it.
fn parts(printed: PrintedLoss) -> Tile {
    let rows = printed.parts.into_iter();
    let rows = rows.map(|part| [part.name.to_owned(), part.text]);
    Tile::rows("parts of the loss", rows.collect())
}

/// The regime, with the share of the load on the boundary layer.
fn lubrication(s: &Summary) -> Tile {
    Tile {
        note: format!(
            "{:.0} % of the load on the boundary layer",
            100.0 * s.boundary_share
        ),
        ..Tile::new(["lubrication".to_owned(), regime(s)])
    }
}

/// The largest contributions to the interval of the loss.
fn contributions(result: &RunResult) -> Option<Tile> {
    let uncertainty = result.uncertainty.as_ref()?;
    let digits = uncertainty.digits();
    let parts = uncertainty.loss.parts.iter().take(LARGEST_PARTS);
    let rows = parts
        .filter(|part| digits.steps(part.half_range_w()) > 0.0)
        .map(|part| {
            let ends = part.quantiles_w.map(|loss| digits.rounded(loss));
            [part.name.clone(), format!("{} W", ends.join(".."))]
        });
    Some(Tile {
        note: "5 to 95 % of the loss, each sampled alone".to_owned(),
        kind: TileKind::Sources,
        ..Tile::rows("sources of the interval", rows.collect())
    })
}
