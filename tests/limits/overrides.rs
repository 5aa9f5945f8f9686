//! What a draw varies beside the keys of a case holds at every other temperature, load and key.

use std::path::Path;

use asperity::case::{Alternative, LoadShareName, LoadedCase, UncertainParameter, load_with};
use asperity::uncertainty::range;
use asperity_core::quantity::Temperature;
use asperity_studies::compare::Finish;
use asperity_studies::map::{Axes, MapBand, map};
use asperity_tests::{contacts, losses_with};

/// The e-drive with few windows, whose temperature has an error, so that every constant acts but those of an oil file.
fn e_drive() -> LoadedCase {
    let file = Path::new(env!("CARGO_MANIFEST_DIR")).join("../fixtures/cases/e-drive.toml");
    load_with(&file, &|input| {
        (input.model.positions, input.model.offsets) = (Some(4), Some(2));
        let _ = input.set("operation.temperature_deviation", "3 K");
    })
    .unwrap()
}

/// Every constant that acts on the case, at its upper end.
fn overridden(case: &LoadedCase) -> Vec<(UncertainParameter, f64)> {
    let stated = case.at_stated().unwrap();
    let acting = UncertainParameter::ALL.into_iter();
    let upper = acting.filter_map(|kind| Some((kind, range(kind, &stated).unwrap()?.high)));
    upper.collect()
}

fn loss(case: &LoadedCase) -> f64 {
    asperity_tests::losses(case).unwrap().summary.loss_w
}

#[test]
fn an_override_holds_at_every_other_temperature_load_and_key() {
    let case = e_drive();
    let found = overridden(&case);
    assert!(found.len() >= 6, "{found:?}");
    let keys = [
        ("operation.bulk_temperature", "60 °C"),
        ("operation.torque", "100 N m"),
        ("operation.speed", "4000 1/min"),
        ("gears.face_width", "30 mm"),
    ];
    for (kind, value) in found {
        let other = case.overridden(|over| over.set(kind, value)).unwrap();
        assert_ne!(case.fingerprint(), other.fingerprint(), "{kind:?}");
        for (key, text) in keys {
            let [own, changed] = [&case, &other].map(|case| case.with_key(key, text).unwrap());
            assert_eq!(changed.case.overrides.get(kind), Some(value));
            let [own, changed] = [own, changed].map(|case| loss(&case));
            assert!((changed / own - 1.0).abs() > 1e-6, "{kind:?} {key}: {own}");
        }
        // What is taken back leaves nothing.
        let back = other.overridden(|over| *over = Default::default()).unwrap();
        assert_eq!(loss(&back), loss(&case));
    }
}

#[test]
fn a_map_of_an_overridden_case_has_its_losses() {
    let case = e_drive();
    let dry = Some(Alternative::LoadShare(LoadShareName::ZhuHu));
    let other = case.overridden(|over| {
        over.alternative = dry;
        over.set(UncertainParameter::BoundaryFriction, 0.12);
    });
    let other = other.unwrap();
    let axes = Axes::new(&[0.0, 100.0, 145.0], &[0.0, 4000.0, 9000.0], &[70.0]).unwrap();
    let finish = Finish {
        name: "overridden".to_owned(),
        case: other.clone(),
    };
    let found = map(&[finish], &axes, MapBand::None, &|_, _| {}).unwrap();
    let point = other.with(|input| {
        input.operation.torque = "100 N m".parse().unwrap();
        input.operation.speed = "4000 1/min".parse().unwrap();
        input
            .operation
            .set_temperature(Temperature::from_celsius(70.0));
    });
    let expected = loss(&point.unwrap());
    let points = &found.finishes[0].points;
    let place = |point: &&asperity_studies::map::Point| {
        point.torque_nm == 100.0 && point.speed_rpm == 4000.0
    };
    let seen = points.iter().find(place).unwrap().numbers.unwrap().loss_w;
    assert!((seen / expected - 1.0).abs() < 1e-12, "{seen} {expected}");
    let tables = contacts(&case).unwrap();
    assert_ne!(
        losses_with(&tables, &other).unwrap().summary.loss_w,
        loss(&case)
    );
}
