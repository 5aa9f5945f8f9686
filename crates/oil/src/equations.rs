//! The equations of the lubricant, for `docs/EQUATIONS.md`.

use asperity_core::citation::{Equation, Reference};

const ASTM_D341: Reference = Reference {
    key: "astm_d341",
    text: "ASTM D341, Standard Practice for Viscosity-Temperature Equations and Charts for Liquid Petroleum or Hydrocarbon Products, ASTM International",
};
const VOGEL_1921: Reference = Reference {
    key: "vogel_1921",
    text: "H. Vogel, Das Temperaturabhängigkeitsgesetz der Viskosität von Flüssigkeiten, Physikalische Zeitschrift 22, 645-646, 1921",
};
const REYNOLDS_1886: Reference = Reference {
    key: "reynolds_1886",
    text: "O. Reynolds, On the theory of lubrication, Phil. Trans. R. Soc. London 177, 157-234, 1886",
};
const BARUS_1893: Reference = Reference {
    key: "barus_1893",
    text: "C. Barus, Isothermals, isopiestics and isometrics relative to viscosity, American Journal of Science 45, 87-96, 1893",
};
const STACHOWIAK_2014: Reference = Reference {
    key: "stachowiak_2014",
    text: "G. W. Stachowiak, A. W. Batchelor, Engineering Tribology, 4th edition, Butterworth-Heinemann, 2014",
};
const ROELANDS_1966: Reference = Reference {
    key: "roelands_1966",
    text: "C. J. A. Roelands, Correlational aspects of the viscosity-temperature-pressure relationship of lubricating oils, doctoral thesis, Delft, 1966",
};
const DOWSON_1966: Reference = Reference {
    key: "dowson_1966",
    text: "D. Dowson, G. R. Higginson, Elasto-Hydrodynamic Lubrication, Pergamon, 1966",
};
const GOLD_2001: Reference = Reference {
    key: "gold_2001",
    text: "P. W. Gold, A. Schmidt, H. Dicke, J. Loos, C. Assmann, Viscosity-pressure-temperature behaviour of mineral and synthetic oils, Journal of Synthetic Lubrication 18(1), 51-79, 2001",
};
const FERNANDES_2013: Reference = Reference {
    key: "fernandes_2013",
    text: "C. M. C. G. Fernandes, R. C. Martins, J. H. O. Seabra, Friction torque of thrust ball bearings lubricated with wind turbine gear oils, Tribology International 58, 47-54, 2013",
};
const CRAGOE_1929: Reference = Reference {
    key: "cragoe_1929",
    text: "C. S. Cragoe, Thermal properties of petroleum products, Miscellaneous Publication 97, National Bureau of Standards, Washington, 1929",
};

const TEMPERATURE: &str = "crates/oil/src/viscosity_temperature.rs";
const PRESSURE: &str = "crates/oil/src/viscosity_pressure.rs";
const DENSITY: &str = "crates/oil/src/density.rs";
const HEAT: &str = "crates/oil/src/heat.rs";

/// Every equation of the lubricant.
pub const EQUATIONS: &[Equation] = &[
    Equation::new(
        "ASTM-1",
        "Constants of ASTM D341 from a data sheet",
        "B = (Y₁ − Y₂)/(log₁₀ T₂ − log₁₀ T₁), A = Y₁ + B·log₁₀ T₁, Yᵢ = log₁₀ log₁₀ (νᵢ + 0.7)",
        TEMPERATURE,
        "astm_d341_passes_through_the_data_sheet_and_60_degrees",
        &[ASTM_D341],
    ),
    Equation::new(
        "ASTM-2",
        "Kinematic viscosity against temperature",
        "log₁₀ log₁₀ (ν + 0.7) = A − B·log₁₀ T",
        TEMPERATURE,
        "astm_d341_passes_through_the_data_sheet_and_60_degrees",
        &[ASTM_D341],
    ),
    Equation::new(
        "ASTM-3",
        "Temperature coefficient of the kinematic viscosity",
        "β_ν = B·(ν + 0.7)·ln(ν + 0.7)/(ν·T)",
        TEMPERATURE,
        "the_temperature_coefficients_are_the_slopes_of_their_laws",
        &[ASTM_D341],
    ),
    Equation::new(
        "Vogel-1",
        "Dynamic viscosity against temperature",
        "η = K·exp(b/(T − θ))",
        TEMPERATURE,
        "the_temperature_coefficients_are_the_slopes_of_their_laws",
        &[VOGEL_1921],
    ),
    Equation::new(
        "Vogel-2",
        "Temperature coefficient of Vogel's law",
        "β = b/(T − θ)²",
        TEMPERATURE,
        "the_temperature_coefficients_are_the_slopes_of_their_laws",
        &[VOGEL_1921],
    ),
    Equation::new(
        "Reynolds-eta",
        "Dynamic viscosity near a known one",
        "η = η_r·exp(−β·(T − T_r))",
        TEMPERATURE,
        "the_exponential_law_stays_within_a_tenth_of_astm_d341_over_20_kelvin",
        &[REYNOLDS_1886],
    ),
    Equation::new(
        "Barus-1",
        "Viscosity against pressure, exponential",
        "η = η₀·exp(α·p)",
        PRESSURE,
        "roelands_and_barus_hit_the_reference_case",
        &[BARUS_1893, STACHOWIAK_2014],
    ),
    Equation::new(
        "Roelands-1",
        "Roelands' exponent",
        "Z = α/(5.1·10⁻⁹·(ln η₀ + 9.67))",
        PRESSURE,
        "both_laws_start_with_the_slope_alpha",
        &[ROELANDS_1966],
    ),
    Equation::new(
        "Roelands-2",
        "Viscosity against pressure",
        "η = η₀·exp((ln η₀ + 9.67)·((1 + 5.1·10⁻⁹·p)^Z − 1))",
        PRESSURE,
        "roelands_and_barus_hit_the_reference_case",
        &[ROELANDS_1966],
    ),
    Equation::new(
        "Density-1",
        "Density against temperature",
        "ρ = ρ_r·(1 − ε·(T − T_r))",
        DENSITY,
        "density_falls_linearly_and_its_coefficient_is_its_slope",
        &[FERNANDES_2013],
    ),
    Equation::new(
        "Density-2",
        "Density against pressure",
        "ρ = ρ₀·(1 + 0.6·10⁻⁹·p/(1 + 1.7·10⁻⁹·p))",
        DENSITY,
        "dowson_higginson_hits_the_reference_case_and_its_limit",
        &[DOWSON_1966],
    ),
    Equation::new(
        "Gold-1",
        "Pressure-viscosity coefficient of a class of base oil",
        "α = s·ν^t",
        "crates/oil/src/pressure_viscosity.rs",
        "mineral_oil_is_stiffer_under_pressure_than_synthetic_oil",
        &[GOLD_2001, FERNANDES_2013],
    ),
    Equation::new(
        "Cragoe-1",
        "Thermal conductivity of an oil",
        "k = 0.1172/d·(1 − 0.00054·t)",
        HEAT,
        "heat_properties_agree_with_cragoe_in_his_own_units",
        &[CRAGOE_1929],
    ),
    Equation::new(
        "Cragoe-2",
        "Specific heat capacity of an oil",
        "c = (1685 + 3.39·t)/√d",
        HEAT,
        "heat_properties_agree_with_cragoe_in_his_own_units",
        &[CRAGOE_1929],
    ),
];
