//! The coarse space of the preconditioner: one unknown per contact patch.
//!
//! The masked symbol |q| does not see the interaction between patches. The residual that it
//! leaves is averaged over each patch, and the even pressures on the patches that remove these
//! averages are added: iterations then hardly depend on the number of patches.
//!
//! K f = y − λ, Σf = 0 is solved by conjugate gradients. K is the sum of
//! - what passes through a grid of nodes: each patch spreads its force over them by cubic
//!   interpolation, and their displacement is a convolution;
//! - the difference to the exact mean displacement for near pairs.
//!
//! The preconditioner of this inner solution takes the patches as evenly spaced: a convolution over
//! their numbers. It needs some ten iterations however many patches there are.
//!
//! | symbol | meaning |
//! |---|---|
//! | K_IJ | mean displacement of patch I by unit force on patch J, see `contact_patches` |
//! | f, y | forces of the patches, mean residuals of the patches |
//! | h | cells between nodes |

use rustfft::FftPlanner;

use super::coarse_nodes::{Nodes, cubic_weights};
use super::contact_patches::{Patch, PatchKernel};
use crate::boundary::Boundary;
use crate::convolution::Buffers;
use crate::convolution::{Run, parts};

/// A single patch acts on no other.
const MIN_PATCHES: usize = 2;
/// Cells per patch below which patches are no coarser than the grid.
const MIN_CELLS_PER_PATCH: usize = 4;
/// Distance in nodes beyond which the nodes alone give the interaction of two patches.
const NEAR_NODES: f64 = 3.0;
/// Near pairs per patch beyond which patches are too crowded for the nodes.
const MAX_NEAR_PAIRS: usize = 16;
/// Residual of the inner solution over that it began with, of few patches and of many. At a tenth of these the outer
/// iterations are as many or one fewer, at five times these up to half as many again.
const INNER_TOLERANCES: [f64; 2] = [1e-2, 3e-3];
/// Most patches that are few.
const FEW_PATCHES: usize = 100;
/// Most iterations of the inner solution.
const INNER_ITERATIONS: usize = 40;

/// One unknown per patch, and what their interaction needs.
#[derive(Default)]
pub(crate) struct CoarseSpace {
    active: bool,
    planner: Option<FftPlanner<f64>>,
    grid: Option<Nodes>,
    patches: Vec<Patch>,
    /// First node of each patch, and where its weights begin; one more than patches.
    spans: Vec<Span>,
    weights: Vec<f64>,
    /// Pairs of patches and what their K differs from that through the nodes.
    near: Vec<(u32, u32, f64)>,
    diagonal: Vec<f64>,
    solution: Inner,
}

#[derive(Clone, Copy, Default)]
struct Span {
    node: usize,
    weight: usize,
}

/// Arrays of the inner solution: one value per patch.
#[derive(Default)]
struct Inner {
    force: Vec<f64>,
    residual: Vec<f64>,
    ascent: Vec<f64>,
    direction: Vec<f64>,
    image: Vec<f64>,
    buffers: Buffers,
}

impl CoarseSpace {
    /// Takes runs of free points as patches; false when a coarse space is of no use for them.
    pub(crate) fn prepare(&mut self, points: usize, boundary: Boundary, runs: &[Run]) -> bool {
        self.active = false;
        self.patches.clear();
        self.patches.extend(parts(runs).map(|(run, listed)| Patch {
            first: run.start,
            end: run.end,
            listed: listed.start,
        }));
        let count = self.patches.len();
        if count < MIN_PATCHES || count * MIN_CELLS_PER_PATCH > points {
            return false;
        }
        let kernel = PatchKernel {
            period: matches!(boundary, Boundary::Periodic(_)).then_some(points),
        };
        let fits = |grid: &Nodes| {
            grid.points == points
                && grid.boundary == boundary
                && count <= grid.inverse.points().min(grid.count)
                && grid.count <= 16 * count
        };
        if !self.grid.as_ref().is_some_and(fits) {
            let planner = self.planner.get_or_insert_with(FftPlanner::new);
            let buffers = &mut self.solution.buffers;
            self.grid = Some(Nodes::new(
                points,
                boundary,
                kernel,
                &self.patches,
                planner,
                buffers,
            ));
        }
        self.spread();
        self.active = self.find_near(kernel);
        self.active
    }

    /// Whether the patches are those of the points that are iterated on.
    pub(crate) fn is_active(&self) -> bool {
        self.active
    }

    /// The patches are no longer those of the points that are iterated on.
    pub(crate) fn dismiss(&mut self) {
        self.active = false;
    }

