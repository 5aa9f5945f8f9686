//! Partial slip of similar materials under a tangential load, for any profile.
//!
//! Source: Ciavarella 1998 and Jäger 1998: the traction is friction times the difference of two
//! normal pressures. Exact for half-planes of similar materials, and on the grid.
//!
//! | symbol | meaning | unit |
//! |---|---|---|
//! | p(W), q | pressure under the load W, traction | Pa |
//! | W, Q | normal and tangential load per metre of face width | N/m |
//! | μ | friction coefficient | - |

use asperity_core::quantity::LineLoad;
use asperity_core::{DomainError, cite};
use serde::Serialize;

use crate::error::ContactError;
use crate::problem::{ContactProblem, ContactSolution, Control, SolverSettings};
use crate::solver::Solver;

/// A contact under normal and tangential load.
#[derive(Debug, Clone, PartialEq, Serialize)]
#[non_exhaustive]
pub struct PartialSlip {
    /// The contact under the normal load.
    pub normal: ContactSolution,
    /// Traction q in Pa.
    pub traction: Vec<f64>,
    /// Whether a point sticks.
    pub stick: Vec<bool>,
}

/// q = ±μ·[p(W) − p(W − |Q|/μ)]; what touches under W − |Q|/μ sticks               [Slip-1]
///
/// The sign is that of the tangential load.
///
/// # Errors
/// When the problem controls the approach or has a pressure limit, the friction coefficient is not
/// positive, the tangential load exceeds what friction holds, or a contact is not solved.
///
/// ```
/// use asperity_contact::{Boundary, ContactProblem, Control, SolverSettings, friction::partial_slip};
/// let gap: Vec<f64> = (0..500).map(|i| (1.2e-6 * (f64::from(i) - 249.5)).powi(2) / 6e-3).collect();
/// let problem = ContactProblem {
///     gap: &gap, spacing: "1.2 um".parse()?, modulus: "115.4 GPa".parse()?,
///     boundary: Boundary::FreeEnds, control: Control::Load("300 N/mm".parse()?),
///     prescribed_pressure: None, pressure_limit: None, start: None,
/// };
/// let slip = partial_slip(&problem, 0.1, "15 N/mm".parse()?, &SolverSettings::default())?;
/// let carried: f64 = slip.traction.iter().sum::<f64>() * 1.2e-6;
/// assert!((carried - 15e3).abs() < 1e-3);
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
pub fn partial_slip(
    problem: &ContactProblem,
    friction: f64,
    tangential: LineLoad,
    settings: &SolverSettings,
) -> Result<PartialSlip, ContactError> {
    cite!("Slip-1");
    let mu = super::sliding::check_friction(friction)?;
    let Control::Load(load) = problem.control else {
        return Err(ContactError::LoadControlNeeded {
            purpose: "partial slip",
        });
    };
    if problem.pressure_limit.is_some() {
        return Err(ContactError::ElasticOnly {
            purpose: "partial slip",
        });
    }
    let q = DomainError::finite("tangential load", tangential)?;
    let core = load.si() - q.abs() / mu;
    DomainError::require(
        core >= 0.0,
        "tangential load",
        q,
        "N/m",
        "must not exceed friction times the normal load: lower it or raise the friction",
    )?;
    let mut solver = Solver::new(problem.gap.len(), problem.boundary)?;
    let normal = solver.solve(problem, settings)?;
    let sticking = if core > 0.0 {
        let below = ContactProblem {
            control: Control::Load(LineLoad::from_si(core)),
            start: Some(&normal.pressure),
            ..*problem
        };
        solver.solve(&below, settings)?.pressure
    } else {
        vec![0.0; normal.pressure.len()]
    };
    let mu = mu.copysign(q);
    let pairs = normal.pressure.iter().zip(&sticking);
    Ok(PartialSlip {
        traction: pairs.map(|(slip, stick)| mu * (slip - stick)).collect(),
        stick: sticking.iter().map(|&p| p > 0.0).collect(),
        normal,
    })
}
