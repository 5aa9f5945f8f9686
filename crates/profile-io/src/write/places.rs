//! Positions of the written points.

/// Positions of the written points.
#[derive(Clone, Copy)]
pub(super) enum Places<'a> {
    /// Spacing \[m\].
    Even(f64),
    /// Individual x \[m\].
    Own(&'a [f64]),
}
