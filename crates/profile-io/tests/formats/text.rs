//! Formats of lines.

use asperity_core::Profile;
use asperity_core::quantity::Length;
use asperity_profile_io::Warning;
use asperity_profile_io::read::{
    FilterState, Format, LengthUnit, Metadata, ReadOptions, SpacingSource, read, read_bytes,
    read_with_conditions,
};
use asperity_profile_io::write::{WrittenFormat, write};

use super::samples::*;

#[test]
fn text_formats_of_instruments_read_with_what_they_say() {
    let reading = read_as("a.sig", sig().as_bytes());
    check(&reading, Format::SigmaSurf, 6);
    assert_eq!(reading.metadata.title.as_deref(), Some("flank 7"));

    let reading = read_as("a.sdf", sdf(1).as_bytes());
    check(&reading, Format::SdfAscii, 9);
    assert_eq!(reading.metadata.instrument.as_deref(), Some("maker"));

    let reading = read_as("a.prf", prf().as_bytes());
    check(&reading, Format::TaylorHobsonPrf, 6);
    assert_eq!(
        reading.metadata.stylus_radius,
        Some("2 um".parse().unwrap())
    );

    let reading = read_as("a.smd", smd_with_blanks().as_bytes());
    check(&reading, Format::Smd, 6);
    assert_eq!(reading.metadata.lambda_c, Some("0.8 mm".parse().unwrap()));
    // A value of zero asks for the parameter and is none.
    assert_eq!(reading.metadata.printed.len(), 1);

    for german in [true, false] {
        check(&read_as("a.pr", &windows(&pr(german))), Format::PtbPr, 6);
    }
    assert!(read_as("a.sig", sig().as_bytes()).warnings.is_empty());
}

#[test]
fn a_mahr_profile_keeps_its_offset_and_drops_locked_points() {
    let reading = read_as("a.txt", &windows(&mahr()));
    assert_eq!((reading.format, reading.points), (Format::MahrText, POINTS));
    assert!((reading.profile.heights()[0] + 0.93e-3).abs() < 1e-9);
    assert_eq!(reading.filter_state, FilterState::Primary);
    assert_eq!(reading.metadata.instrument.as_deref(), Some("PCV"));
    let locked = mahr().replacen("0.000000000 0\r\n", "0.000000000 1\r\n", 1);
    let refused = read_bytes("a.txt", locked.as_bytes(), &ReadOptions::default()).unwrap_err();
    assert_eq!(refused.code(), "E107");
    let short = mahr().replace(&format!("NO_POINTS={POINTS}"), "NO_POINTS=9999");
    let refused = read_bytes("a.txt", short.as_bytes(), &ReadOptions::default()).unwrap_err();
    assert_eq!(refused.code(), "E117", "{refused}");
}

#[test]
fn an_aborted_surfcom_trace_takes_its_spacing_from_what_was_traced() {
    // 240 of 400 points: the header still says 0.2 mm, which would make dx 0.8333 um.
    let profile = format!("0.20000\n{POINTS}\n{}", rows(|z| format!("{z:.4}\n")));
    let conditions = "Fecha\t08.04.2025\nOnda de corte\t0.08mm\nLongitud evaluaci\u{f3}n\t0.1200000mm\nRa\t0.3838um\t*um\n";
    let options = ReadOptions::default();
    let found = read_with_conditions(
        "a.tx1",
        profile.as_bytes(),
        Some(conditions.as_bytes()),
        &options,
    )
    .unwrap();
    check(&found, Format::SurfcomText, 4);
    assert_eq!(
        (found.filter_state, found.spacing_source),
        (FilterState::Primary, SpacingSource::EvaluationLength)
    );
    assert!(
        matches!(found.warnings.as_slice(), [Warning::TraceAborted { .. }]),
        "{:?}",
        found.warnings
    );
    assert_eq!(
        found.metadata.nominal_length,
        Some("0.2 mm".parse().unwrap())
    );
    assert_eq!(found.metadata.printed[0].value, 0.3838);
    let refused = read_bytes("a.tx1", profile.as_bytes(), &options).unwrap_err();
    assert_eq!(refused.code(), "E110");

    let folder = tempfile::tempdir().unwrap();
    std::fs::write(folder.path().join("7.tx2"), &profile).unwrap();
    std::fs::write(folder.path().join("7.tx3"), conditions).unwrap();
    let beside = read(&folder.path().join("7.tx2"), &options).unwrap();
    assert_eq!(
        (beside.spacing, beside.filter_state),
        (found.spacing, FilterState::Roughness)
    );
}

