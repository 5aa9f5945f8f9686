//! Fits to simulated traction curves against an independent program, coverage of the bands, and refusals.
//!
//! The tables in `golden` are simulated by the law of the film with errors of a machine (gain 2 %, zero 0.0005, film 5 %,
//! temperature 1 K, conductivity 20 %, bulk rise) and of points (2.5 % and 0.001); the fits of an independent program to
//! them are the expected values below.

#![allow(
    clippy::unwrap_used,
    clippy::panic,
    reason = "helpers of tests may unwrap as tests do"
)]

use asperity::core::task::par_map;
use asperity::oil::{
    BaseOil, FilmRheology, LubricantInput, PressureLaw, TractionConstants, ViscosityLaw,
};
use asperity_calibration::oil::fit::{PointErrors, fit_law};
use asperity_calibration::oil::problem::{Nuisance, Priors, TractionProblem, Zero};
use asperity_calibration::oil::selection::judge;
use asperity_calibration::oil::{
    FitSettings, Machine, OilBase, OilFit, OilPlan, PlanSettings, Probe, Reading, SetPoint,
    Setting, is_pcs, read_pcs, read_table, set_points, simulated,
};
use asperity_core::numerics::Z_975;
use asperity_core::quantity::{
    Density, Force, KinematicViscosity, Length, PerKelvin, Pressure, Speed, Temperature,
    ThermalConductivity,
};
use nalgebra::DVector;

const E_FLUID: &str = include_str!("golden/traction_e_fluid.csv");
const MINERAL: &str = include_str!("golden/traction_mineral.csv");
const ROELANDS: &str = include_str!("golden/traction_e_fluid_roelands.csv");

/// Oil with the constants and priors of the reference fits, whatever the library says later.
fn oil(is_mineral: bool) -> OilBase {
    let (nu, density, family, stress) = if is_mineral {
        ([96.0, 10.6], 882.0, BaseOil::Mineral, 5e6)
    } else {
        ([30.8, 5.9], 845.0, BaseOil::Pao, 4e6)
    };
    let lubricant = LubricantInput {
        viscosity: Some(ViscosityLaw::AstmD341 {
            at_40: KinematicViscosity::from_si(nu[0] * 1e-6),
            at_100: KinematicViscosity::from_si(nu[1] * 1e-6),
        }),
        density: Some(Density::from_si(density)),
        thermal_expansion: Some(PerKelvin::from_si(0.63 / density)),
        base_oil: Some(family),
        ..LubricantInput::default()
    };
    let input = lubricant;
    let lubricant = input.resolve(Temperature::from_celsius(80.0)).unwrap();
    let mut constants = TractionConstants {
        eyring_stress: Pressure::from_si(stress),
        ..TractionConstants::from_family(family).unwrap()
    };
    if is_mineral {
        constants.conductivity = ThermalConductivity::from_si(0.137);
        (constants.conductivity_rise, constants.conductivity_bend) = (1.72, 0.54);
    }
    let rheology = FilmRheology::new(&lubricant, family).unwrap();
    OilBase {
        name: "test".to_owned(),
        lubricant: input,
        rheology: rheology.with_constants(constants).unwrap(),
        deviations: [0.19, 0.09, 0.10],
        case_temperature: None,
    }
}

fn machine() -> Machine {
    let length = Length::from_si;
    Machine::ball_on_disc(length(9.525e-3), None, length(15e-9)).unwrap()
}

/// Settings of the reference fits.
const REFERENCE: FitSettings = FitSettings {
    is_wide: false,
    zero: Zero::Common,
    errors: PointErrors {
        relative: 0.025,
        floor: 1e-3,
    },
    is_forced: false,
};

fn fitted(oil: &OilBase, text: &str) -> OilFit {
    let (readings, _) = read_table("curves.csv", text, &machine()).unwrap();
    OilFit::new(oil, readings.into(), REFERENCE).unwrap()
}

