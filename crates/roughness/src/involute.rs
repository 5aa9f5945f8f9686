//! Removal of the involute from a flank that was traced from root to tip.
//!
//! Source: geometry of the involute (Litvin and Fuentes 2004, chapter 10).
//!
//! | symbol | meaning | unit |
//! |---|---|---|
//! | r_b | base radius | m |
//! | ρ₀ | roll length (radius of curvature) at the middle of the trace | m |
//! | ξ₀ | roll angle at the middle, ρ₀/r_b | rad |
//! | θ | roll angle from the middle | rad |
//! | x, z | coordinates along the tangent at the middle and out of the material | m |

use std::f64::consts::FRAC_PI_2;

use asperity_core::cite;
use asperity_core::quantity::Length;
use asperity_core::{DomainError, Profile};
use serde::{Deserialize, Serialize};

use crate::error::RoughnessError;
use crate::form::fit;
use crate::warning::Warning;

/// Location of a trace on an involute.
#[derive(Debug, Clone, Copy, PartialEq, Serialize, Deserialize)]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
#[serde(rename_all = "kebab-case", deny_unknown_fields)]
pub struct Involute {
    /// Base radius r_b.
    pub base_radius: Length,
    /// Roll length ρ₀ at the middle of the trace.
    pub roll_length: Length,
    /// Whether the trace runs towards the root.
    pub towards_root: bool,
}

/// x(θ) = r_b (cos θ + ξ sin θ − 1),  z(θ) = r_b (ξ cos θ − sin θ − ξ₀),  ξ = ξ₀ + θ    `[Form-3]`
///
/// Heights of the involute `[m]` at distances `x` `[m]` from the middle of the trace, towards the tip.
///
/// # Errors
/// When a length is not positive, or the trace reaches below the base circle.
///
/// ```
/// use asperity_core::quantity::Length;
/// use asperity_roughness::involute::{Involute, heights};
/// let flank = Involute { base_radius: Length::from_si(50e-3), roll_length: Length::from_si(15e-3), towards_root: false };
/// // Near the middle the involute is a circle of radius ρ₀.
/// let z = heights(&flank, &[0.1e-3])?;
/// assert!((z[0] + 0.1e-3_f64.powi(2) / (2.0 * 15e-3)).abs() < 5e-9);
/// # Ok::<(), asperity_roughness::RoughnessError>(())
/// ```
pub fn heights(flank: &Involute, x: &[f64]) -> Result<Vec<f64>, RoughnessError> {
    cite!("Form-3");
    // Newton steps decrease to the rounding error of x(θ), 1e-16/ξ, where ξ is 0.01 near the root. A step of 1e-12
    // changes x by less than a picometre on any gear, and the next step would be of the order of its square.
    const TOLERANCE: f64 = 1e-12;
    const MAX_ITERATIONS: usize = 50;
    let rb = DomainError::positive("base radius", flank.base_radius)?;
    let roll = DomainError::positive("roll length", flank.roll_length)?;
    let start = roll / rb;
    // x falls from the middle to the base circle, or by a quarter of a turn if that is nearer.
    let turned = start.min(FRAC_PI_2);
    let lowest = rb * (turned.cos() - (start - turned) * turned.sin() - 1.0);
    let at = |x: f64| -> Result<f64, RoughnessError> {
        DomainError::require(
            x > lowest,
            "roll length",
            roll,
            "m",
            "is too short: the trace reaches below the base circle",
        )?;
        // x is approximately the arc length of the involute, r_b ξ²/2.
        let squared = (start * start + 2.0 * x / rb).max(1e-6 * start * start);
        let mut theta = squared.sqrt() - start;
        let mut step = f64::INFINITY;
        for _ in 0..MAX_ITERATIONS {
            let xi = start + theta;
            let reached = rb * (theta.cos() + xi * theta.sin() - 1.0);
            // dx/dθ = r_b ξ cos θ.
            step = (x - reached) / (rb * xi * theta.cos());
            // The flank ends at the base circle.
            step = step.max(-0.5 * xi);
            theta += step;
            if step.abs() <= TOLERANCE * (1.0 + theta.abs()) {
                let xi = start + theta;
                return Ok(rb * (xi * theta.cos() - theta.sin() - start));
            }
        }
        Err(RoughnessError::NotConverged {
            what: "the roll angle",
            iterations: MAX_ITERATIONS,
            residual: step.abs(),
        })
    };
    x.iter().map(|x| at(*x)).collect()
}

