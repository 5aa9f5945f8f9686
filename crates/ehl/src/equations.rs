//! The equations of this crate, for `docs/EQUATIONS.md`.

use asperity_core::{Equation, Reference};

const ROELANDS_1966: Reference = Reference {
    key: "roelands_1966",
    text: "C. J. A. Roelands, Correlational aspects of the viscosity-temperature-pressure relationship of lubricating oils, doctoral thesis, Delft, 1966",
};
const VENNER_2000: Reference = Reference {
    key: "venner_2000",
    text: "C. H. Venner, A. A. Lubrecht, Multilevel Methods in Lubrication, Tribology Series 37, Elsevier, 2000",
};
const MOES_2000: Reference = Reference {
    key: "moes_2000",
    text: "H. Moes, Lubrication and Beyond, University of Twente, 2000",
};
const JAEGER_1942: Reference = Reference {
    key: "jaeger_1942",
    text: "J. C. Jaeger, Moving sources of heat and the temperature at sliding contacts, Proceedings of the Royal Society of New South Wales 76, 203-224, 1942",
};
const EYRING_1936: Reference = Reference {
    key: "eyring_1936",
    text: "H. Eyring, Viscosity, plasticity and diffusion as examples of absolute reaction rates, Journal of Chemical Physics 4, 283-291, 1936",
};
const CARREAU_1972: Reference = Reference {
    key: "carreau_1972",
    text: "P. J. Carreau, Rheological equations from molecular network theories, Transactions of the Society of Rheology 16, 99-127, 1972",
};
const VENNER_1997: Reference = Reference {
    key: "venner_1997",
    text: "C. H. Venner, F. Couhier, A. A. Lubrecht, J. A. Greenwood, Amplitude reduction of waviness in transient EHL line contacts, Tribology Series 32, 103-112, 1997, doi:10.1016/s0167-8922(08)70440-1",
};
const JOHNSON_1985: Reference = asperity_core::material::JOHNSON_1985;

const FLUID: &str = "crates/ehl/src/fluid.rs";
const RHEOLOGY: &str = "crates/ehl/src/rheology.rs";
const REYNOLDS: &str = "crates/ehl/src/reynolds.rs";
const STEADY: &str = "crates/ehl/src/steady.rs";
const STEPPER: &str = "crates/ehl/src/stepper.rs";
const FRICTION: &str = "crates/ehl/src/friction.rs";
const TRACTION: &str = "crates/ehl/src/traction.rs";

