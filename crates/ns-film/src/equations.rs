//! The equations of this crate, for `docs/EQUATIONS.md`.

use asperity_core::citation::RODRIGUEZ_2022;
use asperity_core::{Equation, Reference};

const REYNOLDS_1886: Reference = Reference {
    key: "reynolds_1886",
    text: "O. Reynolds, On the theory of lubrication, Phil. Trans. R. Soc. London 177, 157-234, 1886",
};
const HAMROCK_2004: Reference = Reference {
    key: "hamrock_2004",
    text: "B. J. Hamrock, S. R. Schmid, B. O. Jacobson, Fundamentals of Fluid Film Lubrication, 2nd edition, Marcel Dekker, 2004",
};

const GAP: &str = "crates/ns-film/src/gap.rs";
const PROFILE: &str = "crates/ns-film/src/velocity_profile.rs";
const CROSS: &str = "crates/ns-film/src/reynolds_cross.rs";
const PAPER: &str = "crates/ns-film/src/paper.rs";

const fn row(
    tag: &'static str,
    title: &'static str,
    formula: &'static str,
    file: &'static str,
    test: &'static str,
    references: &'static [Reference],
    misprint: Option<&'static str>,
) -> Equation {
    Equation {
        tag,
        title,
        formula,
        file,
        test,
        references,
        misprint,
    }
}

/// An assumption of the paper about its flow, with which the momentum has the terms that it has.
const fn assumption(tag: &'static str, title: &'static str, formula: &'static str) -> Equation {
    row(
        tag,
        title,
        formula,
        PAPER,
        "the_papers_gradient_is_the_radial_momentum_of_its_own_velocities",
        &[RODRIGUEZ_2022],
        None,
    )
}

