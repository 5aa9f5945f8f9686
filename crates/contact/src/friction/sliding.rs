//! Full sliding of dissimilar materials: the traction tilts the pressure.
//!
//! Source: Dundurs 1969; Johnson 1985, section 7.1. Plane strain, free ends, quasi-static.
//!
//! | symbol | meaning | unit |
//! |---|---|---|
//! | p, q = μ·p | pressure, traction towards +x on the body below | Pa |
//! | E*, β | reduced modulus, Dundurs' second constant | Pa, - |
//! | G, ν | shear modulus, Poisson's ratio of a body | Pa, - |
//! | μ, γ | friction coefficient, shift of the exponents of the pressure | - |
//! | b, R | half width of the contact, relative radius | m |

use std::f64::consts::PI;

use asperity_core::material::Material;
use asperity_core::quantity::{Length, LineLoad, Pressure};
use asperity_core::{DomainError, cite};
use serde::Serialize;

use crate::boundary::Boundary;
use crate::error::ContactError;
use crate::problem::{ContactProblem, ContactSolution, SolverSettings};
use crate::solver::Solver;

/// β = ½·[(1 − 2ν₁)/G₁ − (1 − 2ν₂)/G₂]/[(1 − ν₁)/G₁ + (1 − ν₂)/G₂]                [Dundurs-1]
///
/// `below` (1) is the body that the traction pulls towards +x; equal bodies, and any two
/// incompressible ones, have β = 0.
///
/// # Errors
/// When a modulus is not positive or a Poisson's ratio is outside −1 < ν ≤ 0.5.
pub fn dundurs(below: &Material, above: &Material) -> Result<f64, ContactError> {
    cite!("Dundurs-1");
    // (1 − ν)/G = 2·(1 − ν²)/E and (1 − 2ν)/G = 2·(1 + ν)(1 − 2ν)/E
    let volume = |m: &Material| -> Result<[f64; 2], ContactError> {
        let compliance = m.compliance()?;
        let young = DomainError::positive("Young's modulus", m.young)?;
        Ok([
            (1.0 + m.poisson) * (1.0 - 2.0 * m.poisson) / young,
            compliance,
        ])
    };
    let ([v1, c1], [v2, c2]) = (volume(below)?, volume(above)?);
    Ok(0.5 * (v1 - v2) / (c1 + c2))
}

/// p(x) = (E*/2R)·cos(πγ)·(b + x)^(½ − γ)·(b − x)^(½ + γ), tan(πγ) = β·μ            [Sliding-2]
///
/// Pressure of a cylinder that slides, x from the middle of the contact, whose half width is
/// b = √(4·W·R/(π·E*·(1 − 4γ²))) and whose middle lies 2·γ·b behind the lowest point of the cylinder.
///
/// # Errors
/// When load, radius or modulus is not positive, or β·μ or the position is not finite.
///
/// ```
/// use asperity_contact::friction::sliding_pressure;
/// use asperity_contact::hertz_line::HertzLine;
/// let (load, radius, modulus) = ("300 N/mm".parse()?, "3 mm".parse()?, "115.4 GPa".parse()?);
/// let hertz = HertzLine::new(load, radius, modulus)?;
/// let x = "40 um".parse()?;
/// let still = sliding_pressure(load, radius, modulus, 0.0, x)?;
/// assert!((still / hertz.pressure(x)? - 1.0).abs() < 1e-12);
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
pub fn sliding_pressure(
    load: LineLoad,
    radius: Length,
    modulus: Pressure,
    beta_mu: f64,
    position: Length,
) -> Result<Pressure, ContactError> {
    cite!("Sliding-2");
    let w = DomainError::positive("load", load)?;
    let r = DomainError::positive("relative radius", radius)?;
    let e = DomainError::positive("reduced modulus", modulus)?;
    let x = DomainError::finite("position", position)?;
    let rule = "must be finite";
    DomainError::require(beta_mu.is_finite(), "beta mu", beta_mu, "-", rule)?;
    let gamma = beta_mu.atan() / PI;
    let b = (4.0 * w * r / (PI * e * (1.0 - 4.0 * gamma * gamma))).sqrt();
    if x.abs() >= b {
        return Ok(Pressure::from_si(0.0));
    }
    let shape = (b + x).powf(0.5 - gamma) * (b - x).powf(0.5 + gamma);
    Ok(Pressure::from_si(
        e / (2.0 * r) * (PI * gamma).cos() * shape,
    ))
}

/// Friction and mismatch of sliding bodies, and when their fixed point is found.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct SlidingSettings {
    /// Friction coefficient μ.
    pub friction: f64,
    /// Dundurs' β (see [`dundurs`]).
    pub beta: f64,
    /// Largest change of the pressure over its largest value from one step to the next.
    pub tolerance: f64,
    /// Most steps.
    pub max_steps: usize,
}