/// Values of the constants, and their bands as factors without the widening of linearised bands.
fn check(found: &OilFit, law: &str, kept: usize, expected: [(f64, f64); 3], per_point: f64) {
    assert_eq!((found.pressure_law.name(), found.counts[2]), (law, kept));
    assert!(found.is_law_decided);
    for (k, (value, factor)) in [0, 1, 3].into_iter().zip(expected) {
        let constant = &found.constants[k];
        println!(
            "{} {} {:?}",
            constant.name, constant.fitted.value, constant.band
        );
        assert!(
            (constant.fitted.value / value - 1.0).abs() < 0.01,
            "{constant:?}"
        );
        let log = (constant.band[1] / constant.fitted.value).ln() / 1.15;
        assert!((log.exp() / factor - 1.0).abs() < 0.01, "{constant:?}");
    }
    println!("{} {:?}", found.squares_per_point, found.total_squared);
    assert!((found.squares_per_point - per_point).abs() < 0.05);
}

#[test]
fn synthetic_curves_give_the_constants_of_an_independent_fit() {
    let found = fitted(&oil(false), E_FLUID);
    check(
        &found,
        "barus",
        100,
        [(4.784, 1.132), (0.0356, 1.173), (0.9511, 1.039)],
        0.764,
    );
    assert!(
        (found.total_squared[0] - 78.0).abs() < 2.0 && (found.total_squared[1] - 309.0).abs() < 6.0
    );
    // The stress of a thin polyalphaolefin stays below the limit at this pressure.
    let identified: Vec<bool> = found
        .constants
        .iter()
        .map(|one| one.is_identified)
        .collect();
    assert_eq!(identified, [true, false, false, true]);
    let further = found.constants[1].would_help.as_deref().unwrap();
    println!("{further}");
    assert!(further.contains("70 N"), "{further}");
    let found = fitted(&oil(true), MINERAL);
    check(
        &found,
        "barus",
        120,
        [(4.192, 1.136), (0.0502, 1.129), (1.092, 1.041)],
        found.squares_per_point,
    );
    assert!(
        (found.total_squared[0] - 104.0).abs() < 2.0
            && (found.total_squared[1] - 206.0).abs() < 6.0
    );
    assert!(found.constants[1].is_identified);
    let found = fitted(&oil(false), ROELANDS);
    assert_eq!(found.pressure_law.name(), "roelands");
    assert!(
        (found.total_squared[0] - 105.0).abs() < 2.0
            && (found.total_squared[1] - 261.0).abs() < 6.0
    );
}

#[test]
fn units_order_and_signs_of_the_rows_do_not_matter() {
    let oil = oil(false);
    let (head, rows): (Vec<&str>, Vec<&str>) = E_FLUID
        .lines()
        .partition(|line| line.starts_with(['#', 'l']));
    // A quarter of the points, at all temperatures, loads and speeds.
    let rows: Vec<&str> = rows.into_iter().step_by(4).collect();
    let plain = fitted(&oil, &[&head[..], &rows].concat().join("\n"));
    let mut reversed = rows.clone();
    reversed.reverse();
    let reversed = [head.clone(), reversed].concat().join("\n");
    assert_eq!(fitted(&oil, &reversed).constants, plain.constants);
    let mirrored = |row: &&str| {
        let cells: Vec<&str> = row.split(',').collect();
        let [load, speed, slide, celsius, traction] = cells[..] else {
            panic!("{row}")
        };
        let [slide, traction] = [slide, traction].map(|cell| -cell.parse::<f64>().unwrap());
        format!("{load};{speed};{slide};{celsius};{traction}").replace('.', ",")
    };
    let mirrored: Vec<String> = rows.iter().map(mirrored).collect();
    let semicolons = head.last().unwrap().replace(',', ";");
    let mirrored = format!("{semicolons}\n{}\n", mirrored.join("\n"));
    for (one, other) in fitted(&oil, &mirrored)
        .constants
        .iter()
        .zip(&plain.constants)
    {
        // Both fits end within 1e-10 of the sum of squares, 1e-5 of a standard deviation.
        let sd = (other.band[1] - other.band[0]) / 4.0;
        assert!(
            (one.fitted.value - other.fitted.value).abs() < 1e-4 * sd,
            "{one:?} {other:?}"
        );
    }
}

