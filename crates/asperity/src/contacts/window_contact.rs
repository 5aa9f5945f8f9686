//! The rough contact of one window, solved at the shares that a film needs.

use std::sync::{Arc, Mutex, PoisonError};

use asperity_core::cancel::checkpoint;
use asperity_core::noted::Noted;
use asperity_core::quantity::{Length, LineLoad};
use asperity_mixed_film::{ContactTable, Flattening, RoughContact, WindowRoughness};

use super::inputs::WindowInputs;
use crate::mesh::MeshPosition;
use asperity_case::case::LoadedCase;
use asperity_case::error::PositionError;
use asperity_case::flanks::{
    OffsetIndex, PatchPlace, Roughness, Sheets, Window, WindowPair, row_place,
};

/// The rough contact of one window, and its roughness.
#[derive(Debug, Clone)]
pub(crate) struct WindowContact {
    inputs: Arc<WindowInputs>,
    place: WindowPlace,
    /// Roughness of the window, or of the flanks as a whole where no window is resolved.
    pub roughness: Roughness,
    /// Place of the window on the traces; `None` where no window is resolved.
    pub window: Option<Window>,
    /// The contact at the shares solved so far, once a film needed it.
    pub table: Noted<ContactTable>,
    /// Roughness that the last film left.
    flattened: LastFilm,
}

/// Roughness of a window as the last film left it: films that differ in friction only leave the same.
#[derive(Debug, Default)]
struct LastFilm(Mutex<Option<(Flattening, Arc<WindowRoughness>)>>);

impl Clone for LastFilm {
    fn clone(&self) -> Self {
        Self::default()
    }
}

/// Which window of a mesh it is, with its load.
#[derive(Debug, Clone, Copy)]
struct WindowPlace {
    load: LineLoad,
    radius: Length,
    zone: usize,
    /// Cell of the path.
    cell: usize,
    /// Offset and number of offsets of all pairs.
    offset: OffsetIndex,
}

impl WindowContact {
    /// The windows of `each` offsets of every pair of traces at `position`, with their roughness.
    ///
    /// # Errors
    /// When the traces are too coarse or too short for the contact.
    pub(crate) fn of_position(
        inputs: &Arc<WindowInputs>,
        each: usize,
        position: &MeshPosition,
    ) -> Result<Vec<Arc<Self>>, PositionError> {
        let count = inputs.surfaces.offsets(each);
        let of_offset = |k| Self::of_offset(inputs, position, k, count);
        (0..count).map(of_offset).collect()
    }

    /// The window of offset `k` of `count` at `position`, with its roughness.
    ///
    /// # Errors
    /// When the traces are too coarse or too short for the contact.
    pub(super) fn of_offset(
        inputs: &Arc<WindowInputs>,
        position: &MeshPosition,
        k: usize,
        count: usize,
    ) -> Result<Arc<Self>, PositionError> {
        checkpoint()?;
        let surfaces = &inputs.surfaces;
        Ok(Arc::new(Self {
            inputs: Arc::clone(inputs),
            place: WindowPlace {
                load: position.load,
                radius: position.motion.radius,
                zone: position.zone,
                cell: position.cell,
                offset: OffsetIndex { k, count },
            },
            window: Window::at(surfaces, position, inputs.reach, k, count)?,
            roughness: surfaces.roughness_at(position, inputs.reach, OffsetIndex { k, count })?,
            table: Noted::default(),
            flattened: LastFilm::default(),
        }))
    }

    /// Roughness that a film leaves of the window, made by `make` unless the last film left the same.
    ///
    /// # Errors
    /// As `make`.
    pub(crate) fn flattened<E>(
        &self,
        by: &Flattening,
        make: impl FnOnce() -> Result<WindowRoughness, E>,
    ) -> Result<Arc<WindowRoughness>, E> {
        let last = || {
            self.flattened
                .0
                .lock()
                .unwrap_or_else(PoisonError::into_inner)
        };
        if let Some((_, known)) = last().as_ref().filter(|(of, _)| of == by) {
            known.cite_known();
            return Ok(Arc::clone(known));
        }
        let made = Arc::new(make()?);
        *last() = Some((*by, Arc::clone(&made)));
        Ok(made)
    }

