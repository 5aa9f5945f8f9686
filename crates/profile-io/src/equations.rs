//! The equations of this crate: the file, the formula and the test of each.

use asperity_core::{Equation, Reference};

/// Geometry of the involute.
pub const LITVIN_2004: Reference = Reference {
    key: "litvin_2004",
    text: "F. L. Litvin and A. Fuentes, Gear Geometry and Applied Theory, 2nd edition, Cambridge University Press 2004",
};

/// Splines.
pub const DE_BOOR_1978: Reference = Reference {
    key: "de_boor_1978",
    text: "C. de Boor, A Practical Guide to Splines, Springer 1978",
};

/// Equations of this crate.
pub const EQUATIONS: &[Equation] = &[
    Equation::new(
        "Roll-1",
        "Distance along an involute",
        "s = L²/(2 r_b), L = r_b ξ",
        "crates/profile-io/src/read/roll_length.rs",
        "a_wave_along_the_involute_keeps_its_length_and_height",
        &[LITVIN_2004],
    ),
    Equation::new(
        "Spline-1",
        "Natural cubic spline",
        "S = (1−t) z_i + t z_(i+1) + (((1−t)³ − (1−t)) M_i + (t³ − t) M_(i+1)) h²/6",
        "crates/profile-io/src/read/natural_spline.rs",
        "a_natural_spline_through_three_points_is_that_of_the_closed_form",
        &[DE_BOOR_1978],
    ),
];
