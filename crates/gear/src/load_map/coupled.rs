//! Load over the lines of contact of elastic teeth at a phase.
//!
//! Every pair of teeth in contact deflects by u + f q_H(f); u spreads along the face.
//!
//! | symbol | meaning | unit |
//! |---|---|---|
//! | f | load per length of contact line | N/m |
//! | u, w | deflection of teeth and foundations, u = √q_b·w | m |
//! | λ | coupling length of the deflection along the face | m |
//! | δ | approach common to all pairs | m |
//! | e | separation of the unloaded flanks | m |
//! | a | covered fraction of a cell of the face | - |
//! | g | slope of f q_H(f), q_H − K | m²/N |
//!
//! Method: active set of cells in contact with Newton's method for the flattening. An iteration solves a tridiagonal
//! system per contact line for the right-hand sides 1 and −(e + f (q_H − g)); the force balance then gives δ. Cells
//! outside the line of contact carry no load but transmit deflection; their elimination is computed in advance
//! ([`Tails`]).

use asperity_core::cite;

/// Maximum number of iterations; 2 to 11 suffice.
const MAX_ROUNDS: usize = 100;

/// Convergence criterion: change of the load divided by the mean load.
const TOLERANCE: f64 = 1e-9;

/// Fraction of the mean load below which the flattening is proportional to the load, which avoids ln 0.
const LOAD_FLOOR: f64 = 1e-4;

/// Minimum slope of the flattening divided by its secant at the mean load, which keeps the Newton step finite.
const SLOPE_FLOOR: f64 = 1e-3;

/// Covered fraction of a cell below which it is a rounding error.
pub(crate) const LEAST_COVER: f64 = 1e-12;

/// A cell of a contact line.
#[derive(Debug, Clone, Copy, Default)]
pub(crate) struct CoupledCell {
    /// ξ and y/b at the middle of the covered part.
    pub(crate) xi: f64,
    pub(crate) across: f64,
    /// a.
    pub(crate) cover: f64,
    /// e.
    pub(crate) separation: f64,
    /// √q_b.
    pub(crate) root_bending: f64,
    /// q_H at the mean load.
    pub(crate) flattening: f64,
    /// f.
    pub(crate) load: f64,
    pub(super) touches: bool,
    pub(super) slope: f64,
    pub(super) offset: f64,
    /// Elimination factor to the next cell and the two right-hand sides, then u for both.
    pub(super) factor: f64,
    pub(super) one: f64,
    pub(super) shift: f64,
}

/// The cells covered by the line of contact of a pair of teeth, in the order of y.
#[derive(Debug, Clone, Default)]
pub(crate) struct ContactLine {
    pub(crate) tooth: i64,
    /// Number of idle cells of the face on each side.
    pub(crate) idle: [usize; 2],
    pub(crate) cells: Vec<CoupledCell>,
}

/// Data common to all contact lines.
#[derive(Debug, Clone, Copy)]
pub(crate) struct CoupledProblem<'a> {
    /// F_bn.
    pub(crate) force: f64,
    /// Length of contact line in a completely covered cell.
    pub(crate) cell_length: f64,
    /// Mean load f₀.
    pub(crate) mean_load: f64,
    /// K = −dq_H/d ln f.
    pub(crate) slope: f64,
    pub(crate) tails: &'a Tails,
}

/// Elimination of the idle cells at the ends of the face.
#[derive(Debug, Clone)]
pub(crate) struct Tails {
    /// (λ/h)².
    spread: f64,
    /// w of the last of n idle cells divided by w of the next cell.
    ratio: Vec<f64>,
}

impl Tails {
    /// t₀ = 1 (w′ = 0 at the end of the face), t_{n+1} = κ/(1 + 2κ − κ t_n), κ = (λ/h)².
    pub(crate) fn new(coupling_in_cells: f64, cells: usize) -> Self {
        let spread = coupling_in_cells * coupling_in_cells;
        let mut ratio = vec![1.0];
        for n in 0..cells {
            ratio.push(spread / (1.0 + 2.0 * spread - spread * ratio[n]));
        }
        Self { spread, ratio }
    }

