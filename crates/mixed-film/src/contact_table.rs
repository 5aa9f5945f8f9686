//! The rough contact at twelve asperity shares: what oil, speed and temperature do not change.

use std::cmp::Ordering;

use asperity_core::cite;
use asperity_core::noted::Noted;
use asperity_core::numerics::{Solved, secant_root};
use asperity_core::quantity::{Length, LineEnergy, Pressure};
use asperity_ehl_regime::inlet_flow::LARGEST_SHARE;

use crate::error::LoadShareError;
use crate::rough_contact::{ContactState, RoughContact, SparsePressure};
use crate::spot_tree::Spot;

/// Asperity shares of the table, the largest last.
pub const TABLE_SHARES: [f64; 12] = [
    0.001,
    0.004,
    0.012,
    0.03,
    0.06,
    0.11,
    0.18,
    0.28,
    0.40,
    0.56,
    0.76,
    LARGEST_SHARE,
];

/// Number of the last row.
const LAST: usize = TABLE_SHARES.len() - 1;
/// Row that is solved first, without a start: most windows need it or one next to it.
const FIRST_SOLVED: usize = 7;

/// Power of the share in which the gap is interpolated: the first touch has an infinite slope over the
/// share itself.
const ABSCISSA_POWER: f64 = 0.25;

/// One row of the table.
#[derive(Debug, Clone, PartialEq)]
pub struct TableRow {
    /// Asperity share φ.
    pub asperity_share: f64,
    /// Mean gap.
    pub mean_gap: Length,
    /// Touching spots.
    pub spots: Vec<Spot>,
    /// Share of the Hertz contact that touches.
    pub area: f64,
    /// Largest pressure.
    pub max_pressure: Pressure,
    /// Energy dissipated in one pass.
    pub dissipated: LineEnergy,
    /// Relative load error of the contact solution.
    pub load_error: f64,
    /// Its certified duality gap.
    pub duality_gap: f64,
    /// Pressure of the asperities, from which the next row starts.
    pressure: SparsePressure,
}

impl From<ContactState> for TableRow {
    fn from(state: ContactState) -> Self {
        Self {
            asperity_share: state.asperity_share,
            mean_gap: state.mean_gap,
            area: state.area,
            max_pressure: state.max_pressure,
            dissipated: state.dissipated,
            load_error: state.solution.certificate.load_error,
            duality_gap: state.solution.certificate.duality_gap,
            pressure: SparsePressure::from_pressure(&state.solution.pressure),
            spots: state.spots,
        }
    }
}

/// The rough contact of one window at the shares of the table, each solved when a film first needs it.
///
/// Each starts from the one at the next share towards the row that is solved first, so that a row is the same whichever others
/// are solved.
#[derive(Debug, Clone, PartialEq)]
pub struct ContactTable {
    first_touch: f64,
    rows: [Noted<Box<TableRow>>; TABLE_SHARES.len()],
}

/// A row of the table that is needed and not solved.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
struct Unsolved(usize);

impl From<Unsolved> for LoadShareError {
    fn from(Unsolved(row): Unsolved) -> Self {
        Self::row_not_solved(TABLE_SHARES[row])
    }
}

