//! Meaning of the numbers of a table: spacing, units, order.

use asperity_core::Code;
use asperity_core::quantity::Length;
use asperity_profile_io::Warning;
use asperity_profile_io::read::{
    Axis, FilterState, Format, LengthUnit, ReadOptions, SpacingSource, read_bytes,
};

use super::table::*;

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
            .contains("no unit found for the heights, which span 12"),
        "{refused}"
    );
    assert!(
        refused.remedy().to_string() == "Set z_unit to um | nm",
        "{refused}"
    );
    let furlong = Dialect {
        header: "x [mm],z [furlong]",
        x_per_um: 1e-3,
        ..PLAIN
    };
    assert_eq!(read_text(&furlong.text()).unwrap_err().code(), "E114");
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
    let no_spacing = "no x column and no spacing of the points was found";
    assert_eq!(plain.code(), "E110");
    assert_eq!(plain.fault.to_string(), no_spacing);
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
    assert_eq!(refused.code(), "E110");
    let hint = format!("{no_spacing}; line 1 reads 5600 and is written differently from the rest");
    assert!(refused.fault.to_string().starts_with(&hint), "{refused}");
    let reading = read_bytes("a.txt", npl.as_bytes(), &options).unwrap();
    check(&reading);
    assert_eq!(reading.format, Format::NplText);
    let wrong = ReadOptions {
        dx: Some(Length::from_si(0.25e-6)),
        ..options.clone()
    };
    let refused = read_bytes("a.txt", npl.as_bytes(), &wrong).unwrap_err();
    assert_eq!(refused.code(), "E117", "{refused}");

    // The number of heights, with conditions above it or without.
    for above in [
        "",
        "\" TEST \"\r\nDATE2026/11/02,TIME 10:12:00\r\nRa 0.32 um\r\n",
    ] {
        let counted = format!("{above}{POINTS}\r\n{column}");
        let reading = read_bytes("a.txt", counted.as_bytes(), &options).unwrap();
        check(&reading);
        assert_eq!(
            (reading.format, reading.points),
            (Format::DelimitedText, POINTS)
        );
        let refused = read_text(&counted).unwrap_err();
        assert_eq!(refused.code(), "E110");
        assert_eq!(refused.fault.to_string(), no_spacing);
        // Another number is neither.
        let other = format!("{above}{}\r\n{column}", POINTS + 7);
        let refused = read_bytes("a.txt", other.as_bytes(), &options).unwrap_err();
        assert_eq!(refused.code(), "E117", "{refused}");
    }

    let surfcom = format!("10.00000\r\n{POINTS}\r\n{column}");
    let refused = read_text(&surfcom).unwrap_err();
    assert_eq!(refused.code(), "E110");
    let hint = format!(
        "{no_spacing}; this is a Surfcom text profile, whose header gives the nominal length 10 mm and {POINTS} points. "
    );
    assert!(refused.fault.to_string().starts_with(&hint), "{refused}");
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
    assert_eq!(
        (refused.code(), refused.place().1),
        (Code::E105, Some(51)),
        "{refused}"
    );

    let mut lost = lines.clone();
    lost.remove(100);
    let refused = read_text(&joined(&lost)).unwrap_err();
    assert_eq!(
        (refused.code(), refused.place().1),
        (Code::E109, Some(101)),
        "{refused}"
    );

    let short = read_text(&joined(&lines[..12])).unwrap_err();
    assert_eq!(
        short.to_string(),
        "flank.csv: 11 points; a roughness profile needs at least 100"
    );
}

#[test]
fn a_lost_row_shows_on_whole_numbers_too() {
    let row = |i: usize| format!("{i};{:.3}\n", height(i));
    let text: String = (0..300).filter(|i| *i != 77).map(row).collect();
    let file = format!("x [um];z [um]\n{text}");
    let refused = read_text(&file).unwrap_err();
    assert_eq!(
        (refused.code(), refused.place().1),
        (Code::E109, Some(79)),
        "{refused}"
    );
}

#[test]
fn x_that_counts_points_is_no_length() {
    let text: String = (0..POINTS)
        .map(|i| format!("{i} {:.6}\n", height(i)))
        .collect();
    let refused = read_text(&text).unwrap_err();
    assert_eq!(refused.code(), "E110");
    assert_eq!(
        refused.fault.to_string(),
        "x counts the points, and no spacing of them was found"
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
