//! Conductances between the cells of a periodic grid, and a solver for the pressures in them.
//!
//! Conjugate gradients with a W-cycle over halved grids as preconditioner. A cell of a halved grid is two or four cells, and the
//! conductance between two of them is the sum over their common faces, halved where the faces lie twice as far apart as before.

use asperity_core::numerics::{add_times, dot, vectorised};

/// Cells of a grid that is small enough to be relaxed only.
const FEWEST: usize = 16;
/// Relaxations of the smallest grid.
const ON_SMALLEST: usize = 12;
/// Cycles over the halved grids in each cycle: with one instead of two, a patch near its closing gap takes four times as many
/// iterations, as the halved grids average narrow passages.
const CYCLES: usize = 2;
/// Ratio of the conductances of both directions from which only the better conducting one is halved.
const LOPSIDED: f64 = 2.0;

/// A grid of cells, each connected with four neighbours, the first with the last.
pub(super) struct FlowGrid {
    /// Number of cells in a row, and of rows.
    pub size: [usize; 2],
    /// Conductance to the next cell of the row.
    pub along: Vec<f64>,
    /// Conductance to the cell in the next row.
    pub across: Vec<f64>,
    /// One over the sum of the four conductances of a cell, zero without any.
    inverse: Vec<f64>,
}

impl FlowGrid {
    /// The grid with the given conductances to the next cells.
    pub fn new(size: [usize; 2], along: Vec<f64>, across: Vec<f64>) -> Self {
        let [columns, rows] = size;
        let mut inverse = vec![0.0; columns * rows];
        for j in 0..rows {
            let before = (j + rows - 1) % rows;
            for i in 0..columns {
                let left = (i + columns - 1) % columns;
                let cell = j * columns + i;
                let in_row = along[cell] + along[j * columns + left];
                let in_column = across[cell] + across[before * columns + i];
                let sum = in_row + in_column;
                inverse[cell] = if sum > 0.0 { 1.0 / sum } else { 0.0 };
            }
        }
        Self {
            size,
            along,
            across,
            inverse,
        }
    }

    pub fn cells(&self) -> usize {
        self.inverse.len()
    }

    /// Writes the inflow of every cell of row `j` at the pressures `p`, or without the outflow by its own pressure, to `sums`.
    ///
    /// One pass over the row for the faces of each side: each is a loop over equal shifts, which is compiled to vectors.
    #[inline(always)]
    fn inflow(&self, j: usize, is_net: bool, sources: &[f64], p: &[f64], sums: &mut [f64]) {
        let [n, rows] = self.size;
        let row_of = |j: usize| j * n..(j + 1) * n;
        let [here, before, next] = [j, (j + rows - 1) % rows, (j + 1) % rows].map(row_of);
        let (along, p_here) = (&self.along[here.clone()], &p[here.clone()]);
        let add = |sums: &mut [f64], faces: &[f64], other: &[f64], p: &[f64]| {
            let cells = sums.iter_mut().zip(faces).zip(other.iter().zip(p));
            for ((sum, face), (other, p)) in cells {
                *sum += face * if is_net { other - p } else { *other };
            }
        };
        sums.copy_from_slice(&sources[here.clone()]);
        let last = n - 1;
        add(
            &mut sums[1..],
            &along[..last],
            &p_here[..last],
            &p_here[1..],
        );
        add(
            &mut sums[..1],
            &along[last..],
            &p_here[last..],
            &p_here[..1],
        );
        add(
            &mut sums[..last],
            &along[..last],
            &p_here[1..],
            &p_here[..last],
        );
        add(
            &mut sums[last..],
            &along[last..],
            &p_here[..1],
            &p_here[last..],
        );
        add(sums, &self.across[before.clone()], &p[before], p_here);
        add(sums, &self.across[here], &p[next], p_here);
    }

