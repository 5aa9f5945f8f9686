//! Gradient of a number over the heights of two whole traces from its gradients in windows of the flattened traces.
//!
//! | symbol | meaning | unit |
//! |---|---|---|
//! | J | the number | - |
//! | z | heights of both traces | m |
//! | z_d, p′, z_f | heights that count in the supply, pressures and heights of the ripples of the film | m, Pa, m |
//! | n | scale of the wavelengths that the inlet flattens | 1/m |

use std::borrow::Cow;

use asperity_core::DomainError;
use asperity_core::cite;
use asperity_core::numerics::{add_times, dot};
use asperity_core::profile::{mirrored_indices, mirrored_window};
use asperity_core::quantity::{Length, Pressure};
use asperity_ehl_regime::{Attenuation, GapLaw, PairSpectrum, Ripples, TraceSpectrum};

use super::PositionFilm;
use super::gradient::ShareGradient;
use crate::attenuated_traces::{AttenuatedTraces, mirrored_sums};
use crate::error::LoadShareError;
use crate::window_gap::middle_gradient;
use crate::window_roughness::{Flattening, deviation_gradient, part_gradient};

/// Gradient of a number over the sums of both traces at the points of a window.
#[derive(Debug, Clone, PartialEq)]
pub struct WindowGradient {
    /// First points of the window on both traces.
    pub(crate) starts: [isize; 2],
    /// Over the heights in the rough contact \[1/m\].
    pub(crate) contact: Vec<f64>,
    /// Over the heights that count in the supply \[1/m\].
    pub(crate) supply: Vec<f64>,
    /// Over the ripples of the film \[1/Pa\], \[1/m\]; `None` of a film that does not ripple.
    pub(crate) ripples: Option<Ripples<Vec<f64>>>,
}

impl WindowGradient {
    /// Over what the inlet flattens: z_d, p′ and z_f.
    fn flattened(&self) -> [Option<&[f64]>; 3] {
        let ripples = self.ripples.as_ref();
        [
            Some(&*self.supply),
            ripples.map(|ripples| &*ripples.pressures),
            ripples.map(|ripples| &*ripples.heights),
        ]
    }

    /// Σ g v over the points of the window, v of one whole trace; zero without g.
    fn sum(&self, gradient: Option<&[f64]>, body: usize, of_trace: &[f64]) -> f64 {
        let product = |g| {
            dot(
                g,
                &windowed(of_trace, self.starts[body], self.contact.len()),
            )
        };
        gradient.map_or(0.0, product)
    }

    /// Derivative along a change of a trace that the inlet leaves as `flattened`, with its scale held.
    fn along(&self, change: &TraceChange, flattened: [Option<&[f64]>; 3]) -> f64 {
        let body = change.body;
        let pairs = self.flattened().into_iter().zip(flattened);
        let of = |(gradient, of_trace): (_, Option<&[f64]>)| {
            of_trace.map_or(0.0, |of_trace| self.sum(gradient, body, of_trace))
        };
        self.sum(Some(&self.contact), body, &change.heights) + pairs.map(of).sum::<f64>()
    }
}

/// A change of the heights of one trace.
#[derive(Debug, Clone)]
pub struct TraceChange {
    body: usize,
    heights: Vec<f64>,
    spectrum: TraceSpectrum,
}

impl TraceChange {
    /// A change of all heights of the first or second trace (`body` 0 or 1) \[m\], which are `spacing` apart.
    ///
    /// # Errors
    /// When `body` is neither 0 nor 1, the spacing is not positive, there are fewer than two heights or one is not finite.
    pub fn new(body: usize, heights: Vec<f64>, spacing: Length) -> Result<Self, LoadShareError> {
        DomainError::require(body < 2, "body", body as f64, "-", "must be 0 or 1")?;
        Ok(Self {
            body,
            spectrum: TraceSpectrum::new(&heights, spacing)?,
            heights,
        })
    }
}

/// Adjoint of the flattening of two traces by the inlet of a contact, and its derivative along a change of the traces.
#[derive(Debug, Clone)]
pub struct Unflattening {
    flattening: Flattening,
    modulus: Pressure,
    /// dz_d/d ln n of both traces, dp′/d ln n and dz_f/d ln n.
    slopes: [[Vec<f64>; 2]; 3],
    /// d ln n/dz, if the flattening depends on the heights.
    by_height: Option<[Vec<f64>; 2]>,
}

