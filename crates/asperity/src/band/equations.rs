//! The equations of the band, for `docs/EQUATIONS.md`.

use asperity_core::{Equation, Reference};

/// Latin hypercube sampling.
const MCKAY_1979: Reference = Reference {
    key: "mckay_1979",
    text: "M. D. McKay, R. J. Beckman, W. J. Conover, A comparison of three methods for selecting values of input variables in the analysis of output from a computer code, Technometrics 21 (1979) 239-245",
};

/// Degrees of freedom of a sum of mean squares.
const SATTERTHWAITE_1946: Reference = Reference {
    key: "satterthwaite_1946",
    text: "F. E. Satterthwaite, An approximate distribution of estimates of variance components, Biometrics Bulletin 2 (1946) 110-114",
};

/// Every equation of this folder.
pub const EQUATIONS: &[Equation] = &[
    Equation::new(
        "Effective-windows",
        "Windows of a trace that count as independent",
        "n_e = min(K, L_f/(b_e (1 − b_e/(3 L_f)))), b_e = 1.6 a",
        "crates/asperity/src/band/sampling.rs",
        "printed_intervals_cover_the_mean_of_the_flank",
        &[],
    ),
    Equation::new(
        "Sampling-error",
        "Interval of a mean over windows that overlap",
        "s² = s_K²/(1 − 1/n_e) where n_e < K; ± t(0.95, n_e − 1) s/√n_e",
        "crates/asperity/src/band/sampling.rs",
        "printed_intervals_cover_the_mean_of_the_flank",
        &[],
    ),
    Equation::new(
        "Between-traces",
        "Standard error of the mean over all pairs of sampled teeth",
        "SE² = max(V₁ − M/n₂, 0)/n₁ + max(V₂ − M/n₁, 0)/n₂ + M/(n₁ n₂); d = (V₁/n₁ + V₂/n₂)²/[(V₁/n₁)²/(n₁ − 1) + (V₂/n₂)²/(n₂ − 1)]; ± t(0.95, d) SE",
        "crates/asperity/src/band/pairs.rs",
        "intervals_between_traces_cover_the_mean_of_all_teeth",
        &[SATTERTHWAITE_1946],
    ),
    Equation::new(
        "Set-band",
        "Band of the loss of a planetary set",
        "P_j = n (P₁(θ_j) + P₂(θ_j)); SE_j² = n² (SE₁² + SE₂²)",
        "crates/asperity/src/band/set.rs",
        "errors_of_two_meshes_add_in_squares",
        &[],
    ),
    Equation::new(
        "Latin-hypercube",
        "Draws of uncertain parameters",
        "u_jk = (π_k(j) + r_jk)/N",
        "crates/asperity/src/band/hypercube.rs",
        "every_stratum_of_every_axis_is_drawn_once",
        &[MCKAY_1979],
    ),
    Equation::new(
        "Calibrated-draws",
        "Draws of calibrated parameters with their correlations",
        "ln v = ln v₀ + s± (L z), z = Φ⁻¹(u), s± = ln(v±/v₀)/1.96",
        "crates/asperity/src/band/calibrated.rs",
        "calibrated_draws_have_the_band_and_the_correlation_of_the_case",
        &[],
    ),
    Equation::new(
        "Form-split",
        "Cut-off between the form and the roughness of a trace",
        "λ_f = max(λ_c, 8 a_H)",
        "crates/asperity/src/case/flank_form.rs",
        "the_form_of_a_trace_is_the_relief_that_was_ground",
        &[],
    ),
    Equation::new(
        "Flank-window",
        "Window of a contact on a placed trace",
        "i = ±(ρ²/(2 r_b) − l₀)/dx",
        "crates/asperity/src/placement.rs",
        "a_contact_finds_its_window_by_the_arc",
        &[],
    ),
    Equation::new(
        "Paired-difference",
        "Difference of two finishes by the same draws",
        "δ_j = P_other(θ_j) − P_first(θ_j), SE_j² = SE_other² + SE_first²",
        "crates/asperity/src/band/difference.rs",
        "finishes_differ_less_than_each_is_uncertain",
        &[],
    ),
];