    /// `sources` less the outflow of each cell at the pressures `p`.
    pub fn residual(&self, sources: &[f64], p: &[f64], residual: &mut [f64]) {
        vectorised(
            #[inline(always)]
            || {
                for (j, sums) in residual.chunks_exact_mut(self.size[0]).enumerate() {
                    self.inflow(j, true, sources, p, sums);
                }
            },
        );
    }

    /// One Gauss-Seidel pass, over the cells of one colour of a chessboard and then over the others: they do not wait for each other.
    /// `work` has room for a row.
    fn relax(&self, sources: &[f64], p: &mut [f64], is_reversed: bool, work: &mut [f64]) {
        let [n, rows] = self.size;
        let sums = &mut work[..n];
        vectorised(
            #[inline(always)]
            || {
                for (colour, k) in (0..2 * rows).map(|k| (k / rows, k % rows)) {
                    let j = if is_reversed { rows - 1 - k } else { k };
                    let first = (j + colour + usize::from(is_reversed)) % 2;
                    self.inflow(j, false, sources, p, sums);
                    let (row, last) = (j * n, n - 1);
                    let inverse = &self.inverse[row..row + n];
                    // Both ends of a row with an odd number of cells have one colour and a common face: the later one waits.
                    if n > 1 && first == 0 && last % 2 == 0 {
                        let [early, late] = if is_reversed { [last, 0] } else { [0, last] };
                        let change = sums[early] * inverse[early] - p[row + early];
                        sums[late] += self.along[row + last] * change;
                    }
                    let cells = p[row..row + n].iter_mut().zip(sums.iter().zip(inverse));
                    for (p, (sum, inverse)) in cells.skip(first).step_by(2) {
                        *p = sum * inverse;
                    }
                }
            },
        );
    }
}

/// A grid with its work arrays, and the directions in which the next one is halved.
struct Level {
    grid: FlowGrid,
    halved: [bool; 2],
    sources: Vec<f64>,
    pressures: Vec<f64>,
    residual: Vec<f64>,
}

impl Level {
    fn new(grid: FlowGrid) -> Self {
        let zero = || vec![0.0; grid.cells()];
        let (sources, pressures, residual) = (zero(), zero(), zero());
        let sum = |of: &[f64]| of.iter().sum::<f64>();
        let [along, across] = [sum(&grid.along), sum(&grid.across)];
        let [columns, rows] = grid.size;
        let large = grid.cells() > FEWEST;
        let halved = [
            large && columns > 1 && (across < LOPSIDED * along || rows == 1),
            large && rows > 1 && (along < LOPSIDED * across || columns == 1),
        ];
        Self {
            grid,
            halved,
            sources,
            pressures,
            residual,
        }
    }

    /// One pass over the pressures.
    fn relax(&mut self, is_reversed: bool) {
        let (p, work) = (&mut self.pressures, &mut self.residual);
        self.grid.relax(&self.sources, p, is_reversed, work);
    }

    /// Number of cells in a row and of rows of the halved grid.
    fn next_size(&self) -> [usize; 2] {
        [0, 1].map(|d: usize| {
            if self.halved[d] {
                self.grid.size[d].div_ceil(2)
            } else {
                self.grid.size[d]
            }
        })
    }

    /// Cell of the halved grid for every cell of this one.
    fn visit_next(&self, mut pair: impl FnMut(usize, usize)) {
        let [columns, rows] = self.grid.size;
        let [next_columns, _] = self.next_size();
        let shift = self.halved.map(usize::from);
        for j in 0..rows {
            let next_row = (j >> shift[1]) * next_columns;
            for i in 0..columns {
                pair(j * columns + i, next_row + (i >> shift[0]));
            }
        }
    }

