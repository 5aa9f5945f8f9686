//! The uncertainty of a loss: what it must be in plain cases.

use std::path::Path;
use std::sync::{Arc, OnceLock};

use asperity::case::{Alternative, LoadInputs, LoadedCase, load_with};
use asperity::gear::{GearError, LoadConditions, LoadDistribution, LoadMap};
use asperity::oil::FilmConstantName;
use asperity::pipeline::Kept;
use asperity::result::loss_band::{Trust, Uncertainty};
use asperity::uncertainty::{PairedDifference, Verdict, difference};
use asperity::{Run, RunResult};

const KEPT: Kept = Kept::Highest;

fn case(name: &str) -> LoadedCase {
    let file = Path::new(env!("CARGO_MANIFEST_DIR"))
        .join("../fixtures/cases")
        .join(name);
    load_with(&file, &|input| {
        (input.model.positions, input.model.offsets) = (Some(6), Some(8));
    })
    .unwrap()
}

/// The uncertainty of a loss, and the loss with every constant at its median.
struct Drawn {
    of: Uncertainty,
    at_medians_w: f64,
}

impl std::ops::Deref for Drawn {
    type Target = Uncertainty;

    fn deref(&self) -> &Uncertainty {
        &self.of
    }
}

impl Drawn {
    fn to_median(&self) -> f64 {
        self.loss.median_w / self.at_medians_w
    }
}

fn uncertainty(case: &LoadedCase) -> Drawn {
    let outcome = Run::new(case)
        .pictures(KEPT)
        .interval(true)
        .execute()
        .unwrap()
        .into_only()
        .unwrap();
    Drawn {
        at_medians_w: outcome.result.summary.loss_at_medians_w.unwrap(),
        of: outcome.result.uncertainty.unwrap(),
    }
}

/// The e-drive and its uncertainty, drawn once.
fn e_drive() -> &'static (LoadedCase, Drawn) {
    static DRAWN: OnceLock<(LoadedCase, Drawn)> = OnceLock::new();
    DRAWN.get_or_init(|| {
        let case = case("e-drive.toml");
        let found = uncertainty(&case);
        (case, found)
    })
}

/// Difference of two cases, and the uncertainty of each.
fn between(first: &LoadedCase, other: &LoadedCase) -> (PairedDifference, [Uncertainty; 2]) {
    let drawn = [first, other].map(|case| {
        let (outcome, drawn) = Run::new(case)
            .pictures(KEPT)
            .interval(true)
            .execute()
            .unwrap()
            .only_with_draws()
            .unwrap();
        (case, drawn.unwrap(), outcome.result.uncertainty.unwrap())
    });
    let [own, theirs] = drawn
        .each_ref()
        .map(|(case, drawn, uncertainty)| (*case, drawn, uncertainty));
    let found = difference(own, theirs);
    (found, drawn.map(|(.., uncertainty)| uncertainty))
}

