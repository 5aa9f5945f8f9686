//! Positions whose fields are held to the end of a run.
//!
//! The fields of one contact with the stress below it are about a megabyte, and a case may have thousands of
//! positions.

use std::sync::{Mutex, MutexGuard, PoisonError};

use crate::position::Position;
use crate::result::PositionFields;

/// Positions whose fields an outcome holds.
#[derive(Debug, Clone, PartialEq, Eq, Default)]
#[non_exhaustive]
pub enum KeptFields {
    /// Every position.
    #[default]
    All,
    /// The position with the highest pressure, which a report shows.
    Highest,
    /// These positions, from 1 at A, and the one with the highest pressure.
    Positions(Vec<usize>),
}

impl KeptFields {
    /// Number of positions, of `count`, whose fields are held.
    #[must_use]
    pub fn of(&self, count: usize) -> usize {
        match self {
            Self::All => count,
            Self::Highest => count.min(1),
            Self::Positions(wanted) => count.min(1 + wanted.len()),
        }
    }
}

/// Fields of the position with the highest pressure so far.
struct Highest {
    pressure: f64,
    fields: PositionFields,
}

/// Takes from solved positions the fields that are not kept.
pub(crate) struct Keeper<'a> {
    kept: &'a KeptFields,
    highest: Mutex<Option<Highest>>,
}

impl<'a> Keeper<'a> {
    pub(crate) fn new(kept: &'a KeptFields) -> Self {
        Self {
            kept,
            highest: Mutex::new(None),
        }
    }

    /// Takes the fields of `position`, unless they are kept whatever the others are.
    pub(crate) fn take(&self, position: &mut Position) {
        let number = position.station.number;
        let stays = match self.kept {
            KeptFields::All => true,
            KeptFields::Highest => false,
            KeptFields::Positions(wanted) => wanted.contains(&number),
        };
        if stays {
            return;
        }
        let Some(fields) = position.fields.take() else {
            return;
        };
        let pressure = position.shown_pressure();
        let mut highest = self.lock();
        // Of equal pressures the last position counts, whichever thread comes first.
        let is_higher = highest
            .as_ref()
            .is_none_or(|before| (pressure, number) > (before.pressure, before.fields.position));
        if is_higher {
            *highest = Some(Highest { pressure, fields });
        }
    }

    /// Gives the fields of the highest pressure among those taken back to their position.
    pub(crate) fn give_back(&self, positions: &mut [Position]) {
        let Some(Highest { fields, .. }) = self.lock().take() else {
            return;
        };
        let number = fields.position;
        let mut all = positions.iter_mut();
        if let Some(position) = all.find(|position| position.station.number == number) {
            position.fields = Some(fields);
        }
    }

    fn lock(&self) -> MutexGuard<'_, Option<Highest>> {
        self.highest.lock().unwrap_or_else(PoisonError::into_inner)
    }
}
