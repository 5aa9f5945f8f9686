//! Touching spots of a rough contact: one for each peak of the pressure.
//!
//! Neighbouring cells under pressure may have several peaks. Above a level of pressure they fall into components; these form a
//! tree, whose root is the whole contact at level zero and whose leaves are the peaks. A cell of a line has two neighbours, a
//! cell of a patch four; along the lead a patch is periodic.
//!
//! | symbol | meaning | unit |
//! |---|---|---|
//! | t_ν | pressure at which a component parts; of a leaf its peak P_k | Pa |
//! | s_ν | pressure at which it joins its neighbour: t of the component around both; 0 of a whole contact | Pa |
//! | f_ν, q_ν | load and ∫ p² dx of a component, of a patch per length of its lead Λ | N/m, Pa²·m |
//! | F_k, Q_k | the same of the contact that a peak is part of | N/m, Pa²·m |
//! | b_k, l_k | its axes along rolling and along the lead; l_k > Λ where it reaches along the whole lead | m |
//! | σ_x | standard deviation of the places of its pressure along rolling | m |
//! | ϱ | concentration of its pressure around the lead: 1 at one place, 0 of even pressure | - |
//! | v | part of the axis l_k/2 that the patch holds, min(1, Λ/l_k) | - |
//!
//! All of them are continuous functions of the pressures, with kinks where another cell becomes the lowest between two peaks or the
//! highest of a peak, or where a peak joins another neighbour first.

use std::f64::consts::{PI, TAU};
use std::ops::Range;
use std::slice::Iter;

use asperity_core::cite;
use asperity_core::quantity::{Length, LineLoad};
use serde::Serialize;

use crate::spot_ellipse::{MeasuredSpot, SpotEllipse, spread_over_a_cell};

/// Width of a Hertz contact times ∫ p² dx over (∫ p dx)²: 2a · (4/3) a p₀²/(π a p₀/2)².
const HERTZ_WIDTH: f64 = 32.0 / (3.0 * PI * PI);

/// A touching spot: a peak of the pressure.
#[derive(Debug, Clone, Copy, PartialEq, Serialize)]
pub struct Spot {
    /// Load f_k per metre of face. The loads of all spots add up to the load of the contact.
    pub load: LineLoad,
    /// Load F_k of the contact that it is part of, per metre of its mean extent along the lead; on a line f_k if the pressure
    /// falls to zero on both sides.
    pub joint_load: LineLoad,
    /// Width b_k of the Hertz contact with this joint load and the same ∫ p² dx.
    pub width: Length,
    /// Axis l_k of that contact along the lead, the extent of a spot that is shorter than the lead; infinite on a line, and on a
    /// patch for a ridge that is even along the lead.
    pub length: Length,
    /// Load through the middle of that contact, per metre there; on a line the joint load.
    pub middle_load: LineLoad,
}

/// Derivatives of a number over the load, the joint load and the width of a spot.
pub(crate) type BySpot = [f64; 3];

/// Cells of a line or of a patch.
#[derive(Debug, Clone, Copy)]
pub(crate) struct SpotGrid {
    /// Cells along rolling.
    pub(crate) columns: usize,
    /// Rows along the lead; one of a line.
    pub(crate) rows: usize,
    /// Distances of the columns and of the rows.
    pub(crate) spacings: [Length; 2],
}

impl SpotGrid {
    /// Cells of a line.
    pub(crate) fn line(columns: usize, spacing: Length) -> Self {
        Self {
            columns,
            rows: 1,
            spacings: [spacing; 2],
        }
    }

    /// Area of a cell per length of the lead \[m\].
    fn cell(&self) -> f64 {
        self.spacings[0].si() / self.rows as f64
    }

    /// Neighbours of a cell along rolling and, on a patch, around the lead.
    fn neighbours(&self, cell: usize) -> impl Iterator<Item = usize> {
        let Self { columns, rows, .. } = *self;
        let (row, column) = (cell / columns, cell % columns);
        let around = |step: usize| (rows > 1).then_some((row + step) % rows * columns + column);
        let before = (column > 0).then(|| cell - 1);
        let after = (column + 1 < columns).then_some(cell + 1);
        [before, after, around(1), around(rows - 1)]
            .into_iter()
            .flatten()
    }
}

/// The spots under the pressures of all cells \[Pa\], by the places of their peaks.
pub(crate) fn spots_of(pressure: &[f64], grid: &SpotGrid) -> Vec<Spot> {
    let tree = SpotTree::new(pressure, grid);
    tree.peaks.iter().map(|&peak| tree.spot(peak)).collect()
}

