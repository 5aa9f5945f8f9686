//! `asperity profile change`: traces before and after a test, and pairs that are refused.

use crate::bench::{Bench, E_DRIVE};

#[test]
fn a_worn_trace_is_placed_and_its_loss_is_the_height_that_was_cut() {
    let bench = Bench::new();
    bench.write_flanks();
    let expected = bench.write_worn("pinion.csv", "worn.csv");
    let line = ["profile", "change", "pinion.csv", "worn.csv"];
    let said = bench.run(&[&line[..], &["--no-output"]].concat()).well();
    let text = said.unwrapped();
    assert!(text.contains("The test removed "), "{text}");
    assert!(text.contains("Changed by more than noise: Ra -"), "{text}");
    let json = bench
        .run(&[&line[..], &["--json", "--no-output"]].concat())
        .json();
    let removed = json["mean"]["removed_nm"].as_f64().unwrap();
    assert!((removed - expected).abs() < 0.5, "{removed} {expected}");
    let shift = json["pairs"][0]["shift_um"].as_f64().unwrap();
    assert!((shift - 150.0).abs() < 0.01, "{shift}");
    // Two pairs of one kind, and their mean.
    bench.write_worn("wheel.csv", "worn_wheel.csv");
    let more = ["wheel.csv", "worn_wheel.csv", "--no-output"];
    let both = bench.run(&[&line[..], &more].concat()).well().unwrapped();
    assert!(both.contains("From pair to pair it scatters by "), "{both}");
}

#[test]
fn a_trace_on_itself_lost_nothing() {
    let bench = Bench::new();
    bench.write_flanks();
    let said = bench
        .run(&[
            "profile",
            "change",
            "pinion.csv",
            "pinion.csv",
            "--no-output",
        ])
        .well()
        .unwrapped();
    assert!(
        said.contains("Nothing was removed within the noise floor"),
        "{said}"
    );
    assert!(
        said.contains("No roughness parameter changed by more than its noise floor."),
        "{said}"
    );
}

#[test]
fn a_bow_after_the_test_is_undecided_until_the_form_is_stated() {
    let bench = Bench::new();
    bench.write_flanks();
    let expected = bench.write_worn("pinion.csv", "worn.csv");
    let text = std::fs::read_to_string(bench.path("worn.csv")).unwrap();
    let (header, rows) = text.split_once('\n').unwrap();
    let count = rows.lines().count() as f64;
    let bowed = rows.lines().enumerate().map(|(i, row)| {
        let (x, z) = row.split_once(',').unwrap();
        let z = z.parse::<f64>().unwrap() + 0.4 * (2.0 * i as f64 / count - 1.0).powi(2);
        format!("{x},{z:.5}\n")
    });
    bench.write(
        "bowed.csv",
        format!("{header}\n{}", bowed.collect::<String>()),
    );
    let change =
        |more: &[&str]| bench.run(&[&["profile", "change"], more, &["--no-output"]].concat());
    let said = change(&["pinion.csv", "bowed.csv"]).well().unwrapped();
    assert!(
        said.contains("Inconclusive: ") && said.contains("state form = poly2"),
        "{said}"
    );
    assert!(!said.contains("Nothing was removed"), "{said}");
    let line = ["pinion.csv", "bowed.csv", "--form", "poly2"];
    let said = change(&line).well().unwrapped();
    assert!(said.contains("The test removed "), "{said}");
    let json = change(&[&line[..], &["--json"]].concat()).json();
    let removed = json["mean"]["removed_nm"].as_f64().unwrap();
    assert!((removed - expected).abs() < 0.6, "{removed} {expected}");
    let bow = json["pairs"][0]["bow_um"].as_f64().unwrap();
    assert!((bow + 0.4).abs() < 0.01, "{bow}");
    change(&["pinion.csv", "bowed.csv", "--form", "circle"]).refused(2, "E205", &["form: "]);
    // Both traces in the other order.
    let said = change(&["worn.csv", "pinion.csv"]).well().unwrapped();
    assert!(
        said.contains("Are the traces in the other order?"),
        "{said}"
    );
    assert!(!said.contains("Material moved"), "{said}");
}

#[test]
fn feed_marks_without_a_difference_are_refused_with_all_places() {
    let bench = Bench::new();
    let marks = |begin: usize| {
        let height = |i: usize| 0.6 * (std::f64::consts::TAU * (begin + i) as f64 / 200.0).cos();
        let row = |i: usize| format!("{:.1},{:.5}\n", 0.5 * i as f64, height(i));
        format!("x [um],z [um]\n{}", (0..6000).map(row).collect::<String>())
    };
    bench.write("before.csv", marks(0));
    bench.write("after.csv", marks(60));
    for bound in ["0.5 mm", "0.04 mm"] {
        let line = [
            "profile",
            "change",
            "before.csv",
            "after.csv",
            "--max-shift",
            bound,
        ];
        let said = bench.run(&line);
        said.refused(2, "E143", &["several places alike", "-170, -70, 30, 130"]);
        assert!(!said.err.contains("Mirror"), "{}", said.err);
    }
}

