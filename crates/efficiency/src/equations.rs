//! The equations of this crate: the file, the formula and the test of each.

use asperity_core::citation::RODRIGUEZ_2022;
use asperity_core::{Equation, Reference};

/// Reason for counting rolling friction on both surfaces.
pub const GOKSEM_1978: Reference = Reference {
    key: "goksem_hargreaves_1978",
    text: "P. G. Goksem and R. A. Hargreaves, The effect of viscous shear heating on both film thickness and rolling traction in an EHL line contact, Journal of Lubrication Technology 100 (1978) 346-358",
};

/// Bulk temperature after Oster.
pub const ISO_TR_15144_1: Reference = Reference {
    key: "iso_tr_15144_1_2014",
    text: "ISO/TR 15144-1:2014, Calculation of micropitting load capacity of cylindrical spur and helical gears - Part 1: Introduction and basic principles (from memory, text not reached)",
};

/// Friction of shaft seals.
pub const ISO_TR_14179_2: Reference = Reference {
    key: "iso_tr_14179_2_2001",
    text: "ISO/TR 14179-2:2001, Gears - Thermal capacity - Part 2: Thermal load-carrying capacity (as quoted in open programs, text not reached)",
};

/// Friction of rolling bearings.
pub const SKF_2012: Reference = Reference {
    key: "skf_2012",
    text: "SKF, Rolling bearings, catalogue (2012), The SKF model for calculating the frictional moment (load variables and sliding friction read there, the two reduction factors as in independent programs)",
};

/// Momentum of an oil jet.
pub const ARIURA_1973: Reference = Reference {
    key: "ariura_1973",
    text: "Y. Ariura, T. Ueno, T. Sunaga and S. Sunamoto, The lubricant churning loss in spur gear systems, Bulletin of the JSME 16 (1973) 881-892 (as quoted in later papers, text not reached)",
};

/// Plastic work and shakedown.
pub const JOHNSON_1985: Reference = asperity_core::material::JOHNSON_1985;

