//! What single keys of a case must be, and what the case says of them afterwards.

#![allow(clippy::disallowed_methods, reason = "tests read their own files")]
#![allow(clippy::unwrap_used, reason = "helpers of tests fail as tests do")]

use std::path::Path;

use crate::runs::losses;
use asperity::Error;
use asperity::case::{LoadedCase, load};

fn e_drive() -> LoadedCase {
    let file = Path::new(env!("CARGO_MANIFEST_DIR")).join("../../fixtures/cases/e-drive.toml");
    load(&file, None).unwrap()
}

fn key_of(error: &Error) -> &str {
    error.place().unwrap().key.as_deref().unwrap()
}

#[test]
fn the_ends_of_a_range_are_in_or_out_as_its_rule_says() {
    let case = e_drive();
    // Key, values that may be, values that may not.
    let of_paper: [(&str, &[&str], &[&str]); 3] = [
        ("position", &["0", "1", "C"], &["-0.001", "1.001"]),
        ("delta_step", &["1 nm", "0.999 mm"], &["0 mm", "1 mm"]),
        ("numerical_error", &["0.001", "0.2"], &["0", "0.201"]),
    ];
    let ranges: [(&str, &[&str], &[&str]); 14] = [
        ("positions", &["2", "10000"], &["1", "10001"]),
        ("offsets", &["1", "10000"], &["0", "10001"]),
        ("depths", &["0", "1000"], &["1001"]),
        ("window", &["1.5", "100"], &["1.49", "100.1"]),
        ("stiffness_factor", &["0.05", "20"], &["0", "20.1"]),
        ("face_coupling", &["0.05", "20"], &["0", "20.1"]),
        ("friction_scale", &["0.001", "10"], &["0", "10.01"]),
        ("boundary_friction", &["0", "2"], &["-0.01", "2.01"]),
        ("boundary_layer", &["0 nm", "1 um"], &["-1 nm", "1.01 um"]),
        ("inlet_layer", &["1 nm", "1 mm"], &["0 nm", "1.01 mm"]),
        ("tolerance", &["1e-16", "1e-4"], &["0", "1.01e-4"]),
        ("ehl.records", &["2", "64"], &["1", "65"]),
        ("ehl.cells", &["64", "8192"], &["0", "100", "8256"]),
        ("ehl.travel", &["2", "1000"], &["1.9", "1001"]),
    ];
    let of_model = ranges.map(|(name, inside, outside)| (format!("model.{name}"), inside, outside));
    let of_paper =
        of_paper.map(|(name, inside, outside)| (format!("paper.{name}"), inside, outside));
    for (key, inside, outside) in of_model.into_iter().chain(of_paper) {
        for value in inside {
            let set = case.with_key(&key, value);
            assert!(set.is_ok(), "{key} = {value}: {}", set.unwrap_err());
        }
        for value in outside {
            let error = case.with_key(&key, value).unwrap_err();
            assert_eq!(key_of(&error), key, "{key} = {value}: {error}");
        }
    }
}

#[test]
fn a_value_is_noted_where_its_usual_range_ends() {
    let case = e_drive();
    // Key, the usual ends, values beyond them.
    let ranges: [(&str, [&str; 2], [&str; 2]); 4] = [
        (
            "operation.bulk_temperature",
            ["-29 °C", "159 °C"],
            ["-31 °C", "161 °C"],
        ),
        (
            "operation.speed",
            ["1.1 1/min", "59000 1/min"],
            ["0.9 1/min", "61000 1/min"],
        ),
        (
            "lubricant.density",
            ["705 kg/m3", "1190 kg/m3"],
            ["695 kg/m3", "1210 kg/m3"],
        ),
        ("gears.helix", ["-44 deg", "44 deg"], ["-46 deg", "46 deg"]),
    ];
    let noted = |key: &str, value: &str| {
        let case = case.with_key(key, value).unwrap();
        let said = format!("{key} = ");
        let about = |text: &str| text.starts_with(&said);
        case.warnings.iter().any(|found| about(&found.text))
    };
    for (key, usual, beyond) in ranges {
        for value in usual {
            assert!(!noted(key, value), "{key} = {value}");
        }
        for value in beyond {
            assert!(noted(key, value), "{key} = {value}");
        }
    }
}