/// Where the gap of the contact is the one supplied.
enum Crossing<'a> {
    /// The flanks stay apart.
    Apart,
    /// Between two neighbouring knots of the table.
    Between(TablePiece<'a>),
    /// Nowhere: at the largest share the gap is larger than that supplied, by this part.
    Beyond(TablePiece<'a>, f64),
}

/// The table where the gap of the contact is the one supplied: two neighbouring rows with their weights.
#[derive(Debug, Clone)]
pub(crate) struct AtShare<'a> {
    pub(crate) share: Solved,
    /// The rows; below the first row only that row.
    pub(crate) rows: [(&'a TableRow, f64); 2],
    /// Slope of the second weight over the share.
    pub(crate) slope: f64,
    piece: TablePiece<'a>,
}

impl AtShare<'_> {
    /// Mean gap g(φ).
    pub(crate) fn mean_gap(&self) -> Length {
        Length::from_si(self.piece.gap(abscissa(self.share.value)))
    }

    /// The larger number of the two rows.
    pub(crate) fn worst(&self, of: impl Fn(&TableRow) -> f64) -> f64 {
        self.weighted().map(|(row, _)| of(row)).fold(0.0, f64::max)
    }

    /// A number between the two rows.
    pub(crate) fn mean(&self, of: impl Fn(&TableRow) -> f64) -> f64 {
        self.weighted().map(|(row, weight)| weight * of(row)).sum()
    }

    /// The rows with a weight.
    pub(crate) fn weighted(&self) -> impl Iterator<Item = (&TableRow, f64)> {
        let rows = self.rows.iter().copied();
        rows.filter(|(_, weight)| *weight > 0.0)
    }

    /// Whether a slope of the gap next to the share is limited, so that the gap has no extreme between its knots.
    pub(crate) fn limits_a_slope(&self) -> bool {
        let low = self.piece.low;
        [low, low + 1].map(|k| monotone_slope(&self.piece.knots, k).1) != [false; 2]
    }

    /// Slope g′(φ), and the derivatives of g(φ) over the gap of first touch and over those of the rows that it depends on.
    pub(crate) fn gap_slopes(&self) -> (f64, f64, Vec<(&TableRow, f64)>) {
        /// Step of the difference quotients over the largest gap: the interpolation is linear in the gaps of its knots where no
        /// slope is held.
        const STEP: f64 = 1e-6;
        let s = abscissa(self.share.value);
        let piece = &self.piece;
        let step = STEP * piece.knots[0][1].abs();
        let by_knot = |knot: usize| {
            if step == 0.0 {
                return 0.0;
            }
            let at = |step: f64| {
                let mut moved = piece.clone();
                moved.knots[knot][1] += step;
                set_monotone_slopes(&mut moved.knots);
                moved.gap(s)
            };
            (at(step) - at(-step)) / (2.0 * step)
        };
        let [a, b] = piece.ends();
        let slope = hermite_slope(a, b, s) * abscissa_slope(self.share.value);
        let first = piece.without_row();
        let by_first_touch = (0..first).map(by_knot).sum();
        let rows = piece.rows.iter().zip(first..);
        let by_rows = rows.map(|(row, knot)| (*row, by_knot(knot))).collect();
        (slope, by_first_touch, by_rows)
    }
}

impl ContactTable {
    /// The table of a contact, with no row solved.
    #[must_use]
    pub fn new(contact: &RoughContact) -> Self {
        Self {
            first_touch: contact.first_touch_gap().si(),
            rows: Default::default(),
        }
    }

    /// Solves the contact at all shares of the table.
    ///
    /// # Errors
    /// When a contact does not converge.
    pub fn build(contact: &mut RoughContact) -> Result<Self, LoadShareError> {
        let table = Self::new(contact);
        for row in [0, LAST] {
            table.solve(row, contact)?;
        }
        Ok(table)
    }

    /// Mean gap at which the flanks first touch.
    #[must_use]
    pub fn first_touch_gap(&self) -> Length {
        Length::from_si(self.first_touch)
    }

    /// The rows that are solved, by rising share.
    pub fn rows(&self) -> impl DoubleEndedIterator<Item = &TableRow> {
        self.rows.iter().filter_map(|row| Some(&**row.get()?))
    }

    /// Mean gap g(φ), by monotone cubic interpolation in φ^¼.
    ///
    /// # Errors
    /// When a row next to the share is not solved.
    pub fn mean_gap(&self, asperity_share: f64) -> Result<Length, LoadShareError> {
        let above = TABLE_SHARES.partition_point(|share| *share <= asperity_share);
        let piece = self.piece(above.min(LAST))?;
        Ok(Length::from_si(piece.gap(abscissa(asperity_share))))
    }

    /// Mean gap at the share 0.28, which is solved first in every window.
    ///
    /// # Errors
    /// When `contact` fails, or the contact does not converge.
    pub fn middle_gap<E: From<LoadShareError>>(
        &self,
        contact: impl FnOnce() -> Result<RoughContact, E>,
    ) -> Result<Length, E> {
        if let Ok(known) = self.row(FIRST_SOLVED) {
            return Ok(known.mean_gap);
        }
        Ok(self.solve(FIRST_SOLVED, &mut contact()?)?.mean_gap)
    }

    /// Asperity share under which the mean gap is `gap`; the rows that it needs are solved, and `contact` gives the window if
    /// one is missing.
    ///
    /// # Errors
    /// When `contact` fails, or a contact does not converge.
    pub fn share_at_gap<E: From<LoadShareError>>(
        &self,
        gap: Length,
        contact: impl FnOnce() -> Result<RoughContact, E>,
    ) -> Result<f64, E> {
        let supply = |_| gap.si();
        self.solve_for(&supply, contact)?;
        Ok(self.at_supply(&supply)?.map_or(0.0, |at| at.share.value))
    }

    /// Solves the rows that are needed where the gap of the contact is the one supplied.
    pub(crate) fn solve_for<E: From<LoadShareError>>(
        &self,
        supply: &impl Fn(f64) -> f64,
        contact: impl FnOnce() -> Result<RoughContact, E>,
    ) -> Result<(), E> {
        let missing = || self.crossing(supply).err();
        let Some(Unsolved(row)) = missing() else {
            return Ok(());
        };
        let mut contact = contact()?;
        self.solve(row, &mut contact)?;
        while let Some(Unsolved(row)) = missing() {
            self.solve(row, &mut contact)?;
        }
        Ok(())
    }

    /// Solves a row, after those between it and the one solved first.
    fn solve(&self, row: usize, contact: &mut RoughContact) -> Result<&TableRow, LoadShareError> {
        let solved = self.rows[row].get_or_make(|| self.solved(row, contact))?;
        Ok(solved)
    }

    fn solved(
        &self,
        row: usize,
        contact: &mut RoughContact,
    ) -> Result<Box<TableRow>, LoadShareError> {
        let before = match row.cmp(&FIRST_SOLVED) {
            Ordering::Less => Some(row + 1),
            Ordering::Equal => None,
            Ordering::Greater => Some(row - 1),
        };
        match before {
            None => contact.start_anew(),
            Some(before) => self.solve(before, contact)?.start(contact),
        }
        Ok(Box::new(contact.at(TABLE_SHARES[row])?.into()))
    }

    fn row(&self, row: usize) -> Result<&TableRow, Unsolved> {
        self.rows[row].get().map(|row| &**row).ok_or(Unsolved(row))
    }

    /// The gap between the knot below row `above`, the first touch or a row, and that row.
    fn piece(&self, above: usize) -> Result<TablePiece<'_>, Unsolved> {
        // Slopes follow from the nearest neighbours, at the ends of the table from the nearest three knots.
        let mut knots = Vec::with_capacity(4);
        if above < 2 {
            knots.push([0.0, self.first_touch, 0.0]);
        }
        let near = above.saturating_sub(2)..=(above + 1).min(LAST);
        let rows: Vec<&TableRow> = near.map(|row| self.row(row)).collect::<Result<_, _>>()?;
        let knot = |row: &&TableRow| [abscissa(row.asperity_share), row.mean_gap.si(), 0.0];
        knots.extend(rows.iter().map(knot));
        set_monotone_slopes(&mut knots);
        Ok(TablePiece {
            knots,
            rows,
            low: above.min(1),
        })
    }

    /// The knots between which the excess of the supply over the gap changes its sign, next to the row solved first.
    fn crossing(&self, supply: &impl Fn(f64) -> f64) -> Result<Crossing<'_>, Unsolved> {
        if self.first_touch <= supply(0.0) {
            return Ok(Crossing::Apart);
        }
        // Whether the gap at a row is larger than that supplied: the share is larger.
        let is_short = |row: usize| Ok(supply(TABLE_SHARES[row]) < self.row(row)?.mean_gap.si());
        let mut above = FIRST_SOLVED;
        if is_short(above)? {
            while is_short(above)? {
                if above == LAST {
                    let excess = self.row(LAST)?.mean_gap.si() / supply(LARGEST_SHARE) - 1.0;
                    return Ok(Crossing::Beyond(self.piece(LAST)?, excess));
                }
                above += 1;
            }
        } else {
            while above > 0 && !is_short(above - 1)? {
                above -= 1;
            }
        }
        Ok(Crossing::Between(self.piece(above)?))
    }

    /// The table where the gap of the contact is the one supplied; `None` if the flanks stay apart.
    ///
    /// ```text
    /// g(φ) = h̄(φ);  φ = 0 if g(0) ≤ h̄(0), 0.99 if g(0.99) > h̄(0.99)            [Load-share]
    /// ```
    pub(crate) fn at_supply(
        &self,
        supply: &impl Fn(f64) -> f64,
    ) -> Result<Option<AtShare<'_>>, LoadShareError> {
        cite!("Load-share");
        match self.crossing(supply)? {
            Crossing::Apart => Ok(None),
            Crossing::Between(piece) => {
                let share = piece.share(supply)?;
                Ok(Some(piece.at(share)))
            }
            Crossing::Beyond(piece, residual) => Ok(Some(piece.at(Solved {
                value: LARGEST_SHARE,
                residual,
                iterations: 0,
            }))),
        }
    }
}

