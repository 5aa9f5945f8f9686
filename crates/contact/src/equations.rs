//! The equations of this crate, for `docs/EQUATIONS.md`.

use asperity_core::Equation;

/// Every equation of this crate.
pub const EQUATIONS: &[Equation] = &[];