#[test]
fn pairs_that_cannot_be_compared_are_refused() {
    let bench = Bench::new();
    bench.write_flanks();
    bench.write("case.toml", E_DRIVE);
    let refused = |more: &[&str], code: &str, says: &str| {
        let line = [
            "profile",
            "change",
            "pinion.csv",
            "wheel.csv",
            "--no-output",
        ];
        bench
            .run(&[&line[..], more].concat())
            .refused(2, code, &[says]);
    };
    refused(
        &[],
        "E143",
        "pinion.csv, wheel.csv: not the same place: the valleys of both traces correlate by ",
    );
    refused(
        &["pinion.csv"],
        "E205",
        "pinion.csv: the trace has no second one",
    );
    refused(
        &["--set", "operation.torque=1 N m"],
        "E205",
        "--set and --mesh change a case",
    );
    refused(
        &["--engagements", "1e6"],
        "E205",
        "engagements: load, sliding and loss follow",
    );
    refused(
        &["--flank", "wheel"],
        "E205",
        "flank: load, sliding and loss follow",
    );
    refused(
        &["--case", "case.toml", "--engagements", "-3"],
        "E209",
        "engagements = -3: must be above 0",
    );
    refused(
        &["--leave-out"],
        "E143",
        "no pair of traces is of one place that is certain",
    );
    refused(
        &["--max-stretch", "20 %"],
        "E209",
        "--max-stretch = 0.2: must be from 0 to 0.05",
    );
}

#[test]
#[ignore = "slow: just test-all"]
fn slow_with_a_case_the_loss_of_height_has_a_wear_coefficient_and_a_paired_difference() {
    let bench = Bench::new();
    bench.write_flanks();
    let expected = bench.write_worn("pinion.csv", "worn.csv");
    bench.write("case.toml", E_DRIVE);
    let traces = [
        "profile",
        "change",
        "pinion.csv",
        "worn.csv",
        "pinion.csv",
        "wheel.csv",
    ];
    let case = [
        "--leave-out",
        "--case",
        "case.toml",
        "--set",
        "model.offsets=4",
        "--engagements",
        "1e6",
        "--no-output",
    ];
    let line = [&traces[..], &case].concat();
    let said = bench.run(&line).well();
    let text = said.unwrapped();
    assert!(
        text.contains("W455 pinion.csv, wheel.csv is left out: not the same place"),
        "{text}"
    );
    assert!(
        text.contains(
            "The pinion changed: in the mean over the trace, wherever it lies, a point slides "
        ),
        "{text}"
    );
    assert!(
        text.contains("m in 1e6 engagements. Archard's wear coefficient k is "),
        "{text}"
    );
    assert!(
        text.contains("he flanks after the test ")
            && text.contains("The flanks before the test lose "),
        "{text}"
    );
    let json = bench.run(&[&line[..], &["--json"]].concat()).json();
    let (flank, difference) = (
        &json["in_case"]["flanks"][0],
        &json["in_case"]["difference"],
    );
    let number = |of: &serde_json::Value| of.as_f64().unwrap();
    // Archard: the height over engagements, mean pressure and sliding distance, within the interval of an unknown place.
    let k = number(&flank["k_mm3_per_n_m"]);
    let low = number(&flank["k_quantiles_mm3_per_n_m"][0]);
    assert!(low < k && low > 0.0, "{flank}");
    let pressure = 1e-9 * expected / (1e6 * 1e-6 * number(&flank["sliding_um"]) * 1e-9 * k);
    assert!((0.2e9..2e9).contains(&pressure), "{pressure}");
    // Both runs share what they have in common.
    let rho = |name: &str| {
        let rows = difference["common"].as_array().unwrap();
        number(&rows.iter().find(|row| row["name"] == name).unwrap()["correlation"])
    };
    assert!(
        (0.5..1.0).contains(&rho("error of the model")),
        "{difference}"
    );
    assert!(
        rho("sampling of the flanks") > 0.2 && rho("boundary friction") == 1.0,
        "{difference}"
    );
    // A trace on itself: no loss, no difference.
    let same = ["profile", "change", "pinion.csv", "pinion.csv"];
    let text = bench.run(&[&same[..], &case].concat()).well().unwrapped();
    assert!(
        text.contains("k is at most ")
            && text.contains(
                "With the flanks after the test the loss is exactly as with the flanks before it"
            ),
        "{text}"
    );
}
