//! Traces of involute checkers: x is the roll length or the roll angle.
//!
//! Source: geometry of the involute (Litvin and Fuentes 2004, chapter 10).
//!
//! | symbol | meaning | unit |
//! |---|---|---|
//! | r_b | base radius | m |
//! | ξ | roll angle | rad |
//! | L | roll length, r_b ξ | m |
//! | s | distance along the involute from the base circle | m |
//!
//! Even steps of L are uneven steps of s, so the heights are put on an even grid of s, by a natural cubic
//! spline `[Spline-1]`: straight lines, and cubics through four neighbours too, flatten waves of six points.

use asperity_core::quantity::Length;

use super::error::ReadError;
use super::natural_spline;
use super::options::Abscissa;

/// Points of the even grid over those of the file, at most.
const MOST_REFINED: f64 = 8.0;

/// A trace along the involute.
#[derive(Debug)]
pub(super) struct AlongInvolute {
    /// Heights in the unit they came in.
    pub heights: Vec<f64>,
    /// Spacing [m].
    pub spacing: f64,
    /// Distance of the first point from the base circle [m].
    pub start: f64,
}

/// L `[m]` of the x column, which holds `abscissa`; roll lengths in metres stay as they are.
pub(super) fn roll_lengths(x: &mut [f64], abscissa: Abscissa, base_radius: Length) {
    let factor = match abscissa {
        Abscissa::RollDegrees => base_radius.si() * std::f64::consts::PI / 180.0,
        Abscissa::RollRadians => base_radius.si(),
        Abscissa::RollLength | Abscissa::Distance => return,
    };
    x.iter_mut().for_each(|x| *x *= factor);
}

/// s = L²/(2 r_b)                                                             `[Roll-1]`
///
/// Heights `z` at the rising roll lengths `rolls` \[m\] on an even grid of s.
///
/// # Errors
/// When a roll length is not positive or does not rise.
pub(super) fn along_involute(
    file: &str,
    rolls: &[f64],
    z: &[f64],
    base_radius: Length,
) -> Result<AlongInvolute, ReadError> {
    asperity_core::cite!("Roll-1");
    let impossible = |value| ReadError::Impossible {
        file: file.to_owned(),
        what: "the roll length or base radius",
        value,
        unit: super::options::LengthUnit::Metre,
    };
    let radius = base_radius.si();
    if !(radius.is_finite() && radius > 0.0) {
        return Err(impossible(radius));
    }
    let rises = rolls.windows(2).all(|pair| pair[1] > pair[0]);
    if let Some(&first) = rolls.first()
        && (!rises || first < 0.0)
    {
        return Err(impossible(first));
    }
    let s: Vec<f64> = rolls.iter().map(|l| l * l / (2.0 * radius)).collect();
    let steps = s.windows(2).map(|pair| pair[1] - pair[0]);
    let finest = steps.fold(f64::INFINITY, f64::min);
    let length = s[s.len() - 1] - s[0];
    // The finest step keeps the short waves of the coarse end and invents none beyond.
    let intervals = (length / finest).ceil().min(MOST_REFINED * s.len() as f64);
    let spacing = length / intervals;
    let positions = (0..=intervals as usize).map(|i| s[0] + spacing * i as f64);
    let heights = natural_spline::at_rising(positions, &s, z);
    Ok(AlongInvolute {
        heights,
        spacing,
        start: s[0],
    })
}

#[cfg(test)]
mod tests {
    use super::*;

    /// A sine along the involute, sampled in even steps of the roll length.
    fn sampled(points: usize) -> (Vec<f64>, Vec<f64>) {
        let radius = 50e-3;
        let rolls: Vec<f64> = (0..points)
            .map(|i| 10e-3 + 10e-3 * i as f64 / (points - 1) as f64)
            .collect();
        let wave = |l: &f64| 1e-6 * (l * l / (2.0 * radius) / 50e-6 * std::f64::consts::TAU).sin();
        let z = rolls.iter().map(wave).collect();
        (rolls, z)
    }

    #[test]
    fn a_wave_along_the_involute_keeps_its_length_and_height() {
        let (rolls, z) = sampled(4000);
        let radius = Length::from_si(50e-3);
        let found = along_involute("a", &rolls, &z, radius).unwrap();
        let length = (20e-3_f64.powi(2) - 10e-3_f64.powi(2)) / 0.1;
        let n = found.heights.len() - 1;
        assert!((found.spacing * n as f64 / length - 1.0).abs() < 1e-12);
        for (i, z) in found.heights.iter().enumerate() {
            let s = 1e-3 + found.spacing * i as f64;
            let exact = 1e-6 * (s / 50e-6 * std::f64::consts::TAU).sin();
            // (2π h/λ)⁴/384 of a spline within, at steps of 1 um under waves of 50 um; at the ends its second
            // derivative is nought and not that of the wave.
            let inside = (100..found.heights.len() - 100).contains(&i);
            assert!((z - exact).abs() < if inside { 1e-11 } else { 1e-9 }, "{i}");
        }
    }

    #[test]
    fn roll_lengths_below_the_base_circle_are_refused() {
        let radius = Length::from_si(50e-3);
        let rolls: Vec<f64> = (0..200).map(|i| -1e-3 + 1e-5 * f64::from(i)).collect();
        assert!(along_involute("a", &rolls, &[0.0; 200], radius).is_err());
        let angles = &mut [1.0, 2.0];
        roll_lengths(angles, Abscissa::RollDegrees, radius);
        assert!((angles[1] - 50e-3 * 2.0_f64.to_radians()).abs() < 1e-15);
    }
}
