//! Data that the files of an export are made of.

use std::path::Path;

use asperity_core::message::Warning;

use super::added::AddedLoss;
use super::field::Field;
use crate::cycle::Cycle;
use crate::map::FinishMap;

/// Additional data of the exports of a map.
#[derive(Debug, Clone, Copy, Default)]
pub struct With<'a> {
    /// Loss torque in addition to the mesh.
    pub added: Option<&'a AddedLoss>,
    /// Cycle that weights the formats with a single number.
    pub cycle: Option<&'a Cycle>,
    /// Folder or file next to which a library is compiled, in a draft; `None` for the folder of temporary files.
    pub beside: Option<&'a Path>,
}

impl With<'_> {
    /// Doubts about the tables.
    #[must_use]
    pub fn warnings(&self) -> Vec<Warning> {
        let of_cycle = self.cycle.iter().flat_map(|cycle| &cycle.warnings);
        let of_losses = self.added.iter().filter_map(|added| added.warning.as_ref());
        of_cycle.chain(of_losses).cloned().collect()
    }
}

/// Data that the files of a finish are made of.
pub(super) struct ExportGiven<'a> {
    /// One for each temperature.
    pub fields: &'a [Field],
    pub finish: &'a FinishMap,
    pub with: With<'a>,
}
