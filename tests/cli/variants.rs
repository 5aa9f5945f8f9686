//! Variants of a case in `asperity compare`.

use serde_json::Value;

use crate::bench::{Bench, E_DRIVE};

const FEW: [&str; 2] = ["--set=model.positions=4", "--set=model.offsets=4"];

fn bench() -> Bench {
    let bench = Bench::new();
    bench.write_flanks();
    bench.write("case.toml", E_DRIVE);
    bench.shorten_flanks();
    bench
}

fn compared(bench: &Bench, variants: &[&str]) -> Value {
    let named = variants.iter().flat_map(|text| ["--variant", text]);
    let all = ["compare", "case.toml", "--no-output", "--json"];
    let all: Vec<&str> = all.into_iter().chain(FEW).chain(named).collect();
    bench.run(&all).well().json()
}

fn ends(found: &Value, number: usize) -> [f64; 3] {
    let difference = &found["finishes"][number]["difference"];
    let [low, high] = [0, 1].map(|end| difference["quantiles_w"][end].as_f64().unwrap());
    [low, difference["median_w"].as_f64().unwrap(), high]
}

#[test]
fn two_oils_differ_by_the_draws_of_each_and_their_order_changes_the_sign_only() {
    let bench = bench();
    let oils = ["pao: lubricant.oil=pao100", "mineral: lubricant.oil=m100"];
    let there = compared(&bench, &oils);
    let back = compared(&bench, &[oils[1], oils[0]]);
    let [low, median, high] = ends(&there, 1);
    for (a, b) in [low, median, high]
        .into_iter()
        .zip(ends(&back, 1).into_iter().rev())
    {
        assert!((a + b).abs() < 1e-9 * a.abs(), "{a} {b}");
    }
    assert!(low < median && median < high);
    let common = &there["finishes"][1]["difference"]["common"];
    let rows = common.as_array().unwrap().iter();
    let of =
        |name: &str| rows.clone().find(|row| row["name"] == name).unwrap()["correlation"].as_f64();
    assert_eq!(of("Eyring stress"), Some(0.0));
    assert_eq!(of("boundary friction"), Some(0.0));
    assert_eq!(of("lay"), Some(1.0));
    // Of the same windows: their losses by both oils are nearly in proportion.
    assert!(of("sampling of the flanks") > Some(0.8), "{common}");
    let all = ["compare", "case.toml", "--no-output", "--variant", oils[0]];
    let more = [
        "a: operation.speed=8000 1/min",
        "b: operation.speed=8500 1/min",
    ];
    let more = [
        "--variant",
        oils[1],
        "--variant",
        more[0],
        "--variant",
        more[1],
    ];
    let screen = bench.run(&[&all[..], &FEW, &more].concat()).well().out;
    let has_row = |name: &str| {
        screen
            .lines()
            .any(|line| line.starts_with(&format!("{name}  ")))
    };
    assert!(
        ["pao", "mineral", "a", "b"].into_iter().all(has_row),
        "{screen}"
    );
    // Each oil with its viscosity at 90 °C.
    let oil = |number: usize| {
        let finish = &there["finishes"][number];
        (
            finish["base_oil"].as_str().unwrap(),
            finish["viscosity_mm2_per_s"].as_f64().unwrap(),
        )
    };
    assert_eq!([oil(0).0, oil(1).0], ["pao", "mineral"]);
    let few = ["--no-output", "--variant", oils[0], "--variant", oils[1]];
    let said = bench.run(&[&["compare", "case.toml"][..], &FEW, &few].concat());
    let due = format!(
        "pao: pao, {:.2} mm²/s; mineral: mineral, {:.2} mm²/s.",
        oil(0).1,
        oil(1).1
    );
    assert!(said.well().unwrapped().contains(&due), "{due}");
    // The keys of the oil of the case are left out.
    let changes = &there["finishes"][1]["changes"];
    let keys: Vec<&Value> = changes
        .as_array()
        .unwrap()
        .iter()
        .map(|row| &row["key"])
        .collect();
    assert!(keys.contains(&&"lubricant.oil".into()), "{keys:?}");
    let deciding = there["finishes"][1]["deciding"].as_array().unwrap();
    assert!(
        deciding[0]["width"].as_f64().unwrap() < 0.98,
        "{deciding:?}"
    );
}

#[test]
fn a_single_variant_is_compared_with_the_case_and_an_equal_one_differs_by_nothing() {
    let bench = bench();
    let found = compared(&bench, &["warm: operation.bulk_temperature=110 °C"]);
    assert_eq!(found["finishes"][0]["name"], "as is");
    assert_eq!(found["finishes"][1]["name"], "warm");
    bench.write("keys.toml", "[operation]\nbulk_temperature = \"110 °C\"\n");
    let same = compared(
        &bench,
        &["warm: operation.bulk_temperature=110 °C", "file: keys.toml"],
    );
    assert_eq!(ends(&same, 1), [0.0; 3]);
    assert_eq!(same["finishes"][1]["difference"]["verdict"], "equal");
    let whole = compared(&bench, &["as is", "other=case.toml"]);
    assert_eq!(ends(&whole, 1), [0.0; 3]);
}

