//! The rough contact at twelve asperity shares: what oil, speed and temperature do not change.

use asperity_core::cite;
use asperity_core::numerics::secant_root;
use asperity_core::quantity::{Length, LineEnergy, Pressure};
use asperity_ehl_regime::inlet_flow::LARGEST_SHARE;

use crate::error::LoadShareError;
use crate::rough_contact::{ContactState, RoughContact};
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
}

impl From<ContactState> for TableRow {
    fn from(state: ContactState) -> Self {
        Self {
            asperity_share: state.asperity_share,
            mean_gap: state.mean_gap,
            spots: state.spots,
            area: state.area,
            max_pressure: state.max_pressure,
            dissipated: state.dissipated,
            load_error: state.solution.certificate.load_error,
            duality_gap: state.solution.certificate.duality_gap,
        }
    }
}

/// The rough contact of one window at every share.
#[derive(Debug, Clone, PartialEq)]
pub struct ContactTable {
    first_touch: f64,
    rows: Vec<TableRow>,
    /// φ^¼ of first touch and rows, mean gap there, slope of the gap over φ^¼.
    knots: Vec<[f64; 3]>,
}

/// Two neighbouring rows with their weights.
#[derive(Debug, Clone, Copy)]
pub(crate) struct Between<'a> {
    pub(crate) rows: [(&'a TableRow, f64); 2],
    /// Slope of the second weight over the share.
    pub(crate) slope: f64,
}

impl Between<'_> {
    /// The larger number of the two rows.
    pub(crate) fn worst(&self, of: impl Fn(&TableRow) -> f64) -> f64 {
        self.rows.iter().map(|(row, _)| of(row)).fold(0.0, f64::max)
    }

    /// A number between the two rows.
    pub(crate) fn mean(&self, of: impl Fn(&TableRow) -> f64) -> f64 {
        self.rows.iter().map(|(row, weight)| weight * of(row)).sum()
    }
}

impl ContactTable {
    /// Solves the contact at all shares of the table, from the largest to the smallest, each from the last.
    ///
    /// # Errors
    /// When a contact does not converge.
    pub fn build(contact: &mut RoughContact) -> Result<Self, LoadShareError> {
        let mut rows = Vec::with_capacity(TABLE_SHARES.len());
        for share in TABLE_SHARES.into_iter().rev() {
            rows.push(TableRow::from(contact.at(share)?));
        }
        rows.reverse();
        Ok(Self::of_rows(contact.first_touch_gap(), rows))
    }

    fn of_rows(first_touch: Length, rows: Vec<TableRow>) -> Self {
        let mut knots = vec![[0.0, first_touch.si(), 0.0]];
        knots.extend(
            rows.iter()
                .map(|row| [abscissa(row.asperity_share), row.mean_gap.si(), 0.0]),
        );
        set_monotone_slopes(&mut knots);
        Self {
            first_touch: first_touch.si(),
            rows,
            knots,
        }
    }

    /// Mean gap at which the flanks first touch.
    #[must_use]
    pub fn first_touch_gap(&self) -> Length {
        Length::from_si(self.first_touch)
    }

    /// The rows, by rising share.
    #[must_use]
    pub fn rows(&self) -> &[TableRow] {
        &self.rows
    }

    /// Mean gap g(φ), by monotone cubic interpolation in φ^¼.
    #[must_use]
    pub fn mean_gap(&self, asperity_share: f64) -> Length {
        let s = abscissa(asperity_share);
        let k = self.knot_below(s);
        Length::from_si(hermite(&self.knots[k], &self.knots[k + 1], s))
    }

    /// Number of the knot below φ^¼ = `s`; at the last knot, of the one before it.
    fn knot_below(&self, s: f64) -> usize {
        self.knots[1..self.knots.len() - 1].partition_point(|knot| knot[0] <= s)
    }

    /// Whether a slope of the gap next to a share is limited, so that the gap has no extreme between its knots.
    pub(crate) fn limits_a_slope(&self, asperity_share: f64) -> bool {
        let k = self.knot_below(abscissa(asperity_share));
        [k, k + 1].map(|k| monotone_slope(&self.knots, k).1) != [false; 2]
    }

