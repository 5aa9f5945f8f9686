//! The equations of this crate, for `docs/EQUATIONS.md`.

use asperity_core::citation::RODRIGUEZ_2022;
use asperity_core::material::JOHNSON_1985;
use asperity_core::{Equation, Reference};

use crate::{friction, hertz_line, subsurface};

/// The contact with a limit of the pressure, and its plastic displacement.
const ALMQVIST_2007: Reference = Reference {
    key: "almqvist_2007",
    text: "A. Almqvist, F. Sahlin, R. Larsson, S. Glavatskih, On the dry elasto-plastic contact of nominally flat surfaces, Tribology International 40 (2007) 574-579, doi:10.1016/j.triboint.2005.11.008",
};
/// Conjugate gradients for rough contacts.
const POLONSKY_1999: Reference = Reference {
    key: "polonsky_1999",
    text: "I. A. Polonsky, L. M. Keer, A numerical method for solving rough contact problems based on the multi-level multi-summation and conjugate gradient techniques, Wear 231 (1999) 206-219, doi:10.1016/S0043-1648(99)00113-1",
};
/// Newton's method on the set of touching points.
const HINTERMUELLER_2002: Reference = Reference {
    key: "hintermueller_2002",
    text: "M. Hintermüller, K. Ito, K. Kunisch, The primal-dual active set strategy as a semismooth Newton method, SIAM Journal on Optimization 13 (2002) 865-888, doi:10.1137/S1052623401383558",
};
/// Two-level preconditioners; the one used is their A-DEF2.
const TANG_2009: Reference = Reference {
    key: "tang_2009",
    text: "J. M. Tang, R. Nabben, C. Vuik, Y. A. Erlangga, Comparison of two-level preconditioners derived from deflation, domain decomposition and multigrid methods, Journal of Scientific Computing 39 (2009) 340-370, doi:10.1007/s10915-009-9272-6",
};
/// The wavy half-plane.
const WESTERGAARD_1939: Reference = Reference {
    key: "westergaard_1939",
    text: "H. M. Westergaard, Bearing pressures and cracks, Journal of Applied Mechanics 6 (1939) A49-A53",
};
/// Hardness and yield stress.
const TABOR_1951: Reference = Reference {
    key: "tabor_1951",
    text: "D. Tabor, The Hardness of Metals, Clarendon Press, Oxford, 1951",
};

