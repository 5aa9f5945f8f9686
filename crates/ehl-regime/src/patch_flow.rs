//! Pressure flow along rolling through the gap between two rough flanks.
//!
//! | symbol | meaning | unit |
//! |---|---|---|
//! | H | gap between the mean planes of both flanks | m |
//! | z | heights of both flanks together, over their mean | m |
//! | h | local gap max(0, H − z) | m |
//! | p | pressure | Pa |
//! | K | cube of the smooth gap with the same flow | m³ |
//! | φ_x | flow over the flow of the smooth gap H | - |
//! | σ | standard deviation of z | m |
//!
//! The patch repeats in both directions, and the pressure falls by the same amount from each patch to the next along rolling. Even
//! pressures at both ends would bridge what the ends cut off and pass more: on 21 correlation lengths by 10 % for isotropic
//! heights at H = σ, by 3 % at 2 σ. They are the flow through a patch that is mirrored along rolling, and a case of the periodic one.
//!
//! Finite volumes: the conductance of a face is the harmonic mean of both cells, exact for ridges across and along the flow.

mod multigrid;

use asperity_core::cite;
use asperity_core::quantity::Length;

use crate::error::RegimeError;
use crate::patch::Patch;
use multigrid::{FlowGrid, Grids};

/// Largest difference of the flow between sections, over the flow, at which a solution is accepted, and the same over the flow of a smooth
/// gap of one standard deviation. The smooth gap of the same flow is then known to 1e-5 of it from a fifth of a standard deviation above
/// the closing gap on, and to 2e-4 standard deviations below.
const UNEVEN: f64 = 1e-3;
const NO_FLOW: f64 = 1e-4;
/// Iterations after which a solution is given up: 60 were the most that a patch near its closing gap took.
const MOST_ITERATIONS: usize = 2000;
/// Closed cell of which the place along rolling is not known yet.
const UNSEEN: i32 = i32::MIN;

impl Patch {
    /// The smooth gap with the same flow along rolling, K^⅓, at a gap between the mean planes; zero where the open cells do not
    /// percolate.
    ///
    /// ```text
    /// ∇·(h³ ∇p) = 0,  h = max(0, H − z),  φ_x = K/H³                           [Patch-flow]
    /// ```
    ///
    /// # Errors
    /// When the iteration does not end.
    ///
    /// ```
    /// use asperity_core::quantity::Length;
    /// use asperity_ehl_regime::Patch;
    /// // Ridges across the flow: a third of the length has a gap of 1 um, the rest 2 um.
    /// let um = |value: f64| Length::from_si(value * 1e-6);
    /// let z = |i: usize| if i % 6 < 2 { 2e-6 / 3.0 } else { -1e-6 / 3.0 };
    /// let ridges = Patch::new((0..24).map(z).collect(), [6, 4], [um(1.0), um(1.0)])?;
    /// let found = ridges.hydraulic_gap(um(5.0 / 3.0))?;
    /// let exact = (1.0 / 3.0 + 2.0 / 3.0 / 8.0_f64).powf(-1.0 / 3.0);
    /// assert!((found.si() * 1e6 / exact - 1.0).abs() < 1e-8);
    /// # Ok::<(), asperity_ehl_regime::RegimeError>(())
    /// ```
    pub fn hydraulic_gap(&self, gap: Length) -> Result<Length, RegimeError> {
        cite!("Patch-flow");
        self.hydraulic_gap_to([UNEVEN, NO_FLOW], gap)
    }

    /// The same where a solution is accepted by other differences of the flow.
    fn hydraulic_gap_to(
        &self,
        [most_uneven, no_flow]: [f64; 2],
        gap: Length,
    ) -> Result<Length, RegimeError> {
        let scale = self.rms().si();
        if scale == 0.0 {
            return Ok(Length::from_si(gap.si().max(0.0)));
        }
        let Some(open) = self.percolating(gap.si()) else {
            return Ok(Length::from_si(0.0));
        };
        let cube = |(z, open): (&f64, &bool)| {
            if *open {
                ((gap.si() - z) / scale).powi(3)
            } else {
                0.0
            }
        };
        let cubes: Vec<f64> = self.heights().iter().zip(&open).map(cube).collect();
        let (grid, sources) = self.conductances(&cubes);
        let mut grids = Grids::new(grid);
        let [dx, dy] = self.grid().spacing().map(Length::si);
        let of_smooth = dx / (self.grid().size()[1] as f64 * dy);
        let done = |grid: &FlowGrid, p: &[f64]| {
            let [flow, uneven] = sections(grid, p);
            uneven <= most_uneven * flow + no_flow / of_smooth
        };
        let found = grids.solve(&sources, done, MOST_ITERATIONS);
        let [flow, uneven] = sections(grids.finest(), &found.values);
        if !found.is_done {
            return Err(RegimeError::no_flow(uneven / flow, found.iterations));
        }
        let cubed = of_smooth * flow.max(0.0);
        Ok(Length::from_si(scale * cubed.cbrt()))
    }

    /// The largest gap between the mean planes at which the open cells do not percolate along rolling.
    #[must_use]
    pub fn percolation_gap(&self) -> Length {
        let mut levels = self.heights().to_vec();
        levels.sort_by(f64::total_cmp);
        let is_closed = |gap: &f64| self.percolating(*gap).is_none();
        let closed = levels.partition_point(is_closed);
        Length::from_si(levels[closed.max(1) - 1])
    }

