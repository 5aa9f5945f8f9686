//! The equations of this crate: the file, the formula and the test of each.

use asperity_core::{Equation, Reference};

/// Definitions and symbols of involute gears.
pub const ISO_21771: Reference = Reference {
    key: "iso_21771_2007",
    text: "ISO 21771:2007, Gears - Cylindrical involute gears and gear pairs - Concepts and geometry",
};

/// Forces at the teeth.
pub const ISO_6336_1: Reference = Reference {
    key: "iso_6336_1_2019",
    text: "ISO 6336-1:2019, Calculation of load capacity of spur and helical gears - Part 1: Basic principles, introduction and general influence factors",
};

/// The trapezoidal load sharing.
pub const ISO_TR_13989_1: Reference = Reference {
    key: "iso_tr_13989_1_2000",
    text: "ISO/TR 13989-1:2000, Calculation of scuffing load capacity of cylindrical, bevel and hypoid gears - Part 1: Flash temperature method",
};

/// Ohlendorf's loss factor in a standard.
pub const ISO_TR_14179_2: Reference = Reference {
    key: "iso_tr_14179_2_2001",
    text: "ISO/TR 14179-2:2001, Gears - Thermal capacity - Part 2: Thermal load-carrying capacity",
};

/// Speeds, curvatures and lengths of contact lines.
pub const NIEMANN_WINTER: Reference = Reference {
    key: "niemann_winter_2003",
    text: "G. Niemann and H. Winter, Maschinenelemente, Band 2, 2nd edition, Springer, 2003",
};

/// The first loss factor.
pub const OHLENDORF_1958: Reference = Reference {
    key: "ohlendorf_1958",
    text: "H. Ohlendorf, Verlustleistung und Erwärmung von Stirnrädern, Dissertation, TH München, 1958",
};

/// Load sharing by the minimum of the elastic potential.
pub const PEDRERO_2010: Reference = Reference {
    key: "pedrero_2010",
    text: "J. I. Pedrero, M. Pleguezuelos, M. Artés and J. A. Antona, Load distribution model along the line of contact for involute external gears, Mechanism and Machine Theory 45 (2010) 780-794",
};

/// The local loss factor.
pub const WIMMER_2006: Reference = Reference {
    key: "wimmer_2006",
    text: "A. Wimmer, Lastverluste von Stirnradverzahnungen, Dissertation, TU München, 2006",
};

/// Compliance of teeth, foundations and flanks.
pub const WEBER_BANASCHEK_1953: Reference = Reference {
    key: "weber_banaschek_1953",
    text: "C. Weber and K. Banaschek, Formänderung und Profilrücknahme bei gerad- und schrägverzahnten Rädern, Schriftenreihe Antriebstechnik 11, Vieweg, Braunschweig, 1953",
};

/// Definitions of flank deviations.
pub const ISO_1328_1: Reference = Reference {
    key: "iso_1328_1_2013",
    text: "ISO 1328-1:2013, Cylindrical gears - ISO system of flank tolerance classification - Part 1: Definitions and allowable values of deviations relevant to flanks of gear teeth",
};

/// Kinematics of epicyclic gears.
pub const WILLIS_1870: Reference = Reference {
    key: "willis_1870",
    text: "R. Willis, Principles of Mechanism, 2nd edition, Longmans, Green and Co., London, 1870",
};

