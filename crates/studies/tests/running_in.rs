//! The study of running-in against runs of the flanks that it writes.

#![allow(clippy::unwrap_used, reason = "helpers of tests may panic as tests do")]

use std::path::Path;

use asperity::case::{self, LoadedCase};
use asperity_report::{Settings, StudyResult, StudySettings, Watch};
use asperity_studies::compare::Finish;
use asperity_studies::map::{Axes, MapBand, map};
use asperity_studies::running_in::{RunningInFound, RunningInSettings};

fn case() -> LoadedCase {
    let file = Path::new("../../fixtures/cases/fzg-c.toml");
    case::load_with(file, &|input| {
        (input.model.positions, input.model.offsets) = (Some(4), Some(1));
        let _ = input.set("operation.torque", "302 N m");
    })
    .unwrap()
}

fn found(case: &LoadedCase, stated: serde_json::Value) -> Result<RunningInFound, String> {
    let settings = RunningInSettings::of_json(stated).unwrap();
    let found = settings.run(case.clone(), &Watch::SILENT);
    found.map_err(|fault| format!("{} {fault}", fault.code()))
}

#[test]
fn torques_run_in_side_by_side_and_more_load_is_worth_more() {
    let case = case();
    let stated = serde_json::json!({ "torque": ["94 N m", "302 N m"], "engagements": 1e3 });
    let study = found(&case, stated).unwrap();
    let [low, high] = &study.courses[..] else {
        panic!("two torques")
    };
    assert!((study.of_wheel - 16.0 / 24.0).abs() < 1e-12);
    assert!(high.factor.high < 1.0 && high.factor.value < low.factor.value);
    for course in [low, high] {
        assert!(
            course.factor.low <= course.factor.value && course.factor.value <= course.factor.high
        );
        assert!(course.rows[0].engagements == 0.0 && course.rows[0].loss_w.half_width() == 0.0);
        assert!((course.rows[0].loss_w.value / study.loss_w - 1.0).abs() < 1e-9);
        let each = |of: fn(&asperity_studies::running_in::CourseRow) -> f64| {
            course.rows.iter().map(of).collect::<Vec<f64>>()
        };
        assert!(each(|row| row.pinion_removed_nm.value).is_sorted());
        assert!(each(|row| row.wheel_removed_nm.value).is_sorted());
        let done = course.done_engagements.unwrap();
        assert!((8.0..1e3).contains(&done), "{done}");
        // 2166 engagements a minute.
        assert!((course.done_hours.unwrap() / (done / 2166.0 / 60.0) - 1.0).abs() < 1e-9);
        assert!(
            course
                .removed_mg
                .iter()
                .all(|mass| (0.1..5.0).contains(mass))
        );
    }
}

#[test]
fn the_flanks_written_lose_what_the_history_says() {
    let case = case();
    let folder = tempfile::tempdir().unwrap();
    // In the plastic stage and beyond it.
    for engagements in [10.0, 3e3] {
        let study = found(&case, serde_json::json!({ "engagements": engagements })).unwrap();
        let target = folder.path().join(format!("{engagements}"));
        study.write(&target).unwrap();
        let run_in = case.with(|input| {
            let surface = &mut input.surface;
            surface.form = Some(asperity_roughness::form::Form::None);
            (surface.cutoff, surface.noise_cutoff) = ("0 mm".parse().ok(), "0 um".parse().ok());
            let flank = |name: &str| case::FlankInput {
                file: Some(target.join(format!("{name}.csv"))),
                ..Default::default()
            };
            (surface.pinion, surface.wheel) = (flank("pinion"), Some(flank("wheel")));
        });
        let loss = |case: &LoadedCase| {
            let losses = asperity::Run::new(case).losses().unwrap();
            losses.into_only().unwrap().summary.loss_w
        };
        let (loss, fresh) = (loss(&run_in.unwrap()), loss(&case));
        let factor = study.courses[0].factor.value;
        assert!(
            (loss / fresh / factor - 1.0).abs() < 5e-3,
            "{} {factor}",
            loss / fresh
        );
    }
}