    /// The cells of clusters that percolate along rolling, `None` without any.
    ///
    /// A cluster percolates if it is connected with itself one patch further.
    fn percolating(&self, gap: f64) -> Option<Vec<bool>> {
        let [columns, rows] = self.grid().size();
        let heights = self.heights();
        let mut place = vec![UNSEEN; heights.len()];
        let mut open = vec![false; heights.len()];
        let (mut cluster, mut is_any) = (Vec::new(), false);
        for start in 0..heights.len() {
            if place[start] != UNSEEN || heights[start] >= gap {
                continue;
            }
            place[start] = (start % columns) as i32;
            cluster.clear();
            cluster.push(start);
            let (mut next, mut percolates) = (0, false);
            while let Some(&cell) = cluster.get(next) {
                next += 1;
                let (i, row) = (cell % columns, cell - cell % columns);
                let (above, below) = ((row + columns) % heights.len(), row + (rows - 1) * columns);
                let neighbours = [
                    (row + (i + 1) % columns, 1),
                    (row + (i + columns - 1) % columns, -1),
                    (above + i, 0),
                    (below % heights.len() + i, 0),
                ];
                for (neighbour, step) in neighbours {
                    let at = place[cell] + step;
                    if heights[neighbour] >= gap {
                        continue;
                    }
                    if place[neighbour] == UNSEEN {
                        place[neighbour] = at;
                        cluster.push(neighbour);
                    } else {
                        percolates |= place[neighbour] != at;
                    }
                }
            }
            if percolates {
                is_any = true;
                cluster.iter().for_each(|cell| open[*cell] = true);
            }
        }
        is_any.then_some(open)
    }

    /// Conductances between cells of these cubes of the gap, and the inflow of each by an even fall of the pressure by one a cell.
    fn conductances(&self, cubes: &[f64]) -> (FlowGrid, Vec<f64>) {
        let face = |a: f64, b: f64| {
            if a > 0.0 && b > 0.0 {
                2.0 * a * b / (a + b)
            } else {
                0.0
            }
        };
        let [columns, rows] = self.grid().size();
        let [dx, dy] = self.grid().spacing().map(Length::si);
        let (mut along, mut across) = (vec![0.0; cubes.len()], vec![0.0; cubes.len()]);
        let mut sources = vec![0.0; cubes.len()];
        for j in 0..rows {
            let (row, next_row) = (j * columns, (j + 1) % rows * columns);
            for i in 0..columns {
                let (cell, next) = (row + i, row + (i + 1) % columns);
                along[cell] = dy / dx * face(cubes[cell], cubes[next]);
                across[cell] = dx / dy * face(cubes[cell], cubes[next_row + i]);
                sources[cell] -= along[cell];
                sources[next] += along[cell];
            }
        }
        (FlowGrid::new(self.grid().size(), along, across), sources)
    }
}

/// Mean flow through the sections across rolling, and its largest difference from it.
fn sections(grid: &FlowGrid, pressures: &[f64]) -> [f64; 2] {
    let [columns, _] = grid.size;
    let mut flows = vec![0.0; columns];
    let rows = grid.along.chunks_exact(columns);
    for (faces, p) in rows.zip(pressures.chunks_exact(columns)) {
        for i in 0..columns {
            flows[i] += faces[i] * (1.0 + p[i] - p[(i + 1) % columns]);
        }
    }
    let mean = flows.iter().sum::<f64>() / columns as f64;
    let uneven = flows.iter().map(|flow| (flow - mean).abs());
    [mean, uneven.fold(0.0, f64::max)]
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Waves of 11 to 96 cells along rolling, `ratio` times as long along the lead, with phases that depend on a seed.
    fn rough(ratio: f64, seed: u32) -> Patch {
        const SIZE: [usize; 2] = [96, 96];
        let part = |k: u32, by: f64| (f64::from(k + 100 * seed) * by).fract();
        let waves: Vec<[f64; 4]> = (0..80)
            .map(|k| {
                let [x, y] = [(k % 9 + 1), (k / 9)].map(f64::from);
                let y = (y / ratio).round();
                let turn = std::f64::consts::TAU / 96.0;
                let side = if part(k, 0.754_878) < 0.5 { -1.0 } else { 1.0 };
                let size = (x * x + (y * ratio).powi(2)).powf(-0.9);
                [turn * x, side * turn * y, 7.0 * part(k, 0.618_034), size]
            })
            .collect();
        let height = |cell: usize| -> f64 {
            let [i, j] = [cell % SIZE[0], cell / SIZE[0]].map(|at| at as f64);
            let wave = |[x, y, phase, size]: &[f64; 4]| size * (x * i + y * j + phase).cos();
            1e-7 * waves.iter().map(wave).sum::<f64>()
        };
        let heights = (0..SIZE[0] * SIZE[1]).map(height).collect();
        Patch::new(heights, SIZE, [Length::from_si(1e-6); 2]).unwrap()
    }

    #[test]
    fn a_solution_that_is_accepted_has_the_gap_that_is_claimed() {
        const EXACT: f64 = 1e-11;
        let mut worst = [0.0_f64; 2];
        for (ratio, seed) in [(1.0, 1), (1.0, 2), (3.0, 3), (6.0, 4), (6.0, 5)] {
            let patch = rough(ratio, seed);
            let sigma = patch.rms().si();
            let closing = patch.percolation_gap().si();
            for over in [0.02, 0.05, 0.1, 0.2, 0.5, 1.0, 2.0, 5.0] {
                let gap = Length::from_si(closing + over * sigma);
                let found = patch.hydraulic_gap(gap).unwrap().si();
                let exact = patch.hydraulic_gap_to([EXACT; 2], gap).unwrap().si();
                let (at, off) = if over >= 0.2 {
                    (0, (found - exact).abs() / exact)
                } else {
                    (1, (found - exact).abs() / sigma)
                };
                worst[at] = worst[at].max(off);
            }
        }
        assert!(worst[0] < 1e-5 && worst[1] < 2e-4, "{worst:?}");
    }
}