/// The spot, counted from 0 as in [`spots_of`], of each cell; `None` without pressure. A cell below the pressure at which peaks
/// join is of the spot of its highest neighbour.
pub(crate) fn spot_of_cells(pressure: &[f64], grid: &SpotGrid) -> Vec<Option<u32>> {
    let tree = SpotTree::new(pressure, grid);
    let mut of_cell = vec![None; pressure.len()];
    for (spot, &peak) in (0..).zip(&tree.peaks) {
        for &cell in &tree.cells[tree.nodes[peak].cells.clone()] {
            of_cell[cell] = Some(spot);
        }
    }
    let is_joint = |cell: &usize| of_cell[*cell].is_none();
    let mut joint: Vec<usize> = tree.cells.iter().copied().filter(is_joint).collect();
    joint.sort_by(|a, b| pressure[*b].total_cmp(&pressure[*a]));
    // Cells of a plateau may come before the cell next to them that leads up.
    while !joint.is_empty() {
        joint.retain(|&cell| {
            let known = grid.neighbours(cell).filter(|k| of_cell[*k].is_some());
            let highest = known.max_by(|a, b| pressure[*a].total_cmp(&pressure[*b]));
            of_cell[cell] = highest.and_then(|k| of_cell[k]);
            of_cell[cell].is_none()
        });
    }
    of_cell
}

/// Derivative over the pressures of a line of a number whose derivatives over its spots are `by_spots`.
///
/// With P_k F_k = Σ (t_ν − s_ν) f_ν, the derivatives over f_ν, q_ν, and the levels follow from the leaves to the root, and over the
/// pressures from
///
/// ```text
/// ∂X_ν^m/∂p_i = m p_i^(m−1) dx,  ∂X_ν^m/∂s_ν = −m s_ν^(m−1) n_ν dx                  [Spot-adjoint]
/// ```
///
/// n_ν is the number of cells of the component.
pub(crate) fn pressure_gradient(
    pressure: &[f64],
    spacing: Length,
    mut by_spots: Iter<'_, BySpot>,
) -> Vec<f64> {
    cite!("Spot-adjoint");
    let grid = SpotGrid::line(pressure.len(), spacing);
    SpotTree::new(pressure, &grid).gradient(&mut by_spots)
}

/// A component of the cells above a level.
struct TreeNode {
    /// Its cells in the order of the tree: after those of its parts.
    cells: Range<usize>,
    /// Cell of the highest pressure at which its parts join; of a leaf the cell of its peak.
    top: usize,
    /// t, s
    levels: [f64; 2],
    parent: usize,
    children: Vec<usize>,
    /// Excesses X, X² over s.
    excess: [f64; 2],
    /// f, q
    content: [f64; 2],
    /// Σ (t − s) f and Σ (t − s) q from the root to here.
    sums: [f64; 2],
    /// Of a patch: sums of its places, without weight and with the excess over s as weight.
    places: [SpotPlaces; 2],
    /// Of a patch: Σ (t − s) f σ_x² and Σ (t − s) f ϱ from the root to here.
    spread: [f64; 2],
}

impl TreeNode {
    fn rise(&self) -> f64 {
        self.levels[0] - self.levels[1]
    }

    /// F and Q of a leaf.
    fn joint(&self) -> [f64; 2] {
        self.sums.map(|sum| sum / self.levels[0])
    }
}

/// Weighted sums over places on a patch: of the weight, the column and its square, and the cosine and the sine of the angle around
/// the lead.
#[derive(Debug, Clone, Copy, Default)]
struct SpotPlaces([f64; 5]);

impl SpotPlaces {
    fn new(cell: usize, grid: &SpotGrid) -> Self {
        let (row, column) = (cell / grid.columns, (cell % grid.columns) as f64);
        let (sine, cosine) = (TAU * row as f64 / grid.rows as f64).sin_cos();
        Self([1.0, column, column * column, cosine, sine])
    }

    fn add(&mut self, other: &Self, weight: f64) {
        for (sum, value) in self.0.iter_mut().zip(other.0) {
            *sum += weight * value;
        }
    }