impl TableRow {
    /// Lets the next solution of `contact` start from this row.
    fn start(&self, contact: &mut RoughContact) {
        contact.start_from(self.asperity_share, &self.pressure);
    }

    /// The contact of this row, whose pressures are known.
    ///
    /// # Errors
    /// When it is not that of `contact`.
    pub(crate) fn of(&self, contact: &mut RoughContact) -> Result<ContactState, LoadShareError> {
        contact.known(self.asperity_share, &self.pressure)
    }
}

/// The gap between two neighbouring knots, with the knots that decide its slopes.
#[derive(Debug, Clone)]
struct TablePiece<'a> {
    /// φ^¼, mean gap there, slope of the gap over φ^¼.
    knots: Vec<[f64; 3]>,
    /// Rows of the knots; the first touch, if it is the first knot, has none.
    rows: Vec<&'a TableRow>,
    /// Number of the lower knot.
    low: usize,
}

impl<'a> TablePiece<'a> {
    fn ends(&self) -> [&[f64; 3]; 2] {
        [&self.knots[self.low], &self.knots[self.low + 1]]
    }

    fn gap(&self, s: f64) -> f64 {
        let [a, b] = self.ends();
        hermite(a, b, s)
    }

    /// Number of knots before the first row.
    fn without_row(&self) -> usize {
        self.knots.len() - self.rows.len()
    }

