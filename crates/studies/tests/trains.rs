//! Maps and cycles of gear trains, against runs of the train and maps of its meshes.

#![allow(clippy::unwrap_used, clippy::panic, reason = "tests may panic")]

use asperity::Run;
use std::path::Path;

use asperity::case::Source;
use asperity::case::Train;
use asperity::pipeline::Kept;
use asperity::train::Whole;
use asperity::uncertainty::Verdict;
use asperity_report::StudyResult as _;
use asperity_storage::whole_text;
use asperity_studies::compare::{Finish, FinishResult, compare, difference_with_interval};
use asperity_studies::cycle::{cycle, evaluate};
use asperity_studies::export::Field;
use asperity_studies::map::{Axes, Map, MapBand, Point, map, read};
use asperity_studies::sweep::{Cases, Study};

const TWO_STAGES: &str = r#"
title = "two stages"
train.input = "motor"
mesh.first = { shafts = ["motor", "counter"], gears = { teeth = [23, 68], module = "1.8 mm", face_width = "32 mm", helix = "23.4 deg" } }
mesh.second = { shafts = ["counter", "output"], gears = { teeth = [25, 61], module = "2.5 mm", face_width = "40 mm" } }
vehicle = { mass = "1500 kg", wheel_radius = "300 mm", ratio = 7.2, drag_area = "0.6 m2", rolling_resistance = 0.01 }
"#;
/// A set whose ring turns, after a pair: its speeds are not proportional to the speed of the input.
const SET: &str = r#"
title = "pair and set"
train.input = "motor"
mesh.pair = { shafts = ["motor", "sun"], gears = { teeth = [23, 68], module = "1.8 mm", face_width = "32 mm" } }
mesh.set = { shafts = ["sun", "output"], planetary = { teeth = [27, 24, -75], planets = 3, module = "1.5 mm", face_width = ["20 mm", "20 mm", "20 mm"], ring_speed = "50 rad/s" } }
"#;
const COMMON: &str = r#"
operation = { torque = "60 N m", speed = "4000 1/min", bulk_temperature = "90 °C" }
lubricant.oil = "m100"
surface = { pinion.file = "ground_pinion.csv", wheel = { file = "ground_wheel.csv", mirrored = true }, cutoff = "0.25 mm" }
model = { positions = 4, offsets = 1, depths = 0 }
"#;

fn train(text: &str, keys: &[(&str, &str)]) -> Train {
    let text = format!("{text}{COMMON}");
    let source = Source::from_bytes("train.toml", text.as_bytes()).unwrap();
    let keys = keys
        .iter()
        .map(|(key, value)| ((*key).to_owned(), (*value).to_owned()));
    let folder = Path::new("../../fixtures/profiles");
    Train::load_set(source, folder, &keys.collect::<Vec<_>>(), &|_| {}).unwrap()
}

/// With a band at one temperature, for time.
fn map_of(case: Train, torques: &[f64], band: MapBand) -> Map {
    let temperatures: &[f64] = match band {
        MapBand::None => &[60.0, 90.0],
        _ => &[90.0],
    };
    let axes = Axes::new(torques, &[1000.0, 4000.0], temperatures).unwrap();
    let name = "ground".to_owned();
    map(&[Finish { name, case }], &axes, band, &|_, _| {}).unwrap()
}

fn at(map: &Map, torque: f64) -> &Point {
    let mut points = map.finishes[0].points.iter();
    let place = [torque, 4000.0, 90.0];
    let is_there =
        |point: &&Point| [point.torque_nm, point.speed_rpm, point.temperature_c] == place;
    points.find(is_there).unwrap()
}

fn run(case: &Train, band: bool) -> Whole {
    let found = Run::new(case)
        .pictures(Kept::Highest)
        .interval(band)
        .execute();
    found.unwrap().whole
}

#[test]
fn the_meshes_of_a_map_run_in_at_their_parts_of_the_torque_of_the_input_shaft() {
    let keys = [
        ("operation.running_in.torque", "90 N m"),
        ("operation.running_in.engagements", "4"),
    ];
    let case = train(TWO_STAGES, &keys);
    let found = map_of(case.clone(), &[60.0], MapBand::None);
    let run = Run::new(&case)
        .pictures(Kept::NoPictures)
        .execute()
        .unwrap();
    let meshes = run.meshes.iter();
    let of_meshes = meshes.map(|mesh| mesh.result.run_in.as_ref().unwrap().summary.loss_w);
    let ratio = at(&found, 60.0).numbers.unwrap().loss_w / of_meshes.sum::<f64>();
    assert!((ratio - 1.0).abs() < 1e-9, "{ratio}");
}

