//! Tables in workbooks, as text.

use asperity_profile_io::read::table_text;

use super::samples::*;

/// A sheet of these rows from row 1 and column A: numbers, texts, and cells that are left out.
fn sheet(rows: &[&[&str]]) -> String {
    let cell = |(row, column, text): (usize, usize, &str)| {
        let place = format!("{}{}", char::from(b'A' + column as u8), row + 1);
        match text.parse::<f64>() {
            _ if text.is_empty() => String::new(),
            // A number may be the result of a formula.
            Ok(_) if column == 1 => format!("<c r=\"{place}\"><f>A1+1</f><v>{text}</v></c>"),
            Ok(_) => format!("<c r=\"{place}\"><v>{text}</v></c>"),
            Err(_) => format!("<c r=\"{place}\" t=\"inlineStr\"><is><t>{text}</t></is></c>"),
        }
    };
    let row = |(row, cells): (usize, &&[&str])| {
        let cells = cells.iter().enumerate();
        let cells: String = cells
            .map(|(column, text)| cell((row, column, text)))
            .collect();
        format!("<row>{cells}</row>")
    };
    let rows: String = rows.iter().enumerate().map(row).collect();
    format!("<worksheet><sheetData>{rows}</sheetData></worksheet>")
}

#[test]
fn the_only_sheet_with_numbers_is_a_table_with_all_of_its_cells() {
    let table: &[&[&str]] = &[&["a", "b"], &["1", "2.5"], &["3", "4"]];
    let expected = "a\tb\n1\t2.5\n3\t4\n";
    type Rows<'a> = &'a [&'a [&'a str]];
    let variants: [(&str, &[Rows<'_>], &str); 12] = [
        ("plain", &[table], expected),
        (
            "notes before",
            &[&[&["Notes"], &["Mass 7"]], table],
            expected,
        ),
        (
            "one number of a note",
            &[table, &[&["mass", "7"]]],
            expected,
        ),
        ("an empty sheet", &[&[], table, &[]], expected),
        (
            "a title and an empty row",
            &[&[&["Trip 7"], &[], &["a", "b"], &["1", "2.5"], &["3", "4"]]],
            "Trip 7\t\n\na\tb\n1\t2.5\n3\t4\n",
        ),
        (
            "an empty first column",
            &[&[&["", "a", "b"], &["", "1", "2.5"], &["", "3", "4"]]],
            expected,
        ),
        (
            "units below the names",
            &[&[&["a", "b"], &["s", "km/h"], &["1", "2"], &["3", "4"]]],
            "a\tb\ns\tkm/h\n1\t2\n3\t4\n",
        ),
        (
            "cells left out",
            &[&[&["a", "b", "c"], &["1", "", "2"], &["3", "4", ""]]],
            "a\tb\tc\n1\t\t2\n3\t4\t\n",
        ),
        (
            "numbers with decimal commas, as texts",
            &[&[&["Zeit [s]", "b"], &["0,5", "2,5"], &["1,5", "3"]]],
            "Zeit [s]\tb\n0,5\t2,5\n1,5\t3\n",
        ),
        (
            "texts in the rows",
            &[&[
                &["a", "b", "c"],
                &["1", "2", "mesh"],
                &["3", "4", "gearbox"],
            ]],
            "a\tb\tc\n1\t2\tmesh\n3\t4\tgearbox\n",
        ),
        (
            "a quote and a line end in a text",
            &[&[&["a", "3&quot; b\nc"], &["1", "2.5"], &["3", "4"]]],
            "a\t3  b c\n1\t2.5\n3\t4\n",
        ),
        (
            "large and small numbers",
            &[&[&["a", "b"], &["1E-7", "-2.5"], &["3000000", "4"]]],
            "a\tb\n0.0000001\t-2.5\n3000000\t4\n",
        ),
    ];
    for (about, sheets, expected) in variants {
        let sheets: Vec<String> = sheets.iter().map(|rows| sheet(rows)).collect();
        let text = table_text("table.xlsx", &xlsx(&sheets));
        assert_eq!(text.unwrap(), expected, "{about}");
        // The name of the file does not matter.
        assert!(table_text("table.csv", &xlsx(&sheets)).is_ok(), "{about}");
    }
    // Cells of an `.ods` with the same content are one cell with a number of repetitions.
    let cell = |count: u32, value: &str| {
        format!(
            "<table-cell number-columns-repeated=\"{count}\" value=\"{value}\"><p>x</p></table-cell>"
        )
    };
    let names = "<table-cell><p>a</p></table-cell><table-cell number-columns-repeated=\"2\"><p>b</p></table-cell>";
    let rows = format!(
        "<table-row>{names}</table-row><table-row>{}{}</table-row><table-row number-rows-repeated=\"2\">{}</table-row>",
        cell(1, "1"),
        cell(2, "0"),
        cell(3, "4")
    );
    let content = format!("<document><table>{rows}</table></document>");
    let mimetype = b"application/vnd.oasis.opendocument.spreadsheet".as_slice();
    let ods = zip(&[("mimetype", mimetype), ("content.xml", content.as_bytes())]);
    let text = table_text("table.ods", &ods).unwrap();
    assert_eq!(text, "a\tb\tb\n1\t0\t0\n4\t4\t4\n4\t4\t4\n");
}

#[test]
fn a_workbook_without_one_table_says_how_to_export_it() {
    let table: &[&[&str]] = &[&["a", "b"], &["1", "2"], &["3", "4"]];
    let refused = |sheets: &[String]| {
        let error = table_text("book.xlsx", &xlsx(sheets)).unwrap_err();
        assert_eq!(error.code(), "E108");
        assert!(
            error
                .remedy()
                .to_string()
                .starts_with("Save the sheet of the table as CSV")
        );
        error.to_string()
    };
    assert_eq!(
        refused(&[sheet(table), sheet(&[&["x"]]), sheet(table)]),
        "book.xlsx: the workbook has numbers on 2 sheets"
    );
    let notes = refused(&[sheet(&[&["mass", "7"], &["length", "3"]])]);
    assert!(notes.contains("not a table"), "{notes}");
    // More texts than are stored: none is left out without a word.
    let many: Vec<Vec<String>> = (0..6000)
        .map(|k| vec![k.to_string(), "1".into(), "x".into()])
        .collect();
    let many: Vec<Vec<&str>> = many
        .iter()
        .map(|row| row.iter().map(String::as_str).collect())
        .collect();
    let many: Vec<&[&str]> = many.iter().map(Vec::as_slice).collect();
    assert!(refused(&[sheet(&many)]).contains("not a table"));
    let broken = table_text("book.xlsx", b"PK\x03\x04\0\0").unwrap_err();
    assert_eq!(broken.code(), "E117", "{broken}");
}
