//! Numbers in the prose of the pages for users: each is in a block of its page, or in a file that decides it.
//!
//! Blocks are input and output that `tests/cli` runs; tables that tests write are left out, and `how_it_works.rs` checks its page.
//! Zero and one are not judged: they are the ends of shares and ratios.

use std::fs;

use asperity::oil::viscosity_index::viscosity_index;
use asperity::oil::{ViscosityLaw, library_oil};
use asperity_tests::markdown::{blocks, pages, prose, root, without_code};

const README: &str = "README.md";
const TRUST: &str = "docs/trust.md";
const FAQ: &str = "docs/faq.md";
const SCANS: &str = "docs/howto/more-traces.md";
const PROFILE: &str = "docs/howto/profile.md";
const GENERATED: &str = "docs/howto/generated.md";
const OIL: &str = "docs/howto/oil.md";
const ASKED: &str = "const QUESTIONS: [(&str, Question); 10]";
const NEW_CASE: &str = "cli/src/commands/new_case.rs";
const BOUNDARY: &str = "crates/tribo-friction/src/boundary.rs";
const BLIND_TESTS: &str = "docs/decisions/reference-solutions.md";
const PREPARATION: &str = "crates/roughness/src/preparation.rs";
const LAMBDA_S: &str = "LAMBDA_S: Length = Length::from_si(2.5e-6)";
const LAY: &str = "crates/ehl-regime/src/inlet_flow.rs";
const RECORDED_LAY: &str = "pub const RECORDED: Self = Self(1.0 / 3.0)";
const POINTS: &str = "pub const LEAST_POINTS_PER_HALF_WIDTH: f64 = 20.0;";
const WINDOWS: &str = "crates/flanks/src/window_pair.rs";