/// Every equation of this crate.
pub const EQUATIONS: &[Equation] = &[
    Equation::new(
        "EHL-scales",
        "Speed parameter of the Reynolds equation",
        "λ = 12·u_m·η₀·R²/(a³·p₀) = 3π²/(8·M²)",
        "crates/ehl/src/dimensionless.rs",
        "the_gear_case_has_its_dimensionless_numbers",
        &[MOES_2000, VENNER_2000],
    ),
    Equation::new(
        "Roelands-free",
        "Viscosity against pressure with slope and curvature given separately",
        "ln(η/η₀) = (α·p_r/z)·((1 + p/p_r)^z − 1)",
        RHEOLOGY,
        "roelands_with_free_exponent_starts_with_alpha_and_tends_to_barus",
        &[ROELANDS_1966],
    ),
    Equation::new(
        "Tangent-Eyring",
        "Fluidity along the sliding, Eyring",
        "1/(dτ/dγ) = √(φ² + y²)",
        FLUID,
        "the_fluidity_of_a_sliding_film_is_that_of_the_tangent",
        &[EYRING_1936],
    ),
    Equation::new(
        "Tangent-Carreau",
        "Fluidity along the sliding, Carreau",
        "1/(dτ/dγ) = φⁿ·(φ² + y²)^((3 − n)/2)/(φ² + n·y²)",
        FLUID,
        "the_fluidity_of_a_sliding_film_is_that_of_the_tangent",
        &[CARREAU_1972],
    ),
    Equation::new(
        "Log-mean",
        "Mean fluidity between two nodes",
        "φ = (e^−a − e^−b)/(b − a)",
        REYNOLDS,
        "the_log_mean_is_exact_for_barus",
        &[],
    ),
    Equation::new(
        "EHL-flux",
        "Flux through a face: quadratic Couette part, logarithmic mean of the fluidity",
        "F = m̂ − (ρH³/λ)·φ·dP/dX, m̂ = −m₋/8 + 3m/4 + 3m₊/8",
        REYNOLDS,
        "the_slopes_of_the_balance_are_its_differences",
        &[VENNER_2000],
    ),
    Equation::new(
        "Hat-kernel",
        "Displacement by a pressure that is linear between the nodes",
        "c_k = −(1/(π·h))·[F((k+1)·h) − 2·F(k·h) + F((k−1)·h)], F(u) = u²/2·ln|u| − 3u²/4",
        "crates/ehl/src/hat_kernel.rs",
        "hats_of_a_hertz_pressure_flatten_the_parabola",
        &[JOHNSON_1985],
    ),
    Equation::new(
        "EHL-film",
        "Gap of the rigid rough surfaces",
        "X²/2 − (R/a²)·[z₁(x − (1 + S/2)·T·a) + z₂(x − (1 − S/2)·T·a)]",
        STEPPER,
        "swapping_the_surfaces_and_the_sign_of_sliding_changes_nothing",
        &[VENNER_2000],
    ),
    Equation::new(
        "BDF2",
        "Backward differences of second order with a variable step",
        "dm/dT = [(1 + 2ω)·m − (1 + ω)²·m₁ + ω²·m₂]/((1 + ω)·ΔT)",
        STEPPER,
        "a_steady_film_stays_steady",
        &[],
    ),
    Equation::new(
        "EHL-ceiling",
        "Ceiling of the pressure, at which nodes yield",
        "Hᵢ += dᵢ, 0 ≤ dᵢ ⊥ P_flow − Pᵢ ≥ 0",
        "crates/ehl/src/newton.rs",
        "the_ceiling_holds_the_pressure",
        &[],
    ),
    Equation::new(
        "EHL-window",
        "Window of a smooth film",
        "X_in = −max(4, √(600·H_c)), X_out = max(1.5, 1 + 3·√H_c)",
        STEADY,
        "the_window_floods_the_inlet",
        &[],
    ),
    Equation::new(
        "Rolling-force",
        "Rolling force on one surface",
        "F_r = ∫ (h/2)·(dp/dx) dx",
        STEADY,
        "the_gear_case_has_its_film_and_rolling_force",
        &[VENNER_2000],
    ),
    Equation::new(
        "Richardson",
        "Extrapolation from two grids of second order",
        "φ_∞ = φ_h + (φ_h − φ_2h)/3",
        "crates/ehl/src/graded.rs",
        "rows_of_the_smooth_table_are_met",
        &[],
    ),
    Equation::new(
        "Limited-Eyring",
        "Shear stress of the film with a limiting stress",
        "τ_E = τ₀·arsinh(η₀·e^min(αp, 40)·γ/τ₀), τ = τ_E·(1 + (τ_E/τ_L)⁴)^(−1/4)",
        FRICTION,
        "the_stress_is_newtonian_then_eyring_then_limited",
        &[EYRING_1936],
    ),
    Equation::new(
        "EHL-friction",
        "Friction of a rough film with its boundary share",
        "μ = Σ wᵢ·[β·μ_b·p + (1 − β)·τ(p, Δu/h)]/Σ wᵢ·p, β = min(1, e^(−(h − H_b)/h_b)), e^(−h/h_b) or [h ≤ h_s]",
        FRICTION,
        "boundary_friction_is_whole_on_nodes_in_contact_and_fades_above_them",
        &[],
    ),
    Equation::new(
        "Batch-means",
        "Standard error of the mean of a record",
        "s = √( Σ (x̄ₖ − x̄)²/(n·(n − 1)) )",
        "crates/ehl/src/batch_means.rs",
        "the_standard_error_is_that_of_independent_blocks",
        &[],
    ),
    Equation::new(
        "Load-below-film",
        "Share of the load carried below a given film thickness",
        "share(h) = Σ wᵢ·Pᵢ·[Hᵢ ≤ h]/Σ wᵢ·Pᵢ",
        "crates/ehl/src/transient.rs",
        "the_load_below_a_film_rises_with_the_film",
        &[],
    ),
    Equation::new(
        "Roelands-thermal",
        "Viscosity against pressure and temperature",
        "ln(η/η₀) + A = A·(1 + p/p_r)^z·((T − 138)/(T₀ − 138))^−s, A = α·p_r/z",
        TRACTION,
        "traction_of_the_gear_case_is_met",
        &[ROELANDS_1966],
    ),
    Equation::new(
        "Flash-film",
        "Temperature of the surfaces under a moving distribution of heat",
        "ΔT(x) = ∫ q(x′)/√(x − x′) dx′/(√(π·ρ·c·k)·(√u₁ + √u₂))",
        TRACTION,
        "traction_of_the_gear_case_is_met",
        &[JAEGER_1942],
    ),
    Equation::new(
        "Amplitude-reduction",
        "Remaining amplitude of a wave in pure rolling",
        "A_d/A_i = 1/(1 + 0.125·∇ + 0.04·∇²), ∇ = (λ/a)·M^(3/4)·L^(−1/2)",
        "crates/ehl/src/amplitude_reduction.rs",
        "waves_of_two_contacts_fall_on_one_curve",
        &[VENNER_1997],
    ),
];
