//! Single equations at single points, as the document shows them; the crates prove them.

use asperity::oil::{AstmD341, roelands_exponent};
use asperity_core::quantity::{
    DynamicViscosity, Length, LineLoad, Pressure, PressureViscosity, Speed,
};
use asperity_ehl_regime::film_elliptic::{ellipticity, hamrock_dowson_central};
use asperity_ehl_regime::thermal_reduction::gupta;
use asperity_ehl_regime::{AsperityShape, FilmConditions, Orientation};
use asperity_tribo_friction::XuLaw;
use asperity_tribo_friction::xu::XuConditions;

use crate::comparison::{Comparison, Table};

const ROUNDING: f64 = 1e-12;

fn xu(slide_to_roll: f64, max_pressure: f64) -> f64 {
    let at = XuConditions {
        slide_to_roll,
        max_pressure: Pressure::from_si(max_pressure),
        viscosity: DynamicViscosity::from_si(0.010),
        entrainment: Speed::from_si(10.0),
        radius: Length::from_si(0.010),
        combined_roughness: Length::from_si(0.1e-6),
    };
    XuLaw::default().coefficient(&at).unwrap().value
}

/// |SR| Ph log₁₀ν₀ where μ is largest, by golden section.
fn xu_peak() -> f64 {
    let (mut low, mut high) = (0.1, 1.0);
    for _ in 0..100 {
        let third = (high - low) / 3.0;
        // At 1 GPa and 10 cP the product is the slide-to-roll ratio.
        if xu(low + third, 1e9) < xu(high - third, 1e9) {
            low += third;
        } else {
            high -= third;
        }
    }
    0.5 * (low + high)
}

/// Central film of Hamrock and Dowson at C of Table 2 with the load group of a line \[m\].
fn hamrock_dowson_of_a_line() -> f64 {
    let at = FilmConditions {
        entrainment: Speed::from_si(4.567_908_850_02),
        radius: Length::from_si(11.626_875_546_1e-3),
        load: LineLoad::from_si(113_408.970_605),
        modulus: Pressure::from_si(105e9 / 0.91),
        viscosity: DynamicViscosity::from_si(0.0975),
        pressure_viscosity: PressureViscosity::from_si(2e-8),
        contact_length: None,
    };
    let groups = at.line_groups().unwrap();
    let film = hamrock_dowson_central(&groups, at.radius, f64::INFINITY);
    film.unwrap().value.si()
}

/// Equations of oil, film and thermal reduction with the values computed elsewhere.
fn oil_and_film() -> [(&'static str, &'static str, f64, f64); 5] {
    let data_sheet = ["100 mm2/s", "11.2 mm2/s"].map(|text| text.parse().unwrap());
    let oil = AstmD341::from_data_sheet(data_sheet[0], data_sheet[1]).unwrap();
    let oil = oil.kinematic_viscosity("60 °C".parse().unwrap()).unwrap();
    let exponent = roelands_exponent("97.5 mPa s".parse().unwrap(), "2e-8 1/Pa".parse().unwrap());
    let ridges = AsperityShape::ridges(Length::from_si(100e-6), Length::from_si(10e-3));
    let factor = ridges.film_factor(Orientation::Transverse, 0.67).unwrap();
    let phi = gupta(Pressure::from_si(1e9), Pressure::from_si(113.5e9), 1.0, 0.2).unwrap();
    [
        (
            "ν at 60 °C, ASTM D341, 100 and 11.2 mm²/s",
            "mm²/s",
            39.859_219_084_521_17,
            oil.value.si() * 1e6,
        ),
        (
            "Roelands' Z, 97.5 mPa s, 2e-8 1/Pa",
            "-",
            0.534_121_052_141_019_8,
            exponent.unwrap(),
        ),
        (
            "k = 1.03 (Ry/Rx)^(2/π), Ry/Rx = 10",
            "-",
            4.461_254_479_892_096,
            ellipticity(10.0).unwrap(),
        ),
        (
            "f_q, ridges of 0.1 mm on a flank of 10 mm",
            "-",
            0.118_032_063_565_173_04,
            factor,
        ),
        (
            "φ, Gupta, 1 GPa, E′ 227 GPa, L 1, SRR 0.2",
            "-",
            0.703_980_037_368_216_2,
            phi.value,
        ),
    ]
}

pub fn spot_values() -> Table {
    let mut rows = vec![
        Comparison::new(
            "μ, Xu, SR 0.2, 1 GPa, 10 cP, 10 m/s, 10 mm, 0.1 µm",
            "-",
            0.012_716_825_722_695_101,
            xu(0.2, 1e9),
            ROUNDING,
        ),
        Comparison::new(
            "the same, SR 0.5, 1.5 GPa",
            "-",
            0.015_524_023_448_344_361,
            xu(0.5, 1.5e9),
            ROUNDING,
        ),
        // A maximum is flat: its place is known to the root of the precision of its value.
        Comparison::new(
            "SR·Ph·log₁₀ν₀ where Xu's μ is largest",
            "-",
            0.505_195,
            xu_peak(),
            1e-6,
        ),
        // Evaluated at a load and a radius given to ten digits.
        Comparison::new(
            "central film at C of Table 2, Hamrock-Dowson, k → ∞, line W",
            "µm",
            1.505_765_717,
            hamrock_dowson_of_a_line() * 1e6,
            1e-8,
        ),
    ];
    let others = oil_and_film().into_iter();
    rows.extend(others.map(|(quantity, unit, expected, actual)| {
        Comparison::new(quantity, unit, expected, actual, ROUNDING)
    }));
    Table {
        name: "spot-values",
        test: "single_equations_have_the_values_computed_elsewhere",
        rows,
    }
}

#[test]
fn single_equations_have_the_values_computed_elsewhere() {
    spot_values().hold();
}
