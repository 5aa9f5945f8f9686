//! The equations of the records, for `docs/EQUATIONS.md`.

use asperity_core::Equation;

/// Every equation of this folder.
pub const EQUATIONS: &[Equation] = &[Equation::new(
    "Record-friction",
    "Friction of a record, split into film, lubricated asperities and boundary layer",
    "μ_l = (μ_τ − (μ_s − μ_b φ))/φ, μ = (1 − φ) μ_f + (φ − b) μ_l + b μ_b",
    "crates/asperity/src/records/path_record.rs",
    "friction_of_a_record_is_the_sum_of_its_parts",
    &[],
)];
