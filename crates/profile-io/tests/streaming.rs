//! Files larger than what is looked at first: nothing depends on where chunks and heads end.

#![allow(clippy::unwrap_used, clippy::panic)]

use std::io::{Cursor, Error, Read, Result, Seek, SeekFrom};

use asperity_core::Code;
use asperity_profile_io::Warning;
use asperity_profile_io::read::{
    Encoding, Gaps, ReadError, ReadOptions, read, read_bytes, read_stream,
};

/// Rows of some fifteen bytes: beyond the 256 KiB that are looked at first.
const POINTS: usize = 25_000;

/// Height of point `i` in um, to the four decimals that are written.
fn height(i: usize) -> f64 {
    (((0.037 * i as f64).sin() * 6.0) * 1e4).round() / 1e4
}

fn row(i: usize) -> String {
    format!("{:.1};{:.4}\n", 0.5 * i as f64, height(i))
}

fn table(rows: impl Iterator<Item = usize>) -> String {
    let rows: String = rows.map(row).collect();
    format!("x [um];z [um]\n{rows}")
}

fn refused(text: &str) -> ReadError {
    read_bytes("a.csv", text.as_bytes(), &ReadOptions::default()).unwrap_err()
}

#[test]
fn every_height_of_a_long_file_is_read_in_its_place() {
    let text = table(0..POINTS);
    assert!(text.len() > 300_000);
    let options = ReadOptions::default();
    let reading = read_bytes("a.csv", text.as_bytes(), &options).unwrap();
    let heights: Vec<f64> = (0..POINTS).map(|i| height(i) / 1e6).collect();
    assert_eq!(reading.profile.heights(), heights);
    let ends = text.replace('\n', "\r\r\n");
    let quoted = text.replace(';', ";\"").replace('\n', "\"\n");
    let filled = format!("{text}{}", "\0".repeat(100_000));
    for other in [ends, quoted, filled] {
        let other = read_bytes("a.csv", other.as_bytes(), &options).unwrap();
        assert_eq!(other.profile, reading.profile);
    }
    let utf16: Vec<u8> = text.encode_utf16().flat_map(u16::to_be_bytes).collect();
    let other = read_bytes("a.csv", &utf16, &options).unwrap();
    assert_eq!(
        (other.encoding, other.profile),
        (Some(Encoding::Utf16Be), reading.profile)
    );
}

#[test]
fn a_byte_far_down_that_is_no_utf_8_makes_the_file_windows_1252() {
    // As in "z °" or an "ö" of a comment below the table's start.
    let text = table(0..POINTS)
        .replacen("x [um];z [um]", "x [um];z [um];", 1)
        .replace('\n', ";\n");
    let mut bytes = text.clone().into_bytes();
    let end = bytes.len() - 2;
    bytes[end] = 0xb0;
    let refused = read_bytes("a.csv", &bytes, &ReadOptions::default()).unwrap_err();
    assert!(refused.to_string().contains("°"), "{refused}");
    let text = format!("Höhe über Weg\n{}", table(0..POINTS));
    let whole = read_bytes("a.csv", text.as_bytes(), &ReadOptions::default()).unwrap();
    let latin1: Vec<u8> = text.chars().map(|c| c as u8).collect();
    let other = read_bytes("a.csv", &latin1, &ReadOptions::default()).unwrap();
    assert_eq!(
        (whole.encoding, other.encoding),
        (Some(Encoding::Utf8), Some(Encoding::Windows1252))
    );
    assert_eq!(whole.profile, other.profile);
}

