//! Touching spots of a rough contact: one for each peak of the pressure.
//!
//! A run of neighbouring cells under pressure may have several peaks. Above a level of pressure its cells fall into components;
//! they form a tree, whose root is the whole run and whose leaves are the peaks.
//!
//! | symbol | meaning | unit |
//! |---|---|---|
//! | t_ν | pressure at which a component parts in two; of a leaf its peak P_k | Pa |
//! | s_ν | pressure at which it joins its neighbour: t of the component around both; 0 of a whole run | Pa |
//! | f_ν, q_ν | load and ∫ p² dx of a component | N/m, Pa²·m |
//! | F_k, Q_k | the same of the contact that a peak is part of | N/m, Pa²·m |
//! | b_k | its width | m |
//!
//! All of them are continuous functions of the pressures. They have kinks where another cell becomes the lowest between two
//! peaks or the highest of a peak, or where a peak joins another neighbour first.

use std::f64::consts::PI;
use std::ops::Range;
use std::slice::Iter;

use asperity_core::cite;
use asperity_core::quantity::{Length, LineLoad};
use serde::Serialize;

/// Width of a Hertz contact times ∫ p² dx over (∫ p dx)²: 2a · (4/3) a p₀²/(π a p₀/2)².
const HERTZ_WIDTH: f64 = 32.0 / (3.0 * PI * PI);

/// A touching spot: a peak of the pressure.
#[derive(Debug, Clone, Copy, PartialEq, Serialize)]
pub struct Spot {
    /// Load f_k per metre of face. The loads of all spots add up to the load of the contact.
    pub load: LineLoad,
    /// Load F_k of the contact that it is part of: f_k if the pressure falls to zero on both sides.
    pub joint_load: LineLoad,
    /// Width b_k of the Hertz contact with this joint load and the same ∫ p² dx.
    pub width: Length,
}

/// Derivatives of a number over the load, the joint load and the width of a spot.
pub(crate) type BySpot = [f64; 3];

/// Appends the spots under the pressures `cells` of one run \[Pa\], `spacing` apart, from one end to the other.
pub(crate) fn push_spots(cells: &[f64], spacing: Length, spots: &mut Vec<Spot>) {
    let tree = SpotTree::of(cells, spacing.si());
    spots.extend(tree.peaks.iter().map(|&peak| tree.nodes[peak].spot()));
}

/// Derivative over the pressures `cells` of a run of a number whose derivatives over the next spots are `by_spots`.
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
    cells: &[f64],
    spacing: Length,
    by_spots: &mut Iter<'_, BySpot>,
) -> Vec<f64> {
    cite!("Spot-adjoint");
    SpotTree::of(cells, spacing.si()).gradient(by_spots)
}

/// A component of the cells above a level.
struct Node {
    cells: Range<usize>,
    /// Cell of the lowest pressure between the two components inside it; of a leaf the cell of its peak.
    top: usize,
    /// t, s
    levels: [f64; 2],
    parent: usize,
    children: Option<[usize; 2]>,
    /// Excesses X, X² over s.
    excess: [f64; 2],
    /// f, q
    content: [f64; 2],
    /// Σ (t − s) f and Σ (t − s) q from the root to here.
    sums: [f64; 2],
}

impl Node {
    fn new(cells: Range<usize>, parent: usize, bottom: f64) -> Self {
        let top = cells.start;
        Self {
            cells,
            top,
            levels: [bottom; 2],
            parent,
            children: None,
            excess: [0.0; 2],
            content: [0.0; 2],
            sums: [0.0; 2],
        }
    }

    fn rise(&self) -> f64 {
        self.levels[0] - self.levels[1]
    }

    /// F and Q of a leaf.
    fn joint(&self) -> [f64; 2] {
        self.sums.map(|sum| sum / self.levels[0])
    }

