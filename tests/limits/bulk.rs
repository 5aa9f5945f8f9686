//! The bulk temperature that the loss keeps up: its balance, its words, its refusals.

use std::path::Path;
use std::sync::Arc;
use std::sync::atomic::{AtomicUsize, Ordering};

use asperity::Run;
use asperity::case::{CaseInput, LoadedCase, load_with};
use asperity::core::Checked;
use asperity::oil::ViscosityLaw;
use asperity::pipeline::Kept;
use asperity::quantity::Temperature;
use asperity::tribo_friction::{FilmContact, FilmFriction, FilmTraction, FrictionError};
use asperity::uncertainty::{UncertainParameter, range};
use asperity_tests::losses;

fn case(name: &str, law: &str) -> LoadedCase {
    let file = Path::new(env!("CARGO_MANIFEST_DIR"))
        .join("../fixtures/cases")
        .join(name);
    let case = load_with(&file, &|input| {
        (input.model.positions, input.model.offsets) = (Some(4), Some(2));
    })
    .unwrap();
    with_law(&case, law)
}

/// The case with the temperature that it states as that of the oil.
fn with_law(case: &LoadedCase, law: &str) -> LoadedCase {
    let with_law = |input: &mut CaseInput| {
        let operation = &mut input.operation;
        operation.oil_temperature = operation.stated_temperature();
        operation.bulk_temperature = None;
        input.set("operation.bulk", law).unwrap();
    };
    case.with(with_law).unwrap()
}

fn celsius(temperature: Temperature) -> f64 {
    temperature.si() - 273.15
}

#[test]
fn the_rise_is_that_of_the_loss_at_the_temperature_found() {
    for (lubrication, factor) in [("jet", 1.2), ("dip", 1.0), ("submerged", 0.2)] {
        let law = format!("{{ law = \"iso\", lubrication = \"{lubrication}\" }}");
        let case = case("e-drive.toml", &law);
        let found = losses(&case).unwrap();
        let report = found.bulk.as_ref().unwrap();
        let gears = &case.case.gears;
        let specific = 1e-3 * found.summary.loss_w
            / (1e6 * gears.centre_distance.si() * gears.face_width.si());
        let rise = 7400.0 * specific.powf(0.72) * factor / 1.2;
        let residual = report.bulk_c - report.oil_c - rise;
        assert!(residual.abs() < 0.01, "{lubrication}: {residual} K");
        let oil = case.case.input.operation.oil_temperature.unwrap();
        assert_eq!(report.oil_c, celsius(oil));
        // The loss is that of flanks given at this temperature.
        let settled = Run::new(&case).operating_case().unwrap();
        let given = case
            .with(|input| input.operation.set_bulk_temperature(settled.temperature()))
            .unwrap();
        let given = losses(&given).unwrap();
        assert_eq!(given.summary, found.summary);
        assert!(given.bulk.is_none());
    }
}

/// A friction coefficient of 0.03, which counts how often it is computed.
#[derive(Debug, Default)]
struct Counting(AtomicUsize);

impl FilmFriction for Counting {
    fn name(&self) -> &str {
        "counting"
    }

    fn traction(&self, _: &FilmContact<'_>) -> Result<Checked<FilmTraction>, FrictionError> {
        self.0.fetch_add(1, Ordering::Relaxed);
        Ok(Checked::inside(FilmTraction::from_coefficient(0.03)))
    }
}