    /// Variance along rolling \[m²\] and concentration around the lead, with the extent of a cell.
    ///
    /// ```text
    /// σ_x² = ⟨x²⟩ − ⟨x⟩² + dx²/12,  ϱ = |⟨exp(2πi y/Λ)⟩| sin(π dy/Λ)/(π dy/Λ)                  [Spot-spread]
    /// ```
    ///
    /// The second does not depend on where the lead begins.
    fn spread(&self, grid: &SpotGrid) -> [f64; 2] {
        cite!("Spot-spread");
        let [weight, column, square, cosine, sine] = self.0;
        let x = grid.spacings[0].si();
        let mean = column / weight;
        let along = (square / weight - mean * mean).max(0.0) + 1.0 / 12.0;
        let around = (cosine.hypot(sine) / weight).min(1.0);
        [along * x * x, around * spread_over_a_cell(grid.rows)]
    }
}

/// A component as the level falls.
#[derive(Default)]
struct Growing {
    /// First and last cell of its list, and number of cells.
    list: [usize; 3],
    top: usize,
    level: f64,
    children: Vec<usize>,
}

impl Growing {
    /// Whether it has just appeared at this level: cells of a plateau, and no peak.
    fn is_level(&self, level: f64) -> bool {
        self.children.is_empty() && self.level == level
    }
}

/// No cell, no component.
const NONE: usize = usize::MAX;

/// The components of the cells above a level that falls from cell to cell.
struct Forest {
    /// Component in which each cell was added.
    of_cell: Vec<usize>,
    /// Component of which a component is a part, or itself.
    joined: Vec<usize>,
    growing: Vec<Growing>,
    /// Cell behind each cell in the list of its component.
    next: Vec<usize>,
    /// Components that are complete, each after its parts, with their levels s.
    complete: Vec<(Growing, f64)>,
}

impl Forest {
    /// All components of the cells under pressure.
    fn new(pressure: &[f64], grid: &SpotGrid) -> Self {
        let mut cells: Vec<usize> = (0..pressure.len())
            .filter(|&cell| pressure[cell] > 0.0)
            .collect();
        cells.sort_by(|&a, &b| pressure[b].total_cmp(&pressure[a]).then(a.cmp(&b)));
        let mut forest = Self {
            of_cell: vec![NONE; pressure.len()],
            joined: Vec::new(),
            growing: Vec::new(),
            next: vec![NONE; pressure.len()],
            complete: Vec::new(),
        };
        for cell in cells {
            forest.add(cell, pressure[cell], grid.neighbours(cell));
        }
        for component in 0..forest.growing.len() {
            if forest.joined[component] == component {
                let whole = std::mem::take(&mut forest.growing[component]);
                forest.complete.push((whole, 0.0));
            }
        }
        forest
    }

    fn component(&mut self, cell: usize) -> usize {
        let mut component = self.of_cell[cell];
        while component != NONE && self.joined[component] != component {
            // Halves the way of the next search.
            self.joined[component] = self.joined[self.joined[component]];
            component = self.joined[component];
        }
        component
    }

    /// Adds a cell whose pressure is not above any added before.
    fn add(&mut self, cell: usize, level: f64, neighbours: impl Iterator<Item = usize>) {
        let (mut around, mut count) = ([NONE; 4], 0);
        for neighbour in neighbours {
            let component = self.component(neighbour);
            if component != NONE && !around[..count].contains(&component) {
                around[count] = component;
                count += 1;
            }
        }
        let around = &mut around[..count];
        if let [one] = around {
            let [_, last, cells] = &mut self.growing[*one].list;
            self.next[*last] = cell;
            (*last, *cells) = (cell, *cells + 1);
            self.of_cell[cell] = *one;
            return;
        }
        // Parts in the order of their places; cells of this level behind them.
        around.sort_by_key(|&c| (self.growing[c].is_level(level), self.growing[c].top));
        let Some(&first) = around.first() else {
            self.of_cell[cell] = self.growing.len();
            self.joined.push(self.growing.len());
            self.growing.push(Growing {
                list: [cell, cell, 1],
                top: cell,
                level,
                children: Vec::new(),
            });
            return;
        };
        let parts = around.iter().map(|&c| std::mem::take(&mut self.growing[c]));
        let mut parts: Vec<Growing> = parts.collect();
        let peaks = parts.iter().filter(|part| !part.is_level(level)).count();
        let lists: Vec<[usize; 3]> = parts.iter().map(|part| part.list).collect();
        let mut whole = if peaks > 1 {
            let children = self.complete.len()..self.complete.len() + peaks;
            self.complete
                .extend(parts.drain(..peaks).map(|part| (part, level)));
            Growing {
                top: cell,
                level,
                children: children.collect(),
                ..Growing::default()
            }
        } else {
            parts.swap_remove(0)
        };
        whole.list = [lists[0][0], cell, 1];
        for (k, list) in lists.iter().enumerate() {
            self.next[list[1]] = lists.get(k + 1).map_or(cell, |after| after[0]);
            whole.list[2] += list[2];
        }
        for component in around {
            self.joined[*component] = first;
        }
        self.of_cell[cell] = first;
        self.growing[first] = whole;
    }
}

