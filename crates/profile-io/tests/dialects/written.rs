//! How tables are written: separators, decimal signs, encodings, columns.

use asperity_core::quantity::Length;
use asperity_profile_io::Warning;
use asperity_profile_io::read::{
    Columns, DecimalSign, Encoding, Gaps, LengthUnit, ReadOptions, Separator, read, read_bytes,
};

use super::table::*;

#[test]
fn every_separator_and_decimal_sign_reads_the_same() {
    let german = Dialect {
        header: "Weg [mm];Höhe [µm]",
        end: "\r\n",
        between: ";",
        decimal: ',',
        x_per_um: 1e-3,
        ..PLAIN
    };
    let cases = [
        (PLAIN, Separator::Comma, DecimalSign::Point),
        (german, Separator::Semicolon, DecimalSign::Comma),
        (
            Dialect {
                header: "x_um\tz_um",
                between: "\t",
                ..PLAIN
            },
            Separator::Tab,
            DecimalSign::Point,
        ),
        (
            Dialect {
                header: "# x (um)   z (um)",
                between: "   ",
                after: "      ",
                ..PLAIN
            },
            Separator::Blank,
            DecimalSign::Point,
        ),
        (
            Dialect {
                header: "[um] [um]",
                between: " ",
                decimal: ',',
                ..PLAIN
            },
            Separator::Blank,
            DecimalSign::Comma,
        ),
        (
            Dialect {
                after: ",",
                ..PLAIN
            },
            Separator::Comma,
            DecimalSign::Point,
        ),
        (
            Dialect {
                after: " , ,",
                between: " , ",
                ..PLAIN
            },
            Separator::Comma,
            DecimalSign::Point,
        ),
        (
            Dialect {
                header: "x / nm;z / mm",
                between: ";",
                x_per_um: 1e3,
                z_per_um: 1e-3,
                ..PLAIN
            },
            Separator::Semicolon,
            DecimalSign::Point,
        ),
        (
            Dialect {
                end: "\r\r\n",
                ..PLAIN
            },
            Separator::Comma,
            DecimalSign::Point,
        ),
        (
            Dialect { end: "\r", ..PLAIN },
            Separator::Comma,
            DecimalSign::Point,
        ),
        (
            Dialect {
                end: "\n\n",
                ..PLAIN
            },
            Separator::Comma,
            DecimalSign::Point,
        ),
    ];
    for (dialect, separator, decimal) in cases {
        let reading = read_text(&dialect.text()).unwrap();
        check(&reading);
        let table = reading.table.unwrap();
        assert_eq!((table.separator, table.decimal), (separator, decimal));
        assert_eq!(reading.warnings, []);
    }
}

#[test]
fn every_encoding_reads_the_same() {
    let text = Dialect {
        header: "x [µm],z [µm]",
        ..PLAIN
    }
    .text();
    let utf16 = |big: bool, mark: bool| -> Vec<u8> {
        let marked = if mark {
            format!("\u{feff}{text}")
        } else {
            text.clone()
        };
        let units = marked.encode_utf16();
        if big {
            units.flat_map(u16::to_be_bytes).collect()
        } else {
            units.flat_map(u16::to_le_bytes).collect()
        }
    };
    let latin1: Vec<u8> = text.chars().map(|c| c as u8).collect();
    for (bytes, encoding) in [
        (text.clone().into_bytes(), Encoding::Utf8),
        (format!("\u{feff}{text}").into_bytes(), Encoding::Utf8),
        (utf16(false, true), Encoding::Utf16Le),
        (utf16(true, true), Encoding::Utf16Be),
        (utf16(false, false), Encoding::Utf16Le),
        (utf16(true, false), Encoding::Utf16Be),
        (latin1, Encoding::Windows1252),
    ] {
        let reading = read_bytes("flank.csv", &bytes, &ReadOptions::default()).unwrap();
        check(&reading);
        assert_eq!(reading.encoding, Some(encoding));
    }
}

