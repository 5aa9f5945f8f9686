//! Every dialect of delimited text that labs send, made in memory and read back.

#![allow(clippy::unwrap_used, clippy::panic)]

use asperity_core::quantity::Length;
use asperity_roughness::Warning;
use asperity_roughness::read::{
    Axis, Columns, DecimalSign, Encoding, FilterState, Format, Gaps, LengthUnit, ReadError,
    ReadOptions, Reading, Separator, SpacingHint, SpacingSource, read, read_bytes,
};

const POINTS: usize = 240;

/// Height of point `i` in um: twelve um of span, not periodic in the rows.
fn height(i: usize) -> f64 {
    6.0 * (0.37 * i as f64).sin() + 0.01 * i as f64
}

/// A file of x and height: header, line end, separator, decimal sign, scale of x and z to um.
struct Dialect {
    header: &'static str,
    end: &'static str,
    between: &'static str,
    after: &'static str,
    decimal: char,
    x_per_um: f64,
    z_per_um: f64,
}

const PLAIN: Dialect = Dialect {
    header: "x in um,z in um",
    end: "\n",
    between: ",",
    after: "",
    decimal: '.',
    x_per_um: 1.0,
    z_per_um: 1.0,
};

impl Dialect {
    fn text(&self) -> String {
        let number = |value: f64| format!("{value:.9}").replace('.', &self.decimal.to_string());
        let mut text = String::new();
        if !self.header.is_empty() {
            text += &format!("{}{}", self.header, self.end);
        }
        for i in 0..POINTS {
            let (x, z) = (0.5 * i as f64 * self.x_per_um, height(i) * self.z_per_um);
            text += &format!(
                "{}{}{}{}{}",
                number(x),
                self.between,
                number(z),
                self.after,
                self.end
            );
        }
        text
    }
}

fn check(reading: &Reading) {
    assert_eq!(reading.points, POINTS);
    assert!(
        (reading.spacing.si() - 0.5e-6).abs() < 1e-15,
        "{}",
        reading.spacing
    );
    for (i, z) in reading.profile.heights().iter().enumerate() {
        // Nine decimals of a millimetre are a picometre.
        assert!((z - height(i) * 1e-6).abs() < 1e-12, "{i}");
    }
}

