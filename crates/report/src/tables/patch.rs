//! Contact of a patch, cell by cell.

use std::collections::BTreeMap;
use std::path::Path;

use asperity::result::PositionFields;
use asperity_core::Fault;
use asperity_table::own::OwnFault;
use serde::{Deserialize, Serialize};

use super::csv_table::{check_field, read};
use crate::error;
use crate::units::{MEGA, MICRO};

/// Most columns and rows of cells on a page, so that it stays below 700 kB.
const SHOWN: [usize; 2] = [120, 100];

/// Contact of a patch, row by row along the lead.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
pub struct PatchTable {
    /// Places of the columns, from the middle of the contact \[µm\].
    pub x_um: Vec<f64>,
    /// Places of the rows along the lead \[µm\].
    pub lead_um: Vec<f64>,
    /// Pressure of asperities and film together \[MPa\].
    pub pressure_mpa: Vec<f64>,
    /// Number of the spot that a cell is part of, from 1; 0 where the flanks stay apart. Empty on a page.
    #[serde(default, skip_serializing_if = "Vec::is_empty")]
    pub spot: Vec<u32>,
    /// Loss of the spot that a cell is part of \[mW\]; 0 where the flanks stay apart.
    pub spot_loss_mw: Vec<f64>,
    /// Number of spots.
    pub spots: usize,
    /// Share of the loss of all spots that the costliest tenth makes.
    pub costliest_tenth: f64,
}

/// Row of `patch.csv`: a cell of a patch.
#[derive(Debug, Clone, Copy, PartialEq, Serialize, Deserialize)]
pub struct PatchRow {
    /// Distance from the middle of the contact along rolling \[µm\].
    pub x_um: f64,
    /// Place along the lead \[µm\].
    pub lead_um: f64,
    /// Pressure of asperities and film together \[MPa\].
    pub pressure_mpa: f64,
    /// Number of the spot that the cell is part of, from 1; 0 where the flanks stay apart.
    pub spot: u32,
    /// Loss of the spot that the cell is part of \[mW\]; 0 where the flanks stay apart.
    pub spot_loss_mw: f64,
}

/// `value` with four digits.
fn rounded(value: f64) -> f64 {
    format!("{value:.3e}").parse().unwrap_or(value)
}

/// A place \[µm\] to a nanometre.
fn place(um: f64) -> f64 {
    (1e3 * um).round() / 1e3
}

impl PatchTable {
    /// The table of a contact; `None` of a line.
    pub(super) fn from_fields(fields: &PositionFields) -> Option<Self> {
        const MILLI: f64 = 1e3;
        let patch = fields.patch.as_ref()?;
        let columns = patch.x.len();
        let cells = patch.pressure.iter().zip(&patch.spot).enumerate();
        let row = |(cell, (p, spot)): (usize, (&f64, &Option<u32>))| {
            let loss = spot.and_then(|spot| patch.spot_losses.get(spot as usize));
            PatchRow {
                x_um: place(MICRO * patch.x[cell % columns]),
                lead_um: place(MICRO * patch.y[cell / columns]),
                pressure_mpa: rounded(MEGA * (p + patch.pressure_fluid[cell % columns])),
                spot: spot.map_or(0, |spot| spot + 1),
                spot_loss_mw: rounded(MILLI * loss.copied().unwrap_or_default()),
            }
        };
        let rows: Vec<PatchRow> = cells.map(row).collect();
        Some(Self::of_rows(&rows))
    }

    /// The table of all cells, which form a rectangle.
    fn of_rows(rows: &[PatchRow]) -> Self {
        let first = rows.first().map_or(0.0, |row| row.lead_um);
        let columns = rows.iter().take_while(|row| row.lead_um == first).count();
        let spots = rows.iter().filter(|row| row.spot > 0);
        let spots: BTreeMap<u32, f64> = spots.map(|row| (row.spot, row.spot_loss_mw)).collect();
        let mut losses: Vec<f64> = spots.into_values().collect();
        losses.sort_by(|a, b| b.total_cmp(a));
        let all: f64 = losses.iter().sum();
        let tenth: f64 = losses[..losses.len().div_ceil(10)].iter().sum();
        Self {
            x_um: rows[..columns].iter().map(|row| row.x_um).collect(),
            lead_um: rows
                .iter()
                .step_by(columns.max(1))
                .map(|row| row.lead_um)
                .collect(),
            pressure_mpa: rows.iter().map(|row| row.pressure_mpa).collect(),
            spot: rows.iter().map(|row| row.spot).collect(),
            spot_loss_mw: rows.iter().map(|row| row.spot_loss_mw).collect(),
            spots: losses.len(),
            costliest_tenth: if all > 0.0 { tenth / all } else { 0.0 },
        }
    }