    /// The share at which the gap is the one supplied.
    fn share(&self, supply: &impl Fn(f64) -> f64) -> Result<Solved, LoadShareError> {
        let scale = supply(0.0);
        // In φ^¼ the excess of the supply over the gap rises nearly as a line.
        let excess = |s: f64| (supply(s.powf(1.0 / ABSCISSA_POWER)) - self.gap(s)) / scale;
        let [a, b] = self.ends().map(|knot| knot[0]);
        let slope = (excess(b) - excess(a)) / (b - a);
        let start = a - excess(a) / slope;
        let root = secant_root(excess, [a, b], start, slope, 1e-12);
        let root = root.map_err(|source| LoadShareError::no_root("asperity share", source))?;
        Ok(Solved {
            value: root.value.powf(1.0 / ABSCISSA_POWER),
            ..root
        })
    }

    fn at(self, share: Solved) -> AtShare<'a> {
        let [a, b] = self.ends().map(|knot| knot[0]);
        let above = self.low + 1 - self.without_row();
        let high = self.rows[above];
        let (rows, slope) = match above.checked_sub(1) {
            None => ([(high, 1.0), (high, 0.0)], 0.0),
            Some(below) => {
                let weight = (abscissa(share.value) - a) / (b - a);
                let slope = abscissa_slope(share.value) / (b - a);
                ([(self.rows[below], 1.0 - weight), (high, weight)], slope)
            }
        };
        AtShare {
            share,
            rows,
            slope,
            piece: self,
        }
    }
}

fn abscissa(share: f64) -> f64 {
    share.sqrt().sqrt()
}

/// d(φ^¼)/dφ
fn abscissa_slope(share: f64) -> f64 {
    ABSCISSA_POWER * share.powf(ABSCISSA_POWER - 1.0)
}