/// The rows of a table as an export of a machine: first columns repeated, friction and forces rounded.
fn export(table: &str, lube_below_pot: f64) -> String {
    let mut text = String::from("MTM311 Test Data File\r\nLubricant name:\tx\r\n\r\n");
    let mut last = String::new();
    let mut rows: Vec<Vec<f64>> = table
        .lines()
        .filter(|line| !line.starts_with(['#', 'l']))
        .map(|line| line.split(',').map(|cell| cell.parse().unwrap()).collect())
        .collect();
    let key = |row: &Vec<f64>| [row[3], row[0], row[1], row[2]];
    rows.sort_by(|a, b| key(a).partial_cmp(&key(b)).unwrap());
    for row in rows {
        let [load, speed, slide, celsius, traction] = row[..] else {
            panic!()
        };
        let step = format!("{celsius} {load} {speed}");
        if step != last {
            text.push_str(
                "\r\nStep 1 started at 23/03/2018 10:01:00\r\nStep type\tBOD_TRACTION\r\n",
            );
            text.push_str("SRR (%)\tTraction Coeff (-)\t\tPot RTD Temp (degC)\tLube RTD Temp (degC)\tBall Load (N)\tRolling Speed (mm/s)\tSliding Speed (mm/s)\tSRR (%)\tTraction Force (N)\tTraction Coeff (-)\r\n");
            last = step;
        }
        let friction = format!("{traction:.4}");
        let rounded: f64 = friction.parse().unwrap();
        text.push_str(&format!(
            "{slide:.3}\t{friction}\t\t{celsius}\t{:.1}\t{load:.3}\t{:.2}\t{:.2}\t{slide:.3}\t{:.4}\t{friction}\r\n",
            celsius - lube_below_pot, 1000.0 * speed, 10.0 * speed * slide, rounded * load
        ));
    }
    text
}

#[test]
fn an_export_of_a_machine_gives_the_constants_of_its_table() {
    let text = export(E_FLUID, 0.0);
    assert!(is_pcs(&text) && !is_pcs(E_FLUID));
    let readings = read_pcs("mtm.txt", &text, &machine(), Probe::Lube).unwrap();
    assert_eq!(readings.len(), 120);
    let found = OilFit::new(&oil(false), readings.into(), REFERENCE).unwrap();
    let values = [0, 1, 3].map(|k| found.constants[k].fitted.value);
    // Friction has four decimals in the file.
    for (value, expected) in values.into_iter().zip([4.786, 0.0356, 0.9511]) {
        assert!((value / expected - 1.0).abs() < 2e-3, "{value} {expected}");
    }
    let air = export(E_FLUID, 100.0);
    let refused = read_pcs("mtm.txt", &air, &machine(), Probe::Lube).unwrap_err();
    assert!(refused.to_string().contains(": it reads air"), "{refused}");
    assert_eq!(
        read_pcs("mtm.txt", &air, &machine(), Probe::Pot)
            .unwrap()
            .len(),
        120
    );
    let wrong = text.replacen("\t10.00\t1.000\t", "\t90.00\t1.000\t", 1);
    // One bad reading is left out, a column of bad ones is refused.
    let readings = read_pcs("mtm.txt", &wrong, &machine(), Probe::Lube).unwrap();
    let bad: Vec<&Reading> = readings
        .iter()
        .filter(|one| one.contradiction.is_some())
        .collect();
    assert_eq!((readings.len(), bad.len()), (120, 1));
    let without = OilFit::new(&oil(false), readings.into(), REFERENCE).unwrap();
    let told = without.warnings.iter().any(|warning| {
        warning.text.contains("one reading is left out: mtm.txt:")
            && warning.text.contains("sliding speed 90 mm/s")
    });
    assert!(
        told && without.points.len() == found.points.len() - 1,
        "{:?}",
        without.warnings
    );
    let wrong = text.replace("\t1.000\t", "\t7.000\t");
    let refused = read_pcs("mtm.txt", &wrong, &machine(), Probe::Lube).unwrap_err();
    assert_eq!(refused.code(), "E317", "{refused}");
    let said = refused.to_string();
    assert!(
        said.contains("; 12 lines look like this: line 8 \""),
        "{said}"
    );
    assert!(
        said.ends_with("; the columns seem to be mixed up"),
        "{said}"
    );
    // A mark instead of many numbers, and of one.
    let marked = text.replace("\t40.0\t", "\tn.a.\t");
    let refused = read_pcs("mtm.txt", &marked, &machine(), Probe::Lube).unwrap_err();
    let said = refused.to_string();
    assert!(
        said.contains("temperature: \"n.a.\" is not a finite number; 40 lines look like this"),
        "{said}"
    );
    let marked = text.replacen("\t40.0\t", "\tn.a.\t", 1);
    let refused = read_pcs("mtm.txt", &marked, &machine(), Probe::Lube).unwrap_err();
    assert!(!refused.to_string().contains("look like this"), "{refused}");
    // A word of one cell is a remark: below the rows of a step, above its names, and between two rows.
    for (before, remark) in [
        ("\r\nStep 1", "Remarks\r\n"),
        ("SRR (%)\tTraction Coeff", "\tnew disc 3\r\n"),
        ("\r\n20.000\t", "\r\n\"paused\""),
    ] {
        let remarked = text.replace(before, &format!("{remark}{before}"));
        for text in [
            remarked.clone(),
            remarked.replace('\t', ";").replace('.', ","),
        ] {
            let found = read_pcs("mtm.txt", &text, &machine(), Probe::Lube);
            assert_eq!(
                found.map(|readings| readings.len()).ok(),
                Some(120),
                "{remark}"
            );
        }
    }
    // The title may lack, and a slow step prints few digits of its sliding speed.
    let untitled = text
        .split_once("Step 1")
        .map(|(_, rest)| format!("Step 1{rest}"))
        .unwrap();
    assert!(is_pcs(&untitled));
    assert_eq!(
        read_pcs("mtm.txt", &untitled, &machine(), Probe::Lube)
            .unwrap()
            .len(),
        120
    );
    let titled = text.as_str();
    let variants = [titled, untitled.as_str()].into_iter().flat_map(|text| {
        let with_mark = format!("\u{feff}{text}");
        let unix = text.replace("\r\n", "\n");
        [text.to_owned(), with_mark, unix]
    });
    for (text, printed) in variants.flat_map(|text| [(text.clone(), "-0.01"), (text, "0.00")]) {
        let slow = format!(
            "1\t-0.0002\t\t40.0\t40.0\t30.000\t25.00\t{printed}\t-0.020\t-0.0068\t-0.0002\r\n"
        );
        let head = text.find("SRR (%)").unwrap();
        let begin = head + text[head..].find('\n').unwrap() + 1;
        let with = format!("{}{slow}{}", &text[..begin], &text[begin..]);
        let readings = read_pcs("mtm.txt", &with, &machine(), Probe::Lube).unwrap();
        assert!(
            readings.iter().all(|one| one.contradiction.is_none()),
            "{printed}"
        );
    }
}

