//! The equations of the load share, for `docs/EQUATIONS.md`.

use asperity_core::Equation;

/// Every equation of this folder.
pub const EQUATIONS: &[Equation] = &[
    Equation::new(
        "Share-contact",
        "Rough contact under the pressure of its film",
        "film pressure (1 − φ) p_Hertz, ∫ p_a dx = φ w, 0 ≤ p_a ≤ p_flow − (1 − φ) p₀",
        "crates/asperity/src/load_share/rough_contact.rs",
        "load_share_of_the_reference_windows",
        &[],
    ),
    Equation::new(
        "Load-share",
        "Share of the load on the asperities",
        "g(φ) = h̄(φ); φ = 0 if g(0) ≤ h̄(0), 0.99 if g(0.99) > h̄(0.99)",
        "crates/asperity/src/load_share/contact_table.rs",
        "load_share_of_the_reference_windows",
        &[],
    ),
    Equation::new(
        "Spot-friction",
        "Friction of touching asperities as small lubricated contacts",
        "R_k = π E* (b_k/2)²/(4 f_k), β = Σ f_k β_k/Σ f_k, μ_a = Σ f_k (1 − β_k) τ_k/p_k / Σ f_k (1 − β_k)",
        "crates/asperity/src/load_share/spots.rs",
        "load_share_of_the_reference_windows",
        &[],
    ),
    Equation::new(
        "Run-in",
        "Flanks after running-in",
        "zᵢ ← zᵢ − sᵢ w under the contact of each pass, until the work of a cycle is 5 % of the first's",
        "crates/asperity/src/run_in.rs",
        "running_in_takes_height_and_loss_off_ground_flanks",
        &[],
    ),
];
