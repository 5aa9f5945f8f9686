//! Both whole traces as the inlet of one contact leaves them.

use asperity_core::DomainError;
use asperity_core::profile::mirrored_window;
use asperity_ehl_regime::{Ripples, TraceSpectrum};

use crate::error::LoadShareError;
use crate::window_roughness::{Flattening, WindowRoughness};

/// Two prepared traces, attenuated for one contact, from which windows are cut.
#[derive(Debug, Clone)]
pub struct AttenuatedTraces {
    pub(crate) heights: [Vec<f64>; 2],
    /// Ripples of the film, if it ripples.
    pub(crate) ripples: Option<Ripples<[Vec<f64>; 2]>>,
    /// Points from the middle of a window up to which its film is.
    pub(crate) reach: f64,
    pub(crate) peak_weight: f64,
}

impl AttenuatedTraces {
    /// The traces behind two spectra, flattened as
    /// [`PositionFilm::flattening`](crate::PositionFilm::flattening) returns it.
    #[must_use]
    pub fn new(traces: [&TraceSpectrum; 2], flattening: &Flattening) -> Self {
        let attenuation = &flattening.attenuation;
        let ripple = |modulus| TraceSpectrum::ripple_pair(traces, attenuation, modulus);
        Self {
            heights: TraceSpectrum::attenuated_pair(traces, attenuation),
            ripples: flattening.ripple.map(ripple),
            reach: flattening.reach / traces[0].spacing(),
            peak_weight: flattening.peak_weight,
        }
    }

    /// Roughness of two windows of `points` cells together that begin at `starts`.
    ///
    /// # Errors
    /// When a window leaves its trace or is empty.
    pub fn window(
        &self,
        starts: [usize; 2],
        points: usize,
    ) -> Result<WindowRoughness, LoadShareError> {
        let rule = "must be at least 1";
        DomainError::require(points > 0, "points of the window", points as f64, "-", rule)?;
        for (heights, start) in self.heights.iter().zip(starts) {
            let available = heights.len();
            if start.saturating_add(points) > available {
                return Err(LoadShareError::window_beyond_trace(
                    start, points, available,
                ));
            }
        }
        let cut = |of| parts(of, starts, points);
        let ripples = self.ripples.as_ref().map(|ripples| ripples.each(cut));
        Ok(WindowRoughness::new(
            cut(&self.heights),
            ripples,
            self.reach,
            self.peak_weight,
        ))
    }

    /// z_d, p′ and z_f of a whole trace.
    pub(crate) fn of_trace(&self, body: usize) -> [Option<&[f64]>; 3] {
        let ripples = self.ripples.as_ref();
        [
            Some(&*self.heights[body]),
            ripples.map(|ripples| &*ripples.pressures[body]),
            ripples.map(|ripples| &*ripples.heights[body]),
        ]
    }

    /// [`window`](Self::window) that may reach beyond the ends of the traces, where these are mirrored.
    pub(crate) fn mirrored(
        &self,
        starts: [isize; 2],
        points: usize,
    ) -> Result<WindowRoughness, LoadShareError> {
        let inside = |k: usize| {
            let start = usize::try_from(starts[k]).ok()?;
            (start + points <= self.heights[k].len()).then_some(start)
        };
        if let (Some(first), Some(second)) = (inside(0), inside(1)) {
            return self.window([first, second], points);
        }
        let sums = |of| mirrored_sums(of, starts, points);
        let ripples = self.ripples.as_ref().map(|ripples| ripples.each(sums));
        let ripples = ripples.as_ref().map(|sums| sums.each(|of| [of.as_slice()]));
        Ok(WindowRoughness::new(
            [&sums(&self.heights)],
            ripples,
            self.reach,
            self.peak_weight,
        ))
    }
}

fn parts(of: &[Vec<f64>; 2], starts: [usize; 2], points: usize) -> [&[f64]; 2] {
    [0, 1].map(|k: usize| &of[k][starts[k]..starts[k] + points])
}

pub(crate) fn mirrored_sums(of: &[Vec<f64>; 2], starts: [isize; 2], points: usize) -> Vec<f64> {
    let [first, second] = [0, 1].map(|k: usize| mirrored_window(&of[k], starts[k], points));
    first.iter().zip(&second).map(|(a, b)| a + b).collect()
}
