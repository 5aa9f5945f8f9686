//! `asperity callout`.

use crate::bench::{Bench, E_DRIVE};

/// A case with few positions and a law of load sharing that needs no contacts, and few lots.
const FEW: [&str; 6] = [
    "--set",
    "model.positions=2",
    "--set",
    "model.load_share=zhu-hu",
    "--lots",
    "20",
];

fn bench() -> Bench {
    let bench = Bench::new();
    bench.write_flanks();
    bench.write("case.toml", E_DRIVE);
    bench.shorten_flanks();
    bench
}

fn call(loss: &'static str, options: &[&'static str]) -> Vec<&'static str> {
    [&["callout", "case.toml", "--loss", loss][..], &FEW, options].concat()
}

#[test]
fn limits_are_printed_and_written_with_traces_and_wavelengths() {
    let bench = bench();
    let few = [
        "--parameter",
        "rpk",
        "--traces",
        "1",
        "--confidence",
        "98 %",
    ];
    let said = bench.run(&call("600 W", &few)).well().unwrapped();
    for words in [
        "Both flanks: mean R",
        "Inspect ",
        "wavelengths 2.5 µm to 250 µm",
        "smooth flanks",
    ] {
        assert!(said.contains(words), "{words}: {said}");
    }
    let text = std::fs::read_to_string(bench.path("results/case-callout/callout.json"));
    let found: serde_json::Value = serde_json::from_str(&text.unwrap()).unwrap();
    let losses =
        ["smooth_loss_w", "mean_loss_w", "loss_w"].map(|name| found[name].as_f64().unwrap());
    assert!(losses.is_sorted(), "{losses:?}");
    for table in [
        "limits.csv",
        "parameters.csv",
        "traces.csv",
        "curve.csv",
        "callout.html",
    ] {
        assert!(
            bench
                .path(&format!("results/case-callout/{table}"))
                .is_file()
        );
    }
    let settings = [&found["traces"], &found["confidence"]];
    assert_eq!(settings.map(|value| value.as_f64().unwrap()), [1.0, 0.98]);
}

#[test]
fn losses_that_no_finish_has_and_impossible_settings_are_refused() {
    let bench = bench();
    bench
        .run(&call("560 W", &["--set", "formulation=paper"]))
        .refused(2, "E205", &["formulation = \"paper\"", "leave it out"]);
    bench
        .run(&call("200 W", &[]))
        .refused(2, "E323", &["smooth flanks (Ra 0.01 um) lose "]);
    for (option, value, says) in [
        ("--confidence", "100 %", "50 and 99 %"),
        ("--scatter", "40 %", "0 and 30 %"),
        ("--traces", "0", "1 to 64"),
        ("--traces", "65", "1 to 64"),
    ] {
        bench
            .run(&call("600 W", &[option, value]))
            .refused(2, "E209", &[says]);
    }
    bench
        .run(&call("0 W", &[]))
        .refused(2, "E209", &["must be positive"]);
    let paper = call(
        "600 W",
        &[
            "--set",
            "surface.pinion={ rq = \"0.3 um\" }",
            "--set",
            "formulation=paper",
        ],
    );
    bench.run(&paper).refused(4, "E303", &["a flank has none"]);
}