/// Equations of this crate.
pub const EQUATIONS: &[Equation] = &[
    Equation {
        tag: "P16",
        title: "Output torque",
        formula: "M₂ = M₁ (ω₁/ω₂) η",
        file: "crates/efficiency/src/output_torque.rs",
        test: "torque_and_speed_of_the_driven_gear_carry_the_output_power",
        references: &[RODRIGUEZ_2022],
        misprint: None,
    },
    Equation {
        tag: "P17",
        title: "Sliding loss",
        formula: "P_s = Σ w F_s |V_s|",
        file: "crates/efficiency/src/mesh_loss.rs",
        test: "constant_friction_on_the_reference_case_loses_mu_times_the_loss_factor",
        references: &[RODRIGUEZ_2022],
        misprint: None,
    },
    Equation {
        tag: "P18",
        title: "Rolling loss",
        formula: "P_r = Σ w 2 F_r V_e",
        file: "crates/efficiency/src/mesh_loss.rs",
        test: "rolling_on_both_surfaces_loses_twice_what_the_paper_prints",
        references: &[RODRIGUEZ_2022, GOKSEM_1978],
        misprint: Some(
            "printed F_r V_e with F_r a force; F_r is N/m on one surface (agrees with a Grubin inlet solution), so the loss is 2 F_r V_e l",
        ),
    },
    Equation {
        tag: "P19",
        title: "Deformation loss as printed",
        formula: "P = σ δ a²/T",
        file: "crates/efficiency/src/deformation.rs",
        test: "the_printed_deformation_loss_misses_the_face_width_and_the_teeth",
        references: &[RODRIGUEZ_2022],
        misprint: Some(
            "printed σ δ a²/T, one a × a patch once per revolution; energy per metre times b times engagements per second is larger by b z₁/a",
        ),
    },
    Equation {
        tag: "P20",
        title: "Efficiency",
        formula: "η = 1 − ΣP/(M₁ω₁)",
        file: "crates/efficiency/src/output_torque.rs",
        test: "the_smooth_full_film_losses_give_the_efficiency_of_the_reference_case",
        references: &[RODRIGUEZ_2022],
        misprint: None,
    },
    Equation {
        tag: "Deformation-1",
        title: "Plastic work per engagement and metre",
        formula: "E_pl = Σ p du_pl Δx",
        file: "crates/efficiency/src/deformation.rs",
        test: "plastic_work_under_a_hertz_pressure_is_load_times_uniform_indentation",
        references: &[JOHNSON_1985],
        misprint: None,
    },
    Equation {
        tag: "Deformation-2",
        title: "Elastic energy per metre",
        formula: "E_el = ½ Σ p u Δx",
        file: "crates/efficiency/src/deformation.rs",
        test: "elastic_energy_is_half_the_load_times_a_uniform_displacement",
        references: &[JOHNSON_1985],
        misprint: None,
    },
    Equation {
        tag: "Deformation-3",
        title: "Time between engagements",
        formula: "T_z = 2π/(z₁ω₁)",
        file: "crates/efficiency/src/deformation.rs",
        test: "fifty_teeth_at_three_thousand_turns_engage_2500_times_a_second",
        references: &[],
        misprint: None,
    },
    Equation {
        tag: "Deformation-4",
        title: "Running-in energy and power",
        formula: "E_z = E_pl b, P = E_z/T_z",
        file: "crates/efficiency/src/deformation.rs",
        test: "running_in_power_times_its_period_is_the_energy_per_tooth",
        references: &[JOHNSON_1985],
        misprint: None,
    },
    Equation {
        tag: "Deformation-5",
        title: "Elastic hysteresis loss",
        formula: "P = α_h E_el b/T_z",
        file: "crates/efficiency/src/deformation.rs",
        test: "without_hysteresis_the_elastic_energy_costs_nothing",
        references: &[JOHNSON_1985],
        misprint: None,
    },
    Equation {
        tag: "Breakdown-1",
        title: "Energy per engagement and share of a loss",
        formula: "E_k = P_k T_z, share P_k/ΣP",
        file: "crates/efficiency/src/breakdown.rs",
        test: "shares_sum_to_a_hundred_percent_and_energies_to_power_times_period",
        references: &[],
        misprint: None,
    },
    Equation {
        tag: "Breakdown-2",
        title: "Unexplained share of the input power",
        formula: "|P_in − P_out − ΣP_k|/P_in",
        file: "crates/efficiency/src/breakdown.rs",
        test: "input_is_output_and_losses_whichever_gear_drives",
        references: &[],
        misprint: None,
    },
    Equation {
        tag: "Plausible-1",
        title: "Equivalent friction coefficient",
        formula: "μ_eq = (1 − η)/H_V",
        file: "crates/efficiency/src/plausibility.rs",
        test: "the_equivalent_friction_of_the_reference_case_is_plausible",
        references: &[],
        misprint: None,
    },
    Equation {
        tag: "Elastic-cycling",
        title: "Elastic energy cycled through the flanks",
        formula: "P_el = Σ 2 f a/(3πR) V_e dl",
        file: "crates/efficiency/src/swept.rs",
        test: "swept_powers_of_three_gears",
        references: &[JOHNSON_1985],
        misprint: None,
    },
    Equation {
        tag: "Hysteresis",
        title: "Cycled elastic energy lost to hysteresis",
        formula: "P_hyst = α_h P_el",
        file: "crates/efficiency/src/swept.rs",
        test: "swept_powers_of_three_gears",
        references: &[JOHNSON_1985],
        misprint: None,
    },
    Equation {
        tag: "Plastic-swept",
        title: "Plastic work of one pass over the flanks",
        formula: "P_pl = Σ D/(2a) V_e dl",
        file: "crates/efficiency/src/swept.rs",
        test: "swept_powers_of_three_gears",
        references: &[],
        misprint: None,
    },
    Equation {
        tag: "Run-in-energy",
        title: "Plastic work per flank area in one pass",
        formula: "E_A = D/(2a)",
        file: "crates/efficiency/src/swept.rs",
        test: "swept_powers_of_three_gears",
        references: &[],
        misprint: None,
    },
    Equation {
        tag: "Bulk-iso",
        title: "Rise of the bulk temperature over the oil",
        formula: "ϑ_M − ϑ_oil = 7400 (P/(a b))^0.72 X_S/1.2, P in kW, a and b in mm",
        file: "crates/efficiency/src/bulk_temperature.rs",
        test: "rises_are_those_of_an_independent_computation",
        references: &[ISO_TR_15144_1],
        misprint: None,
    },
    Equation {
        tag: "Bulk-network",
        title: "Temperatures of two gears with conductances to the oil and between them",
        formula: "(G₁ + G₁₂) Δϑ₁ − G₁₂ Δϑ₂ = β P, (G₂ + G₁₂) Δϑ₂ − G₁₂ Δϑ₁ = (1 − β) P",
        file: "crates/efficiency/src/bulk_temperature.rs",
        test: "two_gears_in_oil_have_their_temperatures",
        references: &[],
        misprint: None,
    },
    Equation {
        tag: "Bulk-fixed-point",
        title: "Bulk temperature that its own loss keeps up",
        formula: "ϑ ← (ϑ + g(ϑ))/2 until |g(ϑ) − ϑ| < 0.01 K",
        file: "crates/efficiency/src/bulk_temperature.rs",
        test: "the_fixed_point_of_a_loss_that_falls_with_temperature_is_met",
        references: &[],
        misprint: None,
    },
    Equation {
        tag: "Seal-1",
        title: "Friction of a shaft seal",
        formula: "P = 7.69e-6 d² n, d in mm, n in 1/min",
        file: "crates/efficiency/src/shaft_seal.rs",
        test: "a_seal_loses_what_was_computed_by_hand",
        references: &[ISO_TR_14179_2],
        misprint: None,
    },
    Equation {
        tag: "Jet-1",
        title: "Power that turns an oil jet",
        formula: "P = ρ Q v_t (v_t + v_j)",
        file: "crates/efficiency/src/oil_jet.rs",
        test: "a_jet_takes_what_was_computed_by_hand",
        references: &[ARIURA_1973],
        misprint: None,
    },
    Equation {
        tag: "Bearing-1",
        title: "Friction torque of a rolling bearing",
        formula: "M = φ_ish φ_rs G_rr (ν n)^0.6 + G_sl μ_sl",
        file: "crates/efficiency/src/rolling_bearing.rs",
        test: "torques_of_a_deep_groove_ball_bearing_are_those_of_an_independent_computation",
        references: &[SKF_2012],
        misprint: None,
    },
    Equation {
        tag: "Bearing-2",
        title: "Inlet shear heating of a rolling bearing",
        formula: "φ_ish = 1/(1 + 1.84e-9 (n d_m)^1.28 ν^0.64)",
        file: "crates/efficiency/src/rolling_bearing.rs",
        test: "torques_of_a_deep_groove_ball_bearing_are_those_of_an_independent_computation",
        references: &[SKF_2012],
        misprint: None,
    },
    Equation {
        tag: "Bearing-3",
        title: "Starved replenishment of a rolling bearing",
        formula: "φ_rs = exp(−K_rs ν n (d + D) √(K_z/(2 (D − d))))",
        file: "crates/efficiency/src/rolling_bearing.rs",
        test: "a_bearing_in_a_bath_is_replenished",
        references: &[SKF_2012],
        misprint: None,
    },
    Equation {
        tag: "Bearing-4",
        title: "Sliding coefficient of a rolling bearing",
        formula: "μ_sl = φ_bl μ_bl + (1 − φ_bl) μ_EHL, φ_bl = exp(−2.6e-8 (n ν)^1.4 d_m)",
        file: "crates/efficiency/src/rolling_bearing.rs",
        test: "sliding_goes_from_broken_to_whole_film",
        references: &[SKF_2012],
        misprint: None,
    },
    Equation {
        tag: "Bearing-5",
        title: "Variables of geometry and load of a rolling bearing",
        formula: "balls: G_rr = R₁ d_m^1.96 (F_r + R₂ F_a/sin α_F)^0.54, G_sl = S₁ d_m^−0.145 (F_r⁵ + S₂ d_m^1.5 F_a⁴/sin α_F)^(1/3), α_F = 24.6° (F_a/C₀)^0.24; F_a = 0: G_sl = S₁ d_m^−0.26 F_r^(5/3); cylinders: R₁ d_m^2.41 F_r^0.31, S₁ d_m^0.9 F_a + S₂ d_m F_r; tapers: R₁ d_m^2.38 (F_r + R₂ Y F_a)^0.31, S₁ d_m^0.82 (F_r + S₂ Y F_a)",
        file: "crates/efficiency/src/rolling_bearing.rs",
        test: "roller_bearings_follow_their_exponents",
        references: &[SKF_2012],
        misprint: None,
    },
    Equation {
        tag: "Loss-table",
        title: "Loss torque from a table",
        formula: "M = Σ_k Π_i w_ik M_k over the corners k of the cell, w_i = (1 − a_i, a_i) along axis i",
        file: "crates/efficiency/src/loss_table.rs",
        test: "a_linear_table_is_met_at_its_nodes_and_between_them",
        references: &[],
        misprint: None,
    },
];