#[test]
fn a_point_of_the_map_of_a_train_is_its_run_with_loss_parts_efficiency_and_band() {
    let case = train(TWO_STAGES, &[]);
    let found = map_of(case.clone(), &[60.0], MapBand::Nodes);
    let run = run(&case, true);
    let numbers = at(&found, 60.0).numbers.unwrap();
    let drawn = run.loss_distribution.unwrap();
    let [low, high] = numbers.drawn_w.unwrap().ends();
    let pairs = [
        (numbers.loss_w, run.loss_w),
        (numbers.efficiency.unwrap(), run.efficiency),
        (numbers.film_w, run.kinds.film_w),
        (
            numbers.loss_at_medians_w.unwrap(),
            run.loss_at_medians_w.unwrap(),
        ),
        (numbers.drawn_w.unwrap().value, drawn.drawn.value),
        (low, drawn.drawn.low),
        (high, drawn.drawn.high),
    ];
    assert!(
        pairs.iter().all(|(a, b)| (a / b - 1.0).abs() < 1e-12),
        "{pairs:?}"
    );
    let ratio = found.ratio.unwrap();
    assert!((ratio / (68.0 / 23.0 * 61.0 / 25.0) - 1.0).abs() < 1e-14);
    // The parts of the meshes add up at every point.
    let finish = &found.finishes[0];
    for (index, point) in finish.points.iter().enumerate() {
        let parts: Option<f64> = finish
            .meshes
            .iter()
            .map(|mesh| mesh.loss_torque_nm[index])
            .sum();
        let whole = point.numbers.unwrap().loss_torque_nm;
        assert!((parts.unwrap() / whole - 1.0).abs() < 1e-12);
    }
}

#[test]
fn a_map_of_a_train_is_the_sum_of_the_maps_of_its_meshes() {
    let case = train(TWO_STAGES, &[]);
    let found = map_of(case.clone(), &[-60.0, 60.0], MapBand::None);
    let mut sums = [0.0; 2];
    for (mesh, turns) in case.meshes().zip([1.0, 23.0 / 68.0]) {
        let torque = mesh.case.case.torque.si();
        let axes = Axes::new(&[-torque, torque], &[4000.0 * turns], &[90.0]).unwrap();
        let name = mesh.name.clone();
        let single = Finish {
            name,
            case: mesh.case.clone(),
        };
        let single = map(&[single], &axes, MapBand::None, &|_, _| {}).unwrap();
        for (sum, torque) in sums.iter_mut().zip([-torque, torque]) {
            let mut points = single.finishes[0].points.iter();
            let there = points.find(|point| point.torque_nm == torque && point.speed_rpm > 0.0);
            *sum += there.unwrap().numbers.unwrap().loss_w;
        }
    }
    for (sum, torque) in sums.into_iter().zip([-60.0, 60.0]) {
        // The speed of the second mesh is rounded otherwise.
        let loss = at(&found, torque).numbers.unwrap().loss_w;
        assert!((loss / sum - 1.0).abs() < 1e-12, "{loss} {sum}");
    }
    // The output drives: the power in is larger by the loss than the stated one.
    let numbers = at(&found, -60.0).numbers.unwrap();
    let stated = 60.0 * 4000.0 * std::f64::consts::PI / 30.0;
    let expected = 1.0 - numbers.loss_w / (stated + numbers.loss_w);
    assert!((numbers.efficiency.unwrap() - expected).abs() < 1e-12);
}

#[test]
fn a_set_whose_ring_turns_has_the_loss_and_the_efficiency_of_its_run() {
    let case = train(SET, &[]);
    let found = map_of(case.clone(), &[60.0], MapBand::None);
    let run = run(&case, false);
    let numbers = at(&found, 60.0).numbers.unwrap();
    assert!((numbers.loss_w / run.loss_w - 1.0).abs() < 1e-12);
    assert!((numbers.efficiency.unwrap() - run.efficiency).abs() < 1e-12);
    let counts: Vec<u32> = found.finishes[0]
        .meshes
        .iter()
        .map(|mesh| mesh.count)
        .collect();
    assert_eq!(counts, [1, 3, 3]);
    // Two shafts turn whose torque follows.
    assert_eq!(found.ratio, None);
}

