//! Overrides of a case whose bulk temperature follows from its loss.

use std::path::Path;

use super::{Options, contacts, losses_at, settled};
use crate::pipeline::losses;
use crate::result::Losses;
use crate::uncertainty::range;
use asperity_case::case::{LoadedCase, UncertainParameter, load_with};
use asperity_core::quantity::Temperature;

/// The e-drive with few windows, whose temperature has an error, and follows from the loss.
fn warmed_e_drive() -> LoadedCase {
    let case = load_with(Path::new("../../fixtures/cases/e-drive.toml"), &|input| {
        (input.model.positions, input.model.offsets) = (Some(4), Some(2));
        let _ = input.set("operation.temperature_deviation", "3 K");
    });
    let case = case.unwrap().with(|input| {
        input.set("operation.oil_temperature", "80 °C").unwrap();
        let law = r#"{ law = "iso", lubrication = "jet" }"#;
        input.set("operation.bulk", law).unwrap();
    });
    case.unwrap()
}

#[test]
fn an_override_acts_where_the_temperature_follows_from_the_loss() {
    let case = warmed_e_drive();
    let tables = contacts(&case, &[]).unwrap();
    let warm = settled(&case, &Options::known(&tables)).unwrap();
    let stated = case.at_stated().unwrap();
    let upper = |kind| Some((kind, range(kind, &stated).unwrap()?.high));
    for (kind, value) in UncertainParameter::ALL.into_iter().filter_map(upper) {
        let drawn = warm.overridden(|over| over.set(kind, value)).unwrap();
        let at = losses_at(&tables, &drawn).unwrap().summary.loss_w;
        let own = losses_at(&tables, &warm).unwrap().summary.loss_w;
        assert!((at / own - 1.0).abs() > 1e-6, "{kind:?}");
        let shift = drawn.temperature().si() - warm.temperature().si();
        let expected = match kind {
            UncertainParameter::TemperatureError => value,
            _ => 0.0,
        };
        assert!((shift - expected).abs() < 1e-9, "{kind:?} {shift}");
    }
    // At a temperature that is given the case has the loss that it has at that which is found.
    let given = case.at(warm.temperature()).unwrap();
    let [given, found] = [&given, &warm].map(|case| losses_at(&tables, case).unwrap().summary);
    assert_eq!(given, found);
}

#[test]
fn a_search_for_the_bulk_temperature_leaves_no_equation_in_the_case() {
    let case = warmed_e_drive();
    let tables = contacts(&case, &[]).unwrap();
    let is_named = |found: Losses| {
        let mut equations = found.equations.iter();
        equations.any(|used| used.tag == "Bulk-fixed-point")
    };
    assert!(is_named(losses(&case).unwrap()));
    let given = case.at(Temperature::from_celsius(100.0)).unwrap();
    assert!(!is_named(losses_at(&tables, &given).unwrap()));
}