/// Slope at a knot of the parabola through three neighbours, held to three times the flatter chord: no new extreme between
/// the knots (Fritsch and Carlson). Also returns whether it is limited.
fn monotone_slope(knots: &[[f64; 3]], k: usize) -> (f64, bool) {
    const STEEPEST: f64 = 3.0;
    let chord = |a: &[f64; 3], b: &[f64; 3]| (b[1] - a[1]) / (b[0] - a[0]);
    let last = knots.len() - 1;
    // At an end the parabola of the nearest three knots, seen from there.
    let middle = k.clamp(1, last - 1);
    let (left, right) = (
        chord(&knots[middle - 1], &knots[middle]),
        chord(&knots[middle], &knots[middle + 1]),
    );
    let bend = (right - left) / (knots[middle + 1][0] - knots[middle - 1][0]);
    let slope = left + bend * (2.0 * knots[k][0] - knots[middle - 1][0] - knots[middle][0]);
    let flatter = if k == 0 {
        left
    } else if k == last {
        right
    } else if left * right > 0.0 {
        left.abs().min(right.abs()).copysign(left)
    } else {
        0.0
    };
    let steepest = STEEPEST * flatter.abs();
    if slope * flatter > 0.0 {
        (
            slope.abs().min(steepest).copysign(flatter),
            slope.abs() > steepest,
        )
    } else {
        (0.0, slope != 0.0)
    }
}

fn set_monotone_slopes(knots: &mut [[f64; 3]]) {
    for k in 0..knots.len() {
        knots[k][2] = monotone_slope(knots, k).0;
    }
}

fn hermite(a: &[f64; 3], b: &[f64; 3], x: f64) -> f64 {
    let width = b[0] - a[0];
    let t = (x - a[0]) / width;
    let (d0, d1, rise) = (a[2] * width, b[2] * width, b[1] - a[1]);
    let (c2, c3) = (3.0 * rise - 2.0 * d0 - d1, d0 + d1 - 2.0 * rise);
    a[1] + t * (d0 + t * (c2 + t * c3))
}

fn hermite_slope(a: &[f64; 3], b: &[f64; 3], x: f64) -> f64 {
    let width = b[0] - a[0];
    let t = (x - a[0]) / width;
    let (d0, d1, rise) = (a[2] * width, b[2] * width, b[1] - a[1]);
    let (c2, c3) = (3.0 * rise - 2.0 * d0 - d1, d0 + d1 - 2.0 * rise);
    (d0 + t * (2.0 * c2 + t * 3.0 * c3)) / width
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_parabola_is_met_between_its_knots() {
        let parabola = |x: f64| 0.3 + 2.0 * x + 1.5 * x * x;
        let mut knots = [0.1, 0.25, 0.5, 0.6, 1.0].map(|x| [x, parabola(x), 0.0]);
        set_monotone_slopes(&mut knots);
        assert!((0..knots.len()).all(|k| !monotone_slope(&knots, k).1));
        for pair in knots.windows(2) {
            for part in [0.0, 0.2, 0.5, 0.9, 1.0] {
                let x = pair[0][0] + part * (pair[1][0] - pair[0][0]);
                let found = hermite(&pair[0], &pair[1], x);
                assert!((found - parabola(x)).abs() < 1e-12, "{x}: {found}");
            }
        }
    }

    #[test]
    fn no_extreme_appears_between_knots() {
        let mut knots =
            [[0.0, 0.0], [0.2, 0.0], [0.3, 1.0], [0.9, 1.1], [1.0, 0.5]].map(|[x, y]| [x, y, 0.0]);
        set_monotone_slopes(&mut knots);
        // A level part, a bend, an extreme.
        let held = [0, 1, 2, 3, 4].map(|k| monotone_slope(&knots, k).1);
        assert_eq!(held, [true, true, true, true, false]);
        for pair in knots.windows(2) {
            let (low, high) = (pair[0][1].min(pair[1][1]), pair[0][1].max(pair[1][1]));
            for part in 1..20 {
                let x = pair[0][0] + f64::from(part) / 20.0 * (pair[1][0] - pair[0][0]);
                let found = hermite(&pair[0], &pair[1], x);
                assert!(
                    (low - 1e-12..=high + 1e-12).contains(&found),
                    "{x}: {found}"
                );
            }
        }
    }
}