#[test]
fn finishes_stand_before_other_variants() {
    let bench = bench();
    let finish = ["--finish", "own=pinion.csv,wheel.csv", "--variant"];
    let command = ["compare", "case.toml", "--no-output"];
    let variant = ["slow: operation.speed=6000 1/min"];
    let said = bench
        .run(&[&command[..], &FEW, &finish, &variant].concat())
        .well()
        .out;
    assert!(
        said.contains("\nvariant ") && said.contains("\nown ") && said.contains("\nslow "),
        "{said}"
    );
}

#[test]
fn what_is_no_variant_is_refused_with_a_way_out() {
    let bench = bench();
    bench.write("empty.toml", "# no keys\n");
    for (variants, code, says, help) in [
        (
            &["x: lubricant.oyl=m100"][..],
            "E203",
            "variant x",
            "Correct the spelling",
        ),
        (&["x"], "E205", "it changes nothing", "\"NAME: KEY=VALUE"),
        (&["x:"], "E205", "it changes nothing", "\"NAME: KEY=VALUE"),
        (
            &["=other.toml"],
            "E205",
            "it has no name",
            "\"NAME: KEY=VALUE",
        ),
        (&["x="], "E205", "it names no case", "\"NAME: KEY=VALUE"),
        (
            &["x: operation.torque=145 N m"],
            "E205",
            "it changes nothing: the case has",
            "\"as is\"",
        ),
        (&["as is"], "E205", "give at least two", ""),
        (
            &["x: model.lay=0.1", "x: model.lay=0.2"],
            "E205",
            "two variants have this name",
            "separated by commas",
        ),
        (
            &["x: model.lay=0.1, model.lay=0.2"],
            "E205",
            "model.lay is set twice",
            "Leave one",
        ),
        (
            &["x: gears.pinion={}, gears.pinion.tip_relief=none"],
            "E205",
            "set the same",
            "Leave one",
        ),
        (&["x: none.toml"], "E103", "none.toml", "KEY=VALUE"),
        (
            &["x: empty.toml"],
            "E205",
            "the file has no keys",
            "\"NAME: KEY=VALUE",
        ),
        (&["x=none.toml"], "E201", "--variant x", ""),
        (
            &["x: lubricant.oil=m1000"],
            "E208",
            "there is no oil \"m1000\"",
            "",
        ),
    ] {
        let named = variants.iter().flat_map(|text| ["--variant", text]);
        let all: Vec<&str> = ["compare", "case.toml", "--no-output"]
            .into_iter()
            .chain(named)
            .collect();
        let said = bench.run(&all);
        assert!(said.err.starts_with(code), "{variants:?}: {}", said.err);
        let (message, advice) = said.err.split_once("\n  help: ").unwrap();
        assert!(message.contains(says), "{message}");
        assert!(advice.contains(help), "{advice}");
    }
}

#[test]
fn a_loss_is_stated_as_people_state_it() {
    let bench = bench();
    let few = [
        "--lots",
        "20",
        "--set=model.positions=2",
        "--set=model.load_share=zhu-hu",
        "--no-output",
    ];
    let of =
        |loss: &str| bench.run(&[&["callout", "case.toml", "--loss", loss][..], &few].concat());
    let said = of("-10 %").well().unwrapped();
    assert!(
        said.contains("(10 % less than flanks like these)"),
        "{said}"
    );
    assert_eq!(of("10 % less").well().unwrapped(), said);
    for (loss, code, says) in [
        ("10 %", "E213", "is neither less nor more; write a power"),
        ("-10 % less", "E213", "both a sign and a word"),
        ("-100 %", "E209", "must be above -100 %"),
        ("-5 W", "E209", "must be positive"),
        ("much", "E213", "write a power"),
    ] {
        let refused = of(loss);
        assert!(
            refused.err.starts_with(code) && refused.err.replace('\n', " ").contains(says),
            "{}",
            refused.err
        );
    }
}

#[test]
fn maps_and_cycles_take_variants_with_the_same_draws_in_common() {
    let bench = bench();
    let oils = [
        "--variant",
        "pao: lubricant.oil=pao100",
        "--variant",
        "mineral: lubricant.oil=m100",
    ];
    let axes = [
        "map",
        "case.toml",
        "--torque",
        "50,145",
        "--speed",
        "3000,9000",
        "-o",
        "map",
    ];
    bench.run(&[&axes[..], &FEW, &oils].concat()).well();
    let map = std::fs::read_to_string(bench.path("map/map.json")).unwrap();
    let map: Value = serde_json::from_str(&map).unwrap();
    assert_eq!(map["are_variants"], true);
    let of_map = &map["finishes"][1]["difference_w"];
    let of_map = ["low", "value", "high"].map(|key| of_map[key].as_f64().unwrap());
    let [low, median, high] = ends(&compared(&bench, &[oils[1], oils[3]]), 1);
    // The largest loss is at the operating point of the case; the map has the same draws there.
    for (a, b) in of_map.into_iter().zip([low, median, high]) {
        assert!(
            (a - b).abs() < 0.05 * (high - low),
            "{of_map:?} {:?}",
            [low, median, high]
        );
    }
    bench.write(
        "cycle.csv",
        "time_s,torque_nm,speed_rpm\n0,100,5000\n1,120,6000\n2,60,8000\n",
    );
    let cycle = bench
        .run(&["cycle", "map", "cycle.csv", "--json", "--no-output"])
        .well()
        .json();
    let names: Vec<&Value> = cycle["finishes"]
        .as_array()
        .unwrap()
        .iter()
        .map(|one| &one["name"])
        .collect();
    assert_eq!(names, ["pao", "mineral"]);
    let text = cycle["finishes"][1].to_string();
    assert!(text.contains("difference"), "{text}");
}