impl Unflattening {
    /// Gradient of a number over the heights of both whole traces, from its gradients over the heights in windows of them, over
    /// these heights as the inlet of this contact flattens them, and over the ripples of its film.
    ///
    /// ```text
    /// ∂J/∂z = Σ_v F_v ∂J/∂v + (Σ_v Σ ∂J/∂v dv/d ln n) d ln n/dz,  v = z_d, p′, z_f               [Flattened-gradient]
    /// ```
    ///
    /// F_v = v/z of a wave: A, \[Ripple-pressure\] and \[Ripple-height\].
    ///
    /// The second term is zero with the gap law `power`, whose flattening does not depend on the heights.
    #[must_use]
    pub fn gradient<'w>(
        &self,
        traces: &[TraceSpectrum; 2],
        windows: impl IntoIterator<Item = &'w WindowGradient>,
    ) -> [Vec<f64>; 2] {
        cite!("Flattened-gradient");
        let none = || traces.each_ref().map(|trace| vec![0.0; trace.points()]);
        let (mut direct, mut flattened) = (none(), [none(), none(), none()]);
        for window in windows {
            let add = |sums: &mut [Vec<f64>; 2], gradient: &[f64]| {
                for (sums, start) in sums.iter_mut().zip(window.starts) {
                    let places = mirrored_indices(sums.len(), start, gradient.len());
                    for (i, one) in places.zip(gradient) {
                        sums[i] += one;
                    }
                }
            };
            add(&mut direct, &window.contact);
            for (sums, gradient) in flattened.iter_mut().zip(window.flattened()) {
                if let Some(gradient) = gradient {
                    add(sums, gradient);
                }
            }
        }
        let (attenuation, modulus) = (&self.flattening.attenuation, self.modulus);
        let signals = [0, 1].map(|body: usize| flattened.each_ref().map(|of| &*of[body]));
        let factors = |wave| {
            [
                attenuation.ratio(wave),
                attenuation.ripple(wave, modulus),
                attenuation.film_ratio(wave),
            ]
        };
        let mut gradient = TraceSpectrum::filtered_sums(traces.each_ref(), signals, factors);
        for (sums, direct) in gradient.iter_mut().zip(&direct) {
            add_times(sums, 1.0, direct);
        }
        let Some(by_height) = &self.by_height else {
            return gradient;
        };
        let pairs = flattened.iter().zip(&self.slopes);
        let products = pairs.flat_map(|(of, slopes)| of.iter().zip(slopes));
        let by_scale: f64 = products.map(|(of, slopes)| dot(of, slopes)).sum();
        for (of_body, by_height) in gradient.iter_mut().zip(by_height) {
            add_times(of_body, by_scale, by_height);
        }
        gradient
    }

    /// Derivative of a number along each change, in each window: the product of [`gradient`](Self::gradient) and the change. Each
    /// change is flattened once, and not the gradient of each window. Zero for `None`.
    ///
    /// # Errors
    /// When a change does not have as many heights as its trace.
    pub fn along(
        &self,
        windows: &[Option<WindowGradient>],
        changes: &[TraceChange],
    ) -> Result<Vec<Vec<f64>>, LoadShareError> {
        cite!("Flattened-gradient");
        for change in changes {
            let (points, most) = (change.heights.len(), self.slopes[0][change.body].len());
            let rule = "a change has as many heights as its trace";
            DomainError::require(points == most, "heights", points as f64, "-", rule)?;
        }
        let by_scale = |window: &Option<_>| window.as_ref().map_or(0.0, |of| self.by_scale(of));
        let by_scale: Vec<f64> = windows.iter().map(by_scale).collect();
        // Two changes cost one transform together.
        let of_two = |two: &[TraceChange]| -> Vec<Vec<f64>> {
            let both = [&two[0], &two[two.len() - 1]].map(|change| &change.spectrum);
            let flattened = AttenuatedTraces::new(both, &self.flattening);
            let of = |(k, change): (usize, &TraceChange)| -> Vec<f64> {
                let by_height = self.by_height.as_ref();
                let scale = by_height.map_or(0.0, |of| dot(&of[change.body], &change.heights));
                let flattened = flattened.of_trace(k);
                let of = |(window, by_scale): (&Option<WindowGradient>, &f64)| {
                    let window = window.as_ref();
                    window.map_or(0.0, |of| of.along(change, flattened) + scale * by_scale)
                };
                windows.iter().zip(&by_scale).map(of).collect()
            };
            two.iter().enumerate().map(of).collect()
        };
        Ok(changes.chunks(2).flat_map(of_two).collect())
    }

    /// Derivative of a number over ln n in a window.
    fn by_scale(&self, window: &WindowGradient) -> f64 {
        let pairs = window.flattened().into_iter().zip(&self.slopes);
        let products = pairs.map(|(gradient, slopes)| {
            window.sum(gradient, 0, &slopes[0]) + window.sum(gradient, 1, &slopes[1])
        });
        products.sum()
    }
}

