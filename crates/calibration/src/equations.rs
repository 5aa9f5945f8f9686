//! The equations of this crate, and with them all of the workspace: the table behind `docs/EQUATIONS.md` and
//! `asperity equations`.

use asperity::equations;
use asperity_core::{Equation, Reference};

const FISHER_1925: Reference = Reference {
    key: "fisher_1925",
    text: "R. A. Fisher, Theory of statistical estimation, Proceedings of the Cambridge Philosophical Society 22 (1925) 700-725",
};
const VENZON_1988: Reference = Reference {
    key: "venzon_1988",
    text: "D. J. Venzon, S. H. Moolgavkar, A method for computing profile-likelihood-based confidence intervals, Applied Statistics 37 (1988) 87-94",
};
const EFRON_1993: Reference = Reference {
    key: "efron_1993",
    text: "B. Efron, R. J. Tibshirani, An Introduction to the Bootstrap, Chapman and Hall, New York, 1993",
};
const FEDOROV_1972: Reference = Reference {
    key: "fedorov_1972",
    text: "V. V. Fedorov, Theory of Optimal Experiments, Academic Press, New York, 1972",
};

/// Every equation of this crate.
pub const EQUATIONS: &[Equation] = &[
    Equation::new(
        "Rig-residual",
        "Loss of a rig's point with its nuisance terms, and its residual",
        "L = s_a (S(θ, δT) + ρ R(δT)) + q ω + c |M| ω, r = (ln L_measured − ln L)/(σ/L_measured)",
        "crates/calibration/src/problem.rs",
        "slopes_of_the_residuals_are_their_differences",
        &[],
    ),
    Equation::new(
        "Fisher-information",
        "What the points of a design can find",
        "I = Σ j jᵀ, C = I⁻¹",
        "crates/calibration/src/information.rs",
        "the_information_of_a_line_is_that_of_its_normal_equations",
        &[FISHER_1925],
    ),
    Equation::new(
        "Profile-likelihood",
        "Band of one parameter while all others follow",
        "{ θ : min χ²(θ, ·) − min χ² ≤ 3.84 }",
        "crates/calibration/src/profile_likelihood.rs",
        "the_profile_of_a_correlated_parabola_has_the_marginal_band",
        &[VENZON_1988],
    ),
    Equation::new(
        "Group-bootstrap",
        "Estimates of whole groups drawn anew",
        "θ*_b = θ(g_1 .. g_G), g_k even over 1 .. G",
        "crates/calibration/src/bootstrap.rs",
        "the_bootstrap_of_a_mean_has_its_standard_error",
        &[EFRON_1993],
    ),
    Equation::new(
        "D-optimal",
        "Points that find the parameters of interest best",
        "max ln det (I_11 − I_12 I_22⁻¹ I_21), I = I_prior + Σ J_kᵀ J_k",
        "crates/calibration/src/optimal_design.rs",
        "a_parabola_is_measured_at_its_ends_and_its_middle",
        &[FEDOROV_1972],
    ),
];

/// Every equation of the workspace, in order: the model's and this crate's.
pub fn all() -> Vec<&'static Equation> {
    equations::in_order(equations::all().into_iter().chain(EQUATIONS))
}