#[test]
fn a_map_is_of_flanks_run_in_once_at_the_torque_that_the_case_states() {
    // Before, a map was of the flanks as measured.
    let case = case();
    let key = "operation.running_in";
    let of = |stated: &str| {
        let finish = Finish {
            name: "ground".to_owned(),
            case: case.with_key(key, stated).unwrap(),
        };
        let axes = Axes::new(&[100.0, 302.0], &[2166.0], &[90.0]).unwrap();
        map(&[finish], &axes, MapBand::None, &|_, _| {}).unwrap()
    };
    let (run_in, fresh) = (of("{ engagements = 16 }"), of("false"));
    let loss = |map: &asperity_studies::map::Map, torque: f64| {
        let mut points = map.finishes[0].points.iter();
        let point = points.find(|point| [point.torque_nm, point.speed_rpm] == [torque, 2166.0]);
        point.unwrap().numbers.unwrap().loss_w
    };
    for (torque, stated) in [(100.0, "100 N m"), (302.0, "302 N m")] {
        let run = case.with_key("operation.torque", stated).unwrap();
        let run = run
            .with_key(key, "{ torque = \"302 N m\", engagements = 16 }")
            .unwrap();
        let run = asperity::Run::new(&run).losses().unwrap();
        let run = run.into_only().unwrap();
        let expected = run.run_in.unwrap().summary.loss_w;
        for (map, of_run) in [(&run_in, expected), (&fresh, run.summary.loss_w)] {
            let ratio = loss(map, torque) / of_run;
            assert!((ratio - 1.0).abs() < 1e-9, "{torque}: {ratio}");
        }
        assert!(loss(&run_in, torque) < loss(&fresh, torque));
    }
    let said = "The flanks have run in by plastic flow at 302 N m";
    assert!(run_in.summary().contains(said), "{}", run_in.summary());
    assert!(!fresh.summary().contains("run in"));
    assert!(run_in.finishes[0].fingerprint != fresh.finishes[0].fingerprint);
}

#[test]
fn superfinished_flanks_gain_nothing_by_flow() {
    let file = Path::new("../../fixtures/cases/e-drive-superfinished.toml");
    let case = case::load_with(file, &|input| {
        (input.model.positions, input.model.offsets) = (Some(4), Some(2));
    });
    let study = found(&case.unwrap(), serde_json::json!({ "engagements": 1e5 })).unwrap();
    let course = &study.courses[0];
    let at = |n: f64| course.rows.iter().find(|row| row.engagements == n).unwrap();
    let ratio = at(100.0).pinion_rq_um.value / at(0.0).pinion_rq_um.value;
    assert!((ratio - 1.0).abs() < 1e-5, "{ratio}");
    assert!(study.summary().contains("only wear"), "{}", study.summary());
}

/// A scan without a lay, 24 rows of 1500 points, in the text format of ISO 25178-71.
fn scan(seed: f64) -> Vec<u8> {
    let part = |k: u32, by: f64| ((f64::from(k) + seed) * by).fract();
    let wave = |k: u32| {
        let length = 7.0 * 6.0_f64.powf(part(k, 0.618_034));
        let angle = std::f64::consts::TAU * part(k, 0.754_878);
        [
            angle.cos() / length,
            angle.sin() / length,
            part(k, 0.569_84),
        ]
    };
    let waves: Vec<[f64; 3]> = (0..40).map(wave).collect();
    let height = |x: f64, y: f64| -> f64 {
        let each =
            |[kx, ky, phase]: &[f64; 3]| (std::f64::consts::TAU * (kx * x + ky * y + phase)).cos();
        40.0 * waves.iter().map(each).sum::<f64>()
    };
    let row = |y: u32| {
        let row = (0..1500).map(|x| format!("{:.3} ", height(f64::from(x), 2.0 * f64::from(y))));
        row.collect::<String>() + "\n"
    };
    let rows: String = (0..24).map(row).collect();
    let head = "aISO-1.0\nManufacID = x\nNumPoints = 1500\nNumProfiles = 24\nXscale = 1E-06\nYscale = 2E-06\nZscale = 1E-09\n\
        Zresolution = 1E-12\nCompression = 0\nDataType = 7\nCheckType = 0\n*\n";
    format!("{head}{rows}*\n").into_bytes()
}