impl AttenuatedTraces {
    /// Gradient over the sums of both traces in two windows that begin at `starts`, and are mirrored beyond the ends of their
    /// traces: `scale` times `of`, the gradient over the roughness of the windows.
    #[must_use]
    pub fn window_gradient(
        &self,
        starts: [isize; 2],
        of: &ShareGradient,
        scale: f64,
    ) -> WindowGradient {
        let points = of.by_height.len();
        let [by_rms, by_middle] = of.by_supply.map(|slope| scale * slope);
        let sums = mirrored_sums(&self.heights, starts, points);
        let of_rms = deviation_gradient(&sums, self.peak_weight);
        let both = of_rms.iter().zip(middle_gradient(points, self.reach));
        let by_parts = of.by_parts.iter();
        let by_parts: Vec<_> = by_parts.map(|part| part.map(|of| scale * of)).collect();
        let ripples = self.ripples.as_ref().filter(|_| !by_parts.is_empty());
        let sums = ripples.map(|ripples| ripples.each(|of| mirrored_sums(of, starts, points)));
        WindowGradient {
            starts,
            contact: of.by_height.iter().map(|by| scale * by).collect(),
            supply: both
                .map(|(rms, middle)| by_rms * rms + by_middle * middle)
                .collect(),
            ripples: sums.map(|sums| part_gradient(&sums, self.reach, &by_parts)),
        }
    }
}

impl PositionFilm<'_> {
    /// The adjoint of the flattening of two traces, with their spectra.
    ///
    /// # Errors
    /// When the film is not positive or a number is not finite.
    pub fn unflattening(
        &self,
        spectra: &[TraceSpectrum; 2],
        pair: &PairSpectrum,
    ) -> Result<Unflattening, LoadShareError> {
        let inlet = match self.settings.supply.gap_law() {
            GapLaw::Power => None,
            GapLaw::Inlet => Some(self.inlet(pair)?),
        };
        let attenuation = match &inlet {
            Some(inlet) => inlet.attenuation,
            None => Attenuation::new(GapLaw::Power, self.nabla)?,
        };
        let (both, modulus) = (spectra.each_ref(), self.contact.modulus);
        Ok(Unflattening {
            flattening: self.flattening_by(attenuation),
            modulus,
            slopes: [
                TraceSpectrum::filtered_pair(both, |wave| attenuation.slope(wave)),
                TraceSpectrum::filtered_pair(both, |wave| attenuation.ripple_slope(wave, modulus)),
                TraceSpectrum::filtered_pair(both, |wave| attenuation.film_slope(wave)),
            ],
            by_height: inlet.map(|inlet| inlet.scale_gradient(pair, both)),
        })
    }
}

/// `points` values of a trace from index `start`, which are mirrored beyond its ends.
fn windowed(of: &[f64], start: isize, points: usize) -> Cow<'_, [f64]> {
    let inside = usize::try_from(start).ok();
    match inside.and_then(|start| of.get(start..start + points)) {
        Some(inside) => Cow::Borrowed(inside),
        None => Cow::Owned(mirrored_window(of, start, points)),
    }
}
