//! Loops compiled for the widest vectors of the machine.

/// Numbers of double precision in a vector of most machines: a loop over a multiple of it has no passes of single numbers.
pub const VECTOR_WIDTH: usize = 4;

/// Runs a loop compiled for the widest vectors of the machine, or, without the feature `simd`, for the vectors of every machine.
/// The result is the same on every machine: the order of the operations does not change. What the loop calls must be inlined into it.
#[inline(always)]
pub fn vectorised<R>(pass: impl FnOnce() -> R) -> R {
    #[cfg(feature = "simd")]
    {
        pulp::Arch::new().dispatch(pass)
    }
    #[cfg(not(feature = "simd"))]
    pass()
}
