//! Sampling error of the mean over windows of a trace whose place on the flank is not known.
//!
//! | symbol | meaning | unit |
//! |---|---|---|
//! | K | offsets at which the flanks meet | - |
//! | L_f | trace length minus the window: the way that a window can take | m |
//! | a | half width of the contact | m |
//! | b_e | width over which a window averages | m |
//! | n_e | windows that count as independent | - |
//! | s² | variance of the loss from window to window | W² |
//!
//! Windows that overlap say the same twice: with K growing the mean settles on that of the trace, not on that
//! of the flank. b_e = 1.6 a is that of a loss weighted with the pressure of Hertz; on simulated traces with the
//! spectrum of ground flanks the interval covers 0.86 to 1.00 where it says 0.95, the naive one down to 0.3.

use asperity_core::cite;
use asperity_core::numerics::student_t_quantile;
use asperity_core::quantity::Length;

use crate::flanks::{Surfaces, Texture};
use crate::result::WindowSampling;

/// Confidence of the interval of the mean.
pub const CONFIDENCE: f64 = 0.95;
/// Averaging width b_e in half-widths of the contact.
const AVERAGING_WIDTH: f64 = 1.6;
/// Least way of a window, in averaging widths, for an interval.
const LEAST_WAY: f64 = 3.0;

/// Way that a window of `window` half-widths to each side can take along the shorter trace; negative where it does
/// not fit. None where a flank was not measured.
pub(crate) fn free_way(surfaces: &Surfaces, window: f64, half_width: Length) -> Option<Length> {
    let lengths = surfaces.textures().iter().map(|texture| match texture {
        Texture::Trace(profile) => Some(profile.length().si()),
        Texture::Values { .. } => None,
    });
    let lengths = lengths.collect::<Option<Vec<f64>>>()?;
    let shortest = lengths.into_iter().fold(f64::INFINITY, f64::min);
    Some(Length::from_si(shortest - 2.0 * window * half_width.si()))
}

/// Least way for an interval.
pub(crate) fn least_way(half_width: Length) -> Length {
    half_width * (LEAST_WAY * AVERAGING_WIDTH)
}

/// Windows that count as independent, of `offsets` on traces of which the shortest leaves a window the way
/// `free`; none where that is shorter than 3 b_e.
///
/// ```text
/// n_e = min(K, L_f/(b_e (1 − b_e/(3 L_f)))),  b_e = 1.6 a                  [Effective-windows]
/// ```
///
/// ```
/// use asperity::uncertainty::effective_windows;
/// use asperity::core::quantity::Length;
/// let (a, um) = (Length::from_si(80e-6), 1e-6);
/// let free = |um_: f64| Length::from_si(um_ * um);
/// assert_eq!(effective_windows(16, free(2270.0), a), Some(16.0));
/// assert!(effective_windows(128, free(2270.0), a).is_some_and(|n| (n - 18.07).abs() < 0.01));
/// assert_eq!(effective_windows(16, free(300.0), a), None);
/// ```
#[must_use]
pub fn effective_windows(offsets: usize, free: Length, half_width: Length) -> Option<f64> {
    cite!("Effective-windows");
    let (way, width) = (free.si(), AVERAGING_WIDTH * half_width.si());
    let is_long_enough = way >= LEAST_WAY * width && width > 0.0;
    if !is_long_enough || offsets < 2 {
        return None;
    }
    let independent = way / (width * (1.0 - width / (LEAST_WAY * way)));
    Some(independent.min(offsets as f64))
}

/// Interval of the mean of `losses`, one at each offset, of which `effective` count as independent.
///
/// ```text
/// s² = s_K²/(1 − 1/n_e) where n_e < K;  ± t(0.95, n_e − 1) s/√n_e            [Sampling-error]
/// ```
///
/// None for fewer than two losses.
///
/// ```
/// use asperity::uncertainty::window_sampling;
/// let found = window_sampling(&[1.0, 2.0, 3.0, 4.0, 5.0], 5.0);
/// // t(4, 95 %) = 2.7764, s/√n = 0.70711.
/// assert!(found.is_some_and(|found| (found.half_width_w - 1.96324).abs() < 1e-5));
/// ```
#[must_use]
pub fn window_sampling(losses: &[f64], effective: f64) -> Option<WindowSampling> {
    cite!("Sampling-error");
    let offsets = losses.len();
    if offsets < 2 || effective.is_nan() || effective <= 1.0 {
        return None;
    }
    let k = offsets as f64;
    let mean = losses.iter().sum::<f64>() / k;
    let squares: f64 = losses.iter().map(|loss| (loss - mean).powi(2)).sum();
    let of_windows = squares / (k - 1.0);
    // Windows of one trace scatter about the mean of the trace, which is itself off that of the flank.
    let variance = match effective < k {
        true => of_windows / (1.0 - 1.0 / effective),
        false => of_windows,
    };
    let standard_error_w = (variance / effective).sqrt();
    Some(WindowSampling {
        offsets,
        effective_windows: effective,
        standard_error_w,
        half_width_w: student_t_quantile(CONFIDENCE, effective - 1.0) * standard_error_w,
    })
}
