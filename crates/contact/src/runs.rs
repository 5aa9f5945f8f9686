//! Runs of neighbouring points, and passes over them with the widest vectors of the machine.

use std::ops::Range;

/// Neighbouring points from the first to before the end.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(crate) struct Run {
    first: u32,
    end: u32,
}

impl Run {
    pub(crate) fn new(first: usize, end: usize) -> Self {
        Self {
            first: first as u32,
            end: end as u32,
        }
    }

    pub(crate) fn range(self) -> Range<usize> {
        self.first as usize..self.end as usize
    }

    pub(crate) fn points(self) -> usize {
        (self.end - self.first) as usize
    }
}

/// Runs a pass compiled for the widest vectors that this machine has. Every machine gives the same
/// result: the order of the operations does not change.
#[inline(always)]
pub(crate) fn vectorised<R>(pass: impl FnOnce() -> R) -> R {
    pulp::Arch::new().dispatch(pass)
}