#[test]
fn an_export_is_read_as_spreadsheets_and_other_machines_write_it() {
    let text = export(E_FLUID, 0.0);
    let read = |text: &str| read_pcs("mtm.txt", text, &machine(), Probe::Lube);
    let expected = read(&text).unwrap();
    let comma = |text: &str| text.replace('.', ",");
    // The same columns from the last to the first.
    let turned = |text: &str| -> String {
        let line = |line: &str| {
            let mut cells: Vec<&str> = line.split('\t').collect();
            if cells.len() > 3 {
                cells.reverse();
            }
            cells.join("\t") + "\r\n"
        };
        text.lines().map(line).collect()
    };
    let quoted = |text: &str, separator: char| -> String {
        let line = |line: &str| {
            let cells: Vec<String> = line.split('\t').map(|cell| format!("\"{cell}\"")).collect();
            if cells.len() > 3 {
                cells.join(&separator.to_string()) + "\n"
            } else {
                line.replace('\t', &separator.to_string()) + "\n"
            }
        };
        text.lines().map(line).collect()
    };
    let wider = |text: &str| -> String {
        let line = |line: &str| {
            let mut cells: Vec<&str> = line.split('\t').collect();
            if cells.len() > 3 {
                let is_name = cells[0].starts_with("SRR");
                cells.insert(5, if is_name { "ECR (%)" } else { "98" });
            }
            cells.join("\t") + "\r\n"
        };
        text.lines().map(line).collect()
    };
    let filled = |text: &str| text.replace('\t', ";").replace("\r\n", ";;;;\r\n");
    for (about, text) in [
        ("decimal commas", comma(&text)),
        (
            "decimal commas, with a mark",
            format!("\u{feff}{}", comma(&text)),
        ),
        (
            "semicolons and decimal commas",
            comma(&text).replace('\t', ";"),
        ),
        ("semicolons and decimal points", text.replace('\t', ";")),
        ("commas", text.replace('\t', ",")),
        ("rows filled with separators", filled(&comma(&text))),
        ("quoted cells", quoted(&text, '\t')),
        ("quoted cells and semicolons", quoted(&comma(&text), ';')),
        ("blanks around numbers", text.replace('\t', " \t  ")),
        ("columns in another order", turned(&text)),
        ("a further column", wider(&text)),
        (
            "other names of the temperatures",
            text.replace("Pot RTD Temp (degC)", "Pot Temp (°C)")
                .replace("Lube RTD Temp (degC)", "Lube Temp (°C)"),
        ),
        (
            "steps with names",
            text.replace("Step 1 started", "Step 1 \"curve at 1 GPa\" started"),
        ),
        (
            "times of other countries",
            text.replace("23/03/2018 10:01:00", "2018-03-23 10.01"),
        ),
    ] {
        let found = read(&text).unwrap_or_else(|error| panic!("{about}: {error}"));
        assert!(is_pcs(&text), "{about}");
        assert_eq!(found.len(), expected.len(), "{about}");
        for (one, other) in found.iter().zip(&expected) {
            assert_eq!(
                (one.traction, one.setting),
                (other.traction, other.setting),
                "{about}"
            );
            assert!(one.contradiction.is_none(), "{about}");
        }
    }
}

