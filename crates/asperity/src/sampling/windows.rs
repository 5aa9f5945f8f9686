//! Sampling error of the mean over windows of a trace whose place on the flank is not known.
//!
//! | symbol | meaning | unit |
//! |---|---|---|
//! | K | offsets of the flanks against each other | - |
//! | L_f | trace length minus the window: the way that a window can take | m |
//! | a | half width of the contact | m |
//! | b_e | width over which a window averages | m |
//! | n_max | independent windows of the trace | - |
//! | n_e | windows that count as independent | - |
//! | P_i | sliding loss of position i | W |
//! | d_i | its standard deviation over the offsets | W |
//! | φ | share of the load on the asperities | - |
//! | m | independent rows of a patch, [`Sheets::independent_rows`] | - |
//!
//! Windows that overlap repeat each other: with growing K the mean converges to the mean of the trace, not of the flank.
//! b_e = 1.6 a holds for a loss weighted with the pressure of Hertz.

use asperity_core::cite;
use asperity_core::quantity::Length;

use crate::result::loss_band::WindowSampling;
use asperity_case::error::PositionError;
use asperity_case::flanks::{AVERAGING_WIDTH, Sheets, Surfaces};

/// Scatter of the whole loss over the sum of the scatters of its positions, which share places of the flank: 0.68 to
/// 0.77 measured.
const COMMON: f64 = 0.75;
/// Scatter expected of flanks before any is seen, for each unit of φ, and its weight in degrees of freedom.
const PRIOR: [f64; 2] = [0.5, 4.0];

/// Scatter of the losses of positions over the offsets, over the loss of all.
#[derive(Debug, Clone, Copy, PartialEq, Default)]
pub(crate) struct LossScatter {
    /// Σ d_i² over (Σ P_i)².
    pub squares: f64,
    /// Σ d_i over Σ P_i.
    pub sum: f64,
}

impl LossScatter {
    /// Of the loss of each position and its standard deviation.
    pub fn from_positions(positions: impl Iterator<Item = [f64; 2]>) -> Self {
        let add = |[loss, squares, sum]: [f64; 3], [of_one, deviation]: [f64; 2]| {
            [
                loss + of_one,
                squares + deviation * deviation,
                sum + deviation,
            ]
        };
        let [loss, squares, sum] = positions.fold([0.0; 3], add);
        if loss > 0.0 {
            Self {
                squares: squares / (loss * loss),
                sum: sum / loss,
            }
        } else {
            Self::default()
        }
    }
}

/// Way that a window of `window` half-widths to each side can take along the shorter trace; negative where it does
/// not fit. None where a flank was not measured.
fn free_way(surfaces: &Surfaces, window: f64, half_width: Length) -> Option<Length> {
    let lengths = surfaces.traces().ok()?.map(|trace| trace.length().si());
    let shortest = lengths[0].min(lengths[1]);
    Some(Length::from_si(shortest - 2.0 * window * half_width.si()))
}

/// Independent windows of traces that leave a window the way `free`; at least one.
///
/// ```text
/// n_max = L_f/(b_e (1 − b_e/(3 L_f))),  b_e = 1.6 a                        [Effective-windows]
/// ```
///
/// ```
/// use asperity::uncertainty::independent_windows;
/// use asperity::core::quantity::Length;
/// let (a, um) = (Length::from_si(80e-6), 1e-6);
/// let of_way = |way: f64| independent_windows(Length::from_si(way * um), a);
/// assert!((of_way(2270.0) - 18.07).abs() < 0.01);
/// assert_eq!(of_way(100.0), 1.0);
/// ```
#[must_use]
pub fn independent_windows(free: Length, half_width: Length) -> f64 {
    cite!("Effective-windows");
    let (way, width) = (free.si(), AVERAGING_WIDTH * half_width.si());
    if way > width && width > 0.0 {
        (way / (width * (1.0 - width / (3.0 * way)))).max(1.0)
    } else {
        1.0
    }
}

/// Length of a trace that holds `windows` windows of contacts of half width `half_width`, end to end.
pub(crate) fn length_for(windows: f64, window: f64, half_width: Length) -> Length {
    half_width * (windows * AVERAGING_WIDTH + 2.0 * window)
}

/// Independent windows of `window` half-widths to each side on both flanks, under contacts of half width `half_width`, added up over several
/// teeth; `None` if a flank was not measured.
pub(crate) fn windows_of_traces(
    surfaces: &Surfaces,
    window: f64,
    half_width: Length,
) -> Option<f64> {
    let free = free_way(surfaces, window, half_width)?;
    let teeth = surfaces
        .teeth()
        .map_or(1, |[pinion, wheel]| pinion.min(wheel));
    Some(teeth as f64 * independent_windows(free, half_width))
}

/// Independent windows of flanks, and independent rows of each window.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Independent {
    /// Along rolling.
    pub windows: f64,
    /// Along the lead; `None` of traces.
    pub rows: Option<f64>,
}

impl Independent {
    /// Independent windows of traces.
    #[must_use]
    pub fn of_traces(windows: f64) -> Self {
        Self {
            windows,
            rows: None,
        }
    }

