//! Readings of a traction machine from a text of any known form.

use super::error as oil_error;
use asperity::fingerprint::sha256;
use asperity_core::Fault;
use asperity_core::message::Warning;

use super::machine::Machine;
use super::pcs_text::{Probe, is_pcs, read_pcs};
use super::reading::Reading;
use super::table::read_table;
use crate::rig_table::is_simulated;

/// Readings with the files that they are from.
#[derive(Debug, Clone, PartialEq, Default)]
pub struct Readings {
    /// The readings, file by file.
    pub all: Vec<Reading>,
    /// Name and SHA-256 of every file; the name of simulated readings ends with a mark.
    pub sources: Vec<[String; 2]>,
    /// Doubts about the files.
    pub warnings: Vec<Warning>,
}

impl Readings {
    /// Readings of a table or of a text export; `machine` has what they do not state.
    ///
    /// # Errors
    /// When the text is not valid, or the probe of the oil reads air.
    pub fn read(name: &str, text: &str, machine: &Machine, probe: Probe) -> Result<Self, Fault> {
        let (all, warning) = if is_pcs(text) {
            (read_pcs(name, text, machine, probe)?, None)
        } else {
            read_table(name, text, machine).map_err(oil_error::of_table)?
        };
        let mark = if is_simulated(text) { MARK } else { "" };
        Ok(Self {
            all,
            sources: vec![[format!("{name}{mark}"), sha256(text.as_bytes())]],
            warnings: warning.into_iter().collect(),
        })
    }

    /// Adds the readings of a further file.
    pub fn append(&mut self, other: Self) {
        self.all.extend(other.all);
        self.sources.extend(other.sources);
        self.warnings.extend(other.warnings);
    }
}

impl From<Vec<Reading>> for Readings {
    /// Readings that are from no file.
    fn from(all: Vec<Reading>) -> Self {
        Self {
            all,
            ..Self::default()
        }
    }
}

/// Mark behind the name of simulated readings.
const MARK: &str = " (SIMULATED)";

/// Whether a source of [`Readings`] holds simulated readings.
pub(crate) fn is_simulated_source([name, _]: &[String; 2]) -> bool {
    name.ends_with(MARK)
}
