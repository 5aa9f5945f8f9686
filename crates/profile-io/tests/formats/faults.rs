//! Heights that are not numbers, in the text of every instrument: one is a damaged file, many alike are a dialect of it.

use asperity_profile_io::read::{ReadError, ReadOptions, read_bytes};

use super::areal_files;
use super::samples::*;

/// A text of every format with its name and the beginning of its heights.
fn texts() -> Vec<(&'static str, String, &'static str)> {
    let surfcom = format!("0.12\n{POINTS}\n{}", rows(|z| format!("{z:.4}\n")));
    let zygo = String::from_utf8(areal_files::zygo_xyz()).unwrap();
    vec![
        ("a.prf", prf(), "COMMENT flank 7\r\nEOR\r\n"),
        ("b.smd", smd_with_blanks(), "LC 8.0e-1\r\n\r\n"),
        ("a.sdf", sdf(1), "\n*\n"),
        ("a.pr", pr(false), "240\r\n"),
        ("a.sig", sig(), "PROFILE_UM:\r\n"),
        ("a.tx1", surfcom, "240\n"),
        ("a.txt", mahr(), "C,Lock\r\n"),
        ("a.xyz", zygo, "#\n"),
    ]
}

/// The text with the height of every line from `from` to `to` of its heights rewritten.
fn rewritten(
    text: &str,
    begin: &str,
    (from, to): (usize, usize),
    rewrite: &dyn Fn(&str) -> String,
) -> String {
    let header = text[..text.find(begin).unwrap() + begin.len()]
        .lines()
        .count();
    let line = |(at, line): (usize, &str)| {
        let row = at
            .checked_sub(header)
            .filter(|row| (from..to).contains(row));
        let mut cells: Vec<String> = line.split(' ').map(str::to_owned).collect();
        // The third value of a point of Mahr and of Zygo, otherwise the only one.
        let height = cells.len().min(3) - 1;
        if row.is_some() {
            cells[height] = rewrite(&cells[height]);
        }
        cells.join(" ") + "\n"
    };
    text.lines().enumerate().map(line).collect()
}

fn refused(name: &str, text: &str) -> ReadError {
    let options = ReadOptions {
        row: (name == "a.xyz").then_some(1),
        dx: (name == "a.tx1").then(|| "0.5 um".parse().unwrap()),
        ..ReadOptions::default()
    };
    read_bytes(name, text.as_bytes(), &options).unwrap_err()
}

#[test]
fn many_bad_heights_of_an_instrument_say_what_the_file_seems_to_be() {
    type Kind<'a> = (&'a str, &'a dyn Fn(&str) -> String, &'a str, &'a str);
    let kinds: [Kind<'_>; 3] = [
        (
            "mark",
            &|_| "1.#LOST".to_owned(),
            "mark missing points with \"1.#LOST\"",
            "Write NaN instead of the mark",
        ),
        (
            "unit",
            &|z| format!("{z}um"),
            "followed by the unit \"um\"",
            "Remove \"um\" from all heights",
        ),
        (
            "separator",
            &|z| format!("{z};"),
            "another decimal sign or separator",
            "Export it again, or as text",
        ),
    ];
    for (name, text, begin) in texts() {
        for (kind, rewrite, seems, advice) in kinds {
            let with = |count: usize| rewritten(&text, begin, (20, 20 + count), rewrite);
            let about = format!("{name} {kind}");
            let of_file = refused(name, &with(12));
            let said = of_file.to_string();
            assert_eq!(of_file.code(), "E117", "{about}: {said}");
            for part in ["; 12 lines look like this: line ", seems] {
                assert!(said.contains(part), "{about}: {part} is not in {said}");
            }
            let remedy = of_file.remedy().to_string();
            assert!(remedy.starts_with(advice), "{about}: {remedy}");
            // Nine are single faults of a damaged file.
            let single = refused(name, &with(9));
            assert!(!single.to_string().contains("look like this"), "{about}");
            assert_eq!(single.remedy().to_string(), "Export it again, or as text");
        }
    }
}

#[test]
fn a_mark_of_a_missing_height_is_known_in_every_text_of_an_instrument() {
    for (name, text, begin) in texts() {
        for mark in ["NaN", "BAD", "---", "OVER", "****", "<<<"] {
            let text = rewritten(&text, begin, (20, 23), &|_| mark.to_owned());
            let refused = refused(name, &text);
            assert_eq!(refused.code(), "E107", "{name} {mark}: {refused}");
        }
    }
}
