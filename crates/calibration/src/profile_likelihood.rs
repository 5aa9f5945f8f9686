//! Profile likelihood: band of one parameter with all others refitted.

use asperity_core::cite;
use asperity_core::numerics::find_root;

/// Band by the profile likelihood.
#[derive(Debug, Clone, PartialEq)]
pub struct ProfileBand {
    /// Lower and upper end.
    pub ends: [f64; 2],
    /// Whether an end was not reached within six standard deviations: the band is open there.
    pub is_open: [bool; 2],
    /// Values with the rise of the minimised sum of squares.
    pub curve: Vec<[f64; 2]>,
}

/// Computes the values about `best` at which `rise`, the rise of the sum of squares minimised over all other variables,
/// is the square of `quantile`, the standard deviations of an end of the band.
///
/// ```text
/// { θ : min χ²(θ, ·) − min χ² ≤ q² }                                           [Profile-likelihood]
/// ```
///
/// `deviation` is the standard deviation by the curvature, the scale of the search. `rise` fails if there is no fit.
///
/// # Errors
/// The error of `rise`.
///
/// ```
/// use asperity_calibration::profile_likelihood::profile_band;
/// // The band of a parabola ends at 1.96 standard deviations.
/// let band = profile_band(2.0, 0.5, 1.96, |x| Ok::<f64, ()>(((x - 2.0) / 0.5).powi(2)))?;
/// assert!((band.ends[1] - 2.0 - 0.5 * 1.96).abs() < 1e-6);
/// # Ok::<(), ()>(())
/// ```
pub fn profile_band<E>(
    best: f64,
    deviation: f64,
    quantile: f64,
    mut rise: impl FnMut(f64) -> Result<f64, E>,
) -> Result<ProfileBand, E> {
    cite!("Profile-likelihood");
    /// Points of the curve on either side.
    const POINTS: i32 = 4;
    /// Length of the curve on either side relative to the band.
    const SHOWN: f64 = 1.25;
    /// Standard deviations within which an end is searched.
    const REACH: f64 = 6.0;
    let mut curve = Vec::new();
    for k in -POINTS..=POINTS {
        let at = best + deviation * quantile * SHOWN * f64::from(k) / f64::from(POINTS);
        let value = if k == 0 { 0.0 } else { rise(at)? };
        curve.push([at, value]);
    }
    let mut fault = None;
    let (mut ends, mut is_open) = ([0.0; 2], [false; 2]);
    for (side, sign) in [-1.0, 1.0].into_iter().enumerate() {
        // The square root of a parabola is linear, so the search converges quickly.
        let mut above = |steps: f64| match rise(best + sign * steps * deviation) {
            Ok(value) => value.max(0.0).sqrt() - quantile,
            Err(error) => {
                fault = Some(error);
                f64::NAN
            }
        };
        let reached = above(REACH) > 0.0;
        is_open[side] = !reached;
        let steps = if reached {
            find_root(above, 0.0, REACH, 1e-6).map_or(REACH, |root| root.value)
        } else {
            REACH
        };
        ends[side] = best + sign * steps * deviation;
    }
    match fault {
        Some(error) => Err(error),
        None => Ok(ProfileBand {
            ends,
            is_open,
            curve,
        }),
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// χ² = (x² − 2 c x y + y²)/(1 − c²) with the least over y put in: x².
    #[test]
    fn the_profile_of_a_correlated_parabola_has_the_marginal_band() {
        let c = 0.9;
        let rise = |x: f64| {
            let y = c * x;
            Ok::<f64, ()>((x * x - 2.0 * c * x * y + y * y) / (1.0 - c * c))
        };
        let band = profile_band(0.0, 1.0, 2.2, rise).unwrap();
        assert!((band.ends[0] + 2.2).abs() < 1e-5 && (band.ends[1] - 2.2).abs() < 1e-5);
        assert_eq!((band.is_open, band.curve.len()), ([false; 2], 9));
    }

    #[test]
    fn a_band_is_as_skew_as_its_likelihood_and_says_where_it_is_open() {
        // Flat to the right.
        let rise = |x: f64| Ok::<f64, ()>(if x < 0.0 { 4.0 * x * x } else { 0.01 * x * x });
        let band = profile_band(0.0, 1.0, 1.96, rise).unwrap();
        assert!((band.ends[0] + 0.5 * 1.96).abs() < 1e-5);
        assert_eq!((band.ends[1], band.is_open), (6.0, [false, true]));
        assert_eq!(
            profile_band(0.0, 1.0, 1.96, |_| Err("no fit")),
            Err("no fit")
        );
    }
}
