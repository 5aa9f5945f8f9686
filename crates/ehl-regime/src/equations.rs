//! The equations of this crate, for `docs/EQUATIONS.md`.

use asperity_core::{Equation, Reference};

/// The standard book on line contacts.
pub const DOWSON_HIGGINSON_1977: Reference = Reference {
    key: "dowson_higginson_1977",
    text: "D. Dowson, G. R. Higginson, Elasto-hydrodynamic Lubrication, 2nd ed., Pergamon Press, 1977",
};

/// The central film of line contacts.
pub const DOWSON_TOYODA_1979: Reference = Reference {
    key: "dowson_toyoda_1979",
    text: "D. Dowson, A. Toyoda, A central film thickness formula for elastohydrodynamic line contacts, Proc. 5th Leeds-Lyon Symposium on Tribology (1978), Mechanical Engineering Publications, 1979, 60-65",
};

/// The inlet solution.
pub const GRUBIN_1949: Reference = Reference {
    key: "grubin_1949",
    text: "A. N. Grubin, I. E. Vinogradova, Investigation of the contact of machine components, TsNIITMASh Book 30, Moscow, 1949 (DSIR translation 337)",
};

/// The micropitting rating.
pub const ISO_TS_6336_22: Reference = Reference {
    key: "iso_ts_6336_22_2018",
    text: "ISO/TS 6336-22:2018, Calculation of load capacity of spur and helical gears - Part 22: Calculation of micropitting load capacity (scope read in its abstract; parameters and flash temperature from memory, text not reached)",
};

/// A paper that quotes film and specific film of the micropitting rating.
pub const JBILY_2024: Reference = Reference {
    key: "jbily_2024",
    text: "D. Jbily et al., Procedia Structural Integrity 57 (2024) 199-216, eqs 8 to 10",
};

/// The form with four asymptotes.
pub const MOES_2000: Reference = Reference {
    key: "moes_2000",
    text: "H. Moes, Lubrication and Beyond, lecture notes, University of Twente, 2000",
};

/// The elliptical film.
pub const HAMROCK_DOWSON_1977: Reference = Reference {
    key: "hamrock_dowson_1977",
    text: "B. J. Hamrock, D. Dowson, Isothermal elastohydrodynamic lubrication of point contacts, Part III: fully flooded results, ASME J. Lubr. Technol. 99 (1977) 264-276",
};

/// Thermal reduction with sliding.
pub const GUPTA_1992: Reference = Reference {
    key: "gupta_1992",
    text: "P. K. Gupta, H. S. Cheng, D. Zhu, N. H. Forster, J. B. Schrand, Viscoelastic effects in MIL-L-7808-type lubricant, Part I: analytical formulation, Tribol. Trans. 35 (1992) 269-274",
};

/// Thermal reduction in pure rolling.
pub const MURCH_WILSON_1975: Reference = Reference {
    key: "murch_wilson_1975",
    text: "L. E. Murch, W. R. D. Wilson, A thermal elastohydrodynamic inlet zone analysis, ASME J. Lubr. Technol. 97 (1975) 212-216",
};

/// The film parameter Λ*.
pub const HANSEN_2021: Reference = Reference {
    key: "hansen_2021",
    text: "J. Hansen, M. Björling, R. Larsson, A new film parameter for rough surface EHL contacts with anisotropic and isotropic structures, Tribol. Lett. 69 (2021) 37",
};

/// Load sharing by the film ratio.
pub const ZHU_HU_2001: Reference = Reference {
    key: "zhu_hu_2001",
    text: "D. Zhu, Y.-Z. Hu, A computer program package for the prediction of EHL and mixed lubrication characteristics, friction, subsurface stresses and flash temperatures based on measured 3-D surface roughness, Tribol. Trans. 44 (2001) 383-390",
};

/// Attenuation of roughness in the inlet.
pub const VENNER_1997: Reference = Reference {
    key: "venner_1997",
    text: "C. H. Venner, F. Couhier, A. A. Lubrecht, J. A. Greenwood, Amplitude reduction of waviness in transient EHL line contacts, in Elastohydrodynamics '96, Tribology Series 32, Elsevier, 1997, 103-112, doi 10.1016/s0167-8922(08)70440-1 (abstract read; constants from memory)",
};