#[test]
fn films_of_an_export_replace_the_computed_ones() {
    let (oil, machine) = (oil(false), machine());
    // Films at 60 N and 40 °C, 1.3 times the computed ones.
    let film = |speed: f64| {
        let at = Setting {
            load: Force::from_si(60.0),
            mean_speed: Speed::from_si(speed),
            slide_to_roll: 0.01,
            temperature: Temperature::from_celsius(40.0),
        };
        1.3 * machine.film(&oil.rheology, &at, None, 1.0).unwrap().1.si()
    };
    let mut text = export(E_FLUID, 0.0);
    text += "\r\nStep 13 \"film\" started at 23/03/2018 12:01:00\r\nStep type\tFILM\r\n";
    text +=
        "Rolling Speed (mm/s)\tAverage Film (nm)\tLube Temp (°C)\tPot Temp (°C)\tBall Load (N)\r\n";
    for speed in [0.5, 1.0, 2.0] {
        let nanometres = 1e9 * film(speed);
        text += &format!("{}\t{nanometres}\t40.2\t40\t60.1\r\n", 1000.0 * speed);
    }
    text += "5000\t0\t40\t40\t60\r\n";
    let readings = read_pcs("ehd.txt", &text, &machine, Probe::Lube).unwrap();
    assert_eq!(readings.len(), 120);
    let measured: Vec<&Reading> = readings.iter().filter(|one| one.film.is_some()).collect();
    // Ten points at 1 m/s; 3 m/s lie outside of the films, of which a fringe that was not found is none.
    assert_eq!(measured.len(), 10);
    for reading in &measured {
        assert!((reading.film.unwrap().si() / film(1.0) - 1.0).abs() < 1e-12);
    }
    let faster = text.replace("2000\t", "4000\t");
    let between = read_pcs("ehd.txt", &faster, &machine, Probe::Lube).unwrap();
    let at = |one: &&Reading| one.film.is_some() && one.setting.mean_speed.si() == 3.0;
    let at = between.iter().find(at).unwrap();
    let slope = (film(2.0) / film(1.0)).ln() / 4.0_f64.ln();
    let straight = film(1.0) * 3.0_f64.powf(slope);
    assert!((at.film.unwrap().si() / straight - 1.0).abs() < 1e-9);
    let found = OilFit::new(&oil, readings.into(), REFERENCE).unwrap();
    let of_films = found.points.iter().filter(|row| row.has_measured_film);
    assert_eq!(of_films.count(), 10);
    let wrong = text.replace("1000\t", "x\t");
    let refused = read_pcs("ehd.txt", &wrong, &machine, Probe::Lube).unwrap_err();
    assert_eq!(refused.code(), "E317", "{refused}");
    assert!(refused.to_string().contains(".txt:"), "{refused}");
}

