//! Dialects, names and faults of tables.

#![allow(clippy::unwrap_used, reason = "tests may panic")]

use asperity_table::{Ragged, Table};
use proptest::prelude::*;

fn numbers(text: &str, column: &str) -> Vec<f64> {
    let table = Table::read(text).unwrap();
    table.all(|row| row.number(column)).unwrap()
}

#[test]
fn separator_and_decimal_sign_follow_from_the_table() {
    for text in [
        "a,b\n0.5,1\n-1.5,2\n",
        "a;b\n0.5;1\n-1.5;2\n",
        "a;b\n0,5;1\n-1,5;2\n",
        "a\tb\n0,5\t1\n-1,5\t2\n",
        "\u{feff}# made up\n\na;b\r\n0,5;1\r\n\r\n# a comment\r\n-1,5;2\r\n",
        "\"a\";\"b\"\n\"0,5\";\"1\"\n\"-1,5\";2",
        // Empty cells behind the last column, and rows of separators alone, as spreadsheets write them.
        "a;b;;\n0,5;1;;\n-1,5;2;;\n;;;\n",
    ] {
        assert_eq!(numbers(text, "a"), [0.5, -1.5], "{text:?}");
        assert_eq!(numbers(text, "b"), [1.0, 2.0], "{text:?}");
    }
    // One number with a point: a comma is none of its table's signs, and never a sign of thousands.
    for text in ["a;b\n0.5;1,5\n", "a;b\n1.234,5;1\n", "a,b\n\"0,5\",1\n"] {
        let table = Table::read(text).unwrap();
        let faults = table
            .all(|row| Ok((row.number("a")?, row.number("b")?)))
            .unwrap_err();
        assert!(
            faults[0].rule.contains("is not a finite number"),
            "{faults:?}"
        );
    }
}

#[test]
fn units_stand_in_the_name_or_in_brackets() {
    for (head, name) in [
        ("torque_nm", "torque_nm"),
        ("Torque_Nm", "torque_nm"),
        ("Torque [Nm]", "torque_nm"),
        ("torque [N m]", "torque_nm"),
        ("line load [N/m]", "line_load_n_m"),
        ("Flank state", "flank_state"),
        ("<t>", "<t>"),
        ("Speed [1/min]", "speed_rpm"),
        ("speed (rpm)", "speed_rpm"),
        ("Speed [km/h]", "speed_km_h"),
        ("Temperature [°C]", "temperature_c"),
        ("grade [%]", "grade_percent"),
        ("time[s]", "time_s"),
    ] {
        assert_eq!(Table::read(head).unwrap().names(), [name], "{head}");
    }
}

#[test]
fn every_row_has_its_line_and_all_faults_are_named() {
    let table = Table::read("# one\n\na,b\n1,x\n\n# two\n,3\n4,5\n").unwrap();
    let lines: Vec<usize> = table.rows().map(|row| row.line).collect();
    assert_eq!(lines, [4, 7, 8]);
    let faults = table
        .all(|row| Ok((row.number("a")?, row.number("b")?)))
        .unwrap_err();
    let told: Vec<String> = faults.iter().map(ToString::to_string).collect();
    assert_eq!(
        told,
        ["4: b: \"x\" is not a finite number", "7: a: is missing"]
    );
    assert_eq!(table.rows().next().unwrap().optional("c"), Ok(None));
    let ragged = |text: &str| Table::read(text).unwrap_err();
    let expected = |line, cells| Ragged {
        line,
        cells,
        columns: 2,
        like: None,
    };
    assert_eq!(ragged("a,b\n1,2\n1,2,3\n"), expected(3, 3));
    assert_eq!(ragged("a,b\n1\n"), expected(2, 1));
}

