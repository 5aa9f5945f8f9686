//! What a planetary set says of itself in digits.

use asperity::pipeline::KeptFields;
use asperity::planetary::{MeshRow, run_planetary};
use asperity_tests::planetary_set;

/// The numbers of "95.4 (80..110)".
fn numbers(text: &str) -> [f64; 3] {
    let cleared = text.replace(['(', ')'], "").replace("..", " ");
    let found: Vec<f64> = cleared
        .split(' ')
        .map(|word| word.parse().unwrap())
        .collect();
    found.try_into().unwrap()
}

#[test]
fn losses_are_said_with_the_digits_of_their_band() {
    let mut result = run_planetary(&planetary_set(), &KeptFields::All, &|_, _| {})
        .unwrap()
        .result;
    let drawn = result.loss_distribution.unwrap();
    let [low, high] = drawn.quantiles_w;
    let [loss, efficiency] = result.with_bands();
    // The last place is a fortieth to a quarter of the interval, rounding half of it.
    let near = |what: &str, found: [f64; 3], expected: [f64; 3], width: f64| {
        for (found, expected) in found.into_iter().zip(expected) {
            assert!(
                (found - expected).abs() < 0.126 * width,
                "{what}: {found} {expected}"
            );
        }
    };
    near(
        "loss",
        numbers(&loss),
        [drawn.median_w, low, high],
        high - low,
    );
    let percent = |loss: f64| 100.0 * (1.0 - loss / result.power_in_w);
    let expected = [drawn.median_w, high, low].map(percent);
    near(
        "efficiency",
        numbers(&efficiency),
        expected,
        expected[2] - expected[1],
    );
    // No digit is finer than a fiftieth of the interval, a hundredth where the loss becomes per cent.
    let step = |text: &str| {
        let first = text.split(' ').next().unwrap();
        let zeros = first.len() - first.trim_end_matches('0').len();
        let places = first.split_once('.').map(|(_, after)| after.len());
        match places {
            Some(places) => 0.1_f64.powi(places.try_into().unwrap()),
            None => 10_f64.powi(zeros.try_into().unwrap()),
        }
    };
    assert!(step(&loss) > 0.02 * (high - low), "{loss}");
    let band = expected[2] - expected[1];
    assert!(step(&efficiency) > 0.01 * band, "{efficiency}");

    for mesh in &result.meshes {
        let said = mesh.with_digits().map(|text| text.parse::<f64>().unwrap());
        let band = mesh.loss_q95_w.unwrap() - mesh.loss_q05_w.unwrap();
        let share = band / mesh.loss_w;
        let expected = [
            (mesh.loss_w, band),
            (
                100.0 * mesh.efficiency,
                100.0 * (1.0 - mesh.efficiency) * share,
            ),
            (mesh.mu_equivalent, mesh.mu_equivalent * share),
        ];
        for (said, (value, band)) in said.into_iter().zip(expected) {
            assert!(
                (said - value).abs() < 0.126 * band,
                "{mesh:?}: {said} {value}"
            );
        }
        assert!(
            mesh.with_digits().iter().all(|text| text.len() < 9),
            "{mesh:?}"
        );
    }

    let digits = |row: &MeshRow| row.with_digits()[0].len();
    let with = digits(&result.meshes[0]);
    let mut exact = result.meshes[0].clone();
    (exact.loss_q05_w, exact.loss_q95_w) = (None, None);
    assert!(digits(&exact) > with);
    result.loss_distribution = None;
    let expected = [result.loss_w, 100.0 * result.efficiency].map(|value| format!("{value:.4}"));
    assert_eq!(result.with_bands(), expected);
}