/// Equations of this crate but those of the Hertz contact, the subsurface and friction, which list
/// their own.
pub const EQUATIONS: &[Equation] = &[
    Equation {
        tag: "P1",
        title: "Displacement by the pressure of all cells",
        formula: "uᵢ = (1/(π·E*))·Σⱼ C_ij·p_j",
        file: "crates/contact/src/half_plane.rs",
        test: "the_solved_gap_is_undeformed_gap_plus_displacement_less_approach",
        references: &[RODRIGUEZ_2022, JOHNSON_1985],
        misprint: None,
    },
    Equation {
        tag: "P2",
        title: "Displacement by a uniformly loaded strip",
        formula: "C(x) = (x−a)·ln[((x−a)/a)²] − (x+a)·ln[((x+a)/a)²] + C₀",
        file: "crates/contact/src/strip_kernel.rs",
        test: "the_kernel_has_all_digits_at_any_distance",
        references: &[RODRIGUEZ_2022, JOHNSON_1985],
        misprint: Some("printed: [ln(·)]²; used: ln[(·)²], since the diagonal would hold ln(−1)"),
    },
    Equation {
        tag: "P3",
        title: "Pressure at a given approach",
        formula: "p = π·E*·C⁻¹·(δ − h) over the touching points",
        file: "crates/contact/src/dense_reference.rs",
        test: "transforms_and_the_dense_matrix_give_the_same_periodic_contact",
        references: &[RODRIGUEZ_2022, JOHNSON_1985],
        misprint: None,
    },
    Equation {
        tag: "P4",
        title: "Load carried by the pressure",
        formula: "W = Σᵢ pᵢ·dx",
        file: "crates/contact/src/half_plane.rs",
        test: "the_solved_gap_is_undeformed_gap_plus_displacement_less_approach",
        references: &[RODRIGUEZ_2022],
        misprint: None,
    },
    Equation {
        tag: "P6",
        title: "Stress beyond the elastic limit",
        formula: "σ_pl = max(0, σ_VM − σ_y)",
        file: "crates/contact/src/plasticity.rs",
        test: "stress_is_plastic_beyond_the_elastic_limit_only",
        references: &[RODRIGUEZ_2022],
        misprint: Some(
            "printed: σ_e called the elastic stress, which is circular; used: the elastic limit",
        ),
    },
    Equation {
        tag: "Datum-1",
        title: "Constant of the datum",
        formula: "C₀ = −C(D)",
        file: "crates/contact/src/strip_kernel.rs",
        test: "the_kernel_falls_with_the_distance_and_vanishes_at_the_datum",
        references: &[JOHNSON_1985],
        misprint: None,
    },
    Equation {
        tag: "Periodic-1",
        title: "Kernel of a strip and all its images",
        formula: "C(x) = (L/π)·[Cl₂(2π(x+a)/L) − Cl₂(2π(x−a)/L)]",
        file: "crates/contact/src/strip_kernel.rs",
        test: "the_periodic_kernel_is_the_difference_of_clausen_functions",
        references: &[JOHNSON_1985],
        misprint: None,
    },
    Equation {
        tag: "Periodic-2",
        title: "Displacement by a wave of pressure",
        formula: "u_q = 2·p_q/(E*·|q|)",
        file: "crates/contact/src/strip_kernel.rs",
        test: "full_contact_is_the_linear_solution",
        references: &[JOHNSON_1985],
        misprint: None,
    },
    Equation {
        tag: "Duality-1",
        title: "Bound of the energy error",
        formula: "Σ p·(g − λ); with a limit min(Σ p·g⁺ + (p_max − p)·(−g)⁺, Σ p·(g⁺ − λ)); λ = min(g, 0) where p < p_max",
        file: "crates/contact/src/certificate.rs",
        test: "the_duality_gap_bounds_the_energy_error",
        references: &[POLONSKY_1999],
        misprint: None,
    },
    Equation {
        tag: "Plastic-1",
        title: "Plastic displacement of the surfaces",
        formula: "w = max(−g, 0) where p = p_flow, else 0",
        file: "crates/contact/src/plasticity.rs",
        test: "loading_in_steps_flows_as_much_as_loading_at_once",
        references: &[ALMQVIST_2007],
        misprint: None,
    },
    Equation {
        tag: "Plastic-2",
        title: "Energy dissipated by plastic displacement",
        formula: "D = p_flow·Σ w·dx",
        file: "crates/contact/src/plasticity.rs",
        test: "the_dissipated_energy_is_the_area_of_the_load_approach_loop",
        references: &[ALMQVIST_2007],
        misprint: None,
    },
    Equation {
        tag: "Plastic-3",
        title: "Profile of a body after displacement",
        formula: "z − s·w",
        file: "crates/contact/src/plasticity.rs",
        test: "flanks_pressed_again_on_their_residual_profiles_stay_elastic",
        references: &[ALMQVIST_2007],
        misprint: None,
    },
    Equation {
        tag: "Tabor-1",
        title: "Pressure at which a surface yields",
        formula: "p_flow = 3·σ_y of the softer body",
        file: "crates/contact/src/plasticity.rs",
        test: "the_softer_body_sets_the_flow_pressure",
        references: &[TABOR_1951],
        misprint: None,
    },
    Equation {
        tag: "Tabor-2",
        title: "Pressure at which a contact of two bodies yields",
        formula: "p_flow = min(p_flow,1, p_flow,2)",
        file: "crates/contact/src/plasticity.rs",
        test: "a_contact_flows_at_the_pressure_of_the_softer_body",
        references: &[TABOR_1951],
        misprint: None,
    },
    Equation {
        tag: "Yield-1",
        title: "First yield below a Hertz line contact",
        formula: "p₀ = 1.79·σ_y of the softer body",
        file: "crates/contact/src/plasticity.rs",
        test: "a_contact_first_yields_where_its_von_mises_stress_meets_the_elastic_limit",
        references: &[JOHNSON_1985],
        misprint: None,
    },
    Equation {
        tag: "Share-1",
        title: "Shares of the elastic displacement",
        formula: "sᵢ = cᵢ/(c₁ + c₂), c = (1 − ν²)/E",
        file: "crates/contact/src/plasticity.rs",
        test: "equal_bodies_share_evenly_and_the_softer_takes_more",
        references: &[JOHNSON_1985],
        misprint: None,
    },
    Equation {
        tag: "Share-2",
        title: "Shares of the plastic displacement",
        formula: "s₁ = σ_y2/(σ_y1 + σ_y2), s₂ = 1 − s₁",
        file: "crates/contact/src/plasticity.rs",
        test: "equal_bodies_share_evenly_and_the_softer_takes_more",
        references: &[ALMQVIST_2007],
        misprint: None,
    },
    Equation {
        tag: "Flanks-1",
        title: "Gap of two flanks",
        formula: "h = x²/(2·R) − z₁ − z₂",
        file: "crates/contact/src/two_flanks.rs",
        test: "flanks_pressed_again_on_their_residual_profiles_stay_elastic",
        references: &[JOHNSON_1985],
        misprint: None,
    },
    Equation {
        tag: "Westergaard-1",
        title: "Mean pressure that closes a wavy gap",
        formula: "p* = π·E*·Δ/λ",
        file: "crates/contact/src/westergaard.rs",
        test: "a_wave_has_the_contact_of_westergaard",
        references: &[WESTERGAARD_1939, JOHNSON_1985],
        misprint: None,
    },
    Equation {
        tag: "Westergaard-2",
        title: "Contact width on a wave",
        formula: "sin²(πb/λ) = p̄/p*",
        file: "crates/contact/src/westergaard.rs",
        test: "a_wave_has_the_contact_of_westergaard",
        references: &[WESTERGAARD_1939, JOHNSON_1985],
        misprint: None,
    },
    Equation {
        tag: "Westergaard-3",
        title: "Pressure on a wave",
        formula: "p(x) = (2·p̄·cos ψ/sin²ψ_b)·√(sin²ψ_b − sin²ψ), ψ = πx/λ",
        file: "crates/contact/src/westergaard.rs",
        test: "a_wave_has_the_contact_of_westergaard",
        references: &[WESTERGAARD_1939, JOHNSON_1985],
        misprint: None,
    },
    Equation {
        tag: "Westergaard-4",
        title: "Mean gap over a wave",
        formula: "ḡ = 2·Δ·(½·cos²ψ_b + sin²ψ_b·ln sin ψ_b)",
        file: "crates/contact/src/westergaard.rs",
        test: "a_wave_has_the_contact_of_westergaard",
        references: &[WESTERGAARD_1939, JOHNSON_1985],
        misprint: None,
    },
    Equation {
        tag: "Punch-1",
        title: "Pressure under a flat strip",
        formula: "p(x) = W/(π·√(b² − x²))",
        file: "crates/contact/src/flat_punch.rs",
        test: "a_flat_strip_has_the_pressure_and_approach_of_the_punch",
        references: &[JOHNSON_1985],
        misprint: None,
    },
    Equation {
        tag: "Punch-2",
        title: "Approach of a flat strip over a datum",
        formula: "δ(D) = (2·W/(π·E*))·ln(2·D/b)",
        file: "crates/contact/src/flat_punch.rs",
        test: "a_flat_strip_has_the_pressure_and_approach_of_the_punch",
        references: &[JOHNSON_1985],
        misprint: None,
    },
    Equation {
        tag: "Active-1",
        title: "Next set of free points",
        formula: "F' = {0 < p < p_max} ∪ {p = 0, g < 0} ∪ {p = p_max, g > 0}",
        file: "crates/contact/src/solver/active_set.rs",
        test: "a_contact_of_many_patches_does_not_depend_on_the_start",
        references: &[HINTERMUELLER_2002],
        misprint: None,
    },
    Equation {
        tag: "Deflation-1",
        title: "Preconditioner with the means over contact patches removed",
        formula: "z = B r + Z·K⁻¹·Zᵀ(r − A·B r)",
        file: "crates/contact/src/solver/search_direction.rs",
        test: "iterations_grow_neither_with_the_grid_nor_with_the_patches",
        references: &[TANG_2009],
        misprint: None,
    },
    Equation {
        tag: "Patch-1",
        title: "Mean displacement between contact patches",
        formula: "K_IJ = [G(b−c) − G(b−d) − G(a−c) + G(a−d)]/(l_I·l_J), G(k+1) − 2·G(k) + G(k−1) = C(k)",
        file: "crates/contact/src/solver/contact_patches.rs",
        test: "the_mean_displacement_between_patches_is_the_double_sum_of_the_kernel",
        references: &[JOHNSON_1985],
        misprint: None,
    },
    Equation {
        tag: "Gap-deformed",
        title: "Gap of two deformed bodies",
        formula: "g(x) = h(x) + u(x) − δ, u(x) = −(2/(π·E*))·∫ p(s)·ln|x − s| ds + const",
        file: "crates/contact/src/half_plane.rs",
        test: "the_solved_gap_is_undeformed_gap_plus_displacement_less_approach",
        references: &[JOHNSON_1985],
        misprint: None,
    },
];

/// Every equation of this crate.
pub fn equations() -> impl Iterator<Item = &'static Equation> {
    EQUATIONS
        .iter()
        .chain(hertz_line::EQUATIONS)
        .chain(subsurface::EQUATIONS)
        .chain(friction::EQUATIONS)
}