#[test]
fn columns_state_machine_groups_temperatures_and_errors() {
    let read = |columns: &str, cells: &str| {
        let head = "load_n,mean_speed_m_s,slide_roll_percent,temperature_c,traction";
        let text = format!("{head}{columns}\n30,2,10,81,0.02{cells}\n30,2,-10,82,-0.024{cells}\n");
        read_table("curves.csv", &text, &machine()).map(|(readings, _)| readings)
    };
    let plain = read("", "").unwrap();
    let all = "group,set_temperature_c,sigma,conductivity_w_mk,film_nm,rubbing_s,poisson,youngs_modulus_gpa";
    let stated = read(&format!(",{all}"), ",second,78,0.001,46,90,60,0.28,200").unwrap();
    let [first, other] = [&plain[0], &stated[0]];
    assert_eq!(
        (first.set_temperature_c, other.set_temperature_c),
        (80.0, 78.0)
    );
    assert_eq!((first.sigma, other.sigma), (None, Some(0.001)));
    assert_eq!((first.group.as_str(), other.group.as_str()), ("", "second"));
    assert_eq!(other.machine.material.conductivity.si(), 46.0);
    assert_eq!(other.machine.material.poisson, 0.28);
    assert_eq!(other.machine.material.young.si(), 200e9);
    assert!((other.film.unwrap().si() - 90e-9).abs() < 1e-20);
    assert_eq!((first.rubbing_s, other.rubbing_s), (None, Some(60.0)));
    // Both signs: half the difference, and the error of the mean.
    let points = set_points(&stated);
    assert_eq!(points.len(), 1);
    assert!(points[0].has_both_signs);
    assert!((points[0].reading.traction - 0.022).abs() < 1e-15);
    assert!((points[0].reading.sigma.unwrap() - 0.001 / 2f64.sqrt()).abs() < 1e-15);
    // A better conductor keeps the surfaces colder and the friction higher.
    let friction = |reading: &Reading| {
        let found = reading
            .machine
            .predict(&oil(false).rheology, &reading.setting);
        found.unwrap().friction
    };
    let better = read(",conductivity_w_mk", ",46").unwrap();
    assert!(friction(&better[0]).surface_rise < friction(first).surface_rise);
    // Two groups have two gains.
    let both = [&plain[..], &stated].concat();
    let oil = oil(false);
    let points = set_points(&both);
    let priors = Priors::family(oil.deviations);
    let problem = TractionProblem::new(&oil, PressureLaw::Barus, priors, Zero::Curve, &points);
    let count =
        |kind: fn(&Nuisance) -> bool| problem.terms.iter().filter(|term| kind(&term.kind)).count();
    assert_eq!(count(|kind| matches!(kind, Nuisance::Gain(_))), 2);
    assert_eq!(count(|kind| matches!(kind, Nuisance::Temperature(_))), 2);
    for (columns, cells) in [
        (",face_width_mm", ",10"),
        (",line_load_n_mm", ",10"),
        (",radius_rolling_mm,radius_across_mm", ",10,300"),
    ] {
        let refused = read(columns, cells).unwrap_err().to_string();
        assert!(
            refused.contains("line; its losses are fitted by asperity calibrate"),
            "{refused}"
        );
    }
    let misspelt =
        "load_n,mean_speed_m_s,slide_roll_percent,temperature_c,tracton\n30,2,10,81,0.02\n";
    let refused = read_table("curves.csv", misspelt, &machine())
        .unwrap_err()
        .to_string();
    assert!(
        refused.contains("column tracton is not known; write traction"),
        "{refused}"
    );
    let barrel = read(",radius_rolling_mm,radius_across_mm", ",10,100").unwrap();
    assert_eq!(barrel[0].machine.radii.map(Length::si), [0.01, 0.1]);
    let one = read(",radius_rolling_mm", ",10").unwrap_err().to_string();
    assert!(one.contains("needs radius_across_mm"), "{one}");
    let ball = read(",ball_radius_mm,second_radius_mm", ",10,10").unwrap();
    assert!((ball[0].machine.radii[0].si() - 0.005).abs() < 1e-15);
}

/// Readings of the plan of the reference tables.
fn plan() -> Vec<Reading> {
    read_table("plan.csv", E_FLUID, &machine()).unwrap().0
}

