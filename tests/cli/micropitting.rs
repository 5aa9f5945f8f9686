//! The specific film of the micropitting rating at the command line.

use crate::bench::{Bench, Said, root};

/// A case of the fixtures, coarsely, with settings.
fn run(case: &str, settings: &[&str], more: &[&str]) -> Said {
    let case = root().join(format!("fixtures/cases/{case}.toml"));
    let mut arguments = vec!["run", case.to_str().unwrap(), "--no-band"];
    arguments.extend(more);
    for setting in ["model.positions=4", "model.offsets=2"]
        .iter()
        .chain(settings)
    {
        arguments.extend(["--set", setting]);
    }
    Bench::new().run(&arguments)
}

fn json(case: &str, settings: &[&str]) -> serde_json::Value {
    run(case, settings, &["--no-output", "--json"])
        .well()
        .json()
}

fn of(value: &serde_json::Value) -> f64 {
    value.as_f64().unwrap()
}

#[test]
fn nothing_is_rated_unless_asked_for() {
    assert!(json("e-drive", &[])["micropitting"].is_null());
}

#[test]
fn gears_outside_of_the_specification_are_told_so_and_get_no_safety_factor() {
    let found = json("e-drive", &["micropitting={}"]);
    let rating = &found["micropitting"];
    assert!(rating["safety"].is_null());
    let outside = rating["outside"].to_string();
    assert!(
        outside.contains("module 1.80 mm is outside 3 to 11 mm"),
        "{outside}"
    );
    assert!(found["warnings"].to_string().contains("W432"));
    let text = run("e-drive", &["micropitting={}"], &["--no-output", "--notes"]).well();
    let text = text.unwrapped();
    assert!(
        text.contains("outside of its scope") && text.contains("W432"),
        "{text}"
    );
    assert!(text.contains("no permissible value stated"), "{text}");
}

#[test]
fn the_smallest_film_over_roughness_stands_beside_what_the_flanks_show() {
    // The FZG type C pair at the pitch line velocity of the micropitting test, 8.3 m/s.
    let given = "micropitting={ permissible = 0.2, load_factor = 1.21 }";
    let settings = [given, "operation.speed=2166 1/min"];
    let found = json("fzg-c", &settings);
    let rating = &found["micropitting"];
    assert_eq!(rating["outside"].as_array().unwrap().len(), 0, "{rating}");
    assert!(!found["warnings"].to_string().contains("W432"));
    let ra = rating["ra_um"].as_array().unwrap();
    let mean_ra = 0.5 * (of(&ra[0]) + of(&ra[1]));
    let cells = rating["cells"].as_array().unwrap();
    // Four cells of the path and its ends.
    assert_eq!(cells.len(), 6);
    assert_eq!(of(&cells[0]["path_fraction"]), 0.0);
    assert!((of(&cells[5]["path_fraction"]) - 1.0).abs() < 1e-12);
    let mut least = f64::INFINITY;
    for cell in cells {
        least = least.min(of(&cell["lambda"]));
        assert!((of(&cell["lambda"]) * mean_ra / of(&cell["film_um"]) - 1.0).abs() < 1e-9);
        // Rq of wavelengths below 0.08 mm is less than that of all.
        assert!(of(&cell["lambda_short"]) > 0.0);
    }
    assert_eq!(of(&rating["lambda_min"]), least);
    assert!((of(&rating["safety"]) - least / 0.2).abs() < 1e-12);
    // Pressure goes with the root of the load.
    let row = &found["path"][0];
    let cell = &cells[1];
    assert!((of(&cell["pressure_mpa"]) / of(&row["hertz_pressure_mpa"]) - 1.1).abs() < 1e-9);
    assert!((of(&cell["solid_share"]) - 1.0 + of(&row["film_share"])).abs() < 1e-12);
    // The ends are the points A and E of the result, which have no picture.
    let points = found["points"].as_array().unwrap();
    for (end, point) in [
        (&cells[0], &points[0]),
        (&cells[5], &points[points.len() - 1]),
    ] {
        assert!((of(&end["solid_share"]) - 1.0 + of(&point["film_share"])).abs() < 1e-12);
        assert!(end["flowing_area"].is_null(), "{end}");
    }
    let flow = 7000.0;
    for cell in &cells[1..5] {
        let pressure = of(&cell["solid_pressure_99_mpa"]);
        assert!(
            pressure > of(&cell["pressure_mpa"]) && pressure <= 1.0001 * flow,
            "{cell}"
        );
        assert!((0.0..=1.0).contains(&of(&cell["flowing_area"])));
    }
    let tags = found["equations"].to_string();
    for tag in ["Micropitting-1", "Micropitting-2", "Micropitting-3"] {
        assert!(tags.contains(tag), "{tag}");
    }
    // Twice the roughness, half the ratio.
    let twice = format!(
        "micropitting={{ load_factor = 1.21, ra = [\"{} um\", \"{} um\"] }}",
        2.0 * of(&ra[0]),
        2.0 * of(&ra[1])
    );
    let rougher = json("fzg-c", &[&twice, settings[1]]);
    let half = of(&rougher["micropitting"]["lambda_min"]);
    assert!((2.0 * half / least - 1.0).abs() < 1e-9);
    let text = run("fzg-c", &settings, &["--no-output", "--notes"])
        .well()
        .unwrapped();
    assert!(
        text.contains("over the user's 0.200; by the form of"),
        "{text}"
    );
    assert!(!text.to_lowercase().contains("safe "), "{text}");
}

#[test]
fn the_page_has_a_row_of_every_place() {
    let case = root().join("fixtures/cases/fzg-c.toml");
    let bench = Bench::new();
    let set = [
        "--set",
        "model.positions=4",
        "--set",
        "model.offsets=2",
        "--set",
        "micropitting={}",
    ];
    let run = ["run", case.to_str().unwrap(), "--no-band", "-o", "out"];
    bench.run(&[&run[..], &set].concat()).well();
    let page = std::fs::read_to_string(bench.path("out/report.html")).unwrap();
    for says in [
        "Micropitting: specific film",
        "as quoted by others",
        "do not combine to one rating",
    ] {
        assert!(page.contains(says), "{says}");
    }
}

#[test]
fn factors_that_cannot_be_are_refused() {
    let paper = ["micropitting={}", "formulation=paper"];
    run("fzg-c", &paper, &["--no-output", "--json"]).refused_json("E205", "one position");
    for (setting, says) in [
        ("micropitting.load_factor=0", "micropitting.load_factor"),
        ("micropitting.permissible=-1", "micropitting.permissible"),
        ("micropitting.ra=[\"0 um\", \"1 um\"]", "micropitting.ra"),
    ] {
        run("fzg-c", &[setting], &["--no-output", "--json"]).refused_json("E209", says);
    }
}
