//! The form of a flank, parted from the roughness of its trace.

use asperity_core::quantity::Length;
use asperity_gear::MeasuredForm;
use serde::Serialize;

/// Form of a flank as its trace shows it.
#[derive(Debug, Clone, PartialEq, Serialize)]
#[non_exhaustive]
pub struct FlankForm {
    /// Cut-off λ_f between form and roughness.
    pub cutoff: Length,
    /// Missing material at the tip end of the active flank, against where least is missing.
    pub at_tip: Length,
    /// The same at the root end.
    pub at_root: Length,
    /// The form over the roll length.
    pub form: MeasuredForm,
}
