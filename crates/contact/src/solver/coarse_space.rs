//! The coarse space of the preconditioner: one unknown per contact patch.
//!
//! The symbol |q|, masked to the free points, ignores the interaction between patches. The residual
//! that it leaves is averaged over each patch, and the uniform pressures on the patches that remove
//! these averages are added (deflation; Tang et al. 2009): the number of iterations then hardly
//! depends on the number of patches.
//!
//! K f = y − λ, Σf = 0 is solved by conjugate gradients. K is the sum of
//! - the interaction through a grid of nodes: each patch distributes its force to the nodes by cubic
//!   interpolation, and the displacement of the nodes is a convolution;
//! - for near pairs, the difference between the exact mean displacement and the one by the nodes.
//!
//! The preconditioner of this inner solution assumes evenly spaced patches, for which K is a
//! convolution over their indices. It needs some ten iterations at any number of patches.
//!
//! Few patches are solved directly instead (`direct_patches`).
//!
//! | symbol | meaning |
//! |---|---|
//! | K_IJ | mean displacement of patch I by unit force on patch J, see `contact_patches` |
//! | f, y | forces of the patches, mean residuals of the patches |
//! | h | cells between nodes |

use asperity_core::numerics::FourierNumber;
use rustfft::FftPlanner;

use super::coarse_nodes::{Nodes, cubic_weights};
use super::contact_patches::{Patch, PatchKernel};
use super::direct_patches::DirectPatches;
use crate::boundary::Boundary;
use crate::convolution::{Buffers, Convolution, Run, parts};

/// Fewest patches: the force of a single patch is the load.
const MIN_PATCHES: usize = 2;
/// Cells per patch below which the patches are not coarser than the grid.
const MIN_CELLS_PER_PATCH: usize = 4;
/// Distance in nodes above which the nodes resolve the interaction of two patches: to 7e-3, where the kernel
/// falls by 4 per factor e of distance.
const NEAR_NODES: f64 = 3.0;
/// Near pairs per patch above which the coarse space is given up: patches in clusters have up to n near
/// pairs each, and the correction would cost O(n²).
const MAX_NEAR_PAIRS: usize = 16;
/// Residual of the inner solution relative to its first one, for few and for many patches. A tenth of these values
/// saves at most one outer iteration; five times these values cost up to half as many again.
const INNER_TOLERANCES: [f64; 2] = [1e-2, 3e-3];
/// Number of patches up to which the first of the inner tolerances applies.
const FEW_PATCHES: usize = 100;
/// Most iterations of the inner solution: four times as many as it usually takes. A correction that is not
/// converged still preconditions.
const INNER_ITERATIONS: usize = 40;

/// One unknown per patch, and the operators of their interaction.
#[derive(Default)]
pub(crate) struct CoarseSpace {
    /// Whether the patches match the free points of the iteration.
    active: bool,
    planner: Option<FftPlanner<f64>>,
    grid: Option<Nodes>,
    patches: Vec<Patch>,
    /// First node and first weight of each patch, and the end of all weights.
    spans: Vec<Span>,
    /// Interpolation weights of all patches, one patch after the other.
    weights: Vec<f64>,
    /// Near pairs I, J with the difference between K_IJ and its value by the nodes.
    near: Vec<(u32, u32, f64)>,
    /// The same difference for K_II.
    diagonal: Vec<f64>,
    solution: Inner,
    direct: DirectPatches,
    /// Whether the patches are solved directly.
    is_direct: bool,
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
    /// Makes a patch of each run of free points; false when a coarse space does not help.
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
        self.is_direct = self.direct.prepare(points, boundary, &self.patches);
        if self.is_direct {
            self.active = true;
            return true;
        }
        let kernel = PatchKernel {
            period: matches!(boundary, Boundary::Periodic(_)).then_some(points),
        };
        // The nodes of an earlier set are reused while they are enough for the patches, and not 16 times as
        // many: most sets then plan no transforms.
        let fits = |grid: &Nodes| {
            grid.points == points
                && grid.boundary == boundary
                && count <= grid.inverse.points().min(grid.count)
                && grid.count <= 16 * count
        };
        if !self.grid.as_ref().is_some_and(fits) {
            let planner = self.planner.get_or_insert_with(f64::planner);
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
        self.weigh_nodes();
        self.active = self.correct_near_pairs(kernel);
        self.active
    }

    /// Whether the patches match the free points of the iteration.
    pub(crate) fn is_active(&self) -> bool {
        self.active
    }

    /// Makes the nodes again for the next patches.
    pub(crate) fn forget_nodes(&mut self) {
        self.grid = None;
    }

    /// The coarse space without what it has planned before: without its history.
    pub(crate) fn anew(self) -> Self {
        Self {
            direct: self.direct,
            ..Self::default()
        }
    }

    /// Switches the coarse space off until the next [`prepare`](Self::prepare).
    pub(crate) fn deactivate(&mut self) {
        self.active = false;
    }