/// Removes the involute and the remaining tilt and offset from a profile.
///
/// # Errors
/// As [`heights`].
///
/// ```
/// use asperity_core::{Profile, quantity::Length};
/// use asperity_roughness::involute::{Involute, heights, remove};
/// let flank = Involute { base_radius: Length::from_si(50e-3), roll_length: Length::from_si(15e-3), towards_root: false };
/// let x: Vec<f64> = (0..2001).map(|i| 1e-6 * (f64::from(i) - 1000.0)).collect();
/// let profile = Profile::new(Length::from_si(1e-6), heights(&flank, &x)?)?;
/// assert!(remove(&profile, &flank)?.heights().iter().all(|z| z.abs() < 1e-12));
/// # Ok::<(), asperity_roughness::RoughnessError>(())
/// ```
pub fn remove(profile: &Profile, flank: &Involute) -> Result<Profile, RoughnessError> {
    let level = level(profile.heights(), profile.spacing().si(), flank)?;
    Ok(Profile::new(profile.spacing(), level)?)
}

/// Removes the involute and the remaining line from heights `z` with spacing `dx`.
fn level(z: &[f64], dx: f64, flank: &Involute) -> Result<Vec<f64>, RoughnessError> {
    let n = z.len();
    let middle = 0.5 * (n.max(1) - 1) as f64;
    let sign = if flank.towards_root { -1.0 } else { 1.0 };
    let x: Vec<f64> = (0..n).map(|i| sign * dx * (i as f64 - middle)).collect();
    let form = heights(flank, &x)?;
    let rest: Vec<f64> = z.iter().zip(&form).map(|(z, f)| z - f).collect();
    let line = fit(&rest, 1)?;
    let rest = rest.iter().enumerate();
    Ok(rest.map(|(i, z)| z - line.at(i)).collect())
}

