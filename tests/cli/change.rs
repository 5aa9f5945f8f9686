//! `asperity profile change`: traces before and after a test, and pairs that are refused.

use crate::bench::Bench;

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
fn pairs_that_cannot_be_compared_are_refused() {
    let bench = Bench::new();
    bench.write_flanks();
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
        "pinion.csv, wheel.csv: not the same place: the dales of both traces correlate by ",
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
        &["--max-stretch", "20 %"],
        "E209",
        "--max-stretch = 0.2: must be from 0 to 0.05",
    );
}