/// A machine with errors drawn from the priors measures an oil drawn from its family: readings, and the variables.
fn measured(oil: &OilBase, points: &[SetPoint], seed: u64) -> (Vec<SetPoint>, DVector<f64>) {
    let priors = Priors::family(oil.deviations);
    let problem = TractionProblem::new(oil, PressureLaw::Barus, priors, Zero::Common, points);
    let (x, friction) = simulated(&problem, true, REFERENCE.errors, seed).unwrap();
    let mut points = points.to_vec();
    for (point, friction) in points.iter_mut().zip(friction) {
        point.reading.traction = friction;
    }
    (points, x)
}

/// Share of the bands with the factor 1.15 that hold the truth, for each stated constant.
fn coverage(is_mineral: bool, oils: u64) -> [f64; 4] {
    let oil = oil(is_mineral);
    let points: Vec<SetPoint> = set_points(&plan())
        .into_iter()
        .filter(|point| judge(&oil, point).unwrap().dropped.is_none())
        .collect();
    let seeds: Vec<u64> = (0..oils).collect();
    let held: Vec<[bool; 4]> = par_map(seeds, |seed| {
        let (measured, truth) = measured(&oil, &points, 1000 + seed);
        let priors = Priors::family(oil.deviations);
        let errors = REFERENCE.errors;
        let fit = fit_law(
            &oil,
            PressureLaw::Barus,
            priors,
            Zero::Common,
            errors,
            &measured,
        );
        let fit = fit.unwrap();
        std::array::from_fn(|k| (fit.x[k] - truth[k]).abs() < 1.15 * Z_975 * fit.deviation(k))
    });
    std::array::from_fn(|k| held.iter().filter(|one| one[k]).count() as f64 / oils as f64)
}

/// At least the share `least` of the bands of `oils` oils holds each constant.
fn check_coverage(oils: u64, least: f64) {
    for is_mineral in [false, true] {
        let shares = coverage(is_mineral, oils);
        println!("mineral {is_mineral}: {shares:?}");
        for share in shares {
            assert!(share >= least, "{is_mineral}: {shares:?}");
        }
    }
}

#[test]
fn bands_hold_the_constants_of_oils_drawn_from_their_family() {
    // Bands hold with 0.976, with 0.74 if they were half as wide. Fewer than five of six hold with a probability of 0.8 % for
    // each of eight constants, and all eight hold five times with 0.5 % if they were half as wide.
    check_coverage(6, 0.8);
}

/// Expected standard deviations of an independent program with 2.5 % and 0.001 a point and one common zero, rounded as it
/// prints them: Eyring stress, limiting shear stress and factor in per cent, of one curve to the plan with a small ball.
#[test]
fn a_plan_leaves_the_errors_of_an_independent_program() {
    let expected = [
        [
            [12.0, 9.0, 3.4],
            [9.0, 9.0, 2.7],
            [6.0, 8.0, 2.2],
            [6.0, 7.0, 2.1],
        ],
        [
            [13.0, 8.5, 3.4],
            [12.0, 7.0, 2.9],
            [7.0, 5.5, 1.9],
            [7.0, 3.8, 1.8],
        ],
    ];
    for (is_mineral, expected) in [false, true].into_iter().zip(expected) {
        let settings = PlanSettings {
            machine: machine(),
            is_wide: false,
            zero: Zero::Common,
            errors: REFERENCE.errors,
            simulate: None,
        };
        let plan = OilPlan::new(&oil(is_mineral), None, &settings).unwrap();
        let stages = &plan.stages[1..5];
        let points: Vec<usize> = stages.iter().map(|stage| stage.points).collect();
        // The thin oil lacks the film at 120 °C and 1 m/s.
        let described = if is_mineral {
            [10, 30, 120, 150]
        } else {
            [10, 30, 100, 120]
        };
        assert_eq!(points, described);
        for (stage, expected) in stages.iter().zip(expected) {
            let left = [0, 1, 3].map(|k| 100.0 * stage.constants[k].deviation);
            // Half of the last digit printed.
            for ((left, expected), half) in left.into_iter().zip(expected).zip([0.5, 0.5, 0.05]) {
                assert!((left - expected).abs() <= half, "{is_mineral}: {stage:?}");
            }
        }
    }
}

/// Minutes of processor time.
#[test]
#[ignore = "the same with more oils"]
fn bands_hold_the_constants_of_a_hundred_oils() {
    check_coverage(100, 0.88);
}
