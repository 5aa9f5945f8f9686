//! Profile elements between crossings of the mean line, for RSm and Rc.
//!
//! Source: ISO 4287 with its ±10 % Rz rule, ISO 21920-2 (crossing-the-line).
//!
//! A crossing counts when the profile has been beyond a threshold on one side and comes beyond the
//! threshold on the other; it lies at the first zero after the last point beyond the former, found
//! by linear interpolation. An element runs from a crossing to the next but one. In ISO 4287 elements
//! follow each other; in ISO 21920 every crossing starts one, and the trace is run both ways.

use crate::height_parameters::extremes;

/// Width [points] and height [unit of z] of one profile element.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) struct Element {
    pub width: f64,
    pub height: f64,
}

/// Positions of the counted crossings, in points from the first.
fn crossings(z: &[f64], above: f64, below: f64) -> Vec<f64> {
    let mut found = Vec::new();
    // Side of the last excursion and its last point.
    let mut last: Option<(bool, usize)> = None;
    for (i, &height) in z.iter().enumerate() {
        let up = height > above;
        if !up && height >= -below {
            continue;
        }
        if let Some((side, at)) = last
            && side != up
        {
            found.push(first_zero(z, at, i));
        }
        last = Some((up, i));
    }
    found
}

/// The first zero between points `from` and `to`, whose heights differ in sign.
fn first_zero(z: &[f64], from: usize, to: usize) -> f64 {
    let positive = z[from] > 0.0;
    let k = (from..to)
        .find(|k| (z[k + 1] > 0.0) != positive)
        .unwrap_or(from);
    let fall = z[k] - z[k + 1];
    k as f64 + if fall == 0.0 { 0.0 } else { z[k] / fall }
}

/// Elements of `z` about its zero line that follow each other.
pub(crate) fn elements(z: &[f64], above: f64, below: f64) -> Vec<Element> {
    between(z, crossings(z, above, below).windows(3).step_by(2))
}

/// Elements of `z` that start at every crossing, of the trace run forwards and backwards.
pub(crate) fn overlapping_elements(z: &[f64], above: f64, below: f64) -> Vec<Element> {
    let backwards: Vec<f64> = z.iter().rev().copied().collect();
    let mut found = between(z, crossings(z, above, below).windows(3));
    found.extend(between(
        &backwards,
        crossings(&backwards, above, below).windows(3),
    ));
    found
}

fn between<'a>(z: &[f64], crossings: impl Iterator<Item = &'a [f64]>) -> Vec<Element> {
    let element = |three: &[f64]| {
        let (start, end) = (three[0], three[2]);
        let inside = &z[start.ceil() as usize..=end.floor() as usize];
        let (low, high) = extremes(inside);
        Element {
            width: end - start,
            height: high - low,
        }
    };
    crossings.map(element).collect()
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
    fn ripple_within_the_thresholds_makes_no_element() {
        let z: Vec<f64> = (0..1000)
            .map(|i| if i % 2 == 0 { 0.05 } else { -0.05 })
            .collect();
        assert!(elements(&z, 0.1, 0.1).is_empty());
        assert_eq!(elements(&z, 0.04, 0.04).len(), 499);
    }
}