struct SpotTree {
    grid: SpotGrid,
    /// Number of cells of the grid.
    points: usize,
    /// Cells under pressure in the order of the tree, and their pressures.
    cells: Vec<usize>,
    pressures: Vec<f64>,
    /// Every component after the one around it.
    nodes: Vec<TreeNode>,
    /// The leaves, by the places of their peaks.
    peaks: Vec<usize>,
}

/// p^m of a pressure, m = 1, 2.
fn powers(pressure: f64) -> [f64; 2] {
    [pressure, pressure * pressure]
}

/// m p^(m−1) of a pressure, m = 1, 2.
fn power_slopes(pressure: f64) -> [f64; 2] {
    [1.0, 2.0 * pressure]
}

impl SpotTree {
    /// The components of a contact, with the load and the ∫ p² dx of each.
    ///
    /// ```text
    /// f_ν = f_parent X_ν/Σ X,  q_ν = q_parent X²_ν/Σ X²,  X^m_ν = ∫_ν (p^m − s_ν^m) dx          [Spot-load]
    /// ```
    ///
    /// The sums are over the parts of the parent. A part that has just appeared carries nothing, and parts without
    /// pressure between them their own loads.
    fn new(pressure: &[f64], grid: &SpotGrid) -> Self {
        cite!("Spot-load");
        let Forest { next, complete, .. } = Forest::new(pressure, grid);
        let count = complete.len();
        let mut tree = Self {
            grid: *grid,
            points: pressure.len(),
            cells: Vec::new(),
            pressures: Vec::new(),
            nodes: Vec::with_capacity(count),
            peaks: Vec::new(),
        };
        let mut place = vec![0; if count > 0 { pressure.len() } else { 0 }];
        for (component, (growing, bottom)) in complete.into_iter().rev().enumerate() {
            let [first, _, cells] = growing.list;
            if bottom == 0.0 {
                let mut cell = first;
                for _ in 0..cells {
                    place[cell] = tree.cells.len();
                    tree.cells.push(cell);
                    tree.pressures.push(pressure[cell]);
                    cell = next[cell];
                }
            }
            tree.nodes.push(TreeNode {
                cells: place[first]..place[first] + cells,
                top: growing.top,
                levels: [growing.level, bottom],
                parent: component,
                children: growing
                    .children
                    .iter()
                    .map(|child| count - 1 - child)
                    .collect(),
                excess: [0.0; 2],
                content: [0.0; 2],
                sums: [0.0; 2],
                places: [SpotPlaces::default(); 2],
                spread: [0.0; 2],
            });
        }
        for at in 0..count {
            for child in tree.nodes[at].children.clone() {
                tree.nodes[child].parent = at;
            }
        }
        tree.peaks = (0..count)
            .filter(|&at| tree.nodes[at].children.is_empty())
            .collect();
        tree.peaks.sort_by_key(|&at| tree.nodes[at].top);
        tree.sum_up();
        tree
    }

