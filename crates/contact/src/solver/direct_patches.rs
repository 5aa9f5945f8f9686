//! Direct solution of the forces of few contact patches.
//!
//! The displacement of every listed point by unit force on each patch is a difference of two sums of the kernel. Its means over the
//! patches are the matrix K, which is factored once for each set: a solution then costs n² products and no transform.
//!
//! | symbol | meaning |
//! |---|---|
//! | C(k) | strip kernel at k cells (see `strip_kernel`), over the half cell |
//! | S(k) | sum of C from 0 to below k |
//! | u_I, a, b | displacement by unit force on patch I, its first cell and the cell after its last |
//! | K_IJ | mean of u_I over patch J |
//! | f, y | forces of the patches, mean residuals of the patches |

use asperity_core::cite;
use asperity_core::numerics::Cholesky;

use super::contact_patches::Patch;
use crate::boundary::Boundary;
use crate::convolution::{Lanes, vectorised};
use crate::strip_kernel::strip_column;

/// Most patches that are solved directly (own choice): a factor of n patches takes n³/6 products.
const MOST_PATCHES: usize = 48;
/// Most displacements that are stored (own choice): a solution takes as many products, instead of a transform.
const MOST_VALUES: usize = 1 << 14;

/// Displacements by forces on few patches, and the factor of their means.
#[derive(Default)]
pub(crate) struct DirectPatches {
    /// S(k), for the grids solved so far.
    sums: Vec<f64>,
    listed: usize,
    /// u_I of every listed point, one patch after the other.
    displacements: Vec<f64>,
    /// Factor of K with Σf = 0, of all patches but the last.
    factor: Cholesky,
}

impl DirectPatches {
    /// Factors K of some patches of a grid with free ends; false when it is not solved directly.
    ///
    /// ```text
    /// u_I(i) = [S(b − i) − S(a − i)]/(b − a)
    /// ```
    pub(crate) fn prepare(&mut self, points: usize, boundary: Boundary, patches: &[Patch]) -> bool {
        let count = patches.len();
        self.listed = patches.iter().map(Patch::points).sum();
        if boundary != Boundary::FreeEnds
            || count > MOST_PATCHES
            || count * self.listed > MOST_VALUES
        {
            return false;
        }
        cite!("Patch-1");
        if self.sums.len() <= points {
            let mut sum = 0.0;
            let sums = strip_column(points).into_iter().map(|value| {
                sum += value;
                sum
            });
            self.sums = std::iter::once(0.0).chain(sums).collect();
        }
        self.displace(patches);
        self.factor(patches)
    }

    /// Computes u_I at the listed points.
    fn displace(&mut self, patches: &[Patch]) {
        let sums = &*self.sums;
        self.displacements.clear();
        for pressed in patches {
            let (a, b) = (pressed.first, pressed.end);
            let share = 1.0 / pressed.points() as f64;
            for at in patches {
                let cells = at.first..at.end;
                if at.end <= a {
                    let to = |i: usize| share * (sums[b - i] - sums[a - i]);
                    self.displacements.extend(cells.map(to));
                } else if at.first >= b {
                    let to = |i: usize| share * (sums[i + 1 - a] - sums[i + 1 - b]);
                    self.displacements.extend(cells.map(to));
                } else {
                    // C(0) is in both sums.
                    let to = |i: usize| share * (sums[i + 1 - a] + sums[b - i] - sums[1]);
                    self.displacements.extend(cells.map(to));
                }
            }
        }
    }

    /// Factors K with the force of the last patch as the negative sum of the others; false when it is not positive definite.
    fn factor(&mut self, patches: &[Patch]) -> bool {
        let last = patches.len() - 1;
        let mean = |i: usize, j: usize| patches[j].mean_of(self.of_patch(i));
        let to_last: Vec<f64> = (0..last).map(|i| mean(i, last)).collect();
        let of_last = mean(last, last);
        let element = |i: usize, j: usize| mean(i, j) - to_last[i] - to_last[j] + of_last;
        let factor = Cholesky::new(last, element, 0.0);
        let is_definite = factor.is_some();
        self.factor = factor.unwrap_or_default();
        is_definite
    }

    fn of_patch(&self, patch: usize) -> &[f64] {
        &self.displacements[patch * self.listed..(patch + 1) * self.listed]
    }

    /// Mean over a patch of the displacement by pressures of the listed points.
    pub(crate) fn mean_displacement(&self, patch: usize, pressure: &[f64]) -> f64 {
        let mut lanes = Lanes::new([0.0]);
        vectorised(
            #[inline(always)]
            || {
                lanes.fold([self.of_patch(patch), pressure], |[sum], [u, p]| {
                    [sum + u * p]
                });
            },
        );
        lanes.total()[0]
    }

    /// Solves K f = y − λ with Σf = 0.
    pub(crate) fn solve(&self, means: &[f64], forces: &mut Vec<f64>) {
        forces.clear();
        let Some((of_last, means)) = means.split_last() else {
            return;
        };
        forces.extend(means.iter().map(|mean| mean - of_last));
        self.factor.solve(forces);
        forces.push(-forces.iter().sum::<f64>());
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_forces_give_the_patches_the_same_mean_displacement_as_the_residual() {
        let mut listed = 0;
        let patches = [(3, 9), (11, 12), (40, 47), (60, 90)].map(|(first, end)| {
            listed += end - first;
            Patch {
                first,
                end,
                listed: listed + first - end,
            }
        });
        let mut direct = DirectPatches::default();
        assert!(direct.prepare(100, Boundary::FreeEnds, &patches));
        let residual: Vec<f64> = (0..listed).map(|i| (0.7 * i as f64).sin()).collect();
        let means = patches.map(|patch| patch.mean_of(&residual));
        let mut forces = Vec::new();
        direct.solve(&means, &mut forces);
        assert!(forces.iter().sum::<f64>().abs() < 1e-14);
        // The displacement point by point, with the kernel itself.
        let column = strip_column(100);
        let mut pressure = Vec::new();
        for (patch, force) in patches.iter().zip(&forces) {
            pressure.extend(vec![force / patch.points() as f64; patch.points()]);
        }
        let cells: Vec<usize> = patches.iter().flat_map(|p| p.first..p.end).collect();
        let displacement: Vec<f64> = cells
            .iter()
            .map(|i| {
                let parts = cells.iter().zip(&pressure);
                parts.map(|(j, p)| column[i.abs_diff(*j)] * p).sum()
            })
            .collect();
        let datum = patches[0].mean_of(&displacement) - means[0];
        for (i, (patch, mean)) in patches.iter().zip(means).enumerate() {
            let of_patch = patch.mean_of(&displacement);
            assert!((of_patch - mean - datum).abs() < 1e-12, "{i}");
            assert!((direct.mean_displacement(i, &pressure) - of_patch).abs() < 1e-12);
        }
    }

    #[test]
    fn many_patches_and_periods_are_not_solved_directly() {
        let patch = |i: usize| Patch {
            first: 4 * i,
            end: 4 * i + 1,
            listed: i,
        };
        let patches: Vec<Patch> = (0..60).map(patch).collect();
        let mut direct = DirectPatches::default();
        assert!(!direct.prepare(300, Boundary::FreeEnds, &patches));
        assert!(direct.prepare(300, Boundary::FreeEnds, &patches[..40]));
        let period = Boundary::Periodic(crate::PeriodicKernel::Strip);
        assert!(!direct.prepare(300, period, &patches[..40]));
    }
}
