//! Cases from every source are the same case.

#![allow(clippy::disallowed_methods, reason = "tests read their own files")]
#![allow(clippy::unwrap_used, reason = "helpers of tests fail as tests do")]

use asperity::pipeline::Kept;
use std::path::{Path, PathBuf};

use asperity::case::{CaseInput, FlankInput, LoadedCase, SurfaceInput, Trace, from_text, load};
use asperity::prelude::{Case, Length, ReadOptions};
use asperity::remedy::{Action, Setting};

fn fixtures() -> PathBuf {
    Path::new(env!("CARGO_MANIFEST_DIR")).join("../../fixtures")
}

fn text(name: &str) -> String {
    std::fs::read_to_string(fixtures().join("cases").join(name)).unwrap()
}

fn trace(name: &str) -> Vec<u8> {
    std::fs::read(fixtures().join("profiles").join(name)).unwrap()
}

/// The loss with few positions, which differ like all of them.
fn loss(case: &LoadedCase) -> f64 {
    let few = case
        .with(|input| {
            input.model.positions = Some(6);
            input.model.offsets = Some(2);
        })
        .unwrap();
    let outcome = asperity::Run::new(&few)
        .execute()
        .unwrap()
        .into_only()
        .unwrap();
    outcome.result.summary.loss_w
}

fn e_drive() -> LoadedCase {
    load(&fixtures().join("cases/e-drive.toml"), None).unwrap()
}

#[test]
fn a_text_with_a_resolver_is_the_case_of_the_file() {
    let asked = std::cell::RefCell::new(Vec::new());
    let case = from_text("e-drive.toml", &text("e-drive.toml"), &|name| {
        asked.borrow_mut().push(name.to_owned());
        std::fs::read(fixtures().join("cases").join(name))
    })
    .unwrap();
    assert_eq!(
        asked.into_inner(),
        [
            "../profiles/ground_pinion.csv",
            "../profiles/ground_wheel.csv"
        ]
    );
    let file = e_drive();
    assert_eq!(case.surfaces, file.surfaces);
    assert_eq!(case.flanks, file.flanks);
    assert_eq!(case.case.defaults, file.case.defaults);
    assert_eq!(loss(&case), loss(&file));
}

#[test]
fn a_trace_from_bytes_or_heights_is_the_trace_of_the_file() {
    let file = e_drive();
    let input = file.case.input.clone();
    let options = ReadOptions::default;
    let begin = || {
        let given = input.clone();
        Case::builder(given.gears, given.operation, given.lubricant)
            .material(given.material)
            .change(|case| case.surface.cutoff = given.surface.cutoff)
    };
    let bytes = begin()
        .pinion(Trace::from_bytes(
            "flank.csv",
            trace("ground_pinion.csv"),
            options(),
        ))
        // The same name for another content.
        .wheel(Trace::from_bytes("flank.csv", trace("ground_wheel.csv"), options()).mirrored())
        .build()
        .unwrap();
    assert_eq!(bytes.surfaces, file.surfaces);
    let [pinion, wheel] = [0, 1].map(|i| file.flanks[i].reading.as_ref().unwrap().profile.clone());
    let slices = begin()
        .pinion(Trace::from_heights(pinion.heights(), pinion.spacing()).unwrap())
        .wheel(
            Trace::from_heights(wheel.heights(), wheel.spacing())
                .unwrap()
                .mirrored(),
        )
        .build()
        .unwrap();
    assert_eq!(slices.surfaces, file.surfaces);
    assert_eq!(slices.flanks[0].file.as_deref(), Some("pinion"));
    assert_eq!(loss(&slices), loss(&file));
    let cut = |case: &LoadedCase| {
        let cut = case.with_key("surface.wheel.range", "0.2 mm .. 2.8 mm");
        cut.unwrap().surfaces.clone()
    };
    assert_eq!(cut(&slices), cut(&file));
    assert_ne!(cut(&file), file.surfaces);
    let path = |name: &str| fixtures().join("profiles").join(name);
    let files = begin()
        .pinion(Trace::from_file(path("ground_pinion.csv"), options()))
        .wheel(Trace::from_file(path("ground_wheel.csv"), options()).mirrored())
        .build()
        .unwrap();
    assert_eq!(files.surfaces, file.surfaces);
}