/// Flow through rough gaps by lay.
pub const TRIPP_1983: Reference = Reference {
    key: "tripp_1983",
    text: "J. H. Tripp, Surface roughness effects in hydrodynamic lubrication: the flow factor method, ASME J. Lubr. Technol. 105 (1983) 458-465 (from memory, source not reached)",
};

/// Mixed lubrication with statistical asperities.
pub const JOHNSON_GREENWOOD_POON_1972: Reference = Reference {
    key: "johnson_greenwood_poon_1972",
    text: "K. L. Johnson, J. A. Greenwood, S. Y. Poon, A simple theory of asperity contact in elastohydrodynamic lubrication, Wear 19 (1972) 91-108 (from memory, source not reached)",
};

/// Load share of rough line contacts.
pub const MASJEDI_KHONSARI_2012: Reference = Reference {
    key: "masjedi_khonsari_2012",
    text: "M. Masjedi, M. M. Khonsari, Film thickness and asperity load formulas for line-contact elastohydrodynamic lubrication with provision for surface roughness, ASME J. Tribol. 134 (2012) 011503, doi 10.1115/1.4005514 (abstract read; constants from memory)",
};

const ATTENUATION: &str = "crates/ehl-regime/src/attenuation.rs";
const INLET: &str = "crates/ehl-regime/src/inlet_flow.rs";
const SHARES: &str = "crates/ehl-regime/src/published_shares.rs";
const DIMENSIONLESS: &str = "crates/ehl-regime/src/dimensionless.rs";
const LINE: &str = "crates/ehl-regime/src/film_line.rs";
const ELLIPTIC: &str = "crates/ehl-regime/src/film_elliptic.rs";
const THERMAL: &str = "crates/ehl-regime/src/thermal_reduction.rs";
const LAMBDA: &str = "crates/ehl-regime/src/lambda_star.rs";
const REGIME: &str = "crates/ehl-regime/src/regime.rs";

