//! The band of a loss: what it must be in plain cases.

use std::path::Path;

use asperity::Run;
use asperity::case::{LoadedCase, load_with};
use asperity::pipeline::KeptFields;
use asperity::result::loss_band::{LossBand, Trust};
use asperity::uncertainty::difference;

const KEPT: KeptFields = KeptFields::Highest;

fn case(name: &str) -> LoadedCase {
    let file = Path::new(env!("CARGO_MANIFEST_DIR"))
        .join("../fixtures/cases")
        .join(name);
    load_with(&file, &|input| {
        (input.model.positions, input.model.offsets) = (Some(6), Some(8));
    })
    .unwrap()
}

fn band(case: &LoadedCase) -> LossBand {
    let outcome = Run::new(case).fields(&KEPT).band(true).execute().unwrap();
    outcome.result.band.unwrap()
}

#[test]
fn a_run_with_its_band_has_the_result_of_the_run() {
    let case = case("e-drive.toml");
    let plain = Run::new(&case).fields(&KEPT).execute().unwrap();
    let banded = Run::new(&case).fields(&KEPT).band(true).execute().unwrap();
    assert_eq!(plain.result.summary, banded.result.summary);
    assert_eq!(plain.result.path, banded.result.path);
    assert_eq!(plain.offsets, banded.offsets);
    let band = banded.result.band.unwrap();
    assert_eq!(band.nominal_w, plain.result.summary.loss_w);
    let tags: Vec<&str> = banded.result.equations.iter().map(|e| &*e.tag).collect();
    for tag in ["Latin-hypercube", "Effective-windows", "Sampling-error"] {
        assert!(tags.contains(&tag), "{tag}");
    }
    assert!(
        plain
            .result
            .equations
            .iter()
            .all(|e| tags.contains(&&*e.tag))
    );
}

#[test]
fn kept_contacts_give_the_losses_of_fresh_ones() {
    let case = case("e-drive.toml");
    let band = band(&case);
    // An alternative is evaluated by the contacts of the run; alone it solves its own.
    let other = case.with_key("model.boundary_layer", "20 nm").unwrap();
    let alone = Run::new(&other).fields(&KEPT).execute().unwrap();
    let row = band
        .alternatives
        .iter()
        .find(|row| row.name.contains("boundary layer"));
    assert_eq!(row.unwrap().loss_w, Some(alone.result.summary.loss_w));
}

#[test]
fn identical_finishes_differ_by_exactly_nothing() {
    let case = case("e-drive.toml");
    let [first, other] = [0, 1].map(|_| Run::new(&case).fields(&KEPT).draw().unwrap().1);
    let found = difference(&first, &other);
    assert_eq!(found.nominal_w, 0.0);
    assert_eq!(found.quantiles_w, [0.0, 0.0]);
    assert_eq!(found.parameter_quantiles_w, [0.0, 0.0]);
    assert_eq!(found.share_quantiles, [0.0, 0.0]);
    assert_eq!(found.sampling_half_width_w, Some(0.0));
}

#[test]
fn finishes_differ_less_than_each_is_uncertain() {
    let [ground, polished] = ["e-drive.toml", "e-drive-superfinished.toml"]
        .map(|name| Run::new(&case(name)).fields(&KEPT).draw().unwrap().1);
    let found = difference(&ground, &polished);
    assert!(
        found.nominal_w < 0.0 && found.quantiles_w[1] < 0.0,
        "{found:?}"
    );
    let width = |[low, high]: [f64; 2]| high - low;
    // The draws are the same, so what both finishes share cancels.
    let unpaired = width(ground.quantiles()).hypot(width(polished.quantiles()));
    assert!(width(found.quantiles_w) < unpaired, "{found:?} {unpaired}");
    // Of the other finish seen from this one all turns round, but for the last digits of the quantiles.
    let back = difference(&polished, &ground);
    assert_eq!(back.nominal_w, -found.nominal_w);
    assert!((back.quantiles_w[0] + found.quantiles_w[1]).abs() < 1e-6);
}

#[test]
fn what_the_case_states_is_not_drawn() {
    let all = band(&case("e-drive.toml"));
    let names = |band: &LossBand| -> Vec<String> {
        band.parameters.iter().map(|p| p.name.clone()).collect()
    };
    let every = [
        "boundary friction",
        "boundary layer",
        "lay",
        "limiting shear",
        "Eyring stress",
    ];
    assert_eq!(names(&all), every);
    let stated = case("e-drive.toml")
        .with_key("model.boundary_friction", "0.08")
        .unwrap();
    let stated = band(&stated);
    assert_eq!(names(&stated), every[1..]);
    assert_eq!(stated.held, ["boundary friction"]);
    // The same draws of the others, so the band is narrower and the loss the same.
    assert_eq!(stated.nominal_w, all.nominal_w);
    assert!(stated.half_width_w() < all.half_width_w());
}