#[test]
fn a_row_of_an_sdf_is_read_when_asked_for() {
    let refused = read_bytes("a.sdf", sdf(2).as_bytes(), &ReadOptions::default()).unwrap_err();
    assert_eq!(refused.code(), "E119");
    let second = ReadOptions {
        row: Some(2),
        ..ReadOptions::default()
    };
    check(
        &read_bytes("a.sdf", sdf(2).as_bytes(), &second).unwrap(),
        Format::SdfAscii,
        9,
    );
}

#[test]
fn a_dektak_table_has_heights_in_angstrom() {
    let table: String = (0..POINTS)
        .map(|i| format!("{:.5},{:.4},,\r\n", 0.5 * i as f64, height(i) * 1e4))
        .collect();
    let text = format!(
        "Meta Data\r\nDateTime,20 Nov 2026\r\nScanner Type,Dektak XT\r\nData\r\nLateral(\u{b5}m),Total Profile(\u{c5}),,\r\n{table}"
    );
    let reading = read_as("a.csv", text.as_bytes());
    check(&reading, Format::DektakCsv, 7);
    assert_eq!(reading.z_unit, LengthUnit::Angstrom);
    assert_eq!(reading.metadata.date.as_deref(), Some("20 Nov 2026"));
}

#[test]
fn a_changed_smd_fails_its_checksum() {
    let heights = (0..POINTS).map(|i| height(i) * 1e-6).collect();
    let profile = Profile::new(Length::from_si(0.5e-6), heights).unwrap();
    let bytes = write(&profile, &Metadata::default(), WrittenFormat::Smd).unwrap();
    let text = String::from_utf8(bytes.clone()).unwrap();
    assert_eq!(read_as("a.smd", &bytes).warnings, []);
    let changed = text.replacen("e-7\r\n", "e-8\r\n", 1);
    assert_ne!(changed, text);
    assert!(matches!(
        read_as("a.smd", changed.as_bytes()).warnings.as_slice(),
        [Warning::ChecksumDiffers { .. }]
    ));
}

/// Three named columns of which two are lengths: the height is not the brightness.
#[test]
fn the_only_other_length_beside_x_is_the_height() {
    let row = |i: u32| {
        format!(
            "{:.18e} {:.18e} {}\n",
            1e-3 * f64::from(i),
            0.2 * f64::from(i).sin(),
            200 + i % 7
        )
    };
    let header =
        "# Calibration file\n# \tPosition (mm)     Distance (microns)    Light Intensity (0-255)\n";
    let text = format!("{header}{}", (0..300).map(row).collect::<String>());
    let found = read_bytes("scan.txt", text.as_bytes(), &ReadOptions::default()).unwrap();
    assert!((found.profile.spacing().si() - 1e-6).abs() < 1e-12);
    assert!((found.profile.heights()[1] - 0.2e-6 * 1.0_f64.sin()).abs() < 1e-15);
    let unread = vec!["Light Intensity (0-255)".to_owned()];
    assert_eq!(
        found.warnings,
        [Warning::ColumnsNotRead { columns: unread }]
    );
    // Without lengths in the labels the columns have to be stated.
    let text = text.replace("(microns)", "(counts)");
    assert!(read_bytes("scan.txt", text.as_bytes(), &ReadOptions::default()).is_err());
}
