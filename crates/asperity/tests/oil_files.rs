//! Oil files: read, written, refused, and the law of pressure that a case takes from them.

#![allow(clippy::unwrap_used, reason = "helpers of tests fail as tests do")]

use asperity::case::{CaseError, LoadedCase, OilFile, Source, from_text};
use asperity::oil::{LubricantInput, PressureLaw, ViscosityLaw};
use asperity::quantity::Temperature;

const VALID: &str = r#"
schema = "asperity-oil-1"
lubricant = { oil = "m100" }

[film_friction]
pressure_law = "barus"
eyring_stress = { value = "4.8 MPa", low = "4.2 MPa", high = "5.4 MPa" }
limiting_shear = { value = 0.036, low = 0.030, high = 0.042, identified = false }
limiting_shear_temperature = { value = 0.0004, low = -0.0028, high = 0.0035 }
pressure_viscosity_factor = { value = 0.95, low = 0.91, high = 0.99 }
correlations = [{ between = ["eyring_stress", "pressure_viscosity_factor"], value = -0.66 }]
temperatures = ["40 °C", "120 °C"]
pressure_max = "1.19 GPa"
fit = { points = 100, chi2_per_point = 0.76, other_law = 309.0, this_law = 78.0 }
source = "curves.csv"
"#;

fn read(text: &str) -> Result<OilFile, CaseError> {
    OilFile::of_source(&Source::new("oil.toml", text)?)
}

#[test]
fn a_written_file_reads_back() {
    let file = read(VALID).unwrap();
    let text = file.to_string();
    assert_eq!(read(&text).unwrap(), file, "{text}");
    assert!(
        text.contains(
            "eyring_stress = { value = \"4.8 MPa\", low = \"4.2 MPa\", high = \"5.4 MPa\" }\n"
        ),
        "{text}"
    );
    let own = LubricantInput {
        oil: None,
        viscosity: Some(ViscosityLaw::IsoVg {
            grade: 100.0,
            viscosity_index: 95.0,
        }),
        ..LubricantInput::default()
    };
    let file = OilFile {
        lubricant: own,
        ..file
    };
    assert_eq!(read(&file.to_string()).unwrap(), file, "{file}");
}

/// The valid file with constants by Roelands as well.
fn undecided() -> OilFile {
    let first = VALID.replace("other_law = 309.0", "other_law = 80.0");
    let (_, table) = first.split_once("[film_friction]").unwrap();
    let other = table
        .replace("barus", "roelands")
        .replace("4.8 MPa", "5.0 MPa")
        .replace(
            "other_law = 80.0, this_law = 78.0",
            "other_law = 78.0, this_law = 80.0",
        );
    read(&format!("{first}\n[other_law]{other}")).unwrap()
}

#[test]
fn an_undecided_law_of_pressure_has_the_odds_of_the_fits() {
    let file = undecided();
    assert_eq!(read(&file.to_string()).unwrap(), file, "{file}");
    let odds = file.film_friction.probability_of_other_law();
    assert!((odds - 1.0 / (1.0 + 1f64.exp())).abs() < 1e-15);
    let text = "gears = { teeth = [23, 68], module = \"2 mm\", face_width = \"30 mm\" }\n\
        operation = { torque = \"100 N m\", speed = \"3000 1/min\", bulk_temperature = \"60 °C\" }\n\
        lubricant = { oil_file = \"oil.toml\" }\n\
        surface = { pinion = { rq = \"0.3 um\" }, wheel = { rq = \"0.3 um\" } }\n";
    let case = from_text("case.toml", text, &|_| Ok(file.to_string().into_bytes())).unwrap();
    let by_law = |case: &LoadedCase, stated| {
        let case = case.with(|input| input.model.film_pressure_law = stated);
        let case = case.unwrap();
        let found = OilFile::clone(case.case.oil_file.as_ref().unwrap());
        let other = found.other_law.as_ref().unwrap().pressure_law;
        assert_ne!(other, found.film_friction.pressure_law);
        (case, found)
    };
    let (by_roelands, found) = by_law(&case, Some(PressureLaw::Roelands));
    assert_eq!(found.film_friction.pressure_law, PressureLaw::Roelands);
    assert_eq!(found.film_friction.eyring_stress.fitted.value.si(), 5e6);
    // The better law returns once no law is stated.
    assert_eq!(by_law(&by_roelands, None).1, file);
    assert_eq!(by_law(&case, Some(PressureLaw::Barus)).1, file);
    let text = file.to_string().replace("roelands", "barus");
    let error = read(&text).unwrap_err().to_string();
    assert!(
        error.contains("other_law.pressure_law: needs another law"),
        "{error}"
    );
}