#[test]
fn a_range_stays_with_its_trace() {
    let mut surface = SurfaceInput {
        pinion: FlankInput {
            file: Some("a.csv".into()),
            range: Some("0 mm .. 1 mm".parse().unwrap()),
            ..FlankInput::default()
        },
        ..SurfaceInput::default()
    };
    surface.put_traces(Path::new("/there/a.csv"), Some(Path::new("b.csv")));
    assert!(surface.pinion.range.is_some());
    assert!(surface.wheel.unwrap().range.is_none());
}

#[test]
fn without_a_flank_of_its_own_the_wheel_runs_on_the_pinions_mirrored() {
    let input = e_drive().case.input.clone();
    let heights = e_drive().flanks[0]
        .reading
        .as_ref()
        .unwrap()
        .profile
        .clone();
    let case = Case::builder(input.gears, input.operation, input.lubricant)
        .pinion(Trace::from_heights(heights.heights(), heights.spacing()).unwrap())
        .set("surface.cutoff", "0.25 mm")
        .unwrap()
        .build()
        .unwrap();
    assert!(case.surfaces.same_trace);
    assert!(case.flanks[1].mirrored && !case.flanks[0].mirrored);
}

#[test]
fn every_shipped_case_reads_back_from_what_it_is_written_as() {
    for name in [
        "e-drive.toml",
        "e-drive-superfinished.toml",
        "fzg-c.toml",
        "table2.toml",
    ] {
        let input: CaseInput = text(name).parse().unwrap();
        let again: CaseInput = input.to_toml().unwrap().parse().unwrap();
        assert_eq!(again, input, "{name}");
        let json = input.store(serde_json::value::Serializer).unwrap();
        assert_eq!(CaseInput::stored(json).unwrap(), input);
    }
    // A case with named meshes, whose steel and flanks are stored only as far as they are stated.
    let named = r#"
        train.input = "in"
        mesh.m = { shafts = ["in", "out"], gears = { teeth = [23, 68], module = "1.8 mm", face_width = "32 mm" }, surface.wheel.rq = "0.2 um" }
        operation = { torque = "145 N m", speed = "9000 1/min", bulk_temperature = "90 °C" }
        lubricant = { oil = "m100" }
        surface = { pinion.rq = "0.3 um" }
        gearbox.jets = [{ mesh = "m", flow = "2 l/min", speed = "20 m/s" }]
    "#;
    let input: CaseInput = named.parse().unwrap();
    assert!(input.names_meshes());
    let again: CaseInput = input.to_toml().unwrap().parse().unwrap();
    assert_eq!(again, input);
    let json = input.store(serde_json::value::Serializer).unwrap();
    assert_eq!(json["material"], serde_json::json!({}));
    let keys = |table: &serde_json::Value| -> Vec<String> {
        table.as_object().unwrap().keys().cloned().collect()
    };
    assert_eq!(keys(&json["surface"]), ["pinion"]);
    assert_eq!(keys(&json["mesh"]["m"]["surface"]), ["wheel"]);
    assert!(json.get("gears").is_none());
    assert_eq!(CaseInput::stored(json).unwrap(), input);
    // A key of the one kind is none of the other.
    let pair: CaseInput = text("e-drive.toml").parse().unwrap();
    for (mut case, key) in [(pair, "heat.ambient"), (input, "gears.module")] {
        assert_eq!(case.set(key, "1 mm").unwrap_err().code(), "E203", "{key}");
    }
}