/// The train with other flanks of the mesh `on`, or of all meshes.
fn superfinished(case: &Train, on: Option<&str>) -> Finish<Train> {
    let file = |name: &str| Path::new(name).to_owned();
    let (pinion, wheel) = (file("superfinished.csv"), file("superfinished_wheel.csv"));
    let changed = case.with_each(&|_, mesh, input| {
        if on.is_none_or(|on| on == mesh) {
            input.surface.put_traces(&pinion, Some(&wheel));
        }
    });
    Finish {
        name: "fine".to_owned(),
        case: changed.unwrap(),
    }
}

#[test]
fn a_comparison_of_a_train_has_the_losses_of_its_runs_and_the_differences_of_its_meshes() {
    let case = train(TWO_STAGES, &[]);
    let ground = Finish {
        name: "ground".to_owned(),
        case: case.clone(),
    };
    let same = Finish {
        name: "same".to_owned(),
        ..ground.clone()
    };
    let (all, second) = (
        superfinished(&case, None),
        superfinished(&case, Some("second")),
    );
    let found = compare(&[ground, all.clone(), second, same], &|_, _| {}).unwrap();
    let [first, fine, one, same] = &found.finishes[..] else {
        panic!("{found:?}")
    };
    let run_of_all = run(&all.case, true);
    assert_eq!(
        (fine.loss_w, fine.efficiency),
        (run_of_all.loss_w, run_of_all.efficiency)
    );
    assert_eq!(fine.loss_distribution, run_of_all.loss_distribution);
    for finish in &found.finishes {
        let sum: f64 = finish.meshes.iter().map(|mesh| mesh.loss_w).sum();
        assert!((sum / finish.loss_w - 1.0).abs() < 1e-14);
    }
    let of = |finish: &FinishResult| finish.difference.clone().unwrap();
    let whole = of(fine);
    let at_medians = |of: &FinishResult| of.loss_at_medians_w.unwrap();
    assert!((whole.at_medians_w - (at_medians(fine) - at_medians(first))).abs() < 1e-9);
    let meshes = fine
        .meshes
        .iter()
        .map(|mesh| mesh.difference.clone().unwrap());
    let sum: f64 = meshes.map(|mesh| mesh.at_medians_w).sum();
    assert!((sum - whole.at_medians_w).abs() < 1e-9);
    assert!(
        whole.watts.value < 0.0 && whole.models.len() > 3,
        "{whole:?}"
    );
    // The other mesh cancels draw by draw.
    let [kept, changed] = [0, 1].map(|k| one.meshes[k].difference.clone().unwrap());
    assert_eq!(
        (kept.verdict, kept.watts.ends()),
        (Verdict::Equal, [0.0; 2])
    );
    let of_train = of(one);
    for (own, of_mesh) in of_train.watts.ends().iter().zip(changed.watts.ends()) {
        assert!((own / of_mesh - 1.0).abs() < 1e-9, "{own} {of_mesh}");
    }
    assert_eq!(of(same).verdict, Verdict::Equal);
    // A difference that is exactly 0 has no interval.
    assert_eq!(difference_with_interval(&of(same)), ["0", "0"]);
    // Its summary, its page and its tables.
    let summary = found.summary();
    assert!(
        summary.contains("second, fine") && found.verdicts().len() == 3,
        "{summary}"
    );
    let folder = tempfile::tempdir().unwrap();
    found.write(&folder.path().join("compare")).unwrap();
    let rows = whole_text(&folder.path().join("compare/meshes.csv"), 100_000).unwrap();
    assert_eq!(
        rows.lines().filter(|row| !row.starts_with('#')).count(),
        1 + 4 * 2,
        "{rows}"
    );
}

