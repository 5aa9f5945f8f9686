//! Film of a contact whose inlet is not flooded, as behind a sparse oil jet.

#![allow(
    clippy::unwrap_used,
    reason = "helpers of tests may unwrap as tests do"
)]

use asperity_core::quantity::Length;
use asperity_ehl_regime::starvation::starved;

fn factor(ratio: f64) -> f64 {
    starved(Length::from_si(1e-7), Length::from_si(ratio * 1e-7)).unwrap()
}

#[test]
fn a_starved_film_carries_the_layer_and_no_more_than_the_flooded_film() {
    for ratio in [1e-9, 0.1, 0.5, 0.8] {
        assert!((factor(ratio) / ratio - 1.0).abs() < 3e-3, "{ratio}");
    }
    for ratio in [1.3, 2.0, 1e9] {
        assert!((factor(ratio) - 1.0).abs() < 2e-3, "{ratio}");
    }
    assert!((factor(1.0) - 0.5_f64.powf(1.0 / 15.0)).abs() < 1e-15);
    let ratios: Vec<f64> = (1..200).map(|i| factor(0.02 * f64::from(i))).collect();
    assert!(ratios.is_sorted_by(|a, b| a <= b) && ratios.iter().all(|f| *f <= 1.0));
    // The printed form.
    for ratio in [0.7_f64, 0.9, 1.1] {
        let printed = ratio / (1.0 + ratio.powi(15)).powf(1.0 / 15.0);
        assert!((factor(ratio) - printed).abs() < 1e-14);
    }
}

#[test]
fn no_layer_is_no_film() {
    let film = Length::from_si(1e-7);
    for layer in [0.0, -1e-7, f64::NAN] {
        assert!(starved(film, Length::from_si(layer)).is_err());
    }
    assert!(starved(Length::from_si(0.0), film).is_err());
}
