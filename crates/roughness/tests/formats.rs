//! Every instrument format, made in memory as its writers make it, and read back.

#![allow(clippy::unwrap_used, clippy::panic)]

use std::io::{Cursor, Write};

use asperity_core::Profile;
use asperity_core::quantity::Length;
use asperity_roughness::Warning;
use asperity_roughness::read::{
    FilterState, Format, Gaps, LengthUnit, Metadata, ReadError, ReadOptions, Reading,
    SpacingSource, read, read_bytes, read_with_conditions,
};
use asperity_roughness::write::{WrittenFormat, write};
use md5::{Digest, Md5};
use proptest::prelude::*;
use zip::ZipWriter;
use zip::write::SimpleFileOptions;

const POINTS: usize = 240;

/// Height of point `i` in um.
fn height(i: usize) -> f64 {
    0.6 * (0.37 * i as f64).sin() + 0.001 * i as f64
}

fn rows(line: impl Fn(f64) -> String) -> String {
    (0..POINTS).map(|i| line(height(i))).collect()
}

fn read_as(name: &str, bytes: &[u8]) -> Reading {
    read_bytes(name, bytes, &ReadOptions::default()).unwrap_or_else(|error| panic!("{error}"))
}

/// n, dx and heights to the `decimals` of a micrometre that were written.
fn check(reading: &Reading, format: Format, decimals: i32) {
    assert_eq!((reading.format, reading.points), (format, POINTS));
    assert!(
        (reading.spacing.si() / 0.5e-6 - 1.0).abs() < 1e-9,
        "{}",
        reading.spacing
    );
    for (i, z) in reading.profile.heights().iter().enumerate() {
        let off = (z * 1e6 - height(i)).abs();
        assert!(off <= 0.51 * 10f64.powi(-decimals), "{i}: {off}");
    }
}

fn sig() -> String {
    let head = "SigmaSurf_Data 1.0\r\nIDENTIFICATION: flank 7\r\nDATE: 20 Nov 2026 - 10:00\r\n";
    let rows = rows(|z| format!("{z:.6}\r\n"));
    format!("{head}SPACING_UM: 0.50000\r\nNUMBER_OF_POINTS: {POINTS}\r\nPROFILE_UM:\r\n{rows}")
}

fn sdf(profiles: usize) -> String {
    let rows = rows(|z| format!("{z:.9}\n")).repeat(profiles);
    format!(
        "aISO-1.0\nManufacID   = maker\nCreateDate  = 201120261000\nNumPoints   = {POINTS}\n\
         NumProfiles = {profiles}\nXscale      = 5E-07\nYscale      = 0\nZscale      = 1.0E-6\n\
         Zresolution = -1\nCompression = 0\nDataType    = 7\nCheckType   = 0\n*\n{rows}*\n"
    )
}

fn mahr() -> String {
    let points = (0..POINTS).map(|i| {
        let (x, z) = (12.0 + 0.0005 * i as f64, height(i) / 1e3 - 0.93);
        format!("{i}={x:.9} 0.000000000 {z:.9} 0.000000000 0\r\n")
    });
    format!(
        "[PROFILE_HEADER]\r\nNAME=flank 7\r\nINTERVAL_LIN=0.000500000\r\nNO_POINTS={POINTS}\r\n\
         PB_RADIUS=0.002\r\n[PROFILE_HISTORY]\r\nDateTime=2026-11-20 (Mitteleurop\u{e4}ische Zeit)\r\n\
         MachineName=PCV\r\nProfile.Type=Surface\r\n[PROFILE_VALUES]\r\n// X,Y,Z,C,Lock\r\n{}",
        points.collect::<String>()
    )
}