/// Page, its words with the number, the file that decides it, and the words of that file.
const SOURCES: &[[&str; 4]] = &[
    [
        README,
        "in six panels",
        "docs/figures/how-it-works.svg",
        "6 Loss and interval",
    ],
    [README, "asks ten questions", NEW_CASE, ASKED],
    ["docs/TUTORIAL.md", "ten questions", NEW_CASE, ASKED],
    [PROFILE, "asks ten questions", NEW_CASE, ASKED],
    [
        TRUST,
        "T1 at 0.5 m/s",
        "tests/validation/gates.rs",
        "T1 FZG C-mod, mean μ at 0.5 m/s",
    ],
    [
        TRUST,
        "six speeds (T1)",
        "tests/validation/measured_cases.rs",
        "FZG_SPEEDS: [(f64, f64); 6]",
    ],
    [
        TRUST,
        "90 % interval",
        "crates/uncertainty/src/quantiles.rs",
        "PROBABILITIES: [f64; 3] = [0.05, 0.5, 0.95]",
    ],
    [
        TRUST,
        "| first | 22 of 28 | 18 |",
        BLIND_TESTS,
        "18 of 28 were within their 90 % interval, or 22 with the errors of sampling",
    ],
    [
        TRUST,
        "| second | 18 of 24 | 13 |",
        BLIND_TESTS,
        "By the error of the model only it was 13",
    ],
    [
        TRUST,
        "the second required 19",
        BLIND_TESTS,
        "19 had to be within their 90 % interval. **The test failed**: 18 of 24",
    ],
    [
        TRUST,
        "90 % of 28 are 25",
        BLIND_TESTS,
        "28 conditions on new traces",
    ],
    [
        TRUST,
        "| third, by others | 25 of 28 | 21 |",
        BLIND_TESTS,
        "With the errors of sampling 25 are within their 90 % interval, by the error of the model only 21",
    ],
    [
        TRUST,
        "coefficient is 0.09",
        BOUNDARY,
        "BOUNDARY_FRICTION: f64 = 0.09;",
    ],
    [
        TRUST,
        "measured 0.065 to 0.12",
        "docs/CONSTANTS.md",
        "ground gears 0.065 to 0.07 (Arana 2019), tribometers to 0.12",
    ],
    [
        TRUST,
        "wears 0.03 µm for a measured 0.5 to 4 (T14",
        "tests/golden/evidence/gates.csv",
        "1.7 GPa\",0.5 to 4 (ISO 6336-1: 2.0),measured,printed only,um,0.030",
    ],
    [
        TRUST,
        "10 nm thick",
        BOUNDARY,
        "BOUNDARY_LAYER: Length = Length::from_si(10e-9)",
    ],
    [TRUST, "λs = 2.5 µm", PREPARATION, LAMBDA_S],
    [
        TRUST,
        "boundary share of 0.75",
        BOUNDARY,
        "INNER_BOUNDARY: f64 = 0.75;",
    ],
    [
        TRUST,
        "(0.6 to 0.9)",
        BOUNDARY,
        "INNER_BOUNDARY_RANGE: [f64; 2] = [0.6, 0.9]",
    ],
    [
        TRUST,
        "a factor of ten",
        "crates/studies/src/running_in/study.rs",
        "3e-10 mm³/(N m) within a factor of ten",
    ],
    [TRUST, "above 1/3 (W452)", LAY, RECORDED_LAY],
    [
        FAQ,
        "20 points on a Hertz half-width (E121)",
        WINDOWS,
        POINTS,
    ],
    [
        FAQ,
        "such as -9999",
        "crates/profile-io/src/read/steepness.rs",
        "[-9999.0, 1e30]",
    ],
    [
        FAQ,
        "more than 5 µm",
        "crates/core/src/message/table.rs",
        "the teeth approach each other by more than 5 um",
    ],
    [
        "docs/howto/embed.md",
        "65 crates instead of 104",
        "tests/architecture/embedded.rs",
        "{least} crates instead of {all}",
    ],
    [
        "docs/howto/gears.md",
        "ISO/TR 15144-1",
        "crates/asperity/src/equations/sources.txt",
        "15144-1",
    ],
    [
        GENERATED,
        "150 to 300 µm",
        "crates/roughness/src/generate/pieces.rs",
        "PIECE: [f64; 2] = [150e-6, 300e-6]",
    ],
    [SCANS, "noise cut-off of 2.5 µm", PREPARATION, LAMBDA_S],
    [
        SCANS,
        "at most 1/6",
        "crates/flanks/src/flank_lay.rs",
        "const MOST_LAY: f64 = 1.0 / 6.0;",
    ],
    [
        SCANS,
        "1 or 4 to 8 rows",
        "crates/asperity/tests/patches.rs",
        "(4..=8).contains(&rows.len())",
    ],
    [SCANS, "a lay of 1/3", LAY, RECORDED_LAY],
    [
        SCANS,
        "twelve pairs",
        "crates/flanks/src/surrogates.rs",
        "const PAIRS: usize = 12;",
    ],
    [
        OIL,
        "1.5 % and 0.0003",
        "crates/calibration/src/oil/studies.rs",
        "point_floor: f64 = 0.0003,",
    ],
    [PROFILE, "0.25 mm and 2.5 µm", PREPARATION, LAMBDA_S],
    [PROFILE, "20 points", WINDOWS, POINTS],
    [
        "docs/howto/rig.md",
        "eight hours",
        "crates/calibration/src/settings.rs",
        "hours: f64 = 8,",
    ],
    [
        "docs/howto/rig.md",
        "random errors of 3 %",
        "crates/calibration/src/settings.rs",
        "sigma: Ratio = \"3 %\"",
    ],
    [
        "docs/howto/rig.md",
        "Above 3 the model",
        "crates/calibration/src/birge.rs",
        "LARGEST_RATIO: f64 = 3.0;",
    ],
    [
        "docs/howto/what-matters.md",
        "16 pairs of its flanks",
        "crates/studies/src/callout/lots.rs",
        "const PAIRS: usize = 16;",
    ],
    [
        "docs/TUTORIAL.md",
        "16384 samples",
        "crates/uncertainty/src/draw.rs",
        "const DRAWS: usize = 16_384;",
    ],
];

