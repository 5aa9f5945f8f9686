//! Readings of a traction machine from a text of any known form.

use super::error::OilError;
use super::machine::Machine;
use super::pcs_text::{Probe, is_pcs, read_pcs};
use super::reading::Reading;
use super::table::read_table;

/// Readings of a table or of a text export; `machine` has what they do not state.
///
/// # Errors
/// When the text is not valid, or the probe of the oil reads air.
pub fn read_text(
    name: &str,
    text: &str,
    machine: &Machine,
    probe: Probe,
) -> Result<Vec<Reading>, OilError> {
    match is_pcs(text) {
        true => read_pcs(name, text, machine, probe),
        false => read_table(name, text, machine).map_err(OilError::Table),
    }
}
