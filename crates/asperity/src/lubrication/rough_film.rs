//! Film and rough contact of one mesh position: the load share at any offset.

use std::sync::Arc;

use asperity_core::Checked;
use asperity_core::quantity::Length;

use super::chosen_laws::ChosenLaws;
use super::smooth_position::SmoothPosition;
use crate::contacts::WindowContact;
use crate::mesh::MeshPosition;
use crate::result::PatchFields;
use asperity_case::case::OperatingCase;
use asperity_case::error::PositionError;
use asperity_case::flanks::{Surfaces, Window};
use asperity_mixed_film::{
    AttenuatedTraces, Flattening, Kinks, LoadShareSettings, LoadShareSolution, PositionFilm,
    SmoothFilm, Unflattening, WindowGradient, WindowRoughness,
};

/// Film of a position with the traces as its inlet leaves them.
pub(crate) struct RoughFilm<'a> {
    case: &'a OperatingCase,
    film: PositionFilm<'a>,
    surfaces: Surfaces,
    /// Flattening of the traces, once a window was needed.
    flattening: Option<Flattening>,
    /// Both whole traces, once a window was cut from them.
    traces: Option<AttenuatedTraces>,
}

impl<'a> RoughFilm<'a> {
    /// The film at `position`, if the load-share law requires the rough contact and both flanks are
    /// measured.
    pub(crate) fn at(
        case: &'a OperatingCase,
        laws: &ChosenLaws,
        surfaces: &Surfaces,
        SmoothPosition { at: position, film }: SmoothPosition<'_>,
    ) -> Result<Option<Self>, PositionError> {
        let Some(chosen) = laws.load_share.contact() else {
            return Ok(None);
        };
        let asks = surfaces.are_measured() && case.formulation.pressures().is_none();
        let Some(rheology) = case.rheology().filter(|_| asks) else {
            return Ok(None);
        };
        let settings = LoadShareSettings {
            lay: surfaces.lay(case.model.lay)?,
            ..*chosen
        };
        let contact = position.line_contact(case.modulus, case.materials);
        let smooth = SmoothFilm {
            central: film.film.central,
            thermal_factor: film.thermal_reduction,
        };
        let film =
            PositionFilm::with_film(rheology, &contact, case.temperature(), &settings, smooth)?;
        Ok(Some(Self {
            case,
            film,
            surfaces: surfaces.clone(),
            flattening: None,
            traces: None,
        }))
    }

    /// Flattening of the traces, computed at first need.
    fn flattening(&mut self) -> Result<Flattening, PositionError> {
        let flattening = match self.flattening {
            Some(known) => known,
            None => match self.surfaces.sheets() {
                Some(sheets) => self.film.patch_flattening(sheets.passing()?)?,
                None => self.film.flattening(self.surfaces.pair_spectrum()?)?,
            },
        };
        Ok(*self.flattening.insert(flattening))
    }

    /// Roughness of the attenuated windows of `contact`.
    fn roughness(
        &mut self,
        contact: &WindowContact,
        window: Window,
    ) -> Result<Arc<WindowRoughness>, PositionError> {
        let flattening = self.flattening()?;
        if let Some((sheets, place)) = contact.patch(window)? {
            return Ok(Arc::new(sheets.window(place, &flattening)?));
        }
        let Self {
            surfaces, traces, ..
        } = self;
        contact.flattened(&flattening, || {
            let window = (window.starts, window.points);
            surfaces.window(window, &flattening, traces)
        })
    }

    /// Load share and friction of a window; its contact is solved as far as that needs, and stored.
    ///
    /// # Errors
    /// When the contact has no solution.
    pub(crate) fn share(
        &mut self,
        contact: &WindowContact,
        window: Window,
    ) -> Result<Checked<LoadShareSolution>, PositionError> {
        let roughness = self.roughness(contact, window)?;
        let (table, rough) = contact.table()?;
        (self.film).solve_rows(table, &roughness, || {
            rough.map_or_else(|| contact.rough(), Ok)
        })?;
        Ok(self.film.share(table, &roughness)?)
    }
}

impl RoughFilm<'_> {
    /// Flow through the roughness left in the contact over the flow of a smooth gap.
    ///
    /// # Errors
    /// When a flow has no solution.
    pub(crate) fn flow_factor(
        &mut self,
        gap: Length,
        attenuated_rms: Length,
    ) -> Result<f64, PositionError> {
        if self.surfaces.sheets().is_some() {
            self.flattening()?;
        }
        Ok(self.film.flow_factor(gap, attenuated_rms))
    }

    /// The first patch at a solved share: its pressures, and its spots with their losses; `None` of a line.
    ///
    /// # Errors
    /// When the contact has no solution.
    pub(crate) fn patch(
        &self,
        at: &MeshPosition,
        contact: &WindowContact,
        share: &LoadShareSolution,
    ) -> Result<Option<PatchFields>, PositionError> {
        let Some(window) = contact.window else {
            return Ok(None);
        };
        let Some((sheets, place)) = contact.patch(window)? else {
            return Ok(None);
        };
        let mut rough = contact.rough()?;
        let state = rough.at(share.asperity_share)?;
        let losses = self.film.losses_of_spots(&state.spots, share)?;
        let [along, across] = sheets.spacings().map(Length::si);
        let (columns, rows) = (place.points, sheets.rows());
        let middle = 0.5 * (columns as f64 - 1.0);
        let x: Vec<f64> = (0..columns).map(|i| (i as f64 - middle) * along).collect();
        Ok(Some(PatchFields {
            pressure_fluid: at.hertz_pressure(&x, 1.0 - share.asperity_share)?,
            x,
            y: (0..rows).map(|j| j as f64 * across).collect(),
            spot: rough.spot_of_points(&state),
            pressure: state.solution.pressure,
            spot_losses: losses
                .iter()
                .map(|loss| loss * across * rows as f64)
                .collect(),
        }))
    }
}

impl RoughFilm<'_> {
    /// Gradient of `force` times the friction coefficient of a window whose contact is stored, with the kinks of the window;
    /// `None` if the friction does not depend on the heights.
    ///
    /// # Errors
    /// As [`share`](Self::share).
    pub(crate) fn window_gradient(
        &mut self,
        contact: &WindowContact,
        window: Window,
        force: f64,
    ) -> Result<(Option<WindowGradient>, Kinks), PositionError> {
        let roughness = self.roughness(contact, window)?;
        let Some(table) = contact.table.get() else {
            return Ok((None, Kinks::default()));
        };
        let kinks = self.film.kinks(table, &roughness)?;
        let mut rough = contact.rough()?;
        let scale = self.case.model.friction_scale;
        let found = (self.film).gradient(&mut rough, table, &roughness, scale)?;
        let flattening = self.flattening()?;
        let spectra = self.surfaces.whole_spectra()?;
        let traces = (self.traces)
            .get_or_insert_with(|| AttenuatedTraces::new(spectra.each_ref(), &flattening));
        let gradient = traces.window_gradient(window.starts, &found, force);
        Ok((Some(gradient), kinks))
    }

    /// The adjoint of the flattening of the traces: from gradients in windows to the gradient over the heights.
    pub(crate) fn unflattening(&self) -> Result<Unflattening, PositionError> {
        let spectra = self.surfaces.whole_spectra()?;
        Ok((self.film).unflattening(spectra, self.surfaces.pair_spectrum()?)?)
    }
}
