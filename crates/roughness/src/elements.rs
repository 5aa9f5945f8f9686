//! Profile elements between crossings of the mean line, for RSm and Rc.
//!
//! Source: ISO 4287 with its ±10 % Rz rule, ISO 21920-2 (crossing-the-line).
//!
//! A crossing is counted if the profile exceeds a threshold on one side and then the threshold on the other side. Its
//! position is the first zero after the last point beyond the former threshold, by linear interpolation. An element
//! extends from a crossing to the next but one. In ISO 4287 elements are consecutive; in ISO 21920 an element starts at
//! every crossing, and the trace is evaluated in both directions.

use asperity_core::numerics::extremes;

/// Width [points] and height [unit of z] of a profile element.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) struct Element {
    pub width: f64,
    pub height: f64,
}

/// Counted crossings: last point beyond one threshold, first point beyond the other.
fn crossings(z: &[f64], above: f64, below: f64) -> Vec<(usize, usize)> {
    let beyond = |up: bool, z: f64| if up { z > above } else { z < -below };
    let mut crossings = Vec::new();
    let first = z.iter().position(|&z| beyond(true, z) || beyond(false, z));
    let Some(mut at) = first else {
        return crossings;
    };
    let mut up = beyond(true, z[at]);
    while let Some(step) = z[at..].iter().position(|&z| beyond(!up, z)) {
        let to = at + step;
        let stay = z[at..to].iter().rposition(|&z| beyond(up, z));
        crossings.push((at + stay.unwrap_or(0), to));
        (at, up) = (to, !up);
    }
    crossings
}

/// The first zero between points `from` and `to`, whose heights differ in sign, in points from the first.
fn first_zero(z: &[f64], from: usize, to: usize) -> f64 {
    let positive = z[from] > 0.0;
    let k = (from..to).find(|k| (z[k + 1] > 0.0) != positive);
    zero_after(z, k.unwrap_or(from))
}

/// The last zero between points `from` and `to`: the first zero of the reversed trace.
fn last_zero(z: &[f64], from: usize, to: usize) -> f64 {
    let positive = z[to] > 0.0;
    let k = (from..to).rfind(|&k| (z[k] > 0.0) != positive);
    zero_after(z, k.unwrap_or(from))
}

/// The zero between points `k` and `k` + 1 by linear interpolation.
fn zero_after(z: &[f64], k: usize) -> f64 {
    let fall = z[k] - z[k + 1];
    k as f64 + if fall == 0.0 { 0.0 } else { z[k] / fall }
}

/// Consecutive elements of `z` about its zero line.
pub(crate) fn elements(z: &[f64], above: f64, below: f64) -> Vec<Element> {
    let crossings = crossings(z, above, below).into_iter();
    let zeros: Vec<f64> = crossings
        .map(|(from, to)| first_zero(z, from, to))
        .collect();
    between(z, zeros.windows(3).step_by(2)).collect()
}

/// Elements of `z` that start at every crossing, in both directions of the trace.
pub(crate) fn overlapping_elements(z: &[f64], above: f64, below: f64) -> Vec<Element> {
    // Both directions have the same excursions; only the zeros between them may differ.
    let (forwards, backwards): (Vec<f64>, Vec<f64>) = crossings(z, above, below)
        .into_iter()
        .map(|(from, to)| (first_zero(z, from, to), last_zero(z, from, to)))
        .unzip();
    let mut elements: Vec<Element> = between(z, forwards.windows(3)).collect();
    elements.extend(between(z, backwards.windows(3)));
    elements
}

fn between<'a>(z: &[f64], zeros: impl Iterator<Item = &'a [f64]>) -> impl Iterator<Item = Element> {
    zeros.map(|three| {
        let (start, end) = (three[0], three[2]);
        let inside = &z[start.ceil() as usize..=end.floor() as usize];
        let (low, high) = extremes(inside);
        Element {
            width: end - start,
            height: high - low,
        }
    })
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_sine_has_elements_of_one_wavelength() {
        let z: Vec<f64> = (0..1000)
            .map(|i| (f64::from(i) * std::f64::consts::TAU / 100.0 + 0.3).sin())
            .collect();
        let found = elements(&z, 0.2, 0.2);
        // 19 crossings in ten periods that start within a hill: nine pairs.
        assert_eq!(found.len(), 9);
        for element in found {
            // Zeros of a sine by linear interpolation between points 3.6 degrees apart.
            assert!((element.width - 100.0).abs() < 1e-3, "{element:?}");
            assert!((element.height - 2.0).abs() < 2e-3, "{element:?}");
        }
    }

    #[test]
    fn a_trace_run_backwards_has_the_overlapping_elements_of_the_trace() {
        let z: Vec<f64> = (0..5000)
            .map(|i| ((i * i * 7 + 13 * i) as f64 * 0.618_033_988_75).fract() - 0.5)
            .collect();
        let backwards: Vec<f64> = z.iter().rev().copied().collect();
        let sums = |z: &[f64]| {
            let found = overlapping_elements(z, 0.3, 0.2);
            let widths: f64 = found.iter().map(|element| element.width).sum();
            let heights: f64 = found.iter().map(|element| element.height).sum();
            (found.len(), widths, heights)
        };
        let (one, other) = (sums(&z), sums(&backwards));
        assert!(one.0 > 1000 && one.0 == other.0);
        // Rounding of positions up to 5000 in some thousand elements.
        assert!((one.1 - other.1).abs() < 1e-8 && (one.2 - other.2).abs() < 1e-8);
        // The first zero and the last are apart where the ripple crosses more than once.
        assert_ne!(
            one.1,
            2.0 * elements(&z, 0.3, 0.2).iter().map(|e| e.width).sum::<f64>()
        );
    }

    #[test]
    fn ripple_within_the_thresholds_makes_no_element() {
        let z: Vec<f64> = (0..1000)
            .map(|i| if i % 2 == 0 { 0.05 } else { -0.05 })
            .collect();
        assert!(elements(&z, 0.1, 0.1).is_empty());
        assert_eq!(elements(&z, 0.04, 0.04).len(), 499);
    }
}