#[test]
fn scans_that_a_run_takes_as_patches_run_in_by_their_rows_from_the_loss_of_the_rows() {
    let text = "\
        gears = { teeth = [23, 68], module = \"1.8 mm\", helix = \"23.4 deg\", face_width = \"32 mm\" }\n\
        material.pinion = { elastic_limit = \"1500 MPa\", flow_pressure = \"7 GPa\" }\n\
        operation = { torque = \"30 N m\", speed = \"6000 1/min\", bulk_temperature = \"90 degC\" }\n\
        lubricant.oil = \"m100\"\n\
        model = { positions = 2, offsets = 1, depths = 0 }\n\
        [surface]\ncutoff = \"0.08 mm\"\npinion = { file = \"1\" }\nwheel = { file = \"9\" }\n";
    let scan = |name: &str| Ok(scan(name.parse().unwrap()));
    let case = case::from_text("case.toml", text, &scan).unwrap();
    assert!(case.surfaces.sheets().is_some());
    let study = found(&case, serde_json::json!({ "engagements": 4 })).unwrap();
    // The rows of a run with operation.running_in: 8 x 8 here, where a comparison beside patches takes 4 x 4.
    let rows = case.with_key("operation.running_in", "true").unwrap();
    assert!(rows.surfaces.sheets().is_none());
    let rows = rows.overridden(|over| over.as_measured = true).unwrap();
    let run = asperity::Run::new(&rows).interval(true).execute().unwrap();
    let loss = run.into_only().unwrap().result.summary.loss_w;
    assert!(
        (study.loss_w / loss - 1.0).abs() < 1e-9,
        "{} {loss}",
        study.loss_w
    );
    let said = |text: &str| {
        study
            .warnings
            .iter()
            .any(|warning| warning.text.contains(text))
    };
    assert!(said("the contact of lines is not confirmed") && !said("patches of whole surfaces"));
    let patches = case.with_key("surface.contact", "patch").unwrap();
    let refused = found(&patches, serde_json::json!({})).unwrap_err();
    assert!(
        refused.starts_with("E205") && refused.contains("set surface.contact = \"lines\""),
        "{refused}"
    );
}

#[test]
fn a_history_passes_through_the_traces_of_a_test() {
    let case = case();
    let folder = tempfile::tempdir().unwrap();
    // The test: the flanks of another history after 2e6 engagements.
    let test = found(
        &case,
        serde_json::json!({ "torque": ["302 N m"], "engagements": 2e6 }),
    )
    .unwrap();
    test.write(&folder.path().join("test")).unwrap();
    let fresh = case.surfaces.traces().unwrap()[0];
    let points = fresh.heights().iter().enumerate();
    let step = 1e6 * fresh.spacing().si();
    let rows = points.map(|(i, z)| format!("{},{}\n", i as f64 * step, 1e6 * z));
    std::fs::create_dir(folder.path().join("fresh")).unwrap();
    let text = format!("x_um,z_um\n{}", rows.collect::<String>());
    std::fs::write(folder.path().join("fresh/pinion.csv"), text).unwrap();
    let trace = |name: &str| folder.path().join(name).join("pinion.csv");
    let stated = |engagements: f64| {
        serde_json::json!({
            "engagements": engagements, "before": [trace("fresh")], "after": [trace("test")], "test_engagements": 2e6,
        })
    };
    let study = found(&case, stated(2e6)).unwrap();
    let pair = study.test.as_ref().unwrap();
    let last = study.courses[0].rows.last().unwrap();
    let ratio = last.pinion_rq_um.value / study.courses[0].rows[0].pinion_rq_um.value;
    assert!(
        (ratio / pair.rq_ratio.value - 1.0).abs() < 1e-6,
        "{ratio} {pair:?}"
    );
    assert!(pair.rq_ratio.value < pair.plastic_rq_ratio && pair.k_mm3_per_n_m.is_some());
    let too_far = found(&case, stated(3e7)).unwrap_err();
    assert!(
        too_far.starts_with("E205") && too_far.contains("ten times"),
        "{too_far}"
    );
}

#[test]
fn what_cannot_run_in_is_refused_with_a_way_out() {
    let case = case();
    for (stated, code, says) in [
        (serde_json::json!({ "torque": ["0 N m"] }), "E209", "torque"),
        (
            serde_json::json!({ "torque": ["90 kN m"] }),
            "E212",
            "torque",
        ),
        (
            serde_json::json!({ "engagements": 0.5 }),
            "E209",
            "engagements",
        ),
        (
            serde_json::json!({ "engagements": 1e11 }),
            "E209",
            "engagements",
        ),
        (
            serde_json::json!({ "test_engagements": 1e5 }),
            "E205",
            "the test has no traces",
        ),
        (
            serde_json::json!({ "before": ["a.csv"], "test_engagements": 1e5 }),
            "E205",
            "do not pair: 1 and 0",
        ),
        (
            serde_json::json!({ "before": ["a.csv"], "after": ["b.csv"] }),
            "E205",
            "need its engagements",
        ),
        (
            serde_json::json!({ "before": ["a.csv"], "after": ["b.csv"], "test_engagements": 1e6 }),
            "E103",
            "a.csv",
        ),
    ] {
        let refused = found(&case, stated.clone()).unwrap_err();
        assert!(
            refused.starts_with(code) && refused.contains(says),
            "{stated}: {refused}"
        );
    }
    let values = case.with(|input| {
        input.surface.wheel = Some(case::FlankInput {
            rq: "0.3 um".parse().ok(),
            ..Default::default()
        });
    });
    let refused = found(&values.unwrap(), serde_json::json!({})).unwrap_err();
    assert!(
        refused.contains("needs the traces of both flanks"),
        "{refused}"
    );
}