#[test]
fn an_absolute_offset_and_a_valid_flag_are_understood() {
    let mut text = String::from("X;Y;valid\r\n[mm];[mm];[1/0]\r\n");
    for i in 0..POINTS {
        text += &format!(
            "{:.6};{:.6};1\r\n",
            8.6722 + 0.0005 * i as f64,
            106.6 + height(i) * 1e-3
        );
    }
    let reading = read_bytes("flank.hfm", text.as_bytes(), &ReadOptions::default()).unwrap();
    assert_eq!(
        (reading.x_unit, reading.z_unit),
        (Some(LengthUnit::Millimetre), LengthUnit::Millimetre)
    );
    assert!((reading.spacing.si() - 0.5e-6).abs() < 1e-14);
    assert!((reading.profile.heights()[3] - 0.1066 - height(3) * 1e-6).abs() < 1e-9);

    let broken = text.replacen("1\r\n8.6742", "0\r\n8.6742", 1);
    assert_ne!(broken, text);
    let refused = read_text(&broken).unwrap_err();
    assert_eq!(refused.code(), "E107");
    let start = format!("flank.csv:6: 1 of {POINTS} points have no height, the first reads ");
    assert!(refused.to_string().starts_with(&start), "{refused}");
    assert_eq!(
        refused.remedy().to_string(),
        "Set gaps to interpolate to fill them"
    );
    let options = ReadOptions {
        gaps: Gaps::Interpolate,
        ..ReadOptions::default()
    };
    let filled = read_bytes("flank.hfm", broken.as_bytes(), &options).unwrap();
    assert_eq!((filled.gaps_filled, filled.points), (1, POINTS));
    assert_eq!(
        filled.warnings,
        [Warning::GapsFilled {
            filled: 1,
            longest: 1,
            cut: 0
        }]
    );
    let z = filled.profile.heights();
    assert!((z[3] - 0.5 * (z[2] + z[4])).abs() < 1e-16);
}

#[test]
fn a_header_names_the_columns_in_any_order() {
    let mut text = String::from("No,z [nm],flag,x [mm]\n");
    for i in 0..POINTS {
        text += &format!("{i},{:.3},1,{:.6}\n", 1e3 * height(i), 0.0005 * i as f64);
    }
    let reading = read_text(&text).unwrap();
    assert_eq!(reading.table.unwrap().columns, Columns { x: Some(4), z: 2 });
    check(&reading);
    let bare: String = text.lines().skip(1).flat_map(|line| [line, "\n"]).collect();
    assert_eq!(read_text(&bare).unwrap_err().code(), "E112");
    let options = ReadOptions {
        columns: Some("4,2".parse().unwrap()),
        x_unit: Some(LengthUnit::Millimetre),
        z_unit: Some(LengthUnit::Nanometre),
        ..ReadOptions::default()
    };
    check(&read_bytes("flank.csv", bare.as_bytes(), &options).unwrap());
}

#[test]
fn a_height_column_beyond_the_second_needs_no_x_when_the_spacing_is_stated() {
    // Found by fuzzing: the place of an x among two columns was computed for three.
    let text: String = (0..POINTS)
        .map(|i| format!("{i};7;{:.4}\n", height(i)))
        .collect();
    let text = format!("Nr;flag;z [um]\n{text}");
    assert_eq!(read_text(&text).unwrap_err().code(), "E112");
    let options = ReadOptions {
        dx: Some(Length::from_si(0.5e-6)),
        ..ReadOptions::default()
    };
    let reading = read_bytes("a.csv", text.as_bytes(), &options).unwrap();
    assert_eq!(reading.table.unwrap().columns, Columns { x: None, z: 3 });
}

#[test]
fn a_file_on_disk_reads_like_its_bytes_and_the_echo_holds_no_heights() {
    let folder = tempfile::tempdir().unwrap();
    let path = folder.path().join("flank.csv");
    std::fs::write(&path, PLAIN.text()).unwrap();
    let reading = read(&path, &ReadOptions::default()).unwrap();
    check(&reading);
    let echo = serde_json::to_value(&reading).unwrap();
    assert_eq!(echo["points"], POINTS);
    assert_eq!(echo["spacing"], "500 nm");
    assert_eq!(echo.get("profile"), None);
    let gone = read(&folder.path().join("gone.csv"), &ReadOptions::default()).unwrap_err();
    assert_eq!(gone.code(), "E103");
}

#[test]
fn options_read_from_text_as_a_case_file_writes_them() {
    let text = r#"{"x-unit": "mm", "z-unit": "um", "dx": "0.5 um", "decimal": "comma", "gaps": "interpolate"}"#;
    let options: ReadOptions = serde_json::from_str(text).unwrap();
    assert_eq!(options.dx, Some(Length::from_si(0.5e-6)));
    assert_eq!(
        (options.x_unit, options.gaps),
        (Some(LengthUnit::Millimetre), Gaps::Interpolate)
    );
    assert!(serde_json::from_str::<ReadOptions>(r#"{"unit": "mm"}"#).is_err());
}
