//! Draws of parameters that the case has calibrated on a rig.

use asperity_core::cite;
use asperity_core::numerics::standard_normal_quantile;

use crate::case::{CalibratedName, LoadedCase, cholesky};

use crate::parameters::{OnAxis, Ranged};

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

#[cfg(test)]
mod tests {
    use super::*;
    use crate::case::{Calibrated, CalibrationInput, CorrelationInput};
    use crate::parameters::{AXES, parameters};
    use crate::uncertainty::hypercube::latin_hypercube;

    fn pearson(a: &[f64], b: &[f64]) -> f64 {
        let n = a.len() as f64;
        let mean = |v: &[f64]| v.iter().sum::<f64>() / n;
        let (p, q) = (mean(a), mean(b));
        let sum = |u: &[f64], m: f64, v: &[f64], o: f64| -> f64 {
            u.iter().zip(v).map(|(x, y)| (x - m) * (y - o)).sum()
        };
        sum(a, p, b, q) / (sum(a, p, a, p) * sum(b, q, b, q)).sqrt()
    }

    #[test]
    fn calibrated_draws_have_the_band_and_the_correlation_of_the_case() {
        let file = std::path::Path::new("../../fixtures/cases/e-drive.toml");
        let given = CalibrationInput {
            boundary_friction: Some(Calibrated {
                value: 0.09,
                low: 0.08,
                high: 0.12,
            }),
            limiting_shear: Some(Calibrated {
                value: 0.035,
                low: 0.033,
                high: 0.037,
            }),
            correlations: Some(vec![CorrelationInput {
                between: [
                    CalibratedName::BoundaryFriction,
                    CalibratedName::LimitingShear,
                ],
                value: -0.9,
            }]),
            ..CalibrationInput::default()
        };
        let case = crate::case::load_with(file, &|input| input.calibration = Some(given.clone()));
        let case = case.unwrap();
        let (all, _) = parameters(&case).unwrap();
        let of = |name| {
            all.iter()
                .find(|(_, one)| one.calibrated == Some(name))
                .unwrap()
        };
        let (friction, shear) = (
            of(CalibratedName::BoundaryFriction),
            of(CalibratedName::LimitingShear),
        );
        let draws: Vec<Vec<f64>> = latin_hypercube(2000, AXES.len())
            .into_iter()
            .map(|place| calibrated_places(&case, place, &all))
            .collect();
        let values = |(axis, ranged): &OnAxis| -> Vec<f64> {
            draws.iter().map(|place| ranged.at(place[*axis])).collect()
        };
        let (first, other) = (values(friction), values(shear));
        // Even strata: 2.5 % of the draws lie below each lower end, and above each upper one.
        for (values, [low, high]) in [(&first, [0.08, 0.12]), (&other, [0.033, 0.037])] {
            let below = values.iter().filter(|value| **value < low).count();
            let above = values.iter().filter(|value| **value > high).count();
            assert!(
                (40..=60).contains(&below) && (40..=60).contains(&above),
                "{below} {above}"
            );
        }
        let half = first.iter().filter(|value| **value < 0.09).count();
        assert_eq!(half, 1000);
        let logs = |values: &[f64]| values.iter().map(|value| value.ln()).collect::<Vec<f64>>();
        // The skew band of the first takes a little off the correlation of the logarithms.
        let correlation = pearson(&logs(&first), &logs(&other));
        assert!((-0.93..-0.85).contains(&correlation), "{correlation}");
        // An axis without calibration stays even.
        let layer = all
            .iter()
            .find(|(_, one)| one.calibrated.is_none())
            .unwrap()
            .0;
        assert!(draws.iter().all(|place| (0.0..1.0).contains(&place[layer])));
    }
}
