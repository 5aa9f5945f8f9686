//! Losses of the shipped cases at three torques and three temperatures, before the predictive draws and now.
//!
//! Some minutes; `ASPERITY_WRITE=1 cargo test --release -p asperity-tests --test validation shipped_cases -- --ignored` writes
//! the tables anew. `the_shipped_cases_stand_in_their_tables_as_computed` holds the row of the shipped operation.

use std::fmt::Write as _;
use std::path::Path;

use asperity::case::LoadedCase;
use asperity::result::loss_band::Digits;
use asperity::uncertainty::Verdict;

use crate::band::{Banded, banded, both, change};
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

/// The e-drive at commit b0658b6, torque by torque: loss \[W\] of ground and of superfinished flanks at the former defaults with
/// its 5 and 95 % quantiles, and the saving \[%\].
const E_DRIVE_BEFORE: [[&str; 3]; 9] = [
    ["580 (520..700)", "520 (460..590)", "10 (8..16)"],
    ["580 (520..760)", "450 (390..510)", "23 (18..34)"],
    ["610 (540..850)", "390 (340..450)", "36 (31..48)"],
    ["210 (200..260)", "169 (156..181)", "21 (17..33)"],
    ["210 (190..290)", "124 (115..134)", "42 (36..55)"],
    ["230 (200..330)", "97 (90..106)", "58 (52..69)"],
    ["116 (107..139)", "81.5 (79.9..83.0)", "30 (25..41)"],
    ["110 (100..150)", "54.5 (53.6..55.3)", "52 (47..64)"],
    ["120 (110..170)", "40.0 (39.4..40.9)", "67 (62..76)"],
];
/// The other cases at commit b0658b6.
const OTHERS_BEFORE: [[&str; 9]; 2] = [
    [
        "340 (300..410)",
        "340 (300..430)",
        "340 (310..460)",
        "116 (102..139)",
        "110 (100..140)",
        "110 (100..150)",
        "46 (41..54)",
        "43 (39..57)",
        "45 (40..63)",
    ],
    [
        "480 (450..510)",
        "380 (350..430)",
        "320 (290..380)",
        "295 (289..302)",
        "192 (184..203)",
        "134 (126..150)",
        "246.3 (245.0..247.8)",
        "141 (136..147)",
        "82 (77..91)",
    ],
];

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
    let [before_ground, before_fine, before_saved] = E_DRIVE_BEFORE[k];
    format!(
        "| {torque} | {celsius} | {before_ground} | {} | {before_fine} | {} | {before_saved} | {saved} |",
        text(&ground),
        text(&fine)
    )
}

fn other_row(which: usize, k: usize) -> String {
    let study = &OTHERS[which];
    let (torque, celsius) = (study.torques_nm[k / 3], study.temperatures_c[k % 3]);
    let found = computed(study.case, torque, celsius);
    let before = OTHERS_BEFORE[which][k];
    format!(
        "| {} | {torque} | {celsius} | {before} | {} |",
        study.case,
        text(&found)
    )
}

fn tables() -> String {
    let mut text = String::from(
        "| e-drive N m | °C | ground W, before | ground W | superfinished W, before | superfinished W | saving %, before | saving % | sign |\n\
         |---|---|---|---|---|---|---|---|---|\n",
    );
    for k in 0..9 {
        let _ = writeln!(text, "{}", e_drive_row(k));
    }
    text.push_str("\n| case | N m | °C | loss W, before | loss W |\n|---|---|---|---|---|\n");
    for which in 0..OTHERS.len() {
        for k in 0..9 {
            let _ = writeln!(text, "{}", other_row(which, k));
        }
    }
    text
}

const BEGIN: &str = "<!-- shipped-cases -->\n";

#[test]
#[ignore = "minutes; the tables are renewed by hand"]
fn the_tables_of_the_shipped_cases_are_written() {
    let made = tables();
    println!("{made}");
    if std::env::var_os("ASPERITY_WRITE").is_some() {
        let file = Path::new(env!("CARGO_MANIFEST_DIR")).join("../docs/records/gap-laws.md");
        let mut text = std::fs::read_to_string(&file).unwrap();
        let start = text.find(BEGIN).unwrap() + BEGIN.len();
        let end = start + text[start..].find("<!-- end -->").unwrap();
        text.replace_range(start..end, &made);
        std::fs::write(&file, text).unwrap();
    }
}

#[test]
fn the_shipped_cases_stand_in_their_tables_as_computed() {
    let file = Path::new(env!("CARGO_MANIFEST_DIR")).join("../docs/records/gap-laws.md");
    let text = std::fs::read_to_string(&file).unwrap();
    for row in [
        e_drive_row(SHIPPED),
        other_row(0, SHIPPED),
        other_row(1, SHIPPED),
    ] {
        assert!(
            text.contains(&row),
            "not in docs/records/gap-laws.md: {row}"
        );
    }
}