#[test]
fn what_is_wrong_far_down_is_named_by_its_line() {
    let lines = |from: &str, to: &str| table(0..POINTS).replacen(from, to, 1);
    // The header is line 1, point i stands on line i + 2.
    let cell = row(20_000);
    let damaged = lines(&cell, &cell.replace(';', ";1.O"));
    let expected = format!("a.csv:20002: cannot read \"1.O{:.4}\"", height(20_000));
    assert!(
        refused(&damaged).to_string().starts_with(&expected),
        "{}",
        refused(&damaged)
    );
    let ragged = lines(&cell, &cell.replace('\n', ";7\n"));
    assert!(
        refused(&ragged)
            .to_string()
            .starts_with("a.csv:20002: 3 columns where other rows have 2")
    );
    let missing = lines(&cell, "10000.0;NaN\n");
    let message = refused(&missing).to_string();
    assert!(
        message.starts_with(
            "a.csv:20002: 1 of 25000 points have no height, the first reads \"10000.0;NaN\""
        ),
        "{message}"
    );
    let turned = refused(&lines(&cell, &row(10)));
    assert_eq!(
        (turned.code(), turned.place().1),
        (Code::E105, Some(20_002)),
        "{turned}"
    );
    let lost = refused(&table((0..POINTS).filter(|i| *i != 20_000)));
    assert_eq!(
        (lost.code(), lost.place().1),
        (Code::E109, Some(20_002)),
        "{lost}"
    );
}

#[test]
fn a_falling_x_is_turned_round_and_its_gaps_are_named_by_their_own_lines() {
    let text = table((0..POINTS).rev());
    let options = ReadOptions::default();
    let reading = read_bytes("a.csv", text.as_bytes(), &options).unwrap();
    assert_eq!(reading.warnings, [Warning::Reversed]);
    assert_eq!(reading.profile.heights()[7], height(7) / 1e6);
    // Blank lines are none of the rows, but have numbers: point 5 stands on line 25 000 - 5 + 2.
    let gap = text
        .replacen(&row(5), "2.5;***\n", 1)
        .replacen(&row(9), "4.5;***\n\n\n", 1);
    let refused = read_bytes("a.csv", gap.as_bytes(), &options).unwrap_err();
    let message = refused.to_string();
    assert!(
        message.starts_with(
            "a.csv:24998: 2 of 25000 points have no height, the first reads \"2.5;***\""
        ),
        "{message}"
    );
    let options = ReadOptions {
        gaps: Gaps::Interpolate,
        ..options
    };
    let filled = read_bytes("a.csv", gap.as_bytes(), &options).unwrap();
    assert_eq!(filled.gaps_filled, 2);
}

#[test]
fn a_line_without_end_is_refused() {
    let text = format!("{}{}", table(0..POINTS), "7".repeat(17 << 20));
    let refused = refused(&text);
    assert_eq!(refused.code(), "E118");
    assert!(
        refused.to_string().starts_with("a.csv: a line has "),
        "{refused}"
    );
}

/// Bytes whose end cannot be read.
struct Broken(Cursor<Vec<u8>>, u64);

impl Read for Broken {
    fn read(&mut self, buffer: &mut [u8]) -> Result<usize> {
        if self.0.position() >= self.1 {
            return Err(Error::other("bad sector"));
        }
        self.0.read(buffer)
    }
}

impl Seek for Broken {
    fn seek(&mut self, to: SeekFrom) -> Result<u64> {
        self.0.seek(to)
    }
}

#[test]
fn a_file_that_cannot_be_read_to_its_end_is_refused() {
    let stream = Broken(Cursor::new(table(0..POINTS).into_bytes()), 300_000);
    let refused = read_stream("a.csv", stream, &ReadOptions::default()).unwrap_err();
    assert_eq!(refused.code(), "E103");
    assert!(refused.to_string().contains("bad sector"), "{refused}");
    let folder = tempfile::tempdir().unwrap();
    let refused = read(folder.path(), &ReadOptions::default()).unwrap_err();
    assert_eq!(refused.code(), "E103");
}

#[test]
fn a_long_surfcom_file_is_told_by_the_number_of_its_heights() {
    let heights: String = (0..POINTS)
        .map(|i| format!("{:.4}\r\n", height(i)))
        .collect();
    for (stated, code) in [(POINTS, "Surfcom"), (POINTS + 1, "no spacing")] {
        let text = format!("12.50000\r\n{stated}\r\n{heights}");
        let refused = read_bytes("a.txt", text.as_bytes(), &ReadOptions::default()).unwrap_err();
        assert_eq!(refused.code(), "E110");
        assert_eq!(
            refused.to_string().contains("Surfcom"),
            code == "Surfcom",
            "{refused}"
        );
    }
}
