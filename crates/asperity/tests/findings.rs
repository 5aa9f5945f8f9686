//! Findings about a case have codes, and a check lists those that need no solution.

#![allow(clippy::unwrap_used, reason = "helpers of tests fail as tests do")]

use std::collections::BTreeSet;
use std::path::Path;

use crate::runs::losses;
use asperity::case::{CaseInput, LoadedCase, load_with};
use asperity::message::Warning;

/// Codes of the findings that follow from the solved contacts, and those of friction among the ranges.
const OF_A_SOLUTION: [&str; 13] = [
    "W401", "W402", "W403", "W406", "W409", "W410", "W411", "W413", "W414", "W415", "W416", "W443",
    "W451",
];

fn case(change: &dyn Fn(&mut CaseInput)) -> LoadedCase {
    let few = |input: &mut CaseInput| {
        input.set("model.positions", "3").unwrap();
        input.set("model.offsets", "2").unwrap();
        change(input);
    };
    load_with(Path::new("../../fixtures/cases/e-drive.toml"), &few).unwrap()
}

fn with_keys(keys: &'static [(&str, &str)]) -> LoadedCase {
    case(&|input| {
        for (key, value) in keys {
            input.set(key, value).unwrap();
        }
    })
}

fn codes(found: &[Warning]) -> BTreeSet<&str> {
    found.iter().map(|warning| warning.code.as_str()).collect()
}

#[test]
fn a_check_has_every_finding_that_needs_no_solution() {
    let values = r#"{ pinion = { ra = "0.3 um" }, wheel = { ra = "0.3 um" } }"#;
    let of_values = case(&|input| {
        input.set("surface", values).unwrap();
        input.set("model.load_share", "lambda-star").unwrap();
    });
    let unrelieved = case(&|input| {
        input.gears.pinion = None;
        input.gears.wheel = None;
    });
    let cases = [
        (with_keys(&[]), None),
        (of_values, Some("W408")),
        (unrelieved, Some("W439")),
        (
            with_keys(&[("operation.bulk_temperature", "178 °C")]),
            Some("W401"),
        ),
        (with_keys(&[("micropitting", "{}")]), Some("W432")),
        (
            with_keys(&[(
                "gearbox",
                r#"{ seals = [{ shaft = "pinion", diameter = "280 mm" }] }"#,
            )]),
            Some("W401"),
        ),
        (
            with_keys(&[("surface.pinion.range", "1 mm .. 2.4 mm")]),
            Some("W407"),
        ),
        (with_keys(&[("operation.torque", "900 N m")]), Some("W405")),
    ];
    for (case, expected) in cases {
        let checked = [
            case.warnings.clone(),
            asperity::Run::new(&case).check().unwrap(),
        ]
        .concat();
        let solved = losses(&case).unwrap().warnings;
        let (checked, solved) = (codes(&checked), codes(&solved));
        assert!(
            expected.is_none_or(|code| checked.contains(code)),
            "{expected:?}: {checked:?}"
        );
        assert!(checked.is_subset(&solved), "{checked:?} {solved:?}");
        let left: Vec<_> = solved.difference(&checked).collect();
        let of_a_solution = left.iter().all(|code| OF_A_SOLUTION.contains(code));
        assert!(of_a_solution, "{expected:?}: {left:?} need no solution");
    }
}

#[test]
fn the_film_of_cold_oil_is_named_by_a_check_as_by_a_run() {
    let case = with_keys(&[("operation.bulk_temperature", "-29 °C")]);
    let of_films = |found: Vec<Warning>| -> BTreeSet<String> {
        let texts = found.into_iter().map(|warning| warning.text);
        texts.filter(|text| text.contains("Gupta")).collect()
    };
    let checked = of_films(asperity::Run::new(&case).check().unwrap());
    assert!(!checked.is_empty());
    assert_eq!(checked, of_films(losses(&case).unwrap().warnings));
}