    /// Excesses from the leaves to the root, then contents from the root to the leaves. All terms are positive.
    fn sum_up(&mut self) {
        let dx = self.grid.cell();
        let is_patch = self.grid.rows > 1;
        for at in (0..self.nodes.len()).rev() {
            let node = &self.nodes[at];
            let [top, bottom] = node.levels.map(powers);
            let mut excess = [0.0; 2];
            let mut places = [SpotPlaces::default(); 2];
            let parts = node.children.iter().map(|&k| &self.nodes[k]);
            let end = parts.clone().map(|part| part.cells.end).max();
            let own = end.unwrap_or(node.cells.start)..node.cells.end;
            for (p, cell) in self.pressures[own.clone()].iter().zip(&self.cells[own]) {
                let of_cell = powers(*p);
                for m in [0, 1] {
                    excess[m] += (of_cell[m] - bottom[m]) * dx;
                }
                if is_patch {
                    let place = SpotPlaces::new(*cell, &self.grid);
                    places[0].add(&place, 1.0);
                    places[1].add(&place, of_cell[0] - bottom[0]);
                }
            }
            for part in parts {
                let width = part.cells.len() as f64 * dx;
                for m in [0, 1] {
                    excess[m] += part.excess[m] + (top[m] - bottom[m]) * width;
                }
                places[0].add(&part.places[0], 1.0);
                places[1].add(&part.places[1], 1.0);
                places[1].add(&part.places[0], top[0] - bottom[0]);
            }
            (self.nodes[at].excess, self.nodes[at].places) = (excess, places);
        }
        for at in 0..self.nodes.len() {
            let node = &self.nodes[at];
            let (mut content, mut sums, mut spread) = (node.excess, [0.0; 2], [0.0; 2]);
            if node.parent != at {
                let around = &self.nodes[node.parent];
                for m in [0, 1] {
                    let all: f64 = around
                        .children
                        .iter()
                        .map(|k| self.nodes[*k].excess[m])
                        .sum();
                    content[m] = around.content[m] * node.excess[m] / all;
                }
                (sums, spread) = (around.sums, around.spread);
            }
            for m in [0, 1] {
                sums[m] += node.rise() * content[m];
            }
            if is_patch {
                let of_component = node.places[1].spread(&self.grid);
                for (sum, of_component) in spread.iter_mut().zip(of_component) {
                    *sum += node.rise() * content[0] * of_component;
                }
            }
            let node = &mut self.nodes[at];
            (node.content, node.sums, node.spread) = (content, sums, spread);
        }
    }

    /// The spot of a leaf.
    ///
    /// ```text
    /// F_k = Σ_ν (t_ν − s_ν) f_ν/P_k,  Q_k = Σ_ν (t_ν − s_ν) q_ν/P_k,  b_k = 32 F_k²/(3 π² Q_k)    [Spot-width]
    /// ```
    ///
    /// The sums are over the components that contain the peak, from the whole contact to the peak itself: F_k is the load of the
    /// component around the peak, as a mean over all levels of pressure up to it. In a Hertz contact of half width a,
    /// F = π a p₀/2 and Q = 4 a p₀²/3: b = 2a. Where the pressure between two peaks rises from zero, each is a contact of its
    /// own; where it reaches the lower peak, they are one.
    fn spot(&self, peak: usize) -> Spot {
        cite!("Spot-width");
        let node = &self.nodes[peak];
        let [load, squares] = node.joint();
        let ellipse = (self.grid.rows > 1).then(|| self.ellipse(node)).flatten();
        let of_line = SpotEllipse {
            mean_load: load,
            middle_load: load,
            axes: [HERTZ_WIDTH * load * load / squares, f64::INFINITY],
        };
        let found = ellipse.unwrap_or(of_line);
        let [width, length] = found.axes.map(Length::from_si);
        Spot {
            load: LineLoad::from_si(node.content[0]),
            joint_load: LineLoad::from_si(found.mean_load),
            width,
            length,
            middle_load: LineLoad::from_si(found.middle_load),
        }
    }

    /// The ellipse of a leaf on a patch; `None` if it is a ridge that is even along the lead. σ_x² and ϱ are means over the levels of
    /// pressure as F_k is, and over the loads of their components.
    fn ellipse(&self, node: &TreeNode) -> Option<SpotEllipse> {
        let [load, squares] = node.joint();
        let lead = self.grid.spacings[1].si() * self.grid.rows as f64;
        let [variance, concentration] = node.spread.map(|sum| sum / node.sums[0]);
        SpotEllipse::from_spot(&MeasuredSpot {
            load_over_squares: load * load * lead / squares,
            force: load * lead,
            deviation: variance.sqrt(),
            concentration,
            lead,
        })
    }

