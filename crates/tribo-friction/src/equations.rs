//! The equations of this crate, for `docs/EQUATIONS.md`.

use asperity_core::citation::RODRIGUEZ_2022;
use asperity_core::{Equation, Reference};

/// The friction regression.
pub const XU_2005: Reference = Reference {
    key: "xu_2005",
    text: "H. Xu, Development of a generalized mechanical efficiency prediction methodology for gear pairs, dissertation, The Ohio State University, 2005",
};

/// The friction regression applied to parallel axes.
pub const XU_2007: Reference = Reference {
    key: "xu_2007",
    text: "H. Xu, A. Kahraman, N. E. Anderson, D. G. Maddock, Prediction of mechanical efficiency of parallel-axis gear pairs, ASME J. Mech. Des. 129 (2007) 58-68",
};

/// Roller tests of friction.
pub const BENEDICT_KELLEY_1961: Reference = Reference {
    key: "benedict_kelley_1961",
    text: "G. H. Benedict, B. W. Kelley, Instantaneous coefficients of gear tooth friction, ASLE Trans. 4 (1961) 59-70",
};

/// Metric form of Benedict and Kelley.
pub const AGMA_925: Reference = Reference {
    key: "agma_925",
    text: "AGMA 925-A03, Effect of lubrication on gear surface distress, 2003, 6.2.2",
};

/// Thermal rating, part 1.
pub const ISO_14179_1: Reference = Reference {
    key: "iso_14179_1",
    text: "ISO/TR 14179-1:2001, Gears - Thermal capacity - Part 1: Rating gear drives with thermal equilibrium at 95 °C sump temperature",
};

/// Thermal rating, part 2.
pub const ISO_14179_2: Reference = Reference {
    key: "iso_14179_2",
    text: "ISO/TR 14179-2:2001, Gears - Thermal capacity - Part 2: Thermal load-carrying capacity",
};

/// The mean friction coefficient.
pub const SCHLENK_1994: Reference = Reference {
    key: "schlenk_1994",
    text: "L. Schlenk, Untersuchungen zur Fresstragfähigkeit von Grosszahnrädern, dissertation, TU München, 1994",
};

/// Load sharing by maximum heights.
pub const MATSUMOTO_2014: Reference = Reference {
    key: "matsumoto_2014",
    text: "S. Matsumoto, K. Morikawa, The new estimation formula of coefficient of friction in rolling-sliding contact surface under mixed lubrication condition for the power loss reduction of power transmission gears, International Gear Conference, Lyon, 2014",
};

/// Load sharing by the film ratio.
pub const DOLESCHEL_2002: Reference = Reference {
    key: "doleschel_2002",
    text: "A. Doleschel, Wirkungsgradberechnung von Zahnradgetrieben in Abhängigkeit vom Schmierstoff, dissertation, TU München, 2002",
};

/// Eyring friction and a comparison of load sharing functions.
pub const ARANA_2019: Reference = Reference {
    key: "arana_2019",
    text: "A. Arana, J. Larrañaga, I. Ulacia, Partial EHL friction coefficient model to predict power losses in cylindrical gears, Proc. IMechE J: J. Eng. Tribol. 233 (2019) 303-316, doi 10.1177/1350650118778655",
};

/// Rolling resistance of the inlet.
pub const GOKSEM_HARGREAVES_1978: Reference = Reference {
    key: "goksem_hargreaves_1978",
    text: "P. G. Goksem, R. A. Hargreaves, The effect of viscous shear heating on both film thickness and rolling traction in an EHL line contact, ASME J. Lubr. Technol. 100 (1978) 346-358",
};

/// Flash temperature.
pub const BLOK_1937: Reference = Reference {
    key: "blok_1937",
    text: "H. Blok, Theoretical study of temperature rise at surfaces of actual contact under oiliness lubricating conditions, Proc. General Discussion on Lubrication, IMechE 2 (1937) 222-235",
};

/// Shear stress of oils at high pressure.
pub const EVANS_JOHNSON_1986: Reference = Reference {
    key: "evans_johnson_1986",
    text: "C. R. Evans, K. L. Johnson, Regimes of traction in elastohydrodynamic lubrication, Proc. IMechE C 200 (1986) 313-324",
};

/// Thermal conductivity of oils under pressure.
pub const LARSSON_ANDERSSON_2000: Reference = Reference {
    key: "larsson_andersson_2000",
    text: "R. Larsson, O. Andersson, Lubricant thermal conductivity and heat capacity under high pressure, Proc. IMechE J 214 (2000) 337-342 (constants from memory, source not reached)",
};