#[test]
fn a_comparison_of_a_set_counts_its_equal_meshes() {
    let case = train(SET, &[]);
    let ground = Finish {
        name: "ground".to_owned(),
        case: case.clone(),
    };
    let found = compare(&[ground, superfinished(&case, None)], &|_, _| {}).unwrap();
    let fine = &found.finishes[1];
    assert_eq!(
        fine.meshes
            .iter()
            .map(|mesh| mesh.count)
            .collect::<Vec<_>>(),
        [1, 3, 3]
    );
    let of_meshes = fine.meshes.iter().map(|mesh| {
        let difference = mesh.difference.as_ref().unwrap();
        f64::from(mesh.count) * difference.at_medians_w
    });
    let whole = fine.difference.as_ref().unwrap().at_medians_w;
    assert!((of_meshes.sum::<f64>() / whole - 1.0).abs() < 1e-12);
    let [ground, fine] = [0, 1].map(|k: usize| found.finishes[k].loss_at_medians_w.unwrap());
    assert!((whole / (fine - ground) - 1.0).abs() < 1e-9);
}

#[test]
fn a_sweep_of_a_train_has_the_numbers_of_its_runs() {
    let case = train(TWO_STAGES, &[]);
    let study = r#"{
        "axis": [
            { "key": "mesh.second.gears.face_width", "values": ["40 mm", "50 mm"] },
            { "key": "operation.speed", "values": ["3000 1/min", "4000 1/min"] }
        ],
        "columns": ["loss_w", "efficiency", "film_w", "loss_p95_w", "mesh.first.loss_w", "mesh.second.loss_w",
            "mesh.first.loss_at_medians_w", "mesh.second.loss_at_medians_w"]
    }"#;
    let cases = Cases::new(Study::of_case(case.clone(), study, Path::new(".")).unwrap()).unwrap();
    let rows = cases.rows(0..cases.count()).unwrap();
    assert_eq!(rows.len(), 4);
    let ids: std::collections::BTreeSet<&String> = rows.iter().map(|row| &row[1]).collect();
    assert_eq!(ids.len(), 4);
    let keys = [
        ("mesh.second.gears.face_width", "50 mm"),
        ("operation.speed", "3000 1/min"),
    ];
    let of_run = run(&train(TWO_STAGES, &keys), true);
    let row = &rows[2];
    assert_eq!((row[2].as_str(), row[3].as_str()), ("50 mm", "3000 1/min"));
    let found: Vec<f64> = row[4..10]
        .iter()
        .map(|cell| cell.parse().unwrap())
        .collect();
    let expected = [
        of_run.loss_w,
        of_run.efficiency,
        of_run.kinds.film_w,
        of_run.loss_distribution.unwrap().drawn.high,
        of_run.meshes[0].loss_w,
        of_run.meshes[1].loss_w,
    ];
    for (found, expected) in found.iter().zip(expected) {
        assert!((found / expected - 1.0).abs() < 1e-12, "{row:?} {expected}");
    }
    assert!((found[4] + found[5] - found[0]).abs() < 1e-9);
    assert_eq!(row[13], "");
    // Only the second mesh has another face.
    assert_eq!(rows[0][10], rows[2][10]);
    assert_ne!(rows[0][11], rows[2][11]);
    // The draws of a mesh without a column of the train's.
    let study = r#"{ "axis": [{ "key": "mesh.second.gears.face_width", "values": ["50 mm"] },
            { "key": "operation.speed", "values": ["3000 1/min"] }],
        "columns": ["mesh.first.loss_at_medians_w"] }"#;
    let cases = Cases::new(Study::of_case(case, study, Path::new(".")).unwrap()).unwrap();
    let median: f64 = cases.rows(0..1).unwrap()[0][4].parse().unwrap();
    let expected = of_run.meshes[0].loss_at_medians_w.unwrap();
    assert!(
        (median / expected - 1.0).abs() < 1e-12,
        "{median} {expected}"
    );
}

