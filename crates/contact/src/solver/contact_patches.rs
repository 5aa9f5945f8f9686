//! Contact patches and their interaction: the mean displacement of one patch by uniform pressure on
//! another.
//!
//! | symbol | meaning | unit |
//! |---|---|---|
//! | C(k) | strip kernel at k cells (see `strip_kernel`), over the half cell | - |
//! | G | second sum of C: G(k+1) − 2·G(k) + G(k−1) = C(k), G(0) = 0, even | - |
//! | a, b; l | first cell of a patch and the cell after its last; cells b − a | - |
//! | K_IJ | mean displacement of patch I by unit force, uniform over patch J | - |
//!
//! The double sum of the kernel over the cells of two patches is a combination of four values of its
//! second sum G, at any size of the patches. G is known in closed form up to terms of k⁻⁴.

use asperity_core::cite;

use crate::strip_kernel::{periodic_rest, strip};

/// Contiguous points of F.
#[derive(Debug, Clone, Copy)]
pub(crate) struct Patch {
    pub(crate) first: usize,
    pub(crate) end: usize,
    /// Index of the first point among the listed points.
    pub(crate) listed: usize,
}

impl Patch {
    pub(crate) fn points(&self) -> usize {
        self.end - self.first
    }

    /// Position of the middle in cells.
    fn middle(&self) -> f64 {
        0.5 * (self.first + self.end - 1) as f64
    }

    /// Indices among the listed points.
    pub(crate) fn listed_range(&self) -> std::ops::Range<usize> {
        self.listed..self.listed + self.points()
    }

    /// Mean over the patch of numbers of the listed points.
    pub(crate) fn mean_of(&self, listed: &[f64]) -> f64 {
        listed[self.listed_range()].iter().sum::<f64>() / self.points() as f64
    }
}

/// Constant term of the asymptotic series of G, computed by summing the kernel numerically.
const SERIES_CONSTANT: f64 = 0.099_793_23;

/// G(k) = −2k²·ln 2k + k² + (ln 2k + 1)/6 + 7/(1440·k²) + 0.09979, to 5e-4 at k = 1 and better than
/// 1e-6 from k = 8 on.
fn second_sum(k: f64) -> f64 {
    if k == 0.0 {
        return 0.0;
    }
    let (square, logarithm) = (k * k, (2.0 * k.abs()).ln());
    square * (1.0 - 2.0 * logarithm)
        + (logarithm + 1.0) / 6.0
        + 7.0 / (1440.0 * square)
        + SERIES_CONSTANT
}

/// Kernel of a grid at any distance in cells, up to a constant. A constant cancels: the forces of the
/// patches sum to zero.
#[derive(Debug, Clone, Copy)]
pub(crate) struct PatchKernel {
    /// Cells in a period; `None` for free ends.
    pub(crate) period: Option<usize>,
}

impl PatchKernel {
    /// C at a distance of `cells`.
    pub(crate) fn at(&self, cells: f64) -> f64 {
        strip(2.0 * cells) + self.images(cells)
    }

    /// Contribution of the periodic images, up to a constant.
    fn images(&self, cells: f64) -> f64 {
        match self.period {
            Some(period) => periodic_rest(cells, period) - periodic_rest(0.0, period),
            None => 0.0,
        }
    }

    /// K_IJ = [G(b−c) − G(b−d) − G(a−c) + G(a−d)]/(l_I·l_J)                               `[Patch-1]`
    ///
    /// for the patches a..b and c..d, the second moved on by `shift` cells.
    ///
    /// The images are far away and smooth, so their contribution is taken at the middles.
    pub(crate) fn mean(&self, one: &Patch, other: &Patch, shift: f64) -> f64 {
        cite!("Patch-1");
        let [a, b] = [one.first, one.end].map(|place| place as f64);
        let [c, d] = [other.first, other.end].map(|place| place as f64 + shift);
        let sum = second_sum(b - c) - second_sum(b - d) - second_sum(a - c) + second_sum(a - d);
        let cells = (one.points() * other.points()) as f64;
        sum / cells + self.images((other.middle() + shift - one.middle()).abs())
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn patch(first: usize, end: usize) -> Patch {
        let listed = 0;
        Patch { first, end, listed }
    }

    #[test]
    fn the_mean_displacement_between_patches_is_the_double_sum_of_the_kernel() {
        let column = crate::strip_kernel::strip_column(3_000);
        let kernel = PatchKernel { period: None };
        for (one, other) in [
            (patch(10, 11), patch(10, 11)),
            (patch(10, 11), patch(12, 13)),
            (patch(10, 14), patch(16, 40)),
            (patch(0, 700), patch(0, 700)),
            (patch(5, 300), patch(1_000, 2_900)),
        ] {
            let pairs = (one.first..one.end)
                .flat_map(|i| (other.first..other.end).map(move |j| i.abs_diff(j)));
            let sum: f64 = pairs.map(|lag| column[lag]).sum();
            let exact = sum / (one.points() * other.points()) as f64;
            let mean = kernel.mean(&one, &other, 0.0);
            // Four values of G, which is least exact, to 5e-4, at k = 1.
            assert!(
                (mean - exact).abs() < 2e-3,
                "{one:?} {other:?}: {mean} {exact}"
            );
        }
    }

    #[test]
    fn the_periodic_kernel_differs_from_that_of_the_grid_by_a_constant() {
        let column = crate::strip_kernel::column_of_period(256);
        let kernel = PatchKernel { period: Some(256) };
        for lag in [0, 1, 7, 100, 128] {
            let difference = column[lag] - column[0] - kernel.at(lag as f64);
            assert!(difference.abs() < 1e-12, "{lag}: {difference:e}");
        }
        // From one end of the period to the other.
        let wrapped = kernel.mean(&patch(250, 254), &patch(1, 4), 256.0);
        let inside = kernel.mean(&patch(50, 54), &patch(57, 60), 0.0);
        assert!((wrapped - inside).abs() < 1e-9);
    }
}
