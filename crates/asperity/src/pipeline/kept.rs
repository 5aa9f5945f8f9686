//! Positions whose fields are held to the end of a run.
//!
//! The fields of one contact with the stress below it are about a megabyte, and a case may have thousands of
//! positions.

use crate::lubrication::LubricatedPosition;

/// Positions whose fields an outcome holds.
#[derive(Debug, Clone, PartialEq, Eq, Default)]
#[non_exhaustive]
pub enum Kept {
    /// Every position.
    #[default]
    All,
    /// The position with the highest pressure, which a report shows.
    Highest,
    /// These positions, from 1 at A, and the one with the highest pressure.
    Positions(Vec<usize>),
    /// None, and the points A to E, which are in no mean, are not solved: a comparison shows neither.
    Nothing,
    /// None, and no picture of a contact is computed: no views, no stress below the surface.
    NoPictures,
}

impl Kept {
    /// Number of positions, of `count`, whose fields are held.
    #[must_use]
    pub fn of(&self, count: usize) -> usize {
        match self {
            Self::All => count,
            Self::Highest => count.min(1),
            Self::Positions(wanted) => count.min(1 + wanted.len()),
            Self::Nothing | Self::NoPictures => 0,
        }
    }

    /// Whether fields are held for each of `positions`, of which a part is `resolved` by its windows.
    pub(crate) fn held(
        &self,
        positions: &[LubricatedPosition],
        resolved: impl Fn(&LubricatedPosition) -> bool,
    ) -> Vec<bool> {
        // Of equal pressures the last position counts.
        let highest = positions
            .iter()
            .filter(|position| resolved(position))
            .max_by(|a, b| a.shown_pressure().total_cmp(&b.shown_pressure()))
            .map(|position| position.at.number);
        let is_held = |position: &LubricatedPosition| {
            let number = position.at.number;
            match self {
                Self::All => true,
                Self::Highest => highest == Some(number),
                Self::Positions(wanted) => wanted.contains(&number) || highest == Some(number),
                Self::Nothing | Self::NoPictures => false,
            }
        };
        positions.iter().map(is_held).collect()
    }
}