/// ρ̂ = argmin over ρ₀ of Σ (zᵢ − z(xᵢ; ρ₀, r_b) − line)²                        `[Form-4]`
///
/// Best-fit roll length at the middle of `profile` with the base radius of `flank`, by golden section search in 1/ρ₀.
/// At most two thousand points are used, because an involute is smooth.
///
/// # Errors
/// When the profile has too few points, or a length of `flank` is not positive.
///
/// ```
/// use asperity_core::{Profile, quantity::Length};
/// use asperity_roughness::involute::{Involute, fitted_roll_length, heights};
/// let flank = Involute { base_radius: Length::from_si(50e-3), roll_length: Length::from_si(15e-3), towards_root: false };
/// let x: Vec<f64> = (0..2001).map(|i| 1e-6 * (f64::from(i) - 1000.0)).collect();
/// let profile = Profile::new(Length::from_si(1e-6), heights(&flank, &x)?)?;
/// let wrong = Involute { roll_length: Length::from_si(17e-3), ..flank };
/// assert!((fitted_roll_length(&profile, &wrong)?.si() / 15e-3 - 1.0).abs() < 1e-6);
/// # Ok::<(), asperity_roughness::RoughnessError>(())
/// ```
pub fn fitted_roll_length(profile: &Profile, flank: &Involute) -> Result<Length, RoughnessError> {
    cite!("Form-4");
    const POINTS: usize = 2000;
    const STEPS: usize = 80;
    // Maximum roll length, relative to the given one.
    const MAX_RATIO: f64 = 20.0;
    let stride = profile.len().div_ceil(POINTS);
    let z: Vec<f64> = profile.heights().iter().copied().step_by(stride).collect();
    let dx = profile.spacing().si() * stride as f64;
    let half = 0.5 * dx * (z.len() - 1) as f64;
    // The trace must not reach below the base circle: ρ₀² > 2 r_b x.
    let base = DomainError::positive("base radius", flank.base_radius)?;
    let given = DomainError::positive("roll length", flank.roll_length)?;
    let shortest = 1.001 * (2.0 * base * half).sqrt();
    let square = |curvature: f64| -> Result<f64, RoughnessError> {
        let roll_length = Length::from_si(1.0 / curvature);
        let tried = Involute {
            roll_length,
            ..*flank
        };
        let rest = level(&z, dx, &tried)?;
        Ok(rest.iter().map(|z| z * z).sum())
    };
    let golden = 0.5 * (5.0_f64.sqrt() - 1.0);
    let (mut low, mut high) = (1.0 / (MAX_RATIO * given.max(shortest)), 1.0 / shortest);
    let mut inner = [high - golden * (high - low), low + golden * (high - low)];
    let mut squares = [square(inner[0])?, square(inner[1])?];
    for _ in 0..STEPS {
        if squares[0] < squares[1] {
            high = inner[1];
            inner = [high - golden * (high - low), inner[0]];
            squares = [square(inner[0])?, squares[0]];
        } else {
            low = inner[0];
            inner = [inner[1], low + golden * (high - low)];
            squares = [squares[1], square(inner[1])?];
        }
    }
    Ok(Length::from_si(2.0 / (low + high)))
}

/// Warning about a parabola or a cubic that remains in `profile` after removal of the involute `flank`: the flank is
/// crowned, or its base radius or roll length is wrong.
///
/// # Errors
/// As [`fitted_roll_length`].
///
/// ```
/// use asperity_core::{Profile, quantity::Length};
/// use asperity_roughness::involute::{Involute, form_left, heights};
/// let flank = Involute { base_radius: Length::from_si(50e-3), roll_length: Length::from_si(15e-3), towards_root: false };
/// let x: Vec<f64> = (0..2001).map(|i| 1e-6 * (f64::from(i) - 1000.0)).collect();
/// let mut z = heights(&flank, &x)?;
/// z.iter_mut().enumerate().for_each(|(i, z)| *z += 0.3e-6 * (0.3 * i as f64).sin());
/// let profile = Profile::new(Length::from_si(1e-6), z)?;
/// assert!(form_left(&profile, &flank)?.is_none());
/// let wrong = Involute { roll_length: Length::from_si(17e-3), ..flank };
/// assert!(form_left(&profile, &wrong)?.unwrap().to_string().contains("a roll length of 15"));
/// # Ok::<(), asperity_roughness::RoughnessError>(())
/// ```
pub fn form_left(profile: &Profile, flank: &Involute) -> Result<Option<Warning>, RoughnessError> {
    // Long waves of the roughness cause a parabola of up to about one Rq.
    const NOTICEABLE: f64 = 1.0;
    let rest = level(profile.heights(), profile.spacing().si(), flank)?;
    let parabola = fit(&rest, 2)?;
    let n = rest.len() as f64;
    let position = |i: usize| (2 * i) as f64 / (n - 1.0).max(1.0) - 1.0;
    // t³ − t ⟨t⁴⟩/⟨t²⟩ is orthogonal to the line and, being odd, to the parabola.
    let even = |power: i32| {
        (0..rest.len())
            .map(|i| position(i).powi(power))
            .sum::<f64>()
            / n
    };
    let share = even(4) / even(2);
    let cubic = |i: usize| position(i).powi(3) - share * position(i);
    let (product, norm) = rest.iter().enumerate().fold((0.0, 0.0), |(p, s), (i, z)| {
        let c = cubic(i);
        (p + z * c, s + c * c)
    });
    let coefficient = if norm > 0.0 { product / norm } else { 0.0 };
    let (mut form, mut left) = (0.0, 0.0);
    for (i, z) in rest.iter().enumerate() {
        let smooth = parabola.at(i) + coefficient * cubic(i);
        form += smooth * smooth;
        left += (z - smooth).powi(2);
    }
    let (form, left) = ((form / n).sqrt(), (left / n).sqrt());
    // Rounding errors of heights with a large offset are not form.
    let largest = profile
        .heights()
        .iter()
        .fold(0.0_f64, |m, z| m.max(z.abs()));
    if form <= NOTICEABLE * left + 1e3 * f64::EPSILON * largest {
        return Ok(None);
    }
    Ok(Some(Warning::InvoluteLeft {
        form: Length::from_si(form),
        roughness: Length::from_si(left),
        parabola: parabola.sag(),
        given: flank.roll_length,
        fitted: fitted_roll_length(profile, flank)?,
    }))
}