#[test]
fn titles_units_and_names_are_where_other_programs_write_them() {
    for text in [
        "My test rig\ntime,speed\ns,km/h\n0,1\n2,3\n",
        "time;speed\n[s];[km/h]\n0;1\n2;3\n",
        "Test no. 4;;\ntime [s];speed [km/h];\n0;1;\n2;3;\n",
        "time_s speed_km_h\n0   1\n2   3\n",
        "time [s],speed [km/h],remark\n0,1\n2,3\n",
    ] {
        assert_eq!(numbers(text, "time_s"), [0.0, 2.0], "{text:?}");
        assert_eq!(numbers(text, "speed_km_h"), [1.0, 3.0], "{text:?}");
    }
    // Names stated for a table without names, or instead of its own.
    let names = ["time_s", "-", "v"].map(str::to_owned);
    for text in [
        "0,9,1\n2,9,3\n",
        "a,b,c\n0,9,1\n2,9,3\n",
        "0 9  1\n2 9  3",
        "0,0 9 1,5\n2,0 9 3",
    ] {
        let table = Table::named(text, Some(&names)).unwrap();
        let time = table.values(|row| row.number("time_s")).unwrap();
        assert_eq!(time, [0.0, 2.0], "{text:?}");
        assert!(table.has("v") && table.has_names());
    }
    assert!(!Table::read("0,1\n2,3\n").unwrap().has_names());
    // A row of missing values is none of units.
    let table = Table::read("a,b\nx,y\n1,2\n").unwrap();
    assert_eq!(table.rows().len(), 2);
}

#[test]
fn a_fault_that_repeats_is_one_of_the_file() {
    let rows = |row: &str, count: usize| format!("a,b\n1,2\n{}", format!("{row}\n").repeat(count));
    let faults = |text: &str| {
        let table = Table::read(text).unwrap();
        table.all(|row| row.number("b")).unwrap_err()
    };
    assert_eq!(faults(&rows("1,x", 9)).len(), 9);
    let [fault] = &faults(&rows("1,x", 10))[..] else {
        panic!("ten faults are one of the file");
    };
    let expected = "3: b: \"x\" is not a finite number; 10 lines look like this: line 3 \"1 x\", line 4 \"1 x\"";
    assert!(fault.to_string().starts_with(expected), "{fault}");
    let ragged = |count| Table::read(&rows("1,2,3", count)).unwrap_err().to_string();
    assert!(!ragged(9).contains("look like this"));
    assert!(ragged(10).contains("10 lines look like this: line 3 \"1 2 3\""));
}

#[test]
fn no_text_is_no_table() {
    for text in ["", "\n\n", "# a\n", "\u{feff}"] {
        let table = Table::read(text).unwrap();
        assert!(table.names().is_empty() && table.rows().len() == 0);
    }
}

proptest! {
    #[test]
    fn numbers_of_any_dialect_are_those_written(
        values in proptest::collection::vec(-1e6..1e6_f64, 1..20),
        separator in prop::sample::select(vec![';', '\t', ',']),
        comma: bool,
    ) {
        let comma = comma && separator != ',';
        let cell = |value: f64| {
            let text = format!("{value:.6}");
            if comma { text.replace('.', ",") } else { text }
        };
        let mut text = format!("x{separator}y\n");
        for value in &values {
            text += &format!("{}{separator}{}\n", cell(*value), cell(-value));
        }
        for (found, value) in numbers(&text, "x").into_iter().zip(&values) {
            prop_assert!((found - value).abs() <= 5.1e-7);
        }
    }

    #[test]
    fn no_text_panics(text in "\\PC*|[a;,\t\"\n0-9.#]*") {
        if let Ok(table) = Table::read(&text) {
            let _ = table.all(|row| row.number("a"));
        }
    }
}

#[test]
fn rows_have_their_lines_after_line_ends_of_windows_and_quoted_cells() {
    let text = "\u{feff}# made up\r\n\"speed\";\"loss\"\r\n\r\n\"1,5\";\"2\"\r\n\"2,5\";\"x\"\r\n";
    let table = Table::read(text).unwrap();
    let lines: Vec<usize> = table.rows().map(|row| row.line).collect();
    assert_eq!(lines, [4, 5]);
    let faults = table.all(|row| row.number("loss")).unwrap_err();
    assert_eq!(faults[0].line, 5);
}