    fn next_grid(&self) -> FlowGrid {
        let size = self.next_size();
        let cells = size[0] * size[1];
        let (mut along, mut across) = (vec![0.0; cells], vec![0.0; cells]);
        let [columns, rows] = self.grid.size;
        let scale = self.halved.map(|halved| if halved { 0.5 } else { 1.0 });
        self.visit_next(|cell, next| {
            let [i, j] = [cell % columns, cell / columns];
            // A face within a halved cell conducts inside of it.
            if !self.halved[0] || i % 2 == 1 || i + 1 == columns {
                along[next] += scale[0] * self.grid.along[cell];
            }
            if !self.halved[1] || j % 2 == 1 || j + 1 == rows {
                across[next] += scale[1] * self.grid.across[cell];
            }
        });
        FlowGrid::new(size, along, across)
    }
}

/// Grids from the finest to the smallest.
pub(super) struct Grids {
    levels: Vec<Level>,
}

/// Pressures with what is known about them.
pub(super) struct Pressures {
    pub values: Vec<f64>,
    pub iterations: usize,
    /// Whether the iteration reached its end.
    pub is_done: bool,
}

impl Grids {
    pub fn new(finest: FlowGrid) -> Self {
        let mut levels = vec![Level::new(finest)];
        while let Some(last) = levels.last() {
            if last.halved == [false, false] {
                break;
            }
            levels.push(Level::new(last.next_grid()));
        }
        Self { levels }
    }

    pub fn finest(&self) -> &FlowGrid {
        &self.levels[0].grid
    }

    /// Pressures at which every cell's outflow equals its source, by conjugate gradients until `is_done` of grid and pressures.
    pub fn solve(
        &mut self,
        sources: &[f64],
        mut is_done: impl FnMut(&FlowGrid, &[f64]) -> bool,
        most: usize,
    ) -> Pressures {
        let cells = sources.len();
        let mut p = vec![0.0; cells];
        let mut residual = sources.to_vec();
        let mut direction = vec![0.0; cells];
        let mut outflow = vec![0.0; cells];
        let zero = vec![0.0; cells];
        let (mut before, mut iterations) = (0.0, 0);
        while iterations < most && !is_done(self.finest(), &p) {
            self.levels[0].sources.copy_from_slice(&residual);
            self.levels[0].pressures.fill(0.0);
            self.cycle(0);
            let corrected = &self.levels[0].pressures;
            let product = dot(&residual, corrected);
            if product <= 0.0 {
                break;
            }
            let part = if before > 0.0 { product / before } else { 0.0 };
            for (d, z) in direction.iter_mut().zip(corrected) {
                *d = z + part * *d;
            }
            self.finest().residual(&zero, &direction, &mut outflow);
            let length = -product / dot(&direction, &outflow);
            add_times(&mut p, length, &direction);
            add_times(&mut residual, length, &outflow);
            before = product;
            iterations += 1;
        }
        Pressures {
            is_done: is_done(self.finest(), &p),
            values: p,
            iterations,
        }
    }

    /// One cycle: symmetric if the pressures are zero before, as the relaxations before and behind run in opposite order.
    fn cycle(&mut self, k: usize) {
        let (finer, coarser) = self.levels.split_at_mut(k + 1);
        let level = &mut finer[k];
        let Some(next) = coarser.first_mut() else {
            for _ in 0..ON_SMALLEST {
                level.relax(false);
                level.relax(true);
            }
            return;
        };
        level.relax(false);
        let (grid, sources) = (&level.grid, &level.sources);
        grid.residual(sources, &level.pressures, &mut level.residual);
        next.sources.fill(0.0);
        level.visit_next(|cell, of| next.sources[of] += level.residual[cell]);
        next.pressures.fill(0.0);
        for _ in 0..CYCLES {
            self.cycle(k + 1);
        }
        let (finer, coarser) = self.levels.split_at_mut(k + 1);
        let (level, next) = (&mut finer[k], &coarser[0].pressures);
        let mut pressures = std::mem::take(&mut level.pressures);
        level.visit_next(|cell, of| pressures[cell] += next[of]);
        level.pressures = pressures;
        level.relax(true);
    }
}