#[test]
fn every_variant_has_its_row_and_its_verdict_on_the_first_screen() {
    let bench = bench();
    let torques = ["a", "b", "c", "d", "e", "f", "g"].into_iter().zip(146..);
    let variants: Vec<String> = torques
        .map(|(name, torque)| format!("{name}: operation.torque={torque} N m"))
        .collect();
    let named = variants.iter().flat_map(|text| ["--variant", text]);
    let first = ["compare", "case.toml", "--no-output", "--variant", "as is"];
    let all: Vec<&str> = first.into_iter().chain(FEW).chain(named).collect();
    let screen = bench.run(&all).well().out;
    for (name, _) in variants.iter().map(|text| text.split_at(1)) {
        let mut rows = screen.lines();
        let row = rows.find(|line| line.starts_with(&format!("{name}  ")));
        let row = row.unwrap_or_else(|| panic!("{name}: {screen}"));
        let verdicts = ["holds", "inconclusive", "exceptions", "no change"];
        assert!(
            verdicts.iter().any(|verdict| row.contains(verdict)),
            "{screen}"
        );
    }
}

#[test]
fn small_changes_have_small_intervals_and_a_stated_constant_shifts_its_median() {
    let bench = bench();
    let law = |at_40: &str| {
        format!(
            "lubricant.viscosity={{ law = \"astm-d341\", at_40 = \"{at_40} mm2/s\", at_100 = \"5.9 mm2/s\" }}"
        )
    };
    let viscous = format!("viscosity: {}", law("30.8001"));
    let found = compared(
        &bench,
        &[
            "as is",
            "torque: operation.torque=145.001 N m",
            "limit: material.pinion.elastic_limit=1501 MPa",
            "cut-off: surface.cutoff=0.2501 mm",
            &viscous,
            "friction: model.boundary_friction=0.09",
            "more: model.boundary_friction=0.1",
        ],
    );
    for number in 1..=4 {
        let [low, _, high] = ends(&found, number);
        assert!(low > -2.0 && high < 2.0, "{number}: {low} {high}");
    }
    // Known in one run and drawn in the other: the shift of the median, and both keep their own intervals.
    let width = |number: usize| {
        let drawn = &found["finishes"][number]["uncertainty"]["loss"]["quantiles_w"];
        drawn[1].as_f64().unwrap() - drawn[0].as_f64().unwrap()
    };
    let [low, median, high] = ends(&found, 5);
    assert!(
        median.abs() < 5.0 && high - low < 0.2 * width(0),
        "{low} {median} {high}"
    );
    assert!(width(5) < 0.9 * width(0));
    let [low, _, high] = ends(&found, 6);
    assert!(low > 0.0, "{low} {high}");
    let common = found["finishes"][5]["difference"]["common"]
        .as_array()
        .unwrap();
    let row = common.iter().find(|row| row["name"] == "boundary friction");
    assert_eq!(row.unwrap()["stated_in_one"], true);
    let variants = [
        "--variant",
        "as is",
        "--variant",
        "friction: model.boundary_friction=0.09",
    ];
    let compare = ["compare", "case.toml", "--no-output"];
    let said = bench.run(&[&compare[..], &FEW, &variants].concat()).well();
    let said = said.unwrapped();
    assert!(
        said.contains("friction: one case states boundary friction"),
        "{said}"
    );
}

#[test]
fn sensitivity_and_comparison_agree_on_cut_offs() {
    let bench = bench();
    let study = ["sensitivity", "case.toml", "--no-output", "--json"];
    let study = bench.run(&[&study[..], &FEW].concat()).well().json();
    let rows = study["rows"].as_array().unwrap();
    let found = compared(
        &bench,
        &[
            "as is",
            "s: surface.noise_cutoff=8 um",
            "c: surface.cutoff=0.08 mm",
        ],
    );
    for (number, to) in [(1, "8 um"), (2, "0.08 mm")] {
        let mut of_filters = rows.iter().filter(|row| row["group"] == "filters");
        let row = of_filters.find(|row| row["to"] == to).unwrap();
        let effect = &row["effect"];
        let own = [
            &effect["quantiles_w"][0],
            &effect["difference_w"],
            &effect["quantiles_w"][1],
        ];
        for (own, other) in own.into_iter().zip(ends(&found, number)) {
            let own = own.as_f64().unwrap();
            assert!((own - other).abs() < 5.0, "{to}: {effect} {other}");
        }
    }
}