#[test]
fn every_parameter_that_rubs_more_loses_more() {
    for parameter in band(&case("e-drive.toml")).parameters {
        assert!(parameter.effect_w > 0.0, "{parameter:?}");
        let range = parameter.low..=parameter.high;
        assert!(range.contains(&parameter.value), "{parameter:?}");
    }
    // Where hardly anything touches, only the film counts.
    for parameter in band(&case("e-drive-superfinished.toml")).parameters {
        let of_film = ["limiting shear", "Eyring stress"].contains(&parameter.name.as_str());
        assert!(of_film || parameter.effect_w.abs() < 10.0, "{parameter:?}");
    }
}

#[test]
fn flanks_known_by_their_ra_get_an_answer_on_surrogates() {
    let file = Path::new(env!("CARGO_MANIFEST_DIR")).join("../fixtures/cases/e-drive.toml");
    let case = load_with(&file, &|input| {
        input.surface.pinion = asperity::case::FlankInput {
            ra: Some("0.3 um".parse().unwrap()),
            ..Default::default()
        };
        input.surface.wheel = None;
        (input.model.positions, input.model.offsets) = (Some(6), Some(2));
    })
    .unwrap();
    let band = band(&case);
    assert_eq!(band.trust, Trust::Surrogates);
    assert!(band.half_width_w() > 0.0);
    let text = asperity_report::summary(
        &Run::new(&case)
            .fields(&KEPT)
            .band(true)
            .execute()
            .unwrap()
            .result,
    );
    assert!(text.contains("surrogate"), "{text}");
}

#[test]
fn the_paper_has_no_band() {
    let file = Path::new(env!("CARGO_MANIFEST_DIR")).join("../fixtures/cases/e-drive.toml");
    let case = load_with(&file, &|input| {
        input.formulation = Some(asperity::case::Formulation::Paper);
    })
    .unwrap();
    let outcome = Run::new(&case).fields(&KEPT).band(true).execute().unwrap();
    assert!(outcome.result.band.is_none());
}

/// A rig's calibration: the defaults with narrow bands, boundary friction and layer correlated.
const CALIBRATION: &str = r#"
[calibration]
source = "made up for a test"
boundary_friction = { value = 0.08, low = 0.074, high = 0.087 }
boundary_layer = { value = "10 nm", low = "8 nm", high = "13 nm" }
limiting_shear = { value = 0.035, low = 0.034, high = 0.036 }
eyring_stress = { value = "4 MPa", low = "3.8 MPa", high = "4.2 MPa" }
correlations = [{ between = ["boundary_layer", "boundary_friction"], value = -0.8 }]
"#;

fn calibrated() -> LoadedCase {
    let given: asperity::case::CalibrationInput = {
        let table: toml::Table = CALIBRATION.parse().unwrap();
        table["calibration"].clone().try_into().unwrap()
    };
    let given = &given;
    case("e-drive.toml")
        .with(|input| input.calibration = Some(given.clone()))
        .unwrap()
}

#[test]
fn a_calibrated_case_has_the_same_loss_and_a_narrower_band() {
    let (plain, narrow) = (band(&case("e-drive.toml")), band(&calibrated()));
    // The values are the defaults.
    assert_eq!(plain.nominal_w, narrow.nominal_w);
    let width = |[low, high]: [f64; 2]| high - low;
    let ratio = width(narrow.parameter_quantiles_w) / width(plain.parameter_quantiles_w);
    assert!(ratio < 0.5, "{ratio}");
    let names: Vec<(&str, bool)> = narrow
        .parameters
        .iter()
        .map(|one| (one.name.as_str(), one.is_calibrated))
        .collect();
    assert!(names.contains(&("boundary friction", true)) && names.contains(&("lay", false)));
    assert!(plain.parameters.iter().all(|one| !one.is_calibrated));
}

#[test]
fn constants_of_a_calibrated_case_are_told_with_their_source() {
    let outcome = Run::new(&calibrated())
        .fields(&KEPT)
        .band(true)
        .execute()
        .unwrap();
    let constants = outcome.result.film_constants;
    for name in [
        "boundary_friction",
        "boundary_layer_m",
        "limiting_shear",
        "eyring_stress_pa",
    ] {
        let found: Vec<_> = constants.iter().filter(|one| one.name == name).collect();
        assert_eq!(found.len(), 1, "{name}");
        assert_eq!(found[0].source, "made up for a test");
    }
}
