//! Property of every parser, whatever it is given: it returns a value without fault, or refuses with a code.
//!
//! The fuzz targets in `fuzz/` and their deterministic twins in `tests/cli/mutated.rs` call the same functions.

use asperity::case::{self, Source, planetary};
use asperity::message::explain;
use asperity::result::RunResult;
use asperity_core::quantity::{
    Angle, AngularSpeed, Density, DynamicViscosity, KinematicViscosity, Length, LineLoad,
    PerKelvin, Pressure, PressureViscosity, Quantity, Speed, Temperature, Torque,
};
use asperity_report::{PageTables, html};

/// A trace for every file that a case names.
fn trace() -> Vec<u8> {
    let wave = |i: i32| format!("{:.4}\n", (f64::from(i) * 0.7).sin());
    (0..2500).map(wave).collect::<String>().into_bytes()
}

/// Every quantity reads a text to a finite value that is printed and read again to itself, or refuses it.
///
/// # Panics
/// When it does neither.
pub fn units(text: &str) -> bool {
    fn same<Q: Quantity + std::str::FromStr + std::fmt::Display>(text: &str) -> bool {
        let Ok(read) = text.parse::<Q>() else {
            return false;
        };
        assert!(read.si().is_finite(), "{text:?} is {}", read.si());
        let printed = read.to_string();
        let again = printed.parse::<Q>().ok();
        let off = again.map(|again| (again.si() - read.si()).abs());
        // A degree Celsius is printed from kelvins.
        let rounding = 1e-12 * read.si().abs() + f64::MIN_POSITIVE;
        assert!(
            off.is_some_and(|off| off <= rounding),
            "{text:?} prints as {printed:?}"
        );
        true
    }
    [
        same::<Length>(text),
        same::<Pressure>(text),
        same::<Torque>(text),
        same::<Speed>(text),
        same::<AngularSpeed>(text),
        same::<Angle>(text),
        same::<Temperature>(text),
        same::<LineLoad>(text),
        same::<Density>(text),
        same::<DynamicViscosity>(text),
        same::<KinematicViscosity>(text),
        same::<PressureViscosity>(text),
        same::<PerKelvin>(text),
    ]
    .contains(&true)
}

/// A case text loads, or is refused with a code that is explained.
///
/// # Panics
/// When the code is not.
pub fn case(name: &str, text: &str) -> bool {
    match case::from_text(name, text, &|_| Ok(trace())) {
        Ok(loaded) => {
            assert!(loaded.case.model.positions > 0);
            true
        }
        Err(error) => {
            assert!(explain(error.code()).is_some(), "{error}");
            false
        }
    }
}

/// The text of a planetary case loads, or is refused with codes that are explained, each told once. No file is
/// opened: the flanks are known by their values.
///
/// # Panics
/// When a code is not explained.
pub fn planetary_case(text: &str) -> bool {
    let Ok(source) = Source::new("set.toml", text) else {
        return false;
    };
    let names_files = source
        .key_paths()
        .any(|key| key.ends_with("file") || key.ends_with("xu_coefficients"));
    if !planetary::is_planetary(&source) || names_files {
        return false;
    }
    let found = planetary::check(source, "".as_ref(), &[]);
    assert_eq!(found.case.is_some(), found.errors.is_empty());
    for error in &found.errors {
        assert!(explain(error.code()).is_some(), "{error}");
    }
    found.case.is_some()
}

/// A result is read and drawn as a page that prints no number that is none, or refused.
///
/// # Panics
/// When the page prints one.
pub fn result(bytes: &[u8]) -> bool {
    let Ok(result) = serde_json::from_slice::<RunResult>(bytes) else {
        return false;
    };
    let tables = PageTables {
        flanks: [None, None],
        load_map: Vec::new(),
        contact: None,
        views: Vec::new(),
        file: None,
    };
    let Ok(page) = html::render(&result, &tables) else {
        return false;
    };
    let printed = page.split("<script").next().unwrap_or_default();
    for none in [">NaN", "NaN ", ">inf", " inf "] {
        assert!(!printed.contains(none), "the page prints {none:?}");
    }
    true
}
