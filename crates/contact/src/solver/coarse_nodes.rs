//! Grid of nodes through which distant contact patches act on each other, and the preconditioner of
//! the patches.
//!
//! Interpolating the forces of the patches to evenly spaced nodes turns their interaction into a
//! convolution, as in particle-mesh methods (Hockney and Eastwood 1988): n patches cost O(n log n)
//! and not O(n²). Near pairs, which the nodes do not resolve, are corrected in `coarse_space`.
//!
//! | symbol | meaning |
//! |---|---|
//! | h | cells between nodes |
//! | t | position between two nodes, 0 ≤ t < 1 |

use asperity_core::numerics::FourierNumber;
use rustfft::FftPlanner;
use rustfft::num_complex::Complex;

use super::contact_patches::{Patch, PatchKernel};
use crate::boundary::Boundary;
use crate::convolution::{Buffers, EvenFilter};

/// Extra nodes of free ends: a cubic stencil reaches one node before and two nodes after its interval,
/// and the last interval needs its own end.
const STENCIL_NODES: usize = 4;
/// Pairs of patches sampled for each mean interaction of the preconditioner; more do not change a mean
/// that is only used to precondition.
const SAMPLE: usize = 512;
/// Neighbours whose mean interaction is sampled. Farther patches interact as points at the mean distance.
const NEIGHBOURS: usize = 8;
/// Least symbol of the preconditioner, relative to the difference of the kernel between a patch and its
/// neighbour. The symbol of patches that are not evenly spaced may fall to zero or below, where its
/// inverse would not be positive definite.
const FLOOR: f64 = 0.25;

/// The nodes of a grid, their interaction, and the preconditioner of the patches.
pub(crate) struct Nodes {
    pub(crate) points: usize,
    pub(crate) boundary: Boundary,
    pub(crate) count: usize,
    /// h
    pub(crate) step: f64,
    /// Displacement of the nodes by their forces.
    pub(crate) filter: EvenFilter,
    /// Kernel of `filter`.
    column: Vec<f64>,
    /// The preconditioner: a filter over the indices of the patches.
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
        // Two nodes per patch or more: fewer would leave most pairs to the correction of near pairs.
        let count = (2 * patches.len() + STENCIL_NODES).next_power_of_two();
        let intervals = if kernel.period.is_some() {
            count
        } else {
            count - STENCIL_NODES
        };
        let step = points as f64 / intervals as f64;
        // At distance zero the kernel is infinite for a force in one node. Any finite value serves there,
        // as the correction of near pairs removes it.
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

    /// Position of a cell in units of the node spacing. One node lies before position zero, so the four
    /// nodes of a stencil begin at the index [`below`](Self::below).
    pub(crate) fn position(&self, cell: usize) -> f64 {
        (cell as f64 + 0.5) / self.step
    }

    pub(crate) fn below(&self, cell: usize) -> usize {
        self.position(cell).floor() as usize
    }

    pub(crate) fn wrap(&self, node: usize) -> usize {
        if node >= self.count {
            node - self.count
        } else {
            node
        }
    }

    /// Kernel between nodes `lag` apart; a lag beyond the last node wraps around the period.
    pub(crate) fn kernel(&self, lag: usize) -> f64 {
        match self.column.get(lag) {
            Some(&value) => value,
            None => self.column[lag.abs_diff(self.count).min(self.count - 1)],
        }
    }
}

/// Inverse of the interaction of evenly spaced patches, a filter over their indices.
///
/// The row holds the mean interaction of the sampled neighbours, then the kernel at multiples of the
/// mean distance; its symbol is inverted wave by wave.
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
    let spacing = extent.min(points) as f64 / count as f64;
    let free = PatchKernel { period: None };
    let mut row: Vec<Complex<f64>> = (0..length)
        .map(|number| match number.min(length - number) {
            near if near <= NEIGHBOURS.min(count - 1) => mean(near).into(),
            far => free.at(spacing * far as f64).into(),
        })
        .collect();
    let floor = FLOOR * (row[0] - row[1]).re.abs();
    f64::forward(planner, length).process(&mut row);
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