    fn after(&self, idle: usize) -> f64 {
        self.ratio.get(idle).copied().unwrap_or(0.0)
    }
}

/// PhaseSolution and convergence; the loads are stored in the cells.
#[derive(Debug, Clone, Copy)]
pub(crate) struct PhaseSolution {
    /// δ.
    pub(crate) approach: f64,
    pub(crate) rounds: usize,
    pub(crate) converged: bool,
    /// Load change in the final iteration, divided by the mean load.
    pub(crate) residual: f64,
}

/// u = √q_b w, w − λ² w″ = √q_b f, w′ = 0 at both ends of the face;
/// f > 0: u + f q_H(f) = δ − e, else u ≥ δ − e; Σ ∫ f dl = F_bn               [Load-map-1]
pub(crate) fn solve(rows: &mut [ContactLine], problem: &CoupledProblem<'_>) -> PhaseSolution {
    cite!("Load-map-1");
    for cell in rows.iter_mut().flat_map(|row| &mut row.cells) {
        cell.load = problem.mean_load;
        cell.touches = true;
    }
    let mut last = PhaseSolution {
        approach: 0.0,
        rounds: 0,
        converged: false,
        residual: f64::INFINITY,
    };
    while last.rounds < MAX_ROUNDS && !last.converged {
        let (mut constant, mut stiffness) = (0.0, 0.0);
        for row in rows.iter_mut() {
            linearise(row, problem);
            deflect(row, problem.tails);
            let [force, slope] = forces(row);
            constant += force;
            stiffness += slope;
        }
        let approach = (problem.force / problem.cell_length - constant) / stiffness;
        let (mut residual, mut changed) = (0.0f64, false);
        for row in rows.iter_mut() {
            let (change, moved) = update(row, approach);
            residual = residual.max(change / problem.mean_load);
            changed |= moved;
        }
        last = PhaseSolution {
            approach,
            rounds: last.rounds + 1,
            converged: residual < TOLERANCE && !changed,
            residual,
        };
    }
    balance(rows, problem);
    last
}

/// g and the offset e + f (q_H − g) of each cell.
fn linearise(row: &mut ContactLine, problem: &CoupledProblem<'_>) {
    let floor = LOAD_FLOOR * problem.mean_load;
    for cell in &mut row.cells {
        let mut secant = cell.flattening;
        cell.slope = secant;
        if problem.slope > 0.0 {
            // In the first iteration the load is the mean load.
            if cell.load != problem.mean_load {
                secant -= problem.slope * (cell.load.max(floor) / problem.mean_load).ln();
            }
            let tangent = if cell.load > floor {
                secant - problem.slope
            } else {
                secant
            };
            cell.slope = tangent.max(SLOPE_FLOOR * cell.flattening);
        }
        cell.offset = cell.separation + cell.load * (secant - cell.slope);
    }
}

