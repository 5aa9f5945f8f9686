//! Shakedown limit of repeated sliding line contact.
//!
//! A contact that passes over a surface again and again leaves residual stresses that depend on the depth only, without shear
//! in the planes of the surface. They can cancel all differences of normal stresses, so that the passes stay elastic as
//! long as the shear stress in these planes nowhere exceeds the yield stress in shear (Melan's theorem; Johnson 1985,
//! section 9.2). Below the indentation hardness and above first yield: asperities of run-in flanks have this pressure.
//!
//! | symbol | meaning | unit |
//! |---|---|---|
//! | p_s | largest Hertz pressure of the limit | Pa |
//! | H, k | indentation hardness, yield stress in shear | Pa |
//! | μ | friction coefficient of the sliding contact | - |
//! | τ_xz | shear stress in planes of the surface under a Hertz pressure p₀ with the traction μ p | Pa |
//!
//! Asperities are ridges across the face and are taken as Hertz contacts. A flattened one, whose pressure is uniform, has its
//! limit at π k without friction.

use asperity_core::quantity::{Length, Pressure};
use asperity_core::{DomainError, cite};

use crate::error::ContactError;
use crate::hertz_line::HertzLine;
use crate::plasticity::FLOW_OVER_YIELD;
use crate::subsurface::hertz_stress;

/// Points of the grid to either side of its middle, in the first level and in the others.
const GRID: [usize; 2] = [12, 4];
/// Levels of the search for the largest shear stress, each on a smaller grid.
const LEVELS: usize = 7;
/// Parts of the grid to which the next level extends.
const NEXT: f64 = 1.25;

/// Largest Hertz pressure at which a sliding line contact that is repeated stays elastic in the end.
///
/// ```text
/// p_s = k p₀/max|τ_xz|,  k = H/(3√3)                                            [Shakedown-1]
/// ```
///
/// p_s/k is 4 without friction and 1/μ above μ = 0.367, where the surface flows.
///
/// # Errors
/// When the hardness is not positive, or the friction coefficient is negative.
///
/// ```
/// use asperity_contact::shakedown::shakedown_pressure;
/// let frictionless = shakedown_pressure("7 GPa".parse()?, 0.0)?;
/// assert!((frictionless.si() / 7e9 - 4.0 / 27.0_f64.sqrt()).abs() < 1e-6);
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
pub fn shakedown_pressure(hardness: Pressure, friction: f64) -> Result<Pressure, ContactError> {
    cite!("Shakedown-1");
    let hardness = DomainError::positive("hardness", hardness)?;
    let rule = "must be finite and not negative";
    let holds = friction.is_finite() && friction >= 0.0;
    DomainError::require(holds, "friction coefficient", friction, "-", rule)?;
    let yield_in_shear = hardness / (FLOW_OVER_YIELD * 3.0_f64.sqrt());
    // On the surface the shear stress is the traction.
    let largest = largest_shear(friction)?.max(friction);
    Ok(Pressure::from_si(yield_in_shear / largest))
}

/// Largest shear stress below the surface in planes of the surface, over the largest pressure.
fn largest_shear(friction: f64) -> Result<f64, ContactError> {
    let contact = HertzLine {
        half_width: Length::from_si(1.0),
        max_pressure: Pressure::from_si(1.0),
    };
    let (mut largest, mut at, mut reach) = (0.0, [0.0, 0.6], [1.5, 0.5]);
    for level in 0..LEVELS {
        let half = GRID[level.min(1)] as i32;
        let middle = at;
        let place =
            |axis: usize, step: i32| middle[axis] + reach[axis] * f64::from(step) / f64::from(half);
        for [i, j] in (-half..=half).flat_map(|i| (-half..=half).map(move |j| [i, j])) {
            let [x, z] = [place(0, i), place(1, j).max(0.0)];
            let stress = hertz_stress(&contact, friction, Length::from_si(x), Length::from_si(z))?;
            let shear = stress.tau_xz.si().abs();
            if shear > largest {
                (largest, at) = (shear, [x, z]);
            }
        }
        reach = reach.map(|reach| NEXT * reach / f64::from(half));
    }
    Ok(largest)
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::subsurface::strip_unit;

    #[test]
    fn limits_are_those_of_stresses_of_point_forces() {
        // Computed by references/shakedown.py: p_s/k.
        let yield_in_shear = 0.192_450_09;
        for (friction, limit) in [
            (0.0, 4.0),
            (0.05, 3.771_815),
            (0.09, 3.604_189),
            (0.2, 3.202_365),
            (0.3, 2.899_575),
        ] {
            let found = shakedown_pressure(Pressure::from_si(1.0), friction)
                .unwrap()
                .si();
            let found = found / yield_in_shear;
            assert!((found / limit - 1.0).abs() < 1e-5, "{friction}: {found}");
        }
    }

    #[test]
    fn above_a_friction_of_0_367_the_surface_flows() {
        let limit = |friction: f64| {
            shakedown_pressure(Pressure::from_si(27.0_f64.sqrt()), friction)
                .unwrap()
                .si()
        };
        assert!((limit(0.5) - 2.0).abs() < 1e-12);
        assert!(limit(0.367) > limit(0.368) && (limit(0.3675) - 1.0 / 0.3675).abs() < 2e-3);
        // Below the hardness for any friction, and falling.
        let limits: Vec<f64> = (0..10).map(|i| limit(0.1 * f64::from(i))).collect();
        assert!(limits.is_sorted_by(|a, b| a > b) && limits[0] < 27.0_f64.sqrt());
    }

    #[test]
    fn a_flattened_asperity_has_its_limit_below_that_of_hertz() {
        let [edge, depth, half_width] = [1.0, 1e-6, 1.0].map(Length::from_si);
        let stress = strip_unit(edge, depth, half_width).unwrap();
        let limit = 1.0 / stress.xz_of_pressure.abs();
        let hertz = shakedown_pressure(Pressure::from_si(27.0_f64.sqrt()), 0.0).unwrap();
        assert!(
            (limit - std::f64::consts::PI).abs() < 1e-5 && limit < hertz.si(),
            "{limit}"
        );
    }

    #[test]
    fn what_is_not_a_hardness_or_a_friction_coefficient_is_refused() {
        let one = Pressure::from_si(1.0);
        for (hardness, friction) in [
            (Pressure::from_si(0.0), 0.1),
            (one, -0.1),
            (one, f64::NAN),
            (one, f64::INFINITY),
        ] {
            assert!(shakedown_pressure(hardness, friction).is_err());
        }
    }
}
