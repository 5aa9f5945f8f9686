//! Grids of lines and of patches with the operators of an iteration on them: the one difference between both for the solver.

use std::collections::BTreeMap;

use asperity_core::numerics::{FourierNumber, good_fft_length};

use crate::boundary::{Boundary, PeriodicKernel};
use crate::cells::Cells;
use crate::convolution::{Buffers, Convolution, EvenFilter, PlaneFilter};
use crate::half_plane::{displacement_filter, inverse_filter};
use crate::rectangle_kernel::{lead_waves, plane_symbol};
use crate::strip_kernel::{column_of_period, strip_column};

/// Number of points above which the operators of only one grid size are cached. A displacement
/// operator takes 18 bytes per point besides its plan, more than the arrays of the problem itself.
pub(crate) const LARGE_GRID: usize = 1 << 18;

/// Operators of a kind of grid, made from kernels that it keeps.
pub(crate) trait Grid: Default {
    /// Product with a kernel.
    type Filter<T: FourierNumber>: Convolution<T>;
    /// Whether a run of points is a contact patch of the coarse space, which knows the kernel of lines.
    const RUNS_ARE_PATCHES: bool;

    /// The kernel, without unit.
    fn displacement(
        &mut self,
        cells: Cells,
        boundary: Boundary,
        buffers: &mut Buffers,
    ) -> Self::Filter<f64>;

    /// A filter in single precision.
    fn single(filter: &Self::Filter<f64>) -> Self::Filter<f32>;

    /// |q|, nearly the inverse of the kernel.
    fn inverse(cells: Cells) -> Self::Filter<f32>;

    /// Drops the kernels.
    fn forget(&mut self);
}

/// Grid of a line.
#[derive(Default)]
pub(crate) struct LineGrid {
    /// Kernel of free ends of the largest grid so far; smaller grids use its first cells.
    column: Vec<f64>,
}

impl Grid for LineGrid {
    type Filter<T: FourierNumber> = EvenFilter<T>;
    const RUNS_ARE_PATCHES: bool = true;

    fn displacement(
        &mut self,
        cells: Cells,
        boundary: Boundary,
        buffers: &mut Buffers,
    ) -> EvenFilter {
        let column = &mut self.column;
        let filter = displacement_filter(
            &mut f64::planner(),
            cells.columns,
            boundary,
            column,
            buffers,
        );
        if column.len() > LARGE_GRID {
            self.forget();
        }
        filter
    }

    fn single(filter: &EvenFilter) -> EvenFilter<f32> {
        filter.single(&mut f32::planner())
    }

    fn inverse(cells: Cells) -> EvenFilter<f32> {
        inverse_filter(&mut f32::planner(), cells.columns)
    }

    fn forget(&mut self) {
        self.column = vec![];
    }
}

/// Grid of a patch, periodic along the lead.
#[derive(Default)]
pub(crate) struct PlaneGrid {
    /// Kernels of the waves along the lead by rows and aspect, with the number of their lags along rolling.
    kernels: BTreeMap<(usize, u64), (usize, Vec<f64>)>,
}

/// Periods along the lead after which the kernel of a wave has fallen to exp(−2π·5) of its value.
const REACH: f64 = 5.0;

impl PlaneGrid {
    /// Kernel of the waves along the lead at the lags of `columns` cells along rolling or more.
    fn kernel(&mut self, cells: Cells, lags: usize) -> &(usize, Vec<f64>) {
        let key = (cells.rows, cells.aspect.to_bits());
        let made = || (lags, lead_waves([lags, cells.rows], cells.aspect));
        let kernel = self.kernels.entry(key).or_insert_with(made);
        if kernel.0 < lags {
            *kernel = made();
        }
        kernel
    }
}

impl Grid for PlaneGrid {
    type Filter<T: FourierNumber> = PlaneFilter<T>;
    const RUNS_ARE_PATCHES: bool = false;

    fn displacement(&mut self, cells: Cells, boundary: Boundary, _: &mut Buffers) -> PlaneFilter {
        let Cells {
            columns,
            rows,
            aspect,
        } = cells;
        let shape = cells.shape();
        match boundary {
            Boundary::FreeEnds => {
                let (lags, waves) = self.kernel(cells, columns);
                let line = strip_column(columns);
                PlaneFilter::from_kernel(shape, good_fft_length(2 * columns - 1), |lag, wave| {
                    match wave {
                        _ if lag >= columns => 0.0,
                        0 => line[lag],
                        wave => waves[(wave - 1) * lags + lag],
                    }
                })
            }
            Boundary::Periodic(PeriodicKernel::Strip) => {
                let reach = (REACH * aspect * rows as f64).ceil() as usize;
                let (lags, waves) = self.kernel(cells, columns + reach);
                let line = column_of_period(columns);
                PlaneFilter::from_kernel(shape, columns, |lag, wave| match wave {
                    0 => line[lag],
                    wave => {
                        let row = &waves[(wave - 1) * lags..wave * lags];
                        let images =
                            |first: usize| row[first..].iter().step_by(columns).sum::<f64>();
                        images(lag) + images(columns - lag)
                    }
                })
                .without_mean()
            }
            Boundary::Periodic(PeriodicKernel::Spectral) => {
                PlaneFilter::from_symbol(shape, columns, |along, across| {
                    plane_symbol([along, across], shape, aspect)
                })
            }
        }
    }

    fn single(filter: &PlaneFilter) -> PlaneFilter<f32> {
        filter.single(&mut f32::planner())
    }

    /// As the inverse of a line, with the length of the wave vector.
    fn inverse(cells: Cells) -> PlaneFilter<f32> {
        let period = good_fft_length(cells.columns);
        let lead = cells.rows as f64 * cells.aspect;
        PlaneFilter::from_symbol(cells.shape(), period, |along, across| {
            match (along, across) {
                (0, 0) => 0.5 / period as f64,
                _ => (along as f64 / period as f64).hypot(across as f64 / lead),
            }
        })
    }

    fn forget(&mut self) {
        self.kernels.clear();
    }
}

/// Kernel of a patch at the lags along rolling and along the lead, row after row: the displacement by one cell.
pub(crate) fn plane_kernel(cells: Cells, boundary: Boundary) -> Vec<f64> {
    let mut buffers = Buffers::default();
    let filter = PlaneGrid::default().displacement(cells, boundary, &mut buffers);
    buffers.reserve(&filter);
    let mut cell = vec![0.0; cells.points()];
    cell[0] = 1.0;
    filter.filter(&mut buffers, 1.0, &cell);
    buffers.signal(cells.points()).to_vec()
}