fn prf() -> String {
    let rows = rows(|z| format!("{:.0}\r\n", z * 1e6));
    format!(
        "1 2\r\nSG2004 0.000000e+000 PRF\r\nCX M {POINTS} MM 1.000000e+000 D\r\n\
         CZ M {POINTS} UM 1.000000e-006 L\r\nEOR\r\nSTYLUS_RADIUS 2.0e-003 MM\r\n\
         SPACING CX 5.000000e-004\r\nMAP 1.000000e+000 CZ CZ 1.000000e+000 1.000000e+000\r\n\
         MAP 2.000000e+000 CZ CX 1.000000e+000 0.000000e+000\r\nCOMMENT flank 7\r\nEOR\r\n{rows}EOR\r\nEOF\r\n"
    )
}

fn smd_with_blanks() -> String {
    let rows = rows(|z| format!("{z:.6}\r\n"));
    format!(
        "ISO 5436 - 2000 ground01\r\nPRF 1 ISO5436\r\nCX I {POINTS} mm 1.0e0 D 5.0e-4\r\n\
         CZ A {POINTS} um 1.0e0 D\r\n\r\nDATE 25-Nov-2004\r\nTIME 10:57\r\nCREATED_BY a laboratory\r\n\
         PARAMETER_VALUE Ra 0.383 um 0\r\nPARAMETER_VALUE Rq 0 mm 0\r\n\
         PROFILE_FILTER Gaussian LS 2.5e-3 LC 8.0e-1\r\n\r\n{rows}"
    )
}

fn pr(german: bool) -> String {
    let (length, resolution, points) = match german {
        true => ("X-Ma\u{df} =", "X-Aufl\u{f6}sung", "Punkte/Zeile :"),
        false => ("X-len =", "X-resolution", "points/scanline:"),
    };
    let rows = rows(|z| format!("{z:.6}\r\n"));
    let text = format!(
        "Profil a.pr\r\n{length} 0.1195 {resolution} 2000.000000 {points} {POINTS}\r\n{rows}"
    );
    text.trim_end().to_owned()
}

fn zip(members: &[(&str, &[u8])]) -> Vec<u8> {
    let mut zip = ZipWriter::new(Cursor::new(Vec::new()));
    for (name, bytes) in members {
        zip.start_file(*name, SimpleFileOptions::default()).unwrap();
        zip.write_all(bytes).unwrap();
    }
    zip.finish().unwrap().into_inner()
}

fn hash(bytes: &[u8]) -> String {
    Md5::digest(bytes)
        .iter()
        .map(|byte| format!("{byte:02x}"))
        .collect()
}

/// `main.xml` of `rows` profiles, heights scaled by `increment`, with `record3` as its data.
fn main_xml(
    namespace: bool,
    feature: &str,
    data_type: &str,
    increment: f64,
    rows: usize,
    record3: &str,
) -> String {
    let (open, close) = match namespace {
        true => (
            "<p:ISO5436_2 xmlns:p=\"http://www.opengps.eu/2008/ISO5436_2\">",
            "</p:ISO5436_2>",
        ),
        false => ("<ISO5436_2>", "</ISO5436_2>"),
    };
    format!(
        "<?xml version=\"1.0\" encoding=\"UTF-8\"?>{open}<Record1><FeatureType>{feature}</FeatureType><Axes>\
         <CX><AxisType>I</AxisType><DataType>D</DataType><Increment>5e-07</Increment><Offset>0</Offset></CX>\
         <CY><AxisType>I</AxisType><Increment>5e-07</Increment><Offset>0</Offset></CY>\
         <CZ><AxisType>A</AxisType><DataType>{data_type}</DataType><Increment>{increment:e}</Increment><Offset>0</Offset></CZ>\
         </Axes></Record1><Record2><Date>2026-11-20T10:00:00</Date><Instrument><Manufacturer>maker</Manufacturer>\
         <Model>one</Model></Instrument></Record2><Record3><MatrixDimension><SizeX>{POINTS}</SizeX><SizeY>{rows}</SizeY>\
         <SizeZ>1</SizeZ></MatrixDimension>{record3}</Record3></{close}",
        close = &close[2..]
    )
}

