//! Places of the points that are written.

/// Places of the points that are written.
#[derive(Clone, Copy)]
pub(super) enum Places<'a> {
    /// Spacing \[m\].
    Even(f64),
    /// x of each \[m\].
    Own(&'a [f64]),
}