/// Every equation of this crate.
pub const EQUATIONS: &[Equation] = &[
    row(
        "P22",
        "Continuity in cylinder coordinates",
        "∂ρ/∂t + (1/r)·∂(r·ρ·u_r)/∂r + (1/r)·∂(ρ·u_θ)/∂θ + ∂(ρ·u_z)/∂z = 0",
        PAPER,
        "the_papers_velocities_conserve_mass",
        &[RODRIGUEZ_2022],
        Some(
            "misprinted there; the standard equation (derived), which the velocities of equations 30 and 31 fulfil",
        ),
    ),
    row(
        "P23",
        "Momentum in cylinder coordinates, its radial part",
        "dP/dr = ρ·(u_θ²/r − u_r·∂u_r/∂r − (u_θ/r)·∂u_r/∂θ) + μ·(∂²u_r/∂r² + (1/r)·∂u_r/∂r + (1/r²)·∂²u_r/∂θ² − u_r/r² − (2/r²)·∂u_θ/∂θ)",
        PAPER,
        "the_papers_gradient_is_the_radial_momentum_of_its_own_velocities",
        &[RODRIGUEZ_2022],
        Some(
            "printed with a wrong last term, factors 1 for 2 and wrong signs; used: the standard Navier-Stokes equation in cylinder coordinates (derived)",
        ),
    ),
    assumption("P24", "Assumption: no flow along the axis", "u_z = 0"),
    assumption(
        "P25",
        "Assumption: radial velocity uniform along the axis",
        "∂ⁱu_r/∂zⁱ = 0",
    ),
    assumption("P26", "Assumption: steady flow", "∂uᵢ/∂t = 0"),
    assumption(
        "P27",
        "Assumption: velocity along the film uniform along the axis",
        "∂ⁱu_θ/∂zⁱ = 0",
    ),
    assumption("P28", "Assumption: no gravity", "g = 0"),
    row(
        "P29",
        "Gap over the angle, as printed",
        "h = h₀ + (1 − cos θ)·(r₁ + r₂)",
        GAP,
        "the_printed_gap_is_right_for_equal_radii_only",
        &[RODRIGUEZ_2022],
        Some(
            "printed as the gap of any two cylinders; right to second order in θ only for r₁ = r₂, otherwise its rise is off by r₂/r₁ (geometry); used as printed in the paper's model",
        ),
    ),
    row(
        "P30",
        "Velocity through the film",
        "u_θ = A·h² + B·h + C",
        PROFILE,
        "the_parabola_passes_through_walls_and_middle",
        &[RODRIGUEZ_2022],
        Some("printed: B²; used: B (units)"),
    ),
    row(
        "P31",
        "Radial velocity from continuity",
        "u_r = −f·(r + D)/r",
        PAPER,
        "the_papers_velocities_conserve_mass",
        &[RODRIGUEZ_2022],
        Some("printed with a stray −C; used without"),
    ),
    row(
        "P32",
        "Coefficients of the velocity through the film",
        "A = (4/H²)·((w₁r₁ + w₂r₂)/2 − u∞), B = (4u∞ − w₁r₁ − 3w₂r₂)/H, C = w₂r₂",
        PROFILE,
        "the_parabola_passes_through_walls_and_middle",
        &[RODRIGUEZ_2022],
        Some(
            "printed: B² and H = r₂ + h₀; used: B and H = film thickness (units, speed at the wall)",
        ),
    ),
    row(
        "P33",
        "Radial velocity at the edge of the boundary layer (not used)",
        "u_r(r = δ_BL) = u∞",
        PAPER,
        "the_base_radius_is_half_of_what_is_printed",
        &[RODRIGUEZ_2022],
        Some(
            "sets a radial velocity equal to the free stream along the film, at a δ_BL that is never given; D follows from equation 36 instead",
        ),
    ),
    row(
        "P34",
        "Angle from one tooth to the next",
        "2·π/z",
        PAPER,
        "the_base_radius_is_half_of_what_is_printed",
        &[RODRIGUEZ_2022],
        Some("printed in equations 34 to 36: 2·π/2; used: 2·π/z"),
    ),
    row(
        "P35",
        "Base radius, as first printed (not used)",
        "R_b = m·z·cos α",
        PAPER,
        "the_base_radius_is_half_of_what_is_printed",
        &[RODRIGUEZ_2022],
        Some("the base diameter; equation 36 is used with half of it"),
    ),
    row(
        "P36",
        "Base radius",
        "R_b = m_t·z·cos(α_t)/2, D = −R_b",
        PAPER,
        "the_base_radius_is_half_of_what_is_printed",
        &[RODRIGUEZ_2022],
        Some("printed: R_b = m·z·cos α, the diameter; used: half of it"),
    ),
    row(
        "P37",
        "Pressure uniform along the axis, a result of equations 24 to 28",
        "∂P/∂z = 0",
        PAPER,
        "the_papers_gradient_is_the_radial_momentum_of_its_own_velocities",
        &[RODRIGUEZ_2022],
        None,
    ),
    row(
        "Paper-2",
        "Pressure gradient of the paper's velocities",
        "dP/dr = ρ·(u²/r + u·f'·(1/r + D/r²) + f²·(D/r² + D²/r³)) − μ·(f/r² + f''·(1/r² + D/r³))",
        PAPER,
        "the_papers_gradient_is_the_radial_momentum_of_its_own_velocities",
        &[RODRIGUEZ_2022],
        None,
    ),
    row(
        "Paper-1",
        "Pressure difference across the paper's film",
        "ρ·(u²·I₁ + u·f'·(I₁ + D·I₂) + f²·(D·I₂ + D²·I₃)) − μ·(f·I₂ + f''·(I₂ + D·I₃)), Iₙ = ∫r⁻ⁿ dr",
        PAPER,
        "the_papers_film_hits_the_recomputed_readings",
        &[RODRIGUEZ_2022],
        None,
    ),
    row(
        "Gap-1",
        "Gap along the film",
        "h = h₀ + x²/(2·R), or h₀ + R − √(R² − x²)",
        GAP,
        "parabola_and_cylinder_agree_near_the_line_of_centres",
        &[HAMROCK_2004],
        None,
    ),
    row(
        "Gap-2",
        "Slope of the gap",
        "h' = x/R, or x/√(R² − x²)",
        GAP,
        "parabola_and_cylinder_agree_near_the_line_of_centres",
        &[HAMROCK_2004],
        None,
    ),
    row(
        "Gap-3",
        "Gap over the angle, exact",
        "h = L·cos θ − √(r₁² − (L·sin θ)²) − r₂, L = r₁ + r₂ + h₀",
        GAP,
        "the_printed_gap_is_right_for_equal_radii_only",
        &[RODRIGUEZ_2022],
        None,
    ),
    row(
        "Profile-1",
        "Middle speed from the flow",
        "u_m = (6·q/h − u₁ − u₂)/4",
        PROFILE,
        "the_parabola_that_conserves_flow_obeys_reynolds",
        &[HAMROCK_2004],
        None,
    ),
    row(
        "Reynolds-1",
        "Pressure gradient along the film",
        "dp/dx = 6·η·((u₁ + u₂)·h − 2·q)/h³",
        CROSS,
        "the_parabola_that_conserves_flow_obeys_reynolds",
        &[REYNOLDS_1886, HAMROCK_2004],
        None,
    ),
    row(
        "Reynolds-2",
        "Pressure along the film",
        "d/dx(h³/(12·η)·dp/dx) = ½·(u₁ + u₂)·dh/dx",
        "crates/ns-film/src/film_pressure.rs",
        "a_rigid_cylinder_carries_what_the_closed_forms_say",
        &[REYNOLDS_1886, HAMROCK_2004],
        None,
    ),
    row(
        "Cross-1",
        "Pressure difference across the film",
        "p₁ − p₂ = h'·τ_w1 + ρ·(u₁² + u₁·u₂ + u₂²)·h/(3·r₂)",
        CROSS,
        "the_tilted_wall_is_in_balance",
        &[RODRIGUEZ_2022],
        None,
    ),
    row(
        "Cross-2",
        "Shear stress at the walls",
        "τ_w1,2 = η·(u₁ − u₂)/h ± (h/2)·dp/dx",
        CROSS,
        "shear_and_pressure_balance_on_a_slice_of_film",
        &[HAMROCK_2004],
        None,
    ),
    row(
        "Cross-3",
        "Centrifugal pressure difference of a thin film",
        "ρ·(u₁² + u₁·u₂ + u₂²)·h/(3·r₂)",
        CROSS,
        "the_consistent_film_hits_the_recomputed_values",
        &[RODRIGUEZ_2022],
        None,
    ),
    row(
        "Cross-4",
        "Centrifugal pressure difference of any film",
        "ρ·∫u²/(r₂ + y) dy",
        CROSS,
        "the_consistent_film_hits_the_recomputed_values",
        &[RODRIGUEZ_2022],
        None,
    ),
    row(
        "Wall-1",
        "Speed of a wall",
        "u = ω·r",
        "crates/ns-film/src/model.rs",
        "the_consistent_film_hits_the_recomputed_values",
        &[RODRIGUEZ_2022],
        None,
    ),
];
