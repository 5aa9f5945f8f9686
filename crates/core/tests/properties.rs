//! Properties of quantities that hold for every input.
#![allow(clippy::unwrap_used)] // Helpers outside test functions.

use asperity_core::quantity::{
    Angle, AngularSpeed, Density, DynamicViscosity, Energy, Force, KinematicViscosity, Length,
    LineEnergy, LineLoad, PerKelvin, Power, Pressure, PressureViscosity, Quantity, Ratio,
    SpecificHeat, Speed, Temperature, ThermalConductivity, Time, Torque,
};
use proptest::prelude::*;

/// Calls `$check::<Q>` for every quantity Q that may be negative.
macro_rules! for_every_quantity {
    ($check:ident($($argument:expr),*)) => {
        for_every_quantity!(@ $check($($argument),*):
            Length, Angle, Time, Speed, AngularSpeed, Force, LineLoad, Torque, Power, Energy, LineEnergy,
            Pressure, DynamicViscosity, KinematicViscosity, Density, PressureViscosity,
            ThermalConductivity, SpecificHeat, PerKelvin)
    };
    (@ $check:ident $arguments:tt: $($quantity:ident),*) => {
        $( for_every_quantity!(# $check $quantity $arguments); )*
    };
    (# $check:ident $quantity:ident ($($argument:expr),*)) => {
        $check::<$quantity>($($argument),*)
    };
}

fn finite() -> impl Strategy<Value = f64> {
    use proptest::num::f64::{NEGATIVE, NORMAL, POSITIVE, SUBNORMAL, ZERO};
    prop_oneof![
        POSITIVE | NEGATIVE | NORMAL | SUBNORMAL | ZERO,
        // The sizes that machines have, which the line above hardly ever meets.
        (-1.0..1.0f64, -12..12).prop_map(|(mantissa, exponent)| mantissa * 10f64.powi(exponent)),
    ]
}

/// The message about a missing or unknown unit lists exactly the spellings that are read.
fn lists_all_units<Q: Quantity>()
where
    <Q as std::str::FromStr>::Err: std::fmt::Display,
{
    for text in ["1", "1 furlong"] {
        let said = text
            .parse::<Q>()
            .map(|_| ())
            .map_err(|error| error.to_string());
        let said = said.unwrap_err();
        for unit in Q::UNITS {
            for spelling in std::iter::once(&unit.symbol).chain(unit.spellings) {
                assert!(format!("1 {spelling}").parse::<Q>().is_ok(), "{spelling}");
                let list = said
                    .split_once("one of: ")
                    .or_else(|| said.split_once("accepted: "));
                let list = list.unwrap().1.split(" (as ").next().unwrap();
                let is_listed = list.split(", ").any(|part| part == *spelling);
                assert!(is_listed, "{spelling}: {said}");
            }
        }
    }
}

#[test]
fn every_unit_that_is_read_is_in_the_message() {
    for_every_quantity!(lists_all_units());
    lists_all_units::<Temperature>();
}

fn survives_its_text<Q: Quantity>(value: f64) {
    let text = Q::from_si(value).to_string();
    let back = text
        .parse::<Q>()
        .ok()
        .map(|quantity| quantity.si().to_bits());
    assert_eq!(
        back,
        Some(value.to_bits()),
        "{} {value:e} prints as {text}",
        Q::NAME
    );
}

fn reads_or_refuses<Q: Quantity>(text: &str) {
    if let Ok(quantity) = text.parse::<Q>() {
        assert!(quantity.si().is_finite(), "{} {text}", Q::NAME);
    }
}

/// Texts of pieces that quantities are made of, so that many nearly read.
fn unit_text() -> impl Strategy<Value = String> {
    let piece = prop::sample::select(vec![
        "1", "0", "285", "-", "+", ".", ",", "e", "E", "e5", "e-3", "e999", "_", " ", "\u{a0}",
        "µ", "u", "m", "mm", "N", "·", "*", "/", "(", ")", "^", "2", "²", "⁻", "°", "C", "K", "Pa",
        "MPa", "s", "min", "1/min", "rpm", "kg", "J", "W", "%", "inf", "nan", "∞", "é",
    ]);
    prop_oneof![
        prop::collection::vec(piece, 0..8).prop_map(|pieces| pieces.concat()),
        any::<String>(),
    ]
}

proptest! {
    #![proptest_config(ProptestConfig { failure_persistence: None, ..ProptestConfig::with_cases(2000) })]

    #[test]
    fn every_quantity_survives_its_text_to_the_last_bit(value in finite()) {
        for_every_quantity!(survives_its_text(value));
        // Below absolute zero there is no temperature to print.
        survives_its_text::<Temperature>(value.abs());
        let ratio = Ratio::new(value).to_string().parse::<Ratio>().unwrap();
        prop_assert_eq!(ratio.value().to_bits(), value.to_bits());
    }

    #[test]
    fn every_quantity_survives_json(value in finite()) {
        let length: Length = serde_json::from_str(&serde_json::to_string(&Length::from_si(value)).unwrap()).unwrap();
        prop_assert_eq!(length.si().to_bits(), value.to_bits());
    }
}

proptest! {
    #![proptest_config(ProptestConfig { failure_persistence: None, ..ProptestConfig::with_cases(10_000) })]

    #[test]
    fn no_text_makes_a_quantity_panic(text in unit_text()) {
        for_every_quantity!(reads_or_refuses(&text));
        reads_or_refuses::<Temperature>(&text);
        if let Ok(ratio) = text.parse::<Ratio>() {
            prop_assert!(ratio.value().is_finite());
        }
    }
}
