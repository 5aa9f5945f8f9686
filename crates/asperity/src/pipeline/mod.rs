//! The order of the model, the paper's Fig. 2, as functions between plain values.
//!
//! ```text
//! case -> Mesh -> windows of the flanks -> Contacts -> lubricated positions -> pictures -> result
//! ```
//!
//! [`Mesh`](crate::mesh::Mesh) has the positions along the path with load, speeds and Hertz contact.
//! [`Contacts`](crate::contacts::Contacts) has the rough contact of
//! every window at every offset of the traces; it depends on neither oil, speed nor temperature. At one operating
//! point every position is lubricated: film, Λ*, regime, load share, friction of film, lubricated asperities and
//! boundary layer. Then the sums: cycle mean at each offset, mean and spread over the offsets. Pictures of a contact,
//! with the stress below it, are computed afterwards. The bulk temperature is a fixed point of these functions
//! ([`Run::operating_case`](crate::Run::operating_case)), and running-in applies them again to other flanks.

mod bulk_temperature;
mod gradient;
mod history;
mod kept;
mod options;
mod over_gap;
#[cfg(test)]
mod overridden;
mod scan_use;
mod stages;
mod store;
mod survey;

pub use gradient::{
    LossGradient, check_heights, gradient, gradient_with, mean_along, refuse as check_gradient,
};
pub use history::{History, HistorySettings, HistoryState, history};
pub use kept::Kept;
pub use options::Progress;
pub use scan_use::{ScanUse, less_of_scans};
pub use stages::chooses_offsets;
pub use store::ContactStore;
pub use survey::{RegimeRow, survey};

pub(crate) use options::Options;
pub(crate) use over_gap::over_gap;
pub(crate) use stages::{
    by_solved_contacts, check, contacts, losses_at, losses_of, outcome, settled,
};

/// Losses of a pair of gears.
#[cfg(test)]
pub(crate) fn losses(
    case: &asperity_case::case::LoadedCase,
) -> Result<crate::result::Losses, asperity_case::error::Error> {
    losses_of(case, &Options::default())
}