    fn gradient(&self, by_spots: &mut Iter<'_, BySpot>) -> Vec<f64> {
        let dx = self.grid.cell();
        let mut by_pressure = vec![0.0; self.points];
        // ∂J/∂f_ν, ∂J/∂q_ν, and Σ ∂J/∂F_k/P_k, Σ ∂J/∂Q_k/P_k over the peaks of a component
        let mut by_content = vec![[0.0; 2]; self.nodes.len()];
        let mut by_sums = vec![[0.0; 2]; self.nodes.len()];
        for (&at, [by_load, by_joint_load, by_width]) in self.peaks.iter().zip(by_spots) {
            let node = &self.nodes[at];
            let ([load, squares], peak) = (node.joint(), node.levels[0]);
            let width = HERTZ_WIDTH * load * load / squares;
            let by_joint = [
                by_joint_load + by_width * 2.0 * width / load,
                -by_width * width / squares,
            ];
            by_sums[at] = by_joint.map(|slope| slope / peak);
            by_content[at][0] = *by_load;
            by_pressure[node.top] -= (by_joint[0] * load + by_joint[1] * squares) / peak;
        }
        for at in (0..self.nodes.len()).rev() {
            let node = &self.nodes[at];
            if !node.children.is_empty() {
                let level = power_slopes(node.levels[0]);
                for m in [0, 1] {
                    let excess = |k: usize| self.nodes[k].excess[m];
                    let all: f64 = node.children.iter().map(|&k| excess(k)).sum();
                    let slopes = node.children.iter().map(|&k| by_content[k][m] * excess(k));
                    let mean = slopes.sum::<f64>() / all;
                    for &k in &node.children {
                        let by_excess = node.content[m] * (by_content[k][m] - mean) / all;
                        let cells = self.nodes[k].cells.clone();
                        by_pressure[node.top] -= by_excess * level[m] * cells.len() as f64 * dx;
                        self.add_powers(cells, m, by_excess, &mut by_pressure);
                        by_sums[at][m] += by_sums[k][m];
                    }
                    by_content[at][m] += mean;
                }
            }
            for m in [0, 1] {
                by_content[at][m] += node.rise() * by_sums[at][m];
                let by_level = by_sums[at][m] * node.content[m];
                by_pressure[node.top] += by_level;
                if node.parent != at {
                    by_pressure[self.nodes[node.parent].top] -= by_level;
                } else {
                    self.add_powers(node.cells.clone(), m, by_content[at][m], &mut by_pressure);
                }
            }
        }
        by_pressure
    }

