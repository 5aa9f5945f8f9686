//! The rough contacts of a gear train.

use crate::contacts::Contacts;
use crate::pipeline;
use asperity_case::case::train::Train;
use asperity_case::error::Error;

/// The rough contacts of each mesh, which share windows under the same load, those of `known` among them.
pub(crate) fn contacts(loaded: &Train, known: &[&Contacts]) -> Result<Vec<Contacts>, Error> {
    let mut found: Vec<Contacts> = Vec::new();
    for case in loaded.cases() {
        let known: Vec<&Contacts> = known.iter().copied().chain(&found).collect();
        let own = pipeline::contacts(case, &known)?;
        found.push(own);
    }
    Ok(found)
}
