//! Division of long traces into blocks for Fourier transforms that fit into the cache.

use asperity_core::numerics::good_fft_length;

/// Minimum length of a block transform: the overhead of shorter ones is too large.
const SHORTEST: usize = 8192;
/// Transform length in units of the kernel reach: 14 of 16 reaches are new points. From 8 to 24 the time is the same.
const REACHES: usize = 16;
/// Length from which a transform has the fewest reaches with as little time: the memory of a transform is four times that of its
/// points.
const LONG: usize = 1 << 18;
const FEW_REACHES: usize = 8;

/// Block sizes of a trace.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(crate) struct Blocks {
    /// Points of a transform, with small prime factors.
    pub length: usize,
    /// New points of each block; all points if there is only one block.
    pub step: usize,
}

impl Blocks {
    /// Block sizes for `n` points and a kernel that extends `m` points to either side.
    pub(crate) fn new(n: usize, m: usize) -> Self {
        let whole = good_fft_length(n + m);
        let block = good_fft_length((REACHES * m).min(LONG.max(FEW_REACHES * m)).max(SHORTEST));
        if whole <= block {
            return Self {
                length: whole,
                step: n,
            };
        }
        Self {
            length: block,
            step: block - 2 * m,
        }
    }
}