/// A sliding contact of dissimilar bodies.
#[derive(Debug, Clone, PartialEq, Serialize)]
#[non_exhaustive]
pub struct Sliding {
    /// The contact; its displacement is that of the pressure alone.
    pub contact: ContactSolution,
    /// Traction q in Pa.
    pub traction: Vec<f64>,
    /// Steps of the fixed point.
    pub steps: usize,
    /// Change of the pressure in the last step over its largest value.
    pub residual: f64,
}

/// u_c(x) = (β·μ/E*)·∫ p(s)·sgn(x − s) ds, added to the gap until p no longer changes  [Sliding-1]
///
/// # Errors
/// When the ends are periodic, a setting is not sensible, a contact is not solved or the fixed
/// point is not reached.
pub fn solve_sliding(
    problem: &ContactProblem,
    sliding: &SlidingSettings,
    settings: &SolverSettings,
) -> Result<Sliding, ContactError> {
    cite!("Sliding-1");
    if problem.boundary != Boundary::FreeEnds {
        return Err(ContactError::FreeEndsNeeded {
            purpose: "sliding of dissimilar bodies",
        });
    }
    let mu = check_friction(sliding.friction)?;
    let (beta, tolerance) = (sliding.beta, sliding.tolerance);
    let rule = "must lie between -0.5 and 0.5";
    DomainError::require(beta.abs() <= 0.5, "beta", beta, "-", rule)?;
    let rule = "must be finite and positive";
    let sensible = tolerance.is_finite() && tolerance > 0.0;
    DomainError::require(sensible, "tolerance", tolerance, "-", rule)?;
    let mut solver = Solver::new(problem.gap.len(), problem.boundary)?;
    let mut contact = solver.solve(problem, settings)?;
    let coupling = beta * mu * problem.spacing.si() / problem.modulus.si();
    let mut residual = f64::INFINITY;
    for steps in 1..=sliding.max_steps {
        let gap = coupled_gap(problem.gap, &contact.pressure, coupling);
        let next = solver.solve(
            &ContactProblem {
                gap: &gap,
                start: Some(&contact.pressure),
                ..*problem
            },
            settings,
        )?;
        let pairs = next.pressure.iter().zip(&contact.pressure);
        let change = pairs.fold(0.0, |m, (a, b)| f64::max(m, (a - b).abs()));
        residual = change / next.max_pressure.si();
        contact = next;
        if residual <= tolerance {
            return Ok(Sliding {
                traction: contact.pressure.iter().map(|p| mu * p).collect(),
                contact,
                steps,
                residual,
            });
        }
    }
    Err(ContactError::NoFixedPoint {
        steps: sliding.max_steps,
        residual,
        tolerance,
    })
}

/// h + u_c in m, by sums of the pressure on either side; half of a cell lies on each side of its
/// middle.
fn coupled_gap(gap: &[f64], pressure: &[f64], coupling: f64) -> Vec<f64> {
    let total: f64 = pressure.iter().sum();
    let mut before = 0.0;
    let mut point = |(h, p): (&f64, &f64)| {
        let behind = before + 0.5 * p;
        before += p;
        h + coupling * (2.0 * behind - total)
    };
    gap.iter().zip(pressure).map(&mut point).collect()
}

/// μ > 0
pub(super) fn check_friction(friction: f64) -> Result<f64, DomainError> {
    DomainError::require(
        friction.is_finite() && friction > 0.0,
        "friction coefficient",
        friction,
        "-",
        "must be finite and positive",
    )
}

#[cfg(test)]
mod tests {
    use asperity_core::quantity::{Density, SpecificHeat, ThermalConductivity};

    use super::*;

    #[test]
    fn equal_bodies_do_not_couple_and_a_rigid_one_couples_most() {
        let steel = Material {
            young: Pressure::from_si(210e9),
            poisson: 0.3,
            elastic_limit: Pressure::from_si(900e6),
            density: Density::from_si(7830.0),
            conductivity: ThermalConductivity::from_si(45.0),
            heat_capacity: SpecificHeat::from_si(465.0),
        };
        assert_eq!(dundurs(&steel, &steel).unwrap(), 0.0);
        let rigid = Material {
            young: Pressure::from_si(210e19),
            ..steel
        };
        // (1 − 2ν)/(2(1 − ν)) = 0.4/1.4
        assert!((dundurs(&steel, &rigid).unwrap() - 0.4 / 1.4).abs() < 1e-9);
        assert!((dundurs(&rigid, &steel).unwrap() + 0.4 / 1.4).abs() < 1e-9);
        let rubber = Material {
            young: Pressure::from_si(1e6),
            poisson: 0.5,
            ..steel
        };
        assert!(dundurs(&rubber, &rigid).unwrap().abs() < 1e-9);
    }

    #[test]
    fn the_coupled_gap_adds_what_lies_behind_and_takes_what_lies_ahead() {
        let gap = coupled_gap(&[0.0; 3], &[1.0, 2.0, 3.0], 0.5);
        assert_eq!(gap, [-2.5, -1.0, 1.5]);
    }
}
