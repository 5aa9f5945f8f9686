//! Messages about a case: their codes, their remedies in keys, and those of the parsers in words of the case file.

#![allow(clippy::unwrap_used, reason = "helpers of tests fail as tests do")]

use asperity::CaseInput;
use asperity::key_words::{advice, with_keys};
use asperity::message::{Code, EXPLANATIONS};
use asperity::remedy::{Remedy, Setting, Value};

#[test]
fn no_message_of_the_library_names_an_option() {
    for entry in EXPLANATIONS {
        for text in [entry.title, entry.meaning, entry.remedy] {
            assert!(!text.contains("--"), "{}: {text}", entry.code);
        }
    }
}

#[test]
fn a_remedy_names_keys() {
    let unit = Remedy::set(Setting::ZUnit, Value::OneOf("um | nm | mm".into()));
    assert_eq!(
        with_keys("a.csv: no unit", &unit, "surface.wheel"),
        "a.csv: no unit. Write z_unit = \"um\", or \"nm\", or \"mm\" in surface.wheel"
    );
    let columns = Remedy::set(Setting::Columns, Value::Like("1,2".into()));
    assert_eq!(
        with_keys("m", &columns, "surface.pinion"),
        "m. Write columns = { x = 1, z = 2 } in surface.pinion"
    );
    let none = Remedy::set(Setting::Cutoff, Value::This("0 mm".into()));
    assert_eq!(
        with_keys("m", &none, "surface.wheel"),
        "m. Write cutoff = \"0 mm\" in surface"
    );
    assert_eq!(with_keys("m?", &none, "surface.wheel"), "m?");
}

#[test]
fn advice_names_the_keys_of_a_code() {
    assert_eq!(advice(Code::E121), Code::E121.explain().remedy);
    let of_preparation = advice(Code::E120);
    assert!(of_preparation.ends_with("(cutoff, noise_cutoff in surface)."));
}

/// A case without `without`, with `more` at its end.
fn refused(without: &str, more: &str) -> String {
    let text = "gears = { teeth = [23, 68], module = \"2 mm\", face_width = \"30 mm\" }\n\
        operation = { torque = \"100 N m\", speed = \"3000 1/min\", bulk_temperature = \"60 °C\" }\n\
        lubricant = { oil = \"m100\" }\nsurface = { pinion = { rq = \"0.3 um\" } }\n";
    assert!(text.contains(without), "{without}");
    let text = text.replace(without, "") + more;
    let error = text.parse::<CaseInput>().unwrap_err();
    assert_eq!(error.code(), "E204", "{error}");
    error.to_string()
}

#[test]
fn a_missing_key_is_explained_by_the_schema() {
    let said = refused("module = \"2 mm\", ", "");
    assert!(
        said.ends_with(
            ": missing key \"module\" (Normal module m_n; the transverse one with `module_plane = \"transverse\"`; length with a unit: mm, um, micron, micrometer, micrometre, nm, m, cm); the table needs teeth, module, face_width"
        ),
        "{said}"
    );
    let said = refused("", "gearbox = { seals = [{ diameter = \"40 mm\" }] }\n");
    assert!(
        said.contains("missing key \"shaft\"")
            && said.ends_with("; the table needs shaft, diameter"),
        "{said}"
    );
    let gears = "gears = { teeth = [23, 68], module = \"2 mm\", face_width = \"30 mm\" }\n";
    let said = refused(gears, "");
    assert!(
        said.ends_with(": missing key \"gears\" (The gear pair)"),
        "{said}"
    );
}

#[test]
fn a_formulation_that_no_program_registered_is_refused_with_the_way_to_it() {
    let said = refused("", "formulation = \"paper\"\n");
    let expected = "unknown choice `paper`, expected `corrected`; that of the 2022 paper is in the crate asperity-paper-2022, \
        whose function `register` a program calls before it reads a case";
    assert!(said.contains(expected), "{said}");
}

#[test]
fn the_words_of_rust_are_translated() {
    let mut case = CaseInput::default();
    let mut said = |key, value| case.set(key, value).unwrap_err().to_string();
    for (key, value, expected) in [
        (
            "model.offsets",
            "a",
            "string \"a\" does not fit, expected a whole number, 0 or more \
             (Number of offsets along the traces at which the flanks meet; default 16, and up to 256 where the contacts \
             differ from offset to offset; 4 of each pair of surrogates (`paper`: 1))",
        ),
        (
            "gears.teeth",
            "[1]",
            "1 value does not fit, expected two values, e.g. [first, second] \
             (Numbers of teeth z, pinion then wheel; negative for a ring gear: `[24, -75]`)",
        ),
        (
            "gears.module_plane",
            "x",
            "unknown choice `x`, expected `normal` or `transverse` \
             (Plane in which the module is measured; default `normal`)",
        ),
        // No words of Rust.
        (
            "gears.module",
            "1",
            "1 has no unit; a length needs one of: mm, um, micron, micrometer, micrometre, nm, m, cm (as \"1 mm\")",
        ),
    ] {
        let said = said(key, value);
        assert!(said.ends_with(&format!("{key}: {expected}")), "{said}");
    }
}
