//! Block transforms of long traces, sized to stay in the cache.

use asperity_core::numerics::good_fft_length;

/// Shortest transform of a trace in blocks: shorter ones do not pay their overhead.
const SHORTEST: usize = 8192;
/// Transform length in reaches: of 16 reaches 14 are new. From 8 to 24 the time is the same.
const REACHES: usize = 16;

/// Transform of a trace.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(crate) struct Blocks {
    /// Points of a transform, a good length.
    pub length: usize,
    /// New points of each block; all points when there is one.
    pub step: usize,
}

impl Blocks {
    /// For `n` points and a kernel that reaches `m` points to either side.
    pub(crate) fn of(n: usize, m: usize) -> Self {
        let whole = good_fft_length(n + m);
        let block = good_fft_length((REACHES * m).max(SHORTEST));
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