#[test]
fn keys_are_set_by_their_path_and_nothing_else_changes() {
    let case: CaseInput = text("e-drive.toml").parse().unwrap();
    for (path, value) in [
        ("operation.torque", "200 N m"),
        ("operation.torque", "\"200 N m\""),
        ("gears.teeth", "[24, 68]"),
        ("gears.face_width", "30 mm"),
        ("gears.profile_shift", "[0.1, -0.2]"),
        ("formulation", "corrected"),
        ("title", "2026"),
        ("title", "a = b"),
        ("material.wheel.young", "205 GPa"),
        (
            "lubricant.viscosity",
            "{ law = \"given\", dynamic_viscosity = \"9 mPa s\" }",
        ),
        ("lubricant.viscosity.at_40", "32 mm2/s"),
        ("surface.pinion.dx", "0.5 um"),
        ("surface.pinion.columns", "{ x = 1, z = 2 }"),
        ("surface.wheel.mirrored", "false"),
        ("surface.form", "poly2"),
        ("model.load_distribution", "uniform"),
        (
            "model.load_distribution",
            "{ table = [[0.0, 1.0], [1.0, 0.5]] }",
        ),
        (
            "gears.pinion.tip_relief",
            "{ amount = \"10 um\", length = \"2 mm\" }",
        ),
        ("gears.wheel.crowning", "4 um"),
        ("paper.position", "B"),
        ("paper.position", "0.25"),
        ("model.window", "nan"),
        ("model.tolerance", "1e-9"),
        ("model.film", "hamrock-dowson"),
        ("paper.numerical_error", "2 %"),
        ("model.film_friction", "{ iso-14179-2 = 0.9 }"),
    ] {
        let mut changed = case.clone();
        changed
            .set(path, value)
            .unwrap_or_else(|error| panic!("{path}: {error}"));
        assert_ne!(changed, case, "{path}");
        // Any other key is as before.
        let top = path.split('.').next().unwrap();
        let [mut before, mut after] =
            [&case, &changed].map(|input| input.store(serde_json::value::Serializer).unwrap());
        for value in [&mut before, &mut after] {
            value.as_object_mut().unwrap().remove(top);
        }
        assert_eq!(before, after, "{path}");
    }
    let mut changed = case.clone();
    changed.set("model.window", "5").unwrap();
    changed.unset("model.window").unwrap();
    assert_eq!(changed, case);
}

#[test]
fn a_key_that_cannot_be_set_is_refused_and_changes_nothing() {
    let case: CaseInput = text("e-drive.toml").parse().unwrap();
    for (path, value, code, says) in [
        (
            "operation.torqe",
            "1 N m",
            "E203",
            "Did you mean \"torque\"?",
        ),
        ("", "1", "E203", "unknown key"),
        (
            "gears.module",
            "1.8",
            "E204",
            "gears.module: 1.8 has no unit",
        ),
        ("gears.module", "1.8 kg", "E204", "not a unit of length"),
        ("gears.teeth", "[1]", "E204", "gears.teeth"),
        ("gears", "3", "E204", "gears"),
        ("model.film", "thick", "E204", "unknown choice `thick`"),
        ("model.positions", "-3", "E204", "whole number"),
        ("title.more", "x", "E204", "title"),
        (
            "surface.pinion.columns",
            "[1, 2]",
            "E204",
            "a list does not fit, expected a table",
        ),
    ] {
        let mut changed = case.clone();
        let error = changed.set(path, value).unwrap_err();
        assert_eq!(error.code(), code, "{path}: {error}");
        assert!(error.to_string().contains(says), "{path}: {error}");
        assert_eq!(changed, case, "{path}");
    }
    let mut changed = case.clone();
    assert_eq!(changed.unset("gears.module").unwrap_err().code(), "E204");
    assert_eq!(changed.unset("gears.modul").unwrap_err().code(), "E203");
}