    /// Weights of the nodes by which each patch acts: means over its cells.
    fn spread(&mut self) {
        let Some(grid) = &self.grid else { return };
        self.spans.clear();
        self.weights.clear();
        for patch in &self.patches {
            let (node, last) = (grid.below(patch.first), grid.below(patch.end - 1));
            let begin = self.weights.len();
            self.spans.push(Span {
                node,
                weight: begin,
            });
            self.weights.resize(begin + last - node + 4, 0.0);
            let share = 1.0 / patch.points() as f64;
            for cell in patch.first..patch.end {
                let place = grid.place(cell);
                let below = place.floor();
                let first = begin + below as usize - node;
                let to = &mut self.weights[first..first + 4];
                for (weight, cubic) in to.iter_mut().zip(cubic_weights(place - below)) {
                    *weight += share * cubic;
                }
            }
        }
        self.spans.push(Span {
            node: 0,
            weight: self.weights.len(),
        });
    }

    /// The pairs that nodes do not resolve; false when they are too many.
    fn find_near(&mut self, kernel: PatchKernel) -> bool {
        let Some(grid) = &self.grid else { return false };
        let count = self.patches.len();
        let reach = NEAR_NODES * grid.step;
        self.near.clear();
        self.diagonal.clear();
        for (i, one) in self.patches.iter().enumerate() {
            let exact = kernel.mean(one, one, 0.0);
            self.diagonal
                .push(exact - self.through_nodes(grid, i, i, 0));
            for next in i + 1..i + count {
                let (j, wraps) = (next % count, next >= count);
                let shift = if wraps { grid.points } else { 0 };
                let other = &self.patches[j];
                if (wraps && kernel.period.is_none())
                    || (other.first + shift - one.end) as f64 > reach
                {
                    break;
                }
                if self.near.len() >= MAX_NEAR_PAIRS * count {
                    return false;
                }
                let exact = kernel.mean(one, other, shift as f64);
                let nodes = if wraps { grid.count } else { 0 };
                let rest = exact - self.through_nodes(grid, i, j, nodes);
                self.near.push((i as u32, j as u32, rest));
            }
        }
        true
    }

    /// K_IJ as given by the nodes, the nodes of patch J being `shift` further.
    fn through_nodes(&self, grid: &Nodes, i: usize, j: usize, shift: usize) -> f64 {
        let (one, other) = (self.span(i), self.span(j));
        let mut sum = 0.0;
        for (k, a) in one.1.iter().enumerate() {
            for (l, b) in other.1.iter().enumerate() {
                let lag = (one.0 + k).abs_diff(other.0 + shift + l);
                sum += a * b * grid.lag(lag);
            }
        }
        sum
    }

    /// First node and weights of a patch.
    fn span(&self, patch: usize) -> (usize, &[f64]) {
        let (span, next) = (self.spans[patch], self.spans[patch + 1]);
        (span.node, &self.weights[span.weight..next.weight])
    }

    /// Adds to `ascent` the even pressures on the patches that remove the means of `residual` over
    /// them. Both hold one value per listed point.
    pub(crate) fn correct(&mut self, residual: &[f64], ascent: &mut [f64]) {
        let mut inner = std::mem::take(&mut self.solution);
        inner.residual.clear();
        let mean =
            |patch: &Patch| residual[patch.places()].iter().sum::<f64>() / patch.points() as f64;
        inner.residual.extend(self.patches.iter().map(mean));
        self.solve(&mut inner);
        for (patch, force) in self.patches.iter().zip(&inner.force) {
            let pressure = force / patch.points() as f64;
            for z in &mut ascent[patch.places()] {
                *z += pressure;
            }
        }
        self.solution = inner;
    }

    /// K f = y − λ with Σf = 0, y being the residual to begin with.
    fn solve(&self, inner: &mut Inner) {
        let count = self.patches.len();
        for array in [&mut inner.force, &mut inner.direction] {
            array.clear();
            array.resize(count, 0.0);
        }
        inner.ascent.resize(count, 0.0);
        inner.image.resize(count, 0.0);
        remove_mean(&mut inner.residual);
        let tolerance = INNER_TOLERANCES[usize::from(count > FEW_PATCHES)];
        let goal = tolerance * tolerance * dot(&inner.residual, &inner.residual);
        let mut last = 0.0;
        for _ in 0..INNER_ITERATIONS {
            if dot(&inner.residual, &inner.residual) <= goal {
                return;
            }
            self.precondition(inner);
            let descent = dot(&inner.residual, &inner.ascent);
            let beta = if last > 0.0 { descent / last } else { 0.0 };
            last = descent;
            for (d, z) in inner.direction.iter_mut().zip(&inner.ascent) {
                *d = z + beta * *d;
            }
            self.displace(inner);
            let curvature = dot(&inner.direction, &inner.image);
            let length = descent / curvature;
            if !(length.is_finite() && length > 0.0) {
                return;
            }
            for (f, d) in inner.force.iter_mut().zip(&inner.direction) {
                *f += length * d;
            }
            for (r, u) in inner.residual.iter_mut().zip(&inner.image) {
                *r -= length * u;
            }
            remove_mean(&mut inner.residual);
        }
    }