    /// Computes the interpolation weights of each patch: means over its cells.
    fn weigh_nodes(&mut self) {
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
                let position = grid.position(cell);
                let below = position.floor();
                let first = begin + below as usize - node;
                let to = &mut self.weights[first..first + 4];
                for (weight, cubic) in to.iter_mut().zip(cubic_weights(position - below)) {
                    *weight += share * cubic;
                }
            }
        }
        self.spans.push(Span {
            node: 0,
            weight: self.weights.len(),
        });
    }

    /// Computes the corrections of the pairs that the nodes do not resolve; false when they are too many.
    fn correct_near_pairs(&mut self, kernel: PatchKernel) -> bool {
        let Some(grid) = &self.grid else { return false };
        let count = self.patches.len();
        let reach = NEAR_NODES * grid.step;
        self.near.clear();
        self.diagonal.clear();
        for (i, one) in self.patches.iter().enumerate() {
            let exact = kernel.mean(one, one, 0.0);
            self.diagonal
                .push(exact - self.through_nodes(grid, i, i, 0));
            // Neighbours to the right, around the period if there is one, until the first far one.
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
                let correction = exact - self.through_nodes(grid, i, j, nodes);
                self.near.push((i as u32, j as u32, correction));
            }
        }
        true
    }

    /// K_IJ by the nodes, with the nodes of patch J moved on by `shift`.
    fn through_nodes(&self, grid: &Nodes, i: usize, j: usize, shift: usize) -> f64 {
        let (one, other) = (self.span(i), self.span(j));
        let mut sum = 0.0;
        for (k, a) in one.1.iter().enumerate() {
            for (l, b) in other.1.iter().enumerate() {
                let lag = (one.0 + k).abs_diff(other.0 + shift + l);
                sum += a * b * grid.kernel(lag);
            }
        }
        sum
    }

    /// First node and interpolation weights of a patch.
    fn span(&self, patch: usize) -> (usize, &[f64]) {
        let (span, next) = (self.spans[patch], self.spans[patch + 1]);
        (span.node, &self.weights[span.weight..next.weight])
    }

    /// Adds to `ascent` the uniform pressures on the patches that remove the means of `residual` over
    /// them. Both hold one value per listed point.
    pub(crate) fn correct(&mut self, residual: &[f64], ascent: &mut [f64]) {
        let mut inner = std::mem::take(&mut self.solution);
        inner.residual.clear();
        let means = self.patches.iter().map(|patch| patch.mean_of(residual));
        inner.residual.extend(means);
        if self.is_direct {
            self.direct.solve(&inner.residual, &mut inner.force);
        } else {
            self.solve(&mut inner);
        }
        self.press(&inner.force, ascent);
        self.solution = inner;
    }

    /// Adds to `ascent` the uniform pressures on the patches that remove the means of `residual` less the displacement by `ascent`
    /// over them, without this displacement at every point; false where the patches are not solved directly.
    ///
    /// K and the displacement A are symmetric: the mean of A·z over a patch is the sum of z times the displacement by unit force on it.
    pub(crate) fn correct_displaced(&mut self, residual: &[f64], ascent: &mut [f64]) -> bool {
        if !self.is_direct {
            return false;
        }
        let mut inner = std::mem::take(&mut self.solution);
        inner.residual.clear();
        let left = |(i, patch): (usize, &Patch)| {
            patch.mean_of(residual) - self.direct.mean_displacement(i, ascent)
        };
        let left = self.patches.iter().enumerate().map(left);
        inner.residual.extend(left);
        self.direct.solve(&inner.residual, &mut inner.force);
        self.press(&inner.force, ascent);
        self.solution = inner;
        true
    }

    /// Adds uniform pressures with the `forces` of the patches.
    fn press(&self, forces: &[f64], ascent: &mut [f64]) {
        for (patch, force) in self.patches.iter().zip(forces) {
            let pressure = force / patch.points() as f64;
            for z in &mut ascent[patch.listed_range()] {
                *z += pressure;
            }
        }
    }

    /// Solves K f = y − λ with Σf = 0 by conjugate gradients; y is the residual at the start.
    ///
    /// Removing the mean from residual and direction keeps Σf = 0 and eliminates λ. K is then positive
    /// definite, although the logarithmic kernel is negative at large distances.
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
        let mut last_descent = 0.0;
        for _ in 0..INNER_ITERATIONS {
            if dot(&inner.residual, &inner.residual) <= goal {
                return;
            }
            self.precondition(inner);
            let descent = dot(&inner.residual, &inner.ascent);
            let beta = if last_descent > 0.0 {
                descent / last_descent
            } else {
                0.0
            };
            last_descent = descent;
            for (d, z) in inner.direction.iter_mut().zip(&inner.ascent) {
                *d = z + beta * *d;
            }
            self.displace(inner);
            let curvature = dot(&inner.direction, &inner.image);
            let length = descent / curvature;
            // Round-off has used up the descent: the forces so far are the best to be had.
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

    /// Computes `ascent` from `residual` with the inverse symbol of evenly spaced patches.
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
            let by_nodes: f64 = values.map(|(k, w)| w * signal[grid.wrap(node + k)]).sum();
            *image = by_nodes + self.diagonal[i] * inner.direction[i];
        }
        for &(i, j, correction) in &self.near {
            let (i, j) = (i as usize, j as usize);
            inner.image[i] += correction * inner.direction[j];
            inner.image[j] += correction * inner.direction[i];
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

    /// Patches of one to nine cells in clusters, as in a rough contact.
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