    /// Under contacts of half width `half_width` with windows of `window` half-widths to each side; `None` if a flank was not
    /// measured.
    pub(crate) fn new(
        surfaces: &Surfaces,
        window: f64,
        half_width: Length,
    ) -> Result<Option<Self>, PositionError> {
        let Some(windows) = windows_of_traces(surfaces, window, half_width) else {
            return Ok(None);
        };
        let rows = |sheets: &Sheets| sheets.independent_rows(half_width * AVERAGING_WIDTH);
        let rows = surfaces.sheets().map(|sheets| rows(sheets)).transpose()?;
        Ok(Some(Self { windows, rows }))
    }

    /// s₀ at an asperity share: a patch is the mean of its independent rows, each of which scatters as a trace does.
    fn expected_scatter(self, asperity_share: f64) -> f64 {
        PRIOR[0] * asperity_share / self.rows.unwrap_or(1.0).sqrt()
    }
}

/// Sampling error of the mean loss over `offsets` offsets on flanks with `independent` windows.
///
/// ```text
/// s′ = 0.75 Σ d_i/Σ P_i,  n_e = min(K, n_max),  s₀ = φ/(2 √m), m = 1 of traces
/// s_p² = (4 s₀² + (n_e − 1) s′²)/(3 + n_e),  SE = s_p/√n_e                   [Sampling-error]
/// SE_num² = Σ d_i²/(K (Σ P_i)²)
/// ```
///
/// `positions` are P_i and d_i of each. The error of ln loss has a t distribution with 3 + n_e degrees of freedom.
///
/// ```
/// use asperity::uncertainty::{Independent, window_sampling};
/// // One window says nothing of the scatter: SE = s₀.
/// let found = window_sampling(&[[3.0, 0.3], [1.0, 0.4]], 16, Independent::of_traces(1.0), 0.2);
/// assert!((found.standard_error - 0.1).abs() < 1e-15 && found.freedom == 4.0);
/// ```
#[must_use]
pub fn window_sampling(
    positions: &[[f64; 2]],
    offsets: usize,
    independent: Independent,
    asperity_share: f64,
) -> WindowSampling {
    cite!("Sampling-error");
    let scatter = LossScatter::from_positions(positions.iter().copied());
    let numerical = (scatter.squares / offsets as f64).sqrt();
    sampling(
        offsets,
        COMMON * scatter.sum,
        numerical,
        independent,
        asperity_share,
    )
}

/// Sampling error of a mean over `passed` independent windows that has the standard error `numerical_error` for traces that never
/// end, on traces with `windows` windows.
pub(crate) fn travel_sampling(
    passed: usize,
    numerical_error: f64,
    windows: f64,
    asperity_share: f64,
) -> WindowSampling {
    let own = numerical_error * (passed as f64).sqrt();
    let independent = Independent::of_traces(windows);
    sampling(passed, own, numerical_error, independent, asperity_share)
}

/// The sampling error where windows scatter by `own`, of which the prior is a part.
fn sampling(
    offsets: usize,
    own: f64,
    numerical_error: f64,
    independent: Independent,
    asperity_share: f64,
) -> WindowSampling {
    let effective = (offsets as f64).min(independent.windows);
    let prior = independent.expected_scatter(asperity_share);
    let weight = PRIOR[1];
    let freedom = weight - 1.0 + effective;
    let variance = (weight * prior * prior + (effective - 1.0) * own * own) / freedom;
    WindowSampling {
        offsets,
        effective_windows: effective,
        standard_error: (variance / effective).sqrt(),
        freedom,
        numerical_error,
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn positions_add_their_scatters_and_their_squares() {
        let found = LossScatter::from_positions([[3.0, 0.3], [1.0, 0.4]].into_iter());
        assert!((found.sum - 0.7 / 4.0).abs() < 1e-15);
        assert!((found.squares - 0.25 / 16.0).abs() < 1e-15);
        assert_eq!(
            LossScatter::from_positions(std::iter::empty()),
            LossScatter::default()
        );
    }

    #[test]
    fn a_patch_is_expected_to_scatter_less_than_a_trace() {
        let [trace, patch] = [None, Some(16.0)].map(|rows| {
            let independent = Independent { windows: 1.0, rows };
            window_sampling(&[[1.0, 0.4]], 4, independent, 0.2).standard_error
        });
        assert!((trace - 0.1).abs() < 1e-15 && (patch - 0.025).abs() < 1e-15);
    }

    #[test]
    fn many_windows_have_their_own_scatter() {
        // s′ = 0.75·0.4 = 0.3, s₀ = 0.1: (4·0.01 + 15·0.09)/19 over 16.
        let many = window_sampling(&[[1.0, 0.4]], 16, Independent::of_traces(40.0), 0.2);
        assert!((many.standard_error.powi(2) - 1.39 / 19.0 / 16.0).abs() < 1e-15);
        assert!((many.numerical_error - 0.1).abs() < 1e-15);
        assert_eq!((many.effective_windows, many.freedom), (16.0, 19.0));
    }
}