    /// The spot of a leaf.
    ///
    /// ```text
    /// F_k = Σ_ν (t_ν − s_ν) f_ν/P_k,  Q_k = Σ_ν (t_ν − s_ν) q_ν/P_k,  b_k = 32 F_k²/(3 π² Q_k)    [Spot-width]
    /// ```
    ///
    /// The sums are over the components that contain the peak, from the whole run to the peak itself: F_k is the load of the
    /// component around the peak, as a mean over all levels of pressure up to it. In a Hertz contact of half width a,
    /// F = π a p₀/2 and Q = 4 a p₀²/3: b = 2a. Where the pressure between two peaks rises from zero, each is a contact of its
    /// own; where it reaches the lower peak, they are one.
    fn spot(&self) -> Spot {
        cite!("Spot-width");
        let [load, squares] = self.joint();
        Spot {
            load: LineLoad::from_si(self.content[0]),
            joint_load: LineLoad::from_si(load),
            width: Length::from_si(HERTZ_WIDTH * load * load / squares),
        }
    }
}

/// A local minimum of the pressure, with the next higher ones on both sides of it.
struct Saddle {
    cell: usize,
    beyond: [Option<usize>; 2],
}

/// Local minima of a run, each below those beyond it, and the lowest one.
fn saddles(cells: &[f64]) -> (Option<usize>, Vec<Saddle>) {
    let mut all: Vec<Saddle> = Vec::new();
    let mut open: Vec<usize> = Vec::new();
    let mut falls = false;
    for (cell, pair) in cells.windows(2).enumerate() {
        if pair[1] < pair[0] {
            falls = true;
        } else if pair[1] > pair[0] && falls {
            falls = false;
            let mut left = None;
            while let Some(&last) = open.last() {
                if cells[all[last].cell] <= cells[cell] {
                    all[last].beyond[1] = Some(all.len());
                    break;
                }
                left = open.pop();
            }
            open.push(all.len());
            all.push(Saddle {
                cell,
                beyond: [left, None],
            });
        }
    }
    (open.first().copied(), all)
}

struct SpotTree<'a> {
    cells: &'a [f64],
    dx: f64,
    /// Every component after the one around it.
    nodes: Vec<Node>,
    /// The leaves, from one end to the other.
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

impl<'a> SpotTree<'a> {
    /// The components of a run, with the load and the ∫ p² dx of each.
    ///
    /// ```text
    /// f_ν = f_parent X_ν/Σ X,  q_ν = q_parent X²_ν/Σ X²,  X^m_ν = ∫_ν (p^m − s_ν^m) dx          [Spot-load]
    /// ```
    ///
    /// The sums are over the two parts of the parent. A part that has just appeared carries nothing, and parts without
    /// pressure between them their own loads.
    fn of(cells: &'a [f64], dx: f64) -> Self {
        cite!("Spot-load");
        let (lowest, saddles) = saddles(cells);
        let mut nodes = vec![Node::new(0..cells.len(), 0, 0.0)];
        let mut peaks = Vec::with_capacity(saddles.len() + 1);
        let mut open = vec![(0, lowest)];
        while let Some((at, saddle)) = open.pop() {
            let Some(saddle) = saddle.map(|k| &saddles[k]) else {
                let range = nodes[at].cells.clone();
                let higher = |best: usize, i: usize| if cells[i] > cells[best] { i } else { best };
                let top = range.fold(nodes[at].top, higher);
                (nodes[at].top, nodes[at].levels[0]) = (top, cells[top]);
                peaks.push(at);
                continue;
            };
            let level = cells[saddle.cell];
            let Range { mut start, mut end } = nodes[at].cells;
            while cells[start] <= level {
                start += 1;
            }
            while cells[end - 1] <= level {
                end -= 1;
            }
            let parts = [start..saddle.cell, saddle.cell + 1..end];
            let children = [nodes.len(), nodes.len() + 1];
            nodes.extend(parts.map(|part| Node::new(part, at, level)));
            let node = &mut nodes[at];
            (node.top, node.levels[0]) = (saddle.cell, level);
            node.children = Some(children);
            open.push((children[1], saddle.beyond[1]));
            open.push((children[0], saddle.beyond[0]));
        }
        let mut tree = Self {
            cells,
            dx,
            nodes,
            peaks,
        };
        tree.sum_up();
        tree
    }

