//! Draws of parameters that the case has calibrated on a rig.

use asperity_core::cite;
use asperity_core::numerics::standard_normal_quantile;

use crate::case::{CalibratedName, LoadedCase, cholesky};

use super::parameters::{OnAxis, Ranged};

/// z with 95 % of a normal distribution within ± z.
const BAND: f64 = 1.959_963_984_540_054;

/// The place of a draw along every axis, those of calibrated parameters normal about their values and correlated:
/// 0 and 1 are then the ends of the 95 % band, and draws may lie beyond.
///
/// ```text
/// ln v = ln v₀ + s± (L z),  z = Φ⁻¹(u),  s± = ln(v±/v₀)/1.96                 [Calibrated-draws]
/// ```
///
/// v± are the ends of the band, on either side of v₀ its own; L Lᵀ are the correlations.
pub(crate) fn calibrated_places(
    loaded: &LoadedCase,
    mut place: Vec<f64>,
    parameters: &[OnAxis],
) -> Vec<f64> {
    let known = |(axis, ranged): &OnAxis| Some((*axis, *ranged, ranged.calibrated?));
    let calibrated: Vec<(usize, Ranged, CalibratedName)> =
        parameters.iter().filter_map(known).collect();
    let Some(given) = &loaded.case.input.calibration else {
        return place;
    };
    let names: Vec<CalibratedName> = calibrated.iter().map(|found| found.2).collect();
    // A case whose correlations contradict each other is refused.
    let Some(lower) = cholesky(given, &names) else {
        return place;
    };
    if !calibrated.is_empty() {
        cite!("Calibrated-draws");
    }
    let z: Vec<f64> = calibrated
        .iter()
        .map(|(axis, ..)| standard_normal_quantile(place[*axis]))
        .collect();
    for ((axis, ranged, _), row) in calibrated.iter().zip(&lower) {
        let mixed: f64 = row.iter().zip(&z).map(|(l, z)| l * z).sum();
        let end = if mixed < 0.0 { ranged.low } else { ranged.high };
        let step = (end / ranged.value).ln().abs() / BAND;
        let from_low = (ranged.value / ranged.low).ln() + step * mixed;
        place[*axis] = from_low / (ranged.high / ranged.low).ln();
    }
    place
}
