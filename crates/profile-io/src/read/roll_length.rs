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
//! Even steps of L are uneven steps of s. The heights are interpolated onto an even grid of s by a natural cubic spline
//! `[Spline-1]`; straight lines, and cubics through four neighbours, would flatten waves of six points.

use asperity_core::quantity::Length;

use super::error::ReadFault;
use super::options::Abscissa;

/// Converts the x column of roll angles to roll lengths L `[m]`; roll lengths are unchanged.
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
/// Distances along the involute \[m\] of the roll lengths `rolls` \[m\].
///
/// # Errors
/// When a roll length is negative, or the roll lengths are not ascending.
pub(super) fn along_involute(rolls: Vec<f64>, base_radius: Length) -> Result<Vec<f64>, ReadFault> {
    asperity_core::cite!("Roll-1");
    let impossible = |value| {
        let unit = super::options::LengthUnit::Metre;
        ReadFault::impossible("the roll length or base radius", value, unit)
    };
    let radius = base_radius.si();
    if !(radius.is_finite() && radius > 0.0) {
        return Err(impossible(radius));
    }
    let first = rolls.first().copied().unwrap_or(0.0);
    let s: Vec<f64> = rolls.iter().map(|l| l * l / (2.0 * radius)).collect();
    let rises = s.windows(2).all(|pair| pair[1] > pair[0]) && s.iter().all(|s| s.is_finite());
    if first < 0.0 || !rises {
        return Err(impossible(first));
    }
    Ok(s)
}

#[cfg(test)]
mod tests {
    use super::super::resample::{Between, on_grid};
    use super::*;

    #[test]
    fn a_wave_along_the_involute_keeps_its_length_and_height() {
        let base_radius = Length::from_si(50e-3);
        let roll = |i: usize| 10e-3 + 10e-3 * i as f64 / 3999.0;
        let rolls: Vec<f64> = (0..4000).map(roll).collect();
        let s = along_involute(rolls, base_radius).unwrap();
        let wave = |s: f64| 1e-6 * (s / 50e-6 * std::f64::consts::TAU).sin();
        let z: Vec<f64> = s.iter().map(|s| wave(*s)).collect();
        let length = (20e-3_f64.powi(2) - 10e-3_f64.powi(2)) / 0.1;
        assert!(((s[3999] - s[0]) / length - 1.0).abs() < 1e-12 && s[0] == 1e-3);
        let spacing = length / 6000.0;
        let heights = on_grid(&s, &z, spacing, 6000, Between::Spline);
        for (i, z) in heights.iter().enumerate() {
            let exact = wave(1e-3 + spacing * i as f64);
            // (2π h/λ)⁴/384 of a spline within, at steps of 1 um under waves of 50 um; at the ends its second
            // derivative is nought and not that of the wave.
            let inside = (100..heights.len() - 100).contains(&i);
            assert!((z - exact).abs() < if inside { 1e-11 } else { 1e-9 }, "{i}");
        }
    }

    #[test]
    fn roll_lengths_below_the_base_circle_are_refused() {
        let radius = Length::from_si(50e-3);
        let rolls: Vec<f64> = (0..200).map(|i| -1e-3 + 1e-5 * f64::from(i)).collect();
        assert!(along_involute(rolls, radius).is_err());
        let angles = &mut [1.0, 2.0];
        roll_lengths(angles, Abscissa::RollDegrees, radius);
        assert!((angles[1] - 50e-3 * 2.0_f64.to_radians()).abs() < 1e-15);
    }
}