/// Every equation of this crate.
pub const EQUATIONS: &[Equation] = &[
    Equation::new(
        "Film-groups",
        "Dimensionless material, speed and load groups",
        "G = α E′,  U = η₀ V_e/(E′ R),  W = w/(E′ R)",
        DIMENSIONLESS,
        "groups_of_the_reference_case",
        &[DOWSON_HIGGINSON_1977],
    ),
    Equation::new(
        "Dowson-Toyoda",
        "Central film of a line contact",
        "h_c = 3.06 U^0.69 G^0.56 W^−0.10 R",
        LINE,
        "line_films_of_the_reference_case",
        &[DOWSON_TOYODA_1979],
    ),
    Equation::new(
        "Dowson-Higginson",
        "Minimum film of a line contact",
        "h_m = 2.65 U^0.70 G^0.54 W^−0.13 R",
        LINE,
        "line_films_of_the_reference_case",
        &[DOWSON_HIGGINSON_1977],
    ),
    Equation::new(
        "Ertel-Grubin",
        "Film of a line contact from the inlet",
        "h_c = 1.95 (G U)^(8/11) W^(−1/11) R",
        LINE,
        "ertel_grubin_agrees_with_its_own_inlet_integral",
        &[GRUBIN_1949],
    ),
    Equation::new(
        "Moes",
        "Central film of a line contact in all four regimes",
        "h_c = R √U_Σ [ (H_RI^(7/3) + H_EI^(7/3))^(3s/7) + (H_RP^(−7/2) + H_EP^(−7/2))^(−2s/7) ]^(1/s)",
        LINE,
        "moes_tends_to_each_of_its_asymptotes",
        &[MOES_2000],
    ),
    Equation::new(
        "Ellipticity",
        "Ellipticity of a contact from its radii",
        "k = 1.03 (R_y/R_x)^(2/π)",
        ELLIPTIC,
        "hamrock_dowson_films_of_published_test_cases",
        &[HAMROCK_DOWSON_1977],
    ),
    Equation::new(
        "P13",
        "Minimum film of an elliptical contact",
        "h_m = 3.63 U^0.68 G^0.49 W^−0.073 (1 − e^(−0.68 k)) R_x",
        ELLIPTIC,
        "hamrock_dowson_films_of_published_test_cases",
        &[HAMROCK_DOWSON_1977],
    ),
    Equation::new(
            "P14",
            "Central film of an elliptical contact",
            "h_c = 2.69 U^0.67 G^0.53 W^−0.067 (1 − 0.61 e^(−0.73 k)) R_x",
            ELLIPTIC,
            "hamrock_dowson_films_of_published_test_cases",
            &[HAMROCK_DOWSON_1977],
        ).corrected("prints k = 1.03 (R_y/R_x)^(1/π); 2/π is used, as in eq. 13 and as 0.73·1.03 = 0.75 of eq. 15 asks"),
    Equation::new(
            "P10",
            "Thermal reduction of film and rolling",
            "φ = max(0.3, 1 − 13.2 (p₀/E′) L^0.42)/(1 + 0.213 (1 + 2.23 |SRR|^0.83) L^0.64)",
            THERMAL,
            "thermal_reduction_of_the_reference_case",
            &[GUPTA_1992],
        ).corrected("prints dν/dT and then takes it as zero; −(dη/dT)/η₀ is used, and φ is 0.74 to 0.83 in the reference case"),
    Equation::new(
        "Thermal-load",
        "Thermal loading of the inlet",
        "L = η₀ β_T V_e²/k_oil",
        THERMAL,
        "thermal_reduction_of_the_reference_case",
        &[GUPTA_1992],
    ),
    Equation::new(
        "Murch-Wilson",
        "Thermal reduction in pure rolling",
        "φ = 3.94/(3.94 + L^0.62)",
        THERMAL,
        "murch_wilson_of_a_published_test_case",
        &[MURCH_WILSON_1975],
    ),
    Equation::new(
        "P11",
        "Film parameter of rough contacts",
        "Λ* = h*/S_pk",
        LAMBDA,
        "lambda_star_of_the_reference_case",
        &[HANSEN_2021],
    ),
    Equation::new(
            "P12",
            "Effective film of rough contacts",
            "h* = h_m + f_q h_c",
            LAMBDA,
            "lambda_star_of_the_reference_case",
            &[HANSEN_2021],
        ).corrected("calls h_c the undeformed distance; it is the central smooth film of the source"),
    Equation::new(
        "P15",
        "Ratio of the film between asperity and flank to the smooth film",
        "f_q = (R_xa/R_xb)^α [1 − γ₁ exp(−γ₂ (R_ya/R_xa)^γ₃)]/[1 − γ₁ exp(−γ₂ (R_yb/R_xb)^γ₃)]",
        LAMBDA,
        "film_factor_is_the_ratio_of_two_elliptical_films",
        &[HANSEN_2021],
    ),
    Equation::new(
        "Film-share",
        "Share of the load carried by the film",
        "c_f = 1 − (1 − min(Λ*, 1))²",
        REGIME,
        "film_share_is_one_from_lambda_star_one_on_and_rises_to_it",
        &[],
    ),
    Equation::new(
        "Zhu-Hu",
        "Share of the load carried by the film, by the classical film ratio",
        "c_f = min(1, 1.21 λ^0.64/(1 + 0.37 λ^1.26))",
        REGIME,
        "zhu_hu_share_rises_to_one_and_stays",
        &[ZHU_HU_2001],
    ),
    Equation::new(
        "Film-ratio",
        "Classical film ratio",
        "λ = φ h/Sq",
        REGIME,
        "film_ratio_of_the_reference_case",
        &[DOWSON_HIGGINSON_1977],
    ),
    Equation::new(
        "Moes-numbers",
        "Moes' load and material number",
        "M = W (2U)^(−1/2), L = G (2U)^(1/4)",
        ATTENUATION,
        "moes_numbers_give_the_film_of_moes",
        &[MOES_2000],
    ),
    Equation::new(
        "Venner-nabla",
        "Dimensionless wavelength of roughness",
        "∇ = (l/a) M^(3/4) L^(−1/2)",
        ATTENUATION,
        "attenuation_of_the_reference_windows",
        &[VENNER_1997],
    ),
    Equation::new(
        "Venner",
        "Amplitude of a roughness wave in the contact",
        "A = 1/(1 + 0.125 ∇ + 0.04 ∇²)",
        ATTENUATION,
        "a_wave_keeps_its_amplitude_ratio",
        &[VENNER_1997],
    ),
    Equation::new(
        "Attenuated-trace",
        "Trace in the contact",
        "ẑ_d = A ẑ per wavelength, without mean",
        ATTENUATION,
        "a_wave_keeps_its_amplitude_ratio",
        &[VENNER_1997],
    ),
    Equation::new(
        "Inlet-flow",
        "Ratio of the mean gap of rough flanks to the smooth film",
        "Ψ = √(1 + 2.342 t (σ_d/h_c)²), t = (3/(1 + γ) − 1)/2",
        INLET,
        "inlet_factor_is_the_small_roughness_limit_of_grubins_inlet",
        &[GRUBIN_1949, TRIPP_1983],
    ),
    Equation::new(
        "Supply",
        "Mean gap supplied at an asperity share",
        "h̄ = h_c Ψ (1 − min(φ, 0.99))^(−0.16)",
        INLET,
        "supply_rises_with_the_share",
        &[JOHNSON_GREENWOOD_POON_1972],
    ),
    Equation::new(
        "Central-gap",
        "Gap of a central film",
        "h = h_c/(ρ(p₀)/ρ₀)",
        INLET,
        "gap_is_the_compressed_film",
        &[DOWSON_HIGGINSON_1977],
    ),
    Equation::new(
        "Masjedi-Khonsari",
        "Asperity share of a rough line contact",
        "L_a = 0.00005 W^−0.408 U^−0.088 G^0.103 ln(1 + 4470 σ̄^6.015 V^1.168 W^0.485 U^−3.741 G^−2.898)",
        SHARES,
        "masjedi_khonsari_of_the_fixture_pair",
        &[MASJEDI_KHONSARI_2012],
    ),
    Equation::new(
        "Johnson-Greenwood-Poon",
        "Film share by the mean gap",
        "c_f = (h_c/h̄)^6.3",
        SHARES,
        "johnson_greenwood_poon_is_the_inverse_of_the_supply",
        &[JOHNSON_GREENWOOD_POON_1972],
    ),
    Equation::new(
        "Micropitting-1",
        "Film of the micropitting rating",
        "h = 1600 ρ_n G_M^0.6 U^0.7 W^−0.13 S^0.22 µm; G_M = 1e6 α_M E_r, U = η_M v_Σ/(2000 E_r ρ_n), W = 2π p²/E_r², S = α_B η_B/(α_M η_M); mm, N, m/s",
        "crates/ehl-regime/src/micropitting.rs",
        "films_of_the_rating_are_those_of_an_independent_computation",
        &[ISO_TS_6336_22, JBILY_2024],
    ),
    Equation::new(
        "Micropitting-2",
        "Flash temperature of the micropitting rating",
        "ϑ_fl = (√π/2) 1e6 µ p |v₁ − v₂|/(B₁ √v₁ + B₂ √v₂) √(8 ρ_n p/(1000 E_r))",
        "crates/ehl-regime/src/micropitting.rs",
        "flash_of_the_rating_is_that_of_an_independent_computation",
        &[ISO_TS_6336_22],
    ),
    Equation::new(
        "Micropitting-3",
        "Specific film thickness of the micropitting rating",
        "λ_GF = h/((Ra₁ + Ra₂)/2)",
        "crates/ehl-regime/src/micropitting.rs",
        "films_of_the_rating_are_those_of_an_independent_computation",
        &[ISO_TS_6336_22, JBILY_2024],
    ),
];