#[test]
fn a_changed_case_is_the_case_that_says_so() {
    let case = e_drive();
    let changed = case.with_key("operation.torque", "200 N m").unwrap();
    let written = text("e-drive.toml").replace("145 N m", "200 N m");
    let resolver = |name: &str| std::fs::read(fixtures().join("cases").join(name));
    let expected = from_text("e-drive.toml", &written, &resolver).unwrap();
    assert_eq!(loss(&changed), loss(&expected));
    let smoother = case.with_key("surface.cutoff", "0.08 mm").unwrap();
    assert_ne!(smoother.surfaces, case.surfaces);
    let error = case
        .with(|input| input.model.window = Some(0.0))
        .unwrap_err();
    assert_eq!(error.code(), "E209");
    assert_eq!(error.place().unwrap().key.as_deref(), Some("model.window"));
    assert_eq!(error.place().unwrap().line, None);
}

#[test]
fn errors_carry_code_place_and_remedy_as_data() {
    let bad = text("e-drive.toml").replace("\"1.8 mm\"", "\"-1.8 mm\"");
    let error = from_text("bad.toml", &bad, &|name| {
        std::fs::read(fixtures().join("cases").join(name))
    })
    .unwrap_err();
    assert_eq!(error.code(), "E209");
    let place = error.place().unwrap();
    assert_eq!(place.file, "bad.toml");
    assert_eq!(place.key.as_deref(), Some("gears.module"));
    let line = 1 + bad
        .lines()
        .position(|line| line.starts_with("module"))
        .unwrap();
    assert_eq!((place.line, place.column), (Some(line), Some(10)));
    assert_eq!(&bad[place.span.clone().unwrap()], "\"-1.8 mm\"");
    assert_eq!(error.text().unwrap().text(), bad);
    let _: &dyn std::error::Error = &error;

    let heights: String = (0..4000).map(|i| format!("{}.5\n", i % 7)).collect();
    let input = e_drive().case.input.clone();
    let error = Case::builder(input.gears, input.operation, input.lubricant)
        .pinion(Trace::from_bytes("z.txt", heights, ReadOptions::default()))
        .build()
        .unwrap_err();
    assert_eq!(error.code(), "E110");
    let remedy = error.remedy();
    assert!(
        matches!(remedy.actions(), [Action::Set { settings, .. }] if settings[..] == [Setting::Spacing]),
        "{remedy:?}"
    );
    assert_eq!(
        error.place().unwrap().key.as_deref(),
        Some("surface.pinion.file")
    );
    assert!(error.place().unwrap().line.is_none());
}

#[test]
fn traces_that_cannot_be_are_refused_when_they_are_made() {
    let good = vec![1e-7; 200];
    let dx = Length::from_si(0.5e-6);
    assert!(Trace::from_heights(&good, dx).is_ok());
    let code = |heights: &[f64], dx| Trace::from_heights(heights, dx).unwrap_err().code();
    assert_eq!(code(&good[..99], dx), "E106");
    assert_eq!(code(&good, Length::from_si(0.5)), "E116");
    assert_eq!(code(&good, Length::from_si(f64::NAN)), "E116");
    let mut bad = good.clone();
    bad[7] = f64::NAN;
    assert_eq!(code(&bad, dx), "E116");
}

#[test]
fn losses_have_the_warnings_of_a_run() {
    let hot = e_drive()
        .with_key("operation.bulk_temperature", "250 °C")
        .unwrap();
    let few = hot
        .with(|input| {
            input.model.positions = Some(6);
            input.model.offsets = Some(2);
        })
        .unwrap();
    let losses = crate::runs::losses(&few).unwrap();
    let run = asperity::Run::new(&few).pictures(Kept::NoPictures);
    let run = run
        .interval(false)
        .execute()
        .unwrap()
        .into_only()
        .unwrap()
        .result;
    assert!(run.warnings.len() > few.warnings.len());
    assert_eq!(losses.warnings, run.warnings);
}