fn read_text(text: &str) -> Result<Reading, ReadError> {
    read_bytes("flank.csv", text.as_bytes(), &ReadOptions::default())
}

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
    assert!(
        matches!(
            refused,
            ReadError::MissingPoints {
                line: 6,
                missing: 1,
                fillable: true,
                ..
            }
        ),
        "{refused}"
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
fn missing_heights_are_refused_by_line_whatever_they_are_called() {
    for word in ["NaN", "Bad", "", "***", "inf"] {
        let text = PLAIN.text();
        let third = text.lines().nth(3).unwrap();
        let broken = text.replace(third, &format!("1.000000000,{word}"));
        let refused = read_text(&broken).unwrap_err();
        assert_eq!(refused.code(), "E107");
        assert!(
            refused
                .to_string()
                .starts_with("flank.csv:4: 1 of 240 points"),
            "{refused}"
        );
    }
}

#[test]
fn the_spacing_is_that_of_the_whole_length_when_x_is_rounded() {
    // dx = 0.0996 um written to 0.1 um: most differences read 0.1, some 0.
    let mut text = String::from("x [um];z [um]\n");
    for i in 0..2000 {
        text += &format!("{:.1};{:.4}\n", 0.0996 * f64::from(i), height(i as usize));
    }
    let reading = read_text(&text).unwrap();
    let expected = 0.0996e-6;
    // Both ends are rounded by up to 0.05 um of 199 um.
    assert!(
        (reading.spacing.si() / expected - 1.0).abs() < 5e-4,
        "{}",
        reading.spacing
    );
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
fn a_missing_unit_is_assumed_only_when_no_other_is_possible() {
    let mm = Dialect {
        header: "",
        between: "\t",
        x_per_um: 1e-3,
        z_per_um: 1e-3,
        ..PLAIN
    };
    let reading = read_text(&mm.text()).unwrap();
    check(&reading);
    let assumed = |axis| Warning::UnitAssumed {
        axis,
        unit: LengthUnit::Millimetre,
    };
    assert_eq!(
        reading.warnings,
        [assumed(Axis::Trace), assumed(Axis::Height)]
    );
    // 0.12 mm of trace and 12 units of height: neither mm nor um heights are impossible in nm files.
    let nm = Dialect {
        header: "",
        x_per_um: 1e-3,
        z_per_um: 1e3,
        ..PLAIN
    };
    let refused = read_text(&nm.text()).unwrap_err();
    assert_eq!(refused.code(), "E104");
    assert!(
        refused
            .to_string()
            .contains("no unit found and heights span 14"),
        "{refused}"
    );
    assert!(
        refused.to_string().ends_with("Say --z-unit um | nm | mm"),
        "{refused}"
    );
    let inch = Dialect {
        header: "x [mm],z [inch]",
        x_per_um: 1e-3,
        ..PLAIN
    };
    assert_eq!(read_text(&inch.text()).unwrap_err().code(), "E114");
}

#[test]
fn heights_alone_need_a_spacing_and_header_numbers_are_no_heights() {
    let column: String = (0..POINTS)
        .map(|i| format!("{:.6}\r\n", height(i)))
        .collect();
    let options = ReadOptions {
        dx: Some(Length::from_si(0.5e-6)),
        z_unit: Some(LengthUnit::Micrometre),
        ..ReadOptions::default()
    };
    let plain = read_text(&column).unwrap_err();
    assert!(
        matches!(
            plain,
            ReadError::NoSpacing {
                hint: SpacingHint::None,
                ..
            }
        ),
        "{plain}"
    );
    let reading = read_bytes("a.txt", column.as_bytes(), &options).unwrap();
    check(&reading);
    assert_eq!(
        (reading.spacing_source, reading.x_unit),
        (SpacingSource::Stated, None)
    );

    let npl = format!("0.500\r\n{column}");
    let reading = read_text(&npl).unwrap();
    check(&reading);
    assert_eq!(reading.spacing_source, SpacingSource::FirstLine);
    assert_eq!(
        reading.warnings,
        [Warning::SpacingFromFirstLine { value: 0.5 }]
    );
    // 5600 is no spacing in um: it may be a length.
    let refused = read_text(&npl.replacen("0.500", "5600", 1)).unwrap_err();
    assert!(
        matches!(
            refused,
            ReadError::NoSpacing {
                hint: SpacingHint::FirstLine(5600.0),
                ..
            }
        ),
        "{refused}"
    );
    let reading = read_bytes("a.txt", npl.as_bytes(), &options).unwrap();
    check(&reading);
    assert_eq!(reading.format, Format::NplText);
    let wrong = ReadOptions {
        dx: Some(Length::from_si(0.25e-6)),
        ..options.clone()
    };
    assert_eq!(
        read_bytes("a.txt", npl.as_bytes(), &wrong)
            .unwrap_err()
            .code(),
        "E110"
    );

    let surfcom = format!("10.00000\r\n{POINTS}\r\n{column}");
    let refused = read_text(&surfcom).unwrap_err();
    assert!(
        matches!(
            refused,
            ReadError::NoSpacing {
                hint: SpacingHint::NominalLength { points: POINTS, .. },
                ..
            }
        ),
        "{refused}"
    );
    let reading = read_bytes("a.tx2", surfcom.as_bytes(), &options).unwrap();
    check(&reading);
    assert_eq!(
        (reading.format, reading.filter_state),
        (Format::SurfcomText, FilterState::Roughness)
    );
    assert_eq!(reading.warnings, [Warning::AlreadyFiltered]);
}

#[test]
fn x_must_rise_evenly_or_fall_evenly() {
    let text = PLAIN.text();
    let lines: Vec<&str> = text.lines().collect();
    let joined = |lines: &[&str]| lines.join("\n");
    let mut turned = lines.clone();
    turned[1..].reverse();
    let reading = read_text(&joined(&turned)).unwrap();
    check(&reading);
    assert_eq!(reading.warnings, [Warning::Reversed]);

    let mut doubled = lines.clone();
    doubled.insert(50, lines[10]);
    let refused = read_text(&joined(&doubled)).unwrap_err();
    assert!(
        matches!(refused, ReadError::NotMonotone { line: 51, .. }),
        "{refused}"
    );

    let mut lost = lines.clone();
    lost.remove(100);
    let refused = read_text(&joined(&lost)).unwrap_err();
    assert!(
        matches!(refused, ReadError::UnevenSpacing { line: 101, .. }),
        "{refused}"
    );

    let short = read_text(&joined(&lines[..12])).unwrap_err();
    assert_eq!(
        short.to_string(),
        "flank.csv: 11 points; a roughness profile needs at least 100. Export the whole trace"
    );
}

#[test]
fn a_lost_row_shows_on_whole_numbers_too() {
    let row = |i: usize| format!("{i};{:.3}\n", height(i));
    let text: String = (0..300).filter(|i| *i != 77).map(row).collect();
    let file = format!("x [um];z [um]\n{text}");
    let refused = read_text(&file).unwrap_err();
    assert!(
        matches!(refused, ReadError::UnevenSpacing { line: 79, .. }),
        "{refused}"
    );
}

#[test]
fn x_that_counts_points_is_no_length() {
    let text: String = (0..POINTS)
        .map(|i| format!("{i} {:.6}\n", height(i)))
        .collect();
    let refused = read_text(&text).unwrap_err();
    assert!(
        matches!(
            refused,
            ReadError::NoSpacing {
                hint: SpacingHint::XCounts,
                ..
            }
        ),
        "{refused}"
    );
    let options = ReadOptions {
        dx: Some(Length::from_si(0.5e-6)),
        z_unit: Some(LengthUnit::Micrometre),
        ..ReadOptions::default()
    };
    check(&read_bytes("a.txt", text.as_bytes(), &options).unwrap());
}

#[test]
fn a_stated_spacing_wins_over_the_column_and_says_so() {
    let options = ReadOptions {
        dx: Some(Length::from_si(0.4e-6)),
        ..ReadOptions::default()
    };
    let reading = read_bytes("flank.csv", PLAIN.text().as_bytes(), &options).unwrap();
    assert_eq!(reading.spacing, Length::from_si(0.4e-6));
    match reading.warnings.as_slice() {
        [Warning::SpacingOverridden { column, .. }] => {
            assert!((column.si() - 0.5e-6).abs() < 1e-15);
        }
        other => panic!("{other:?}"),
    }
}

#[test]
fn an_unreadable_cell_is_shown_with_what_the_file_looks_like() {
    let german = Dialect {
        header: "x [um];z [um]",
        between: ";",
        decimal: ',',
        ..PLAIN
    };
    let options = ReadOptions {
        decimal: Some(DecimalSign::Point),
        ..ReadOptions::default()
    };
    let refused = read_bytes("flank.csv", german.text().as_bytes(), &options).unwrap_err();
    assert_eq!(
        refused.to_string(),
        "flank.csv:2: cannot read \"0,000000000\" as a number; the file looks like ';' with decimal comma. Try --decimal comma"
    );
    assert_eq!(refused.code(), "E101");
    let text = PLAIN.text();
    let broken = text.replacen("4.500000000,", "4.5O,", 1);
    assert_ne!(broken, text);
    let refused = read_text(&broken).unwrap_err();
    assert_eq!(
        refused.to_string(),
        "flank.csv:11: cannot read \"4.5O\" as a number; the file looks like ',' with decimal point. Correct or remove this line"
    );
    let pairs: String = (0..POINTS)
        .map(|i| format!("0,{:04},1,{:04}\n", 5 * i, 7 * i))
        .collect();
    assert_eq!(read_text(&pairs).unwrap_err().code(), "E113");
}

#[test]
fn formats_that_are_not_read_are_named() {
    for (name, bytes, format) in [
        ("a.mat", b"MATLAB 5.0 MAT-file".as_slice(), Format::Matlab),
        ("a.xls", b"\xd0\xcf\x11\xe0\xa1\xb1\x1a\xe1", Format::Excel),
        ("a.opdx", b"VCA DATA\x01\x00", Format::Opdx),
        ("a.hwp", b"\x00\x01\x02\x03", Format::HommelHwp),
        ("a.pcd", b"\x00\x01\x02\x03", Format::MahrPcd),
        ("a.mnt", b"\x00\x01\x02\x03", Format::DigitalSurf),
        ("a.bin", b"\x00\x01\x02\x03", Format::UnknownBinary),
        ("a.tx3", b"Fecha\t08.04.2025\n", Format::SurfcomConditions),
    ] {
        let refused = read_bytes(name, bytes, &ReadOptions::default()).unwrap_err();
        assert_eq!(refused.code(), "E108");
        assert!(
            matches!(refused, ReadError::FormatNotRead { format: found, .. } if found == format),
            "{refused}"
        );
        assert!(
            refused.to_string().contains("is not read by this version"),
            "{refused}"
        );
    }
    let empty = read_text("").unwrap_err();
    assert_eq!(empty.code(), "E102");
    assert_eq!(
        read_text("no numbers\nat all\n").unwrap_err().code(),
        "E102"
    );
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