    /// The share at which the contact's gap is the one supplied, with its residual.
    ///
    /// ```text
    /// g(φ) = h̄(φ);  φ = 0 if g(0) ≤ h̄(0), 0.99 if g(0.99) > h̄(0.99)            [Load-share]
    /// ```
    pub(crate) fn share(
        &self,
        supply: impl Fn(f64) -> f64,
    ) -> Result<asperity_core::numerics::Solved, LoadShareError> {
        cite!("Load-share");
        if let Some(end) = end_share(self.first_touch, &supply, |phi| self.mean_gap(phi).si()) {
            return Ok(end);
        }
        let scale = supply(0.0);
        // In φ^¼ the excess of the supply over the gap rises nearly as a line.
        let root = secant_root(
            |s: f64| {
                let phi = s.powf(1.0 / ABSCISSA_POWER);
                (supply(phi) - self.mean_gap(phi).si()) / scale
            },
            [0.0, abscissa(LARGEST_SHARE)],
            0.7,
            self.first_touch / scale,
            1e-12,
        );
        match root {
            Ok(root) => Ok(asperity_core::numerics::Solved {
                value: root.value.powf(1.0 / ABSCISSA_POWER),
                ..root
            }),
            Err(source) => Err(LoadShareError::NoRoot {
                quantity: "asperity share",
                source,
            }),
        }
    }

    /// The neighbouring rows of a share; below the first row only that row.
    pub(crate) fn between(&self, asperity_share: f64) -> Between<'_> {
        let last = self.rows.len() - 1;
        let k = self
            .rows
            .partition_point(|row| row.asperity_share <= asperity_share);
        if k == 0 {
            return Between {
                rows: [(&self.rows[0], 1.0), (&self.rows[0], 0.0)],
                slope: 0.0,
            };
        }
        let (low, high) = (&self.rows[(k - 1).min(last)], &self.rows[k.min(last)]);
        let (a, b) = (abscissa(low.asperity_share), abscissa(high.asperity_share));
        let (weight, slope) = if b > a {
            let s = abscissa(asperity_share);
            let slope = abscissa_slope(asperity_share);
            ((s - a) / (b - a), slope / (b - a))
        } else {
            (0.0, 0.0)
        };
        Between {
            rows: [(low, 1.0 - weight), (high, weight)],
            slope,
        }
    }

    /// Slope g′(φ), and the derivative of g(φ) over the gap of every knot: first touch, then the rows.
    pub(crate) fn gap_slopes(&self, asperity_share: f64) -> (f64, Vec<f64>) {
        /// Step of the difference quotients over the gap of first touch: the interpolation is linear in the gaps of its knots
        /// where no slope is held.
        const STEP: f64 = 1e-6;
        let s = abscissa(asperity_share);
        let k = self.knot_below(s);
        let slope = hermite_slope(&self.knots[k], &self.knots[k + 1], s);
        let step = STEP * self.first_touch.abs();
        let by_knot = |j: usize| {
            // Slopes follow from the nearest neighbours; at the ends from the nearest three knots.
            if step == 0.0 || j + 2 < k || j > k + 3 {
                return 0.0;
            }
            let at = |step: f64| {
                let mut knots = self.knots.clone();
                knots[j][1] += step;
                set_monotone_slopes(&mut knots);
                hermite(&knots[k], &knots[k + 1], s)
            };
            (at(step) - at(-step)) / (2.0 * step)
        };
        let all = (0..self.knots.len()).map(by_knot).collect();
        (slope * abscissa_slope(asperity_share), all)
    }
}

/// The share at the ends, if gap and supply are not equal between them.
pub(crate) fn end_share(
    first_touch: f64,
    supply: &impl Fn(f64) -> f64,
    gap: impl FnOnce(f64) -> f64,
) -> Option<asperity_core::numerics::Solved> {
    let at = |value: f64, residual: f64| asperity_core::numerics::Solved {
        value,
        residual,
        iterations: 0,
    };
    if first_touch <= supply(0.0) {
        return Some(at(0.0, 0.0));
    }
    let excess = gap(LARGEST_SHARE) / supply(LARGEST_SHARE) - 1.0;
    (excess > 0.0).then(|| at(LARGEST_SHARE, excess))
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
