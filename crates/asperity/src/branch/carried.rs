//! Result of a branch: pressures along a contact.

use asperity_contact::ContactSolution;

use crate::result::HistoryRow;

/// Pressures along a contact, and the solution of the solids where they touch.
#[derive(Debug, Clone)]
pub(crate) struct Carried {
    /// Pressure in the film \[Pa\].
    pub fluid: Vec<f64>,
    /// Solution of the rough contact; none in full film.
    pub solids: Option<ContactSolution>,
    /// History of the approach to the solution.
    pub history: Vec<HistoryRow>,
}