/// Computes u for the right-hand sides 1 and −offset, stored in `one` and `shift`.
fn deflect(row: &mut ContactLine, tails: &Tails) {
    let spread = tails.spread;
    if spread == 0.0 {
        // An independent slice deflects by its own load, whatever fraction is covered.
        for cell in &mut row.cells {
            let q = cell.root_bending * cell.root_bending;
            let share = if cell.touches {
                q / (q + cell.slope)
            } else {
                0.0
            };
            (cell.one, cell.shift) = (share, -share * cell.offset);
        }
        return;
    }
    let last = row.cells.len().saturating_sub(1);
    let far = tails.after(row.idle[1]);
    // Idle cells before the first cell: w₋₁ = t w₀.
    let (mut factor, mut one, mut shift) = (tails.after(row.idle[0]), 0.0, 0.0);
    for (k, cell) in row.cells.iter_mut().enumerate() {
        let m = if cell.touches {
            cell.cover / cell.slope
        } else {
            0.0
        };
        let source = cell.root_bending * m;
        let mut diagonal = 1.0 + source * cell.root_bending + 2.0 * spread - spread * factor;
        if k == last {
            diagonal -= spread * far;
        }
        let inverse = 1.0 / diagonal;
        factor = spread * inverse;
        one = (source + spread * one) * inverse;
        shift = (spread * shift - source * cell.offset) * inverse;
        (cell.factor, cell.one, cell.shift) = (factor, one, shift);
    }
    let (mut one, mut shift) = (0.0, 0.0);
    for cell in row.cells.iter_mut().rev() {
        one = cell.one + cell.factor * one;
        shift = cell.shift + cell.factor * shift;
        cell.one = cell.root_bending * one;
        cell.shift = cell.root_bending * shift;
    }
}

/// Σ a f for δ = 0, and its derivative with respect to δ.
fn forces(row: &ContactLine) -> [f64; 2] {
    let mut sums = [0.0; 2];
    for cell in row.cells.iter().filter(|cell| cell.touches) {
        let inverse = cell.cover / cell.slope;
        sums[0] -= (cell.offset + cell.shift) * inverse;
        sums[1] += (1.0 - cell.one) * inverse;
    }
    sums
}

/// Updates loads and contact; returns the largest load change and whether the set of cells in contact changed.
fn update(row: &mut ContactLine, approach: f64) -> (f64, bool) {
    let (mut largest, mut changed) = (0.0f64, false);
    for cell in &mut row.cells {
        let u = cell.one * approach + cell.shift;
        let mut load = 0.0;
        if cell.touches {
            load = (approach - cell.offset - u) / cell.slope;
            if load < 0.0 {
                (cell.touches, changed, load) = (false, true, 0.0);
            }
        } else if approach - cell.separation - u > LEAST_COVER * approach.abs() {
            (cell.touches, changed) = (true, true);
        }
        largest = largest.max((load - cell.load).abs());
        cell.load = load;
    }
    (largest, changed)
}

