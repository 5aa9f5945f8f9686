//! Both whole traces as the inlet of one contact leaves them.

use asperity_core::profile::mirrored_window;
use asperity_core::quantity::Length;
use asperity_core::{DomainError, cite};
use asperity_ehl_regime::{Attenuation, TraceSpectrum};

use crate::error::LoadShareError;

/// Two prepared traces, attenuated for one contact, from which windows are cut.
#[derive(Debug, Clone)]
pub struct AttenuatedTraces {
    heights: [Vec<f64>; 2],
}

impl AttenuatedTraces {
    /// The traces behind two spectra, flattened as
    /// [`PositionFilm::attenuation`](crate::PositionFilm::attenuation) gives it.
    #[must_use]
    pub fn new(traces: [&TraceSpectrum; 2], attenuation: &Attenuation) -> Self {
        Self {
            heights: TraceSpectrum::attenuated_pair(traces, attenuation),
        }
    }

    /// Standard deviation σ_d of the sum of two windows of `points` cells that begin at `starts`.
    ///
    /// # Errors
    /// When a window leaves its trace or is empty.
    pub fn window_rms(&self, starts: [usize; 2], points: usize) -> Result<Length, LoadShareError> {
        let rule = "must be at least 1";
        DomainError::require(points > 0, "points of the window", points as f64, "-", rule)?;
        let part = |k: usize| {
            let available = self.heights[k].len();
            let end = starts[k].saturating_add(points);
            self.heights[k]
                .get(starts[k]..end)
                .ok_or(LoadShareError::WindowBeyondTrace {
                    start: starts[k],
                    points,
                    available,
                })
        };
        Ok(deviation(part(0)?, part(1)?))
    }

    /// Derivative of σ_d over the sum of the heights at each point of two windows, which are mirrored beyond the ends of their
    /// traces; zero where σ_d is.
    ///
    /// ```text
    /// ∂σ_d/∂y_i = (y_i − ȳ)/(n σ_d)                                              [Rms-gradient]
    /// ```
    #[must_use]
    pub fn rms_gradient(&self, starts: [isize; 2], points: usize) -> Vec<f64> {
        cite!("Rms-gradient");
        let [first, second] =
            [0, 1].map(|k: usize| mirrored_window(&self.heights[k], starts[k], points));
        let deviation = deviation(&first, &second).si();
        let sums: Vec<f64> = first.iter().zip(&second).map(|(a, b)| a + b).collect();
        let n = points as f64;
        let mean = sums.iter().sum::<f64>() / n;
        let of = |y: &f64| match deviation > 0.0 {
            true => (y - mean) / (n * deviation),
            false => 0.0,
        };
        sums.iter().map(of).collect()
    }

    /// The same of windows that may reach beyond the ends of their traces, where these are mirrored.
    pub(crate) fn mirrored_rms(
        &self,
        starts: [isize; 2],
        points: usize,
    ) -> Result<Length, LoadShareError> {
        let inside = |k: usize| {
            let start = usize::try_from(starts[k]).ok()?;
            (start + points <= self.heights[k].len()).then_some(start)
        };
        if let (Some(first), Some(second)) = (inside(0), inside(1)) {
            return self.window_rms([first, second], points);
        }
        let part = |k: usize| mirrored_window(&self.heights[k], starts[k], points);
        Ok(deviation(&part(0), &part(1)))
    }
}

/// Standard deviation of the sum of two windows.
pub(crate) fn deviation(first: &[f64], second: &[f64]) -> Length {
    let (mut sum, mut squares) = (0.0, 0.0);
    for (a, b) in first.iter().zip(second) {
        let z = a + b;
        sum += z;
        squares += z * z;
    }
    let n = first.len() as f64;
    let mean = sum / n;
    Length::from_si((squares / n - mean * mean).max(0.0).sqrt())
}