fn link(data: &[u8], mask: &str) -> String {
    format!(
        "<DataLink><PointDataLink>bindata/data.bin</PointDataLink><MD5ChecksumPointData>{}</MD5ChecksumPointData>{mask}</DataLink>",
        hash(data)
    )
}

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

/// The bytes of a text in the code page of western Windows.
fn windows(text: &str) -> Vec<u8> {
    encoding_rs::WINDOWS_1252.encode(text).0.into_owned()
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
    assert!(matches!(refused, ReadError::Damaged { .. }), "{refused}");
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
fn x3p_reads_in_every_data_type_with_and_without_folder_and_namespace() {
    let exact: Vec<f64> = (0..POINTS).map(|i| height(i) * 1e-6).collect();
    let count = |step: f64| exact.iter().map(move |z| (z / step).round());
    let cases: [(&str, f64, Vec<u8>, i32); 4] = [
        (
            "D",
            1.0,
            exact.iter().flat_map(|z| z.to_le_bytes()).collect(),
            12,
        ),
        (
            "F",
            1.0,
            exact
                .iter()
                .flat_map(|z| (*z as f32).to_le_bytes())
                .collect(),
            6,
        ),
        (
            "L",
            1e-12,
            count(1e-12)
                .flat_map(|v| (v as i32).to_le_bytes())
                .collect(),
            6,
        ),
        (
            "I",
            1e-10,
            count(1e-10)
                .flat_map(|v| (v as i16).to_le_bytes())
                .collect(),
            4,
        ),
    ];
    for (data_type, increment, data, decimals) in cases {
        for (folder, namespace) in [("", true), ("export/flank/", false)] {
            let xml = main_xml(namespace, "PRF", data_type, increment, 1, &link(&data, ""));
            let checksum = format!("{} *main.xml", hash(xml.as_bytes()));
            let bytes = zip(&[
                (&format!("{folder}main.xml"), xml.as_bytes()),
                (&format!("{folder}md5checksum.hex"), checksum.as_bytes()),
                (&format!("{folder}bindata/data.bin"), &data),
            ]);
            let reading = read_as("a.x3p", &bytes);
            check(&reading, Format::X3p, decimals);
            assert_eq!(reading.warnings, []);
            assert_eq!(reading.metadata.instrument.as_deref(), Some("maker one"));
        }
    }
    let text = exact
        .iter()
        .map(|z| format!("<Datum>{z:e}</Datum>"))
        .collect::<String>();
    let xml = main_xml(
        true,
        "PRF",
        "D",
        1.0,
        1,
        &format!("<DataList>{text}</DataList>"),
    );
    let reading = read_as("a.zip", &zip(&[("main.xml", xml.as_bytes())]));
    assert_eq!(reading.profile.heights(), exact);
}

#[test]
fn x3p_masks_and_checksums_and_rows_are_heeded() {
    let exact: Vec<f64> = (0..3 * POINTS)
        .map(|i| height(i % POINTS) * 1e-6 + (i / POINTS) as f64 * 1e-6)
        .collect();
    let data: Vec<u8> = exact.iter().flat_map(|z| z.to_le_bytes()).collect();
    let surface = main_xml(true, "SUR", "D", 1.0, 3, &link(&data, ""));
    let bytes = zip(&[
        ("main.xml", surface.as_bytes()),
        ("bindata/data.bin", &data),
    ]);
    let refused = read_bytes("a.x3p", &bytes, &ReadOptions::default()).unwrap_err();
    assert!(
        matches!(refused, ReadError::SeveralProfiles { rows: 3, .. }),
        "{refused}"
    );
    let second = ReadOptions {
        row: Some(2),
        ..ReadOptions::default()
    };
    let reading = read_bytes("a.x3p", &bytes, &second).unwrap();
    assert_eq!(reading.profile.heights(), &exact[POINTS..2 * POINTS]);
    let fourth = ReadOptions {
        row: Some(4),
        ..ReadOptions::default()
    };
    assert_eq!(
        read_bytes("a.x3p", &bytes, &fourth).unwrap_err().code(),
        "E119"
    );

    let one = &data[..8 * POINTS];
    let mut mask = vec![0xff_u8; POINTS / 8];
    mask[2] = 0b1111_0111;
    let linked = link(one, "<ValidPointsLink>bindata/valid.bin</ValidPointsLink>");
    let xml = main_xml(true, "PRF", "D", 1.0, 1, &linked);
    let bytes = zip(&[
        ("main.xml", xml.as_bytes()),
        ("bindata/data.bin", one),
        ("bindata/valid.bin", &mask),
    ]);
    let refused = read_bytes("a.x3p", &bytes, &ReadOptions::default()).unwrap_err();
    assert!(
        matches!(
            refused,
            ReadError::MissingPoints {
                line: 20,
                missing: 1,
                ..
            }
        ),
        "{refused}"
    );
    let filled = ReadOptions {
        gaps: Gaps::Interpolate,
        ..ReadOptions::default()
    };
    let reading = read_bytes("a.x3p", &bytes, &filled).unwrap();
    assert!((reading.profile.heights()[19] - 0.5 * (exact[18] + exact[20])).abs() < 1e-18);

    let wrong = xml.replace(&hash(one), "00112233445566778899aabbccddeeff");
    let checksum = "00112233445566778899aabbccddeeff *main.xml";
    let bytes = zip(&[
        (
            "main.xml",
            wrong
                .replace("<ValidPointsLink>bindata/valid.bin</ValidPointsLink>", "")
                .as_bytes(),
        ),
        ("md5checksum.hex", checksum.as_bytes()),
        ("bindata/data.bin", one),
    ]);
    let codes: Vec<_> = read_as("a.x3p", &bytes)
        .warnings
        .iter()
        .map(Warning::code)
        .collect();
    assert_eq!(codes, ["W120", "W120"]);
}

#[test]
fn hostile_archives_and_counts_are_refused() {
    let refused = |name: &str, bytes: &[u8]| {
        read_bytes(name, bytes, &ReadOptions::default())
            .unwrap_err()
            .code()
    };
    // A hundred million zeros pack to some hundred kilobytes.
    let bomb = zip(&[("main.xml", &vec![b' '; 100_000_000])]);
    assert!(bomb.len() < 300_000);
    assert_eq!(refused("a.x3p", &bomb), "E118");
    let data = [0_u8; 8 * POINTS];
    let xml = main_xml(true, "PRF", "D", 1.0, 1, &link(&data, ""));
    for size in ["18446744073709551615", "99999999999", "0", "-1"] {
        let xml = xml.replace(&format!("<SizeX>{POINTS}"), &format!("<SizeX>{size}"));
        let code = refused(
            "a.x3p",
            &zip(&[("main.xml", xml.as_bytes()), ("bindata/data.bin", &data)]),
        );
        assert!(["E117", "E118"].contains(&code), "{size} {code}");
    }
    let deep = "<a>".repeat(100_000);
    assert_eq!(
        refused("a.x3p", &zip(&[("main.xml", deep.as_bytes())])),
        "E117"
    );
    assert_eq!(refused("a.x3p", b"PK\x03\x04 and no more"), "E117");
    let many = sdf(1).replace(
        &format!("NumPoints   = {POINTS}"),
        "NumPoints   = 18446744073709551615",
    );
    assert_eq!(refused("a.sdf", many.as_bytes()), "E117");
    let many = smd_with_blanks().replace(&format!("CZ A {POINTS}"), "CZ A 1e300");
    assert_eq!(refused("a.smd", many.as_bytes()), "E117");
    let far = sig().replace("SPACING_UM: 0.50000", "SPACING_UM: 1e300");
    assert_eq!(refused("a.sig", far.as_bytes()), "E116");
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
fn a_mitutoyo_workbook_gives_profile_conditions_and_printed_values() {
    let texts = [
        "Mitutoyo",
        "SurfTest",
        " Profile",
        "R",
        "Cut-Off",
        "0.08mm",
        "Ra     0.383  \u{b5}m      ",
    ];
    let shared: String = texts
        .iter()
        .map(|text| format!("<si><t>{text}</t></si>"))
        .collect();
    let cells: String = (0..6)
        .map(|i| format!("<c r=\"B{}\" t=\"s\"><v>{i}</v></c>", i + 1))
        .collect();
    let points: String = (0..POINTS).map(|i| {
        let (row, x) = (i + 1, 0.0005 * (i + 1) as f64);
        format!("<row r=\"{row}\"><c r=\"E{row}\"><v>{x:.4}</v></c><c r=\"F{row}\"><v>{:.9}</v></c></row>", height(i))
    }).collect();
    let book = |shared: &str| {
        zip(&[
        ("xl/workbook.xml", b"<workbook/>".as_slice()),
        ("xl/sharedStrings.xml", format!("<sst>{shared}</sst>").as_bytes()),
        ("xl/worksheets/sheet1.xml", format!("<worksheet><sheetData><row>{cells}</row></sheetData></worksheet>").as_bytes()),
        ("xl/worksheets/sheet2.xml", format!("<worksheet><sheetData><row><c r=\"A1\" t=\"s\"><v>6</v></c></row>{points}</sheetData></worksheet>").as_bytes()),
    ])
    };
    let reading = read_as("a.xlsx", &book(&shared));
    check(&reading, Format::MitutoyoXlsx, 9);
    assert_eq!(
        (reading.filter_state, reading.z_unit),
        (FilterState::Roughness, LengthUnit::Micrometre)
    );
    assert_eq!(reading.metadata.lambda_c, Some("0.08 mm".parse().unwrap()));
    let printed = &reading.metadata.printed[0];
    assert_eq!(
        (printed.name.as_str(), printed.value, printed.decimals),
        ("Ra", 0.383, 3)
    );
    let other = shared
        .replace("Mitutoyo", "Sheet")
        .replace("SurfTest", "one");
    let refused = read_bytes("a.xlsx", &book(&other), &ReadOptions::default()).unwrap_err();
    assert_eq!(refused.code(), "E108");
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

/// One valid file of every format.
fn seeds() -> Vec<(&'static str, Vec<u8>)> {
    let heights = (0..POINTS).map(|i| height(i) * 1e-6).collect();
    let profile = Profile::new(Length::from_si(0.5e-6), heights).unwrap();
    let written = |format| write(&profile, &Metadata::default(), format).unwrap();
    vec![
        ("a.x3p", written(WrittenFormat::X3p)),
        ("a.smd", written(WrittenFormat::Smd)),
        ("b.smd", smd_with_blanks().into_bytes()),
        ("a.sig", sig().into_bytes()),
        ("a.sdf", sdf(1).into_bytes()),
        ("a.txt", mahr().into_bytes()),
        ("a.prf", prf().into_bytes()),
        ("a.pr", pr(true).into_bytes()),
        (
            "a.tx1",
            format!("0.12\n{POINTS}\n{}", rows(|z| format!("{z:.4}\n"))).into_bytes(),
        ),
    ]
}

/// A workbook as Mitutoyo's tool writes it.
fn workbook() -> Vec<u8> {
    let texts = ["Mitutoyo", " Profile", "R"]
        .map(|text| format!("<si><t>{text}</t></si>"))
        .concat();
    let label = |i: usize| format!("<c r=\"B{}\" t=\"s\"><v>{i}</v></c>", i + 1);
    let labels: String = (0..3).map(label).collect();
    let point = |i: usize| {
        let (row, x) = (i + 1, 0.0005 * (i + 1) as f64);
        format!(
            "<row><c r=\"E{row}\"><v>{x:.4}</v></c><c r=\"F{row}\"><v>{:.6}</v></c></row>",
            height(i)
        )
    };
    let points: String = (0..POINTS).map(point).collect();
    let sheet = |rows: &str| format!("<worksheet><sheetData>{rows}</sheetData></worksheet>");
    zip(&[
        (
            "xl/sharedStrings.xml",
            format!("<sst>{texts}</sst>").as_bytes(),
        ),
        (
            "xl/worksheets/sheet1.xml",
            sheet(&format!("<row>{labels}</row>")).as_bytes(),
        ),
        ("xl/worksheets/sheet2.xml", sheet(&points).as_bytes()),
    ])
}

#[test]
#[ignore = "writes the seeds of the fuzz targets into the source tree"]
fn write_seeds() {
    let folder = std::path::Path::new(env!("CARGO_MANIFEST_DIR")).join("fuzz/seeds");
    let csv = rows(|z| format!("{z:.4}\n"));
    let numbered = csv.lines().enumerate();
    let csv: String = numbered
        .map(|(i, z)| format!("{:.1};{z}\n", 0.5 * i as f64))
        .collect();
    let mut all = vec![
        ("delimited", format!("x [um];z [um]\n{csv}").into_bytes()),
        ("mitutoyo", workbook()),
    ];
    let targets = [
        "x3p",
        "smd",
        "smd",
        "sigmasurf",
        "sdf",
        "mahr",
        "taylor_hobson",
        "ptb",
        "surfcom",
    ];
    all.extend(
        targets
            .into_iter()
            .zip(seeds().into_iter().map(|(_, bytes)| bytes)),
    );
    for (at, (target, bytes)) in all.into_iter().enumerate() {
        std::fs::create_dir_all(folder.join(target)).unwrap();
        std::fs::write(folder.join(target).join(format!("{at:02}")), bytes).unwrap();
    }
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(400))]

    #[test]
    fn what_is_written_reads_back_to_the_last_bit(
        heights in prop::collection::vec(-1e-4..1e-4_f64, 100..200),
        dx in 1e-8..1e-5_f64,
    ) {
        let profile = Profile::new(Length::from_si(dx), heights).unwrap();
        let metadata = Metadata { title: Some("a <b> & \"c\"".into()), date: Some("2026-11-20".into()), ..Metadata::default() };
        for (name, format) in [("a.csv", WrittenFormat::Csv), ("a.x3p", WrittenFormat::X3p), ("a.smd", WrittenFormat::Smd)] {
            let bytes = write(&profile, &metadata, format).unwrap();
            let reading = read_bytes(name, &bytes, &ReadOptions::default()).unwrap();
            prop_assert_eq!(&reading.profile, &profile);
            prop_assert_eq!(reading.metadata.date.as_deref(), Some("2026-11-20"));
            prop_assert!(reading.warnings.is_empty(), "{:?}", reading.warnings);
        }
    }

    #[test]
    fn a_damaged_instrument_file_is_read_or_refused(
        seed in 0..9_usize,
        edits in prop::collection::vec((any::<prop::sample::Index>(), any::<u8>(), 0..3_u8), 1..12),
    ) {
        let (name, mut bytes) = seeds().swap_remove(seed);
        for (at, byte, kind) in edits {
            if bytes.is_empty() {
                break;
            }
            let at = at.index(bytes.len());
            match kind {
                0 => bytes[at] = byte,
                1 => bytes.insert(at, byte),
                _ => bytes.truncate(at.max(bytes.len() / 2)),
            }
        }
        match read_bytes(name, &bytes, &ReadOptions::default()) {
            Ok(reading) => {
                prop_assert!(reading.points >= 100);
                prop_assert!(reading.profile.heights().iter().all(|z| z.is_finite()));
            }
            Err(error) => prop_assert!(error.to_string().starts_with(name)),
        }
    }
}
