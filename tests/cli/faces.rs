//! A value of a study is one value on every face: terminal, page, CSV and JSON, with digits by one rule.

use std::collections::BTreeMap;
use std::fs;

use asperity_report::{Input, StudyResult, StudySettings};
use asperity_studies::every_study;
use serde_json::Value;

use crate::bench::{Bench, E_DRIVE, root};

/// A table of a page: its file, the names of its columns there, and the texts of its rows.
struct Shown {
    file: String,
    columns: Vec<Option<String>>,
    rows: Vec<Vec<String>>,
}

/// The part of `text` from after `from` to before `to`, and the rest.
fn between<'a>(text: &'a str, from: &str, to: &str) -> Option<(&'a str, &'a str)> {
    let begin = text.find(from)? + from.len();
    let end = begin + text[begin..].find(to)?;
    Some((&text[begin..end], &text[end + to.len()..]))
}

fn attribute(tag: &str, name: &str) -> Option<String> {
    Some(between(tag, &format!("{name}=\""), "\"")?.0.to_owned())
}

/// Text of markup, in which a paragraph ends as a sentence.
fn plain(markup: &str) -> String {
    let mut text = String::new();
    let ended = ["</summary>", "</p>"]
        .iter()
        .fold(markup.to_owned(), |all, end| all.replace(end, ". "));
    for part in ended.split('<') {
        text += part.split_once('>').map_or(part, |(_, text)| text);
    }
    let entities = [
        ("&lt;", "<"),
        ("&gt;", ">"),
        ("&quot;", "\""),
        ("&amp;", "&"),
    ];
    entities
        .iter()
        .fold(text, |text, (entity, c)| text.replace(entity, c))
}

/// Elements with these names: the tag and the text of each.
fn elements<'a>(markup: &'a str, names: &[&str]) -> Vec<(&'a str, String)> {
    let parts = markup.match_indices('<').filter_map(|(at, _)| {
        let rest = &markup[at + 1..];
        let is_named = |name: &&&str| {
            let after = rest.strip_prefix(**name);
            after.is_some_and(|after| after.starts_with([' ', '>']))
        };
        let name = names.iter().find(is_named)?;
        let (tag, rest) = rest.split_once('>')?;
        let (content, _) = rest.split_once(&format!("</{name}>"))?;
        Some((tag, plain(content)))
    });
    parts.collect()
}

/// The tables of a page that show the values of a file.
fn tables(page: &str) -> Vec<Shown> {
    let mut rest = page;
    let mut found = Vec::new();
    while let Some((table, after)) = between(rest, "<table", "</table>") {
        rest = after;
        let tag = table.split('>').next().unwrap();
        let Some(file) = attribute(tag, "data-file") else {
            continue;
        };
        let (head, body) = between(table, "<thead>", "</thead>").unwrap();
        let columns = elements(head, &["th", "td"]);
        let rows = body.split("<tr>").skip(1);
        let row = |row: &str| {
            let cells = elements(row, &["th", "td"]).into_iter();
            cells.map(|(_, text)| text).collect()
        };
        found.push(Shown {
            file,
            columns: columns
                .iter()
                .map(|(tag, _)| attribute(tag, "data-column"))
                .collect(),
            rows: rows.map(row).collect(),
        });
    }
    found
}

/// The numbers of a cell, each with its text: "-130 (-141..-120) W" has three.
fn numbers(cell: &str) -> Vec<(f64, String)> {
    let is_part = |c: char| c.is_ascii_digit() || matches!(c, '.' | '-' | '+' | 'e');
    let spaced = cell.replace("..", " ").replace('−', "-");
    let words = spaced.split(|c: char| !is_part(c));
    let number = |word: &str| Some((word.parse().ok()?, word.to_owned()));
    words.filter_map(number).collect()
}

/// Half of the last place of the numbers of a cell, which they share; a 0 does not tell it.
fn half_place(numbers: &[(f64, String)]) -> f64 {
    let of = |text: &String| {
        let digits = text.trim_start_matches(['+', '-']);
        match digits.split_once('.') {
            Some((_, decimals)) => 0.5 * 10f64.powi(-(decimals.len() as i32)),
            // A whole number may be rounded to tens, hundreds, and so on.
            None => {
                let zeros = digits.len() - digits.trim_end_matches('0').len();
                0.5 * 10f64.powi(zeros as i32)
            }
        }
    };
    let told = numbers.iter().filter(|(number, _)| *number != 0.0);
    let least = told.map(|(_, text)| of(text)).fold(f64::INFINITY, f64::min);
    if least.is_finite() { least } else { 0.5 }
}

