//! Parallel loops collect their equations and give the same numbers on one thread and on several.

use std::fmt::Debug;
use std::path::Path;

use asperity::case::{LoadedCase, load_with};
use asperity::core::provenance::Provenance;
use asperity::core::task::on_threads;
use asperity::pipeline::{Kept, gradient};
use asperity::{ContactStore, Run};
use asperity_calibration::evidence::standard_plan;
use asperity_calibration::oil::{Machine, OilBase, TractionCurves, TractionRange};
use asperity_studies::compare::{Finish, compare};
use asperity_studies::map::{Axes, MapBand, map};

fn e_drive(keys: &[(&str, &str)]) -> LoadedCase {
    let file = Path::new(env!("CARGO_MANIFEST_DIR")).join("../fixtures/cases/e-drive.toml");
    load_with(&file, &|input| {
        (input.model.positions, input.model.offsets) = (Some(4), Some(2));
        for (key, value) in keys {
            input.set(key, value).unwrap();
        }
    })
    .unwrap()
}

/// `work` gives the same, with the same equations, on one thread and on four; a run has its equations in its result.
fn agrees<T: Debug + Send>(name: &str, work: &(dyn Fn() -> T + Sync)) {
    let on = |count: usize| {
        let used = Provenance::new();
        let found = used.collect(|| on_threads(count, work).unwrap());
        (used.tags(), format!("{found:?}"))
    };
    let ((tags, one), (of_four, four)) = (on(1), on(4));
    assert!(!tags.is_empty(), "{name}");
    assert_eq!(tags, of_four, "{name}");
    assert!(one == four, "{name}");
}

#[test]
fn a_run_and_its_parts() {
    // Flanks that are run in and an interval with its evidence: positions, pictures, points, contacts, passes, samples, curves.
    agrees("run", &|| {
        let case = e_drive(&[("operation.running_in", "{ engagements = 16 }")]);
        let run = Run::new(&case).interval(true).pictures(Kept::Highest);
        let found = run.evidence(&standard_plan).execute().unwrap();
        found.into_only().unwrap().result
    });
    agrees("chosen windows", &|| {
        let case = e_drive(&[])
            .with(|input| input.model.offsets = None)
            .unwrap();
        let losses = Run::new(&case).losses().unwrap().into_only().unwrap();
        (losses.summary, losses.equations)
    });
    agrees("gradient", &|| gradient(&e_drive(&[])).unwrap().by_height);
    agrees("stored contacts", &|| {
        let cases = [e_drive(&[]), e_drive(&[("operation.torque", "160 N m")])];
        let mut store = ContactStore::default();
        store.prepare(&cases.each_ref());
        cases.map(|case| {
            Run::new(&case)
                .known(store.of(&case).as_deref())
                .losses()
                .unwrap()
                .meshes
        })
    });
}

#[test]
fn studies_over_cases() {
    agrees("comparison", &|| {
        let finish = |name: &str, keys: &[(&str, &str)]| Finish {
            name: name.to_owned(),
            case: e_drive(keys),
        };
        let finishes = [
            finish("ground", &[]),
            finish("crossed", &[("model.lay", "1")]),
        ];
        compare(&finishes, &|_, _| {}).unwrap().finishes
    });
    agrees("map", &|| {
        let axes = Axes::new(&[60.0, 145.0], &[4000.0, 9000.0], &[70.0, 90.0]).unwrap();
        let finish = Finish {
            name: "ground".to_owned(),
            case: e_drive(&[]),
        };
        let found = map(&[finish], &axes, MapBand::Nodes, &|_, _| {}).unwrap();
        found
            .finishes
            .into_iter()
            .map(|finish| finish.points)
            .collect::<Vec<_>>()
    });
    agrees("traction curves", &|| {
        let range = TractionRange {
            machine: Machine::ball_on_disc(
                "9.525 mm".parse().unwrap(),
                None,
                "15 nm".parse().unwrap(),
            )
            .unwrap(),
            load: "30 N".parse().unwrap(),
            mean_speed: "2 m/s".parse().unwrap(),
            slide_to_roll: 0.05,
            temperatures: ["40 °C", "80 °C", "120 °C"]
                .map(|text| text.parse().unwrap())
                .to_vec(),
            boundary_friction: 0.09,
        };
        TractionCurves::new(&OilBase::of_library("m100").unwrap(), &range)
            .unwrap()
            .over_slide
    });
}
