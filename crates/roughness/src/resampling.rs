//! Band-limited resampling of a filtered profile.
//!
//! | symbol | meaning | unit |
//! |---|---|---|
//! | zₖ, δ | heights and spacing before | m |
//! | yᵢ, d | heights and spacing after | m |
//! | K | kernel: a sine cardinal under a window of Kaiser | - |
//! | M | points on either side of a place | - |
//! | β | steepness of the window | - |
//!
//! Source of the window: Kaiser 1974. A profile that λs has filtered has no waves near its Nyquist wavelength 2δ if δ is a small share
//! of λs: heights between its points then follow from the heights of the points.

use std::f64::consts::PI;

use asperity_core::profile::common_spacing;
use asperity_core::quantity::Length;
use asperity_core::{DomainError, Profile, cite};

/// M: with [`STEEPNESS`] waves of at least 2.7 spacings have their heights within 2e-4 of their amplitude.
const REACH: usize = 12;
/// β: side lobes of the window 80 dB below its middle.
const STEEPNESS: f64 = 8.0;

/// The profile at points `spacing` apart, the first of which is its first point. Of a spacing that is a multiple of its own, these are points
/// of the profile; an equal one ([`common_spacing`]) leaves all of them.
///
/// ```text
/// yᵢ = Σₖ wᵢₖ zₖ,  wᵢₖ = K(i d/δ − k)/Σⱼ K(i d/δ − j)
/// K(t) = sin(π t)/(π t) · I₀(β √(1 − t²/M²))/I₀(β), |t| < M                          [Band-limited]
/// ```
///
/// Beyond an end z₀ the profile continues as its image through that point, 2 z₀ − z, without a step of height or slope. Nothing is filtered: a
/// coarser spacing must leave no wave shorter than 2 d.
///
/// # Errors
/// When the spacing is not positive, or the profile would have more than a hundred million points.
///
/// ```
/// use asperity_core::Profile;
/// use asperity_roughness::resampling::respaced;
/// let wave = |x: f64| (std::f64::consts::TAU * x / 7.0).sin();
/// let profile = Profile::new("1 um".parse()?, (0..200).map(|i| wave(f64::from(i))).collect())?;
/// let other = respaced(&profile, "1.6 um".parse()?)?;
/// assert!((other.heights()[50] - wave(80.0)).abs() < 1e-4);
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
pub fn respaced(profile: &Profile, spacing: Length) -> Result<Profile, DomainError> {
    cite!("Band-limited");
    let z = profile.heights();
    let count = points_after(profile.len(), profile.spacing(), spacing)?;
    let ratio = ratio(profile.spacing(), spacing);
    let height = |i: usize| {
        let mut sum = 0.0;
        weights(i, ratio, z.len(), |k, weight| sum += weight * z[k]);
        sum
    };
    let heights = (0..count).map(height).collect();
    Profile::new(spacing, heights)
}

/// Gradient of a number over the heights of a profile of `points` at `from`, from its gradient over the heights of
/// [`respaced`] at `to`.
///
/// ```text
/// ∂J/∂zₖ = Σᵢ wᵢₖ ∂J/∂yᵢ                                                        [Resample-1]
/// ```
#[must_use]
pub fn respaced_gradient(
    over_respaced: &[f64],
    points: usize,
    from: Length,
    to: Length,
) -> Vec<f64> {
    cite!("Resample-1");
    let ratio = ratio(from, to);
    let mut gradient = vec![0.0; points];
    for (i, of_point) in over_respaced.iter().enumerate() {
        weights(i, ratio, points, |k, weight| {
            gradient[k] += weight * of_point;
        });
    }
    gradient
}

/// Spacing after over that before; 1 of spacings that count as equal.
fn ratio(from: Length, to: Length) -> f64 {
    match common_spacing(from, to) {
        Some(_) => 1.0,
        None => to / from,
    }
}