/// Columns that add up to another as printed: one of them may be rounded the other way.
const PARTS: [&str; 4] = ["film_w", "lubricated_asperity_w", "boundary_w", "rolling_w"];

/// Whether number `k` of a cell shows `value`, which it may give in percent, within `room`.
fn shows(numbers: &[(f64, String)], k: usize, value: f64, room: f64) -> bool {
    let room = room * (1.0 + 1e-9) + 1e-12;
    let shown = numbers.get(k).map_or(f64::NAN, |(shown, _)| *shown);
    let close = |value: f64| (shown - value).abs() <= room;
    close(value) || close(100.0 * value)
}

/// All numbers and texts of a JSON value.
fn leaves<'a>(value: &'a Value, found: &mut Vec<&'a Value>) {
    match value {
        Value::Array(items) => items.iter().for_each(|item| leaves(item, found)),
        Value::Object(fields) => fields.values().for_each(|field| leaves(field, found)),
        leaf => found.push(leaf),
    }
}

fn is_in(numbers: &[f64], value: f64) -> bool {
    let close = |other: f64| (other - value).abs() <= 1e-9 * value.abs();
    // The JSON may have another unit.
    let scales = (-9..=9).map(|power| 10f64.powi(power));
    let mut scaled = scales.flat_map(|scale| numbers.iter().map(move |other| scale * other));
    scaled.any(close)
}

/// Numbers in the tables of a folder besides `file`.
fn numbers_of_others(bench: &Bench, folder: &str, file: &str) -> Vec<f64> {
    let entries = fs::read_dir(bench.path(folder)).unwrap();
    let paths = entries.map(|entry| entry.unwrap().path());
    let others = paths.filter(|path| {
        path.extension().is_some_and(|end| end == "csv") && path.file_name().unwrap() != file
    });
    let cells = others.flat_map(|path| {
        let text = fs::read_to_string(path).unwrap();
        let cells = text.lines().flat_map(|line| line.split(','));
        let numbers = cells.filter_map(|cell| cell.parse().ok());
        numbers.collect::<Vec<f64>>()
    });
    cells.collect()
}

/// Numbers that follow from those of the JSON and of other tables: percentages of the power by the median of the loss,
/// differences of two runs, and films.
const DERIVED: [&str; 6] = [
    "efficiency_percent",
    "share_percent",
    "change_percent",
    "difference_w",
    "traction.csv film_nm",
    "traction.csv film_ratio",
];

/// The values of a column in a row of a file: one, three of a number with its interval, or two of an interval.
fn values_of<'a>(row: &'a BTreeMap<String, String>, column: &str) -> Vec<&'a str> {
    let of = |name: String| row.get(&name).map(String::as_str);
    let Some(value) = row.get(column) else {
        let ends = ["low", "high"].map(|end| of(format!("{column}_{end}")));
        return ends.into_iter().flatten().collect();
    };
    let end = |which: &str| match (column.contains("median"), column.rsplit_once('_')) {
        (true, _) => of(column.replace("median", which)),
        (false, Some((stem, unit))) => of(format!("{stem}_{which}_{unit}")),
        (false, None) => of(format!("{column}_{which}")),
    };
    let ends = [end("p05"), end("p95")];
    [value.as_str()]
        .into_iter()
        .chain(ends.into_iter().flatten())
        .collect()
}

/// What a folder holds besides its page.
struct Folder<'a> {
    bench: &'a Bench,
    name: &'a str,
    /// Numbers and texts of its JSON file.
    numbers: Vec<f64>,
    texts: Vec<String>,
}

impl<'a> Folder<'a> {
    fn new(bench: &'a Bench, name: &'a str, json: &Value) -> Self {
        let mut found = Vec::new();
        leaves(json, &mut found);
        Self {
            bench,
            name,
            numbers: found.iter().filter_map(|leaf| leaf.as_f64()).collect(),
            texts: found
                .iter()
                .filter_map(|leaf| Some(leaf.as_str()?.to_owned()))
                .collect(),
        }
    }

    /// Rows of a file by the names of their columns.
    fn rows(&self, file: &str) -> Vec<BTreeMap<String, String>> {
        let path = self.bench.path(self.name).join(file);
        let mut reader = csv::Reader::from_path(path).unwrap();
        let header = reader.headers().unwrap().clone();
        let row = |row: csv::StringRecord| {
            let cells = header.iter().zip(&row);
            cells
                .map(|(name, cell)| (name.to_owned(), cell.to_owned()))
                .collect()
        };
        reader.records().map(|line| row(line.unwrap())).collect()
    }

