//! The nodes through which contact patches that are not neighbours act on each other.
//!
//! | symbol | meaning |
//! |---|---|
//! | h | cells between nodes |
//! | t | place between two nodes, 0 ≤ t < 1 |

use rustfft::FftPlanner;
use rustfft::num_complex::Complex;

use super::contact_patches::{Patch, PatchKernel};
use crate::boundary::Boundary;
use crate::convolution::{Buffers, EvenFilter};

/// Nodes that stencils may need beyond those of free ends.
const BEYOND: usize = 4;
/// Patches whose distances are examined to find what neighbours have in common.
const SAMPLE: usize = 512;
/// Neighbours whose mean distance is taken from the sample.
const NEIGHBOURS: usize = 8;
/// Least symbol of the preconditioner, over the difference of the kernel from a patch to the next.
const FLOOR: f64 = 0.25;

/// The nodes of a grid, their interaction, and the preconditioner over the numbers of patches.
pub(crate) struct Nodes {
    pub(crate) points: usize,
    pub(crate) boundary: Boundary,
    pub(crate) count: usize,
    /// h
    pub(crate) step: f64,
    pub(crate) filter: EvenFilter,
    column: Vec<f64>,
    pub(crate) inverse: EvenFilter,
}

impl Nodes {
    pub(crate) fn new(
        points: usize,
        boundary: Boundary,
        kernel: PatchKernel,
        patches: &[Patch],
        planner: &mut FftPlanner<f64>,
        buffers: &mut Buffers,
    ) -> Self {
        let count = (2 * patches.len() + BEYOND).next_power_of_two();
        // Free ends need the nodes of the stencils beyond them.
        let between = if kernel.period.is_some() {
            count
        } else {
            count - BEYOND
        };
        let step = points as f64 / between as f64;
        let distance = |lag: usize| step * if lag == 0 { 0.5 } else { lag as f64 };
        let column: Vec<f64> = (0..count)
            .map(|lag| match kernel.period {
                Some(_) => kernel.at(distance(lag.min(count - lag))),
                None => kernel.at(distance(lag)),
            })
            .collect();
        let filter = match kernel.period {
            Some(_) => EvenFilter::from_period(planner, &column, buffers),
            None => EvenFilter::from_column(planner, &column, buffers),
        };
        let inverse = inverse(points, kernel, patches, planner);
        buffers.reserve(&filter);
        buffers.reserve(&inverse);
        Self {
            points,
            boundary,
            count,
            step,
            filter,
            column,
            inverse,
        }
    }

    /// Place of a cell among the nodes. There is one node before the first place, so that the four
    /// nodes of its interpolation begin with the one of the number that is next below.
    pub(crate) fn place(&self, cell: usize) -> f64 {
        (cell as f64 + 0.5) / self.step
    }

    pub(crate) fn below(&self, cell: usize) -> usize {
        self.place(cell).floor() as usize
    }

    pub(crate) fn wrap(&self, node: usize) -> usize {
        if node >= self.count {
            node - self.count
        } else {
            node
        }
    }

    pub(crate) fn lag(&self, lag: usize) -> f64 {
        match self.column.get(lag) {
            Some(&value) => value,
            None => self.column[lag.abs_diff(self.count).min(self.count - 1)],
        }
    }
}

/// Inverse of the interaction of patches at the mean distance, by its symbol over their numbers.
fn inverse(
    points: usize,
    kernel: PatchKernel,
    patches: &[Patch],
    planner: &mut FftPlanner<f64>,
) -> EvenFilter {
    let count = patches.len();
    let length = (2 * count).next_power_of_two();
    let every = count.div_ceil(SAMPLE);
    let mean = |neighbour: usize| {
        let pairs = patches.iter().zip(&patches[neighbour..]).step_by(every);
        let (sum, pairs) = pairs.fold((0.0, 0.0), |(sum, pairs), (one, other)| {
            (sum + kernel.mean(one, other, 0.0), pairs + 1.0)
        });
        sum / pairs
    };
    let extent = match kernel.period {
        Some(period) => period,
        None => patches[count - 1].end - patches[0].first,
    };
    let apart = extent.min(points) as f64 / count as f64;
    let free = PatchKernel { period: None };
    let mut row: Vec<Complex<f64>> = (0..length)
        .map(|number| match number.min(length - number) {
            near if near <= NEIGHBOURS.min(count - 1) => mean(near).into(),
            far => free.at(apart * far as f64).into(),
        })
        .collect();
    let floor = FLOOR * (row[0] - row[1]).re.abs();
    planner.plan_fft_forward(length).process(&mut row);
    EvenFilter::from_symbol(planner, length, length, |wave| {
        1.0 / row[wave.max(1)].re.max(floor)
    })
}

/// Lagrange's weights of the nodes −1, 0, 1 and 2 at 0 ≤ t < 1.
pub(crate) fn cubic_weights(t: f64) -> [f64; 4] {
    [
        -t * (t - 1.0) * (t - 2.0) / 6.0,
        (t + 1.0) * (t - 1.0) * (t - 2.0) / 2.0,
        -(t + 1.0) * t * (t - 2.0) / 2.0,
        (t + 1.0) * t * (t - 1.0) / 6.0,
    ]
}
