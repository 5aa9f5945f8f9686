//! Film and rolling of a cold oil.

use std::path::Path;

use asperity::case::load_with;

#[test]
fn film_and_rolling_do_not_fall_as_the_oil_thickens_in_the_cold() {
    let cases = Path::new(env!("CARGO_MANIFEST_DIR")).join("../fixtures/cases");
    // An oil above 100 Pa s is refused: the mineral oil is below it down to −30 °C.
    for (name, coldest) in [("e-drive-superfinished.toml", -40), ("fzg-c.toml", -30)] {
        let case = load_with(&cases.join(name), &|input| {
            (input.model.positions, input.model.offsets) = (Some(4), Some(1));
        });
        let case = case.unwrap();
        let tables = asperity_tests::contacts(&case).unwrap();
        let mut before: Option<(f64, Vec<f64>)> = None;
        for celsius in (coldest..=40).rev().step_by(5) {
            let at = format!("{celsius} °C");
            let cold = case.with_key("operation.bulk_temperature", &at).unwrap();
            let losses = asperity_tests::losses_with(&tables, &cold).unwrap();
            let films = losses.path.iter().map(|row| row.film_central_um).collect();
            let now: (f64, Vec<f64>) = (losses.summary.rolling_w, films);
            if let Some((rolling, films)) = &before {
                assert!(now.0 > *rolling, "{name} {celsius} °C: {} {rolling}", now.0);
                for (now, before) in now.1.iter().zip(films) {
                    assert!(now > before, "{name} {celsius} °C: {now} {before}");
                }
            }
            before = Some(now);
        }
    }
}

#[test]
fn the_interval_of_cold_oil_reaches_to_the_printed_thermal_reduction() {
    let cases = Path::new(env!("CARGO_MANIFEST_DIR")).join("../fixtures/cases");
    let case = load_with(&cases.join("e-drive-superfinished.toml"), &|input| {
        (input.model.positions, input.model.offsets) = (Some(4), Some(2));
    });
    let case = case.unwrap();
    let part = |celsius: &str| {
        let case = case.with_key("operation.bulk_temperature", celsius);
        let outcome = asperity::Run::new(&case.unwrap()).interval(true).execute();
        let uncertainty = outcome
            .unwrap()
            .into_only()
            .unwrap()
            .result
            .uncertainty
            .unwrap();
        let name = "thermal reduction beyond its fit";
        let mut parts = uncertainty.loss.parts.into_iter();
        parts.find(|part| part.name == name)
    };
    assert!(part("40 °C").is_none());
    let cold = part("-25 °C").unwrap();
    let [low, high] = cold.quantiles_w;
    assert!(low < 0.97 * high, "{low} {high}");
}