    /// Checks a table of the page against its file, and this against the JSON; returns the number of cells.
    fn check(&self, table: &Shown) -> usize {
        let file = self.rows(&table.file);
        assert_eq!(file.len(), table.rows.len(), "{}/{}", self.name, table.file);
        let others = numbers_of_others(self.bench, self.name, &table.file);
        let mut checked = 0;
        for (shown, row) in table.rows.iter().zip(&file) {
            let cells = shown.iter().zip(&table.columns);
            let cells = cells.filter_map(|(text, column)| Some((text, column.as_ref()?)));
            let watts = cells.clone().filter(|(_, column)| column.ends_with("_w"));
            let of_watts: Vec<_> = watts.flat_map(|(text, _)| numbers(text)).collect();
            for (text, column) in cells {
                let values = values_of(row, column);
                let what = format!(
                    "{}/{} {column}: {text:?} and {values:?}",
                    self.name, table.file
                );
                assert!(!values.is_empty(), "{what}: no such column");
                let of_text = numbers(text);
                let is_zero = of_text.iter().all(|(number, _)| *number == 0.0);
                let room = match (PARTS.contains(&column.as_str()), is_zero) {
                    // Parts and their total share the last place.
                    (true, _) => 2.0 * half_place(&of_watts),
                    // A change in per cent that is nothing in the place that the interval of its watts allows.
                    (_, true) if column.ends_with("percent") => half_place(&of_watts),
                    _ => half_place(&of_text),
                };
                for (k, value) in values.iter().enumerate() {
                    let Ok(number) = value.parse::<f64>() else {
                        continue;
                    };
                    // An interval of no width is not shown.
                    let is_shown = k < of_text.len() || k == 0;
                    // A time is shown in minutes where it is short.
                    let is_in_minutes = column.ends_with("hours") && text.ends_with(" min");
                    let in_unit = if is_in_minutes { 60.0 * number } else { number };
                    assert!(!is_shown || shows(&of_text, k, in_unit, room), "{what}");
                    let place = format!("{} {column}", table.file);
                    let is_known = DERIVED.iter().any(|name| name == column || *name == place)
                        || self.texts.iter().any(|text| text == value)
                        || is_in(&self.numbers, number)
                        || is_in(&others, number);
                    assert!(is_known, "{what}: not in the JSON");
                }
                checked += 1;
            }
        }
        checked
    }
}

/// Cells of a row that tell it from others, where a terminal has no room for all.
const LEAST_CELLS: usize = 4;
/// Most words of a sentence, or of a part of it up to a colon or semicolon.
const MOST_WORDS: usize = 25;

/// Checks that the sentences of `text` have few words. The mesh of a train in brackets is no part of its warning.
pub fn short_sentences(text: &str, name: &str) {
    for sentence in text.split([';', ':']).flat_map(|part| part.split(". ")) {
        let of_mesh = sentence.rfind(" [").filter(|_| sentence.ends_with(']'));
        let sentence = &sentence[..of_mesh.unwrap_or(sentence.len())];
        let words = sentence.split_whitespace().count();
        assert!(words <= MOST_WORDS, "{name}: {words} words: {sentence}");
    }
}

/// Checks the sentences of the paragraphs and items of a page: few words, and a capital at the beginning.
fn plain_sentences(page: &str, name: &str) {
    for (tag, text) in elements(page, &["p", "li", "figcaption", "summary"]) {
        let text = text.split_whitespace().collect::<Vec<_>>().join(" ");
        short_sentences(&text, name);
        // A paragraph of a file begins with its name.
        let first = text.split(' ').next().unwrap_or_default();
        let is_name = first.contains(['.', '_', '/']) || tag.contains("class=");
        let is_small = text.starts_with(char::is_lowercase);
        assert!(
            !is_small || is_name || tag.starts_with("li"),
            "{name}: {text}"
        );
    }
}