    /// Adds the gradient of `by_excess` times ∫ p^(m + 1) dx over `cells`.
    fn add_powers(&self, cells: Range<usize>, m: usize, by_excess: f64, sum: &mut [f64]) {
        for (cell, p) in self.cells[cells.clone()].iter().zip(&self.pressures[cells]) {
            sum[*cell] += by_excess * power_slopes(*p)[m] * self.grid.cell();
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    const SPACING: f64 = 0.05e-6;

    fn spots(cells: &[f64]) -> Vec<Spot> {
        spots_of(
            cells,
            &SpotGrid::line(cells.len(), Length::from_si(SPACING)),
        )
    }

    /// Pressures of a Hertz contact, all of them above zero.
    fn hertz(half: f64, peak: f64) -> Vec<f64> {
        let cells = (-2000..=2000).map(|i| f64::from(i) * SPACING / half);
        let cells = cells.map(|x| peak * (1.0 - x * x).max(0.0).sqrt());
        cells.filter(|p| *p > 0.0).collect()
    }

    fn close(found: f64, expected: f64, tolerance: f64) -> bool {
        (found / expected - 1.0).abs() < tolerance
    }

    #[test]
    fn a_spot_with_hertz_pressure_has_the_width_of_the_hertz_contact() {
        let [half, peak] = [12e-6, 1.3e9];
        let [spot] = spots(&hertz(half, peak))[..] else {
            panic!("one peak");
        };
        // The sum over cells misses the integral of the root at its ends by (dx/a)^1.5.
        let error = (SPACING / half).powf(1.5);
        assert!(close(spot.load.si(), 0.5 * PI * half * peak, error));
        assert!(close(spot.width.si(), 2.0 * half, error));
        assert!(close(spot.joint_load.si(), spot.load.si(), 1e-15));
        // Even pressure over a strip: 32/(3 π²) = 1.081 of its width.
        assert!(close(
            spots(&[1e9; 4])[0].width.si(),
            4.323_036e-6 * 0.05,
            1e-6
        ));
    }

    #[test]
    fn spots_that_touch_are_those_of_two_contacts_and_become_one_as_the_valley_fills() {
        let (first, second) = (hertz(12e-6, 1.3e9), hertz(5e-6, 0.8e9));
        let joined = |valley: f64| [&first[..], &[valley], &second[..]].concat();
        let touching = spots(&joined(1.0));
        let apart = [spots(&first), spots(&second)].concat();
        assert_eq!(touching.len(), 2);
        for (a, b) in touching.iter().zip(&apart) {
            assert!(close(a.load.si(), b.load.si(), 1e-8));
            assert!(close(a.joint_load.si(), b.joint_load.si(), 1e-8));
            assert!(close(a.width.si(), b.width.si(), 1e-8));
        }
        // Two triangles: as the valley reaches the lower peak, this peak is part of the whole and carries nothing itself.
        let ridge = |valley: f64| [0.3, 0.6, 0.9, 0.6 + valley, 0.8, 0.4].map(|p| p * 1e9);
        let (before, after) = (spots(&ridge(0.2 - 1e-9)), spots(&ridge(0.2)));
        let ([high, low], [whole]) = (&before[..], &after[..]) else {
            panic!("two peaks become one: {before:?} {after:?}");
        };
        assert!(low.load.si() < 1e-7 * whole.load.si());
        for peak in [high, low] {
            assert!(close(peak.joint_load.si(), whole.load.si(), 1e-6));
            assert!(close(peak.width.si(), whole.width.si(), 1e-6));
        }
        // Half way between two equal peaks P, a valley of P/2: the whole counts for half of the levels.
        let equal = spots(&[2e9, 1e9, 2e9]);
        assert_eq!(equal[0], equal[1]);
        assert!(close(equal[0].load.si(), 2.5e9 * SPACING, 1e-14));
        assert!(close(
            equal[0].joint_load.si(),
            1.5 * 2.5e9 * SPACING,
            1e-14
        ));
    }

    /// Pressures of an elliptical Hertz contact with half axes \[m\] on a patch, its middle at a row, and the grid.
    fn ellipse(half_axes: [f64; 2], middle: usize) -> (Vec<f64>, SpotGrid) {
        let grid = SpotGrid {
            columns: 80,
            rows: 200,
            spacings: [0.5e-6, 0.4e-6].map(Length::from_si),
        };
        let pressure = |cell: usize| {
            let row = (cell / grid.columns + grid.rows - middle + grid.rows / 2) % grid.rows;
            let x = (cell % grid.columns) as f64 - 39.3;
            let y = row as f64 - (grid.rows / 2) as f64;
            let [x, y] = [0.5e-6 * x / half_axes[0], 0.4e-6 * y / half_axes[1]];
            1.3e9 * (1.0 - x * x - y * y).max(0.0).sqrt()
        };
        ((0..grid.columns * grid.rows).map(pressure).collect(), grid)
    }

    #[test]
    fn a_spot_with_the_pressure_of_an_elliptical_hertz_contact_has_its_axes() {
        // At any place along the lead, also where it lies over both of its ends.
        for (half_axes, middle) in [
            ([12e-6, 12e-6], 100),
            ([6e-6, 15e-6], 3),
            ([16e-6, 8e-6], 199),
        ] {
            let (pressure, grid) = ellipse(half_axes, middle);
            let [spot] = spots_of(&pressure, &grid)[..] else {
                panic!("one peak");
            };
            let force = 2.0 / 3.0 * PI * half_axes[0] * half_axes[1] * 1.3e9;
            assert!(close(spot.load.si() * 80e-6, force, 2e-3));
            let [a, b] = [spot.width, spot.length].map(|axis| 0.5 * axis.si());
            assert!(close(a, half_axes[0], 5e-3), "{a}");
            assert!(close(b, half_axes[1], 5e-3), "{b}");
            assert!(close(
                spot.joint_load.si() / spot.width.si(),
                2.0 / 3.0 * 1.3e9,
                5e-3
            ));
        }
    }

    #[test]
    fn a_patch_constant_along_the_lead_has_the_spots_of_its_line() {
        let line = RUN.map(|p| p * 1e9);
        let grid = SpotGrid {
            columns: line.len(),
            rows: 7,
            spacings: [SPACING, 3.0 * SPACING].map(Length::from_si),
        };
        let of_patch = spots_of(&line.repeat(7), &grid);
        assert_eq!(of_patch.len(), spots(&line).len());
        for (found, expected) in of_patch.iter().zip(spots(&line)) {
            assert!(close(found.load.si(), expected.load.si(), 1e-12));
            assert!(close(
                found.joint_load.si(),
                expected.joint_load.si(),
                1e-12
            ));
            assert!(close(found.width.si(), expected.width.si(), 1e-12));
            assert!(found.length.si().is_infinite());
        }
        // With a crest of other heights along the lead the spots still carry the whole load, and a short one has its length.
        let mut pressure = line.repeat(7);
        for cell in (0..4 * line.len()).step_by(5) {
            pressure[cell] *= 0.6 + 0.1 * (cell % 7) as f64;
        }
        pressure[5 * line.len() + 16] = 0.0;
        let uneven = spots_of(&pressure, &grid);
        let load: f64 = uneven.iter().map(|spot| spot.load.si()).sum();
        assert!(close(
            load,
            pressure.iter().sum::<f64>() * SPACING / 7.0,
            1e-12
        ));
        let mut alone = vec![0.0; pressure.len()];
        alone[2 * line.len() + 4] = 1e9;
        let [cell] = spots_of(&alone, &grid)[..] else {
            panic!("one peak");
        };
        // A cell with even pressure: 9/8 of its area, its sides in proportion but for the fourth moment around seven rows.
        let area = 0.25 * PI * cell.width.si() * cell.length.si();
        assert!(close(area, 1.125 * 3.0 * SPACING * SPACING, 1e-12));
        assert!(close(cell.length.si() / cell.width.si(), 3.0, 3e-3));
    }

    #[test]
    fn every_touching_cell_is_of_the_spot_to_which_the_pressure_rises() {
        // Two peaks with a joint foot, and a plateau as a valley; a row without pressure parts them from the third.
        let rows = [
            [0.1, 0.9, 0.3, 0.3, 0.8, 0.2],
            [0.1, 0.4, 0.3, 0.3, 0.2, 0.1],
            [0.0; 6],
            [0.0, 0.0, 0.5, 0.0, 0.0, 0.0],
            [0.0; 6],
        ];
        let grid = SpotGrid {
            columns: 6,
            rows: 5,
            spacings: [SPACING; 2].map(Length::from_si),
        };
        let found = spot_of_cells(&rows.concat(), &grid);
        let [a, b, c] = [0, 1, 2].map(Some);
        assert_eq!(found[..12], [a, a, a, b, b, b, a, a, a, b, b, b]);
        assert_eq!(found[12..].iter().flatten().count(), 1);
        assert_eq!(found[20], c);
    }

    /// A run with valleys inside valleys and a plateau at the pressure limit.
    const RUN: [f64; 18] = [
        0.2, 0.9, 0.5, 1.1, 1.4, 0.7, 0.95, 0.85, 1.6, 1.6, 1.3, 0.4, 0.3, 0.8, 0.6, 0.75, 0.1,
        0.35,
    ];

    /// Σ f (ln F + √b), in units of 1 GPa and the spacing.
    fn number(cells: &[f64]) -> f64 {
        let terms = spots(cells).into_iter().map(|spot| {
            let [f, joint] = [spot.load, spot.joint_load].map(|load| load.si() / (1e9 * SPACING));
            f * (joint.ln() + (spot.width.si() / SPACING).sqrt())
        });
        terms.sum()
    }

    #[test]
    fn the_gradient_of_the_spots_is_their_central_difference() {
        let cells = RUN.map(|p| p * 1e9);
        let by_spot = |spot: &Spot| {
            let unit = 1e9 * SPACING;
            let [f, joint] = [spot.load, spot.joint_load].map(|load| load.si() / unit);
            let root = (spot.width.si() / SPACING).sqrt();
            [
                (joint.ln() + root) / unit,
                f / joint / unit,
                0.5 * f / root / SPACING,
            ]
        };
        let by_spots: Vec<BySpot> = spots(&cells).iter().map(by_spot).collect();
        let gradient = pressure_gradient(&cells, Length::from_si(SPACING), by_spots.iter());
        for i in (0..cells.len()).filter(|i| RUN[*i] != 1.6) {
            let at = |step: f64| {
                let mut moved = cells;
                moved[i] += step;
                number(&moved)
            };
            let expected = (at(1e4) - at(-1e4)) / 2e4;
            assert!(close(gradient[i], expected, 1e-6), "{i}: {expected}");
        }
    }

    #[test]
    fn the_spots_are_continuous_in_every_pressure_and_carry_the_whole_load() {
        // Every cell passes all others: new peaks, valleys that change their cell, cells that leave.
        let cells = RUN.map(|p| p * 1e9);
        let step = 1e5;
        // Spots that join at once would move the number by 1; the steepest slope is 60 per GPa.
        const STEEPEST: f64 = 100.0;
        for i in 0..cells.len() {
            let at = |k: u32| {
                let mut moved = cells;
                moved[i] = step * f64::from(k);
                moved
            };
            let mut before = number(&at(0));
            for k in 1..20_000 {
                let moved = at(k);
                let load: f64 = spots(&moved).iter().map(|spot| spot.load.si()).sum();
                assert!(close(load, moved.iter().sum::<f64>() * SPACING, 1e-12));
                let now = number(&moved);
                // A step is 1e-4 GPa.
                assert!(
                    (now - before).abs() < STEEPEST * 1e-4,
                    "{i} at {k}: {before} {now}"
                );
                before = now;
            }
        }
    }
}
