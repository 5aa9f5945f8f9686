//! Refusal of tables of gearbox losses, in a build without the feature `case-files`.

use asperity_core::message::Warning;
use asperity_core::{Code, Fault};
use asperity_efficiency::loss_table::LossTable;

/// Refuses the table.
///
/// # Errors
/// Always.
pub fn read(name: &str, _: &str) -> Result<(LossTable, Option<Warning>), Fault> {
    let text = format!("{name}: is read only by a build with feature case-files");
    Err(Fault::new(Code::E138, text))
}
