//! Readings of a traction machine from a text of any known form.

use super::error as oil_error;
use asperity::fingerprint::sha256;
use asperity_core::Fault;

use super::machine::Machine;
use super::pcs_text::{Probe, is_pcs, read_pcs};
use super::reading::Reading;
use super::table::read_table;
use crate::rig_table::is_simulated;

/// Readings of a table or of a text export; `machine` has what they do not state.
///
/// # Errors
/// When the text is not valid, or the probe of the oil reads air.
pub fn read_text(
    name: &str,
    text: &str,
    machine: &Machine,
    probe: Probe,
) -> Result<Vec<Reading>, Fault> {
    match is_pcs(text) {
        true => read_pcs(name, text, machine, probe),
        false => read_table(name, text, machine).map_err(oil_error::of_table),
    }
}

/// Name and SHA-256 of a text; the name of simulated readings ends with a mark.
#[must_use]
pub fn source(name: &str, text: &str) -> [String; 2] {
    let mark = if is_simulated(text) { MARK } else { "" };
    [format!("{name}{mark}"), sha256(text.as_bytes())]
}

/// Mark behind the name of simulated readings.
const MARK: &str = " (SIMULATED)";

/// Whether a [`source`] holds simulated readings.
pub(crate) fn is_simulated_source([name, _]: &[String; 2]) -> bool {
    name.ends_with(MARK)
}