#[test]
fn impossible_files_are_refused_with_key_and_line() {
    for (from, to, code, says) in [
        (
            "asperity-oil-1",
            "asperity-oil-2",
            "E204",
            "oil.toml:2: schema: unknown choice `asperity-oil-2`",
        ),
        (
            "pressure_law = \"barus\"\n",
            "",
            "E204",
            "missing key \"pressure_law\"",
        ),
        (
            "eyring_stress",
            "eyring_strain",
            "E203",
            "oil.toml:7: unknown key \"film_friction.eyring_strain\"",
        ),
        (
            "low = \"4.2 MPa\"",
            "low = \"5.2 MPa\"",
            "E205",
            "oil.toml:7: film_friction.eyring_stress: needs 0 < low < high",
        ),
        (
            "low = 0.030",
            "low = 0",
            "E205",
            "film_friction.limiting_shear: needs 0 < low",
        ),
        (
            "high = 0.042",
            "high = 1.2",
            "E205",
            "film_friction.limiting_shear: must be below 1",
        ),
        (
            "low = -0.0028",
            "low = 0.0028",
            "E205",
            "film_friction.limiting_shear_temperature: needs low < high",
        ),
        (
            "high = 0.0035",
            "high = 0.02",
            "E205",
            "no single temperature",
        ),
        (
            "value = \"4.8 MPa\"",
            "value = 4.8",
            "E204",
            "film_friction.eyring_stress",
        ),
        (
            "value = -0.66",
            "value = -1.66",
            "E205",
            "film_friction.correlations: contradict",
        ),
        (
            "\"eyring_stress\", \"pr",
            "\"eyring\", \"pr",
            "E204",
            "film_friction.correlations",
        ),
        (
            "[\"40 °C\", \"120 °C\"]",
            "[]",
            "E205",
            "film_friction.temperatures",
        ),
        ("1.19 GPa", "-1 GPa", "E205", "film_friction.pressure_max"),
        ("points = 100", "points = 0", "E205", "film_friction.fit"),
        (
            "oil = \"m100\"",
            "oil_file = \"b.toml\"",
            "E205",
            "oil.toml:3: lubricant.oil_file: is a key of a case",
        ),
    ] {
        assert!(VALID.contains(from), "{from}");
        let error = read(&VALID.replacen(from, to, 1)).unwrap_err();
        assert_eq!(error.code(), code, "{error}");
        assert!(error.to_string().contains(says), "{error}");
    }
    assert_eq!(read("x y").unwrap_err().code(), "E202");
}

#[test]
fn the_error_of_the_law_grows_beyond_the_tested_temperatures() {
    let mut found = read(VALID).unwrap().film_friction;
    let at = |celsius: f64| Temperature::from_celsius(celsius);
    for (celsius, error) in [(90.0, 0.02), (139.0, 0.02), (15.0, 0.02f64.hypot(0.0625))] {
        assert!((found.law_error(at(celsius)) - error).abs() < 1e-12);
    }
    found.fit.chi2_per_point = 2.0;
    assert_eq!(found.law_error(at(90.0)), 0.12);
}