#[test]
fn a_name_is_found_by_its_row_or_as_a_key_with_blanks() {
    let started_low = r#"{ amount = "20 um", start_diameter = "10 mm" }"#;
    for (key, value, name, at) in [
        ("gears.helix", "61 deg", "helix angle", "gears.helix"),
        ("gears.face_width", "0 mm", "face width", "gears.face_width"),
        (
            "lubricant.heat_capacity",
            "0 J/(kg K)",
            "specific heat capacity",
            "lubricant.heat_capacity",
        ),
        (
            "gears.pinion.tip_relief",
            started_low,
            "start diameter of the relief",
            "gears",
        ),
    ] {
        let error = e_drive().with_key(key, value).unwrap_err();
        assert_eq!(
            (error.code().as_str(), key_of(&error)),
            ("E209", at),
            "{error}"
        );
        let says = format!(": {at}: {name} = ");
        assert!(error.to_string().contains(&says), "{error}");
    }
}

#[test]
fn a_bulk_temperature_takes_the_conductances_of_its_law() {
    let case = e_drive();
    let set = |law: &str| {
        case.with(|input| {
            input.set("operation.oil_temperature", "90 °C").unwrap();
            input.set("operation.bulk", law).unwrap();
        })
    };
    assert!(set(r#"{ law = "iso", lubrication = "jet" }"#).is_ok());
    for name in ["pinion_to_oil", "wheel_to_oil", "between"] {
        let law = format!(r#"{{ law = "iso", lubrication = "jet", {name} = "3 W/K" }}"#);
        let error = set(&law).unwrap_err();
        assert_eq!(
            (error.code().as_str(), key_of(&error)),
            ("E205", "operation.bulk")
        );
        assert!(error.to_string().contains("takes conductances"), "{error}");
    }
}

#[test]
fn grid_and_records_are_defaults_only_where_they_are_used() {
    let case = e_drive();
    let defaults = |keys: &[(&str, &str)]| {
        let case = keys.iter().fold(case.clone(), |case, (key, value)| {
            case.with_key(key, value).unwrap()
        });
        ["model.ehl.cells", "model.ehl.records"]
            .map(|key| case.case.defaults.iter().any(|default| default.key == key))
    };
    assert_eq!(defaults(&[]), [false, false]);
    assert_eq!(defaults(&[("model.full_film", "ehl")]), [true, false]);
    assert_eq!(defaults(&[("model.full_film", "ehl-transient")]), [true; 2]);
    assert_eq!(defaults(&[("model.load_share", "ehl")]), [true; 2]);
}

#[test]
fn a_calibration_that_cannot_be_names_its_parameter() {
    let case = e_drive();
    for (name, band) in [
        (
            "boundary_friction",
            r#"{ value = 0.1, low = 0.12, high = 0.13 }"#,
        ),
        (
            "boundary_layer",
            r#"{ value = "20 nm", low = "0 nm", high = "30 nm" }"#,
        ),
        (
            "limiting_shear",
            r#"{ value = 0.06, low = 0.05, high = 0.04 }"#,
        ),
        (
            "eyring_stress",
            r#"{ value = "9 MPa", low = "3 MPa", high = "8 MPa" }"#,
        ),
    ] {
        let table = format!("{{ {name} = {band} }}");
        let error = case.with_key("calibration", &table).unwrap_err();
        assert_eq!(error.code(), "E205", "{error}");
        let says = format!("calibration.{name}: needs 0 < low < high");
        assert!(error.to_string().contains(&says), "{error}");
    }
}

#[test]
fn traces_of_two_spacings_are_told_with_both() {
    let folder = tempfile::tempdir().unwrap();
    let fixtures = Path::new(env!("CARGO_MANIFEST_DIR")).join("../../fixtures");
    let text = std::fs::read_to_string(fixtures.join("cases/e-drive.toml")).unwrap();
    let text = text.replace("../profiles/", "");
    std::fs::write(folder.path().join("case.toml"), text).unwrap();
    let pinion = std::fs::read(fixtures.join("profiles/ground_pinion.csv")).unwrap();
    std::fs::write(folder.path().join("ground_pinion.csv"), pinion).unwrap();
    let wheel = std::fs::read_to_string(fixtures.join("profiles/ground_wheel.csv")).unwrap();
    let rows = wheel.lines().filter(|line| !line.starts_with('#'));
    let head = rows
        .clone()
        .take_while(|line| line.starts_with(char::is_alphabetic));
    let points = rows.filter(|line| !line.starts_with(char::is_alphabetic));
    let coarser: Vec<&str> = head.chain(points.step_by(2)).collect();
    std::fs::write(folder.path().join("ground_wheel.csv"), coarser.join("\n")).unwrap();
    let loaded = load(&folder.path().join("case.toml"), None).unwrap();
    let told = loaded.warnings.iter().find(|found| found.code == "W119");
    let says = "the flanks are spaced 500 nm and 1 um; the coarser was resampled to 500 nm";
    assert_eq!(told.unwrap().text, says);
}

#[test]
fn a_place_that_no_flank_has_is_refused_with_what_was_wrong() {
    let placed = |at: &str| {
        let pinion = format!(
            r#"{{ file = "../profiles/ground_pinion.csv", from = "root", at = {{ {at} }} }}"#
        );
        e_drive().with_key("surface.pinion", &pinion).unwrap_err()
    };
    let error = placed(r#"roll_length = "-3 mm""#);
    assert!(
        error.to_string().contains("must not be negative"),
        "{error}"
    );
}

/// Mistakes of case files, each with its code and with the words that name it; an unusual number is a warning.
#[test]
fn deliberate_mistakes_are_named() {
    let mistakes: [(&str, &str, &str, &str); 43] = [
        (
            "operation.torque",
            "145 kN m",
            "E212",
            "Hertz pressure at the pitch point",
        ),
        (
            "operation.torque",
            "145000 N m",
            "E212",
            "Hertz pressure at the pitch point",
        ),
        (
            "operation.torque",
            "145 N mm",
            "E121",
            "5.2 points per Hertz half-width",
        ),
        ("operation.torque", "0 N m", "E209", "not zero"),
        (
            "operation.speed",
            "9000 rad/s",
            "W201",
            "operation.speed = 85943",
        ),
        (
            "operation.speed",
            "9000 1/s",
            "E212",
            "pitch-line speed (by",
        ),
        ("operation.speed", "0 1/min", "E209", "operation.speed"),
        ("operation.bulk_temperature", "90 K", "E212", "-183.15 °C"),
        (
            "operation.bulk_temperature",
            "363 °C",
            "W201",
            "operation.bulk_temperature = 363 °C",
        ),
        (
            "gears.teeth",
            "[68, 23]",
            "W201",
            "the pinion, which is named first",
        ),
        (
            "gears.teeth",
            "[-23, 68]",
            "E205",
            "only the wheel may be a ring",
        ),
        ("gears.module", "1.8 m", "E212", "1800 mm is beyond"),
        ("gears.module", "1.8", "E204", "1.8 has no unit"),
        ("gears.module", "1,8 mm", "E204", "decimal sign as a point"),
        ("gears.face_width", "32 m", "E212", "32000 mm is beyond"),
        ("gears.face_width", "32 um", "E212", "face width"),
        ("gears.helix", "23.4 rad", "E209", "within 60 deg"),
        (
            "gears.centre_distance",
            "80 mm",
            "E206",
            "larger than the sum of the base radii",
        ),
        ("gears.profile_shift", "[3.0, 0]", "E206", "is pointed"),
        (
            "gears.tip_diameter",
            "[\"136.9 mm\", \"48.7 mm\"]",
            "E209",
            "are pinion and wheel exchanged",
        ),
        (
            "gears.tip_diameter",
            "[\"24.35 mm\", \"68.5 mm\"]",
            "E209",
            "radii stated as diameters",
        ),
        (
            "gears.pinion.tip_relief",
            "{ amount = \"20 mm\", length = \"2 mm\" }",
            "E212",
            "20000 um (11111.1111 um per mm of module) is beyond",
        ),
        (
            "gears.pinion.tip_relief",
            "{ amount = \"20 um\", length = \"2 m\" }",
            "E212",
            "(1111.1111 mm per mm of module) is beyond",
        ),
        (
            "gears.pinion.tip_relief",
            "{ amount = \"20 um\", length = \"20 mm\" }",
            "E209",
            "longer than twice the path of contact",
        ),
        (
            "gears.end_relief",
            "{ amount = \"20 um\", length = \"60 mm\" }",
            "E209",
            "longer than the face width",
        ),
        ("gears.wheel.fillet_radius", "3", "E209", "must be 0 to 1"),
        ("gears.wheel.dedendum", "0.1", "E209", "must be 0.5 to 3"),
        (
            "gears.wheel.crowning",
            "-20 mm",
            "E212",
            "-20000 um (-11111.1111 um per mm of module) is beyond",
        ),
        (
            "material.pinion.young",
            "210 MPa",
            "E212",
            "0.21 GPa is beyond",
        ),
        ("material.pinion.young", "210", "E204", "210 has no unit"),
        ("material.pinion.poisson", "3", "E209", "not above 0.5"),
        ("material.pinion.steel", "PA66", "E204", "is a plastic"),
        (
            "material.pinion.steel",
            "steel",
            "E220",
            "the library has no such steel",
        ),
        (
            "lubricant.density",
            "0.845 kg/m3",
            "E212",
            "0.845 kg/m3 is beyond",
        ),
        (
            "lubricant.density",
            "845 g/cm3",
            "E212",
            "845000 kg/m3 is beyond",
        ),
        (
            "lubricant.viscosity",
            "{ law = \"astm-d341\", at_40 = \"5.9 mm2/s\", at_100 = \"30.8 mm2/s\" }",
            "E209",
            "below the viscosity at 40 °C",
        ),
        (
            "lubricant.viscosity",
            "ISO VG 100",
            "E204",
            "states the viscosity at 40 °C only",
        ),
        (
            "lubricant",
            "{ oil = \"mobil\" }",
            "E208",
            "there is no oil \"mobil\"",
        ),
        (
            "surface.pinion",
            "{ ra = \"0.3 mm\" }",
            "E212",
            "300 um is beyond",
        ),
        (
            "surface.pinion",
            "{ ra = \"0.3 nm\" }",
            "W201",
            "surface.pinion.ra",
        ),
        ("surface.cutoff", "8 mm", "E120", "3 mm long"),
        (
            "surface.noise_cutoff",
            "0.1 um",
            "E120",
            "cut-off lambda_s = 1e-7 m: must not be shorter",
        ),
        (
            "gears.wheel.tip_relief",
            "{ amount = \"-8 um\", length = \"2 mm\" }",
            "E209",
            "must be finite and not negative",
        ),
    ];
    let mut wrong = Vec::new();
    for (key, value, code, words) in mistakes {
        let solved = |case: LoadedCase| match code {
            // The points of a Hertz half-width are counted in the run.
            "E121" => crate::runs::losses(&case).map(|_| case),
            _ => Ok(case),
        };
        let (found, said) = match e_drive().with_key(key, value).and_then(solved) {
            Err(error) => (error.code().to_string(), error.to_string()),
            Ok(case) => {
                let about = case
                    .warnings
                    .iter()
                    .filter(|warning| warning.code == "W201");
                let texts: Vec<&str> = about.map(|warning| &*warning.text).collect();
                ("W201".to_owned(), texts.join("; "))
            }
        };
        if found != code || !said.contains(words) {
            wrong.push(format!("{key} = {value}: {found} {said}"));
        }
    }
    assert!(wrong.is_empty(), "{}", wrong.join("\n"));
}

#[test]
fn a_starved_inlet_thins_the_film_to_its_layer() {
    let case = e_drive().with(|input| {
        (input.model.positions, input.model.offsets) = (Some(4), Some(2));
    });
    let case = case.unwrap();
    let with = |layer: &str| losses(&case.with_key("model.inlet_layer", layer).unwrap()).unwrap();
    let flooded = losses(&case).unwrap();
    // The law of a starved inlet, with a layer that starves nothing, loses more than the law of a flooded one: 9 % in these few
    // windows, 2 % over the path.
    let plenty = with("100 um");
    let jump = plenty.summary.loss_w / flooded.summary.loss_w - 1.0;
    assert!((0.06..0.12).contains(&jump), "{jump}");
    assert_eq!(
        plenty.path[0].film_central_um,
        flooded.path[0].film_central_um
    );
    let starved = with("0.05 um");
    assert!(starved.summary.asperity_share > plenty.summary.asperity_share);
    for (starved, flooded) in starved.path.iter().zip(&flooded.path) {
        // Shown as gap, the layer as mass flow: the same ratio.
        let ratio = starved.film_central_um / flooded.film_central_um;
        let minimum = starved.film_minimum_um / flooded.film_minimum_um;
        assert!(
            ratio < 0.6 && (minimum / ratio - 1.0).abs() < 1e-12,
            "{ratio}"
        );
        assert!(starved.film_central_um <= 0.05 + 1e-12);
        assert!((starved.rolling_w_per_m / flooded.rolling_w_per_m - 1.0).abs() < 1e-12);
    }
    for keys in [
        [("model.inlet_layer", "1 um"), ("model.load_share", "ehl")],
        [("model.inlet_layer", "1 um"), ("model.full_film", "ehl")],
    ] {
        let refused = case.with(|input| {
            for (key, value) in keys {
                input.set(key, value).unwrap();
            }
        });
        let error = refused.unwrap_err();
        assert_eq!(
            (error.code().as_str(), key_of(&error)),
            ("E205", "model.inlet_layer")
        );
    }
}