/// Viscosity index of an oil of the library, by its viscosities at 40 and 100 °C.
fn index(name: &str) -> String {
    let oil = library_oil(name).unwrap();
    let Some(ViscosityLaw::AstmD341 { at_40, at_100 }) = oil.lubricant.viscosity else {
        panic!("{name} has no viscosities at 40 and 100 °C");
    };
    format!("{:.0}", viscosity_index(at_40, at_100).unwrap())
}

/// Words of the page on oils that are computed here.
fn indices() -> [String; 3] {
    let [naphthenic, mineral, thin, thick] =
        ["n100", "m100", "e-fluid-70w75w", "pao100"].map(index);
    [
        format!("index of {naphthenic}"),
        format!("index of {mineral}"),
        format!("indices of {thin} and {thick}"),
    ]
}

/// Blind tests: the words of their decision with the number of conditions, the stored solutions, and the table of the model today.
///
/// How many were inside when a test was blind no run gives again, since the model has changed; the commits that the decision names
/// printed it. Of the third test no solutions are stored.
const BLIND: [[&str; 3]; 2] = [
    ["28 conditions on new traces", "blind", "ehl-blind"],
    [
        "24 conditions on new finishes",
        "second_blind",
        "ehl-second-blind",
    ],
];

#[test]
fn a_blind_test_has_as_many_conditions_as_stored_solutions() {
    let decisions = joined(&fs::read_to_string(root().join(BLIND_TESTS)).unwrap());
    for [words, solutions, table] in BLIND {
        let files = [
            format!("fixtures/records/{solutions}.csv"),
            format!("tests/golden/evidence/{table}.csv"),
        ];
        for file in files {
            let text = fs::read_to_string(root().join(&file)).unwrap();
            let rows = text.lines().filter(|line| !line.starts_with('#')).skip(1);
            let count = format!("{} ", rows.count());
            assert!(
                decisions.contains(words) && words.starts_with(&count),
                "{words}: {file} has {count}"
            );
        }
    }
}

/// Words that are numbers; smaller ones are not judged.
const COUNTED: [(&str, &str); 9] = [
    ("five", "5"),
    ("six", "6"),
    ("seven", "7"),
    ("eight", "8"),
    ("nine", "9"),
    ("ten", "10"),
    ("eleven", "11"),
    ("twelve", "12"),
    ("twenty", "20"),
];

/// A number without its sign, or a word for one as a number; `None` for other words.
fn number(word: &str) -> Option<&str> {
    let word = word.trim_start_matches(['-', '+', '.']);
    let word = word.trim_end_matches(['-', '+', '.']);
    let is_number = word.starts_with(|c: char| c.is_ascii_digit())
        && word.bytes().all(|b| !b.is_ascii_alphabetic() || b == b'e');
    let counted = || {
        COUNTED
            .iter()
            .find(|(name, _)| word.eq_ignore_ascii_case(name))
    };
    is_number
        .then_some(word)
        .or_else(|| counted().map(|(_, number)| *number))
}

fn numbers(text: &str) -> Vec<String> {
    let text = text.replace("..", " ");
    let is_between = |c: char| !(c.is_alphanumeric() || ['.', '-', '+'].contains(&c));
    let found = text.split(is_between).filter_map(number);
    found.map(str::to_owned).collect()
}

/// `text` on one line.
fn joined(text: &str) -> String {
    text.split_whitespace().collect::<Vec<_>>().join(" ")
}

/// The prose of a page without what tests write into it, numbers of headings, code, and targets of links.
fn said(text: &str) -> String {
    let mut is_written = false;
    let mut lines = Vec::new();
    for line in prose(text) {
        let is_mark = line.starts_with("<!-- ");
        is_written = if is_mark {
            line != "<!-- end -->"
        } else {
            is_written
        };
        if is_mark || is_written {
            continue;
        }
        let line = line.trim_start_matches(['#', ' ']);
        let is_heading = |c: char| c.is_ascii_digit() || c == '.';
        let line = match line.split_once(' ') {
            Some((first, rest)) if first.ends_with('.') && first.chars().all(is_heading) => rest,
            _ => line,
        };
        let mut parts = line.split("](");
        let mut plain = parts.next().unwrap_or_default().to_owned();
        for part in parts {
            plain += part.split_once(')').map_or("", |(_, rest)| rest);
        }
        lines.push(without_code(&plain));
    }
    joined(&lines.join(" "))
}