    /// Reads the table in `file`.
    ///
    /// # Errors
    /// When it is damaged.
    pub(super) fn read(file: &Path) -> Result<Self, Fault> {
        let rows: Vec<PatchRow> = read(file)?;
        check_field(&rows, |row| [row.x_um, row.lead_um])
            .map_err(|reason| error::bad_table(file, reason))?;
        Ok(Self::of_rows(&rows))
    }

    /// Whether it is a rectangle of cells; in a damaged file it may not be.
    pub(super) fn check(&self) -> Result<(), OwnFault> {
        let cells = self.x_um.len() * self.lead_um.len();
        if [&self.pressure_mpa, &self.spot_loss_mw].map(Vec::len) == [cells; 2] {
            Ok(())
        } else {
            Err(OwnFault::NotAField)
        }
    }

    /// All cells; none on a page.
    pub fn rows(&self) -> impl Iterator<Item = PatchRow> {
        let places = self.lead_um.iter();
        let places = places.flat_map(|lead| self.x_um.iter().map(|x| [*x, *lead]));
        let spots = self.spot.iter().zip(&self.spot_loss_mw);
        let values = self.pressure_mpa.iter().zip(spots);
        places
            .zip(values)
            .map(|([x_um, lead_um], (p, (spot, loss)))| PatchRow {
                x_um,
                lead_um,
                pressure_mpa: *p,
                spot: *spot,
                spot_loss_mw: *loss,
            })
    }

    /// The cells up to `near` \[µm\] from the middle of the contact, in blocks with the largest values of their cells. The last block
    /// of a row or column can have fewer cells; it is drawn as large as the others.
    pub(super) fn thinned(&self, near: f64) -> Self {
        let columns: Vec<usize> = (0..self.x_um.len())
            .filter(|i| self.x_um[*i].abs() <= near)
            .collect();
        let rows: Vec<usize> = (0..self.lead_um.len()).collect();
        let blocks = |of: &[usize], most: usize| -> Vec<Vec<usize>> {
            let size = of.len().div_ceil(most).max(1);
            of.chunks(size).map(<[usize]>::to_vec).collect()
        };
        let (across, along) = (blocks(&columns, SHOWN[0]), blocks(&rows, SHOWN[1]));
        let middle = |places: &[f64], block: &Vec<usize>| {
            place(0.5 * (places[block[0]] + places[block[block.len() - 1]]))
        };
        let highest = |values: &[f64]| -> Vec<f64> {
            let of_block = |rows: &Vec<usize>, columns: &Vec<usize>| {
                let cells = rows
                    .iter()
                    .flat_map(|j| columns.iter().map(move |i| (*j, *i)));
                let cells = cells.map(|(j, i)| values[j * self.x_um.len() + i]);
                cells.fold(0.0, f64::max)
            };
            let lines = along.iter();
            lines
                .flat_map(|rows| across.iter().map(move |columns| of_block(rows, columns)))
                .collect()
        };
        Self {
            x_um: across
                .iter()
                .map(|block| middle(&self.x_um, block))
                .collect(),
            lead_um: along
                .iter()
                .map(|block| middle(&self.lead_um, block))
                .collect(),
            pressure_mpa: highest(&self.pressure_mpa),
            spot: Vec::new(),
            spot_loss_mw: highest(&self.spot_loss_mw),
            ..*self
        }
    }
}

#[cfg(test)]
mod tests {
    use super::place;

    #[test]
    fn places_far_from_the_middle_keep_their_distance() {
        assert_eq!([123.456_4, 123.206_4].map(place), [123.456, 123.206]);
    }
}