#[test]
fn a_sweep_of_a_train_takes_its_losses_passed_on_and_names_what_it_refuses() {
    let keys = [("train.losses", "passed-on")];
    let study =
        r#"{ "axis": [{ "key": "mesh.first.gears.module", "values": ["1.8 mm", "9 mm"] }] }"#;
    let case = train(TWO_STAGES, &keys);
    let lost = run(&case, false).loss_w;
    let cases = Cases::new(Study::of_case(case, study, Path::new(".")).unwrap()).unwrap();
    let header = cases.header();
    assert_eq!(header.last().unwrap(), "code");
    assert!(
        header.contains(&"mesh.first.loss_w".to_owned()),
        "{header:?}"
    );
    let rows = cases.rows(0..2).unwrap();
    let column = header.iter().position(|name| name == "loss_w").unwrap();
    let found: f64 = rows[0][column].parse().unwrap();
    assert!((found / lost - 1.0).abs() < 1e-12, "{found} {lost}");
    // Teeth of 9 mm have the place of their axes.
    assert!(rows[1].iter().all(|cell| cell != "NaN"), "{rows:?}");
    let unknown = r#"{ "axis": [{ "key": "mesh.third.gears.module", "values": ["1.8 mm"] }] }"#;
    let case = train(TWO_STAGES, &[]);
    let cases = Cases::new(Study::of_case(case, unknown, Path::new(".")).unwrap()).unwrap();
    let row = &cases.rows(0..1).unwrap()[0];
    assert!(row.last().unwrap().starts_with("E2"), "{row:?}");
}

/// Largest differences of the losses of a map with losses passed on from runs at its points, relative to them: of all meshes, of
/// each mesh, and of a map with torques by the tooth numbers.
fn off_runs(text: &str, keys: &[(&str, &str)]) -> [f64; 3] {
    let passed = [&[("train.losses", "passed-on")], keys].concat();
    let found = map_of(train(text, &passed), &[-60.0, 60.0], MapBand::None);
    let without = map_of(train(text, keys), &[-60.0, 60.0], MapBand::None);
    let mut largest = [0.0_f64; 3];
    let mut off = |k: usize, value: f64, run: f64| {
        largest[k] = largest[k].max((value / run - 1.0).abs());
    };
    for (index, point) in found.finishes[0].points.iter().enumerate() {
        // Slow and cold, or fast and hot.
        let is_one = (point.speed_rpm == 1000.0) == (point.temperature_c == 60.0);
        if point.torque_nm == 0.0 || point.speed_rpm == 0.0 || !is_one {
            continue;
        }
        let torque = format!("{} N m", point.torque_nm);
        let speed = format!("{} 1/min", point.speed_rpm);
        let temperature = format!("{} °C", point.temperature_c);
        let there = [
            ("operation.torque", torque.as_str()),
            ("operation.speed", speed.as_str()),
            ("operation.bulk_temperature", temperature.as_str()),
        ];
        let run = run(&train(text, &[&passed[..], &there[..]].concat()), false);
        let numbers = point.numbers.unwrap();
        off(0, numbers.loss_w, run.loss_w);
        let by_teeth = without.finishes[0].points[index].numbers.unwrap();
        off(2, by_teeth.loss_w, run.loss_w);
        let power_w = numbers.loss_w / (1.0 - numbers.efficiency.unwrap());
        assert!((power_w / run.power_in_w - 1.0).abs() < 1e-3, "{point:?}");
        let omega = point.speed_rpm * std::f64::consts::PI / 30.0;
        for (part, mesh) in found.finishes[0].meshes.iter().zip(&run.meshes) {
            let loss = part.loss_torque_nm[index].unwrap() * omega;
            off(1, loss, f64::from(mesh.count) * mesh.loss_w);
        }
    }
    largest
}

#[test]
fn a_map_with_losses_passed_on_has_the_losses_of_runs_at_its_points() {
    let values = [
        (
            "surface",
            r#"{ pinion = { rq = "0.3 um", asperity_radius = "50 um" } }"#,
        ),
        ("model.load_share", "zhu-hu"),
    ];
    for text in [TWO_STAGES, SET] {
        // Flanks known by their values: no windows of traces, so that only the line between both torques differs.
        let [whole, of_meshes, by_teeth] = off_runs(text, &values);
        assert!(whole < 5e-6 && of_meshes < 2e-5, "{whole} {of_meshes}");
        assert!(by_teeth > 3e-3, "{by_teeth}");
        // Windows of other widths, one offset: 10 % standard error of a loss.
        let [whole, of_meshes, _] = off_runs(text, &[]);
        assert!(whole < 0.01 && of_meshes < 0.02, "{whole} {of_meshes}");
    }
}