/// Pages for users whose numbers are checked here.
fn judged() -> Vec<String> {
    let mut judged = pages();
    let others = [README, "docs/TUTORIAL.md", TRUST, FAQ];
    judged.retain(|page| others.contains(&page.as_str()) || page.starts_with("docs/howto/"));
    judged
}

#[test]
fn every_number_of_a_page_for_users_has_a_source() {
    let mut unknown = Vec::new();
    let mut count = 0;
    let indices = indices();
    for page in judged() {
        let text = fs::read_to_string(root().join(&page)).unwrap();
        let shown = blocks(&text)
            .iter()
            .flat_map(|block| block.lines.clone())
            .flat_map(numbers)
            .collect::<Vec<_>>();
        let mut said = said(&text);
        let of_sources = SOURCES.iter().map(|[of, words, ..]| (*of, *words));
        let computed = indices.iter().map(|words| (OIL, words.as_str()));
        for (_, words) in of_sources.chain(computed).filter(|(of, _)| *of == page) {
            assert!(
                said.contains(words),
                "{page} does not say {words:?}: leave it out of this file"
            );
            said = said.replace(words, " ");
        }
        for number in numbers(&said) {
            count += 1;
            if !shown.contains(&number) && !["0", "1"].contains(&number.as_str()) {
                unknown.push(format!("{page}: {number}"));
            }
        }
    }
    assert!(count > 20, "{count} numbers");
    assert!(
        unknown.is_empty(),
        "no block and no source has\n{}",
        unknown.join("\n")
    );
    assert_eq!(
        numbers("E101, (90..110) of ten: -13 %, 1/3; Apache-2.0, 3e-4."),
        ["90", "110", "10", "13", "1", "3", "3e-4"]
    );
    assert_eq!(
        said("## 2. A `3` [b 4](c5.md) d\n<!-- x -->\n6\n<!-- end -->\n7"),
        "A [b 4 d 7"
    );
}

#[test]
fn every_source_has_the_number_that_a_page_says() {
    for [page, says, file, words] in SOURCES {
        let text = fs::read_to_string(root().join(file)).unwrap();
        assert!(
            joined(&text).contains(words),
            "{page}: {says:?} was decided by {file} with {words:?}"
        );
    }
}

/// Verdicts that the page on trust states in words: beginning of the name of a gate, verdict, and how many.
const VERDICTS: [(&str, &str, usize); 10] = [
    ("T1 loss over", "pass", 3),
    ("T1 loss over", "inconclusive", 3),
    ("T1 FZG C-mod, mean μ at 0.5 m/s", "**FAIL**", 1),
    ("T3 ", "inconclusive", 3),
    ("T4 ", "pass", 1),
    ("T7 ", "**FAIL**", 1),
    ("T11 ", "**FAIL**", 1),
    ("T12 ", "pass", 2),
    ("T13 ", "**FAIL**", 2),
    ("T15 ", "**FAIL**", 1),
];

#[test]
fn the_page_on_trust_states_the_verdicts_of_the_table() {
    let text = fs::read_to_string(root().join("docs/VALIDATION.md")).unwrap();
    let (_, table) = text.split_once("<!-- gates-that-count -->").unwrap();
    let (table, _) = table.split_once("<!-- end -->").unwrap();
    let rows: Vec<&str> = table
        .lines()
        .filter(|line| line.starts_with("| T"))
        .collect();
    for (begin, verdict, count) in VERDICTS {
        let is_one =
            |row: &&&str| row[2..].starts_with(begin) && row.ends_with(&format!("| {verdict} |"));
        assert_eq!(
            rows.iter().filter(is_one).count(),
            count,
            "{begin}{verdict}"
        );
    }
    assert_eq!(
        VERDICTS.iter().map(|(.., count)| count).sum::<usize>(),
        rows.len()
    );
}