#[test]
fn a_hotter_equilibrium_can_be_left_aside_on_each_way_to_a_result() {
    let case = case("e-drive.toml", r#"{ law = "iso", lubrication = "dip" }"#);
    let ways: [&dyn Fn(Run<'_>) -> f64; 3] = [
        &|run| run.operating_case().unwrap().temperature().si(),
        &|run| run.losses().unwrap().into_only().unwrap().summary.loss_w,
        &|run| {
            let found = run.pictures(Kept::NoPictures).execute().unwrap();
            found.into_only().unwrap().result.summary.loss_w
        },
    ];
    for way in ways {
        let counted = |of: fn(Run<'_>) -> Run<'_>| {
            let law = Arc::new(Counting::default());
            let case = case.with_laws(|laws| laws.friction = Some(law.clone()));
            (way(of(Run::new(&case))), law.0.load(Ordering::Relaxed))
        };
        let ((alone, fewer), (beside, more)) = (counted(|run| run.coldest()), counted(|run| run));
        assert_eq!(alone, beside);
        assert!(fewer > 0 && fewer < more, "{fewer} {more}");
    }
}

#[test]
fn two_gears_shed_the_heat_that_the_mesh_makes() {
    let law = r#"{ law = "network", pinion_to_oil = "12 W/K", wheel_to_oil = "18 W/K", between = "3 W/K" }"#;
    let case = case("e-drive.toml", law);
    let found = losses(&case).unwrap();
    let report = found.bulk.unwrap();
    let [pinion, wheel] = report.gears_c.unwrap().map(|t| t - report.oil_c);
    let shed = 12.0 * pinion + 18.0 * wheel;
    // Both gears follow within the 0.01 K of the fixed point.
    assert!((shed - found.summary.loss_w).abs() < 0.5, "{shed} W");
    let mean = 0.5 * (pinion + wheel) + report.oil_c;
    assert!((mean - report.bulk_c).abs() < 1e-9);
    // The pinion's flank slides past faster below the pitch point, slower above: near a half in all.
    let share = report.pinion_heat_share.unwrap();
    assert!((0.45..0.55).contains(&share), "{share}");
}

#[test]
fn a_run_tells_the_oil_it_was_given_and_the_flanks_it_found() {
    let case = case("e-drive.toml", r#"{ law = "iso", lubrication = "jet" }"#);
    let run = Run::new(&case)
        .execute()
        .unwrap()
        .into_only()
        .unwrap()
        .result;
    let report = run.bulk.unwrap();
    assert_eq!(run.inputs, case.case.input);
    let at_bulk = case
        .case
        .lubricant
        .at(Temperature::from_si(report.bulk_c + 273.15))
        .unwrap();
    let ratio = run.lubricant.dynamic_viscosity / at_bulk.value.dynamic_viscosity;
    assert!((ratio - 1.0).abs() < 1e-9);
    for tag in ["Bulk-iso", "Bulk-fixed-point"] {
        assert!(run.equations.iter().any(|used| used.tag == tag), "{tag}");
    }
}

/// Gate T2's case: a viscosity given at the temperature of the operation.
fn given_viscosity() -> LoadedCase {
    let file =
        Path::new(env!("CARGO_MANIFEST_DIR")).join("../fixtures/measured/petry-johnson.toml");
    load_with(&file, &|input| {
        (input.model.positions, input.model.offsets) = (Some(4), Some(1));
    })
    .unwrap()
}

#[test]
fn a_viscosity_given_without_a_temperature_thins_as_the_flanks_warm() {
    let law = r#"{ law = "iso", lubrication = "jet" }"#;
    let case = given_viscosity();
    let tables = asperity_tests::contacts(&case).unwrap();
    let loss = |case: &LoadedCase| {
        let found = asperity_tests::losses_with(&tables, case).unwrap();
        found.summary.loss_w
    };
    let warm = with_law(&case, law);
    let stated = case
        .with(|input| {
            input.lubricant = input
                .lubricant
                .stated_at(case.case.stated_temperature)
                .unwrap()
        })
        .unwrap();
    let stated_warm = with_law(&stated, law);
    let (hot, cold) = (loss(&warm), loss(&case));
    assert_eq!(hot, loss(&stated_warm));
    assert!(hot < 0.98 * cold, "{hot} {cold}");
    // The result states the oil as the case does.
    let run = Run::new(&warm).pictures(Kept::NoPictures).execute();
    assert_eq!(
        run.unwrap().into_only().unwrap().result.inputs,
        warm.case.input
    );
}

#[test]
fn a_given_viscosity_belongs_to_the_temperature_that_the_case_states() {
    let case = given_viscosity();
    let viscosity = |case: &LoadedCase| case.at_stated().unwrap().oil().dynamic_viscosity.si();
    let hot_flanks = |input: &mut CaseInput| {
        let hot = Temperature::from_celsius(120.0);
        input.operation.set_temperature(hot);
    };
    // By a key, by a value, and past the text of the file: 10 K at 0.04 1/K.
    let file =
        Path::new(env!("CARGO_MANIFEST_DIR")).join("../fixtures/measured/petry-johnson.toml");
    let key = ("operation.bulk_temperature".to_owned(), "120 °C".to_owned());
    let source = asperity::case::open_source(&file).unwrap();
    let hotter = [
        case.with_key(&key.0, &key.1).unwrap(),
        case.with(hot_flanks).unwrap(),
        load_with(&file, &hot_flanks).unwrap(),
        asperity::case::load_set(source, file.parent().unwrap(), &[key], &|_| {}).unwrap(),
    ];
    for hot in &hotter {
        let ratio = viscosity(hot) / viscosity(&case);
        assert!((ratio - (-0.4f64).exp()).abs() < 1e-12, "{ratio}");
        // What the result states is the same case again.
        let again = LoadedCase::try_from(hot.case.input.clone()).unwrap();
        assert_eq!(viscosity(&again), viscosity(hot));
    }
    // And back.
    let back = hotter[0]
        .with_key("operation.bulk_temperature", "110 °C")
        .unwrap();
    assert_eq!(viscosity(&back), viscosity(&case));
    // A viscosity stated together with the temperature holds at it.
    let other = case
        .with(|input| {
            hot_flanks(input);
            input.lubricant.viscosity = Some(ViscosityLaw::Given {
                dynamic_viscosity: "8 mPa s".parse().unwrap(),
                temperature: None,
            });
        })
        .unwrap();
    assert!((viscosity(&other) - 8e-3).abs() < 1e-18);
}

#[test]
fn tables_made_before_give_the_same_temperature() {
    let case = case("e-drive.toml", r#"{ law = "iso", lubrication = "dip" }"#);
    let tables = asperity_tests::contacts(&case).unwrap();
    let kept = asperity_tests::losses_with(&tables, &case).unwrap();
    let anew = losses(&case).unwrap();
    assert_eq!(kept.bulk, anew.bulk);
    assert_eq!(kept.summary, anew.summary);
}

#[test]
fn parameters_set_past_the_keys_act_at_the_temperature_found() {
    let case = case("e-drive.toml", r#"{ law = "iso", lubrication = "jet" }"#);
    let tables = asperity_tests::contacts(&case).unwrap();
    let loss = |parameter: UncertainParameter, factor: f64| {
        let value = range(parameter, &case.at_stated().unwrap())
            .unwrap()
            .unwrap()
            .value;
        let changed = case
            .overridden(|over| over.set(parameter, factor * value))
            .unwrap();
        let found = asperity_tests::losses_with(&tables, &changed).unwrap();
        found.summary.loss_w
    };
    for parameter in [
        UncertainParameter::BoundaryFriction,
        UncertainParameter::BoundaryLayer,
        UncertainParameter::LimitingShear,
        UncertainParameter::EyringStress,
        UncertainParameter::PressureViscosity,
    ] {
        let [less, more] = [0.8, 1.25].map(|factor| loss(parameter, factor));
        assert!(more > 1.0001 * less, "{}: {less} {more}", parameter.name());
    }
}

#[test]
fn a_key_of_the_temperature_replaces_the_others() {
    let file = Path::new(env!("CARGO_MANIFEST_DIR")).join("../fixtures/cases/e-drive.toml");
    let mut input = load_with(&file, &|_| {}).unwrap().case.input.clone();
    let law = r#"{ law = "iso", lubrication = "dip" }"#;
    input.set("operation.bulk", law).unwrap();
    input.set("operation.oil_temperature", "80 °C").unwrap();
    let operation = &input.operation;
    assert!(operation.bulk_temperature.is_none() && operation.bulk.is_some());
    input
        .set("operation.bulk_temperature", r#"["80 °C", "100 °C"]"#)
        .unwrap();
    let operation = &input.operation;
    assert!(operation.oil_temperature.is_none() && operation.bulk.is_none());
}

#[test]
fn film_and_friction_take_the_mean_of_two_flanks() {
    let file = Path::new(env!("CARGO_MANIFEST_DIR")).join("../fixtures/cases/e-drive.toml");
    let case = load_with(&file, &|input| {
        (input.model.positions, input.model.offsets) = (Some(4), Some(2));
    })
    .unwrap();
    let two = case
        .with_key("operation.bulk_temperature", r#"["80 °C", "100 °C"]"#)
        .unwrap();
    let [one, two_flanks] = [&case, &two].map(|case| losses(case).unwrap().summary.loss_w);
    assert!((two_flanks / one - 1.0).abs() < 1e-12, "{one} {two_flanks}");
    // At another mean the flanks keep their difference.
    let hotter = two
        .with(|input| {
            input
                .operation
                .set_temperature(Temperature::from_celsius(110.0))
        })
        .unwrap();
    let flanks = hotter.case.input.operation.bulk_temperature.unwrap().both();
    for (flank, expected) in flanks.into_iter().zip([100.0, 120.0]) {
        assert!((celsius(flank) - expected).abs() < 1e-9);
    }
    assert!((celsius(hotter.case.stated_temperature) - 110.0).abs() < 1e-9);
}

#[test]
fn the_oil_is_warned_of_at_the_temperature_found_and_not_at_the_one_stated() {
    let law = r#"{ law = "iso", lubrication = "jet" }"#;
    let case = case("e-drive.toml", law).with(|input| {
        let thin = r#"{ law = "astm-d341", at_40 = "5 mm2/s", at_100 = "1.3 mm2/s" }"#;
        input.set("lubricant.viscosity", thin).unwrap();
    });
    let case = case.unwrap();
    let is_of_oil = |warning: &asperity::message::Warning| warning.text.contains("Pa s there");
    assert!(!case.warnings.iter().any(is_of_oil), "{:?}", case.warnings);
    let found = losses(&case).unwrap();
    assert!(found.bulk.unwrap().bulk_c > 100.0);
    let said: Vec<_> = found.warnings.iter().filter(|one| is_of_oil(one)).collect();
    assert!(said.len() == 1 && said[0].code == "W201", "{said:?}");
}