#[test]
fn a_cycle_on_the_map_of_a_train_loses_its_loss_times_the_time() {
    let case = train(TWO_STAGES, &[("model.offsets", "2")]);
    let found = map_of(case, &[0.0, 60.0], MapBand::Nodes);
    // The map as written and read again.
    let folder = tempfile::tempdir().unwrap();
    let folder = folder.path().join("map");
    found.write(&folder).unwrap();
    let found = read(&folder).unwrap();
    let summary = found.summary();
    assert!(summary.contains("\nground  first "), "{summary}");
    let text = "time_s,torque_nm,speed_rpm\n0,60,4000\n1800,60,4000\n3600,60,4000\n";
    let constant = cycle(text, None).unwrap();
    let energies = evaluate(&found.clone().into(), 0, &constant, "constant", false).unwrap();
    let numbers = at(&found, 60.0).numbers.unwrap();
    let finish = &energies.finishes[0];
    let at_medians = [finish.lost_at_medians_wh, numbers.loss_at_medians_w].map(Option::unwrap);
    assert!((at_medians[0] / at_medians[1] - 1.0).abs() < 1e-12);
    // The draws are common to the cycle, the sampling less so, which moves the median little.
    assert!(
        (finish.lost_wh / numbers.loss_w - 1.0).abs() < 2e-3,
        "{} {}",
        finish.lost_wh,
        numbers.loss_w
    );
    let [low, high] = numbers.drawn_w.unwrap().ends();
    let [low_wh, high_wh] = finish.lost_drawn_wh().unwrap().ends();
    assert!(low_wh > 0.99 * low && high_wh < 1.01 * high && high_wh - low_wh > 0.8 * (high - low));
    // Without torque there is no power of which the loss is a share.
    let idle = map_of(train(TWO_STAGES, &[]), &[0.0], MapBand::None);
    assert!(!idle.summary().contains("inf"));
    // A vehicle is a table of the train, too.
    let driven = cycle(
        "time_s,speed_km_h\n0,0\n10,20\n20,20\n",
        found.input.vehicle.as_ref(),
    )
    .unwrap();
    assert!(
        evaluate(&found.clone().into(), 0, &driven, "driven", false)
            .unwrap()
            .finishes[0]
            .lost_wh
            > 0.0
    );
}

#[test]
fn seals_and_bearings_are_the_added_part_of_a_map() {
    let bearing = |at: &str| {
        format!(
            r#"{{ shaft = "counter", at = "{at}", kind = "cylindrical-roller", bore = "40 mm", outside_diameter = "80 mm", r1 = 1.09e-6, s1 = 0.16, s2 = 0.0015, k_z = 5.1, k_rs = 3e-8, mu_bl = 0.12, mu_ehl = 0.02, locating = {} }}"#,
            at.starts_with('0')
        )
    };
    let stated = format!(
        r#"{{ seals = [{{ shaft = "output", diameter = "50 mm" }}], bearings = [{}, {}] }}"#,
        bearing("0 mm"),
        bearing("150 mm")
    );
    let keys = [
        ("gearbox", stated.as_str()),
        ("mesh.first.at", "40 mm"),
        ("mesh.first.angle", "0 deg"),
        ("mesh.first.hand", "right"),
        ("mesh.second.at", "110 mm"),
        ("mesh.second.angle", "200 deg"),
    ];
    let case = train(TWO_STAGES, &keys);
    let found = map_of(case.clone(), &[0.0, 60.0], MapBand::None);
    let run = run(&case, false);
    let gearbox = found.gearbox.as_ref().unwrap();
    assert_eq!(gearbox.parts, ["seal 1", "bearing 1", "bearing 2"]);
    let points = &found.finishes[0].points;
    let there = points
        .iter()
        .position(|point| std::ptr::eq(point, at(&found, 60.0)));
    let omega = 4000.0 * std::f64::consts::PI / 30.0;
    let parts = gearbox.loss_torque_nm[there.unwrap()] * omega;
    assert!((parts / run.gearbox.unwrap().parts_w - 1.0).abs() < 1e-12);
    // Exports hold them as the added part, and the meshes stay as they are.
    let fields = Field::all(&found, 0, None).unwrap();
    let across = fields[1].speed_rpm.len();
    let index = fields[1]
        .torque_nm
        .iter()
        .position(|torque| *torque == 60.0)
        .unwrap()
        * across
        + across
        - 1;
    assert_eq!(fields[1].added_nm.as_ref().unwrap()[index], parts / omega);
    assert_eq!(fields[1].mesh_nm[index], run.loss_w / omega);
    assert!(found.summary().contains("W431"));
}