#[cfg(test)]
mod tests {
    use super::*;

    /// An involute with roughness on it, spaced by 0.5 um, about its middle.
    fn rough(flank: &Involute, points: usize) -> Profile {
        let middle = 0.5 * (points - 1) as f64;
        let sign = if flank.towards_root { -1.0 } else { 1.0 };
        let x: Vec<f64> = (0..points)
            .map(|i| sign * 0.5e-6 * (i as f64 - middle))
            .collect();
        let mut z = heights(flank, &x).unwrap();
        for (i, z) in z.iter_mut().enumerate() {
            *z += 0.4e-6 * (0.21 * i as f64).sin() + 0.2e-6 * (0.033 * i as f64).cos();
        }
        Profile::new(Length::from_si(0.5e-6), z).unwrap()
    }

    fn flank(base: f64, roll: f64) -> Involute {
        Involute {
            base_radius: Length::from_si(base),
            roll_length: Length::from_si(roll),
            towards_root: false,
        }
    }

    #[test]
    fn traces_near_the_root_converge() {
        // Down to a roll angle of a fiftieth of a radian, the trace from almost the base circle on.
        for (base, roll) in [
            (50e-3_f64, 15e-3_f64),
            (50e-3, 1e-3),
            (20e-3, 0.4e-3),
            (300e-3, 6e-3),
        ] {
            let longest = base * (1.0 - (roll / base).cos());
            let x: Vec<f64> = (0..4001)
                .map(|i| 0.999 * longest * (f64::from(i) / 2000.0 - 1.0))
                .collect();
            let z = heights(&flank(base, roll), &x).unwrap();
            assert!(z.iter().all(|z| z.is_finite()));
        }
    }

    #[test]
    fn a_wrong_roll_length_is_named_with_the_fitted_one() {
        for towards_root in [false, true] {
            let right = Involute {
                towards_root,
                ..flank(50e-3, 15e-3)
            };
            let profile = rough(&right, 4001);
            assert_eq!(form_left(&profile, &right).unwrap(), None);
            let wrong = Involute {
                roll_length: Length::from_si(12e-3),
                ..right
            };
            let Some(Warning::InvoluteLeft {
                form,
                roughness,
                fitted,
                ..
            }) = form_left(&profile, &wrong).unwrap()
            else {
                panic!("nothing found");
            };
            // The difference of two parabolas over ±1 mm is 1/2 (1/12 − 1/15) mm high, √(4/45) of it as rms; the
            // higher orders of the involute add a tenth.
            assert!((form.si() / 2.5e-6 - 1.0).abs() < 0.15, "{form}");
            assert!((roughness.si() / 0.316e-6 - 1.0).abs() < 0.2, "{roughness}");
            assert!((fitted.si() / 15e-3 - 1.0).abs() < 1e-3, "{fitted}");
        }
    }
}
