//! Losses of the shipped cases at three torques and three temperatures, two files of `tests/golden/evidence`.
//!
//! Some minutes; `ASPERITY_WRITE=1 cargo test --release --workspace --test validation shipped_cases -- --ignored` writes the tables.
//! `the_shipped_operation_of_each_case_is_in_its_table` compares the rows of the shipped operation.

use std::fmt::Write as _;

use asperity::case::LoadedCase;
use asperity::result::loss_band::Digits;
use asperity::uncertainty::Verdict;

use crate::band::{Banded, banded, both, change};
use crate::evidence;
use crate::load_share::with;

/// A case with its torques \[N m\] and temperatures \[°C\]: its own and two more, scaled as those of the e-drive.
struct Study {
    case: &'static str,
    torques_nm: [f64; 3],
    temperatures_c: [f64; 3],
}

const E_DRIVE: Study = Study {
    case: "e-drive",
    torques_nm: [145.0, 50.0, 20.0],
    temperatures_c: [60.0, 90.0, 120.0],
};
const OTHERS: [Study; 2] = [
    Study {
        case: "fzg-c",
        torques_nm: [183.4, 63.2, 25.3],
        temperatures_c: [60.0, 90.0, 120.0],
    },
    Study {
        case: "table2",
        torques_nm: [285.0, 98.3, 39.3],
        temperatures_c: [30.0, 60.0, 90.0],
    },
];

/// Row of the shipped operation: largest torque, middle temperature.
const SHIPPED: usize = 1;

/// The median with its quantiles.
fn text((_, found, ..): &Banded) -> String {
    rounded(found.loss.drawn().value, found.loss.drawn().ends())
}

fn computed(case: &str, torque_nm: f64, celsius: f64) -> Banded {
    let (torque, temperature) = (format!("{torque_nm} N m"), format!("{celsius} °C"));
    let keys = [
        ("operation.torque", &*torque),
        ("operation.bulk_temperature", &*temperature),
    ];
    let mut loaded: LoadedCase = with(case, &keys);
    if case == "table2" {
        // The viscosity given is the one at 60 °C.
        let viscosity =
            r#"{ law = "given", dynamic_viscosity = "97.5 mPa s", temperature = "60 °C" }"#;
        loaded = loaded.with_key("lubricant.viscosity", viscosity).unwrap();
    }
    banded(loaded)
}

/// Saving of `other` in per cent of the loss of `first`, and whether its sign holds.
fn saving(first: &Banded, other: &Banded) -> String {
    let change = change(first, other);
    let [low, high] = change.share.ends();
    let verdict = match &change.verdict {
        Verdict::Holds => format!("holds under {} models", change.models.len()),
        Verdict::Except(models) => format!("except under {}", models.join(", ")),
        Verdict::Undecided => "undecided".to_owned(),
        other => format!("{other:?}"),
    };
    let saved = rounded(-100.0 * change.share.value, [-100.0 * high, -100.0 * low]);
    format!("{saved} | {verdict}")
}

/// Value and ends as screens print them.
fn rounded(value: f64, [low, high]: [f64; 2]) -> String {
    let digits = Digits::of_interval([low, high]);
    let [value, low, high] = [value, low, high].map(|value| digits.rounded(value));
    format!("{value} ({low}..{high})")
}

fn e_drive_row(k: usize) -> String {
    let (torque, celsius) = (E_DRIVE.torques_nm[k / 3], E_DRIVE.temperatures_c[k % 3]);
    let [ground, fine] = match k {
        SHIPPED => both().clone(),
        _ => ["e-drive", "e-drive-superfinished"].map(|case| computed(case, torque, celsius)),
    };
    let saved = saving(&ground, &fine);
    format!(
        "| {torque} | {celsius} | {} | {} | {saved} |",
        text(&ground),
        text(&fine)
    )
}

fn other_row(which: usize, k: usize) -> String {
    let study = &OTHERS[which];
    let (torque, celsius) = (study.torques_nm[k / 3], study.temperatures_c[k % 3]);
    let found = computed(study.case, torque, celsius);
    format!(
        "| {} | {torque} | {celsius} | {} |",
        study.case,
        text(&found)
    )
}

/// Names of both tables.
pub const NAMES: [&str; 2] = ["shipped-e-drive", "shipped-others"];

fn e_drive_table() -> String {
    let mut text = String::from(
        "| torque N m | °C | ground W | superfinished W | saving % | sign |\n|---|---|---|---|---|---|\n",
    );
    for k in 0..9 {
        let _ = writeln!(text, "{}", e_drive_row(k));
    }
    text
}

fn other_table() -> String {
    let mut text = String::from("| case | torque N m | °C | loss W |\n|---|---|---|---|\n");
    for which in 0..OTHERS.len() {
        for k in 0..9 {
            let _ = writeln!(text, "{}", other_row(which, k));
        }
    }
    text
}

#[test]
#[ignore = "minutes"]
fn every_row_of_the_shipped_cases_is_in_its_table() {
    evidence::hold(NAMES[0], &e_drive_table());
    evidence::hold(NAMES[1], &other_table());
}

#[test]
fn the_shipped_operation_of_each_case_is_in_its_table() {
    evidence::hold_row(NAMES[0], &e_drive_row(SHIPPED));
    for which in 0..OTHERS.len() {
        evidence::hold_row(NAMES[1], &other_row(which, SHIPPED));
    }
}