/// Equations of this crate.
pub const EQUATIONS: &[Equation] = &[
    Equation::new(
        "Involute-1",
        "Involute function",
        "inv α = tan α − α",
        "crates/gear/src/involute.rs",
        "the_involute_of_twenty_degrees_is_the_tabulated_one",
        &[ISO_21771],
    ),
    Equation::new(
        "Involute-2",
        "Inverse involute function",
        "t ← t − (t − arctan t − inv α)(1 + t²)/t², t = tan α",
        "crates/gear/src/involute.rs",
        "the_inverse_undoes_the_involute_in_a_few_steps",
        &[ISO_21771],
    ),
    Equation::new(
        "Involute-3",
        "Thickness of a tooth",
        "s = 2 r (π/(2z) + 2 x tan αₙ/z + inv αₜ − inv α_r)",
        "crates/gear/src/involute.rs",
        "the_rack_tooth_of_a_large_gear_has_the_thickness_of_its_tool",
        &[ISO_21771],
    ),
    Equation::new(
        "Pair-1",
        "Transverse section",
        "mₜ = mₙ/cos β, tan αₜ = tan αₙ/cos β, sin β_b = sin β cos αₙ, r = mₜ z/2, r_b = r cos αₜ",
        "crates/gear/src/rack.rs",
        "the_reference_case_has_the_geometry_of_table_2",
        &[ISO_21771],
    ),
    Equation::new(
        "Pair-2",
        "Working pressure angle and centre distance from the profile shifts",
        "inv α_wt = inv αₜ + 2 tan αₙ (x₁ + x₂)/(z₁ + z₂), a = (r_b1 + r_b2)/cos α_wt",
        "crates/gear/src/centre_distance.rs",
        "profile_shifts_give_the_centre_distances_printed_by_a_gear_tool",
        &[ISO_21771],
    ),
    Equation::new(
        "Pair-3",
        "Profile shift sum from the centre distance",
        "cos α_wt = (r_b1 + r_b2)/a, x₁ + x₂ = (inv α_wt − inv αₜ)(z₁ + z₂)/(2 tan αₙ)",
        "crates/gear/src/centre_distance.rs",
        "the_centre_distance_gives_back_the_profile_shifts",
        &[ISO_21771],
    ),
    Equation::new(
        "Pair-4",
        "Tip radius",
        "r_a = r + mₙ (hₐ* + x)",
        "crates/gear/src/tips.rs",
        "the_reference_case_has_the_geometry_of_table_2",
        &[ISO_21771],
    ),
    Equation::new(
        "Path-1",
        "Points on the line of action",
        "A = T₁T₂ − sgn(z₂) √(r_a2² − r_b2²), E = √(r_a1² − r_b1²), C = r_b1 tan α_wt, B = E − p_et, D = A + p_et",
        "crates/gear/src/path_of_contact.rs",
        "the_reference_case_has_the_path_of_contact_of_table_2",
        &[ISO_21771],
    ),
    Equation::new(
        "Path-2",
        "Contact ratios",
        "ε₁ = (E − C)/p_et, ε₂ = (C − A)/p_et, ε_α = ε₁ + ε₂, ε_β = b tan β_b/p_et",
        "crates/gear/src/path_of_contact.rs",
        "the_reference_case_has_the_path_of_contact_of_table_2",
        &[ISO_21771],
    ),
    Equation::new(
        "Path-3",
        "Profile coordinate",
        "ξ = (s − A)/p_et",
        "crates/gear/src/path_of_contact.rs",
        "coordinates_and_places_are_inverse_to_each_other",
        &[PEDRERO_2010],
    ),
    Equation::new(
        "Kinematics-1",
        "Radii of curvature",
        "ρ₁ = s, ρ₂ = T₁T₂ − s, R = ρ₁ρ₂/(ρ₁ + ρ₂)/cos β_b",
        "crates/gear/src/kinematics.rs",
        "the_reference_case_moves_as_table_2_says",
        &[NIEMANN_WINTER],
    ),
    Equation::new(
        "Kinematics-2",
        "Surface speeds",
        "uᵢ = ωᵢρᵢ, V_s = u₁ − u₂ = (ω₁ + ω₂)(s − C), V_e = (u₁ + u₂)/2",
        "crates/gear/src/kinematics.rs",
        "sliding_is_the_difference_of_the_surface_speeds",
        &[NIEMANN_WINTER],
    ),
    Equation::new(
        "Force-1",
        "Tooth forces",
        "F_bt = |T₁|/r_b1, F_bn = F_bt/cos β_b, F_t = |T₁|/r_w1, F_r = F_t tan α_wt, F_a = F_bt tan β_b",
        "crates/gear/src/forces.rs",
        "the_reference_case_carries_the_forces_of_table_2",
        &[ISO_6336_1],
    ),
    Equation::new(
        "Load-share-1",
        "Equal shares",
        "v = 1",
        "crates/gear/src/load_sharing.rs",
        "equal_shares_are_one_over_the_number_of_pairs",
        &[NIEMANN_WINTER],
    ),
    Equation::new(
        "Load-share-2",
        "Trapezoidal shares",
        "v = 1/3 + ξ/(3(ε_α − 1)) in double contact, 1 in single contact",
        "crates/gear/src/load_sharing.rs",
        "the_trapezoid_passes_through_its_corners",
        &[ISO_TR_13989_1],
    ),
    Equation::new(
        "Load-share-3",
        "Weights of minimum elastic energy",
        "v = cos(b₀(ξ − ε_α/2)), b₀ = (½(1 + ε_α/2)² − 1)^(−1/2)",
        "crates/gear/src/load_sharing.rs",
        "least_energy_shares_rise_from_about_a_third_to_two_thirds",
        &[PEDRERO_2010],
    ),
    Equation::new(
        "Load-share-4",
        "Share of a pair",
        "R(ξ) = v(ξ)/Σⱼ v(ξ + j)",
        "crates/gear/src/load_sharing.rs",
        "the_shares_of_all_pairs_in_contact_sum_to_one",
        &[PEDRERO_2010],
    ),
    Equation::new(
        "Load-1",
        "Line load of a spur pair",
        "f = F_bn R(ξ)/b",
        "crates/gear/src/line_load.rs",
        "the_mean_load_on_all_contact_lines_is_the_tooth_force",
        &[NIEMANN_WINTER],
    ),
    Equation::new(
        "Load-2",
        "Line load of a helical pair",
        "f = F_bn cos β_b v(ξ)/(b ∫₀^ε_α v dξ)",
        "crates/gear/src/line_load.rs",
        "the_mean_load_on_all_contact_lines_is_the_tooth_force",
        &[NIEMANN_WINTER, PEDRERO_2010],
    ),
    Equation::new(
        "Length-1",
        "Length of the contact lines at a mesh phase",
        "l(φ) = b/(ε_β cos β_b) Σⱼ [min(φ + j + ε_β, ε_α) − max(φ + j, 0)]₊",
        "crates/gear/src/contact_length.rs",
        "a_whole_overlap_ratio_keeps_the_contact_length_constant",
        &[NIEMANN_WINTER],
    ),
    Equation::new(
        "Length-2",
        "Mean length of the contact lines",
        "l̄ = b ε_α/cos β_b",
        "crates/gear/src/contact_length.rs",
        "the_mean_contact_length_is_the_mean_over_the_phases",
        &[NIEMANN_WINTER],
    ),
    Equation::new(
        "Mean-1",
        "Mean over a mesh cycle",
        "ḡ = b/(cos β_b p_et) ∫_A^E g ds",
        "crates/gear/src/positions.rs",
        "means_over_positions_are_means_over_the_mesh_cycle",
        &[WIMMER_2006],
    ),
    Equation::new(
        "Loss-1",
        "Loss factor by Ohlendorf",
        "H_V = π(u + 1)/(z₁ u cos β_b) (1 − ε_α + ε₁² + ε₂²)",
        "crates/gear/src/loss_factor.rs",
        "loss_factors_are_those_printed_by_a_gear_tool",
        &[OHLENDORF_1958, ISO_TR_14179_2],
    ),
    Equation::new(
        "Loss-2",
        "Local loss factor",
        "H_V = b/(cos β_b p_et) ∫_A^E f |V_s| ds/(F_bt v_b)",
        "crates/gear/src/loss_factor.rs",
        "local_loss_factors_of_spur_pairs_follow_the_sharing",
        &[WIMMER_2006],
    ),
    Equation::new(
        "Loss-3",
        "Local loss factor averaged over the mesh phases",
        "H_V = ∫₀¹ (∫ v |V_s| dξ/∫ v dξ) dφ/(v_b cos β_b)",
        "crates/gear/src/loss_factor.rs",
        "the_reference_case_has_the_loss_factors_of_table_2",
        &[WIMMER_2006],
    ),
    Equation::new(
        "Loss-4",
        "Loss factor of a wide helical pair",
        "H_V = π(u + 1)/(z₁ u cos β_b) (ε₁|ε₁| + ε₂|ε₂|)/ε_α",
        "crates/gear/src/loss_factor.rs",
        "the_local_loss_factor_of_a_helical_pair_has_a_closed_form",
        &[NIEMANN_WINTER],
    ),
    Equation::new(
        "Tooth-1",
        "Virtual spur gear of the normal section",
        "z_n = z/(cos² β_b cos β), r_n = mₙ z_n/2, r_bn = r_n cos αₙ",
        "crates/gear/src/tooth_outline.rs",
        "tooth_compliances_are_those_of_an_independent_program",
        &[ISO_6336_1],
    ),
    Equation::new(
        "Tooth-2",
        "Fillet generated by the rounded edge of a rack",
        "P = (h t + ρ t/√(1 + t²), r − h − ρ/√(1 + t²)) turned by −(h t − E)/r, h = (h_fP* − ρ_fP* − x) m, E = π m/4 − h_fP* m tan αₙ − (1 − sin αₙ) ρ/cos αₙ",
        "crates/gear/src/tooth_outline.rs",
        "the_fillet_meets_the_involute_with_its_slope",
        &[],
    ),
    Equation::new(
        "Tooth-3",
        "Load line of a tooth",
        "a′ = α − γ (ring: α + γ), y_P = r_b/cos a′, h = r_C sin γ/cos a′",
        "crates/gear/src/tooth_outline.rs",
        "the_flattening_is_that_of_an_independent_program",
        &[WEBER_BANASCHEK_1953],
    ),
    Equation::new(
        "Tooth-4",
        "Fillet of a helical tooth in the transverse section",
        "P = ((h + k) t cos β, r − h − k) turned by −((h + k) t cos β − (E + k t)/cos β)/r, k = ρ/√(1 + t²)",
        "crates/gear/src/transverse_tooth.rs",
        "the_fillet_of_a_helical_tooth_meets_its_involute",
        &[],
    ),
    Equation::new(
        "Compliance-1",
        "Bending, shear and compression of a tooth",
        "q₁ = cos² a′ [12 (1 − ν²)/E ∫ (L − η)²/(2X)³ dη + (2.4 (1 + ν)/E + tan² a′ (1 − ν²)/E) ∫ dη/(2X)]",
        "crates/gear/src/tooth_compliance.rs",
        "tooth_compliances_are_those_of_an_independent_program",
        &[WEBER_BANASCHEK_1953],
    ),
    Equation::new(
        "Compliance-2",
        "Compliance of the foundation of a tooth",
        "q₂ = cos² a′ (1 − ν²)/E [18/π (L/s_f)² + 2 (1 − 2ν)/(1 − ν) L/s_f + 4.8/π (1 + (1 − ν)/2.4 tan² a′)]",
        "crates/gear/src/tooth_compliance.rs",
        "the_stiffest_place_has_about_the_stiffness_of_iso_6336",
        &[WEBER_BANASCHEK_1953],
    ),
    Equation::new(
        "Compliance-3",
        "Flattening of two flanks",
        "q_H = Σ (1 − ν²)/(π E) [ln(4 h²/a²) − ν/(1 − ν)], a² = 4 f R/(π E*)",
        "crates/gear/src/hertz_compliance.rs",
        "the_flattening_is_that_of_an_independent_program",
        &[WEBER_BANASCHEK_1953],
    ),
    Equation::new(
        "Stiffness-1",
        "Theoretical single stiffness",
        "1/c′_th = 0.04723 + 0.15551/z_n1 + 0.25791/z_n2 − 0.00635 x₁ − 0.11654 x₁/z_n1 − 0.00193 x₂ − 0.24188 x₂/z_n2 + 0.00529 x₁² + 0.00182 x₂²",
        "crates/gear/src/iso_stiffness.rs",
        "the_stiffness_polynomial_is_that_of_the_standard",
        &[ISO_6336_1],
    ),
    Equation::new(
        "Stiffness-2",
        "Mean mesh stiffness of the standard",
        "c_γ = C_M c′_th cos β (0.75 ε_α + 0.25)",
        "crates/gear/src/iso_stiffness.rs",
        "the_stiffness_polynomial_is_that_of_the_standard",
        &[ISO_6336_1],
    ),
    Equation::new(
        "Stiffness-3",
        "Single stiffness along the path",
        "c(ξ) = C_M c′_th (1 − 0.33 ((ξ − ε_α/2)/(ε_α/2))²)",
        "crates/gear/src/iso_stiffness.rs",
        "iso_stiffness_has_the_loss_factors_of_a_second_program",
        &[],
    ),
    Equation::new(
        "Relief-1",
        "Separation of modified flanks",
        "e = Σ C_a ((ξ − ξ₁) p_et/L)ⁿ + C_c (2y/b − 1)² + C_l (y/b − ½) + C_p (ξ/ε_α − ½) + C_Ca (2ξ/ε_α − 1)² + Σ e_i(ξ) + pitch",
        "crates/gear/src/relief.rs",
        "relieved_loss_factors_are_those_of_the_reference",
        &[ISO_21771, ISO_1328_1],
    ),
    Equation::new(
        "Relief-2",
        "Roll length of a relief",
        "L = |√(r_end² − r_b²) − √(r_start² − r_b²)|",
        "crates/gear/src/relief.rs",
        "a_start_diameter_gives_the_roll_length_it_leaves",
        &[ISO_21771],
    ),
    Equation::new(
        "Relief-3",
        "Separation by the measured form of a flank",
        "e_i(ξ) = w̄_i − w_i(ρ_i(ξ)), ρ₁ = s_A + ξ p_et, ρ₂ = |T₁T₂ − ρ₁|",
        "crates/gear/src/relief.rs",
        "a_measured_form_acts_as_the_relief_it_shows",
        &[ISO_21771],
    ),
    Equation::new(
        "Edge-1",
        "Separation of a tip edge outside the path",
        "g = r_b1 (θ_P + inv(arccos(r_b1/r_P)) − θ_b)",
        "crates/gear/src/edge_contact.rs",
        "the_reference_pairs_have_their_geometry_and_forces",
        &[],
    ),
    Equation::new(
        "Load-map-1",
        "Load over the lines of contact of elastic teeth",
        "u = √q_b w, w − λ² w″ = √q_b f; f > 0: u + f q_H(f) = δ − e; Σ ∫ f dl = F_bn",
        "crates/gear/src/load_map/coupled.rs",
        "touching_cells_share_the_approach_and_the_others_stay_clear",
        &[],
    ),
    Equation::new(
        "Load-map-2",
        "Load over the lines of contact by weights",
        "f = F_bn v(ξ)/∫ v dl; v = 1: f = F_bn/l(φ)",
        "crates/gear/src/load_map/rigid.rs",
        "laws_without_deflections_have_the_loss_factors_of_the_reference",
        &[NIEMANN_WINTER, PEDRERO_2010],
    ),
    Equation::new(
        "Loss-5",
        "Loss factor of a load map",
        "H_V = (1/cos β_b) ∫∫ f |V_s| dy dξ/(T₁ ω₁)",
        "crates/gear/src/load_map/map.rs",
        "elastic_loss_factors_are_those_of_the_reference",
        &[WIMMER_2006],
    ),
    Equation::new(
        "Cell-1",
        "Representative contact of a cell of the path",
        "ξ̄ = ∫ ξ dP/∫ dP, ln f̄ = ∫ ln f dP/∫ dP, dP = f |V_s| dl",
        "crates/gear/src/load_map/cells.rs",
        "sixteen_cells_stand_for_friction_that_varies",
        &[],
    ),
    Equation::new(
        "Width-1",
        "Face load factor",
        "K_Hβ = largest over mean load per width of the face, in 16 strips",
        "crates/gear/src/load_map/cells.rs",
        "width_errors_load_one_end_and_leave_the_loss",
        &[ISO_6336_1],
    ),
    Equation::new(
        "TE-1",
        "Transmission error",
        "TE = δ/cos β_b",
        "crates/gear/src/load_map/deflection.rs",
        "transmission_errors_are_those_of_the_reference",
        &[],
    ),
    Equation::new(
        "TE-2",
        "Mesh stiffness",
        "c_γ = mean of F_bt/(b TE)",
        "crates/gear/src/load_map/deflection.rs",
        "transmission_errors_are_those_of_the_reference",
        &[ISO_6336_1],
    ),
    Equation::new(
        "Planet-1",
        "Speeds of a planetary set",
        "ω_c = (ω_s z_s + ω_r z_r)/(z_s + z_r), ω_p − ω_c = −(ω_s − ω_c) z_s/z_p",
        "crates/gear/src/planetary.rs",
        "a_planetary_set_turns_as_willis_says",
        &[WILLIS_1870],
    ),
    Equation::new(
        "Planet-2",
        "Torques of the meshes of a planetary set",
        "T = T_s/n_p at the sun, T_s z_p/(n_p z_s) at the planet",
        "crates/gear/src/planetary.rs",
        "the_meshes_of_a_planetary_set_carry_the_torque_of_the_sun",
        &[NIEMANN_WINTER],
    ),
    Equation::new(
        "Planet-3",
        "Loss of a planetary set",
        "P = n_p (P_sun-planet + P_planet-ring)",
        "crates/gear/src/planetary.rs",
        "the_loss_of_a_planetary_set_is_that_of_its_meshes",
        &[NIEMANN_WINTER],
    ),
    Equation::new(
        "Flank-arc",
        "Arc of the involute to a point of the flank",
        "ρ = √(r² − r_b²) = r_b ξ, l = ρ²/(2 r_b)",
        "crates/gear/src/flank_coordinate.rs",
        "arcs_at_the_ends_and_the_pitch_point_are_those_of_the_reference",
        &[ISO_21771],
    ),
    Equation::new(
        "Flank-meeting",
        "Places of both flanks that meet",
        "l₁(s) + x meets l₂(s) − x; l₂(s) + x on a ring",
        "crates/gear/src/flank_coordinate.rs",
        "the_tip_of_one_gear_meets_the_root_of_the_other",
        &[ISO_21771],
    ),
];
