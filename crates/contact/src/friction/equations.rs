//! The equations of friction, for `docs/EQUATIONS.md`.

use asperity_core::material::JOHNSON_1985;
use asperity_core::{Equation, Reference};

const MINDLIN_1949: Reference = Reference {
    key: "mindlin_1949",
    text: "R. D. Mindlin, Compliance of elastic bodies in contact, Journal of Applied Mechanics 16 (1949) 259-268",
};
const CARTER_1926: Reference = Reference {
    key: "carter_1926",
    text: "F. W. Carter, On the action of a locomotive driving wheel, Proceedings of the Royal Society A 112 (1926) 151-157",
};
const CIAVARELLA_1998: Reference = Reference {
    key: "ciavarella_1998",
    text: "M. Ciavarella, The generalized Cattaneo partial slip plane contact problem, International Journal of Solids and Structures 35 (1998) 2349-2378",
};
const DUNDURS_1969: Reference = Reference {
    key: "dundurs_1969",
    text: "J. Dundurs, Discussion of a paper by D. B. Bogy, Journal of Applied Mechanics 36 (1969) 650-652",
};

/// Every equation of friction.
pub const EQUATIONS: &[Equation] = &[
    Equation {
        tag: "Mindlin-1",
        title: "Stick zone of a Hertz contact under a tangential load",
        formula: "c = b·√(1 − |Q|/(μ·W))",
        file: "crates/contact/src/friction/mindlin.rs",
        test: "the_traction_carries_the_tangential_load_and_nowhere_exceeds_friction",
        references: &[MINDLIN_1949, JOHNSON_1985],
        misprint: None,
    },
    Equation {
        tag: "Mindlin-2",
        title: "Traction of a Hertz contact under a tangential load",
        formula: "q = ±μ·p₀·[√(1 − x²/b²) − (c/b)·√(1 − x²/c²)]",
        file: "crates/contact/src/friction/mindlin.rs",
        test: "partial_slip_on_the_grid_has_the_traction_of_mindlin",
        references: &[MINDLIN_1949, JOHNSON_1985],
        misprint: None,
    },
    Equation {
        tag: "Carter-1",
        title: "Traction of a rolling cylinder",
        formula: "q = ±μ·p₀·[√(1 − x²/b²) − (c/b)·√(1 − (x − d)²/c²)]",
        file: "crates/contact/src/friction/carter.rs",
        test: "the_traction_of_carter_creeps_evenly_where_it_sticks",
        references: &[CARTER_1926, JOHNSON_1985],
        misprint: None,
    },
    Equation {
        tag: "Carter-2",
        title: "Creepage of a rolling cylinder",
        formula: "ξ = −(±μ·b/R)·[1 − √(1 − |Q|/(μ·W))]",
        file: "crates/contact/src/friction/carter.rs",
        test: "the_traction_of_carter_creeps_evenly_where_it_sticks",
        references: &[CARTER_1926, JOHNSON_1985],
        misprint: None,
    },
    Equation {
        tag: "Slip-1",
        title: "Partial slip of any profile",
        formula: "q = ±μ·[p(W) − p(W − |Q|/μ)]",
        file: "crates/contact/src/friction/partial_slip.rs",
        test: "what_sticks_in_partial_slip_is_displaced_alike",
        references: &[CIAVARELLA_1998],
        misprint: None,
    },
    Equation {
        tag: "Dundurs-1",
        title: "Mismatch of two materials",
        formula: "β = ½·[(1 − 2ν₁)/G₁ − (1 − 2ν₂)/G₂]/[(1 − ν₁)/G₁ + (1 − ν₂)/G₂]",
        file: "crates/contact/src/friction/sliding.rs",
        test: "equal_bodies_do_not_couple_and_a_rigid_one_couples_most",
        references: &[DUNDURS_1969, JOHNSON_1985],
        misprint: None,
    },
    Equation {
        tag: "Sliding-1",
        title: "Normal displacement by the traction of sliding dissimilar bodies",
        formula: "u_c(x) = (β·μ/E*)·∫ p(s)·sgn(x − s) ds",
        file: "crates/contact/src/friction/sliding.rs",
        test: "a_sliding_cylinder_of_another_material_has_the_tilted_pressure",
        references: &[DUNDURS_1969, JOHNSON_1985],
        misprint: None,
    },
    Equation {
        tag: "Sliding-2",
        title: "Pressure of a sliding cylinder of another material",
        formula: "p = (E*/2R)·cos(πγ)·(b + x)^(½ − γ)·(b − x)^(½ + γ), tan(πγ) = β·μ",
        file: "crates/contact/src/friction/sliding.rs",
        test: "a_sliding_cylinder_of_another_material_has_the_tilted_pressure",
        references: &[DUNDURS_1969, JOHNSON_1985],
        misprint: None,
    },
];
