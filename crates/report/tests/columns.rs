//! Tables in the terminal.

use asperity_report::{Report, columns};

#[test]
fn a_long_text_in_the_last_column_stays_in_its_column() {
    let long = "left out: the film is thinner than three times the roughness of both specimens";
    let rows = [(9.25, "1 2 3"), (2.125, long), (4.0, "")];
    let table = columns! { (ratio, slides) in rows;
        number ratio "film over roughness" "" "{:.1}" = ratio;
        text slides "slide-to-roll ratios" "%" = slides;
    };
    let lines = [
        "film over",
        "roughness  slide-to-roll ratios [%]",
        "      9.2  1 2 3",
        "      2.1  left out: the film is thinner than three times the roughness of both",
        "           specimens",
        "      4.0",
    ];
    assert_eq!(table.text("").lines().collect::<Vec<_>>(), lines);
}

#[test]
fn columns_are_added_and_left_out_by_their_headings() {
    let table = || {
        let first = columns! { k in 1..=2_usize; number square "square" "mm²" = k * k; };
        first.with(columns! { k in 1..=2_usize; number cube "cube" "mm³" = k * k * k; })
    };
    assert_eq!(
        table().text("  "),
        "  square   cube\n   [mm²]  [mm³]\n       1      1\n       4      8\n"
    );
    let squares = table().brief(&["cube"]).text("");
    assert_eq!(squares.lines().last(), Some("     4"));
    let none = columns! { loss in [None, Some(0.125)]; number loss "loss" "W" "{:.2}" = loss; };
    assert_eq!(none.text("").lines().nth(2), Some("   -"));
}

#[test]
fn a_first_screen_keeps_a_short_warning_and_counts_the_others() {
    let rows = || columns! { k in 1..=20_usize; number number "number" "" = k; };
    let warnings = ["W436 one parameter is held", "W431 the gearbox is left out"];
    let report = Report::new("A study", "example")
        .section("Result")
        .verdict(["It pays."])
        .table(rows())
        .warning(warnings);
    let (text, left_out) = report.brief(6);
    let lines: Vec<&str> = text.lines().map(str::trim).collect();
    assert_eq!(lines[..2], ["A study", "It pays."]);
    assert_eq!(lines.len(), 6);
    assert!(lines.contains(&warnings[0]), "{text}");
    assert!(!text.contains("W431"), "{text}");
    assert_eq!(left_out.warnings, 1);
    assert_eq!(
        lines.len() + left_out.lines,
        report.terminal().lines().count()
    );
    assert_eq!(
        left_out.to_string(),
        format!("{} more lines with 1 warning", left_out.lines)
    );
}

#[test]
fn a_first_screen_has_so_many_lines_at_most_whatever_a_report_holds() {
    let long = "A sentence that is longer than a line of a terminal, as those that name several finishes are. ".repeat(3);
    for (verdicts, rows) in [(0, 0), (1, 1), (3, 40), (12, 3_usize)] {
        for warnings in [0, 1, 5] {
            let table = columns! { k in 1..=rows; number number "number" "" = k; };
            let report = Report::new("A study", "example")
                .section("Result")
                .verdict(vec![&*long; verdicts])
                .text(vec![&*long; verdicts])
                .heading("Points")
                .table(table)
                .warning(vec![&*long; warnings]);
            for lines in 3..=12 {
                let (text, left_out) = report.brief(lines);
                assert!(text.lines().count() <= lines, "{lines}:\n{text}");
                let all = report.terminal().lines().count();
                assert_eq!(text.lines().count() + left_out.lines, all);
            }
        }
    }
}
