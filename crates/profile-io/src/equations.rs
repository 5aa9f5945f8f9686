//! The equations of this crate: the file, the formula and the test of each.

use asperity_core::{Equation, Reference};

/// Geometry of the involute.
pub const LITVIN_2004: Reference = Reference {
    key: "litvin_2004",
    text: "F. L. Litvin and A. Fuentes, Gear Geometry and Applied Theory, 2nd edition, Cambridge University Press 2004",
};

/// Equations of this crate.
pub const EQUATIONS: &[Equation] = &[Equation::new(
    "Roll-1",
    "Distance along an involute",
    "s = L²/(2 r_b), L = r_b ξ",
    "crates/profile-io/src/read/roll_length.rs",
    "a_wave_along_the_involute_keeps_its_length_and_height",
    &[LITVIN_2004],
)];