    /// Excesses from the leaves to the root, then contents from the root to the leaves. All terms are positive.
    fn sum_up(&mut self) {
        for at in (0..self.nodes.len()).rev() {
            let node = &self.nodes[at];
            let [top, bottom] = node.levels.map(powers);
            let mut excess = [0.0; 2];
            let mut from = node.cells.start;
            let parts = node
                .children
                .map(|children| children.map(|k| &self.nodes[k]));
            let mut add = |cells: Range<usize>| {
                for p in &self.cells[cells] {
                    let of_cell = powers(*p);
                    for m in [0, 1] {
                        excess[m] += (of_cell[m] - bottom[m]) * self.dx;
                    }
                }
            };
            for part in parts.iter().flatten() {
                add(from..part.cells.start);
                from = part.cells.end;
            }
            add(from..node.cells.end);
            for part in parts.iter().flatten() {
                let width = part.cells.len() as f64 * self.dx;
                for m in [0, 1] {
                    excess[m] += part.excess[m] + (top[m] - bottom[m]) * width;
                }
            }
            self.nodes[at].excess = excess;
        }
        for at in 0..self.nodes.len() {
            let node = &self.nodes[at];
            let around = &self.nodes[node.parent];
            let (mut content, mut sums) = (node.excess, [0.0; 2]);
            if let Some(pair) = around.children.filter(|_| at > 0) {
                for m in [0, 1] {
                    let both: f64 = pair.iter().map(|k| self.nodes[*k].excess[m]).sum();
                    content[m] = around.content[m] * node.excess[m] / both;
                    sums[m] = around.sums[m];
                }
            }
            for m in [0, 1] {
                sums[m] += node.rise() * content[m];
            }
            (self.nodes[at].content, self.nodes[at].sums) = (content, sums);
        }
    }

    fn gradient(&self, by_spots: &mut Iter<'_, BySpot>) -> Vec<f64> {
        let mut by_pressure = vec![0.0; self.cells.len()];
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
            if let Some(pair) = node.children {
                let level = power_slopes(node.levels[0]);
                for m in [0, 1] {
                    let [first, second] = pair.map(|k| self.nodes[k].excess[m]);
                    let both = first + second;
                    let [a, b] = pair.map(|k| by_content[k][m]);
                    let mean = (a * first + b * second) / both;
                    by_content[at][m] += mean;
                    for (k, slope) in pair.into_iter().zip([a, b]) {
                        let by_excess = node.content[m] * (slope - mean) / both;
                        let cells = self.nodes[k].cells.clone();
                        by_pressure[node.top] -=
                            by_excess * level[m] * cells.len() as f64 * self.dx;
                        self.add_powers(cells, m, by_excess, &mut by_pressure);
                        by_sums[at][m] += by_sums[k][m];
                    }
                }
            }
            for m in [0, 1] {
                by_content[at][m] += node.rise() * by_sums[at][m];
                let by_level = by_sums[at][m] * node.content[m];
                by_pressure[node.top] += by_level;
                if at > 0 {
                    by_pressure[self.nodes[node.parent].top] -= by_level;
                }
            }
        }
        for m in [0, 1] {
            self.add_powers(0..self.cells.len(), m, by_content[0][m], &mut by_pressure);
        }
        by_pressure
    }

    /// Adds the gradient of `by_excess` times ∫ p^(m + 1) dx over `cells`.
    fn add_powers(&self, cells: Range<usize>, m: usize, by_excess: f64, sum: &mut [f64]) {
        let pressures = self.cells[cells.clone()].iter();
        for (sum, p) in sum[cells].iter_mut().zip(pressures) {
            *sum += by_excess * power_slopes(*p)[m] * self.dx;
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    const SPACING: f64 = 0.05e-6;

    fn spots(cells: &[f64]) -> Vec<Spot> {
        let mut spots = Vec::new();
        for run in cells.split(|p| *p == 0.0).filter(|run| !run.is_empty()) {
            push_spots(run, Length::from_si(SPACING), &mut spots);
        }
        spots
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
        let gradient = pressure_gradient(&cells, Length::from_si(SPACING), &mut by_spots.iter());
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