/// Number of points `spacing` apart on a profile of `points` points `from` apart.
///
/// # Errors
/// When the spacing is not positive, or the profile would have more than a hundred million points.
///
/// ```
/// use asperity_core::quantity::Length;
/// use asperity_roughness::resampling::points_after;
/// let um = |value: f64| Length::from_si(value * 1e-6);
/// assert_eq!(points_after(16, um(0.31), um(0.5))?, 10);
/// # Ok::<(), asperity_core::DomainError>(())
/// ```
pub fn points_after(points: usize, from: Length, spacing: Length) -> Result<usize, DomainError> {
    /// Maximum number of points, as in the generators: 800 MB.
    const MAX_POINTS: f64 = 1e8;
    let d = DomainError::positive("spacing", spacing)?;
    let intervals = points.saturating_sub(1) as f64 / ratio(from, spacing);
    let rule = "is too fine: the profile would have more than a hundred million points";
    DomainError::require(intervals < MAX_POINTS, "spacing", d, "m", rule)?;
    Ok((intervals * (1.0 + f64::EPSILON)).floor() as usize + 1)
}

/// Calls `each` with the number of every point before that point `i` after depends on, and with its weight.
fn weights(i: usize, ratio: f64, points: usize, mut each: impl FnMut(usize, f64)) {
    /// Distance from a point, in spacings, at which a place is that point.
    const AT_A_POINT: f64 = 1e-9;
    let last = points as isize - 1;
    let place = i as f64 * ratio;
    let nearest = place.round();
    if (place - nearest).abs() < AT_A_POINT || points == 1 {
        return each((nearest as usize).min(points - 1), 1.0);
    }
    let below = place.floor() as isize;
    let reach = REACH as isize;
    let near = below + 1 - reach..=below + reach;
    let total: f64 = near.clone().map(|k| kernel(place - k as f64)).sum();
    for k in near {
        let weight = kernel(place - k as f64) / total;
        // Of a trace shorter than the kernel the image ends at its other end.
        match k {
            _ if k < 0 => {
                each(0, 2.0 * weight);
                each((-k).min(last) as usize, -weight);
            }
            _ if k > last => {
                each(last as usize, 2.0 * weight);
                each((2 * last - k).max(0) as usize, -weight);
            }
            _ => each(k as usize, weight),
        }
    }
}

/// K(t) up to a factor.
fn kernel(t: f64) -> f64 {
    let part = t / REACH as f64;
    let window = bessel_i0(STEEPNESS * (1.0 - part * part).max(0.0).sqrt());
    window * (PI * t).sin() / (PI * t)
}

/// I₀(x), the modified Bessel function of order 0, by its series: Σ ((x/2)^k/k!)².
fn bessel_i0(x: f64) -> f64 {
    let quarter = 0.25 * x * x;
    let (mut term, mut sum, mut k) = (1.0, 1.0, 0.0);
    while term > f64::EPSILON * sum {
        k += 1.0;
        term *= quarter / (k * k);
        sum += term;
    }
    sum
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_bessel_function_has_its_printed_values() {
        // Abramowitz and Stegun, table 9.8.
        for (x, value) in [(0.0, 1.0), (1.0, 1.266_065_878), (5.0, 27.239_871_82)] {
            assert!((bessel_i0(x) / value - 1.0).abs() < 1e-9, "{x}");
        }
    }

    #[test]
    fn the_weights_of_a_place_add_up_to_one() {
        for points in [1, 2, 5, 300] {
            for ratio in [0.37, 1.0, 1.7] {
                let places = ((points - 1) as f64 / ratio) as usize;
                for i in 0..=places {
                    let mut sum = 0.0;
                    weights(i, ratio, points, |k, weight| {
                        assert!(k < points);
                        sum += weight;
                    });
                    assert!((sum - 1.0).abs() < 1e-12, "{points} {ratio} {i}: {sum}");
                }
            }
        }
    }
}