/// Scales the loads so that the force balance holds exactly.
fn balance(rows: &mut [ContactLine], problem: &CoupledProblem<'_>) {
    let carried: f64 = (rows.iter().flat_map(|row| &row.cells))
        .map(|cell| cell.load * cell.cover)
        .sum();
    let factor = problem.force / (carried * problem.cell_length);
    for cell in rows.iter_mut().flat_map(|row| &mut row.cells) {
        cell.load *= factor;
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn row(cells: usize, covered: usize) -> ContactLine {
        let cell = |k: usize| CoupledCell {
            across: (k as f64 + 0.5) / cells as f64,
            cover: 1.0,
            root_bending: 80f64.sqrt(),
            flattening: 16.0,
            ..CoupledCell::default()
        };
        ContactLine {
            tooth: 0,
            idle: [0, cells - covered],
            cells: (0..covered).map(cell).collect(),
        }
    }

    #[test]
    fn a_line_that_ends_within_a_wide_face_carries_more_at_its_end() {
        // On a half-infinite line w − λ²w″ = √q f with f = (δ − √q w)/q_H and w decaying beyond its
        // end gives f(end)/f(far) = √((q + q_H)/q_H) = 2.449 for 80 and 16.
        let mut ends = Vec::new();
        for cells in [512usize, 1024] {
            let mut rows = [row(cells, cells / 2)];
            // A face of 20 λ.
            let tails = Tails::new(cells as f64 / 20.0, cells);
            let problem = CoupledProblem {
                force: 1.0,
                cell_length: 1.0 / cells as f64,
                mean_load: 2.0,
                slope: 0.0,
                tails: &tails,
            };
            let solved = solve(&mut rows, &problem);
            assert!(solved.converged && solved.rounds <= 3, "{solved:?}");
            let loads: Vec<f64> = rows[0].cells.iter().map(|cell| cell.load).collect();
            let last = loads.len() - 1;
            // Half a cell beyond the last middle.
            let end = 1.5 * loads[last] - 0.5 * loads[last - 1];
            ends.push(end / loads[last / 2]);
        }
        let exact = 6f64.sqrt();
        assert!((ends[0] / exact - 1.0).abs() < 5e-3, "{ends:?}");
        assert!((ends[1] / exact - 1.0).abs() < 1.5e-3, "{ends:?}");
    }

    #[test]
    fn a_line_over_the_whole_face_carries_the_same_everywhere() {
        let mut rows = [row(64, 64)];
        let tails = Tails::new(3.7, 64);
        let problem = CoupledProblem {
            force: 5.0,
            cell_length: 0.5,
            mean_load: 1.0,
            slope: 0.0,
            tails: &tails,
        };
        solve(&mut rows, &problem);
        for cell in &rows[0].cells {
            assert!((cell.load / (5.0 / 32.0) - 1.0).abs() < 1e-12);
        }
    }

    /// w of the whole face, from the loads alone and without the elimination of idle cells.
    fn deflections(row: &ContactLine, spread: f64, cells: usize) -> Vec<f64> {
        let mut source = vec![0.0; cells];
        for (k, cell) in row.cells.iter().enumerate() {
            source[row.idle[0] + k] = cell.root_bending * cell.cover * cell.load;
        }
        // Gauss-Seidel on (1 + 2κ) w − κ (w₋ + w₊) = source with mirrored ends.
        let mut w = source.clone();
        for _ in 0..20_000 {
            for k in 0..cells {
                let left = if k == 0 { w[0] } else { w[k - 1] };
                let right = if k + 1 == cells { w[k] } else { w[k + 1] };
                w[k] = (source[k] + spread * (left + right)) / (1.0 + 2.0 * spread);
            }
        }
        w
    }

    #[test]
    fn touching_cells_share_the_approach_and_the_others_stay_clear() {
        let cells = 48;
        let mut rows = [row(cells, 40), row(cells, 30)];
        for (r, row) in rows.iter_mut().enumerate() {
            row.idle = [3 * r, cells - row.cells.len() - 3 * r];
            let last = row.cells.len() - 1;
            row.cells[last].cover = 0.3;
            for (k, cell) in row.cells.iter_mut().enumerate() {
                cell.separation = 600.0 * (k as f64 / 20.0 - 0.6).powi(2) * (1.0 + r as f64);
            }
        }
        let tails = Tails::new(2.5, cells);
        let problem = CoupledProblem {
            force: 1.0,
            cell_length: 1.0 / cells as f64,
            mean_load: 0.7,
            slope: 1.7,
            tails: &tails,
        };
        let solved = solve(&mut rows, &problem);
        assert!(solved.converged && solved.rounds < 12, "{solved:?}");
        let force: f64 = (rows.iter().flat_map(|row| &row.cells))
            .map(|cell| cell.load * cell.cover * problem.cell_length)
            .sum();
        assert!((force - 1.0).abs() < 1e-9);
        let (mut touching, mut clear) = (0, 0);
        for row in &rows {
            let w = deflections(row, tails.spread, cells);
            for (k, cell) in row.cells.iter().enumerate() {
                let u = cell.root_bending * w[row.idle[0] + k];
                let room = solved.approach - cell.separation - u;
                if cell.load > 0.0 {
                    let floor = LOAD_FLOOR * problem.mean_load;
                    let q = cell.flattening - 1.7 * (cell.load.max(floor) / 0.7).ln();
                    assert!((room - cell.load * q).abs() < 1e-7, "{k} {cell:?}");
                    touching += 1;
                } else {
                    assert!(room <= 1e-7, "{k} {cell:?}");
                    clear += 1;
                }
            }
        }
        assert!(touching > 10 && clear > 10, "{touching} {clear}");
    }
}