/// Heat of moving line sources.
pub const CARSLAW_JAEGER_1959: Reference = Reference {
    key: "carslaw_jaeger_1959",
    text: "H. S. Carslaw, J. C. Jaeger, Conduction of Heat in Solids, 2nd ed., Oxford University Press, 1959, 10.7",
};

/// Pressure-viscosity of mineral and synthetic oils.
pub const GOLD_2001: Reference = Reference {
    key: "gold_2001",
    text: "P. W. Gold, A. Schmidt, H. Dicke, J. Loos, C. Assmann, Viscosity-pressure-temperature behaviour of mineral and synthetic oils, Journal of Synthetic Lubrication 18(1), 51-79, 2001",
};

const RHEOLOGY: &str = "crates/tribo-friction/src/film_friction/rheology.rs";
const FILM: &str = "crates/tribo-friction/src/film_friction/line_contact.rs";

/// Every equation of this crate.
pub const EQUATIONS: &[Equation] = &[
    Equation::new(
        "P7",
        "Friction coefficient of a thermal mixed EHL contact",
        "μ = e^f P_h^b₂ |SR|^b₃ V_e^b₆ ν₀^b₇ R^b₈, f = b₁ + b₄ q + b₅ e^(−q) + b₉ e^S, q = |SR| P_h log₁₀ ν₀",
        "crates/tribo-friction/src/xu.rs",
        "xu_of_the_reference_case",
        &[XU_2005, XU_2007],
    ),
    Equation::new(
        "Benedict-Kelley",
        "Friction coefficient of roller tests",
        "μ = 0.0127 · 1.13/(1.13 − Ra) · log₁₀(29 700 w/(η |V_s| V_Σ²))",
        "crates/tribo-friction/src/benedict_kelley.rs",
        "benedict_kelley_of_the_reference_case",
        &[BENEDICT_KELLEY_1961, AGMA_925],
    ),
    Equation::new(
        "ISO-14179-1",
        "Mesh coefficient of friction",
        "f_m = ν^−0.223 K^−0.40/(3.239 V^0.70)",
        "crates/tribo-friction/src/iso_14179_1.rs",
        "whole_mesh_laws_of_the_reference_case",
        &[ISO_14179_1],
    ),
    Equation::new(
        "Schlenk",
        "Mean friction coefficient of a mesh",
        "μ_mz = 0.048 ((F_bt/b)/(v_ΣC ρ_redC))^0.2 η^−0.05 Ra^0.25 X_L",
        "crates/tribo-friction/src/iso_14179_2.rs",
        "whole_mesh_laws_of_the_reference_case",
        &[SCHLENK_1994, ISO_14179_2],
    ),
    Equation::new(
        "Matsumoto-share",
        "Load share of the asperities by maximum heights",
        "ξ = ½ log₁₀((Rz₁ + Rz₂)/h_m), 0 ≤ ξ ≤ 1",
        "crates/tribo-friction/src/matsumoto.rs",
        "asperity_shares_of_the_published_functions",
        &[MATSUMOTO_2014, ARANA_2019],
    ),
    Equation::new(
        "Matsumoto",
        "Friction coefficient by maximum heights",
        "μ = (1 − ξ) μ_ehd + ξ μ_bdr",
        "crates/tribo-friction/src/matsumoto.rs",
        "shared_laws_run_from_boundary_to_fluid_friction",
        &[MATSUMOTO_2014],
    ),
    Equation::new(
        "Doleschel-share",
        "Load share of the asperities by the film ratio",
        "ξ = (1 − λ/2)² for λ < 2, else 0",
        "crates/tribo-friction/src/doleschel.rs",
        "asperity_shares_of_the_published_functions",
        &[DOLESCHEL_2002, ARANA_2019],
    ),
    Equation::new(
        "Doleschel",
        "Friction coefficient by the film ratio",
        "μ = (1 − ξ) μ_ehd + ξ μ_bdr",
        "crates/tribo-friction/src/doleschel.rs",
        "shared_laws_run_from_boundary_to_fluid_friction",
        &[DOLESCHEL_2002],
    ),
    Equation::new(
        "Eyring",
        "Fluid friction coefficient of a full film",
        "μ = min((τ_E/p̄) arsinh(η |V_s|/(τ_E h)), Λ), τ_E = 2 Λ/α, p̄ = π p₀/4",
        "crates/tribo-friction/src/eyring.rs",
        "eyring_spot_values",
        &[ARANA_2019],
    ),
    Equation::new(
        "P21",
        "Friction force of film and asperities",
        "F_s = ∫ (μ_m p_solid + μ p_fluid) dx",
        "crates/tribo-friction/src/mixed.rs",
        "mixed_friction_of_a_hertz_contact_is_the_coefficient_times_the_load",
        &[RODRIGUEZ_2022],
    ),
    Equation {
        misprint: Some(
            "called a force; it is a force per length, on one surface (within 5 % of a numerical Grubin inlet)",
        ),
        ..Equation::new(
            "P9",
            "Rolling resistance on one surface",
            "F_r = 4.318 φ (G U)^0.658 W^0.0126 R/α",
            "crates/tribo-friction/src/rolling.rs",
            "rolling_resistance_agrees_with_a_numerical_inlet",
            &[GOKSEM_HARGREAVES_1978],
        )
    },
    Equation::new(
        "Goksem-long",
        "Rolling resistance, longer form",
        "F_r α/(W R) = e^(0.658228 ln D − 0.162625) e^(0.0106383 L^0.3174603 ln D)/(1 + 0.411483 L^0.707071), D = (3/4) (2π)^(3/2) G U/W^(3/2)",
        "crates/tribo-friction/src/rolling.rs",
        "goksem_factor_of_a_published_test_case",
        &[GOKSEM_HARGREAVES_1978],
    ),
    Equation::new(
        "Blok",
        "Flash temperature of a line contact",
        "ΔT = 1.11 μ w |u₁ − u₂|/((B₁ √u₁ + B₂ √u₂) √(2a)), B = √(k ρ c)",
        "crates/tribo-friction/src/flash.rs",
        "flash_temperature_of_the_reference_case",
        &[BLOK_1937],
    ),
    Equation::new(
        "Blok-share",
        "Share of the frictional heat that goes into a flank",
        "β = B₁ √u₁/(B₁ √u₁ + B₂ √u₂), B = √(k ρ c)",
        "crates/tribo-friction/src/flash.rs",
        "two_flanks_share_the_heat_that_makes_them_equally_hot",
        &[BLOK_1937],
    ),
    Equation::new(
        "Alpha-T",
        "Pressure-viscosity coefficient against temperature",
        "α(T) = α_ref (η₀(T)/η₀(T_ref))^t",
        RHEOLOGY,
        "film_friction_of_fourteen_conditions",
        &[GOLD_2001],
    ),
    Equation::new(
        "Larsson-Andersson",
        "Thermal conductivity of the film under pressure",
        "k(p) = k (1 + c₁ p/(1 + c₂ p)), p in GPa",
        RHEOLOGY,
        "film_friction_of_fourteen_conditions",
        &[LARSSON_ANDERSSON_2000],
    ),
    Equation::new(
        "Limiting-shear",
        "Shear stress below its limit",
        "τ = τ_E (1 + (τ_E/τ_L)⁴)^(−1/4), τ_E = τ₀ arsinh(η γ̇/τ₀), τ_L = τ_L0 + Λ e^(−b_L (T − 363.15)) p",
        RHEOLOGY,
        "film_friction_of_fourteen_conditions",
        &[EVANS_JOHNSON_1986, ARANA_2019],
    ),
    Equation::new(
        "Film-heat",
        "Shear stress of a self-heated film",
        "τ = Law(p, T_s + (1/12) τ V_s h/k(p), V_s/h)",
        RHEOLOGY,
        "the_roots_of_stress_and_temperature_leave_no_residual",
        &[EVANS_JOHNSON_1986],
    ),
    Equation::new(
        "Film-friction",
        "Friction of a smooth film in a line contact",
        "μ_f = (2a/w) ∫₀^(π/2) τ cos t dt, p = p₀ cos t",
        FILM,
        "film_friction_of_fourteen_conditions",
        &[EVANS_JOHNSON_1986],
    ),
    Equation::new(
        "Surface-heat",
        "Mean rise of the surface temperature in a line contact",
        "T_s − T₀ = 0.7985 μ w V_s/((B₁ √u₁ + B₂ √u₂) √(2a)), u_i ≥ 2 κ_i/a",
        FILM,
        "film_friction_of_fourteen_conditions",
        &[CARSLAW_JAEGER_1959, BLOK_1937],
    ),
    Equation::new(
        "Boundary-share",
        "Share of an asperity's load on the boundary layer",
        "β_k = 1/(1 + h_k/h_b)",
        "crates/tribo-friction/src/boundary.rs",
        "boundary_share_runs_from_layer_to_film",
        &[],
    ),
    Equation::new(
        "Three-parts",
        "Friction of film, lubricated asperities and boundary layer",
        "μ = (1 − φ) μ_f + φ [(1 − β) μ_a + β μ_b]",
        "crates/tribo-friction/src/boundary.rs",
        "three_parts_add_up",
        &[],
    ),
];