/// Checks the page, the tables and the JSON of `folder`, and what the terminal said of it; returns the number of cells.
fn agree(bench: &Bench, folder: &str, name: &str, said: &str) -> usize {
    let read = |file: &str| fs::read_to_string(bench.path(folder).join(file)).unwrap();
    let json = serde_json::from_str(&read(&format!("{name}.json"))).unwrap();
    let files = Folder::new(bench, folder, &json);
    let lines: Vec<String> = said.lines().map(|line| format!(" {line} ")).collect();
    let tables = tables(&read(&format!("{name}.html")));
    for row in tables.iter().flat_map(|table| &table.rows) {
        // The terminal has the row, with the same texts.
        let count = |line: &String| {
            let in_line = |text: &&String| !text.is_empty() && line.contains(&format!(" {text} "));
            row.iter().filter(in_line).count()
        };
        let most = lines.iter().map(count).max().unwrap_or(0);
        let is_there = 2 * most >= row.len() || most >= LEAST_CELLS;
        assert!(is_there, "{folder}: {row:?} is not in\n{said}");
    }
    plain_sentences(&read(&format!("{name}.html")), name);
    tables.iter().map(|table| files.check(table)).sum()
}

#[test]
#[ignore = "slow: just test-all"]
fn slow_the_pages_of_runs_are_in_plain_sentences() {
    let bench = Bench::new();
    bench.write_flanks();
    bench.write("case.toml", E_DRIVE);
    bench.write("set.toml", crate::gear::SET);
    let page = |name: &str| {
        let text = fs::read_to_string(bench.path(name)).unwrap();
        plain_sentences(&text, name);
    };
    let ridges = [
        "run",
        "case.toml",
        "-o",
        "one",
        "--ridges",
        "--fields",
        "all",
    ];
    bench.run(&ridges).well();
    page("one/report.html");
    bench.run(&["report", "one", "--position", "1"]).well();
    page("one/report.html");
    let more = [
        "--set",
        "operation.running_in=true",
        "--set",
        "micropitting={}",
    ];
    bench
        .run(&[&["run", "case.toml", "-o", "two"][..], &more].concat())
        .well();
    page("two/report.html");
    bench.run(&["run", "set.toml", "-o", "set"]).well();
    // The gears of this set interfere, which is graver than the other warnings.
    let set = fs::read_to_string(bench.path("set/report.html")).unwrap();
    assert!(set.matches("<li class=\"grave\">").count() == 1, "{set}");
    for name in [
        "report.html",
        "sun_planet/report.html",
        "planet_ring/report.html",
    ] {
        page(&format!("set/{name}"));
    }
}

const STUDY: &str = r#"case = "case.toml"
columns = ["loss_w", "film_w", "efficiency"]
[sample]
method = "sobol"
count = 16
indices = true
vary."operation.torque" = { uniform = ["60 N m", "150 N m"] }
vary."operation.bulk_temperature" = { uniform = ["60 °C", "100 °C"] }
"#;

/// Stribeck curves at 120 °C and 50 N.
fn stribeck() -> String {
    let mut text =
        "load_n,mean_speed_m_s,slide_roll_percent,temperature_c,rubbing_s,traction\n".to_owned();
    for rubbing_s in [0, 3600] {
        for k in 0..12 {
            let speed = 0.002 * 1.5f64.powi(k);
            let friction = 0.11 - 0.02 * f64::from(rubbing_s) / 3600.0 - 0.0005 * f64::from(k);
            text += &format!("50,{speed},50,120,{rubbing_s},{friction}\n");
        }
    }
    text
}