#[test]
fn a_run_with_its_band_is_the_run_restated_at_its_median() {
    let case = case("e-drive.toml");
    let plain = Run::new(&case)
        .pictures(KEPT)
        .execute()
        .unwrap()
        .into_only()
        .unwrap();
    let banded = Run::new(&case)
        .pictures(KEPT)
        .interval(true)
        .execute()
        .unwrap()
        .into_only()
        .unwrap();
    let (before, after) = (&plain.result.summary, &banded.result.summary);
    assert_eq!(after.loss_at_medians_w, Some(before.loss_w));
    assert_eq!(before.loss_at_medians_w, None);
    let found = banded.result.uncertainty.as_ref().unwrap();
    assert_eq!(after.loss_w, found.loss.median_w);
    let ratio = after.loss_w / before.loss_w;
    let is_scaled = |scaled: f64, of_run: f64| (scaled / of_run / ratio - 1.0).abs() < 1e-12;
    assert!(is_scaled(after.boundary_w, before.boundary_w));
    assert!(is_scaled(after.mu_equivalent, before.mu_equivalent));
    assert!(is_scaled(1.0 - after.efficiency, 1.0 - before.efficiency));
    assert_eq!(after.asperity_share, before.asperity_share);
    for (before, after) in plain.result.path.iter().zip(&banded.result.path) {
        assert!(is_scaled(after.sliding_w_per_m, before.sliding_w_per_m));
        assert!(is_scaled(after.mu, before.mu));
        assert_eq!(
            (after.film_share, after.flash_k),
            (before.film_share, before.flash_k)
        );
    }
    for (before, after) in plain.offsets.iter().zip(&banded.offsets) {
        assert!(is_scaled(after.loss_w, before.loss_w));
    }
    let tags: Vec<&str> = banded.result.equations.iter().map(|e| &*e.tag).collect();
    for tag in [
        "Latin-hypercube",
        "Predictive-draw",
        "Quadratic-surface",
        "Sampling-error",
    ] {
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
    let (case, found) = e_drive();
    // Another model is evaluated by the contacts of the run; alone it solves its own.
    let halved = Some(Alternative::AsperityShareTimes(0.5));
    let other = case.overridden(|over| over.alternative = halved).unwrap();
    let alone = Run::new(&other)
        .pictures(KEPT)
        .execute()
        .unwrap()
        .into_only()
        .unwrap();
    let row = found
        .other_models
        .iter()
        .find(|row| row.name.contains("halved"));
    let of_run = row.unwrap().loss_w.unwrap() / found.to_median();
    assert!((of_run / alone.result.summary.loss_w - 1.0).abs() < 1e-12);
}

#[test]
fn the_draws_over_the_boundary_share_of_inner_spots_are_runs_with_that_share() {
    let (case, found) = e_drive();
    for share in ["0.6", "0.75", "0.9"] {
        let other = case.with_key("model.inner_boundary", share).unwrap();
        let run = asperity_tests::losses(&other).unwrap().summary.loss_w;
        let mut rows = found.structures.iter();
        let row = rows.find(|row| row.name.ends_with(share));
        let drawn = row.unwrap().loss_w.unwrap() / found.to_median();
        assert!((drawn / run - 1.0).abs() < 0.015, "{share}: {drawn} {run}");
    }
}

#[test]
fn the_median_of_the_draws_is_the_run_with_stated_relief() {
    let files = [
        "e-drive.toml",
        "e-drive-superfinished.toml",
        "fzg-c.toml",
        "table2.toml",
    ];
    for file in files {
        let found = uncertainty(&case(file));
        assert!(found.roughness_over_film.unwrap() < 3.0);
        // 0.5 % at most with all positions and offsets.
        let off = found.to_median() - 1.0;
        assert!(off.abs() < 0.01, "{file}: {off}");
    }
}

#[test]
fn a_lay_beyond_the_records_is_named_and_reaches_down_to_a_confirmed_lay() {
    let with = |lay: &str| case("e-drive.toml").with_key("model.lay", lay).unwrap();
    let found = |case: &LoadedCase| {
        let outcome = Run::new(case).pictures(KEPT).interval(true).execute();
        outcome.unwrap().into_only().unwrap().result
    };
    let is_far = |warnings: &[asperity::message::Warning]| {
        warnings.iter().any(|warning| warning.code == "W452")
    };
    let far_part = |result: &RunResult| {
        let parts = &result.uncertainty.as_ref().unwrap().loss.parts;
        let mut parts = parts.iter();
        parts.find(|part| part.name == "lay above 1/3").cloned()
    };
    let recorded = found(&with("0.33"));
    assert!(!is_far(&recorded.warnings) && far_part(&recorded).is_none());
    let far = with("0.6");
    assert!(is_far(&asperity::Run::new(&far).check().unwrap()));
    let result = found(&far);
    let shown = asperity_report::brief(&result, 80, 10);
    assert!(
        shown.contains("W452") && shown.contains("(effect on loss: "),
        "{shown}"
    );
    let confirmed = asperity_tests::losses(&with("0.166666666666667")).unwrap();
    let of_run = result.summary.loss_at_medians_w.unwrap();
    let [low, high] = [confirmed.summary.loss_w, of_run];
    let to_median = result.summary.loss_w / of_run;
    // Scaled to the median of the draws: a twentieth of the way from either end.
    let ends = far_part(&result).unwrap().quantiles_w;
    for (end, part) in ends.into_iter().zip([0.05, 0.95]) {
        let expected = to_median * (low + part * (high - low));
        assert!((end / expected - 1.0).abs() < 5e-3, "{end} {expected}");
    }
}

#[test]
fn a_draw_is_a_run_with_its_constants() {
    let (case, found) = e_drive();
    assert!(
        found.interpolation_error < 0.02,
        "{}",
        found.interpolation_error
    );
    let friction = found
        .constants
        .iter()
        .find(|one| one.name == "boundary friction")
        .unwrap();
    let part = found
        .loss
        .parts
        .iter()
        .find(|part| part.name == "boundary friction")
        .unwrap();
    // The loss rises with the friction, so that the quantiles of one are those of the other.
    for (value, drawn) in [
        (friction.drawn().low, part.quantiles_w[0]),
        (friction.drawn().high, part.quantiles_w[1]),
    ] {
        let other = case
            .with_key("model.boundary_friction", &value.to_string())
            .unwrap();
        let run = asperity_tests::losses(&other).unwrap().summary.loss_w;
        let drawn = drawn / found.to_median();
        assert!((drawn / run - 1.0).abs() < 0.02, "{value}: {drawn} {run}");
    }
}

#[test]
fn identical_finishes_differ_by_exactly_nothing() {
    let case = case("e-drive.toml");
    let (found, _) = between(&case, &case);
    assert_eq!((found.at_medians_w, found.watts.value), (0.0, 0.0));
    assert_eq!(
        (found.watts.ends(), found.share.ends()),
        ([0.0; 2], [0.0; 2])
    );
    assert_eq!(found.verdict, Verdict::Equal);
}

#[test]
fn finishes_differ_less_than_each_is_uncertain() {
    let [ground, polished] = ["e-drive.toml", "e-drive-superfinished.toml"].map(case);
    let (found, drawn) = between(&ground, &polished);
    assert!(
        found.watts.value < 0.0 && found.watts.high < 0.0,
        "{found:?}"
    );
    let width = |[low, high]: [f64; 2]| high - low;
    // The draws are the same, so what both finishes share cancels.
    let each = drawn.map(|uncertainty| width(uncertainty.loss.drawn().ends()));
    assert!(
        width(found.watts.ends()) < each[0].hypot(each[1]),
        "{found:?} {each:?}"
    );
    assert_eq!(found.verdict, Verdict::Holds);
    assert!(found.models.len() >= 7, "{:?}", found.models);
}

#[test]
fn what_the_case_states_is_not_drawn() {
    let (case, all) = e_drive();
    let names = |found: &Uncertainty| -> Vec<String> {
        found.constants.iter().map(|one| one.name.clone()).collect()
    };
    let every = [
        "boundary friction",
        "boundary layer",
        "lay",
        "limiting shear",
        "Eyring stress",
        "pressure-viscosity",
    ];
    assert_eq!(names(all), every);
    let stated = case.with_key("model.boundary_friction", "0.09").unwrap();
    let stated = uncertainty(&stated);
    assert_eq!(names(&stated), every[1..]);
    assert_eq!(stated.held, ["boundary friction"]);
    // The same draws of the others, so the spread is smaller and the run the same.
    assert_eq!(stated.at_medians_w, all.at_medians_w);
    assert!(stated.loss.sd_ln < all.loss.sd_ln);
}

#[test]
fn every_component_widens_the_loss_and_none_exceeds_all() {
    let (case, stated) = e_drive();
    assert!(
        stated
            .loss
            .parts
            .iter()
            .all(|part| part.name != "tip relief not stated")
    );
    let unstated = case.with(|input| (input.gears.pinion, input.gears.wheel) = (None, None));
    let found = uncertainty(&unstated.unwrap());
    let names: Vec<&str> = found
        .loss
        .parts
        .iter()
        .map(|part| part.name.as_str())
        .collect();
    for name in [
        "tip relief not stated",
        "sampling of the flanks",
        "error of the model",
        "rolling loss",
    ] {
        assert!(names.contains(&name), "{names:?}");
    }
    assert!(
        found
            .loss
            .parts
            .iter()
            .all(|part| part.sd_ln < found.loss.sd_ln && !part.remedy.is_empty())
    );
    assert!(
        found
            .loss
            .parts
            .is_sorted_by(|a, b| a.half_range_w() >= b.half_range_w())
    );
    assert!(stated.loss.sd_ln < found.loss.sd_ln);
    // Half of the approach of the teeth lowers the loss.
    assert!(
        found.at_medians_w < 0.97 * stated.at_medians_w,
        "{}",
        found.at_medians_w
    );
}

/// The load over the teeth with another relief than the case has.
#[derive(Debug)]
struct RelievedLoad(LoadInputs);

impl LoadDistribution for RelievedLoad {
    fn name(&self) -> &str {
        "with another relief"
    }

    fn load_map(&self, _: &LoadConditions<'_>) -> Result<LoadMap, GearError> {
        self.0.load_map()
    }
}

#[test]
fn the_factor_of_a_relief_is_that_of_a_run_with_it() {
    let unstated = case("e-drive.toml").with(|input| {
        (input.gears.pinion, input.gears.wheel) = (None, None);
        (input.model.positions, input.model.offsets) = (Some(16), Some(16));
    });
    let unstated = unstated.unwrap();
    let assumed = unstated.case.assumed_relief.clone().unwrap();
    let loss = |c: f64| {
        let own = RelievedLoad(assumed.under(&unstated.case.load_inputs(), c, 0.75));
        let other = unstated.with_laws(|laws| laws.load_distribution = Some(Arc::new(own)));
        asperity_tests::losses(&other).unwrap().summary.loss_w
    };
    let outcome = Run::new(&unstated).pictures(KEPT).interval(true).execute();
    let first = &outcome.unwrap().into_only().unwrap().result.warnings[0];
    assert_eq!(first.code, "W439");
    // "... The loss changes by -15 % with 10 um, and by +19 % without relief, ..."
    let words = first.text.split(' ');
    let percents: Vec<f64> = words
        .filter(|word| word.starts_with(['+', '-']))
        .map(|word| word.parse().unwrap())
        .collect();
    for (c, percent) in [1.0, 0.0].into_iter().zip(&percents) {
        let run = loss(c) / loss(0.5);
        let drawn = 1.0 + 0.01 * percent;
        assert!((drawn / run - 1.0).abs() < 0.04, "{c}: {drawn} {run}");
    }
    assert_eq!(percents.len(), 2);
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
    let result = Run::new(&case)
        .pictures(KEPT)
        .interval(true)
        .execute()
        .unwrap()
        .into_only()
        .unwrap()
        .result;
    let found = result.uncertainty.as_ref().unwrap();
    assert_eq!(found.trust, Trust::Surrogates);
    assert!(
        found
            .loss
            .parts
            .iter()
            .any(|part| part.name == "sampling of the flanks")
    );
    let text = asperity_report::summary(&result);
    assert!(text.contains("surrogate"), "{text}");
}

#[test]
fn the_paper_has_no_band() {
    let file = Path::new(env!("CARGO_MANIFEST_DIR")).join("../fixtures/cases/e-drive.toml");
    let case = load_with(&file, &|input| {
        input.formulation = Some(asperity_paper_2022::register());
    })
    .unwrap();
    let outcome = Run::new(&case)
        .pictures(KEPT)
        .interval(true)
        .execute()
        .unwrap()
        .into_only()
        .unwrap();
    assert!(outcome.result.uncertainty.is_none());
}

/// A rig's calibration: the defaults with narrow bands, boundary friction and layer correlated.
const CALIBRATION: &str = r#"
[calibration]
source = "made up for a test"
boundary_friction = { value = 0.09, low = 0.084, high = 0.097 }
boundary_layer = { value = "10 nm", low = "8 nm", high = "13 nm" }
limiting_shear = { value = 0.035, low = 0.034, high = 0.036 }
eyring_stress = { value = "4.06 MPa", low = "3.8 MPa", high = "4.3 MPa" }
correlations = [{ between = ["boundary_layer", "boundary_friction"], value = -0.8 }]
"#;

/// The run of the e-drive with it.
fn calibrated() -> &'static RunResult {
    static RUN: OnceLock<RunResult> = OnceLock::new();
    RUN.get_or_init(|| {
        let given: asperity::case::CalibrationInput = {
            let table: toml::Table = CALIBRATION.parse().unwrap();
            table["calibration"].clone().try_into().unwrap()
        };
        let given = &given;
        let case = case("e-drive.toml")
            .with(|input| input.calibration = Some(given.clone()))
            .unwrap();
        let outcome = Run::new(&case).pictures(KEPT).interval(true).execute();
        outcome.unwrap().into_only().unwrap().result
    })
}

