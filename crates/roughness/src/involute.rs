//! The involute taken off a flank that was traced from root to tip.
//!
//! Source: geometry of the involute (Litvin and Fuentes 2004, chapter 10).
//!
//! | symbol | meaning | unit |
//! |---|---|---|
//! | r_b | base radius | m |
//! | ρ₀ | roll length (radius of curvature) at the middle of the trace | m |
//! | ξ₀ | roll angle there, ρ₀/r_b | rad |
//! | θ | roll angle from there | rad |
//! | x, z | along the tangent at the middle, out of the material | m |

use asperity_core::cite;
use asperity_core::quantity::Length;
use asperity_core::{DomainError, Profile};
use schemars::JsonSchema;
use serde::{Deserialize, Serialize};

use crate::error::RoughnessError;
use crate::form::fit;

/// Where on an involute a trace lies.
#[derive(Debug, Clone, Copy, PartialEq, Serialize, Deserialize, JsonSchema)]
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
/// // Near the middle it is a circle of radius ρ₀.
/// let z = heights(&flank, &[0.1e-3])?;
/// assert!((z[0] + 0.1e-3_f64.powi(2) / (2.0 * 15e-3)).abs() < 5e-9);
/// # Ok::<(), asperity_roughness::RoughnessError>(())
/// ```
pub fn heights(flank: &Involute, x: &[f64]) -> Result<Vec<f64>, RoughnessError> {
    cite!("Form-3");
    // A step of the roll angle that moves x by less than a rounding error.
    const SETTLED: f64 = 1e-15;
    const MOST: usize = 50;
    let rb = DomainError::positive("base radius", flank.base_radius)?;
    let roll = DomainError::positive("roll length", flank.roll_length)?;
    let start = roll / rb;
    let at = |x: f64| -> Result<f64, RoughnessError> {
        // Arc length along the involute is r_b ξ²/2, and x is nearly that.
        let squared = start * start + 2.0 * x / rb;
        DomainError::require(
            squared > 0.0,
            "roll length",
            roll,
            "m",
            "is too short: the trace reaches below the base circle",
        )?;
        let mut theta = squared.sqrt() - start;
        let mut step = f64::INFINITY;
        for _ in 0..MOST {
            let xi = start + theta;
            let found = rb * (theta.cos() + xi * theta.sin() - 1.0);
            // dx/dθ = r_b ξ cos θ.
            step = (x - found) / (rb * xi * theta.cos());
            theta += step;
            if step.abs() <= SETTLED * (1.0 + theta.abs()) {
                let xi = start + theta;
                return Ok(rb * (xi * theta.cos() - theta.sin() - start));
            }
        }
        Err(RoughnessError::NotConverged {
            what: "the roll angle",
            iterations: MOST,
            residual: step.abs(),
        })
    };
    x.iter().map(|x| at(*x)).collect()
}

/// The profile without its involute, and without the tilt and offset that setting up leaves.
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
    let n = profile.len();
    let middle = 0.5 * (n.max(1) - 1) as f64;
    let sign = if flank.towards_root { -1.0 } else { 1.0 };
    let dx = profile.spacing().si();
    let x: Vec<f64> = (0..n).map(|i| sign * dx * (i as f64 - middle)).collect();
    let form = heights(flank, &x)?;
    let rest: Vec<f64> = profile
        .heights()
        .iter()
        .zip(&form)
        .map(|(z, f)| z - f)
        .collect();
    let line = fit(&rest, 1)?;
    let level = rest
        .iter()
        .enumerate()
        .map(|(i, z)| z - line.at(i))
        .collect();
    Ok(Profile::new(profile.spacing(), level)?)
}