#[test]
#[ignore = "slow: just test-all"]
fn slow_every_study_has_one_value_on_every_face() {
    let bench = Bench::new();
    bench.write_flanks();
    bench.write("case.toml", E_DRIVE);
    bench.write("rig.toml", crate::calibrate::CASE);
    bench.write("study.toml", STUDY);
    bench.write("stribeck.csv", stribeck());
    bench.write(
        "cycle.csv",
        "time_s,torque_nm,speed_rpm\n0,40,500\n30,90,4000\n60,60,3000\n",
    );
    let smooth = ["pinion", "wheel"].map(|flank| {
        let text = fs::read_to_string(bench.path(&format!("{flank}.csv"))).unwrap();
        let halved = text.lines().map(|line| match line.split_once(',') {
            Some((x, z)) => match z.parse::<f64>() {
                Ok(z) => format!("{x},{}\n", 0.5 * z),
                Err(_) => format!("{line}\n"),
            },
            None => format!("{line}\n"),
        });
        bench.write(&format!("{flank}_smooth.csv"), halved.collect::<String>());
        format!("{flank}_smooth.csv")
    });
    let smooth = format!("smooth={}", smooth.join(","));
    let run = |arguments: &[&str]| {
        let all = bench
            .first_screen(&[arguments, &["--notes"]].concat())
            .well();
        for line in all.out.lines() {
            let is_code = line.contains(" = ");
            assert!(line.chars().count() <= 80 || is_code, "{line}");
        }
        all.unwrapped()
    };
    let few = ["--set", "model.positions=4", "--set", "model.offsets=2"];
    let with = |command: &[&str]| run(&[command, &few].concat());
    let mut checked = BTreeMap::new();
    let mut check = |folder: &str, name: &'static str, said: &str| {
        checked.insert(name, agree(&bench, folder, name, said));
    };
    let share = ["--set", "model.load_share=zhu-hu", "--lots", "20"];
    let call = ["callout", "case.toml", "--loss", "600 W", "-o", "l"];
    check("l", "callout", &with(&[&call[..], &share].concat()));
    let finishes = [
        "--finish",
        "ground=pinion.csv,wheel.csv",
        "--finish",
        &smooth,
    ];
    let compare = ["compare", "case.toml", "-o", "c"];
    check("c", "compare", &with(&[&compare[..], &finishes].concat()));
    let axes = [
        "--torque=-100,40,100",
        "--speed=500,9000",
        "--temperature=90",
    ];
    let map = ["map", "case.toml", "-o", "m"];
    check("m", "map", &with(&[&map[..], &axes].concat()));
    check("y", "cycle", &run(&["cycle", "m", "cycle.csv", "-o", "y"]));
    run(&["sweep", "run", "study.toml", "-q"]);
    check(
        "w",
        "sweep",
        &run(&["sweep", "merge", "study.toml", "-o", "w"]),
    );
    let axes = ["--torque", "60,183.4", "--speed", "25..4400:7:log"];
    let design = ["design", "rig.toml", "--simulate", "4", "-o", "d"];
    check("d", "design", &run(&[&design[..], &axes].concat()));
    let calibrate = ["calibrate", "d/simulated.csv", "rig.toml", "-o", "b"];
    check("b", "calibration", &run(&calibrate));
    let plan = ["oil", "plan", "--oil", "m100", "--simulate", "1", "-o", "p"];
    check("p", "oil_plan", &run(&plan));
    let fit = ["oil", "fit", "p/simulated.csv", "--oil", "m100", "-o", "f"];
    check("f", "oil_fit", &run(&fit));
    bench.write_worn("pinion.csv", "worn.csv");
    let change = ["profile", "change", "pinion.csv", "worn.csv", "-o", "h"];
    check("h", "change", &run(&change));
    let traction = ["oil", "traction", "m100", "-o", "t"];
    check("t", "traction", &run(&traction));
    let stribeck = [
        "oil",
        "stribeck",
        "stribeck.csv",
        "--oil",
        "m100",
        "-o",
        "k",
    ];
    check("k", "stribeck", &run(&stribeck));
    // A study of a case that needs no settings is run without any.
    for (command, name) in every_study!(without_settings).into_iter().flatten() {
        if !checked.contains_key(name) {
            let said = with(&[command, "case.toml", "-o", name]);
            checked.insert(name, agree(&bench, name, name, &said));
        }
    }
    assert!(checked.values().all(|cells| *cells > 0), "{checked:?}");
    // No study is left out.
    let folders = ["crates/studies/src", "crates/calibration/src"];
    let texts = folders.map(|folder| sources(&root().join(folder)));
    let all = texts.concat().join("\n");
    let mut rest = all.as_str();
    while let Some((name, after)) = between(rest, "const NAME: &'static str = \"", "\"") {
        assert!(checked.contains_key(name), "{name} is not in this test");
        rest = after;
    }
}

/// The command of a study of a case alone that needs no settings, and the name of its JSON file.
fn without_settings<S: StudySettings>() -> Option<(&'static str, &'static str)> {
    let is_of_case = matches!(&S::Input::described()[..], [only] if only.kind == "Case");
    (is_of_case && S::usual().is_ok()).then_some((S::COMMAND, S::Found::NAME))
}

/// Texts of the sources in a folder.
fn sources(folder: &std::path::Path) -> Vec<String> {
    let entries = fs::read_dir(folder)
        .unwrap()
        .map(|entry| entry.unwrap().path());
    entries
        .flat_map(|path| {
            if path.is_dir() {
                sources(&path)
            } else {
                vec![fs::read_to_string(&path).unwrap()]
            }
        })
        .collect()
}