    /// The window ready to be pressed.
    ///
    /// # Errors
    /// When no window is resolved, or a number is outside the domain of the contact.
    pub(crate) fn rough(&self) -> Result<RoughContact, PositionError> {
        let WindowPlace {
            load,
            radius,
            zone,
            offset,
            ..
        } = self.place;
        let window = self.window.ok_or_else(PositionError::no_profile)?;
        if let Some((sheets, place)) = self.patch(window)? {
            let composite = sheets.composite(place);
            let (rows, spacings) = (sheets.rows(), sheets.spacings());
            let inputs = &self.inputs;
            return inputs.rough_contact(load, radius, &composite, rows, spacings);
        }
        let [first, second] = window.cut(&self.inputs.surfaces, zone, offset)?;
        let pairs = first.heights().iter().zip(second.heights());
        let composite: Vec<f64> = pairs.map(|(a, b)| a + b).collect();
        self.inputs
            .rough_contact(load, radius, &composite, 1, [first.spacing(); 2])
    }

    /// Both surfaces with the place of the patch around a window; `None` of traces.
    ///
    /// # Errors
    /// When a flank has no trace.
    pub(crate) fn patch(
        &self,
        window: Window,
    ) -> Result<Option<(&Sheets, PatchPlace)>, PositionError> {
        let WindowPlace {
            zone,
            cell,
            offset: OffsetIndex { k, count },
            ..
        } = self.place;
        let (of_pair, k, _) = self.inputs.surfaces.met(zone, k, count);
        let Some(sheets) = of_pair.sheets() else {
            return Ok(None);
        };
        let spacing = of_pair.traces()?[0].spacing();
        Ok(Some((
            sheets,
            window.patch(sheets, spacing, row_place(k, cell)),
        )))
    }

    /// The table of the contact, with the window if it was made for it.
    ///
    /// # Errors
    /// As [`rough`](Self::rough).
    pub(crate) fn table(&self) -> Result<(&ContactTable, Option<RoughContact>), PositionError> {
        let mut made = None;
        let table = self.table.get_or_make(|| {
            let rough = made.insert(self.rough()?);
            Ok::<_, PositionError>(ContactTable::new(rough))
        })?;
        Ok((table, made))
    }

    /// Asperity share of the window under the mean gap `gap`.
    ///
    /// # Errors
    /// When the contact has no solution.
    pub(crate) fn share_at_gap(&self, gap: Length) -> Result<f64, PositionError> {
        let (table, rough) = self.table()?;
        table.share_at_gap(gap, || rough.map_or_else(|| self.rough(), Ok))
    }

    /// Mean gap of the window at the asperity share that is solved first.
    ///
    /// # Errors
    /// When the contact has no solution.
    pub(super) fn middle_gap(&self) -> Result<Length, PositionError> {
        let (table, rough) = self.table()?;
        table.middle_gap(|| rough.map_or_else(|| self.rough(), Ok))
    }

    /// `error` of the contact at `position` with the gap of the window, if it did not converge.
    pub(crate) fn keeping(&self, error: PositionError, position: &MeshPosition) -> PositionError {
        let of_traces = self
            .window
            .filter(|_| self.inputs.surfaces.sheets().is_none());
        let pair = of_traces.and_then(|window| {
            let WindowPlace { zone, offset, .. } = self.place;
            let flanks = window.cut(&self.inputs.surfaces, zone, offset).ok()?;
            WindowPair::new(flanks, position, self.inputs.modulus).ok()
        });
        match pair {
            Some(pair) => error.keeping(&pair.x, &pair.gap),
            None => error,
        }
    }

    /// Whether the contact was solved at any share.
    pub(super) fn is_solved(&self) -> bool {
        (self.table.get()).is_some_and(|table| table.rows().next().is_some())
    }

    /// Checks the windows at the first offset of each pair of teeth as [`of_position`](Self::of_position) does.
    ///
    /// # Errors
    /// When the traces do not have the windows, or the pressures in a window are needed and there are no traces.
    pub(crate) fn check(loaded: &LoadedCase, position: &MeshPosition) -> Result<(), PositionError> {
        let (surfaces, model) = (&loaded.surfaces, &loaded.case.model);
        let count = surfaces.offsets(model.offsets);
        for k in (0..count).filter(|k| surfaces.begins_a_pair(*k, count)) {
            let window = Window::at(surfaces, position, model.window, k, count)?;
            if window.is_none() && loaded.case.formulation.pressures().is_some() {
                return Err(PositionError::no_profile());
            }
            surfaces.roughness_at(position, model.window, OffsetIndex { k, count })?;
        }
        Ok(())
    }
}