    /// `ascent` by the symbol of evenly spaced patches.
    fn precondition(&self, inner: &mut Inner) {
        let Some(grid) = &self.grid else { return };
        let count = self.patches.len();
        let signal = inner.buffers.signal(grid.inverse.points());
        signal[..count].copy_from_slice(&inner.residual);
        signal[count..].fill(0.0);
        let whole = Run::new(0, grid.inverse.points());
        grid.inverse.filter_runs(&mut inner.buffers, 1.0, &[whole]);
        inner.ascent.copy_from_slice(inner.buffers.signal(count));
        remove_mean(&mut inner.ascent);
    }

    /// `image` = K·`direction`
    fn displace(&self, inner: &mut Inner) {
        let Some(grid) = &self.grid else { return };
        let signal = inner.buffers.signal(grid.filter.points());
        signal.fill(0.0);
        for (i, force) in inner.direction.iter().enumerate() {
            let (node, weights) = self.span(i);
            for (k, weight) in weights.iter().enumerate() {
                signal[grid.wrap(node + k)] += force * weight;
            }
        }
        let whole = Run::new(0, grid.filter.points());
        grid.filter.filter_runs(&mut inner.buffers, 1.0, &[whole]);
        let signal = inner.buffers.signal(grid.filter.points());
        for (i, image) in inner.image.iter_mut().enumerate() {
            let (node, weights) = self.span(i);
            let values = weights.iter().enumerate();
            let far: f64 = values.map(|(k, w)| w * signal[grid.wrap(node + k)]).sum();
            *image = far + self.diagonal[i] * inner.direction[i];
        }
        for &(i, j, rest) in &self.near {
            let (i, j) = (i as usize, j as usize);
            inner.image[i] += rest * inner.direction[j];
            inner.image[j] += rest * inner.direction[i];
        }
    }
}

fn dot(a: &[f64], b: &[f64]) -> f64 {
    a.iter().zip(b).map(|(a, b)| a * b).sum()
}

fn remove_mean(values: &mut [f64]) {
    let mean = values.iter().sum::<f64>() / values.len() as f64;
    for value in values {
        *value -= mean;
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Patches of one to nine cells in clusters, as a rough contact has.
    fn patches(points: usize, count: usize) -> Vec<Run> {
        let mut state = 7_u64;
        let mut random = |most: u64| {
            state = state
                .wrapping_mul(6_364_136_223_846_793_005)
                .wrapping_add(1);
            (state >> 33) % most
        };
        let room = (points / count) as u64;
        let mut runs = vec![];
        for number in 0..count {
            let first = number * points / count + random(room / 2) as usize;
            let length = 1 + random(9).min(room / 3) as usize;
            runs.push(Run::new(first, first + length));
        }
        runs
    }

    #[test]
    fn patches_interact_as_the_double_sums_of_the_kernel_say() {
        for boundary in [
            Boundary::FreeEnds,
            Boundary::Periodic(crate::PeriodicKernel::Strip),
        ] {
            let points = 8_192;
            let runs = patches(points, 150);
            let mut coarse = CoarseSpace::default();
            assert!(coarse.prepare(points, boundary, &runs));
            let count = coarse.patches.len();
            let mut inner = std::mem::take(&mut coarse.solution);
            let kernel = PatchKernel {
                period: (boundary != Boundary::FreeEnds).then_some(points),
            };
            inner.image = vec![0.0; count];
            inner.direction = (0..count).map(|i| (i as f64 * 0.7).sin()).collect();
            remove_mean(&mut inner.direction);
            coarse.displace(&mut inner);
            for (i, one) in coarse.patches.iter().enumerate() {
                let exact: f64 = coarse
                    .patches
                    .iter()
                    .zip(&inner.direction)
                    .map(|(other, force)| {
                        let shifts: &[f64] = match kernel.period {
                            Some(_) => &[0.0, -8192.0, 8192.0],
                            None => &[0.0],
                        };
                        let distance =
                            |shift: &f64| (other.first as f64 + shift - one.first as f64).abs();
                        let shift = shifts
                            .iter()
                            .copied()
                            .min_by(|a, b| distance(a).total_cmp(&distance(b)))
                            .unwrap();
                        force * kernel.mean(one, other, shift)
                    })
                    .sum();
                // Forces to 1 on 150 patches; a pair beyond three nodes errs by up to 7e-3.
                assert!(
                    (inner.image[i] - exact).abs() < 0.02,
                    "{boundary:?} {i}: {} {exact}",
                    inner.image[i]
                );
            }
        }
    }
}
