//! Extent of a run.

/// Extent of a run; each level includes those before it.
#[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord)]
pub(crate) enum Detail {
    /// Losses; the rough contacts only where the losses hang on them.
    Losses,
    /// The rough contact at every offset.
    Contacts,
    /// Fields and stress of the first offset.
    Fields,
}