#[test]
fn a_calibrated_case_has_the_same_loss_and_smaller_parts() {
    let (plain, narrow) = (&e_drive().1, calibrated().uncertainty.as_ref().unwrap());
    // The values are the defaults.
    assert_eq!(
        Some(plain.at_medians_w),
        calibrated().summary.loss_at_medians_w
    );
    for name in [
        "boundary friction",
        "boundary layer",
        "limiting shear",
        "Eyring stress",
    ] {
        let sd = |found: &Uncertainty| {
            found
                .loss
                .parts
                .iter()
                .find(|part| part.name == name)
                .map_or(0.0, |part| part.sd_ln)
        };
        assert!(
            sd(narrow) < 0.6 * sd(plain),
            "{name}: {} {}",
            sd(narrow),
            sd(plain)
        );
    }
    let names: Vec<(&str, bool)> = narrow
        .constants
        .iter()
        .map(|one| (one.name.as_str(), one.is_calibrated))
        .collect();
    assert!(names.contains(&("boundary friction", true)) && names.contains(&("lay", false)));
    assert!(plain.constants.iter().all(|one| !one.is_calibrated));
}

#[test]
fn constants_of_a_calibrated_case_are_told_with_their_source() {
    let constants = &calibrated().film_constants;
    for name in [
        FilmConstantName::BoundaryFriction,
        FilmConstantName::BoundaryLayer,
        FilmConstantName::LimitingShear,
        FilmConstantName::EyringStress,
    ] {
        let found: Vec<_> = constants.iter().filter(|one| one.name == name).collect();
        assert_eq!(found.len(), 1, "{name:?}");
        assert_eq!(found[0].constant.source, "made up for a test");
    }
}
